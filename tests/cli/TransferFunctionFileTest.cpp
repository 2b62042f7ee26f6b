#include "io/TransferFunctionFile.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/support/TestData.h"

namespace fenestra::io::transferFunctionFileTest {
namespace {

template <class T>
Volume volumeOf(const std::vector<T>& values) {
  Volume volume;
  volume.grid.dims = {static_cast<int>(values.size()), 1, 1};
  volume.voxels = Voxels(scalarTypeOf<T>(), values.size());
  std::copy(values.begin(), values.end(), volume.voxels.as<T>().begin());
  volume.computeRange();
  return volume;
}

Volume ct() {
  Volume volume = volumeOf<std::int16_t>({-1024, 0, 60, 1500});
  volume.modality = Modality::CT;
  volume.unit = "HU";
  return volume;
}

std::filesystem::path written(const std::string& text) {
  const std::filesystem::path path = tests::scratchFolder() / "function.json";
  std::ofstream(path) << text;
  return path;
}

/// The error's cause, or empty when the file was read.
std::string causeOf(const std::string& text) {
  try {
    loadContextFunction(written(text).string(), ct());
  } catch (const Error& error) {
    return error.cause();
  }
  return {};
}

TEST(TransferFunctionFile, EveryPresetLoads) {
  const auto presets = transferFunctionPresets();
  ASSERT_EQ(presets.size(), 13u);
  for (const TransferFunctionPreset& preset : presets) {
    EXPECT_FALSE(preset.name.empty());
    const TransferFunction function = loadContextFunction(preset.id, ct()).function;
    EXPECT_GE(function.nodes.size(), 2u) << preset.id;
    EXPECT_EQ(function.nodes.front().properties.extinction, 0.0) << preset.id << " makes air opaque";
    EXPECT_TRUE(std::any_of(function.nodes.begin(), function.nodes.end(), [](const auto& node) {
      return node.properties.extinction > 0.0;
    })) << preset.id;
  }
}

TEST(TransferFunctionFile, OpacityIsThatOfOneMillimetre) {
  const TransferFunction function =
      loadContextFunction(
          written(
              R"({"name": "x", "domain": "value", "nodes": [{"value": -5, "colour": [0, 0.5, 1], "opacity": 0.75}]})")
              .string(),
          ct())
          .function;
  ASSERT_EQ(function.nodes.size(), 1u);
  EXPECT_EQ(function.nodes[0].value, -5.0);
  EXPECT_EQ(function.nodes[0].properties.colour, glm::dvec3(0.0, 0.5, 1.0));
  EXPECT_DOUBLE_EQ(1.0 - std::exp(-function.nodes[0].properties.extinction), 0.75);
}

TEST(TransferFunctionFile, PercentilesDescribeTissueOnly) {
  // Three quarters of a head scan are air with noise; tissue runs from 1000 to 2000 in equal shares.
  std::vector<float> values;
  for (int i = 0; i < 3000; ++i) values.push_back(static_cast<float>(i % 50));
  for (int i = 0; i <= 1000; ++i) values.push_back(static_cast<float>(1000 + i));
  values.push_back(1e30f);
  values.push_back(std::numeric_limits<float>::quiet_NaN());
  values.push_back(std::numeric_limits<float>::infinity());
  const auto path = written(R"({"name": "x", "domain": "percentile", "nodes": [
      {"value": 0, "colour": [1, 1, 1], "opacity": 0}, {"value": 50, "colour": [1, 1, 1], "opacity": 1}]})");
  const TransferFunction function = loadContextFunction(path.string(), volumeOf(values)).function;
  EXPECT_EQ(function.nodes[0].value, 1000.0);
  // The one outlier shifts the middle of 1002 values by half a step.
  EXPECT_NEAR(function.nodes[1].value, 1500.0, 0.5);
}

/// The value that a node at the surface of the body gets, with the domain "tissue".
double surfaceOf(const Volume& volume) {
  return loadContextFunction(written(R"({"name": "x", "domain": "tissue", "nodes": [
      {"value": 0, "colour": [1, 1, 1], "opacity": 0}, {"value": 100, "colour": [1, 1, 1], "opacity": 1}]})")
                                 .string(),
                             volume)
      .function.nodes[0]
      .value;
}

TEST(TransferFunctionFile, TissueBeginsAboveAirAndItsNoise) {
  std::vector<float> values;
  for (int i = 0; i < 3000; ++i) values.push_back(static_cast<float>(i % 50));
  for (int i = 0; i < 1000; ++i) values.push_back(static_cast<float>(1000 + i));
  EXPECT_EQ(surfaceOf(volumeOf(values)), 524.5) << "the noise of air is one class, however it is spread";
  for (int i = 0; i < 400; ++i) values.push_back(static_cast<float>(100 + i % 100));
  EXPECT_EQ(surfaceOf(volumeOf(values)), 74.5) << "skin that is darker than all else";
  EXPECT_EQ(surfaceOf(volumeOf<std::uint8_t>({0, 0, 0, 1, 1})), 0.5) << "a mask's surface";
  EXPECT_EQ(surfaceOf(volumeOf<std::uint8_t>({7, 7, 7, 7})), 7.0);
}

TEST(TransferFunctionFile, AnMrHeadStartsWithItsSkin) {
  FENESTRA_TEST_DATA_OR_SKIP(file, "formats/metaimage/HeadMRVolume.mhd");
  const double surface = startingContext(*openVolume(file).volume).function.nodes.front().value;
  // The noise of air has a mean of 3, and from 26 on the face has holes.
  EXPECT_GT(surface, 10.0);
  EXPECT_LT(surface, 20.0);
}

TEST(TransferFunctionFile, PercentilesOfDegenerateVolumes) {
  const auto nodesOf = [](const Volume& volume) { return loadContextFunction("mr", volume).function.nodes; };
  for (const auto& node : nodesOf(volumeOf<std::uint8_t>({7, 7, 7, 7}))) EXPECT_EQ(node.value, 7.0);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const auto& node : nodesOf(volumeOf<float>({nan, nan}))) EXPECT_EQ(node.value, 0.0);
  for (const auto& node : nodesOf(volumeOf<std::int16_t>({-3}))) EXPECT_EQ(node.value, -3.0);
}

TEST(TransferFunctionFile, SaysWhatIsWrong) {
  const auto expectCause = [](const std::string& text, const std::string& part) {
    EXPECT_NE(causeOf(text).find(part), std::string::npos) << "got: " << causeOf(text);
  };
  expectCause("", "not valid JSON");
  expectCause("[]", "top level");
  expectCause(R"({"name": "x", "nodes": []})", "nodes");
  expectCause(R"({"name": "x", "domain": "hue", "nodes": [{}]})", "domain");
  const auto node = [](const std::string& body) {
    return R"({"name": "x", "domain": "percentile", "nodes": [)" + body + "]}";
  };
  expectCause(node("3"), "node 1: not an object");
  expectCause(node(R"({"value": "3", "colour": [1, 1, 1], "opacity": 0})"), "\"value\" is not a number");
  expectCause(node(R"({"value": 101, "colour": [1, 1, 1], "opacity": 0})"), "percentile outside");
  expectCause(node(R"({"value": 1, "colour": [1, 1], "opacity": 0})"), "\"colour\"");
  expectCause(node(R"({"value": 1, "colour": [1, 1, 2], "opacity": 0})"), "\"colour\" lies outside");
  expectCause(node(R"({"value": 1, "colour": [1, 1, 1], "opacity": -1})"), "\"opacity\" lies outside");
  expectCause(
      node(R"({"value": 1, "colour": [1, 1, 1], "opacity": 0}, {"value": 0, "colour": [1, 1, 1], "opacity": 0})"),
      "node 2: its value is less");
}

TEST(TransferFunctionFile, UnknownNameListsThePresets) {
  try {
    loadContextFunction("ct-bones", ct());
    FAIL() << "an unknown preset was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.hint(),
              "the presets are ct-angio, ct-bone, ct-lung, ct-plain, ct-skin, ct-soft-tissue, mr, mr-angio, mr-bright, "
              "mr-t1, mr-t2, pet, ultrasound");
  }
}

TEST(TransferFunctionFile, DefaultFollowsModalityAndRange) {
  EXPECT_EQ(defaultPreset(ct()), "ct-soft-tissue");
  EXPECT_EQ(plainPreset(ct()), "ct-plain");
  Volume mr = volumeOf<std::int16_t>({0, 1200});
  mr.modality = Modality::MR;
  EXPECT_EQ(defaultPreset(mr), "mr-t1");
  EXPECT_EQ(plainPreset(mr), "mr");
  mr.modality = Modality::PT;
  EXPECT_EQ(defaultPreset(mr), "pet");
  mr.modality = Modality::US;
  EXPECT_EQ(defaultPreset(mr), "ultrasound");
  EXPECT_EQ(defaultPreset(volumeOf<std::int32_t>({-1207, 40, 3382})), "ct-soft-tissue") << "HU without a modality";
  EXPECT_EQ(defaultPreset(volumeOf<float>({0.0f, 0.5f, 1.0f})), "mr-t1") << "too few values to tell a CT";
}

/// Air, foam as much as half of the body, muscle with a scanner's noise, and bone up to `densest` HU; each value is
/// `factor` · HU + `offset`.
Volume headOf(double factor, double offset, double densest = 1500.0) {
  std::vector<float> values;
  const auto add = [&](int count, double from, double to) {
    for (int i = 0; i < count; ++i)
      values.push_back(static_cast<float>(factor * (from + (to - from) * i / count) + offset));
  };
  add(20000, -1020.0, -980.0);
  add(6000, -750.0, -300.0);
  add(9000, 0.0, 90.0);
  add(1500, 100.0, densest);
  return volumeOf(values);
}

TEST(TransferFunctionFile, ACtInOtherUnitsStartsAsOneAndKeepsItsTissuesColours) {
  const Volume stored = headOf(1.0, 1024.0), inUnits = headOf(1.0, 0.0);
  EXPECT_EQ(defaultPreset(stored), "ct-soft-tissue");
  EXPECT_EQ(plainPreset(stored), "mr") << "the plain look is what it was";
  const auto expected = loadContextFunction("ct-bone", inUnits).function.nodes;
  const auto shown = loadContextFunction("ct-bone", stored).function.nodes;
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(shown[i].value, expected[i].value + 1024.0);
  const auto path = written(R"({"name": "x", "domain": "value", "nodes": [
      {"value": 150, "colour": [1, 1, 1], "opacity": 0}]})");
  EXPECT_EQ(loadContextFunction(path.string(), stored).function.nodes[0].value, 150.0) << "the volume's own values";
  EXPECT_EQ(defaultPreset(headOf(0.7, 800.0)), "ct-soft-tissue") << "a scale that is not known";
  EXPECT_EQ(defaultPreset(headOf(0.7, 800.0, 700.0)), "mr-t1") << "nothing as dense as compact bone";
  EXPECT_EQ(defaultPreset(headOf(1.0, 1024.0, 700.0)), "mr-t1") << "nothing as dense as compact bone";
  Volume mr = headOf(1.0, 1024.0);
  mr.modality = Modality::MR;
  EXPECT_EQ(defaultPreset(mr), "mr-t1");
}

TEST(TransferFunctionFile, RealCtsInOtherUnitsStartAsCtsAndMrDoesNot) {
  // What is there is held to it, and the message names each file that is not.
  std::string missing;
  const auto presetOf = [&](const char* path) -> std::optional<std::string> {
    if (const std::filesystem::path file = tests::findTestData(path); !file.empty())
      return defaultPreset(*openVolume(file).volume);
    missing += std::string(" ") + path;
    return std::nullopt;
  };
  for (const char* path : {"visible-human/vm_head_ct.mha", "dicom/ct-tiny-uniform", "ct-head/ct.nii.gz"})
    EXPECT_EQ(presetOf(path).value_or("ct-soft-tissue"), "ct-soft-tissue") << path;
  for (const char* path :
       {"visible-human/vm_head_mri.mha", "labelled/brain-colin27/ch2.nii.gz", "formats/metaimage/HeadMRVolume.mhd",
        "formats/nifti/ras.hdr", "dicom/enhanced/Philips_WIP_B0_NS_801_e1.nii"})
    EXPECT_EQ(presetOf(path).value_or("mr-").substr(0, 3), "mr-") << path;
  if (!missing.empty()) GTEST_SKIP() << "needs the test-data files" << missing;
}

/// Air, tissue around 100, and `bright` of a thousand voxels that are `times` as bright.
std::string defaultWith(int bright, int times) {
  std::vector<std::int16_t> values(1000, 0);
  for (int i = 0; i < 1000; ++i) values.push_back(static_cast<std::int16_t>(i < bright ? 100 * times : 90 + i % 20));
  Volume mr = volumeOf(values);
  mr.modality = Modality::MR;
  return defaultPreset(mr);
}

TEST(TransferFunctionFile, DefaultOfAnMrFollowsHowMuchOfItIsBright) {
  EXPECT_EQ(defaultWith(0, 1), "mr-t1");
  EXPECT_EQ(defaultWith(30, 2), "mr-t1");
  EXPECT_EQ(defaultWith(10, 4), "mr-angio");
  EXPECT_EQ(defaultWith(100, 3), "mr-t2");
}

TEST(TransferFunctionFile, UptakeIsStandardisedOrCountsByTheMeanOfTheTissue) {
  Volume volume = volumeOf<float>({0.0f, 0.0f, 0.0f, 0.0f, 3000.0f, 5000.0f});
  const auto path = written(R"({"name": "x", "domain": "uptake", "nodes": [
      {"value": 0.5, "colour": [1, 1, 1], "opacity": 0}, {"value": 2, "colour": [1, 1, 1], "opacity": 1}]})");
  const auto valueOf = [&] { return loadContextFunction(path.string(), volume).function.nodes[1].value; };
  EXPECT_EQ(valueOf(), 8000.0);
  volume.unit = "GML";
  EXPECT_EQ(valueOf(), 2.0);
}

TEST(TransferFunctionFile, AnOpacityMayBeThatOfAVoxel) {
  Volume volume = ct();
  volume.grid.spacing = {3.0, 0.5, 1.0};
  const auto path = written(R"({"name": "x", "domain": "value", "nodes": [
      {"value": 0, "colour": [1, 1, 1], "opacity": 0.5}, {"value": 1, "colour": [1, 1, 1], "opacity": 0.5, "per": "voxel"}]})");
  const auto nodes = loadContextFunction(path.string(), volume).function.nodes;
  EXPECT_DOUBLE_EQ(nodes[1].properties.extinction, 2.0 * nodes[0].properties.extinction);
  EXPECT_NE(causeOf(R"({"name": "x", "domain": "value", "nodes": [
      {"value": 0, "colour": [1, 1, 1], "opacity": 0.5, "per": "inch"}]})")
                .find("\"per\""),
            std::string::npos);
}

}  // namespace
}  // namespace fenestra::io::transferFunctionFileTest
