// NIfTI-1 and NIfTI-2, single files and pairs, either byte order. Definitions: nifti1.h and nifti2.h of nifti_clib.

#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include <nifti2_io.h>

#include "io/ImageFile.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

std::optional<ElementType> elementType(int datatype) {
  switch (datatype) {
    case DT_UINT8: return ElementType::UInt8;
    case DT_INT8: return ElementType::Int8;
    case DT_UINT16: return ElementType::UInt16;
    case DT_INT16: return ElementType::Int16;
    case DT_UINT32: return ElementType::UInt32;
    case DT_INT32: return ElementType::Int32;
    case DT_UINT64: return ElementType::UInt64;
    case DT_INT64: return ElementType::Int64;
    case DT_FLOAT32: return ElementType::Float32;
    case DT_FLOAT64: return ElementType::Float64;
    default: return std::nullopt;
  }
}

double millimetres(int units) {
  switch (XYZT_TO_SPACE(units)) {
    case NIFTI_UNITS_METER: return 1000.0;
    case NIFTI_UNITS_MICRON: return 0.001;
    default: return 1.0;  // NIFTI_UNITS_MM, and files that name no unit
  }
}

/// NIfTI's world is RAS, ours is LPS.
bool setRasGeometry(Grid& grid, glm::dmat4 rasFromIndex, double unit) {
  const glm::dmat4 lpsFromRas = glm::dmat4(glm::dvec4(-unit, 0, 0, 0), glm::dvec4(0, -unit, 0, 0),
                                           glm::dvec4(0, 0, unit, 0), glm::dvec4(0, 0, 0, 1));
  const glm::dmat4 affine = lpsFromRas * rasFromIndex;
  return setGeometry(grid, glm::dmat3(affine), glm::dvec3(affine[3]));
}

/// The two versions' headers have the same fields in different types and places.
template <class Header>
void interpret(const Header& header, ImageFile& image) {
  const auto type = elementType(header.datatype);
  if (!type) {
    const bool colour = header.datatype == DT_RGB24 || header.datatype == DT_RGBA32;
    throw Error(image.path,
                colour ? "holds colours" : "has voxels of NIfTI data type " + std::to_string(header.datatype),
                "only scalar volumes can be opened; extract one component first");
  }
  image.type = *type;

  const auto rank = static_cast<std::int64_t>(header.dim[0]);
  if (rank < 1 || rank > 7)
    throw Error(image.path, "its header gives " + std::to_string(rank) + " dimensions", "the header is damaged");
  const auto dim = [&](int axis) { return axis <= rank ? static_cast<std::int64_t>(header.dim[axis]) : std::int64_t{1}; };
  setDims(image, dim(1), dim(2), dim(3));
  for (int axis = 4; axis <= 7; ++axis)
    if (dim(axis) < 1) throw Error(image.path, "its header gives a dimension of no length", "the header is damaged");
  if (dim(5) > 1)
    throw Error(image.path, "holds vectors of " + std::to_string(dim(5)) + " components",
                "only scalar volumes can be opened; extract one component first");
  const std::uint64_t volumes =
      saturatingProduct(saturatingProduct(static_cast<std::uint64_t>(dim(4)), static_cast<std::uint64_t>(dim(6))),
                        static_cast<std::uint64_t>(dim(7)));
  if (volumes > 1'000'000) throw Error(image.path, "its header gives over a million time points", "the header is damaged");
  image.volumes = static_cast<std::int64_t>(volumes);

  // "If the scl_slope field is nonzero, then each voxel value in the dataset should be scaled" (nifti1.h).
  const double slope = static_cast<double>(header.scl_slope), intercept = static_cast<double>(header.scl_inter);
  if (slope != 0.0 && std::isfinite(slope) && std::isfinite(intercept)) {
    image.slope = slope;
    image.intercept = intercept;
  }

  const double unit = millimetres(header.xyzt_units);
  glm::dvec3 spacing;
  for (int axis = 0; axis < 3; ++axis) {
    const double given = std::abs(static_cast<double>(header.pixdim[axis + 1]));
    spacing[axis] = std::isfinite(given) && given > 0.0 ? given : 1.0;
  }
  if (header.sform_code > 0) {
    const auto row = [](const auto* values) { return glm::dvec4(values[0], values[1], values[2], values[3]); };
    const glm::dmat4 rows(row(header.srow_x), row(header.srow_y), row(header.srow_z), glm::dvec4(0, 0, 0, 1));
    if (setRasGeometry(image.grid, glm::transpose(rows), unit)) return;
  }
  if (header.qform_code > 0) {
    const double qfac = header.pixdim[0] < 0 ? -1.0 : 1.0;
    const nifti_dmat44 q = nifti_quatern_to_dmat44(header.quatern_b, header.quatern_c, header.quatern_d, header.qoffset_x,
                                                   header.qoffset_y, header.qoffset_z, spacing.x, spacing.y, spacing.z, qfac);
    glm::dmat4 rasFromIndex(1.0);
    for (int column = 0; column < 4; ++column)
      for (int r = 0; r < 3; ++r) rasFromIndex[column][r] = q.m[r][column];
    if (setRasGeometry(image.grid, rasFromIndex, unit)) return;
  }
  // nifti1.h's method 1: no orientation is stored, the axes are taken as right, anterior, superior.
  setRasGeometry(image.grid, glm::dmat4(glm::dmat3(spacing.x, 0, 0, 0, spacing.y, 0, 0, 0, spacing.z)), unit);
  image.warnings.push_back({Warning::Kind::NoGeometry,
                            "the file stores no orientation; its axes are taken as right, anterior, superior",
                            {image.path}});
}

struct Headers {
  bool swapped = false;
  std::optional<nifti_1_header> one;
  std::optional<nifti_2_header> two;
};

/// The header at `path`, in this machine's byte order; empty when it is neither version's.
std::optional<Headers> readHeaders(const fs::path& path) {
  std::array<std::byte, sizeof(nifti_2_header)> bytes{};
  const std::size_t got = openMaybeGzip(path)->read(bytes.data(), bytes.size());
  nifti_2_header two;
  std::memcpy(&two, bytes.data(), sizeof two);
  Headers headers;
  headers.swapped = NIFTI2_NEEDS_SWAP(two);
  if (got >= sizeof(nifti_1_header)) {
    nifti_1_header one;
    std::memcpy(&one, bytes.data(), sizeof one);
    if (headers.swapped) nifti_swap_as_nifti1(&one);
    const bool pairOrSingle = std::strncmp(one.magic, "ni1", 4) == 0 || std::strncmp(one.magic, "n+1", 4) == 0;
    if (one.sizeof_hdr == sizeof(nifti_1_header) && pairOrSingle) {
      headers.one = one;
      return headers;
    }
  }
  if (got == sizeof two) {
    if (headers.swapped) nifti_swap_as_nifti2(&two);
    const bool pairOrSingle = std::strncmp(two.magic, "ni2", 4) == 0 || std::strncmp(two.magic, "n+2", 4) == 0;
    if (two.sizeof_hdr == static_cast<int>(sizeof two) && pairOrSingle) {
      headers.two = two;
      return headers;
    }
  }
  return std::nullopt;
}

/// The pair's other file: `path` with "hdr" in place of "img" or the other way, ".gz" kept or not, as it exists.
fs::path partner(const fs::path& path, const std::string& extension) {
  fs::path stem = path;
  if (stem.extension() == ".gz") stem.replace_extension();
  fs::path plain = stem, packed = stem;
  plain.replace_extension(extension);
  packed.replace_extension(extension + ".gz");
  return fs::exists(packed) && !fs::exists(plain) ? packed : plain;
}

bool isImg(const fs::path& path) {
  return path.extension() == ".img" || (path.extension() == ".gz" && path.stem().extension() == ".img");
}

}  // namespace

bool looksLikeNifti(const fs::path& path) {
  if (isImg(path)) {
    const fs::path header = partner(path, ".hdr");
    return fs::is_regular_file(header) && readHeaders(header).has_value();
  }
  return readHeaders(path).has_value();
}

ImageFile readNiftiHeader(const fs::path& path) {
  ImageFile image;
  image.path = path;
  image.format = "NIfTI";
  const fs::path headerPath = isImg(path) ? partner(path, ".hdr") : path;
  const auto headers = readHeaders(headerPath);
  if (!headers) throw Error(headerPath, "has no NIfTI header", "the file is damaged or no NIfTI file");

  double offset = 0.0;
  bool pair = false;
  if (headers->one) {
    interpret(*headers->one, image);
    offset = headers->one->vox_offset;
    pair = std::strncmp(headers->one->magic, "ni1", 4) == 0;
  } else {
    interpret(*headers->two, image);
    offset = static_cast<double>(headers->two->vox_offset);
    pair = std::strncmp(headers->two->magic, "ni2", 4) == 0;
  }
  // Single files keep 4 bytes for the extension flag behind the header; a smaller offset points into the header.
  const double least = pair ? 0.0 : headers->one ? 352.0 : 544.0;
  // 2^53: beyond it a double, and any file, holds no offset.
  if (!std::isfinite(offset) || offset > 9e15) throw Error(image.path, "its header gives no voxel offset", "the header is damaged");
  image.source.skip = static_cast<std::int64_t>(std::max(offset, least));
  image.bigEndian = headers->swapped != (std::endian::native == std::endian::big);
  const fs::path data = pair ? partner(headerPath, ".img") : headerPath;
  if (!fs::exists(data)) throw Error(data, "does not exist", "a .hdr file needs the .img file beside it");
  image.source.files = {data};
  image.source.packing = isGzip(data) ? Packing::Deflate : Packing::None;
  return image;
}

}  // namespace fenestra::io
