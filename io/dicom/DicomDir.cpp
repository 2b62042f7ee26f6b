#include "io/dicom/DicomDir.h"

#include <algorithm>
#include <optional>
#include <string>

#include "io/base/Text.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// The entry of `folder` with this name in any case, without the version that ISO 9660 appends (";1").
std::optional<fs::path> entryNamed(const fs::path& folder, const std::string& name) {
  std::error_code failure;
  if (fs::exists(folder / name, failure)) return folder / name;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    const std::string found = lowered(entry->path().filename().string());
    if (found.substr(0, found.rfind(';')) == lowered(name)) return entry->path();
  }
  return std::nullopt;
}

/// A Referenced File ID below `root`; empty when a part of it does not exist, or is no plain name.
std::optional<fs::path> resolved(const fs::path& root, const std::vector<std::string>& parts) {
  fs::path path = root;
  for (const std::string& part : parts) {
    if (part.empty() || part == "." || part == ".." || part.find('/') != std::string::npos) return std::nullopt;
    const auto entry = entryNamed(path, part);
    if (!entry) return std::nullopt;
    path = *entry;
  }
  std::error_code unknown;
  return fs::is_regular_file(path, unknown) ? std::optional(path) : std::nullopt;
}

}  // namespace

DicomDir readDicomDir(const fs::path& path) {
  prepareDcmtk();
  DicomDir directory;
  DcmFileFormat file;
  DcmSequenceOfItems* records = nullptr;
  if (file.loadFile(OFFilename(path.c_str())).bad() ||
      file.getDataset()->findAndGetSequence(DCM_DirectoryRecordSequence, records).bad() || !records)
    return directory;
  const fs::path root = fs::absolute(path).parent_path();
  for (unsigned long i = 0; i < records->card(); ++i) {
    DcmItem& record = *records->getItem(i);
    Uint16 inUse = 0xFFFF;
    record.findAndGetUint16(DCM_RecordInUseFlag, inUse);
    OFString id;
    if (inUse == 0 || record.findAndGetOFStringArray(DCM_ReferencedFileID, id).bad() || id.empty()) continue;
    std::vector<std::string> parts = split(std::string(id.c_str(), id.size()), '\\');
    for (std::string& part : parts) part = trimmed(part);
    if (auto found = resolved(root, parts)) {
      directory.files.push_back(std::move(*found));
    } else {
      fs::path named = root;
      for (const std::string& part : parts) named /= part;
      directory.missing.push_back(std::move(named));
    }
  }
  std::sort(directory.files.begin(), directory.files.end());
  directory.files.erase(std::unique(directory.files.begin(), directory.files.end()), directory.files.end());
  return directory;
}

}  // namespace fenestra::io
