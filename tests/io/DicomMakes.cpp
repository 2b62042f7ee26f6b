#include "tests/io/DicomMakes.h"

#include <cstring>

#include "tests/io/IoTesting.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

Edit set(std::uint32_t tag, const std::string& vr, const std::string& value) {
  return [=](DicomBytes& file) { file.set(tag, vr, value); };
}
Edit set(std::uint32_t tag, int value) { return set(tag, "US", shortValue(value)); }
Edit drop(std::uint32_t tag) {
  return [=](DicomBytes& file) { file.drop(tag); };
}
Edit unknown(std::uint32_t tag) {
  return [=](DicomBytes& file) { file.makeUnknown(tag); };
}
Edit change(std::uint32_t tag, const std::function<void(std::string&)>& how) {
  return [=](DicomBytes& file) { how(file.value(tag)); };
}

fs::path writeEdited(const fs::path& path, const DicomSpec& spec, const std::vector<Edit>& edits) {
  writeDicom(path, spec);
  DicomBytes file(readFile(path));
  for (const Edit& edit : edits) edit(file);
  writeFile(path, file.bytes());
  return path;
}

Make file(const std::vector<Edit>& edits, const DicomSpec& spec) {
  return [=](const fs::path& folder) { return writeEdited(folder / "a.dcm", spec, edits); };
}
Make bytes(const std::function<std::string(std::string)>& how, const DicomSpec& spec) {
  return [=](const fs::path& folder) {
    writeDicom(folder / "a.dcm", spec);
    writeFile(folder / "a.dcm", how(readFile(folder / "a.dcm")));
    return folder / "a.dcm";
  };
}
Make series(int count, const std::function<void(int slice, DicomSpec&)>& how, const std::vector<Edit>& edits,
            const std::function<std::vector<Edit>(int slice)>& own) {
  return [=](const fs::path& folder) {
    for (int slice = 0; slice < count; ++slice) {
      DicomSpec spec = pictureSpec();
      spec.instance = "1.2.3." + std::to_string(slice + 1);
      spec.instanceNumber = slice + 1;
      spec.position = glm::dvec3(0, 0, 2 * slice);
      how(slice, spec);
      std::vector<Edit> all = own ? own(slice) : std::vector<Edit>();
      all.insert(all.end(), edits.begin(), edits.end());
      writeEdited(folder / (std::to_string(slice) + ".dcm"), spec, all);
    }
    return folder;
  };
}
void asItIs(int, DicomSpec&) {}

namespace {
const std::string sequenceEnd("\xfe\xff\xdd\xe0\0\0\0\0", 8);

}  // namespace

std::string fragments(const std::vector<std::string>& parts, bool ended) {
  std::string value = std::string("\xfe\xff\x00\xe0", 4) + std::string(4, '\0');
  for (const std::string& part : parts)
    value += std::string("\xfe\xff\x00\xe0", 4) + bytesOf(static_cast<std::uint32_t>(part.size())) + part;
  return value + (ended ? sequenceEnd : "");
}
Edit fragment(const std::function<std::string(std::string)>& how, bool ended) {
  return change(pixels, [=](std::string& value) {
    std::uint32_t table = 0, length = 0;
    std::memcpy(&table, value.data() + 4, 4);
    std::memcpy(&length, value.data() + 12 + table, 4);
    std::string part = how(value.substr(16 + table, length));
    if (part.size() % 2 != 0) part += '\0';
    value = fragments({part}, ended);
  });
}
Edit withoutEnd() {
  return fragment([](const std::string& part) { return part.substr(0, part.rfind("\xff\xd9")); });
}
std::string element(std::uint32_t tag, const std::string& vr, const std::string& value) {
  return shortValue(static_cast<int>(tag >> 16)) + shortValue(static_cast<int>(tag & 0xffff)) + vr +
         shortValue(static_cast<int>(value.size())) + value;
}
std::string item(const std::string& content) {
  return std::string("\xfe\xff\x00\xe0", 4) + bytesOf(static_cast<std::uint32_t>(content.size())) + content;
}

std::string tagValue(std::uint32_t tag) {
  return shortValue(static_cast<int>(tag >> 16)) + shortValue(static_cast<int>(tag & 0xffff));
}
std::string sequence(std::uint32_t tag, const std::string& content) {
  const std::string one = item(content);
  return tagValue(tag) + std::string("SQ\0\0", 4) + bytesOf(static_cast<std::uint32_t>(one.size())) + one;
}

}  // namespace fenestra::tests
