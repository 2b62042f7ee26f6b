// Analyze 7.5 (.hdr with .img), either byte order. Definition: "ANALYZE 7.5 File Format", Mayo Clinic, whose struct dsr
// has the offsets below; NIfTI-1 kept those of the first 148 bytes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>

#include "io/formats/ImageFile.h"
#include "io/formats/NiftiParts.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr std::int32_t headerBytes = 348;

/// Fields by their offsets in bytes.
class Header {
 public:
  explicit Header(const FileStart& start) {
    const std::span<const std::byte> first = start.unpacked();
    got_ = std::min(first.size(), bytes_.size());
    std::copy_n(first.begin(), got_, bytes_.begin());
    swapped_ = at<std::int32_t>(0) != headerBytes;
  }

  template <class T>
  T at(std::size_t offset) const {
    T value{};
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return swapped_ ? byteSwapped(value) : value;
  }
  /// The format has no signature: its size field must hold, and the fields that every file needs.
  bool isAnalyze() const {
    return got_ == bytes_.size() && at<std::int32_t>(0) == headerBytes && rank() >= 1 && rank() <= 7 && dim()[1] > 0 &&
           niftiElementType(datatype()).has_value();
  }
  int rank() const { return at<std::int16_t>(40); }
  std::array<std::int64_t, 8> dim() const {
    std::array<std::int64_t, 8> stored{};
    for (std::size_t axis = 0; axis < stored.size(); ++axis) stored[axis] = at<std::int16_t>(40 + 2 * axis);
    return stored;
  }
  /// As text, up to its first NUL: "mm", "um", or nothing.
  std::string unit() const {
    const std::string stored(reinterpret_cast<const char*>(bytes_.data()) + 56, 4);
    return stored.substr(0, stored.find('\0'));
  }
  int datatype() const { return at<std::int16_t>(70); }
  double spacing(int axis) const { return at<float>(76 + 4 * static_cast<std::size_t>(axis)); }
  double voxelOffset() const { return at<float>(108); }
  double slope() const { return at<float>(112); }  ///< SPM's; 0 elsewhere
  int orientation() const { return std::to_integer<int>(bytes_[252]); }
  /// SPM's voxel at the origin, counted from 1; 0 elsewhere.
  glm::ivec3 originVoxel() const { return {at<std::int16_t>(253), at<std::int16_t>(255), at<std::int16_t>(257)}; }
  bool bigEndian() const { return swapped_ != (std::endian::native == std::endian::big); }

 private:
  std::array<std::byte, headerBytes> bytes_{};
  std::size_t got_ = 0;
  bool swapped_ = false;
};

/// LPS directions of the image's axes for each value of "orient"; the header's `hist.orient` counts them from 0.
constexpr std::array<glm::dmat3, 6> axes{
    glm::dmat3{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},   // transverse
    glm::dmat3{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},   // coronal
    glm::dmat3{{0, -1, 0}, {0, 0, 1}, {1, 0, 0}},   // sagittal
    glm::dmat3{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},    // transverse, flipped
    glm::dmat3{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},  // coronal, flipped
    glm::dmat3{{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}}   // sagittal, flipped
};

void readGeometry(ImageFile& image, const Header& header) {
  const int orientation = header.orientation();
  glm::dmat3 columns = axes[orientation < static_cast<int>(axes.size()) ? static_cast<std::size_t>(orientation) : 0];
  const double unit = millimetresOf(image, header.unit());
  std::string assumed;
  for (int axis = 0; axis < 3; ++axis) {
    double spacing = std::abs(header.spacing(axis + 1));
    if (!std::isfinite(spacing) || spacing == 0.0) {
      spacing = 1.0;
      assumed = "; voxel sizes that are missing are taken as 1 mm";
    } else {
      spacing *= unit;
    }
    columns[axis] *= spacing;
  }
  const glm::ivec3 voxel = header.originVoxel();
  const bool inside =
      glm::all(glm::greaterThan(voxel, glm::ivec3(0))) && glm::all(glm::lessThanEqual(voxel, image.grid.dims));
  const glm::dvec3 origin = inside ? -(columns * glm::dvec3(voxel - 1)) : glm::dvec3(0.0);
  if (!setGeometry(image.grid, columns, origin))
    throw Error(image.path, "its voxel sizes cannot be used", "the header is damaged");
  image.warnings.push_back({Warning::Kind::NoGeometry,
                            "Analyze files do not say which side is left; the first axis is taken as the format's " +
                                std::string("description has it (right to left when transverse)") + assumed,
                            {image.path}});
}

fs::path headerOf(const fs::path& path) { return isPairImage(path) ? pairPartner(path, ".hdr") : path; }

}  // namespace

bool looksLikeAnalyze(const FileStart& start) {
  const fs::path header = headerOf(start.path());
  std::error_code unknown;
  if (!fs::is_regular_file(header, unknown) || pairPartner(header, ".img") == header) return false;
  return header == start.path() ? Header(start).isAnalyze() : Header(FileStart(header)).isAnalyze();
}

ImageFile readAnalyzeHeader(const fs::path& path) {
  const fs::path headerPath = headerOf(path);
  const Header header{FileStart(headerPath)};
  if (!header.isAnalyze()) throw Error(headerPath, "has no Analyze header", "the file is damaged or no Analyze file");
  ImageFile image;
  image.path = path;
  image.format = "Analyze";
  image.type = *niftiElementType(header.datatype());
  image.bigEndian = header.bigEndian();
  const std::array<std::int64_t, 8> lengths = axisLengths(image, header.dim());
  setDims(image, lengths[1], lengths[2], lengths[3]);
  for (std::size_t axis = 4; axis < lengths.size(); ++axis) image.volumes *= lengths[axis];
  readGeometry(image, header);
  if (std::isfinite(header.slope()) && header.slope() != 0.0) image.slope = header.slope();
  const double offset = header.voxelOffset();
  // A negative offset stands before each volume (struct dsr); none of the programs that write the format do so.
  if (!std::isfinite(offset) || offset < 0.0 || offset > 9e15)
    throw Error(image.path, "its header gives no voxel offset", "the header is damaged");
  image.source.skip = static_cast<std::int64_t>(offset);
  setVoxelFile(image, pairPartner(headerPath, ".img"));
  return image;
}

}  // namespace fenestra::io
