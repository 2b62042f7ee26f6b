// Real segmentations and structure sets: dcmqi's against the label maps that they were made from, highdicom's against
// DCMTK's own reader, contours against a count of crossings for each voxel.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmfg/fgseg.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>
#include <dcmtk/dcmseg/segutils.h>
#include <dcmtk/oflog/oflog.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::realSegmentationTest {
namespace fs = std::filesystem;

namespace {

/// Segments at each voxel, by DCMTK's own reader; frames are laid on the slices whose position they have.
std::map<std::size_t, std::set<int>> segmentsByDcmtk(const fs::path& path, const Grid& grid) {
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  std::map<std::size_t, std::set<int>> result;
  DcmSegmentation* read = nullptr;
  EXPECT_TRUE(DcmSegmentation::loadFile(path.c_str(), read).good()) << path;
  const std::unique_ptr<DcmSegmentation> document(read);
  if (!document) return result;
  const bool binary = document->getSegmentationType() == DcmSegTypes::ST_BINARY;
  const auto rows = static_cast<Uint16>(grid.dims.y), columns = static_cast<Uint16>(grid.dims.x);
  for (std::size_t number = 0; number < document->getNumberOfFrames(); ++number) {
    const auto frame = static_cast<Uint32>(number);
    auto& groups = document->getFunctionalGroups();
    auto* place = dynamic_cast<FGPlanePosPatient*>(groups.get(frame, DcmFGTypes::EFG_PLANEPOSPATIENT));
    auto* of = dynamic_cast<FGSegmentation*>(groups.get(frame, DcmFGTypes::EFG_SEGMENTATION));
    if (!place || !of) {
      ADD_FAILURE() << path << " frame " << number;
      return result;
    }
    glm::dvec3 position;
    place->getImagePositionPatient(position.x, position.y, position.z);
    Uint16 segment = 0;
    of->getReferencedSegmentNumber(segment);
    const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(position, 1.0));
    const int slice = static_cast<int>(std::lround(index.z));
    EXPECT_LT(std::abs(index.x) + std::abs(index.y), 0.05);
    if (slice < 0 || slice >= grid.dims.z || std::abs(index.z - slice) > 0.05) continue;
    const DcmIODTypes::Frame* stored = document->getFrame(number);
    const std::unique_ptr<DcmIODTypes::Frame> bytes(binary ? DcmSegUtils::unpackBinaryFrame(stored, rows, columns)
                                                           : nullptr);
    const Uint8* pixel = binary ? bytes->pixData : stored->pixData;
    for (int i = 0; i < grid.dims.x * grid.dims.y; ++i)
      if (binary ? pixel[i] != 0 : 2 * pixel[i] >= 255)
        result[grid.offset({i % grid.dims.x, i / grid.dims.x, slice})].insert(segment);
  }
  return result;
}

/// Every voxel has the smallest of the segments that DCMTK finds there.
void expectAsDcmtk(const fs::path& path, const Grid& grid) {
  SCOPED_TRACE(path.string());
  const std::vector<int> ours = valuesOf(*io::openLabels(path, grid).labels);
  const auto theirs = segmentsByDcmtk(path, grid);
  ASSERT_FALSE(theirs.empty());
  std::map<int, std::size_t> sizes;
  for (const auto& [voxel, segments] : theirs)
    for (const int segment : segments) ++sizes[segment];
  std::size_t different = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const auto at = theirs.find(i);
    int expected = 0;
    if (at != theirs.end())
      expected = *std::min_element(at->second.begin(), at->second.end(),
                                   [&](int a, int b) { return std::pair(sizes[a], -a) < std::pair(sizes[b], -b); });
    different += ours[i] != expected;
  }
  EXPECT_EQ(different, 0u);
}

struct RealContour {
  std::vector<glm::dvec2> points;  ///< column and row, in voxels
  double z = 0.0;                  ///< mm
};

/// The contours of one ROI on axial slices of `grid`, in voxels.
std::vector<RealContour> contoursOf(const fs::path& path, int roi, const Grid& grid) {
  std::vector<RealContour> contours;
  DcmFileFormat file;
  EXPECT_TRUE(file.loadFile(path.c_str()).good());
  DcmItem* item = nullptr;
  for (long i = 0; file.getDataset()->findAndGetSequenceItem(DCM_ROIContourSequence, item, i).good(); ++i) {
    Sint32 number = 0;
    item->findAndGetSint32(DCM_ReferencedROINumber, number);
    if (number != roi) continue;
    DcmItem* contour = nullptr;
    for (long c = 0; item->findAndGetSequenceItem(DCM_ContourSequence, contour, c).good(); ++c) {
      OFString text;
      contour->findAndGetOFStringArray(DCM_ContourData, text);
      std::istringstream stream(text.c_str());
      std::vector<double> numbers;
      for (std::string word; std::getline(stream, word, '\\');) numbers.push_back(std::stod(word));
      RealContour points;
      for (std::size_t n = 0; n + 2 < numbers.size(); n += 3) {
        const glm::dvec3 world(numbers[n], numbers[n + 1], numbers[n + 2]);
        points.points.push_back(glm::dvec2(glm::dvec3(grid.indexFromWorld() * glm::dvec4(world, 1.0))));
        points.z = world.z;
      }
      contours.push_back(points);
    }
  }
  return contours;
}

double distanceToEdge(const std::vector<RealContour>& contours, glm::dvec2 at) {
  double least = 1e9;
  for (const RealContour& contour : contours)
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const glm::dvec2 a = contour.points[i], edge = contour.points[(i + 1) % contour.points.size()] - a;
      const double along = glm::dot(edge, edge) > 0.0 ? glm::dot(at - a, edge) / glm::dot(edge, edge) : 0.0;
      least = std::min(least, glm::distance(at, a + std::clamp(along, 0.0, 1.0) * edge));
    }
  return least;
}

/// Whether a ray straight down crosses the contours an odd number of times.
bool isEnclosed(const std::vector<RealContour>& contours, glm::dvec2 at) {
  bool inside = false;
  for (const RealContour& contour : contours)
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const glm::dvec2 a = contour.points[i], b = contour.points[(i + 1) % contour.points.size()];
      if ((a.x > at.x) == (b.x > at.x)) continue;
      inside ^= a.y + (at.x - a.x) / (b.x - a.x) * (b.y - a.y) > at.y;
    }
  return inside;
}

/// Every voxel of a slice against the crossings; those within a hundredth of a voxel of an edge belong to the
/// structure.
void expectFilled(const LabelMap& map, int label, int slice, const std::vector<RealContour>& contours) {
  ASSERT_FALSE(contours.empty());
  std::size_t inside = 0, wrong = 0;
  for (int y = 0; y < map.grid.dims.y; ++y)
    for (int x = 0; x < map.grid.dims.x; ++x) {
      const double distance = distanceToEdge(contours, {x, y});
      const bool expected = isEnclosed(contours, {x, y}) || distance < 0.0099;
      inside += expected;
      if (distance < 0.0099 || distance > 0.0143) wrong += (map.value({x, y, slice}) == label) != expected;
    }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(inside, 500u);
}

}  // namespace

TEST(RealSegmentation, DcmqiGivesItsLabelMapsBack) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/seg");
  const Grid liver = io::openVolume(folder / "dcmqi/ct-3slice").volume->grid;
  const auto fromSeg = io::openLabels(folder / "dcmqi/liver.dcm", liver);
  EXPECT_TRUE(fromSeg.warnings.empty()) << fromSeg.warnings.front().text;
  EXPECT_EQ(fromSeg.labels->find(1)->name, "Liver");
  // The colour is from 3D Slicer's table; 16 bits of CIELab keep more than 8 bits of sRGB.
  EXPECT_LT(glm::distance(fromSeg.labels->find(1)->colour, glm::dvec3(221, 130, 101) / 255.0), 0.001);
  expectSameLabels(*fromSeg.labels, *io::openLabels(folder / "dcmqi/liver_seg.nrrd", liver).labels);

  for (const char* image : {"dcmqi-24x38x3/image", "dcmqi-24x38x3/multiframe/mf.dcm"}) {
    const Grid small = io::openVolume(folder / image).volume->grid;
    expectSameLabels(*io::openLabels(folder / "dcmqi-24x38x3/seg/label.seg", small).labels,
                     *io::openLabels(folder / "dcmqi-24x38x3/nrrd/label.nrrd", small).labels);
  }
}

TEST(RealSegmentation, EverySegmentIsWhereDcmtkFindsIt) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/seg");
  const Grid ct = io::openVolume(folder / "dcmqi/ct-3slice").volume->grid;
  expectAsDcmtk(folder / "dcmqi/partial_overlaps.dcm", ct);
  expectAsDcmtk(folder / "dcmqi/liver.dcm", ct);
  expectAsDcmtk(folder / "dcmqi-24x38x3/seg/label.seg", io::openVolume(folder / "dcmqi-24x38x3/image").volume->grid);
  const Grid pieces = io::openVolume(folder / "highdicom/referenced-ct-77654033-CT2").volume->grid;
  for (const char* name : {"seg_image_ct_binary.dcm", "seg_image_ct_binary_overlap.dcm",
                           "seg_image_ct_binary_fractional.dcm", "seg_image_ct_true_fractional.dcm"})
    expectAsDcmtk(folder / "highdicom" / name, pieces);
  expectAsDcmtk(folder / "highdicom/seg_image_ct_binary_single_frame.dcm",
                io::openVolume(folder / "highdicom/ct_image.dcm").volume->grid);
}

TEST(RealSegmentation, AreListedWithTheirSeries) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom");
  const io::OpenedVolume ct = io::openVolume(folder / "seg/dcmqi");
  ASSERT_EQ(ct.segmentations.size(), 2u);
  EXPECT_EQ(ct.segmentations[0].file.filename(), "liver.dcm");
  EXPECT_EQ(ct.segmentations[1].structures.size(), 5u);
  const io::OpenedVolume planned = io::openVolume(folder / "rtstruct/dicompyler");
  ASSERT_EQ(planned.segmentations.size(), 1u);
  EXPECT_EQ(planned.segmentations[0].kind, "RTSTRUCT");
  EXPECT_EQ(planned.segmentations[0].structures.size(), 10u);
}

TEST(RealSegmentation, Thorough_ContoursAreFilledAsTheirCrossingsSay) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/rtstruct");
  const Grid phantom = io::openVolume(folder / "rt-utils").volume->grid;
  const auto labels = io::openLabels(folder / "rt-utils/rt.dcm", phantom).labels;
  const std::vector<RealContour> all = contoursOf(folder / "rt-utils/rt.dcm", 1, phantom);
  int filled = 0;
  for (int k = 0; k < phantom.dims.z; ++k) {
    std::vector<RealContour> here;
    for (const RealContour& contour : all)
      if (std::abs(contour.z - (phantom.origin.z + phantom.direction[2].z * phantom.spacing.z * k)) < 0.1)
        here.push_back(contour);
    if (here.empty()) continue;
    expectFilled(*labels, 1, k, here);
    ++filled;
  }
  EXPECT_GE(filled, 1);

  const Grid slice = io::openVolume(folder / "dicompyler/ct.0.dcm").volume->grid;
  const auto planned = io::openLabels(folder / "dicompyler/rtss.dcm", slice).labels;
  std::vector<RealContour> body;
  for (const RealContour& contour : contoursOf(folder / "dicompyler/rtss.dcm", 1, slice))
    if (std::abs(contour.z - slice.origin.z) < 0.1) body.push_back(contour);
  EXPECT_EQ(planned->find(1)->name, "BODY");
  expectFilled(*planned, 1, 0, body);
}

}  // namespace fenestra::tests::realSegmentationTest
