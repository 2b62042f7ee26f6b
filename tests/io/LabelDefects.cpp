// Segmentations and structure sets that are damaged or contradict themselves, each beside the volume that they are for.

#include "tests/io/Defects.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/io/NiftiBytes.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

/// Volume of 5 x 3 x 3 voxels of 1 mm whose axes are those of the world, LPS; NIfTI's are RAS.
void writeVolume(const fs::path& path) {
  NiftiSpec spec;
  spec.dims = {5, 3, 3};
  spec.sform = 1;
  spec.srow = {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0};
  writeFile(path, niftiHeader(spec) + std::string(2 * 45, '\1'));
}

/// A row of the table whose labels `write` makes.
Defect labels(std::string name, const std::function<void(const fs::path&)>& write, Expected expected) {
  Defect defect{"labels " + std::move(name),
                [=](const fs::path& folder) {
                  writeVolume(folder / "volume.nii");
                  write(folder / "labels.dcm");
                  return folder / "labels.dcm";
                },
                std::move(expected)};
  defect.labelsOf = "volume.nii";
  return defect;
}

std::vector<int> pixels(std::initializer_list<int> set) {
  std::vector<int> result(15, 0);
  for (const int i : set) result[static_cast<std::size_t>(i)] = 1;
  return result;
}

/// Two segments on three planes.
Defect segmentation(std::string name, const std::function<void(SegSpec&)>& change, Expected expected) {
  SegSpec spec;
  spec.segments = {{1, "liver", {}}, {7, "vessel", {}}};
  spec.frames = {{7, glm::dvec3(0, 0, 2), pixels({14})},
                 {1, glm::dvec3(0, 0, 1), pixels({0, 7})},
                 {1, glm::dvec3(0, 0, 2), pixels({0, 1, 2})},
                 {7, glm::dvec3(0, 0, 0), pixels({6, 8})},
                 {1, glm::dvec3(0, 0, 0), pixels({3})}};
  change(spec);
  return labels(
      "seg " + std::move(name), [=](const fs::path& path) { writeSeg(path, spec); }, std::move(expected));
}

/// Two structures of one contour each.
Defect structures(std::string name, const std::function<void(RtSpec&)>& change, Expected expected) {
  RtSpec spec;
  spec.rois = {{1, "a", "", {{rectangle(0, 0, 2, 2, 0), "CLOSED_PLANAR", {}, {}}}},
               {2, "b", "", {{rectangle(0, 0, 2, 2, 1), "CLOSED_PLANAR", {}, {}}}}};
  change(spec);
  return labels(
      "rtstruct " + std::move(name), [=](const fs::path& path) { writeRtStruct(path, spec); }, std::move(expected));
}

/// structures() with other coordinates in the first contour.
Defect coordinates(const std::string& name, const char* data, Expected expected) {
  return structures(
      name, [=](RtSpec& spec) { spec.rois[0].contours[0].data = data; }, std::move(expected));
}

std::vector<Defect> segmentationDefects() {
  return {
      segmentation(
          "whole", [](SegSpec&) {}, opens),
      segmentation(
          "frame of no segment", [](SegSpec& s) { s.frames[2].segment = 3; }, error("belongs to segment 3")),
      segmentation(
          "two segments of one number", [](SegSpec& s) { s.segments[0].number = 7; }, error("have the number 7")),
      segmentation(
          "frame of no place", [](SegSpec& s) { s.frames[1].position.reset(); }, error("does not say where it lies")),
      segmentation(
          "frame outside any scanner", [](SegSpec& s) { s.frames[1].position = glm::dvec3(1e9, 0, 0); },
          error("outside any scanner")),
      segmentation(
          "tiles", [](SegSpec& s) { s.frames[1].position = glm::dvec3(5, 0, 2); }, error("on one plane (tiles)")),
      segmentation(
          "unknown type", [](SegSpec& s) { s.type = "OTHER"; }, error("segmentation type is \"OTHER\"")),
      segmentation(
          "fewer frames than described", [](SegSpec& s) { s.numberOfFrames = 4; }, error("4 frames but describes 5")),
      segmentation(
          "more frames than stored", [](SegSpec& s) { s.numberOfFrames = 8; },
          error("10 bytes of pixels where its header describes 8 frames")),
      segmentation(
          "two thousand million frames", [](SegSpec& s) { s.numberOfFrames = 2000000000; },
          error("bytes where its header describes 2000000000 frames")),
      segmentation(
          "cut pixels", [](SegSpec& s) { s.pixelBytes = 4; },
          error("4 bytes of pixels where its header describes 5 frames")),
      segmentation(
          "binary of 16 bits", [](SegSpec& s) { s.bits = 16; }, error("16 bits, which its type does not allow")),
      segmentation(
          "binary of 8 bits", [](SegSpec& s) { s.bits = 8; }, opens),
      segmentation(
          "type padded with NUL", [](SegSpec& s) { s.type = std::string("BINARY\0", 7); }, opens),
      segmentation(
          "greatest fraction 0",
          [](SegSpec& s) {
            s.type = "FRACTIONAL";
            s.bits = 8;
            s.greatest = 0;
          },
          error("greatest fraction is 0")),
      segmentation(
          "frames of 65535 rows and columns", [](SegSpec& s) { s.rows = s.columns = 65535; },
          error("where its header describes")),
      segmentation(
          "frames padded to bytes",
          [](SegSpec& s) {
            s.frames[4].pixels = pixels({3, 14});
            s.padsFrames = true;
          },
          warning("frames of 15 bits begins on a byte of its own")),
      segmentation(
          "overlapping segments",
          [](SegSpec& s) {
            s.frames[0].pixels = pixels({1, 14});
          },
          warning("overlap at 1 voxel")),
      segmentation(
          "far from the volume",
          [](SegSpec& s) {
            for (SegFrameSpec& frame : s.frames) *frame.position += glm::dvec3(500, 0, 0);
          },
          warning("outside")),
  };
}

std::vector<Defect> structureSetDefects() {
  // One contour of structure "a"; structure "b" stays.
  const auto leftOut = [](const std::string& fault) {
    return warning("1 contour left out, which cannot be read: a contour of a has " +
                   (fault.starts_with("coordinate") ? "the " + fault : fault));
  };
  return {
      structures(
          "whole", [](RtSpec&) {}, opens),
      coordinates("coordinate NaN", "0\\0\\nan", leftOut("coordinate \"nan\"")),
      coordinates("infinite coordinate", "0\\inf\\0", leftOut("coordinate \"inf\"")),
      coordinates("coordinate 1e300", "1e300\\0\\0", leftOut("coordinate \"1e300\"")),
      coordinates("coordinate of letters", "1\\x\\0", leftOut("coordinate \"x\"")),
      coordinates("four coordinates", "1\\2\\3\\4", leftOut("4 coordinates")),
      structures(
          "more points than stored", [](RtSpec& s) { s.rois[0].contours[0].count = 2000000000; },
          leftOut("4 points but says 2000000000")),
      structures(
          "two structures of one number", [](RtSpec& s) { s.rois[1].number = 1; }, error("have the number 1")),
      structures(
          "contours of no structure", [](RtSpec& s) { s.contoursOf = 9; },
          error("structure 9, which it does not describe, and no others")),
      structures(
          "contours of one structure too many",
          [](RtSpec& s) {
            s.rois.push_back({12, "c", "", {{rectangle(0, 0, 2, 2, 1), "CLOSED_PLANAR", {}, {}}}, false});
          },
          warning("1 contour left out: of structure 12, which it does not describe")),
      structures(
          "fewer points than stored", [](RtSpec& s) { s.rois[1].contours[0].count = 3; },
          warning("a contour of b has 4 points but says 3")),
      structures(
          "coordinates with decimal commas", [](RtSpec& s) { s.rois[0].contours[0].data = "0,5\\0\\0"; },
          leftOut("coordinate \"0,5\"")),
      structures(
          "no contour that can be read",
          [](RtSpec& s) {
            s.rois.pop_back();
            s.rois[0].contours[0].count = 7;
          },
          error("a contour of a has 4 points but says 7")),
      structures(
          "contours that exclude each other", [](RtSpec& s) { s.rois[0].contours[0].type = "CLOSEDPLANAR_XOR"; },
          opens),
      structures(
          "contour type in lower case", [](RtSpec& s) { s.rois[0].contours[0].type = "closed_planar"; }, opens),
      structures(
          "contour type padded with NUL",
          [](RtSpec& s) { s.rois[0].contours[0].type = std::string("CLOSED_PLANAR\0", 14); }, opens),
      structures(
          "coordinates padded with NUL and blanks",
          [](RtSpec& s) { s.rois[0].contours[0].data = std::string("0\\0\\0\\ 2\\0 \\0\\2\\2\\0\\0\\2\\0\0", 26); },
          opens),
      structures(
          "contour without coordinates", [](RtSpec& s) { s.rois[0].contours[0].data = ""; },
          warning("a contour of a has 0 points but says 4")),
      structures(
          "open contour", [](RtSpec& s) { s.rois[0].contours[0].type = "OPEN_PLANAR"; },
          warning("points or open lines")),
  };
}

}  // namespace

std::vector<Defect> labelDefects() {
  std::vector<Defect> all = segmentationDefects(), others = structureSetDefects();
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

}  // namespace fenestra::tests
