// Every DICOM series of the collection against GDCM, which shares no code with the project's reader: the same frames in
// the same volumes, at the same places, with the same values, or a row that says why not. Places are compared for files
// of one frame; of others, GDCM gives that of the first frame alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/GdcmPeer.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;
using io::Warning;

namespace {

/// A part of a path, and why what lies there differs from GDCM's reading.
struct Difference {
  const char* path;
  const char* why;
};
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

bool hasFolders(const fs::path& folder) {
  const fs::directory_iterator entries(folder);
  return std::any_of(begin(entries), end(entries), [](const auto& entry) { return entry.is_directory(); });
}

/// Folders of files alone, and single files where a folder holds unrelated ones.
std::vector<fs::path> placesBelow(const fs::path& top) {
  static const std::set<std::string> unrelated{"enhanced", "pixel-formats", "single-ct", "monochrome1", "12bit"};
  std::set<fs::path> places;
  for (const auto& entry : fs::recursive_directory_iterator(top)) {
    if (!entry.is_regular_file()) continue;
    const fs::path folder = entry.path().parent_path();
    const bool single = unrelated.contains(folder.filename().string());
    if (single || !hasFolders(folder)) places.insert(single ? entry.path() : folder);
  }
  return {places.begin(), places.end()};
}

/// The files of all volumes, each once; segmentations are none of them.
std::vector<fs::path> filesOf(const std::vector<io::SeriesInfo>& series) {
  std::set<fs::path> files;
  for (const io::SeriesInfo& info : series) files.insert(info.files.begin(), info.files.end());
  return {files.begin(), files.end()};
}

struct Counts {
  int compared = 0, agreeing = 0, explained = 0, unread = 0;
};

/// All volumes at one place.
void compareAt(const fs::path& place, Counts& counts) {
  std::vector<io::SeriesInfo> series;
  try {
    series = io::listSeries(place);
    if (series.front().modality.empty()) return;  // no DICOM
  } catch (const io::Error&) {
    return;  // no image: letters, references, segmentations
  }
  const std::vector<GdcmImage> images = readWithGdcm(filesOf(series), place.filename() == "rtdose.dcm");
  std::vector<PeerFrame> frames;
  for (const GdcmImage& image : images)
    for (int number = 0; number < image.header.dims.z; ++number) frames.push_back({&image, number});
  if (frames.empty()) {
    ++counts.unread;
    return;
  }
  for (const io::SeriesInfo& info : series) {
    const std::string found =
        differenceOf(io::openVolume(place, {.series = info.id, .regularise = io::Regularise::Off}), frames);
    ++counts.compared;
    if (found.empty()) {
      ++counts.agreeing;
      continue;
    }
    const auto why = std::find_if(differences.begin(), differences.end(), [&](const Difference& difference) {
      return place.generic_string().find(difference.path) != std::string::npos;
    });
    if (why == differences.end()) {
      ADD_FAILURE() << place << ", " << info.id << ": " << found;
      continue;
    }
    ++counts.explained;
    std::cout << place.filename() << ": " << found << "; " << why->why << "\n";
  }
}

}  // namespace

TEST(Differential, EveryDicomSeriesIsAsGdcmReadsItOrARowSaysWhyNot) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  Counts counts;
  std::vector<fs::path> tops{dicom};
  for (const char* more : {"hard", "labelled/totalsegmentator-dicom"})
    if (const fs::path top = findTestData(more); !top.empty()) tops.push_back(top);
  for (const auto& [archive, folder] : {std::pair{"visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head"},
                                        std::pair{"dicom/ct-tilt-philips-S21610_S2010.tar.xz", "S21610_S2010"}})
    if (const fs::path top = unpackTestData(archive, folder); !top.empty()) tops.push_back(top);
  for (const fs::path& top : tops)
    for (const fs::path& place : placesBelow(top)) compareAt(place, counts);
  std::cout << counts.compared << " volumes compared, " << counts.agreeing << " agree, " << counts.explained
            << " explained; " << counts.unread << " files that GDCM does not read\n";
  EXPECT_GT(counts.agreeing, 40);
}

}  // namespace fenestra::tests
