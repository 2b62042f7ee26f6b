// NIfTI-1 and NIfTI-2, single files and pairs, either byte order. Definitions: nifti1.h and nifti2.h of nifti_clib,
// whose structs are used and whose functions are not: they print to the error stream, and share their names with ITK's.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>

#include <nifti1.h>
#include <nifti2.h>
#include <glm/gtc/quaternion.hpp>

#include "io/base/Memory.h"
#include "io/formats/ImageFile.h"
#include "io/formats/NiftiParts.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// The word for a header's xyzt_units; empty where it names no unit.
std::string unitNamed(int units) {
  const int space = XYZT_TO_SPACE(units);
  switch (space) {
    case NIFTI_UNITS_UNKNOWN:
      return {};
    case NIFTI_UNITS_METER:
      return "m";
    case NIFTI_UNITS_MM:
      return "mm";
    case NIFTI_UNITS_MICRON:
      return "um";
    default:
      return "number " + std::to_string(space);
  }
}

/// NIfTI's world is RAS, ours is LPS.
bool setRasGeometry(Grid& grid, glm::dmat4 rasFromIndex, double unit) {
  const glm::dmat4 lpsFromRas = glm::dmat4(glm::dvec4(-unit, 0, 0, 0), glm::dvec4(0, -unit, 0, 0),
                                           glm::dvec4(0, 0, unit, 0), glm::dvec4(0, 0, 0, 1));
  const glm::dmat4 affine = lpsFromRas * rasFromIndex;
  return setGeometry(grid, glm::dmat3(affine), glm::dvec3(affine[3]));
}

bool isOneOf(const char* magic, const char* pair, const char* single) {
  return std::strncmp(magic, pair, 4) == 0 || std::strncmp(magic, single, 4) == 0;
}

/// A header of either version, whose fields have the same names in different types and places.
template <class Header>
class Interpreter {
 public:
  Interpreter(const Header& header, bool swapped, ImageFile& image)
      : header_(header), swapped_(swapped), image_(image) {}

  void interpret() {
    readType();
    readDims();
    readGeometry();
    // "If the scl_slope field is nonzero, then each voxel value in the dataset should be scaled" (nifti1.h).
    const double slope = real(header_.scl_slope), intercept = real(header_.scl_inter);
    if (!std::isfinite(slope) || (slope != 0.0 && !std::isfinite(intercept))) {
      warn(Warning::Kind::Other, "its scl_slope or scl_inter is no number; values are shown as stored");
    } else if (slope != 0.0) {
      image_.slope = slope;
      image_.intercept = intercept;
    }
    // 2^53: beyond it a double, and any file, holds no offset.
    const double offset = real(header_.vox_offset);
    if (!std::isfinite(offset) || offset > 9e15)
      throw Error(image_.path, "its header gives no voxel offset", "the header is damaged");
    // Single files keep 4 bytes for the extension flag behind the header; a smaller offset points into the header.
    image_.source.skip = static_cast<std::int64_t>(std::max(offset, isPair() ? 0.0 : sizeof(Header) + 4.0));
  }
  bool isPair() const { return header_.magic[1] == 'i'; }

 private:
  template <class T>
  T field(T value) const {
    return swapped_ ? byteSwapped(value) : value;
  }
  template <class T>
  double real(T value) const {
    return static_cast<double>(field(value));
  }

  void readType() {
    const int datatype = field(header_.datatype);
    const auto type = niftiElementType(datatype);
    if (!type)
      throw Error(image_.path,
                  datatype == DT_RGB24 || datatype == DT_RGBA32
                      ? "holds colours"
                      : "has voxels of NIfTI data type " + std::to_string(datatype),
                  "only scalar volumes can be opened; extract one component first");
    image_.type = *type;
  }

  void readDims() {
    const auto rank = static_cast<std::int64_t>(field(header_.dim[0]));
    if (rank < 1 || rank > 7)
      throw Error(image_.path, "its header gives " + std::to_string(rank) + " dimensions", "the header is damaged");
    std::array<std::int64_t, 8> stored{};
    for (std::size_t axis = 0; axis < stored.size(); ++axis)
      stored[axis] = static_cast<std::int64_t>(field(header_.dim[axis]));
    const std::array<std::int64_t, 8> dim = axisLengths(image_, stored);
    setDims(image_, dim[1], dim[2], dim[3]);
    if (dim[5] > 1)
      throw Error(image_.path, "holds vectors of " + std::to_string(dim[5]) + " components",
                  "only scalar volumes can be opened; extract one component first");
    const std::uint64_t volumes =
        saturatingProduct(saturatingProduct(static_cast<std::uint64_t>(dim[4]), static_cast<std::uint64_t>(dim[6])),
                          static_cast<std::uint64_t>(dim[7]));
    if (volumes > 1'000'000)
      throw Error(image_.path, "its header gives over a million time points", "the header is damaged");
    image_.volumes = static_cast<std::int64_t>(volumes);
  }

  void warn(Warning::Kind kind, const std::string& text) { image_.warnings.push_back({kind, text, {image_.path}}); }

  /// pixdim, made positive; 1 where it is no positive number.
  glm::dvec3 readSpacing() {
    glm::dvec3 spacing(1.0);
    bool garbled = false, negative = false;
    for (int axis = 0; axis < 3; ++axis) {
      const double given = real(header_.pixdim[axis + 1]);
      const bool usable = std::isfinite(given) && given != 0.0;
      // A file of fewer dimensions has no spacing along the others.
      garbled |= !usable && image_.grid.dims[axis] > 1;
      negative |= usable && given < 0.0;
      if (usable) spacing[axis] = std::abs(given);
    }
    if (garbled)
      warn(Warning::Kind::NoGeometry, "its pixdim is not three positive numbers; 1 mm is assumed for the others");
    if (negative) warn(Warning::Kind::NoGeometry, "its pixdim is negative; the sign is ignored");
    return spacing;
  }

  /// World from index as the sform or qform gives it; false when it is unusable.
  bool useSform(double unit) {
    glm::dmat4 rasFromIndex(1.0);
    for (int column = 0; column < 4; ++column) {
      // Element by element: the version 2 header is packed, so that a pointer to its rows would be misaligned.
      rasFromIndex[column].x = real(header_.srow_x[column]);
      rasFromIndex[column].y = real(header_.srow_y[column]);
      rasFromIndex[column].z = real(header_.srow_z[column]);
    }
    return setRasGeometry(image_.grid, rasFromIndex, unit);
  }
  bool useQform(const glm::dmat3& scale, double unit) {
    // Method 2 of nifti1.h: a unit quaternion whose first part is implied, and the third axis' sign.
    const glm::dvec3 imaginary(real(header_.quatern_b), real(header_.quatern_c), real(header_.quatern_d));
    const double rest = 1.0 - glm::dot(imaginary, imaginary);
    glm::dquat rotation(std::sqrt(std::max(rest, 0.0)), imaginary);
    rotation = glm::normalize(rotation);
    glm::dmat4 rasFromIndex(glm::mat3_cast(rotation) * scale);
    if (real(header_.pixdim[0]) < 0.0) rasFromIndex[2] = -rasFromIndex[2];
    rasFromIndex[3] = glm::dvec4(real(header_.qoffset_x), real(header_.qoffset_y), real(header_.qoffset_z), 1.0);
    return setRasGeometry(image_.grid, rasFromIndex, unit);
  }

  void readGeometry() {
    const double unit = millimetresOf(image_, unitNamed(field(header_.xyzt_units)));
    const bool hasSform = field(header_.sform_code) > 0, hasQform = field(header_.qform_code) > 0;
    if (hasSform && useSform(unit)) return;
    const glm::dvec3 spacing = readSpacing();
    const glm::dmat3 scale(spacing.x, 0, 0, 0, spacing.y, 0, 0, 0, spacing.z);
    const bool usedQform = hasQform && useQform(scale, unit);
    if (hasSform)
      warn(Warning::Kind::NoGeometry, std::string("its sform is not three independent axes; ") +
                                          (usedQform ? "the qform takes its place" : "it is ignored"));
    if (usedQform) return;
    if (hasQform) warn(Warning::Kind::NoGeometry, "its qform is no rotation with a position; it is ignored");
    // Method 1: no orientation is stored, the axes are taken as right, anterior, superior.
    if (!setRasGeometry(image_.grid, glm::dmat4(scale), unit))
      throw Error(image_.path, "its header gives no voxel size", "the header is damaged");
    warn(Warning::Kind::NoGeometry, "the file stores no orientation; its axes are taken as right, anterior, superior");
  }

  const Header& header_;
  bool swapped_;
  ImageFile& image_;
};

struct Headers {
  bool swapped = false;
  std::optional<nifti_1_header> one;
  std::optional<nifti_2_header> two;
};

static_assert(FileStart::mostBytes >= sizeof(nifti_2_header));

/// The header as stored; empty when it is neither version's.
std::optional<Headers> headersIn(const FileStart& start) {
  std::array<std::byte, sizeof(nifti_2_header)> bytes{};
  const std::span<const std::byte> first = start.unpacked();
  const std::size_t got = std::min(first.size(), bytes.size());
  std::copy_n(first.begin(), got, bytes.begin());
  std::int32_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  Headers headers;
  headers.swapped = size != sizeof(nifti_1_header) && size != sizeof(nifti_2_header);
  if (headers.swapped) size = byteSwapped(size);
  if (size == sizeof(nifti_1_header) && got >= sizeof(nifti_1_header)) {
    nifti_1_header& one = headers.one.emplace();
    std::memcpy(&one, bytes.data(), sizeof one);
    if (isOneOf(one.magic, "ni1", "n+1")) return headers;
  } else if (size == sizeof(nifti_2_header) && got == sizeof(nifti_2_header)) {
    nifti_2_header& two = headers.two.emplace();
    std::memcpy(&two, bytes.data(), sizeof two);
    if (isOneOf(two.magic, "ni2", "n+2")) return headers;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ElementType> niftiElementType(int datatype) {
  switch (datatype) {
    case DT_UINT8:
      return ElementType::UInt8;
    case DT_INT8:
      return ElementType::Int8;
    case DT_UINT16:
      return ElementType::UInt16;
    case DT_INT16:
      return ElementType::Int16;
    case DT_UINT32:
      return ElementType::UInt32;
    case DT_INT32:
      return ElementType::Int32;
    case DT_UINT64:
      return ElementType::UInt64;
    case DT_INT64:
      return ElementType::Int64;
    case DT_FLOAT32:
      return ElementType::Float32;
    case DT_FLOAT64:
      return ElementType::Float64;
    default:
      return std::nullopt;
  }
}

std::array<std::int64_t, 8> axisLengths(ImageFile& image, const std::array<std::int64_t, 8>& dim) {
  std::array<std::int64_t, 8> lengths;
  lengths.fill(1);
  const auto rank = static_cast<std::size_t>(dim[0]);
  std::copy_n(dim.begin(), rank + 1, lengths.begin());
  std::string assumed;
  for (std::size_t axis = rank; axis >= 3 && (lengths[axis] == 0 || lengths[axis] == 1); --axis)
    if (lengths[axis] == 0) {
      lengths[axis] = 1;
      assumed = std::to_string(axis) + (assumed.empty() ? "" : ", " + assumed);
    }
  if (!assumed.empty())
    image.warnings.push_back(
        {Warning::Kind::Other, "its header gives length 0 for dimension " + assumed + "; 1 is assumed", {image.path}});
  if (std::any_of(lengths.begin() + 4, lengths.end(), [](std::int64_t length) { return length < 1; }))
    throw Error(image.path, "its header gives a dimension of no length", "the header is damaged");
  return lengths;
}

fs::path pairPartner(const fs::path& path, const std::string& extension) {
  fs::path stem = path;
  if (stem.extension() == ".gz") stem.replace_extension();
  fs::path plain = stem, packed = stem;
  plain.replace_extension(extension);
  packed.replace_extension(extension + ".gz");
  std::error_code unknown;
  return fs::exists(packed, unknown) && !fs::exists(plain, unknown) ? packed : plain;
}

bool isPairImage(const fs::path& path) {
  return path.extension() == ".img" || (path.extension() == ".gz" && path.stem().extension() == ".img");
}

void setVoxelFile(ImageFile& image, const fs::path& file) {
  std::error_code unknown;
  if (!fs::exists(file, unknown)) throw Error(file, "does not exist", "a .hdr file needs the .img file beside it");
  image.source.files = {file};
  image.source.packing = isGzip(file) ? Packing::Deflate : Packing::None;
}

bool looksLikeNifti(const FileStart& start) {
  if (!isPairImage(start.path())) return headersIn(start).has_value();
  const fs::path header = pairPartner(start.path(), ".hdr");
  std::error_code unknown;
  return fs::is_regular_file(header, unknown) && headersIn(FileStart(header)).has_value();
}

ImageFile readNiftiHeader(const fs::path& path) {
  ImageFile image;
  image.path = path;
  image.format = "NIfTI";
  const fs::path headerPath = isPairImage(path) ? pairPartner(path, ".hdr") : path;
  const auto headers = headersIn(FileStart(headerPath));
  if (!headers) throw Error(headerPath, "has no NIfTI header", "the file is damaged or no NIfTI file");

  const auto interpret = [&](const auto& header) {
    Interpreter interpreter(header, headers->swapped, image);
    interpreter.interpret();
    return interpreter.isPair();
  };
  const bool pair = headers->one ? interpret(*headers->one) : interpret(*headers->two);
  image.bigEndian = headers->swapped != (std::endian::native == std::endian::big);
  setVoxelFile(image, pair ? pairPartner(headerPath, ".img") : headerPath);
  return image;
}

}  // namespace fenestra::io
