#include "io/deidentify/OutputFolder.h"

#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "io/base/Error.h"

namespace fenestra::io::deidentify {
namespace fs = std::filesystem;

bool liesIn(const fs::path& inner, const fs::path& outer) {
  std::error_code failure;
  const fs::path whole = fs::weakly_canonical(inner, failure), holder = fs::weakly_canonical(outer, failure);
  const auto [end, rest] = std::mismatch(holder.begin(), holder.end(), whole.begin(), whole.end());
  return end == holder.end();
}

OutputFolder::OutputFolder(const fs::path& folder, const std::vector<fs::path>& sources)
    : folder_(folder.has_filename() ? folder : folder.parent_path()) {
  std::error_code failure;
  const bool exists = fs::exists(folder_, failure);
  if (exists && !fs::is_directory(folder_, failure))
    throw Error(folder_, "is a file", "name a folder that does not exist or is empty");
  if (exists && !fs::is_empty(folder_, failure))
    throw Error(folder_, "holds files", "name a folder that does not exist or is empty");
  for (const fs::path& source : sources)
    if (fs::is_directory(source, failure) && liesIn(folder_, source))
      throw Error(folder_, "lies in the folder that is read", "name a folder elsewhere, which can be given away");
  if (folder_.has_parent_path()) fs::create_directories(folder_.parent_path(), failure);
  std::string name = folder_.string() + ".XXXXXX";
  if (!::mkdtemp(name.data()))
    throw Error(folder_, "cannot be made: " + std::generic_category().message(errno),
                "name a folder that can be written to");
  place_ = name;
}

OutputFolder::~OutputFolder() {
  std::error_code failure;
  if (!place_.empty()) fs::remove_all(place_, failure);
}

void OutputFolder::finish() {
  std::error_code failure;
  fs::rename(place_, folder_, failure);
  if (failure)
    throw Error(folder_, "cannot be written: " + failure.message(), "choose a place with space that can be written to");
  place_.clear();
}

}  // namespace fenestra::io::deidentify
