// Every DICOM series of the collection against GDCM, which shares no code with the project's reader: the same frames in
// the same volumes, at the same places, with the same values, or a row that says why not. Places are compared for files
// of one frame; of others, GDCM gives that of the first frame alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <set>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/DifferentialPlaces.h"
#include "tests/io/GdcmPeer.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::differentialTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

constexpr std::array differences = std::to_array<Difference>({
    {"pixel-formats/12bit", "GDCM reads a mosaic as one picture; its slices are compared in RealDicomTest.cpp"},
    {"enhanced/IM_0027_fMAP", "GDCM rescales all frames as the first; they are compared in RealDicomTest.cpp"},
    {"hard/number-texts-comma-position", "GDCM cuts numbers at a decimal comma"},
});

/// One frame as GDCM reads it.
struct PeerFrame {
  const GdcmImage* image = nullptr;
  int number = 0;
  bool used = false;
  const double* values() const {
    const glm::ivec3 dims = image->header.dims;
    return image->values.data() +
           static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(number);
  }
};

std::vector<double> sliceOf(const Volume& volume, int z) {
  std::vector<double> values;
  const std::size_t count = static_cast<std::size_t>(volume.grid.dims.x) * static_cast<std::size_t>(volume.grid.dims.y);
  volume.voxels.visit([&](auto scalars) {
    const auto* slice = scalars.data() + count * static_cast<std::size_t>(z);
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(volume.slope * static_cast<double>(slice[i]) + volume.intercept);
  });
  return values;
}

/// Whether values agree; those of slices whose rescales differ are stored in single precision.
bool agree(const std::vector<double>& ours, const double* peers, bool single) {
  for (std::size_t i = 0; i < ours.size(); ++i)
    if (ours[i] != (single ? static_cast<double>(static_cast<float>(peers[i])) : peers[i])) return false;
  return true;
}

bool hasPlaces(const io::OpenedVolume& opened) {
  return !opened.geometry && std::none_of(opened.warnings.begin(), opened.warnings.end(), [](const Warning& warning) {
    return warning.kind == Warning::Kind::NoGeometry;
  });
}

/// How a volume differs from the frames; empty where it does not. Marks the frames that it consists of.
std::string differenceOf(const io::OpenedVolume& opened, std::vector<PeerFrame>& frames) {
  const Grid& grid = opened.volume->grid;
  const bool single = opened.volume->voxels.type() == ScalarType::Float32;
  for (int z = 0; z < grid.dims.z; ++z) {
    const glm::dvec3 place(grid.worldFromIndex() * glm::dvec4(0, 0, z, 1));
    const std::vector<double> values = sliceOf(*opened.volume, z);
    PeerFrame* nearest = nullptr;
    for (PeerFrame& frame : frames) {
      const GdcmRecord& header = frame.image->header;
      if (frame.used || header.dims.x != grid.dims.x || header.dims.y != grid.dims.y) continue;
      if (nearest && glm::distance(nearest->image->header.origin, place) <= glm::distance(header.origin, place))
        continue;
      if (agree(values, frame.values(), single)) nearest = &frame;
    }
    if (!nearest) return "slice " + std::to_string(z) + " has values that GDCM reads in no frame";
    nearest->used = true;
    const GdcmRecord& header = nearest->image->header;
    const double off = glm::distance(header.origin, place);
    // Sixteen-character decimal strings; a hundredth of a millimetre is what reports pass over.
    if (header.dims.z == 1 && hasPlaces(opened) && off > 0.01)
      return "slice " + std::to_string(z) + " lies " + std::to_string(off) + " mm from where GDCM has it";
    if (header.dims.z == 1 && hasPlaces(opened) &&
        (std::abs(header.spacing.x - grid.spacing.x) > 1e-9 || std::abs(header.spacing.y - grid.spacing.y) > 1e-9))
      return "slice " + std::to_string(z) + " has another pixel spacing";
  }
  return {};
}

/// The files of all volumes, each once; segmentations are none of them.
std::vector<fs::path> filesOf(const std::vector<io::SeriesInfo>& series) {
  std::set<fs::path> files;
  for (const io::SeriesInfo& info : series) files.insert(info.files.begin(), info.files.end());
  return {files.begin(), files.end()};
}

struct Counts : DifferentialCounts {
  int unread = 0;
};

/// All volumes at one place.
void compareAt(const fs::path& place, Counts& counts) {
  const std::vector<io::SeriesInfo> series = imageSeriesAt(place);
  if (series.empty()) return;
  const std::vector<GdcmImage> images = readWithGdcm(filesOf(series), place.filename() == "rtdose.dcm");
  std::vector<PeerFrame> frames;
  for (const GdcmImage& image : images)
    for (int number = 0; number < image.header.dims.z; ++number) frames.push_back({&image, number});
  if (frames.empty()) {
    ++counts.unread;
    return;
  }
  compareSeries(
      place, series, differences, [&frames](const io::OpenedVolume& opened) { return differenceOf(opened, frames); },
      counts);
}

}  // namespace

TEST(Differential, Thorough_EveryDicomSeriesIsAsGdcmReadsItOrARowSaysWhyNot) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  Counts counts;
  for (const fs::path& place : dicomPlaces()) compareAt(place, counts);
  std::cout << "volumes: " << counts.text() << "; " << counts.unread << " files that GDCM does not read\n";
  EXPECT_GT(counts.agreeing, 40);
}

}  // namespace fenestra::tests::differentialTest
