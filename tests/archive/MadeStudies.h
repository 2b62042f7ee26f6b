#pragma once
// Small studies of known content, with names in several character sets, and what becomes of their files.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/io/DicomWriter.h"

namespace fenestra::tests {

struct MadeStudy {
  std::string uid, series, name, id, accession, date, description;
  std::string characterSet;  ///< of its files; empty: ASCII
  int slices = 3;
  std::filesystem::path folder = {};  ///< where its files are
};

/// Five of them below `folder`: names in Latin, Cyrillic, Greek, Chinese and Japanese writing.
std::vector<MadeStudy> makeStudies(const std::filesystem::path& folder);
/// One series of `slices` slices of 64×64, in ASCII.
MadeStudy makeStudy(const std::filesystem::path& folder, const std::string& uid, int slices);

/// One object of `frames` frames of 64×64 signed words, each with a rescaling of its own, `file` its file.
struct MadeFrames {
  std::string uid, series, object;
  std::filesystem::path file;
};
MadeFrames makeFrames(const std::filesystem::path& folder, const std::string& uid, int frames,
                      Syntax syntax = Syntax::ExplicitLittle);

/// Each object's data set by its SOP Instance UID as explicit little endian bytes, without what servers add.
std::map<std::string, std::string> objectsIn(const std::filesystem::path& folder);

}  // namespace fenestra::tests
