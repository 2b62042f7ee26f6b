// Small pictures of series, made in the background.

#include <algorithm>

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "io/Thumbnail.h"
#include "io/VolumeReader.h"
#include "tests/gui/Patience.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"
#include "viewer/jobs/Thumbnails.h"

namespace fenestra::viewer::thumbnailsTest {
namespace {

namespace fs = std::filesystem;
using tests::DicomSpec;

/// Axial slices of 8×4 pixels, 1 mm wide and 2 mm high. Slice k is black left of column k, and white from it on.
io::SeriesInfo writeSeries(const fs::path& folder) {
  fs::create_directories(folder);
  for (int slice = 0; slice < 5; ++slice) {
    DicomSpec spec;
    spec.instance = "1.2.3." + std::to_string(slice);
    spec.columns = 8;
    spec.rows = 4;
    spec.pixelSpacing = "2\\1";
    spec.window = "50 100";
    spec.position = glm::dvec3(0, 0, slice);
    for (int i = 0; i < 32; ++i) spec.words.push_back(i % 8 < slice ? 0 : 100);
    tests::writeDicom(folder / std::to_string(slice), spec);
  }
  return io::listSeries(folder).front();
}

TEST(Thumbnail, ShowsTheMiddleSliceWithSquarePixels) {
  const io::SeriesInfo series = writeSeries(tests::scratchFolder() / "series");
  const io::Thumbnail small = io::makeThumbnail(series, 8);
  ASSERT_EQ(small.size, glm::ivec2(8, 8));
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      EXPECT_EQ(small.grey[static_cast<std::size_t>(8 * y + x)], x < 2 ? 0 : 255) << x << ' ' << y;
  // Pixels are means: columns 0 to 3 of a 2-pixel picture hold two black ones and two white ones.
  const io::Thumbnail tiny = io::makeThumbnail(series, 2);
  ASSERT_EQ(tiny.size, glm::ivec2(2, 2));
  EXPECT_NEAR(tiny.grey[0], 127, 1);
  EXPECT_EQ(tiny.grey[1], 255);
}

TEST(Thumbnails, ComeOneByOneAndLeaveOutWhatCannotBeRead) {
  const fs::path folder = tests::scratchFolder();
  const io::SeriesInfo good = writeSeries(folder / "series");
  io::SeriesInfo damaged = good;
  damaged.files = {folder / "missing.dcm"};
  Thumbnails thumbnails({good, damaged, good}, 16);
  QSignalSpy made(&thumbnails, &Thumbnails::made);
  while (made.count() < 2 && made.wait(patience)) {
  }
  ASSERT_EQ(made.count(), 2);
  EXPECT_EQ(made[0][0].toInt(), 0);
  EXPECT_EQ(made[1][0].toInt(), 2);
  EXPECT_EQ(made[1][1].value<QImage>().size(), QSize(16, 16));
  EXPECT_FALSE(made.wait(50));
}

TEST(Thumbnails, StopWhenNobodyNeedsThem) {
  const io::SeriesInfo series = writeSeries(tests::scratchFolder() / "series");
  const std::vector<io::SeriesInfo> many(2000, series);
  Thumbnails(many, 64);  // destroyed at once: a wait for all of them would take minutes
}

}  // namespace
}  // namespace fenestra::viewer::thumbnailsTest
