#include "tests/io/Defects.h"

#include <cctype>

#include "io/VolumeReader.h"
#include "io/base/Text.h"

namespace fenestra::tests {

Expected error(std::string says) { return {Outcome::Error, std::move(says)}; }
Expected warning(std::string says) { return {Outcome::Warning, std::move(says)}; }

io::OpenOptions Defect::options() const {
  io::OpenOptions options;
  if (!raw.empty()) options.raw = io::parseRawDescription(raw);
  options.time = time;
  options.spacing = told;
  return options;
}

std::vector<std::string> Defect::command(const std::filesystem::path& path) const {
  if (!labelsOf.empty()) {
    std::vector<std::string> words{"convert", (path.parent_path() / labelsOf).string(), "--labels", path.string(),
                                   "-o",      (path.parent_path() / "out.nii").string()};
    if (!labelTable.empty()) words.insert(words.end(), {"--label-table", (path.parent_path() / labelTable).string()});
    return words;
  }
  std::vector<std::string> arguments{"info", path.string()};
  if (!raw.empty()) arguments.insert(arguments.end(), {"--raw", raw});
  if (told)
    arguments.insert(arguments.end(), {"--spacing", io::plainNumber(told->x) + "," + io::plainNumber(told->y) + "," +
                                                        io::plainNumber(told->z)});
  if (time) arguments.insert(arguments.end(), {"--time", std::to_string(*time)});
  return arguments;
}

std::ostream& operator<<(std::ostream& stream, const Defect& defect) { return stream << defect.name; }

std::string testNameOf(const Defect& defect) {
  std::string name;
  bool start = true;
  for (const char c : defect.name) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (letter) name += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    start = !letter;
  }
  return name;
}

std::vector<Defect> allDefects() {
  std::vector<Defect> all;
  for (const auto& part : {dicomDefects(), dicomKindDefects(), fileDefects(), meaningDefects(), tiffDefects(),
                           labelDefects(), labelNameDefects()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace fenestra::tests
