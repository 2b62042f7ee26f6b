#pragma once
// What goes wrong with files: one typed error, shown once, by the program.

#include <filesystem>
#include <stdexcept>
#include <string>

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

/// The progress callback asked to stop; nothing was kept.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace fenestra::io
