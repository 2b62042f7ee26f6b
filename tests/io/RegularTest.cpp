// Series of known truth whose slices are missing, uneven, tilted or shifted: where everything lies after resampling.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "io/base/Words.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::regularTest {
namespace fs = std::filesystem;
using io::Regularise;
using io::Warning;

namespace {

/// Heights of slices in mm along the table.
using Heights = std::vector<double>;

/// Steps in which a field stores its values: fine enough for a hundredth of a millimetre, over 130 mm in 16 bits.
constexpr double unit = 0.002;

/// A series of 24 × `rows` pixels whose gantry is tilted by so many degrees around x.
struct Series {
  Heights heights;
  double tilt = 0.0;
  std::vector<glm::dvec2> shifts = {};  ///< of single slices, mm along x and y; may be empty
  int rows = 20;

  DicomSpec spec() const {
    DicomSpec result;
    result.columns = 24;
    result.rows = rows;
    result.pixelSpacing = "0.9\\0.7";
    const double angle = tilt * std::numbers::pi / 180.0;
    result.column = {0.0, std::cos(angle), std::sin(angle)};
    result.slope = "0.002";
    return result;
  }
  glm::dvec3 position(std::size_t slice) const {
    const glm::dvec2 shift = shifts.empty() ? glm::dvec2(0.0) : shifts[slice];
    return {-8.0 + shift.x, 5.0 + shift.y, -20.0 + heights[slice]};
  }
};

/// Writes `field` of a point in the patient, from -65 to 65.
void write(const fs::path& folder, const Series& series, const std::function<double(glm::dvec3)>& field) {
  fs::create_directories(folder);
  DicomSpec spec = series.spec();
  for (std::size_t i = 0; i < series.heights.size(); ++i) {
    spec.instance = "1.2.3." + std::to_string(i + 1);
    spec.position = series.position(i);
    spec.words.clear();
    for (int y = 0; y < spec.rows; ++y)
      for (int x = 0; x < spec.columns; ++x) {
        const glm::dvec3 at = *spec.position + spec.row * (0.7 * x) + spec.column * (0.9 * y);
        spec.words.push_back(static_cast<std::uint16_t>(std::lround(field(at) / unit)));
      }
    writeDicom(folder / ("slice" + std::to_string(i)), spec);
  }
}

io::OpenedVolume open(const fs::path& folder, Regularise regularise) {
  return io::openVolume(folder, {.regularise = regularise});
}

glm::dvec3 worldAt(const Grid& grid, int x, int y, int z) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(x, y, z, 1.0));
}

/// Whether both slices beside a point have pixels where the line through it along `direction` meets them.
bool isScanned(const Series& series, glm::dvec3 at, glm::dvec3 direction) {
  const DicomSpec spec = series.spec();
  const glm::dvec3 normal = glm::cross(spec.row, spec.column);
  const auto heightAbove = [&](std::size_t slice) { return glm::dot(at - series.position(slice), normal); };
  constexpr double hair = 1e-3;  // mm
  for (std::size_t i = 0; i < series.heights.size(); ++i) {
    const bool on = std::abs(heightAbove(i)) <= hair;
    const bool below = heightAbove(i) > hair && i + 1 < series.heights.size() && heightAbove(i + 1) < -hair;
    const bool above = heightAbove(i) < -hair && i > 0 && heightAbove(i - 1) > hair;
    if (!on && !below && !above) continue;
    const glm::dvec3 hit = at - direction * (heightAbove(i) / glm::dot(direction, normal)) - series.position(i);
    const double x = glm::dot(hit, spec.row), y = glm::dot(hit, spec.column);
    if (x < -hair || x > 0.7 * 23 + hair || y < -hair || y > 0.9 * (series.rows - 1) + hair) return false;
  }
  return true;
}

/// The farthest that a voxel's value, a coordinate of the place where it was scanned, lies from where the voxel is.
/// Voxels outside of what was scanned must hold the least value, and are counted.
struct Displacement {
  double farthest = 0.0;
  std::size_t empty = 0, wrong = 0;
};
Displacement displacementIn(const Volume& volume, const Series& series,
                            const std::function<double(glm::dvec3)>& field) {
  Displacement found;
  for (int z = 0; z < volume.grid.dims.z; ++z)
    for (int y = 0; y < volume.grid.dims.y; ++y)
      for (int x = 0; x < volume.grid.dims.x; ++x) {
        const glm::dvec3 at = worldAt(volume.grid, x, y, z);
        const double value = volume.value({x, y, z});
        if (isScanned(series, at, volume.grid.direction[2])) {
          found.farthest = std::max(found.farthest, std::abs(value - field(at)));
        } else {
          ++found.empty;
          found.wrong += value != volume.range.low;
        }
      }
  return found;
}

const std::pair<const char*, Heights> spacings[] = {
    {"one missing", {0, 2, 4, 6, 10, 12, 14, 16}},
    {"three missing", {0, 2, 6, 8, 12, 14, 16, 18, 22, 24}},
    {"1, 4 and 7 mm", {0, 4, 8, 12, 13, 17, 24, 31, 38, 45}},
    {"uneven", {0, 1.1, 2.0, 3.4, 4.1, 5.55, 6.4, 7.9}},
    {"even", {0, 2.5, 5, 7.5, 10}},
};

}  // namespace

TEST(Regular, NothingIsDisplacedAndARampStaysARamp) {
  const std::pair<const char*, std::function<double(glm::dvec3)>> fields[] = {
      {"x", [](glm::dvec3 p) { return p.x; }},
      {"y", [](glm::dvec3 p) { return p.y; }},
      {"z", [](glm::dvec3 p) { return p.z; }},
      {"ramp", [](glm::dvec3 p) { return 0.8 * p.x - 0.9 * p.y + 0.7 * p.z; }}};
  for (const double tilt : {-20.0, 0.0, 20.0})
    for (const auto& [name, heights] : spacings)
      for (const auto& [axis, field] : fields) {
        const Series series{heights, tilt};
        const fs::path folder = scratchFolder();
        write(folder, series, field);
        for (const Regularise choice : {Regularise::Automatic, Regularise::Linear, Regularise::Cubic}) {
          SCOPED_TRACE(std::string(name) + ", tilt " + std::to_string(tilt) + ", " + axis + ", " + wordOf(choice).word);
          const io::OpenedVolume opened = open(folder, choice);
          const Displacement found = displacementIn(*opened.volume, series, field);
          // A stored step, rounded twice, is 0.002 mm; 1e-4 of the ramps' least range of 16 mm is as much.
          EXPECT_LE(found.farthest, unit * 1.001);
          EXPECT_EQ(found.wrong, 0u);
          EXPECT_EQ(found.empty, opened.geometry ? opened.geometry->emptyVoxels : 0u);
          EXPECT_LE(opened.geometry.value_or(io::GeometryReport()).displacement, 0.01);
        }
      }
}

TEST(Regular, SpreadEvenlyTheSameSlicesAreDisplacedAsReported) {
  const Series series{spacings[2].second, 20.0};
  const auto height = [](glm::dvec3 p) { return p.z; };
  const fs::path folder = scratchFolder();
  write(folder, series, height);
  const io::OpenedVolume opened = open(folder, Regularise::Off);
  EXPECT_EQ(opened.volume->grid.dims.z, 10);
  const double farthest = displacementIn(*opened.volume, series, height).farthest;
  ASSERT_TRUE(opened.geometry);
  EXPECT_NEAR(farthest, opened.geometry->displacement, unit);
  EXPECT_GT(farthest, 5.0);
  EXPECT_EQ(open(folder, Regularise::Automatic).geometry->displacementAsIs, opened.geometry->displacement);
}

TEST(Regular, ARodAlongTheTableStaysStraight) {
  // Its axis, mm. The pictures are so high that all four slices that a cubic value comes from reach around it.
  const glm::dvec2 rod(0.3, 22.0);
  // Cubic interpolation dips below its samples beside the rod. A lower column far from it keeps the dips within the
  // slices' range, to which values are clamped.
  const auto density = [&](glm::dvec3 p) {
    if (p.x < -7.0) return -60.0;
    return 60.0 * std::exp(-0.5 * glm::dot(glm::dvec2(p) - rod, glm::dvec2(p) - rod) / (1.2 * 1.2));
  };
  for (const double tilt : {-20.0, 20.0}) {
    const Series series{.heights = spacings[2].second, .tilt = tilt, .rows = 40};
    const fs::path folder = scratchFolder();
    write(folder, series, density);
    for (const Regularise choice : {Regularise::Automatic, Regularise::Linear, Regularise::Cubic}) {
      SCOPED_TRACE(std::to_string(tilt) + wordOf(choice).word);
      const io::OpenedVolume opened = open(folder, choice);
      const Volume& volume = *opened.volume;
      for (int z = 0; z < volume.grid.dims.z; ++z) {
        glm::dvec3 sum(0.0);
        double weight = 0.0;
        for (int y = 0; y < volume.grid.dims.y; ++y)
          for (int x = 0; x < volume.grid.dims.x; ++x) {
            // Five standard deviations across the table, and along y as much beside the rod in the slices that the
            // plane comes from, up to 5 mm away. What was not scanned is farther away.
            const glm::dvec2 from = glm::abs(glm::dvec2(worldAt(volume.grid, x, y, z)) - rod);
            if (from.x > 6.0 || from.y > 11.0) continue;
            sum += volume.value({x, y, z}) * worldAt(volume.grid, x, y, z);
            weight += volume.value({x, y, z});
          }
        ASSERT_GT(weight, 100.0);
        const glm::dvec3 centre = sum / weight;
        // The centroid of the rod's cross section in a plane lies on the rod's axis.
        EXPECT_LE(glm::distance(glm::dvec2(centre), rod), 0.01) << "plane " << z;
      }
    }
  }
}

TEST(Regular, AcquiredSlicesStayAsTheyAreWhereSomeAreMissing) {
  for (const double tilt : {0.0, 20.0}) {
    const Series series{{0, 2, 4, 8, 10}, tilt};
    const auto field = [](glm::dvec3 p) {
      return 10.0 * std::sin(p.x) + 20.0 * std::cos(p.y) + 3.0 * std::sin(2.0 * p.z);
    };
    const fs::path folder = scratchFolder();
    write(folder, series, field);
    const auto stored = open(folder, Regularise::Off).volume;
    const io::OpenedVolume opened = open(folder, Regularise::Automatic);
    ASSERT_EQ(opened.volume->grid.dims, glm::ivec3(24, 20, 6));
    EXPECT_EQ(opened.geometry->interpolatedPlanes, std::vector<int>{3});
    EXPECT_EQ(opened.geometry->emptyVoxels, 0u);
    const int sliceOf[] = {0, 1, 2, -1, 3, 4};
    for (int z = 0; z < 6; ++z)
      for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 24; ++x)
          if (sliceOf[z] >= 0)
            ASSERT_EQ(opened.volume->value({x, y, z}), stored->value({x, y, sliceOf[z]}));
          else  // rounded to a stored step
            ASSERT_NEAR(opened.volume->value({x, y, z}), 0.5 * (stored->value({x, y, 2}) + stored->value({x, y, 3})),
                        0.5001 * unit);
  }
}

TEST(Regular, CubicInterpolationReproducesAParabolaBetweenInnerSlices) {
  const Series series{spacings[3].second, 0.0};
  const auto parabola = [](glm::dvec3 p) { return 0.5 * (p.z + 16.0) * (p.z + 16.0) - 3.0 * p.z - 60.0; };
  const fs::path folder = scratchFolder();
  write(folder, series, parabola);
  const auto errorOf = [&](Regularise choice) {
    const auto volume = open(folder, choice).volume;
    double worst = 0.0;
    for (int z = 0; z < volume->grid.dims.z; ++z) {
      const glm::dvec3 at = worldAt(volume->grid, 5, 5, z);
      const double height = at.z + 20.0;
      if (height < 1.1 || height > 6.4) continue;
      worst = std::max(worst, std::abs(volume->value({5, 5, z}) - parabola(at)));
    }
    return worst;
  };
  EXPECT_LE(errorOf(Regularise::Cubic), 2.0 * unit);  // rounded in the file and after
  EXPECT_GT(errorOf(Regularise::Linear), 20.0 * unit);
}

TEST(Regular, SlicesShiftedSidewaysAreMovedBackByPartsOfAPixel) {
  Series series{{0, 2, 4, 6, 8}, 0.0};
  series.shifts = {{0, 0}, {1.0, 0}, {0, -0.5}, {0.35, 2.2}, {0, 0}};
  for (const auto& field : {std::function<double(glm::dvec3)>([](glm::dvec3 p) { return p.x; }),
                            std::function<double(glm::dvec3)>([](glm::dvec3 p) { return p.y; })}) {
    const fs::path folder = scratchFolder();
    write(folder, series, field);
    const io::OpenedVolume opened = open(folder, Regularise::Automatic);
    const Displacement found = displacementIn(*opened.volume, series, field);
    EXPECT_LE(found.farthest, unit * 1.001);
    EXPECT_EQ(found.wrong, 0u);
    EXPECT_EQ(found.empty, opened.geometry->emptyVoxels);
    EXPECT_GT(found.empty, 0u);
    const Warning shifted = opened.geometry->findings.front();
    EXPECT_NE(shifted.text.find("3 slices shifted sideways by up to 2.228 mm"), std::string::npos) << shifted.text;
    EXPECT_EQ(shifted.files.size(), 3u);
  }
}

TEST(Regular, TheReportNamesWhatWasFoundAndDone) {
  const Series series{spacings[2].second, 20.0};
  const fs::path folder = scratchFolder();
  write(folder, series, [](glm::dvec3 p) { return p.z; });
  const io::OpenedVolume opened = open(folder, Regularise::Automatic);
  ASSERT_TRUE(opened.geometry);
  const io::GeometryReport& report = *opened.geometry;
  ASSERT_EQ(report.findings.size(), 3u);
  EXPECT_EQ(report.findings[0].kind, Warning::Kind::GantryTilt);
  EXPECT_EQ(report.findings[1].kind, Warning::Kind::UnevenSpacing);
  EXPECT_EQ(report.findings[1].files.size(), 7u) << "both sides of the gaps of 1 and 7 mm";
  EXPECT_EQ(report.findings[2].kind, Warning::Kind::SlicePlacement);
  EXPECT_EQ(report.applied, Regularise::Linear);
  EXPECT_TRUE(report.sheared);
  EXPECT_EQ(report.slices, 10);
  const double across = std::cos(20.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(report.scannedStep, 4.0 * across, 1e-9);
  EXPECT_EQ(report.planes, 12);  // 45 mm / 4 mm
  EXPECT_NEAR(report.step, 45.0 / 11.0 * across, 1e-9);
  std::vector<int> within;  // gaps of 7 mm
  for (int plane = 0; plane < 12; ++plane) {
    const double height = 45.0 / 11.0 * plane;
    if (height > 17.0 + 1e-3 && height < 45.0 - 1e-3 && std::abs(height - 24.0) > 1e-3 &&
        std::abs(height - 31.0) > 1e-3 && std::abs(height - 38.0) > 1e-3)
      within.push_back(plane);
  }
  EXPECT_EQ(report.interpolatedPlanes, within);
  for (const Warning& finding : report.findings)
    EXPECT_NE(std::find(opened.warnings.begin(), opened.warnings.end(), finding), opened.warnings.end());
  const io::GeometryReport straight = *open(folder, Regularise::Linear).geometry;
  EXPECT_FALSE(straight.sheared);
  EXPECT_GT(straight.emptyVoxels, 0u);
}

TEST(Regular, AStraightEvenSeriesHasNoReport) {
  const fs::path folder = scratchFolder();
  write(folder, {{0, 2, 4.004, 6, 8}, 0.0}, [](glm::dvec3 p) { return p.z; });
  for (const auto& word : io::wordsOf(Regularise{})) {
    const io::OpenedVolume opened = open(folder, word.value);
    EXPECT_FALSE(opened.geometry);
    EXPECT_TRUE(opened.warnings.empty());
    EXPECT_EQ(opened.volume->grid.dims, glm::ivec3(24, 20, 5));
  }
}

TEST(Regular, AFewDenseSlicesDoNotMultiplyTheVolume) {
  Heights heights;
  for (int i = 0; i < 6; ++i) heights.push_back(0.05 * i);
  for (int i = 1; i < 20; ++i) heights.push_back(0.25 + 0.45 * i);
  const fs::path folder = scratchFolder();
  write(folder, {heights, 0.0}, [](glm::dvec3 p) { return p.z; });
  EXPECT_LE(open(folder, Regularise::Automatic).volume->grid.dims.z, 4 * static_cast<int>(heights.size()) + 1);
}

TEST(Regular, AStackThatNoBoxHoldsIsRefusedOnlyWhenAsked) {
  const fs::path folder = scratchFolder();
  write(folder, {{0, 200, 400, 700, 900}, 89.0}, [](glm::dvec3) { return 1.0; });
  EXPECT_NE(errorOf([&] { open(folder, Regularise::Linear); }).find("--regularise off"), std::string::npos);
  EXPECT_EQ(open(folder, Regularise::Automatic).volume->grid.dims.x, 24);
}

}  // namespace fenestra::tests::regularTest
