#pragma once
// Shared by the peers: their programs' options, and the files with their measurements; tests/bench/Peers.h reads them.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tests/bench/Subjects.h"

namespace fenestra::peers {

struct Options {
  std::filesystem::path folder;  ///< the report's; files go to FOLDER/peers
  bench::Views views;
};

/// Who measured.
struct Program {
  std::string name;     ///< of its files
  std::string title;    ///< in the report
  std::string version;  ///< of the library
  std::string machine;  ///< what it draws on
};

/// A peer's main(): reads the options, runs `measure` and prints what it throws. Returns the exit code.
int runProgram(int argc, char** argv, const std::string& description,
               const std::function<void(const Options&)>& measure);

/// Writes RGBA of the compared pixels as FOLDER/peers/FILE.
void writePicture(const Options& options, const std::string& file, const std::vector<float>& colours);

/// Writes FOLDER/peers/NAME.json.
void writeRuns(const Options& options, const Program& program, const nlohmann::ordered_json& runs);

}  // namespace fenestra::peers
