#include "io/report/Origin.h"

#include <algorithm>

#include "io/base/AtomicFile.h"
#include "io/base/Error.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io::report {
namespace fs = std::filesystem;

void readOrigin(const fs::path& source, Origin& origin) {
  prepareDcmtk();
  if (!source.empty()) {
    loadHeader(source, origin.file);
    // Names of labels are UTF-8, so everything is.
    require(origin.dataset().convertToUTF8(), source, "its texts have an unknown character set");
  }
  origin.study = textOf(origin.dataset(), DCM_StudyInstanceUID);
  origin.frameOfReference = textOf(origin.dataset(), DCM_FrameOfReferenceUID);
  if (!origin.study.empty()) return;
  origin.study = newUid();
  origin.dataset().putAndInsertString(DCM_StudyInstanceUID, origin.study.c_str());
}

std::string newUid() {
  char uid[100];
  return dcmGenerateUniqueIdentifier(uid, SITE_INSTANCE_UID_ROOT);
}

std::string bounded(const std::string& text, std::size_t characters) {
  std::string result;
  std::size_t count = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 && c != '\n') continue;
    if ((byte & 0xc0) != 0x80 && ++count > characters) break;
    result += c;
  }
  return result;
}

std::string longString(const std::string& text) {
  constexpr std::size_t longest = 64;
  std::string line = bounded(text, longest);
  std::replace(line.begin(), line.end(), '\\', '/');
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

void require(const OFCondition& condition, const fs::path& file, const char* what) {
  if (condition.bad())
    throw Error(file, std::string("cannot be made: ") + what + " (" + condition.text() + ")",
                "check the DICOM files that it is about");
}

void save(DcmFileFormat& whole, const fs::path& file) {
  writeAtomically(file, [&](const fs::path& temporary) {
    const OFCondition saved = whole.saveFile(OFFilename(temporary.c_str()), EXS_LittleEndianExplicit);
    if (saved.bad())
      throw Error(file, std::string("cannot be written: ") + saved.text(),
                  "check the folder, its permissions and the free space");
  });
}

}  // namespace fenestra::io::report
