// Which of several series opens first, and why.

#include <algorithm>

#include <gtest/gtest.h>

#include "io/base/SeriesChoice.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::seriesChoiceTest {
namespace fs = std::filesystem;
namespace {

/// An original axial CT of 100 slices of 512 × 512, each 1 mm behind the other, with changes.
io::SeriesInfo seriesWith(const std::string& id, const std::function<void(io::SeriesInfo&)>& change = {}) {
  io::SeriesInfo series;
  series.id = id;
  series.imageType = "ORIGINAL\\PRIMARY\\AXIAL";
  series.sopClass = "1.2.840.10008.5.1.4.1.1.2";
  series.dims = {512, 512, 100};
  series.step = 1.0;
  if (change) change(series);
  return series;
}
io::SeriesInfo typed(const std::string& imageType) {
  return seriesWith("1", [&](io::SeriesInfo& series) {
    series.imageType = imageType;
    series.step = 0.5;  // all that speaks for it
    series.dims = {512, 512, 800};
    series.number = 1;
  });
}
io::SeriesInfo sized(const glm::ivec3& dims, double step = 1.0) {
  return seriesWith("1", [&](io::SeriesInfo& series) {
    series.dims = dims;
    series.step = step;
  });
}

struct Row {
  const char* name;
  io::SeriesInfo first, second;  ///< `second` has the id that would win
  std::string reason;
};

std::vector<Row> rows() {
  const io::SeriesInfo usual = seriesWith("2");
  const std::string noOverview = "the only one that is no overview, capture or reformat";
  const auto capture = seriesWith("1", [](auto& series) { series.sopClass = "1.2.840.10008.5.1.4.1.1.7.2"; });
  const auto broken = seriesWith("1", [](auto& series) { series.plausible = false; });
  const auto numbered = seriesWith("2", [](auto& series) { series.number = 3; });
  const auto later = seriesWith("1", [](auto& series) { series.number = 12; });
  const auto untyped = seriesWith("2", [](auto& series) { series.imageType.clear(); });
  const auto thickUntyped = seriesWith("1", [](auto& series) {
    series.imageType.clear();
    series.step = 3.0;
  });
  const io::SeriesInfo few = seriesWith("2", [](auto& series) { series.dims.z = 3; });
  return {
      {"implausible geometry", usual, broken, "the only one whose geometry is plausible"},
      {"coronal reformat of more voxels", usual, typed("DERIVED\\SECONDARY\\REFORMATTED\\AVERAGE"), noOverview},
      {"derived picture", usual, typed("DERIVED\\SECONDARY"), noOverview},
      {"padded words", usual, typed("DERIVED \\SECONDARY "), noOverview},
      {"reformat called primary", usual, typed("DERIVED\\PRIMARY\\MPR"), noOverview},
      {"projection", usual, typed("DERIVED\\PRIMARY\\PROJECTION IMAGE\\MIP"), noOverview},
      {"maximum", usual, typed("ORIGINAL\\PRIMARY\\MIP"), noOverview},
      {"localiser", usual, typed("ORIGINAL\\PRIMARY\\LOCALIZER"), noOverview},
      {"screenshot", usual, typed("DERIVED\\PRIMARY\\SCREEN SAVE"), noOverview},
      {"dose report", usual, typed("ORIGINAL\\PRIMARY\\DOSE REPORT"), noOverview},
      {"secondary capture", usual, capture, noOverview},
      {"reformat over nothing acquired but an image", seriesWith("2", [](auto& series) { series.dims.z = 1; }),
       typed("DERIVED\\SECONDARY\\MPR"), noOverview},
      {"single image", usual, sized({4096, 4096, 1}), "the only acquired volume"},
      {"few thin slices", usual, sized({2048, 2048, io::leastSlices - 1}, 0.1), "the only acquired volume"},
      {"image of more voxels than a stack", few, sized({4096, 4096, 1}), "the only acquired stack of slices"},
      {"derived, though primary", usual, typed("DERIVED\\PRIMARY\\M"), "the only acquired volume"},
      {"no image type", usual, typed(""), "the only acquired volume"},
      {"thick slices of more voxels", usual, sized({1024, 1024, 100}, 2.5), "the thinnest acquired volume, 1.0 mm"},
      {"thick slices without a type", untyped, thickUntyped,
       "the thinnest volume that is no overview, capture or reformat, 1.0 mm"},
      {"reformats alone", seriesWith("2", [](auto& series) { series.imageType = "DERIVED\\SECONDARY\\MPR"; }),
       seriesWith("1",
                  [](auto& series) {
                    series.imageType = "DERIVED\\SECONDARY\\MPR";
                    series.step = 1.25;
                  }),
       "the thinnest volume, 1.0 mm"},
      {"fewer voxels, steps alike but for rounding", usual, sized({512, 512, 99}, 0.99999),
       "of the thinnest ones, 1.0 mm, the one of most voxels"},
      {"fewer voxels of few slices", few, sized({512, 512, 2}, 0.1), "the acquired stack of slices of most voxels"},
      {"later number", numbered, later, "of equal ones the first by its number, 3"},
      {"no number", numbered, seriesWith("1"), "of equal ones the first by its number, 3"},
      {"id, in natural order", seriesWith("1.2#2"), seriesWith("1.2#10"), ""},
  };
}

TEST(SeriesChoice, FollowsTheRule) {
  for (const Row& row : rows()) {
    const io::SeriesChoice forth = io::firstSeries({row.first, row.second}),
                           back = io::firstSeries({row.second, row.first});
    EXPECT_EQ(forth.index, 0u) << row.name;
    EXPECT_EQ(back.index, 1u) << row.name;
    EXPECT_EQ(plainText(forth.reason), row.reason) << row.name;
    EXPECT_EQ(plainText(back.reason), row.reason) << row.name;
  }
}

TEST(SeriesChoice, ChoosesTheSameInAnyOrder) {
  std::vector<io::SeriesInfo> all;
  const std::vector<Row> table = rows();
  for (std::size_t i = 0; i < table.size(); ++i)
    for (io::SeriesInfo series : {table[i].first, table[i].second}) {
      series.id += "." + std::to_string(i);
      all.push_back(series);
    }
  const std::string id = all[io::firstSeries(all).index].id;
  for (std::size_t turn = 0; turn < all.size(); ++turn) {
    std::rotate(all.begin(), all.begin() + 1, all.end());
    EXPECT_EQ(all[io::firstSeries(all).index].id, id);
  }
}

TEST(SeriesChoice, SaysNothingOfASingleSeries) {
  const io::SeriesChoice only = io::firstSeries({seriesWith("1")});
  EXPECT_EQ(only.index, 0u);
  EXPECT_EQ(plainText(only.reason), "");
}

/// `count` slices, `step` mm apart.
void writeSlices(const fs::path& folder, DicomSpec spec, int count, double step) {
  fs::create_directories(folder);
  for (int slice = 0; slice < count; ++slice) {
    spec.instance = spec.series + "." + std::to_string(slice + 1);
    spec.position = glm::dvec3(0, 0, slice * step);
    writeDicom(folder / std::to_string(slice), spec);
  }
}

TEST(SeriesChoice, OpensTheThinAcquiredSeriesOfAFolder) {
  const fs::path folder = scratchFolder();
  DicomSpec thin;
  thin.series = "1.2.2";
  thin.seriesNumber = "4 ";
  thin.imageType = "ORIGINAL\\PRIMARY\\AXIAL";
  thin.thickness = "1.5";
  thin.kernel = "B30f";
  thin.patientName = "Vermeer^Johanna";
  thin.patientId = "QX-4711";
  writeSlices(folder / "thin", thin, 20, 1.0);
  DicomSpec thick = thin;
  thick.series = "1.2.1";
  writeSlices(folder / "thick", thick, 30, 5.0);
  DicomSpec reformat = thin;
  reformat.series = "1.2.0";
  reformat.imageType = "DERIVED\\SECONDARY\\REFORMATTED";
  writeSlices(folder / "reformat", reformat, 60, 0.5);

  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.series.id, "1.2.2");
  EXPECT_EQ(opened.series.number, 4);
  EXPECT_EQ(opened.series.thickness, 1.5);
  EXPECT_EQ(opened.series.kernel, "B30f");
  EXPECT_NEAR(opened.series.step, 1.0, 1e-9);
  EXPECT_EQ(opened.series.patient.name, "Vermeer^Johanna");
  EXPECT_EQ(opened.series.patient.id, "QX-4711");
  EXPECT_EQ(plainText(opened.reason), "the thinnest acquired volume, 1.0 mm");
  EXPECT_EQ(opened.otherSeries.size(), 2u);
  EXPECT_EQ(io::openVolume(folder, {.series = "1.2.1"}).reason, io::Phrase()) << "another one was named";
  EXPECT_EQ(io::openVolume(folder, {.series = "1.2.2"}).reason, opened.reason) << "true of it, whoever named it";
}

}  // namespace
}  // namespace fenestra::tests::seriesChoiceTest
