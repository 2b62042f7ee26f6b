#include "io/dicom/Segmentation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <optional>
#include <set>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmiod/cielabutil.h>

#include "io/base/Memory.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomDecoder.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/FramePlaces.h"
#include "io/dicom/Slabs.h"
#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

enum class Type { Binary, Fractional, LabelMap };

struct Frame {
  int number = 0;             ///< of the stored frame, from 0
  std::uint16_t segment = 0;  ///< 0 in a label map, whose pixels name the segments
  glm::dvec3 origin{0.0};     ///< centre of the first pixel, LPS mm
  double along = 0.0;         ///< position along the normal, mm
  std::size_t plane = 0;
};

struct Header {
  DicomFile file;
  Type type = Type::Binary;
  std::int64_t greatest = 1;    ///< the fractional value that stands for a whole voxel
  std::int64_t background = 0;  ///< pixel value of a label map where there is no segment
  std::vector<Label> labels;
  std::vector<Frame> frames;
  glm::dmat2x3 axes{1.0};  ///< unit vectors along a row and down a column
  glm::dvec2 spacing{1.0};
  double declaredStep = 0.0, thickness = 0.0;  ///< mm; 0 when not said

  glm::dvec3 normal() const { return glm::normalize(glm::cross(axes[0], axes[1])); }
  std::size_t framePixels() const {
    return static_cast<std::size_t>(file.format.rows) * static_cast<std::size_t>(file.format.columns);
  }
};

/// Recommended Display CIELab Value as sRGB. PS3.3 C.10.7.1.1 means CIELab against D50, but DCMTK, and with it dcmqi
/// and 3D Slicer, write and read it against D65; as they do, so that colours come back as they were chosen.
std::optional<glm::dvec3> displayColour(DcmItem& segment) {
  std::array<Uint16, 3> lab{};
  for (unsigned long i = 0; i < lab.size(); ++i)
    if (segment.findAndGetUint16(DCM_RecommendedDisplayCIELabValue, lab[i], i).bad()) return std::nullopt;
  glm::dvec3 rgb;
  IODCIELabUtil::dicomLab2RGB(rgb.x, rgb.y, rgb.z, lab[0], lab[1], lab[2]);
  return glm::clamp(rgb, 0.0, 1.0);
}

std::vector<Label> segmentsOf(DcmDataset& dataset, const fs::path& path) {
  std::vector<Label> labels;
  std::set<std::int64_t> taken;
  forEachItem(dataset, DCM_SegmentSequence, [&](DcmItem& segment) {
    const std::int64_t number = integerOf(segment, DCM_SegmentNumber).value_or(-1);
    if (number < 0 || number > greatestLabel) refuseDamaged(path, "one of its segments has no number");
    if (!taken.insert(number).second)
      refuseDamaged(path, "two of its segments have the number " + std::to_string(number));
    if (number == 0) return;  // a label map may describe its background
    Label label;
    label.value = static_cast<std::uint16_t>(number);
    label.name = segmentName(segment, dataset);
    label.colour = noColour;
    if (const auto colour = displayColour(segment)) label.colour = *colour;
    labels.push_back(std::move(label));
  });
  return labels;
}

Type typeOf(DcmDataset& dataset, const fs::path& path) {
  const std::string name = codeOf(dataset, DCM_SegmentationType);
  if (name == "BINARY") return Type::Binary;
  if (name == "FRACTIONAL") return Type::Fractional;
  if (name == "LABELMAP" || textOf(dataset, DCM_SOPClassUID) == labelMapSegmentationClass) return Type::LabelMap;
  refuseDamaged(path, "its segmentation type is \"" + name + "\"");
}

void readFormat(DcmDataset& dataset, Header& header) {
  PixelFormat& format = header.file.format;
  format.rows = static_cast<int>(integerOf(dataset, DCM_Rows).value_or(0));
  format.columns = static_cast<int>(integerOf(dataset, DCM_Columns).value_or(0));
  const std::int64_t bits = integerOf(dataset, DCM_BitsAllocated).value_or(0);
  if (format.rows < 1 || format.columns < 1) refuseDamaged(header.file.path, "it holds no frames");
  const bool possible =
      header.type == Type::LabelMap ? bits == 8 || bits == 16 : bits == 8 || (bits == 1 && header.type == Type::Binary);
  if (!possible)
    refuseDamaged(header.file.path, "its pixels have " + std::to_string(bits) + " bits, which its type does not allow");
  format.bitsAllocated = format.bitsStored = static_cast<int>(bits);
  format.highBit = format.bitsStored - 1;
  header.greatest = integerOf(dataset, DCM_MaximumFractionalValue).value_or(255);
  if (header.greatest < 1 || header.greatest > 255)
    refuseDamaged(header.file.path,
                  "its greatest fraction is " + std::to_string(header.greatest) + ", not from 1 to 255");
  if (header.type == Type::LabelMap) header.background = integerOf(dataset, DCM_PixelPaddingValue).value_or(0);
}

Frame readFrame(const Scopes& scopes, int number, Header& header) {
  DicomFrame place;
  readGeometry(scopes, place);
  const std::string name = "frame " + std::to_string(number + 1);
  if (!place.hasGeometry || !place.ownPlace)
    throw Error(header.file.path, "its " + name + " does not say where it lies in the patient",
                "only segmentations of volumes can be opened");
  if (place.assumed & (assumed::spacing | assumed::garbledSpacing))
    refuseDamaged(header.file.path, "its " + name + " has no pixel spacing");
  // A kilometre: beyond any scanner, and far from where arithmetic fails.
  if (glm::any(glm::greaterThan(glm::abs(place.position), glm::dvec3(1e6))))
    refuseDamaged(header.file.path, "its " + name + " lies outside any scanner");
  if (number == 0) {
    header.axes = place.axes;
    header.spacing = place.spacing;
    header.thickness = place.thickness > 0.0 ? place.thickness : place.step;
    header.declaredStep = place.step;
  }
  // A thousandth of a radian, and of the spacing: rounding leaves less.
  const bool parallel = glm::distance(place.axes[0], header.axes[0]) < 1e-3 &&
                        glm::distance(place.axes[1], header.axes[1]) < 1e-3 &&
                        glm::all(glm::lessThan(glm::abs(place.spacing - header.spacing), 1e-3 * header.spacing));
  if (!parallel)
    throw Error(header.file.path, "its frames have several orientations or pixel spacings",
                "split it into one file for each");
  place.number = number;
  header.file.frames.push_back(place);
  Frame frame;
  frame.number = number;
  frame.origin = place.position;
  frame.along = glm::dot(place.position, header.normal());
  if (header.type == Type::LabelMap) return frame;
  std::int64_t segment = 0;
  for (DcmItem* groups : {scopes.perFrame, scopes.shared})
    if (DcmItem* of = firstItem(groups, DCM_SegmentIdentificationSequence); of && segment == 0)
      segment = integerOf(*of, DCM_ReferencedSegmentNumber).value_or(0);
  const bool known = std::any_of(header.labels.begin(), header.labels.end(),
                                 [&](const Label& label) { return label.value == segment; });
  if (!known)
    refuseDamaged(header.file.path,
                  "its " + name + " belongs to segment " + std::to_string(segment) + ", which it does not describe");
  frame.segment = static_cast<std::uint16_t>(segment);
  return frame;
}

void readFrames(DcmDataset& dataset, Header& header) {
  const auto pixels = pixelsOf(dataset, header.file.path);
  if (!pixels) refuseDamaged(header.file.path, "it has no pixels");
  header.file.pixels = *pixels;
  header.file.transferSyntax = dataset.getOriginalXfer();
  const std::int64_t count = countFrames(dataset, header.file);
  DcmSequenceOfItems* perFrame = nullptr;
  dataset.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, perFrame);
  const std::int64_t described = perFrame ? static_cast<std::int64_t>(perFrame->card()) : 0;
  if (described != count)
    refuseDamaged(header.file.path,
                  "it has " + std::to_string(count) + " frames but describes " + std::to_string(described));
  DcmItem* shared = firstItem(&dataset, DCM_SharedFunctionalGroupsSequence);
  DcmObject* next = nullptr;
  for (int number = 0; (next = perFrame->nextInContainer(next)); ++number)
    header.frames.push_back(readFrame({dynamic_cast<DcmItem*>(next), shared, dataset}, number, header));
}

/// Labelled pixels of frames. Binary frames of one bit a pixel follow each other without padding, the lowest bit first
/// (PS3.5 8.1.1); some writers begin each frame on a byte of its own.
class FramePixels {
 public:
  explicit FramePixels(const Header& header) : header_(header), native_(header.file.path, header.file.pixels) {
    if (header.file.format.bitsAllocated > 1)
      decoder_.emplace(header.file);
    else if (header.file.pixels.encapsulated)
      throw Error(header.file.path, "its frames of one bit a pixel are compressed",
                  "store the segmentation uncompressed");
    else
      padded_ = isPadded();
  }
  /// Whether each frame begins on a byte of its own.
  bool isPaddedToBytes() const { return padded_; }

  /// Calls visit(pixel, label) for each labelled pixel of a frame.
  template <class F>
  void forEach(const Frame& frame, F&& visit) {
    const std::size_t count = header_.framePixels();
    if (!decoder_) {
      const std::uint64_t first = static_cast<std::uint64_t>(frame.number) * (padded_ ? (count + 7) / 8 * 8 : count);
      bits_.resize((first + count + 7) / 8 - first / 8);
      native_.read(first / 8, bits_);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t bit = first % 8 + i;
        if (bit % 8 == 0 && bits_[bit / 8] == std::byte{0} && i + 8 <= count)
          i += 7;  // eight empty pixels
        else if ((bits_[bit / 8] >> (bit % 8) & std::byte{1}) != std::byte{0})
          visit(i, frame.segment);
      }
      return;
    }
    const std::span<const std::byte> words = decoder_->decode(frame.number);
    for (std::size_t i = 0; i < count; ++i) {
      std::uint16_t value = 0;
      if (header_.file.format.bitsAllocated == 16)
        std::memcpy(&value, words.data() + 2 * i, 2);
      else
        value = static_cast<std::uint16_t>(words[i]);
      if (header_.type == Type::LabelMap) {
        if (value != header_.background && value != 0) visit(i, value);
      } else if (header_.type == Type::Binary ? value != 0 : 2 * value >= header_.greatest) {
        visit(i, frame.segment);
      }
    }
  }

 private:
  /// As the length of the pixel data tells, which an even number of bytes rounds up. Where it fits both, bits behind
  /// the last pixel of packed frames can only be a padded frame's.
  bool isPadded() {
    const std::uint64_t count = header_.framePixels(), frames = header_.frames.size();
    const std::uint64_t length = header_.file.pixels.length;
    const std::uint64_t packed = (frames * count + 7) / 8, padded = frames * ((count + 7) / 8);
    const auto fits = [&](std::uint64_t bytes) { return length == bytes || length == bytes + bytes % 2; };
    if (count % 8 == 0 || frames < 2 || !fits(padded)) return false;
    if (!fits(packed)) return true;
    std::vector<std::byte> end(padded - frames * count / 8);
    native_.read(frames * count / 8, end);
    if (!end.empty()) end.front() >>= frames * count % 8;
    return std::any_of(end.begin(), end.end(), [](std::byte each) { return each != std::byte{0}; });
  }

  const Header& header_;
  NativePixels native_;
  bool padded_ = false;
  std::optional<DicomDecoder> decoder_;  ///< of frames with whole bytes a pixel
  std::vector<std::byte> bits_;
};

/// Labels on the planes that the frames lie on, in ascending order along the normal.
struct LabelPlanes {
  std::vector<double> positions;      ///< along the normal, mm
  std::vector<glm::dvec3> origins;    ///< centre of each plane's first pixel, LPS mm
  std::vector<std::uint16_t> values;  ///< plane after plane, row after row
};

/// Gives each frame its plane.
LabelPlanes planesOf(Header& header) {
  std::vector<std::size_t> order(header.frames.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return header.frames[a].along < header.frames[b].along; });
  // Frames of one slice carry the same position, up to rounding.
  const double tolerance = std::min({0.01, 0.1 * header.spacing.x, 0.1 * header.spacing.y});
  LabelPlanes planes;
  for (const std::size_t i : order) {
    Frame& frame = header.frames[i];
    if (planes.positions.empty() || frame.along - planes.positions.back() > tolerance) {
      planes.positions.push_back(frame.along);
      planes.origins.push_back(frame.origin);
    }
    if (glm::distance(frame.origin, planes.origins.back()) > 2.0 * tolerance)
      throw Error(header.file.path, "several of its frames lie beside each other on one plane (tiles)",
                  "only segmentations of volumes can be opened");
    frame.plane = planes.positions.size() - 1;
  }
  return planes;
}

void paint(const Header& header, const Progress& progress, LabelPlanes& planes, std::vector<Warning>& warnings) {
  checkMemory(header.file.path, saturatingProduct(planes.positions.size(), 2 * header.framePixels()));
  planes.values.assign(planes.positions.size() * header.framePixels(), 0);
  FramePixels pixels(header);
  if (pixels.isPaddedToBytes())
    warnings.push_back({Warning::Kind::Other,
                        "each of its frames of " + std::to_string(header.framePixels()) +
                            " bits begins on a byte of its own, where DICOM packs them without gaps; they are read so",
                        {header.file.path}});
  std::vector<std::uint64_t> sizes(greatestLabel + 1u, 0);
  const auto step = [&](std::size_t done) {
    const double fraction = 0.5 * static_cast<double>(done) / static_cast<double>(header.frames.size());
    if (progress && !progress(fraction, "reading segments")) throw Cancelled();
  };
  for (std::size_t i = 0; i < header.frames.size(); ++i) {
    step(i);
    pixels.forEach(header.frames[i], [&](std::size_t, std::uint16_t label) { ++sizes[label]; });
  }
  LabelOverlap overlap;
  for (const Label& label : header.labels) overlap.add(label.value, sizes[label.value]);
  for (std::size_t i = 0; i < header.frames.size(); ++i) {
    step(header.frames.size() + i);
    std::uint16_t* plane = planes.values.data() + header.frames[i].plane * header.framePixels();
    pixels.forEach(header.frames[i],
                   [&](std::size_t pixel, std::uint16_t label) { plane[pixel] = overlap.keep(plane[pixel], label); });
  }
  overlap.warn(header.file.path, header.labels, warnings);
}

/// The usual distance between planes: as declared, unless neighbours lie closer.
double stepOf(const Header& header, const std::vector<double>& positions, const Grid& target) {
  double step = header.declaredStep;
  for (std::size_t i = 1; i < positions.size(); ++i) {
    const double gap = positions[i] - positions[i - 1];
    if (step == 0.0 || gap < step) step = gap;
  }
  if (step > 0.0) return step;
  return header.thickness > 0.0 ? header.thickness : target.spacing.z;
}

/// The label of the nearest pixel for each voxel of `target`.
std::vector<std::uint16_t> onGrid(const Header& header, const LabelPlanes& planes, const Grid& target,
                                  std::vector<Warning>& warnings) {
  const double step = stepOf(header, planes.positions, target);
  const Slabs slabs(planes.positions, step);
  const glm::dmat3 pixelFromWorld =
      glm::inverse(glm::dmat3(header.axes[0] * header.spacing.x, header.axes[1] * header.spacing.y, header.normal()));
  const glm::dmat4 worldFromIndex = target.worldFromIndex();
  const glm::dvec3 normal = header.normal(), along = glm::dvec3(worldFromIndex[0]);
  const glm::dvec3 size(header.file.format.columns, header.file.format.rows, 1.0);
  std::vector<std::uint16_t> result(target.voxelCount(), 0);
  const auto rows = static_cast<std::size_t>(target.dims.y), slices = static_cast<std::size_t>(target.dims.z);
  parallelFor(rows * slices, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const glm::dvec3 start(worldFromIndex * glm::dvec4(0.0, row % rows, row / rows, 1.0));
      std::uint16_t* to = result.data() + row * static_cast<std::size_t>(target.dims.x);
      for (int x = 0; x < target.dims.x; ++x) {
        const glm::dvec3 world = start + static_cast<double>(x) * along;
        const int plane = slabs.at(glm::dot(world, normal));
        if (plane < 0) continue;
        const auto index = static_cast<std::size_t>(plane);
        const glm::dvec3 pixel = glm::floor(pixelFromWorld * (world - planes.origins[index]) + 0.5);
        if (pixel.x < 0.0 || pixel.y < 0.0 || pixel.x >= size.x || pixel.y >= size.y) continue;
        to[x] = planes.values[index * header.framePixels() +
                              static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(header.file.format.columns) +
                              static_cast<std::size_t>(pixel.x)];
      }
    }
  });
  const glm::dmat4 indexFromWorld = target.indexFromWorld();
  const glm::dvec3 acrossColumns = header.axes[0] * header.spacing.x, acrossRows = header.axes[1] * header.spacing.y;
  bool sameLattice = std::abs(header.spacing.x * header.spacing.y * step / target.voxelVolume() - 1.0) < 0.03;
  for (const glm::dvec3& origin : planes.origins)
    for (const glm::dvec3& corner :
         {origin, origin + acrossColumns * (size.x - 1.0), origin + acrossRows * (size.y - 1.0)})
      sameLattice = sameLattice && isVoxelCentre(glm::dvec3(indexFromWorld * glm::dvec4(corner, 1.0)));
  warnOfPlacement(header.file.path, labelledVoxels(planes.values), labelledVoxels(result), sameLattice, warnings);
  return result;
}

}  // namespace

std::string segmentName(DcmItem& segment, DcmDataset& dataset) {
  for (const DcmTagKey& tag : {DCM_SegmentLabel, DCM_SegmentDescription})
    if (std::string name = typedTextOf(segment, tag, &dataset); !name.empty()) return name;
  DcmItem* type = firstItem(&segment, DCM_SegmentedPropertyTypeCodeSequence);
  return type ? typedTextOf(*type, DCM_CodeMeaning, &dataset) : std::string();
}

LabelsOnGrid readSegmentation(DcmDataset& dataset, const fs::path& path, const Grid& target, const Progress& progress) {
  Header header;
  header.file.path = path;
  header.type = typeOf(dataset, path);
  readFormat(dataset, header);
  header.labels = segmentsOf(dataset, path);
  readFrames(dataset, header);
  LabelsOnGrid read;
  LabelPlanes planes = planesOf(header);
  paint(header, progress, planes, read.warnings);
  read.values = onGrid(header, planes, target, read.warnings);
  if (header.type == Type::Fractional)
    read.warnings.push_back(
        {Warning::Kind::Other, "its segments are fractional; a voxel belongs to a segment from one half on", {path}});
  read.labels = std::move(header.labels);
  return read;
}

}  // namespace fenestra::io
