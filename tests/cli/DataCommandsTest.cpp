// fenestra-cli info, convert, measure, slice, surface and compare.

#include <cmath>
#include <cstdint>
#include <limits>

#include "io/ImageWriter.h"
#include "tests/cli/CommandLine.h"
#include "tests/io/DicomWriter.h"

namespace fenestra::tests::dataCommandsTest {
namespace {

using DataCommands = CommandLine;

TEST_F(DataCommands, InfoDescribesThePhantom) {
  const Result result = run({"info", "--phantom", "torso", "--phantom-voxels", "48"});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_TRUE(result.error.empty()) << result.error;
  const Json info = result.json();
  EXPECT_EQ(info["format"], "phantom");
  EXPECT_EQ(info["unit"], "HU");
  EXPECT_EQ(info["modality"], "CT");
  EXPECT_EQ(info["type"], "int16");
  EXPECT_EQ(info["dims"].size(), 3u);
  EXPECT_EQ(info["dims"][2], 48);
  EXPECT_EQ(info["range"][0], -1000.0);
  EXPECT_EQ(info["warnings"], Json::array());
}

TEST_F(DataCommands, InfoTellsSeriesApartWithoutNamingThePatient) {
  const fs::path folder = at("dicom");
  fs::create_directories(folder);
  for (const std::string& kernel : {std::string("B30f"), std::string()}) {
    DicomSpec spec;
    spec.series = kernel.empty() ? "1.2.4" : "1.2.3";
    spec.instance = spec.series + ".1";
    spec.kernel = kernel;
    spec.patientName = "Vermeer^Johanna";
    spec.patientId = "QX-4711";
    if (!kernel.empty()) {
      spec.seriesNumber = "7";
      spec.thickness = "1.5";
    }
    writeDicom(folder / spec.series, spec);
  }
  const Result result = run({"info", folder.string()});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json series = result.json()["series"], other = result.json()["other_series"][0];
  EXPECT_EQ(series["number"], 7);
  EXPECT_EQ(series["thickness"], 1.5);
  EXPECT_EQ(series["kernel"], "B30f");
  EXPECT_FALSE(other.contains("number") || other.contains("thickness") || other.contains("kernel")) << other;
  for (const char* name : {"Vermeer", "QX-4711"}) EXPECT_EQ(result.out.find(name), std::string::npos) << name;
}

TEST_F(DataCommands, MeasuresEachLabel) {
  const Json all = run({"measure", "--phantom", "torso", "--phantom-voxels", "48"}).json();
  const Json info = run({"info", "--phantom", "torso", "--phantom-voxels", "48"}).json();
  EXPECT_EQ(all["unit"], "HU");
  double voxel = 1.0;
  for (const Json& spacing : info["spacing"]) voxel *= spacing.get<double>();
  ASSERT_GT(all["labels"].size(), 5u);
  for (const Json& label : all["labels"]) {
    if (label["voxels"] == 0) {  // too small for so coarse a phantom
      EXPECT_TRUE(label["mean"].is_null() && label["box_lps"].is_null()) << label;
      continue;
    }
    EXPECT_NEAR(label["ml"].get<double>(), label["voxels"].get<double>() * voxel / 1000.0, 1e-9) << label;
    EXPECT_LE(label["min"], label["mean"]) << label;
    EXPECT_LE(label["mean"], label["max"]) << label;
    for (int k = 0; k < 3; ++k) {
      EXPECT_LT(label["box_lps"][0][k], label["centre_lps"][k]) << label;
      EXPECT_LT(label["centre_lps"][k], label["box_lps"][1][k]) << label;
    }
  }
  const std::string name = all["labels"][2]["name"];
  const Json one = run({"measure", "--phantom", "torso", "--phantom-voxels", "48", "--focus-labels", name}).json();
  ASSERT_EQ(one["labels"].size(), 1u);
  EXPECT_EQ(one["labels"][0], all["labels"][2]);

  EXPECT_EQ(run({"convert", "--phantom", "torso", "--phantom-voxels", "48", "-o", at("bare.mha")}).exitCode, 0);
  const Result bare = run({"measure", at("bare.mha")});
  EXPECT_EQ(bare.exitCode, 1);
  EXPECT_NE(bare.error.find("name a label map with --labels"), std::string::npos) << bare.error;
}

TEST_F(DataCommands, TagsOfASliceAreListedWithoutThePatient) {
  const fs::path folder = at("tags");
  fs::create_directories(folder);
  for (int i = 0; i < 3; ++i) {
    DicomSpec spec;
    spec.instance = "1.2.3." + std::to_string(i);
    spec.instanceNumber = 10 + i;
    spec.position = glm::dvec3(0, 0, -2.0 * i);
    spec.patientName = "Vermeer^Johanna";
    writeDicom(folder / std::to_string(i), spec);
  }
  const auto numberOf = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"info", folder.string(), "--tags", "--search", "instancenumber"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words).json()["tags"][0]["value"];
  };
  EXPECT_EQ(numberOf({}), "11");
  EXPECT_EQ(numberOf({"--slice", "0"}), "12");
  EXPECT_EQ(numberOf({"--slice", "2"}), "10");

  const Result hidden = run({"info", folder.string(), "--tags"});
  ASSERT_EQ(hidden.exitCode, 0) << hidden.error;
  EXPECT_EQ(hidden.out.find("Vermeer"), std::string::npos);
  EXPECT_EQ(run({"info", folder.string(), "--tags", "--search", "vermeer"}).json()["tags"], Json::array());
  const Json shown = run({"info", folder.string(), "--tags", "--search", "0010,0010", "--with-patient"}).json();
  EXPECT_EQ(shown["tags"][0]["value"], "Vermeer^Johanna");
  EXPECT_EQ(shown["slices"], 3);

  for (const char* beyond : {"3", "-1"}) {
    const Result outside = run({"info", folder.string(), "--tags", "--slice", beyond});
    EXPECT_EQ(outside.exitCode, 1);
    EXPECT_NE(outside.error.find("slices run from 0 to 2"), std::string::npos) << outside.error;
  }
  // Pixels are not decoded: a slice whose pixels are damaged is listed, too.
  DicomSpec packed = pictureSpec(Syntax::JpegLossless);
  packed.patientName = "Vermeer^Johanna";
  const fs::path damaged = at("damaged.dcm");
  writeDicom(damaged, packed);
  std::string bytes = contents(damaged);
  bytes.replace(bytes.size() - 200, 150, std::string(150, '\x55'));
  std::ofstream(damaged, std::ios::binary) << bytes;
  EXPECT_EQ(run({"info", damaged.string()}).exitCode, 1) << "its pixels cannot be decoded";
  EXPECT_EQ(run({"info", damaged.string(), "--tags"}).json()["slices"], 1);

  const Result phantom = run({"info", "--phantom", "head", "--phantom-voxels", "16", "--tags"});
  EXPECT_EQ(phantom.exitCode, 1);
  EXPECT_NE(phantom.error.find("has no DICOM attributes"), std::string::npos) << phantom.error;
  EXPECT_EQ(run({"info", folder.string(), "--slice", "1"}).exitCode, 2);
}

TEST_F(DataCommands, ConvertedVolumesAreTheSameVolume) {
  const Json original = run({"info", "--phantom", "head", "--phantom-voxels", "40"}).json();
  for (const std::string name : {"volume.mha", "volume.nii.gz", "volume.nii", "volume.nrrd", "Kopf größer 頭.nrrd"}) {
    const Result converted = run({"convert", "--phantom", "head", "--phantom-voxels", "40", "-o", at(name)});
    ASSERT_EQ(converted.exitCode, 0) << converted.error;
    const Result result = run({"info", at(name)});
    ASSERT_EQ(result.exitCode, 0) << name << ": " << result.error;
    const Json info = result.json();
    EXPECT_EQ(info["dims"], original["dims"]) << name;
    EXPECT_EQ(info["type"], original["type"]) << name;
    EXPECT_EQ(info["range"], original["range"]) << name;
    for (int axis = 0; axis < 3; ++axis) {
      // NIfTI keeps its geometry in single precision: 6e-8 of up to 150 mm.
      EXPECT_NEAR(info["spacing"][axis].get<double>(), original["spacing"][axis].get<double>(), 1e-5) << name;
      EXPECT_NEAR(info["origin"][axis].get<double>(), original["origin"][axis].get<double>(), 1e-4) << name;
      for (int column = 0; column < 3; ++column)
        EXPECT_NEAR(info["direction"][axis][column].get<double>(), axis == column, 1e-6) << name;
    }
  }
}

TEST_F(DataCommands, LabelsAreWrittenByNumberAndName) {
  const std::vector<std::string> phantom{"--phantom", "torso", "--phantom-voxels", "48"};
  const auto convert = [&](std::vector<std::string> more) {
    std::vector<std::string> all{"convert"};
    all.insert(all.end(), phantom.begin(), phantom.end());
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  EXPECT_EQ(convert({"-o", at("volume.nrrd")}).exitCode, 0);
  EXPECT_EQ(convert({"--focus-labels", "left kidney,right kidney", "-o", at("kidneys.nrrd")}).exitCode, 0);
  EXPECT_NE(contents(at("kidneys.nrrd")).find("Segment1_Name:=left kidney"), std::string::npos);
  EXPECT_EQ(contents(at("kidneys.nrrd")).find("Segment2_"), std::string::npos);
  // The whole label map, because a .dcm is a segmentation; back as labels of the volume, and out again.
  EXPECT_EQ(convert({"-o", at("all.dcm")}).exitCode, 0);
  const Result again = run({"convert", at("volume.nrrd"), "--labels", at("all.dcm"), "--focus-labels", "left kidney",
                            "-o", at("left.nii.gz")});
  EXPECT_EQ(again.exitCode, 0) << again.error;
  EXPECT_EQ(again.error, "");
  expectFailure(run({"convert", at("volume.nrrd"), "-o", at("x.dcm")}), at("volume.nrrd"));
  expectFailure(convert({"--focus-labels", "aorta", "-o", at("x.png")}), at("x.png"));
  EXPECT_EQ(run({"convert", at("volume.nrrd"), "--focus-labels", "3", "-o", at("x.nrrd")}).exitCode, 2);
}

TEST_F(DataCommands, SliceOfRawBytesIsExact) {
  // 3×2×2: value 10·x + 40·y + 100·z; axes along L, P, S.
  std::string bytes;
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x) bytes += static_cast<char>(10 * x + 40 * y + 100 * z);
  const std::string raw = (folder() / "bytes.raw").string();
  write(raw, bytes);
  const auto sliceOf = [&](const std::string& plane, const std::string& index) {
    const Result result = run({"slice", raw, "--raw", "3x2x2:uint8", "--spacing", "1,2,3", "--plane", plane, "--index",
                               index, "--window", "255", "--level", "127.5", "-o", at("slice.png")});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    std::vector<int> grey;
    for (const float value : io::readPicture(at("slice.png")).values)
      grey.push_back(static_cast<int>(std::lround(value * 255.0f)));
    return grey;
  };
  EXPECT_EQ(sliceOf("axial", "1"), (std::vector<int>{100, 110, 120, 140, 150, 160}));
  EXPECT_EQ(sliceOf("coronal", "0"), (std::vector<int>{100, 110, 120, 0, 10, 20}));
  EXPECT_EQ(sliceOf("sagittal", "2"), (std::vector<int>{120, 160, 20, 60}));
}

TEST_F(DataCommands, SlicesOfThePhantomAreTheRightWayUp) {
  const auto sliceOf = [&](const std::string& plane, const std::string& mm) {
    const Result result = run({"slice", "--phantom", "head", "--phantom-voxels", "150", "--plane", plane, "--at", mm,
                               "--window", "400", "--level", "0", "-o", at("slice.png")});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return io::readPicture(at("slice.png"));
  };
  const auto grey = [](const io::Picture& picture, int i, int j) {
    return picture.values[static_cast<std::size_t>(j * picture.size.x + i)];
  };
  /// Pixels of air from an edge inwards: from (i, j) in steps of (di, dj).
  const auto air = [&](const io::Picture& picture, int i, int j, int di, int dj) {
    int steps = 0;
    for (; i >= 0 && j >= 0 && i < picture.size.x && j < picture.size.y && grey(picture, i, j) < 0.1f; i += di, j += dj)
      ++steps;
    return steps;
  };
  // The nose comes close to the front of the picture's box, the back of the head does not.
  const io::Picture axial = sliceOf("axial", "-30");
  const int middle = axial.size.x / 2;
  EXPECT_LT(air(axial, middle, 0, 0, 1) + 5, air(axial, middle, axial.size.y - 1, 0, -1));
  // The neck runs out of the box below, there is air above the crown.
  const io::Picture coronal = sliceOf("coronal", "15");
  EXPECT_EQ(air(coronal, coronal.size.x / 2, coronal.size.y - 1, 0, -1), 0);
  EXPECT_GT(air(coronal, coronal.size.x / 2, 0, 0, 1), 3);
  const io::Picture sagittal = sliceOf("sagittal", "0");
  EXPECT_EQ(air(sagittal, sagittal.size.x / 2, sagittal.size.y - 1, 0, -1), 0);
  const int noseRow = sagittal.size.y * 6 / 10;  // z = -30 of 150 … -150
  EXPECT_LT(air(sagittal, 0, noseRow, 1, 0) + 5, air(sagittal, sagittal.size.x - 1, noseRow, -1, 0));
}

TEST_F(DataCommands, SliceOutsideTheVolumeFails) {
  const Result result =
      run({"slice", "--phantom", "head", "--phantom-voxels", "16", "--index", "16", "-o", at("x.png")});
  expectFailure(result, "phantom head");
  EXPECT_NE(result.error.find("0 to 15"), std::string::npos) << result.error;
  EXPECT_TRUE(nothingLeftBehind());
}

TEST_F(DataCommands, ASurfaceIsWrittenAndMeasured) {
  const std::vector<std::string> scene{"surface", "--phantom",      "torso",       "--phantom-voxels",
                                       "64",      "--focus-labels", "left kidney", "-o"};
  std::vector<double> volumes;
  for (const char* name : {"a.stl", "a.ply", "a.obj"}) {
    std::vector<std::string> all = scene;
    all.insert(all.end(), {at(name), "--frame", "ras"});
    const Result result = run(all);
    ASSERT_EQ(result.exitCode, 0) << result.error;
    volumes.push_back(result.json().at("volume_ml"));
    EXPECT_EQ(result.json().at("frame"), "ras");
    EXPECT_GT(fs::file_size(at(name)), 1000u);
  }
  // A kidney has some 150 ml.
  EXPECT_GT(volumes[0], 50.0);
  EXPECT_LT(volumes[0], 400.0);
  EXPECT_EQ(volumes[0], volumes[1]);
  std::vector<std::string> all = scene;
  all.push_back(at("a.vtk"));
  expectFailure(run(all), at("a.vtk"));
  EXPECT_EQ(run({"surface", "--phantom", "torso"}).exitCode, 2);
}

TEST_F(DataCommands, CompareMeasuresErrors) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<float> a{0.0f, 1.0f, 2.0f, nan, inf, -inf}, b{0.5f, 1.0f, 0.0f, nan, inf, -inf};
  io::writeLayer(at("a.mha"), {3, 2}, 1, a);
  io::writeLayer(at("b.mha"), {3, 2}, 1, b);
  const Result same = run({"compare", at("a.mha"), at("a.mha")});
  EXPECT_EQ(same.exitCode, 0) << same.error;
  EXPECT_EQ(same.json()["max"], 0.0);
  const Result differ = run({"compare", at("a.mha"), at("b.mha")});
  EXPECT_EQ(differ.exitCode, 0) << differ.error;
  EXPECT_EQ(differ.json()["compared"], 3);
  EXPECT_EQ(differ.json()["max"], 2.0);
  EXPECT_NEAR(differ.json()["rms"].get<double>(), std::sqrt(4.25 / 3.0), 1e-12);
  EXPECT_EQ(differ.json()["percentiles"]["50"], 0.5);
}

TEST_F(DataCommands, CompareFailsWhereNanOrInfinityDisagree) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  io::writeLayer(at("finite.mha"), {2, 1}, 1, std::vector<float>{1.0f, 2.0f});
  io::writeLayer(at("nan.mha"), {2, 1}, 1, std::vector<float>{1.0f, nan});
  io::writeLayer(at("inf.mha"), {2, 1}, 1, std::vector<float>{1.0f, inf});
  io::writeLayer(at("minus.mha"), {2, 1}, 1, std::vector<float>{1.0f, -inf});
  const auto compared = [&](const std::string& a, const std::string& b) { return run({"compare", at(a), at(b)}); };
  EXPECT_EQ(compared("finite.mha", "nan.mha").exitCode, 1);
  EXPECT_EQ(compared("finite.mha", "nan.mha").json()["nan_mismatches"], 1);
  EXPECT_EQ(compared("inf.mha", "finite.mha").exitCode, 1);
  EXPECT_EQ(compared("inf.mha", "minus.mha").json()["infinity_mismatches"], 1);
  EXPECT_EQ(compared("nan.mha", "inf.mha").exitCode, 1);
}

TEST_F(DataCommands, CompareRefusesDifferentSizesAndNoPictures) {
  io::writeLayer(at("a.mha"), {2, 1}, 1, std::vector<float>{1.0f, 2.0f});
  io::writeLayer(at("b.mha"), {1, 2}, 1, std::vector<float>{1.0f, 2.0f});
  expectFailure(run({"compare", at("a.mha"), at("b.mha")}), at("b.mha"));
  expectFailure(run({"compare", at("a.mha"), at("missing.png")}), at("missing.png"));
  write(at("noise.png"), randomBytes(400));
  expectFailure(run({"compare", at("noise.png"), at("a.mha")}), at("noise.png"));
}

}  // namespace
}  // namespace fenestra::tests::dataCommandsTest
