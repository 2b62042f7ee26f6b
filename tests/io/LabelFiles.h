#pragma once
// Segmentations and structure sets of known content, written with DCMTK's dataset functions attribute by attribute, and
// label maps compared.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/VolumeReader.h"

namespace fenestra::tests {

struct SegmentSpec {
  int number = 1;
  std::string label;
  std::vector<int> cieLab;  ///< three words, or none
};
struct SegFrameSpec {
  int segment = 1;
  std::optional<glm::dvec3> position = glm::dvec3(0.0);
  std::vector<int> pixels;  ///< rows · columns
};
struct SegSpec {
  std::string type = "BINARY";
  std::string description = "made up";
  std::string sopClass = "1.2.840.10008.5.1.4.1.1.66.4";
  int columns = 5, rows = 3;
  int bits = 1;
  bool padsFrames = false;  ///< each frame of bits begins on a byte of its own
  int greatest = 255;       ///< Maximum Fractional Value
  glm::dvec3 row{1, 0, 0}, column{0, 1, 0};
  std::string pixelSpacing = "1\\1";
  std::string spacingBetweenSlices = "1";
  std::string series = "1.2.3.4";  ///< that it refers to; empty: none
  std::string frameOfReference = "1.2.3";
  std::string transferSyntax = "explicit";  ///< explicit, implicit, big, deflated, rle
  std::vector<SegmentSpec> segments{{1, "first", {}}};
  std::vector<SegFrameSpec> frames;
  std::optional<int> numberOfFrames;      ///< when it lies
  std::optional<std::size_t> pixelBytes;  ///< when pixels are missing
};
void writeSeg(const std::filesystem::path& path, const SegSpec& spec);

struct ContourSpec {
  std::vector<glm::dvec3> points;
  std::string type = "CLOSED_PLANAR";
  std::optional<std::string> data;  ///< instead of the points
  std::optional<int> count;         ///< when it lies
};
struct RoiSpec {
  int number = 1;
  std::string name;
  std::string colour;  ///< "r\\g\\b"
  std::vector<ContourSpec> contours;
  bool described = true;  ///< among the structures, which come first
};
struct RtSpec {
  std::vector<RoiSpec> rois;
  std::string series = "1.2.3.4";
  std::optional<int> contoursOf;  ///< ROI number that all contours claim
};
void writeRtStruct(const std::filesystem::path& path, const RtSpec& spec);

Grid labelGrid(glm::ivec3 dims, glm::dvec3 origin = glm::dvec3(0.0), glm::dvec3 spacing = glm::dvec3(1.0));
std::vector<int> valuesOf(const LabelMap& map);
/// Fails the test where two maps differ in a voxel; says how many do.
void expectSameLabels(const LabelMap& actual, const LabelMap& expected);
/// A closed rectangle on the plane z.
std::vector<glm::dvec3> rectangle(double left, double top, double right, double bottom, double z);

}  // namespace fenestra::tests
