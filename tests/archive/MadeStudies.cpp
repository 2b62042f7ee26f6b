#include "tests/archive/MadeStudies.h"

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dctk.h>

#include "tests/io/DicomItems.h"

namespace fenestra::tests {
namespace fs = std::filesystem;
namespace {

void writeSlice(const MadeStudy& study, int slice) {
  const fs::path path = study.folder / (std::to_string(slice) + ".dcm");
  DicomSpec spec;
  spec.instance = study.series + "." + std::to_string(slice + 1);
  spec.series = study.series;
  spec.rows = spec.columns = 64;
  for (int i = 0; i < 64 * 64; ++i) spec.words.push_back(static_cast<std::uint32_t>((i * 7 + slice * 131) % 4001));
  spec.position = {0.0, 0.0, 2.0 * slice};
  spec.instanceNumber = slice + 1;
  spec.slope = "1";
  spec.intercept = "-1024";
  spec.patientName = study.name;
  spec.patientId = study.id;
  spec.accessionNumber = study.accession;
  spec.study = study.description;
  writeDicom(path, spec);
  DcmFileFormat file;
  ASSERT_TRUE(file.loadFile(path.c_str()).good());
  file.loadAllDataIntoMemory();
  DcmDataset& dataset = *file.getDataset();
  put(dataset, DCM_StudyInstanceUID, study.uid);
  put(dataset, DCM_StudyDate, study.date);
  put(dataset, DCM_StudyID, study.id);
  if (study.characterSet.empty())
    dataset.findAndDeleteElement(DCM_SpecificCharacterSet);
  else
    ASSERT_TRUE(dataset.convertCharacterSet(study.characterSet.c_str()).good()) << study.characterSet;
  ASSERT_TRUE(file.saveFile(path.c_str(), EXS_LittleEndianExplicit).good());
}

MadeStudy made(MadeStudy study, const fs::path& folder) {
  study.folder = folder / study.uid;
  fs::create_directories(study.folder);
  for (int slice = 0; slice < study.slices; ++slice) writeSlice(study, slice);
  return study;
}

}  // namespace

std::vector<MadeStudy> makeStudies(const fs::path& folder) {
  const std::vector<MadeStudy> all{
      {"1.2.3.10", "1.2.3.10.1", "Smith^Anna", "P-1", "A100", "20240105", "Head", ""},
      {"1.2.3.20", "1.2.3.20.1", "Müller^Jürgen", "P-2", "A200", "20240220", "Thorax", "ISO_IR 100"},
      {"1.2.3.30", "1.2.3.30.1", "Иванов^Пётр", "P-3", "A300", "20240315", "Head", "ISO_IR 144"},
      {"1.2.3.40", "1.2.3.40.1", "Παπάς^Νίκος", "P-4", "B400", "20250101", "Knee", "ISO_IR 126"},
      {"1.2.3.50", "1.2.3.50.1", "Yamada^Tarou=山田^太郎", "P-5", "B500", "20251231", "Knee", "ISO_IR 192"}};
  std::vector<MadeStudy> studies;
  for (const MadeStudy& each : all) studies.push_back(made(each, folder));
  return studies;
}

MadeStudy makeStudy(const fs::path& folder, const std::string& uid, int slices) {
  return made({uid, uid + ".1", "Test^Study", "T-" + uid, "T1", "20240101", "Test", "", slices}, folder);
}

MadeFrames makeFrames(const fs::path& folder, const std::string& uid, int frames, Syntax syntax) {
  MadeFrames made{uid, uid + ".1", uid + ".1.1", folder / (uid + ".dcm")};
  fs::create_directories(folder);
  DicomSpec spec;
  spec.sopClass = UID_EnhancedCTImageStorage;
  spec.instance = made.object;
  spec.series = made.series;
  spec.syntax = syntax;
  spec.rows = spec.columns = 64;
  spec.pixelSpacing = "0.5\\0.75";
  spec.window = "40 400";
  for (int frame = 0; frame < frames; ++frame) {
    spec.frames.push_back({{0.0, 0.0, 2.0 * frame}, 1.0 + 0.5 * frame, -100.0 * frame});
    for (int i = 0; i < 64 * 64; ++i)
      spec.words.push_back(static_cast<std::uint32_t>((i * 7 + frame * 131) % 4001 - 2000) & 0xffff);
  }
  writeDicom(made.file, spec);
  DcmFileFormat file;
  EXPECT_TRUE(file.loadFile(made.file.c_str()).good());
  file.loadAllDataIntoMemory();
  put(*file.getDataset(), DCM_StudyInstanceUID, uid);
  EXPECT_TRUE(file.saveFile(made.file.c_str(), file.getDataset()->getOriginalXfer()).good());
  return made;
}

std::map<std::string, std::string> objectsIn(const fs::path& folder) {
  std::map<std::string, std::string> objects;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    DcmFileFormat file;
    if (!entry.is_regular_file() || file.loadFile(entry.path().c_str()).bad()) continue;
    DcmDataset& dataset = *file.getDataset();
    OFString uid;
    dataset.findAndGetOFString(DCM_SOPInstanceUID, uid);
    std::string bytes(1 << 20, '\0');
    DcmOutputBufferStream stream(bytes.data(), static_cast<offile_off_t>(bytes.size()));
    dataset.transferInit();
    EXPECT_TRUE(dataset.write(stream, EXS_LittleEndianExplicit, EET_UndefinedLength, nullptr).good());
    dataset.transferEnd();
    void* start = nullptr;
    offile_off_t size = 0;
    stream.flushBuffer(start, size);
    objects[uid.c_str()] = std::string(static_cast<const char*>(start), static_cast<std::size_t>(size));
  }
  return objects;
}

}  // namespace fenestra::tests
