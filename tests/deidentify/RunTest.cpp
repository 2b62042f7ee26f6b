// Whole runs: what the copies hold and what they must not, where they lie, and what is refused.

#include <sys/stat.h>
#include <algorithm>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "io/deidentify/Deidentify.h"
#include "io/deidentify/PlainWords.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"
#include "tests/io/DicomMakes.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::deidentify_run {
namespace {

namespace fs = std::filesystem;
using io::deidentify::Outcome;
using io::deidentify::Request;

/// All that names the patient of these tests, and none of it anything else.
const std::vector<std::string>& planted() {
  static const std::vector<std::string> texts{"Mustermann",    "MUSTERMANN", "Erika",
                                              "MRN-4711-0815", "19640812",   "ACC-99887766"};
  return texts;
}

std::vector<Edit> plantedEdits() {
  return {set(0x00080005, "CS", "ISO_IR 192"),
          set(0x00080080, "LO", "Klinik Mustermann"),
          set(0x00080090, "PN", "Mustermann^Dr"),
          set(0x00081090, "LO", "Scanner of Erika"),                 // not in the table; a name stands in it
          set(0x00204000, "LT", "Erika Mustermann, born 19640812"),  // comments
          set(0x00090010, "LO", "Mustermann private"),               // a private block
          set(0x00091001, "LO", "MRN-4711-0815"),
          set(0x60000010, "US", std::string("\x04\0", 2)),  // an overlay
          set(0x60003000, "OW", "Mustermann!!"),
          set(0x00101010, "AS", "061Y"),
          set(0xfffcfffc, "OB", "Mustermann"),  // padding behind the pixels
          set(0x00400275, "SQ",
              item(element(0x00321060, "LO", "MR of Mustermann") + element(0x00400009, "SH", "ACC-99887766"))),
          set(0x00081110, "SQ", item(element(0x00081155, "UI", "1.2.3.4.5.12")))};
}

DicomSpec patientSpec(Syntax syntax = Syntax::ExplicitLittle) {
  DicomSpec spec = pictureSpec(syntax);
  spec.patientName = "Mustermann^Erika";
  spec.patientId = "MRN-4711-0815";
  spec.birthDate = "19640812";
  spec.sex = "F";
  spec.accessionNumber = "ACC-99887766";
  spec.date = "19640812";
  spec.study = "Thorax of MUSTERMANN 19640812";
  spec.description = "Thorax ax 1.25 mm Erika";
  return spec;
}

/// A series of a patient, with names wherever people write them.
fs::path patientSeries(const fs::path& folder, Syntax syntax = Syntax::ExplicitLittle) {
  const fs::path made = folder / "Mustermann_Erika";
  fs::create_directories(made);
  for (int slice = 0; slice < 4; ++slice) {
    DicomSpec spec = patientSpec(syntax);
    spec.instance = "1.2.3.4.5." + std::to_string(slice + 1);
    spec.position = glm::dvec3(-20.5, 10.25, 2.5 * slice);
    spec.instanceNumber = slice + 1;
    spec.slope = "2";
    spec.intercept = "-1024";
    const fs::path file = made / ("Mustermann_" + std::to_string(slice) + ".dcm");
    if (syntax == Syntax::ExplicitLittle)
      writeEdited(file, spec, plantedEdits());
    else
      writeDicom(file, spec);
  }
  return made;
}

/// A structure set of one rectangle on the second slice of the series.
RtSpec structureSet(const std::string& name) {
  ContourSpec contour;
  contour.points = rectangle(-15, 15, -5, 25, 2.5);
  RoiSpec roi;
  roi.name = name;
  roi.contours = {contour};
  RtSpec spec;
  spec.rois = {roi};
  return spec;
}

std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void expectNothingPlanted(const fs::path& folder) {
  for (const fs::path& file : filesBelow(folder)) {
    std::string bytes = file.lexically_relative(folder).string() + '\n' + readFile(file);
    for (const std::string& text : planted())
      EXPECT_EQ(bytes.find(text), std::string::npos) << text << " in " << file.filename();
  }
}

/// The bytes of the pixel data as they are stored, by the place of the slice.
std::map<std::string, std::string> pixelsIn(const fs::path& folder) {
  std::map<std::string, std::string> pixels;
  for (const fs::path& file : filesBelow(folder)) {
    DcmFileFormat header;
    io::loadHeader(file, header);
    const std::string place = io::textOf(*header.getDataset(), DCM_InstanceNumber);
    const auto at = io::pixelsOf(*header.getDataset(), file);
    if (!at) {
      ADD_FAILURE() << "no pixels in " << file;
      continue;
    }
    const std::string bytes = readFile(file);
    // Encapsulated pixels have no length: they end at the delimiter of the sequence of fragments.
    const std::string end("\xfe\xff\xdd\xe0\0\0\0\0", 8);
    const std::size_t length = at->encapsulated ? bytes.find(end, at->offset) - at->offset : at->length;
    pixels[place] = bytes.substr(at->offset, length);
  }
  return pixels;
}

DcmFileFormat loaded(const fs::path& file) {
  DcmFileFormat object;
  io::loadObject(file, object);
  return object;
}

class Deidentify : public ::testing::Test {
 protected:
  Outcome run(const fs::path& input, const io::deidentify::Options& options = {}) {
    return io::deidentify::deidentify({.inputs = {input}, .output = out_, .options = options});
  }

  const fs::path folder_ = scratchFolder();
  const fs::path out_ = folder_ / "out";
};

TEST_F(Deidentify, LeavesNothingThatNamesThePatient) {
  const fs::path source = patientSeries(folder_ / "in");
  ASSERT_NE(readFile(filesBelow(source).front()).find("Mustermann"), std::string::npos);
  for (const auto& [name, options] : std::map<std::string, io::deidentify::Options>{
           {"profile", {}}, {"graphics", {.cleanGraphics = true}}, {"descriptors", {.cleanDescriptors = true}}}) {
    SCOPED_TRACE(name);
    fs::remove_all(out_);
    const Outcome outcome = run(source, options);
    EXPECT_EQ(outcome.objects, 4u);
    EXPECT_EQ(filesBelow(out_).size(), 4u);
    expectNothingPlanted(out_);
  }
}

TEST_F(Deidentify, KeepsVoxelsAndGeometry) {
  const fs::path source = patientSeries(folder_ / "in");
  const io::OpenedVolume before = io::openVolume(source);
  run(source);
  const io::OpenedVolume after = io::openVolume(out_);
  EXPECT_EQ(realValues(*after.volume), realValues(*before.volume));
  expectSameGrid(after.volume->grid, before.volume->grid, 0.0);
  EXPECT_EQ(after.patient.name, "");
}

TEST_F(Deidentify, KeepsPixelsToTheBitInEachCoding) {
  for (const Syntax syntax : {Syntax::ImplicitLittle, Syntax::ExplicitLittle, Syntax::ExplicitBig, Syntax::Rle,
                              Syntax::JpegLossless, Syntax::JpegLs}) {
    SCOPED_TRACE(static_cast<int>(syntax));
    fs::remove_all(out_);
    fs::remove_all(folder_ / "in");
    const fs::path source = patientSeries(folder_ / "in", syntax);
    run(source);
    EXPECT_EQ(pixelsIn(out_), pixelsIn(source));
    EXPECT_EQ(realValues(*io::openVolume(out_).volume), realValues(*io::openVolume(source).volume));
    expectNothingPlanted(out_);
  }
}

TEST_F(Deidentify, KeepsDeflatedObjects) {
  const fs::path source = patientSeries(folder_ / "in", Syntax::Deflated);
  run(source);
  EXPECT_EQ(realValues(*io::openVolume(out_).volume), realValues(*io::openVolume(source).volume));
}

TEST_F(Deidentify, SaysWhatWasDone) {
  run(patientSeries(folder_ / "in"), {.retainDates = true, .cleanDescriptors = true});
  DcmFileFormat object = loaded(filesBelow(out_).front());
  DcmDataset& dataset = *object.getDataset();
  EXPECT_EQ(io::textOf(dataset, DCM_PatientIdentityRemoved), "YES");
  EXPECT_NE(io::textOf(dataset, DCM_DeidentificationMethod), "");
  EXPECT_EQ(io::textOf(dataset, DCM_LongitudinalTemporalInformationModified), "UNMODIFIED");
  std::vector<std::string> codes;
  io::forEachItem(dataset, DCM_DeidentificationMethodCodeSequence,
                  [&](DcmItem& code) { codes.push_back(io::textOf(code, DCM_CodeValue)); });
  EXPECT_EQ(codes, (std::vector<std::string>{"113100", "113105", "113106"}));
  EXPECT_EQ(io::textOf(dataset, DCM_SeriesDate), "19640812");
  EXPECT_EQ(io::textOf(dataset, DCM_StudyDescription), "Thorax of");
  EXPECT_EQ(io::textOf(dataset, DCM_SeriesDescription), "Thorax ax 1.25 mm");
  DcmMetaInfo& meta = *object.getMetaInfo();
  EXPECT_EQ(io::textOf(meta, DCM_MediaStorageSOPInstanceUID), io::textOf(dataset, DCM_SOPInstanceUID));
}

TEST_F(Deidentify, ReplacesUidsAlikeInAllObjects) {
  const fs::path source = patientSeries(folder_ / "in");
  SegSpec segmentation;
  segmentation.columns = 40;
  segmentation.rows = 30;
  segmentation.frames = {{1, glm::dvec3(-20.5, 10.25, 2.5), std::vector<int>(1200, 1)}};
  writeSeg(source / "seg.dcm", segmentation);
  writeRtStruct(source / "rt.dcm", structureSet("Mustermann"));
  const io::OpenedVolume before = io::openVolume(source);
  run(source);
  const io::OpenedVolume after = io::openVolume(out_);
  ASSERT_EQ(before.segmentations.size(), 2u);
  ASSERT_EQ(after.segmentations.size(), 2u);
  for (const fs::path& file : filesBelow(out_)) {
    DcmFileFormat object = loaded(file);
    const std::string instance = io::textOf(*object.getDataset(), DCM_SOPInstanceUID);
    EXPECT_TRUE(instance.starts_with("2.25.")) << instance;
    EXPECT_LE(instance.size(), 64u);
    EXPECT_EQ(file.filename().string(), instance + ".dcm");
    EXPECT_EQ(file.parent_path().filename().string(), io::textOf(*object.getDataset(), DCM_SeriesInstanceUID));
  }
  expectNothingPlanted(out_);
}

TEST_F(Deidentify, ReadsLabelsOfCopiesAsBefore) {
  const fs::path source = patientSeries(folder_ / "in"), labels = folder_ / "labels";
  fs::create_directories(labels);
  writeRtStruct(labels / "rt.dcm", structureSet("one"));
  const Grid grid = io::openVolume(source).volume->grid;
  const auto before = io::openLabels(labels / "rt.dcm", grid);
  run(labels);
  const auto after = io::openLabels(filesBelow(out_).front(), grid);
  const std::vector<int> values = valuesOf(*before.labels);
  ASSERT_TRUE(std::any_of(values.begin(), values.end(), [](int value) { return value != 0; }));
  expectSameLabels(*after.labels, *before.labels);
}

TEST_F(Deidentify, KeepsWhatPlacesTheSlicesOfAMosaic) {
  FENESTRA_TEST_DATA_OR_SKIP(mosaic, "dicom/pixel-formats/12bit");
  const io::OpenedVolume before = io::openVolume(mosaic);
  run(mosaic);
  const io::OpenedVolume after = io::openVolume(out_);
  ASSERT_GT(before.volume->grid.dims.z, 1);
  EXPECT_EQ(realValues(*after.volume), realValues(*before.volume));
  expectSameGrid(after.volume->grid, before.volume->grid, 0.0);
}

TEST_F(Deidentify, GivesOtherUidsInEachRun) {
  const fs::path source = patientSeries(folder_ / "in");
  const auto first = run(source).series;
  fs::remove_all(out_);
  EXPECT_NE(run(source).series, first);
  fs::remove_all(out_);
  EXPECT_EQ(run(source, {.retainUids = true}).series.begin()->first, "1.2.3.4");
}

TEST_F(Deidentify, WritesTheMapForItsOwnerAlone) {
  const fs::path source = patientSeries(folder_ / "in"), map = folder_ / "map.tsv";
  const Outcome outcome = io::deidentify::deidentify({.inputs = {source}, .output = out_, .map = map});
  const std::string text = readFile(map);
  EXPECT_NE(text.find("1.2.3.4\t" + outcome.series.begin()->first + "\n"), std::string::npos) << text;
  struct stat status {};
  ASSERT_EQ(::stat(map.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  const std::string refusal = errorOf(
      [&] { io::deidentify::deidentify({.inputs = {source}, .output = folder_ / "b", .map = folder_ / "b/map"}); });
  EXPECT_NE(refusal.find("would be given away"), std::string::npos) << refusal;
}

TEST_F(Deidentify, TellsWhatItWouldDoWithoutWriting) {
  const fs::path source = patientSeries(folder_ / "in");
  const Outcome outcome = io::deidentify::deidentify({.inputs = {source}, .values = true});
  const auto name = outcome.changes.all().find({0x00100010, io::deidentify::Action::Empty});
  ASSERT_NE(name, outcome.changes.all().end());
  EXPECT_EQ(name->second.count, 4u);
  EXPECT_EQ(name->second.values, (std::set<std::string>{"Mustermann^Erika"}));
  EXPECT_EQ(name->second.keyword, "PatientName");
  EXPECT_TRUE(outcome.changes.all().contains({0x00091001, io::deidentify::Action::Remove}));
  const Outcome silent = io::deidentify::deidentify({.inputs = {source}});
  EXPECT_TRUE(silent.changes.all().at({0x00100010, io::deidentify::Action::Empty}).values.empty());
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder_)) left.insert(entry.path().filename().string());
  EXPECT_EQ(left, (std::set<std::string>{"in"}));
}

TEST_F(Deidentify, RefusesFoldersThatHoldFilesOrAreRead) {
  const fs::path source = patientSeries(folder_ / "in");
  fs::create_directories(out_);
  writeFile(out_ / "mine", "kept");
  EXPECT_EQ(errorOf([&] { run(source); }),
            out_.string() + ": holds files; name a folder that does not exist or is empty");
  EXPECT_EQ(readFile(out_ / "mine"), "kept");
  const fs::path inside = source / "copies";
  const std::string refusal = errorOf([&] { io::deidentify::deidentify({.inputs = {source}, .output = inside}); });
  EXPECT_NE(refusal.find("lies in the folder that is read"), std::string::npos) << refusal;
  EXPECT_EQ(filesBelow(source).size(), 4u);
}

TEST_F(Deidentify, LeavesNothingBehindWhereItFails) {
  const fs::path source = patientSeries(folder_ / "in");
  int steps = 0;
  EXPECT_THROW(
      io::deidentify::deidentify({.inputs = {source}, .output = out_},
                                 [&](double fraction, std::string_view) { return fraction < 0.5 || ++steps < 2; }),
      io::Cancelled);
  EXPECT_FALSE(fs::exists(out_));
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++entries;
  EXPECT_EQ(entries, 1u);
}

TEST_F(Deidentify, SaysWhatIsLeftOutAndWhatStays) {
  const fs::path source = patientSeries(folder_ / "in");
  writeFile(source / "notes.txt", "Mustermann");
  writeFile(source / "broken.dcm", readFile(source / "Mustermann_0.dcm").substr(0, 300));
  DicomSpec capture = patientSpec();
  capture.sopClass = "1.2.840.10008.5.1.4.1.1.7";
  capture.instance = "1.2.3.9";
  capture.series = "1.2.3.99";
  writeEdited(source / "capture.dcm", capture, {set(0x00280301, "CS", "YES")});
  const Outcome outcome = run(source);
  EXPECT_EQ(outcome.objects, 5u);
  EXPECT_EQ(outcome.leftOut, 2u);
  std::string texts;
  for (const io::Warning& warning : outcome.warnings) texts += warning.text + "\n";
  EXPECT_NE(texts.find("1 file left out: not DICOM"), std::string::npos) << texts;
  EXPECT_NE(texts.find("1 object with names burned into the pixels"), std::string::npos) << texts;
}

TEST_F(Deidentify, KeepsPatientsApart) {
  const fs::path source = folder_ / "in";
  fs::create_directories(source);
  DicomSpec spec = patientSpec();
  for (const char* id : {"first", "second", "first"}) {
    spec.patientId = id;
    spec.instance += ".1";
    writeDicom(source / (spec.instance + ".dcm"), spec);
  }
  run(source);
  std::map<std::string, int> patients;
  for (const fs::path& file : filesBelow(out_)) ++patients[io::textOf(*loaded(file).getDataset(), DCM_PatientID)];
  ASSERT_EQ(patients.size(), 2u);
  EXPECT_EQ(patients.begin()->second + patients.rbegin()->second, 3);
  EXPECT_EQ(patients.begin()->first.size(), 12u);
}

TEST_F(Deidentify, RefusesWhatHoldsNoObjects) {
  fs::create_directories(folder_ / "in");
  writeFile(folder_ / "in/notes.txt", "nothing");
  const std::string refusal = errorOf([&] { run(folder_ / "in"); });
  EXPECT_NE(refusal.find("holds no DICOM objects"), std::string::npos) << refusal;
  EXPECT_NE(errorOf([&] { run(folder_ / "none"); }).find("does not exist"), std::string::npos);
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Deidentify, KeepsObjectsOfOneUidApart) {
  const fs::path source = folder_ / "in";
  fs::create_directories(source);
  DicomSpec spec = patientSpec();
  writeDicom(source / "a.dcm", spec);
  spec.position = glm::dvec3(0, 0, 5);
  writeDicom(source / "b.dcm", spec);
  run(source);
  EXPECT_EQ(filesBelow(out_).size(), 2u);
}

TEST_F(Deidentify, CleansTheElementsWhoseVrIsUnknown) {
  // A sequence of unknown VR is coded with implicit VR (PS3.5 6.2.2): tag, length, value.
  const std::string name = std::string("\x10\x00\x10\x00\x10\x00\x00\x00", 8) + "Mustermann^Erika";
  const fs::path source = folder_ / "in";
  fs::create_directories(source);
  writeEdited(source / "a.dcm", patientSpec(),
              {set(0x00081090, "LO", "Erika"), unknown(0x00100010), unknown(0x00081090), unknown(0x00080018),
               unknown(0x0020000e), set(0x00081140, "UN", item(name))});
  run(source);
  expectNothingPlanted(out_);
  DcmFileFormat object = loaded(filesBelow(out_).front());
  EXPECT_TRUE(io::textOf(*object.getDataset(), DCM_SOPInstanceUID).starts_with("2.25."));
}

TEST(DeidentifyWords, KeepOnlyHarmlessOnes) {
  using io::deidentify::plainWords;
  EXPECT_EQ(plainWords("CT Abdomen/Pelvis w/o contrast 1.25mm", {}), "CT Abdomen Pelvis w o contrast 1.25mm");
  EXPECT_EQ(plainWords("T2_TSE_SAG Müller 12.03.1965", {}), "T2 TSE SAG");
  EXPECT_EQ(plainWords("Hand of John Hand, 4711", {"hand", "john"}), "of");
  EXPECT_EQ(plainWords("20240131 1234567", {}), "");
  EXPECT_EQ(plainWords("12-03-65", {}), "12");
  EXPECT_EQ(plainWords("", {}), "");
}

}  // namespace
}  // namespace fenestra::tests::deidentify_run
