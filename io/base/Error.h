#pragma once
// What goes wrong with files: one typed error, shown once, by the program.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/base/WayOut.h"

namespace fenestra::io {

/// what() is "PATH: cause; hint", one line.
class Error : public std::runtime_error {
 public:
  Error(std::filesystem::path file, std::string cause, std::string hint);
  /// With a way out that each program offers in its own words; what() and hint() hold those of the command line.
  Error(std::filesystem::path file, std::string cause, WayOut way);

  const std::filesystem::path& file() const { return file_; }
  const std::string& cause() const { return cause_; }  ///< what is wrong
  const std::string& hint() const { return hint_; }    ///< the way out
  WayOut way() const { return way_; }

 private:
  std::filesystem::path file_;
  std::string cause_, hint_;
  WayOut way_ = WayOut::None;
};

/// Throws the Error of a file that contradicts itself or its format; `cause` says in what.
[[noreturn]] void refuseDamaged(const std::filesystem::path& file, const std::string& cause);

/// The file does not say how large its voxels are, and nobody has: OpenOptions::spacing says it.
class SpacingMissing : public Error {
 public:
  SpacingMissing(std::filesystem::path file, std::string cause)
      : Error(std::move(file), std::move(cause), WayOut::SayVoxelSize) {}
};

/// The progress callback asked to stop; nothing was kept.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace fenestra::io
