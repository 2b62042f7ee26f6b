// How transfer functions are edited, the histogram under them, and the folder of the user's presets.

#include <gtest/gtest.h>

#include <limits>

#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"
#include "viewer/model/FunctionEdit.h"
#include "viewer/model/LookLibrary.h"
#include "viewer/model/ValueHistogram.h"

namespace fenestra::viewer::functionEditTest {
namespace {

namespace fs = std::filesystem;

TransferFunction::Node node(double value, double opacity) {
  return {value, {{0.1, 0.2, 0.3}, extinctionFromOpacity(opacity)}};
}

TransferFunction twoTrapezoids() {
  return {{node(0, 0), node(10, 0.5), node(20, 0.5), node(30, 0), node(40, 0.1), node(50, 0.6), node(60, 0.6),
           node(70, 0.1)}};
}

TEST(FunctionEdit, FindsTrapezoidsByTheirPlateau) {
  EXPECT_EQ(trapezoidsOf(twoTrapezoids()), (std::vector<std::size_t>{0, 4}));
  EXPECT_TRUE(trapezoidsOf({{node(0, 0), node(1, 0.5), node(2, 0.4), node(3, 0)}}).empty()) << "no plateau";
  EXPECT_TRUE(trapezoidsOf({{node(0, 0.5), node(1, 0.5), node(2, 0.5), node(3, 0)}}).empty()) << "not lower beside";
  EXPECT_TRUE(trapezoidsOf({}).empty());
}

TEST(FunctionEdit, WhatMovesStaysInOrderWhateverTheDistance) {
  using enum Grip::Part;
  for (const Grip grip : {Grip{Node, 0}, Grip{Node, 1}, Grip{Node, 3}, Grip{Node, 7}, Grip{Plateau, 4},
                          Grip{LeftEdge, 4}, Grip{RightEdge, 0}, Grip{Whole, 0}, Grip{Whole, 4}})
    for (const double by : {-1e300, -35.0, -1.0 / 3.0, 0.0, 1e-9, 7.7, 1e300})
      for (const double opacity : {-2.0, 0.0, 0.3, 2.0}) {
        const TransferFunction after = moved(twoTrapezoids(), grip, by, opacity);
        ASSERT_EQ(after.nodes.size(), 8u);
        for (std::size_t i = 0; i + 1 < 8; ++i) EXPECT_LE(after.nodes[i].value, after.nodes[i + 1].value);
        for (const auto& each : after.nodes) {
          EXPECT_GE(each.properties.extinction, 0.0);
          EXPECT_TRUE(std::isfinite(each.properties.extinction));
        }
      }
}

TEST(FunctionEdit, MovesExactlyWhatTheGripSays) {
  const TransferFunction before = twoTrapezoids();
  const TransferFunction edge = moved(before, {Grip::Part::LeftEdge, 4}, -3.0, 0.4);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(edge.nodes[i].value, before.nodes[i].value - (i == 4 || i == 5 ? 3.0 : 0.0));
    EXPECT_EQ(edge.nodes[i].properties, before.nodes[i].properties) << "to the bit";
  }
  const TransferFunction whole = moved(before, {Grip::Part::Whole, 0}, 50.0, 0.0);
  EXPECT_EQ(whole.nodes[3].value, 40.0) << "up to its neighbour";
  EXPECT_EQ(whole.nodes[0].value, 10.0) << "as wide as before";
  const TransferFunction high = moved(before, {Grip::Part::Plateau, 0}, 5.0, 0.25);
  EXPECT_NEAR(opacityFromExtinction(high.nodes[1].properties.extinction), 0.75, 1e-12);
  EXPECT_EQ(high.nodes[1].properties.extinction, high.nodes[2].properties.extinction);
  EXPECT_EQ(high.nodes[1].value, 10.0);
}

TEST(FunctionEdit, AnAddedNodeLiesOnTheCurveInItsColour) {
  const TransferFunction before{{{0.0, {{1, 0, 0}, 0.0}}, {10.0, {{0, 0, 1}, 1.0}}}};
  const WithNode with = withNode(before, 2.5, 0.4);
  EXPECT_EQ(with.node, 1u);
  EXPECT_EQ(with.function.nodes[1].properties.colour, glm::dvec3(0.75, 0, 0.25));
  EXPECT_EQ(withoutNode(with.function, 1), before);
  EXPECT_EQ(withNode({}, 1.0, 0.5).function.nodes.size(), 1u);
}

TEST(FunctionEdit, ATrapezoidStandsOutWhereverItIsAdded) {
  for (const double low : {-100.0, 0.0, 12.0, 25.0, 45.0, 65.0, 200.0}) {
    const WithNode with = withTrapezoid(twoTrapezoids(), {low, low + 15.0}, 0.5);
    const std::vector<std::size_t> found = trapezoidsOf(with.function);
    EXPECT_NE(std::find(found.begin(), found.end(), with.node), found.end()) << low;
    for (std::size_t i = 0; i + 1 < with.function.nodes.size(); ++i)
      EXPECT_LE(with.function.nodes[i].value, with.function.nodes[i + 1].value);
    // Between other nodes the same line rounds differently.
    EXPECT_NEAR(with.function.evaluate(low - 1.0).extinction, twoTrapezoids().evaluate(low - 1.0).extinction, 1e-12)
        << "nothing beside it changes";
  }
}

TEST(ValueHistogramTest, CountsWholeNumbersInTheMiddleOfTheirBins) {
  Volume volume;
  volume.grid.dims = {4, 4, 4};
  volume.voxels = Voxels(ScalarType::Int16, 64);
  const auto voxels = volume.voxels.as<std::int16_t>();
  for (std::size_t i = 0; i < 64; ++i) voxels[i] = static_cast<std::int16_t>(i < 16 ? -1000 : i < 48 ? 40 : 1000);
  volume.computeRange();
  const ValueHistogram histogram = histogramOf(volume);
  EXPECT_EQ(histogram.density({40.0, 40.0}), 32.0);
  EXPECT_EQ(histogram.density({-1000.0, -1000.0}), 16.0);
  EXPECT_EQ(histogram.density({1000.0, 1000.0}), 16.0);
  EXPECT_EQ(histogram.density({500.0, 600.0}), 0.0);
  EXPECT_EQ(histogram.density({2000.0, 3000.0}), 0.0);
}

TEST(ValueHistogramTest, CountsTheVoxelsOfALabelInTheVolumesBins) {
  Volume volume;
  volume.grid.dims = {4, 4, 4};
  volume.voxels = Voxels(ScalarType::Int16, 64);
  LabelMap labels;
  labels.grid = volume.grid;
  labels.voxels = Voxels(ScalarType::UInt8, 64);
  const auto voxels = volume.voxels.as<std::int16_t>();
  const auto marks = labels.voxels.as<std::uint8_t>();
  for (std::size_t i = 0; i < 64; ++i) {
    voxels[i] = static_cast<std::int16_t>(i < 16 ? -1000 : i < 48 ? 40 : 1000);
    marks[i] = i < 8 ? 1 : i < 40 ? 2 : 0;
  }
  volume.computeRange();
  const ValueHistogram all = histogramOf(volume), one = histogramOf(volume, labels, 1),
                       two = histogramOf(volume, labels, 2), none = histogramOf(volume, labels, 3);
  EXPECT_EQ(two.values.low, all.values.low);
  EXPECT_EQ(two.counts.size(), all.counts.size());
  EXPECT_EQ(one.density({-1000.0, -1000.0}), 8.0);
  EXPECT_EQ(one.density({40.0, 40.0}), 0.0);
  EXPECT_EQ(two.density({-1000.0, -1000.0}), 8.0);
  EXPECT_EQ(two.density({40.0, 40.0}), 24.0);
  // A quarter of label 2 lies at -1000, the rest at 40, each in the middle of a bin that is one wide.
  const ValueRange middle = middleOf(two, 0.3);
  EXPECT_NEAR(middle.low, 40.0, 0.5);
  EXPECT_NEAR(middle.high, 40.0, 0.5);
  EXPECT_NEAR(middleOf(two, 0.1).low, -1000.0, 0.5);
  EXPECT_EQ(middleOf(none, 0.1), all.values);
}

TEST(ValueHistogramTest, TakesAnyNumbers) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), big = std::numeric_limits<double>::max();
  for (const std::vector<double>& values : std::vector<std::vector<double>>{{5.0, 5.0},
                                                                            {-big, big},
                                                                            {std::nan(""), 1.0},
                                                                            {-infinity, 0.25},
                                                                            {std::nan(""), std::nan("")},
                                                                            {0.0, 1e-300}}) {
    Volume volume;
    volume.grid.dims = {2, 1, 1};
    volume.voxels = Voxels(ScalarType::Float64, 2);
    std::copy(values.begin(), values.end(), volume.voxels.as<double>().begin());
    volume.computeRange();
    const ValueHistogram histogram = histogramOf(volume);
    EXPECT_LE(histogram.counts.size(), 8193u);
    EXPECT_GE(histogram.counts.size(), 1u);
  }
}

TEST(LookLibraryTest, ListsWhatItKeepsAndNamesWhatItCannotRead) {
  const fs::path folder = tests::scratchFolder() / "looks";
  LookLibrary library(folder);
  EXPECT_TRUE(library.entries().empty());
  EXPECT_FALSE(fs::exists(folder)) << "made when it is needed";
  const std::vector<std::string> names{"9", "10", "../up", std::string(300, 'x'), "con", ".hidden", "Ä/%"};
  for (const std::string& name : names) library.keep({name, "HU", {}, {}});
  EXPECT_EQ(library.entries().size(), names.size());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.parent_path()), {}), 1) << "nothing beside the folder";
  for (const std::string& name : names) EXPECT_TRUE(library.find(QString::fromStdString(name))) << name;
  tests::writeFile(folder / "bad.json", "{}");
  LookLibrary again(folder);
  EXPECT_EQ(again.entries().size(), names.size());
  ASSERT_EQ(again.problems().size(), 1u);
  EXPECT_NE(again.problems()[0].find("bad.json"), std::string::npos);
}

TEST(LookLibraryTest, WithoutAFolderNothingIsKept) {
  LookLibrary library({});
  EXPECT_FALSE(library.canKeep());
  EXPECT_THROW(library.keep({"a", "", {}, {}}), io::Error);
}

}  // namespace
}  // namespace fenestra::viewer::functionEditTest
