#pragma once
// What goes wrong with files: one typed error, shown once, by the program.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

namespace fenestra::io {

/// what() is "PATH: cause; hint", one line.
class Error : public std::runtime_error {
 public:
  Error(std::filesystem::path file, std::string cause, std::string hint);

  const std::filesystem::path& file() const { return file_; }
  const std::string& cause() const { return cause_; }  ///< what is wrong
  const std::string& hint() const { return hint_; }    ///< the way out

 private:
  std::filesystem::path file_;
  std::string cause_, hint_;
};

/// The file does not say how large its voxels are, and nobody has: OpenOptions::spacing says it.
class SpacingMissing : public Error {
 public:
  SpacingMissing(std::filesystem::path file, std::string cause)
      : Error(std::move(file), std::move(cause), "say it in mm, with --spacing X,Y,Z on the command line") {}
};

/// The progress callback asked to stop; nothing was kept.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace fenestra::io
