// fenestra-cli report: results as DICOM objects that validators accept, and that info reads again.

#include <cmath>
#include <map>
#include <set>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "io/ImageWriter.h"
#include "io/LabelReader.h"
#include "io/LabelWriter.h"
#include "io/VolumeReader.h"
#include "io/session/SessionFile.h"
#include "io/study/SessionData.h"
#include "rendering/volume/LabelStatistics.h"
#include "tests/cli/CommandLine.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/LabelFiles.h"

namespace fenestra::tests::report_command {
namespace {

bool isInstalled(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

class ReportCommand : public CommandLine {
 protected:
  void SetUp() override {
    fs::create_directories(source_);
    DicomSpec spec = pictureSpec();
    spec.patientName = "Mustermann^Erika";
    spec.patientId = "4711";
    spec.birthDate = "19700102";
    spec.sex = "F";
    spec.date = "20260102";
    for (int slice = 0; slice < 5; ++slice) {
      spec.instance = "1.2.3.4.5." + std::to_string(slice + 1);
      spec.instanceNumber = slice + 1;
      spec.position = glm::dvec3(-20, 7, 2.5 * slice);
      writeDicom(source_ / (std::to_string(slice) + ".dcm"), spec);
    }
    writeLabelsOn(source_, "labels.nrrd");
  }

  /// Two boxes, labels 3 and 8, on the grid of a volume; 9 is named, but has no voxels.
  void writeLabelsOn(const fs::path& volume, const std::string& name) {
    labels_.grid = io::openVolume(volume).volume->grid;
    labels_.labels = {{3, "Niere größer", {1, 0.5, 0}}, {8, "", {0, 0.2, 0.9}}, {9, "none", {0, 1, 0}}};
    labels_.voxels = Voxels(ScalarType::UInt8, labels_.grid.voxelCount());
    const glm::ivec3 dims = labels_.grid.dims;
    std::size_t next = 0;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x, ++next)
          labels_.voxels.as<std::uint8_t>()[next] = static_cast<std::uint8_t>(x < dims.x / 3 && z > 0            ? 3
                                                                              : x > dims.x / 2 && y < dims.y / 2 ? 8
                                                                                                                 : 0);
    io::writeLabels(labels_, at(name));
  }

  /// Runs report, which must succeed.
  Json report(std::vector<std::string> words) const {
    words.insert(words.begin(), "report");
    const Result done = run(words);
    EXPECT_EQ(done.exitCode, 0) << done.error;
    return done.json();
  }
  Json info(const std::string& name) const {
    const Result done = run({"info", at(name), "--descriptions"});
    EXPECT_EQ(done.exitCode, 0) << done.error;
    return done.json();
  }

  /// Writes `everyKind`; the report is about labels and drawn measures.
  void writeEveryKind(const std::string& series, const std::string& labels) const {
    io::Session session;
    session.volume = io::sessionVolume(series, io::openVolume(series));
    const glm::dvec3 a(labels_.grid.worldFromIndex() * glm::dvec4(1, 1, 1, 1)),
        b(labels_.grid.worldFromIndex() * glm::dvec4(9, 6, 1, 1)),
        c(labels_.grid.worldFromIndex() * glm::dvec4(1, 9, 1, 1));
    const glm::dvec3 right = labels_.grid.direction[0], down = labels_.grid.direction[1];
    session.measures = {{MeasureKind::Distance, {a, b}, right, down},
                        {MeasureKind::Angle, {b, a, c}, right, down},
                        {MeasureKind::Ellipse, {a, b}, right, down},
                        {MeasureKind::Rectangle, {a, b}, right, down}};
    io::noteContents(session);
    io::writeSession(at("work.fenestra"), session);
    report({"measures", at("work.fenestra"), "--labels", at(labels), "-o", at("all.dcm")});
    report({"capture", series, "--picture", at("picture.png"), "-o", at("picture.dcm")});
    report({"keys", series, "--slices", "1,3", "--description", "why", "-o", at("keys.dcm")});
  }
  const std::vector<std::string> everyKind{"all.dcm", "all-segments.dcm", "picture.dcm", "keys.dcm"};

  /// The lines of errors of a validator about files.
  std::string errorsOf(const std::string& validator, const std::vector<std::string>& names) const {
    const fs::path log = folder() / "validator.log";
    std::string errors;
    for (const std::string& name : names) {
      [[maybe_unused]] const int status =
          std::system((validator + " '" + at(name) + "' > '" + log.string() + "' 2>&1").c_str());
      std::ifstream lines(log);
      bool isEmpty = true;
      for (std::string line; std::getline(lines, line); isEmpty = false)
        if (line.starts_with("Error") || line.find("xception") != std::string::npos)
          errors += name + ": " + line + "\n";
      if (isEmpty) errors += name + ": the validator said nothing\n";
    }
    return errors;
  }

  const fs::path source_ = folder() / "in";
  LabelMap labels_;
};

/// The values of one group as derivation or name → value.
std::map<std::string, double> valuesOf(const Json& info, const std::string& group) {
  std::map<std::string, double> values;
  for (const Json& value : info["measures"])
    if (value["of"] == group)
      values[value["derivation"].is_null() ? value["name"] : value["derivation"]] = value["value"];
  return values;
}

}  // namespace

TEST_F(ReportCommand, MeasuresComeBackToTheLastDigitWithTheirSegments) {
  const Json made = report({"measures", at("in"), "--labels", at("labels.nrrd"), "-o", at("measures.dcm")});
  EXPECT_EQ(made["labels"], 2);
  EXPECT_EQ(made["segments"], at("measures-segments.dcm"));
  EXPECT_EQ(made["study"], "1.2");
  const Json read = info("measures.dcm"), segments = info("measures-segments.dcm");
  EXPECT_EQ(read["kind"], "measures");
  EXPECT_EQ(read["title"], "Imaging Measurement Report");
  EXPECT_EQ(read["study"], "1.2");
  EXPECT_NE(read["series"], "1.2.3.4");
  EXPECT_EQ(segments["kind"], "segmentation");
  EXPECT_EQ(segments["segments"], Json({"Niere größer", "label 8"}));
  EXPECT_EQ(segments["study"], "1.2");
  EXPECT_EQ(segments["frame_of_reference"], "1.2.3");
  const Json measured = run({"measure", at("in"), "--labels", at("labels.nrrd")}).json();
  for (const int row : {0, 1}) {
    const Json& expected = measured["labels"][static_cast<std::size_t>(row)];
    const auto values = valuesOf(read, row == 0 ? "Niere größer" : "label 8");
    ASSERT_EQ(values.size(), 5u) << read.dump(2);
    EXPECT_EQ(values.at("Volume"), expected["ml"]);
    EXPECT_EQ(values.at("Mean"), expected["mean"]);
    EXPECT_EQ(values.at("Standard Deviation"), expected["sd"]);
    EXPECT_EQ(values.at("Minimum"), expected["min"]);
    EXPECT_EQ(values.at("Maximum"), expected["max"]);
  }
  for (const Json& value : read["measures"]) {
    EXPECT_EQ(value["segment"], value["of"] == "label 8" ? 2 : 1);
    EXPECT_EQ(value["unit"], value["name"] == "Volume" ? "cm3" : "[hnsf'U]");
  }
  // Patient and study are the source's; the name stands nowhere but where it stood.
  const std::string bytes = contents(at("measures.dcm"));
  EXPECT_NE(bytes.find("Mustermann^Erika"), std::string::npos);
  EXPECT_EQ(bytes.find("Mustermann"), bytes.rfind("Mustermann"));
  EXPECT_EQ(run({"info", at("measures.dcm")}).out.find("Mustermann"), std::string::npos);
}

TEST_F(ReportCommand, DrawnMeasuresKeepTheirPoints) {
  io::Session session;
  session.volume.path = at("in");
  session.measures = {{MeasureKind::Distance, {{-18, 9, 2.5}, {-10, 15, 2.5}}},
                      {MeasureKind::Angle, {{-10, 10, 5}, {-15, 10, 5}, {-15, 20, 5}}},
                      {MeasureKind::Ellipse, {{-15, 12, 5}, {-5, 16, 5}}},
                      {MeasureKind::Rectangle, {{-15, 12, 5}, {-5, 16, 5}}}};
  io::writeSession(at("work.fenestra"), session);
  const Json made = report({"measures", at("work.fenestra"), "-o", at("drawn.dcm")});
  EXPECT_EQ(made["measures"], 4);
  EXPECT_TRUE(made["segments"].is_null());
  const Json read = info("drawn.dcm");
  EXPECT_EQ(valuesOf(read, "distance 1"), (std::map<std::string, double>{{"Length", 10.0}}));
  EXPECT_EQ(valuesOf(read, "angle 1"), (std::map<std::string, double>{{"Angle", 90.0}}));
  EXPECT_EQ(valuesOf(read, "rectangle 1").at("Area"), 40.0);
  EXPECT_NEAR(valuesOf(read, "ellipse 1").at("Area"), 10.0 * std::acos(-1.0), 1e-9);  // rounding of π · 5 · 2
  EXPECT_EQ(valuesOf(read, "ellipse 1").size(), 5u);
  std::map<std::string, Json> points;
  for (const Json& value : read["measures"])
    if (value.contains("points_lps")) points[value["of"]] = value["points_lps"];
  EXPECT_EQ(points["distance 1"], Json::parse("[[-18,9,2.5],[-10,15,2.5]]"));
  EXPECT_EQ(points["angle 1"], Json::parse("[[-10,10,5],[-15,10,5],[-15,20,5]]"));
  EXPECT_EQ(points["ellipse 1"], Json::parse("[[-15,14,5],[-5,14,5],[-10,12,5],[-10,16,5]]"));
  EXPECT_EQ(points["rectangle 1"], Json::parse("[[-15,12,5],[-5,12,5],[-5,16,5],[-15,16,5],[-15,12,5]]"));
  EXPECT_EQ(read["frame_of_reference"], "1.2.3");
}

TEST_F(ReportCommand, SegmentationsOpenAsTheSameLabels) {
  report({"segmentation", at("in"), "--labels", at("labels.nrrd"), "-o", at("seg.dcm")});
  const auto read = io::openLabels(at("seg.dcm"), labels_.grid).labels;
  for (std::uint8_t& value : labels_.voxels.as<std::uint8_t>()) value = value == 3 ? 1 : value == 8 ? 2 : 0;
  expectSameLabels(*read, labels_);
}

TEST_F(ReportCommand, CapturesHoldThePictureAndItsTexts) {
  const std::vector<std::uint8_t> pixels{255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 8, 7, 1, 2, 3};
  io::writePng(at("picture.png"), {5, 1}, 3, pixels, {{"Certificate", "{\"within\": 0.5}"}});
  report({"capture", at("in"), "--picture", at("picture.png"), "--description", "Niere von vorn", "-o", at("cap.dcm")});
  const Json read = info("cap.dcm");
  EXPECT_EQ(read["kind"], "capture");
  EXPECT_EQ(read["study"], "1.2");
  EXPECT_EQ(read["description"], "Niere von vorn");
  ASSERT_EQ(read["texts"].size(), 2u);
  EXPECT_EQ(read["texts"][1], "{\"within\": 0.5}");
  const std::string bytes = contents(at("cap.dcm"));
  EXPECT_NE(bytes.find(std::string(pixels.begin(), pixels.end())), std::string::npos);
  EXPECT_NE(bytes.find("Mustermann^Erika"), std::string::npos);
  // Without DICOM, it is a study of its own.
  const Json alone = report({"capture", "--phantom", "torso", "--picture", at("picture.png"), "-o", at("alone.dcm")});
  EXPECT_NE(alone["study"], "1.2");
}

TEST_F(ReportCommand, KeyObjectsNameTheSlices) {
  report({"keys", at("in"), "--slices", "0,2-3", "--description", "Läsion", "-o", at("keys.dcm")});
  const Json read = info("keys.dcm");
  EXPECT_EQ(read["kind"], "keys");
  EXPECT_EQ(read["title"], "Of Interest");
  EXPECT_EQ(read["texts"], Json({"Läsion"}));
  std::set<std::string> named;
  for (const Json& image : read["images"]) named.insert(image["instance"]);
  EXPECT_EQ(named, (std::set<std::string>{"1.2.3.4.5.1", "1.2.3.4.5.3", "1.2.3.4.5.4"}));
}

TEST_F(ReportCommand, DciodvfyAcceptsEveryKind) {
  if (!isInstalled("dciodvfy")) GTEST_SKIP() << "needs dciodvfy, of the package dicom3tools";
  io::writePng(at("picture.png"), {2, 1}, 3, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6});
  writeEveryKind(at("in"), "labels.nrrd");
  EXPECT_EQ(errorsOf("dciodvfy", everyKind), "");
  report({"capture", "--phantom", "torso", "--picture", at("picture.png"), "-o", at("alone.dcm")});
  EXPECT_EQ(errorsOf("dciodvfy", {"alone.dcm"}), "");
}

TEST_F(ReportCommand, DciodvfyAcceptsEveryKindOfASeriesWithFlaws) {
  if (!isInstalled("dciodvfy")) GTEST_SKIP() << "needs dciodvfy, of the package dicom3tools";
  io::writePng(at("picture.png"), {2, 1}, 3, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6});
  // A plane is interpolated where a slice is missing, and no image is its source; "0Y" is no age.
  fs::remove(source_ / "2.dcm");
  for (const auto& slice : fs::directory_iterator(source_)) {
    DcmFileFormat file;
    ASSERT_TRUE(file.loadFile(OFFilename(slice.path().c_str())).good());
    file.getDataset()->putAndInsertString(DCM_PatientAge, "0Y");
    ASSERT_TRUE(file.saveFile(OFFilename(slice.path().c_str())).good());
  }
  writeLabelsOn(source_, "labels.nrrd");
  ASSERT_EQ(labels_.grid.dims.z, 5) << "the missing plane is filled";
  writeEveryKind(at("in"), "labels.nrrd");
  EXPECT_EQ(errorsOf("dciodvfy", everyKind), "");
}

TEST_F(ReportCommand, DciodvfyAcceptsEveryKindOfRealSeries) {
  if (!isInstalled("dciodvfy")) GTEST_SKIP() << "needs dciodvfy, of the package dicom3tools";
  FENESTRA_TEST_DATA_OR_SKIP(data, "dicom");
  io::writePng(at("picture.png"), {2, 1}, 3, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6});
  for (const char* name : {"ct-missing-slice", "ct-tiny-uniform", "enhanced/emri_small.dcm"}) {
    SCOPED_TRACE(name);
    writeLabelsOn(data / name, "real.nrrd");
    writeEveryKind((data / name).string(), "real.nrrd");
    EXPECT_EQ(errorsOf("dciodvfy", everyKind), "");
  }
}

TEST_F(ReportCommand, Exhaustive_TheTemplatesAreKept) {
  // Java's limits, which its own rules exceed, are lifted for it.
  const std::string validator =
      "JAVA_TOOL_OPTIONS='-Djdk.xml.xpathTotalOpLimit=0 -Djdk.xml.xpathExprOpLimit=0 "
      "-Djdk.xml.xpathExprGrpLimit=0' DicomSRValidator";
  if (!isInstalled("DicomSRValidator")) GTEST_SKIP() << "needs DicomSRValidator, of the package pixelmed-apps";
  // Labels alone: it takes groups of drawn measures (TID 1501) for volumetric ones (TID 1411), whose container has the
  // same name, and misses their segments.
  report({"measures", at("in"), "--labels", at("labels.nrrd"), "-o", at("all.dcm")});
  report({"keys", at("in"), "--slices", "1,3", "--description", "why", "-o", at("keys.dcm")});
  EXPECT_EQ(errorsOf(validator, {"all.dcm", "keys.dcm"}), "");
}

TEST_F(ReportCommand, SaysWhatIsWrong) {
  EXPECT_EQ(run({"report", "measures", at("in")}).exitCode, 2);
  EXPECT_EQ(run({"report", "capture", at("in"), "-o", at("a.dcm")}).exitCode, 2);
  EXPECT_EQ(run({"report", "keys", at("in"), "-o", at("a.dcm")}).exitCode, 2);
  EXPECT_EQ(run({"report", "keys", at("in"), "--slices", "3-1", "-o", at("a.dcm")}).exitCode, 2);
  EXPECT_EQ(run({"report", "keys", at("in"), "--slices", "1", "-o", at("a.png")}).exitCode, 2);
  expectFailure(run({"report", "keys", at("in"), "--slices", "9", "-o", at("a.dcm")}), at("in"));
  expectFailure(run({"report", "measures", at("in"), "-o", at("a.dcm")}), at("a.dcm"));
  expectFailure(run({"report", "segmentation", at("in"), "-o", at("a.dcm")}), at("in"));
  expectFailure(run({"report", "capture", at("in"), "--picture", at("labels.nrrd"), "-o", at("a.dcm")}),
                at("labels.nrrd"));
  expectFailure(run({"report", "measures", at("labels.nrrd"), "--labels", at("labels.nrrd"), "-o", at("a.dcm")}),
                at("labels.nrrd"));
  EXPECT_FALSE(fs::exists(at("a.dcm")));
  EXPECT_FALSE(fs::exists(at("a-segments.dcm")));
}

}  // namespace fenestra::tests::report_command
