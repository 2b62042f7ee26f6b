#pragma once
// The commands of fenestra-cli. Results go to standard output as JSON, progress and warnings to standard error. Errors
// are thrown: io::Error, egl::EglError, RenderError.

#include <filesystem>
#include <optional>

#include "app/cli/DescriptorReport.h"
#include "io/study/StudyRequest.h"
#include "io/surface/Surface.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/placement/Placer.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "rendering/volume/Slab.h"

namespace fenestra::cli {

struct InfoOptions {
  io::DataRequest data;
  bool descriptions = false;  ///< also the series' free texts, which may hold anything the operator typed
  bool tags = false;          ///< the DICOM attributes of a slice's file instead
  bool withPatient = false;   ///< also those attributes' values that may identify the patient
  std::string search;         ///< only attributes that hold it
  std::optional<int> slice;   ///< as scanned, from 0; the middle one otherwise
};
void info(const InfoOptions& options);
/// Prints the DICOM attributes of one slice's file.
void tags(const InfoOptions& options);

struct ConvertOptions {
  io::DataRequest data;
  std::vector<std::string> labels;  ///< those to write, by value or name; with any, or a file of them, no voxels are
  std::filesystem::path output;
};
void convert(const ConvertOptions& options);

struct SliceOptions {
  io::StudyRequest study;  ///< its focus is read for `facing` alone; its size is the picture's, pixels
  SlicePlane plane = SlicePlane::Axial;
  std::optional<double> at;  ///< mm along S, L or P; the middle slice when neither is given
  std::optional<int> index;
  std::optional<glm::dvec3> normal;      ///< unit, LPS
  std::optional<io::PlacedView> facing;  ///< the camera that the slice faces
  std::optional<glm::dvec3> through;     ///< world mm
  std::optional<double> spacing;         ///< mm, of square pixels
  Slab slab;                             ///< of thickness 0: the slice alone
  std::optional<double> width, level;
  std::filesystem::path output;  ///< .mha: real values; else a PNG
};
/// Writes a slice or a slab; prints where it lies as JSON. Needs OpenGL where a camera must be placed.
void slice(const SliceOptions& options);

struct MeasureOptions {
  io::DataRequest data;             ///< with labels
  std::vector<std::string> labels;  ///< those to measure, by value or name; all when empty
};
/// Prints volume, values and place of each label as JSON.
void measure(const MeasureOptions& options);

struct ReformatOptions {
  io::StudyRequest study;         ///< its focus is the structure to follow, or to measure along the path
  std::filesystem::path path;     ///< file of points; empty: the centre line of the focus
  std::optional<double> spacing;  ///< mm, of square pixels; the least of the volume's otherwise
  double width = 50.0;            ///< mm
  double angle = 0.0;             ///< degrees
  std::optional<double> section;  ///< mm from the path's beginning; unset: the straightened volume
  std::optional<double> windowWidth, level;
  std::filesystem::path output;  ///< .mha: real values; else a PNG
};
/// Writes the volume straightened along a path, or a section across it; prints the path's length, and the area and
/// radius of the focus along it, as JSON.
void reformat(const ReformatOptions& options);

struct SurfaceOptions {
  io::StudyRequest study;
  std::filesystem::path output;
  io::SurfaceFrame frame = io::SurfaceFrame::Lps;
  bool raw = false;  ///< without smoothing
};
/// Writes the focus as triangles; prints its volume, box and numbers of points and triangles as JSON.
void surface(const SurfaceOptions& options);

struct RenderOptions {
  io::StudyRequest study;
  std::filesystem::path output, layers, stats, session, look;  ///< empty: not written
  std::optional<Schedule> schedule;                            ///< empty: the faster one
  int repeat = 1;                                              ///< frames, each from the first pass on
  bool reference = false;                                      ///< in double precision on the CPU
  std::optional<int> certify;                                  ///< pixels to compare with the reference
  std::uint64_t certifySeed = 1;                               ///< that chooses them
};
void render(const RenderOptions& options);

struct PlaceOptions {
  io::StudyRequest study;
  placement::Sampling sampling;
  placement::Options placement;
  bool joint = placement::jointByDefault;
  bool everyCandidate = false;  ///< also the descriptors of all candidates
  std::optional<Schedule> schedule;
  int repeat = 1;             ///< measurements, for their times
  std::filesystem::path map;  ///< PNG of the quality over the sphere; empty: not written
  /// Beside the paper's three; of evenly spread directions, so that `sampling` is then not refined.
  DescriptorOptions descriptors;
  std::optional<glm::dvec3> pick;  ///< world mm: LiveSync for the structure there, in place of the focus
  placement::LiveSyncOptions liveSync;
};
/// Needs OpenGL, unless a point is picked.
void place(const PlaceOptions& options);
/// For the picked point.
void placeByPick(const PlaceOptions& options);

struct GrowOptions {
  io::DataRequest data;
  RegionFocus region;  ///< with an inside seed
  bool curve = false;  ///< also the volume at every tolerance
  std::filesystem::path output;
};
void grow(const GrowOptions& options);

struct BenchmarkOptions {
  std::filesystem::path output;      ///< .md or .json; empty: JSON to standard output
  bool isQuick = false;              ///< in about twenty seconds
  std::optional<glm::ivec2> size;    ///< of the pictures, pixels; that of the known machines otherwise
  std::optional<Schedule> schedule;  ///< empty: the faster one
};
/// Measures how fast this machine draws the built-in phantom, and compares it with machines of the project's report.
void benchmark(const BenchmarkOptions& options);

struct CompareOptions {
  std::filesystem::path a, b;
};
/// False when NaN or infinities of the two disagree.
bool compare(const CompareOptions& options);

}  // namespace fenestra::cli
