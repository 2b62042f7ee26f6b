#include "io/VolumeWriter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iomanip>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <vector>

#include <nifti1.h>
#include <nifti2.h>
#include <zlib.h>
#include <glm/gtc/quaternion.hpp>

#include "io/base/AtomicFile.h"
#include "io/base/ByteStream.h"
#include "io/base/Text.h"
#include "io/base/VoxelSink.h"
#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t blockVoxels = 1u << 20;

/// The narrowest type that holds every real value exactly. Values that a scaling makes fractional are float32: their
/// stored integers have fewer digits than it keeps.
ScalarType narrowestType(const Volume& volume) {
  bool whole = true, exactFloat = true;
  double low = 0.0, high = 0.0;
  std::mutex mutex;
  volume.voxels.visit([&](auto scalars) {
    parallelFor(scalars.size(), blockVoxels, [&](std::size_t begin, std::size_t end) {
      bool allWhole = true, allExact = true;
      double least = 0.0, greatest = 0.0;
      for (std::size_t i = begin; i < end; ++i) {
        const double real = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
        allWhole = allWhole && real == std::floor(real) && std::isfinite(real);
        if (!std::isfinite(real)) continue;
        allExact = allExact && std::abs(real) <= std::numeric_limits<float>::max() &&
                   static_cast<double>(static_cast<float>(real)) == real;
        least = std::min(least, real);
        greatest = std::max(greatest, real);
      }
      const std::scoped_lock lock(mutex);
      whole = whole && allWhole;
      exactFloat = exactFloat && allExact;
      low = std::min(low, least);
      high = std::max(high, greatest);
    });
  });
  if (whole && low >= -2147483648.0 && high <= 4294967295.0) {
    const ScalarType type = narrowestInteger(static_cast<std::int64_t>(low), static_cast<std::uint64_t>(high));
    if (type != ScalarType::Float64) return type;
  }
  const bool fractional = volume.voxels.type() != ScalarType::Float64 && !whole;
  return exactFloat || fractional ? ScalarType::Float32 : ScalarType::Float64;
}

/// Calls write(bytes, size) with the real values as `type` in this machine's byte order, block by block.
void forEachBlock(const Volume& volume, ScalarType type,
                  const std::function<void(const std::byte*, std::size_t)>& write) {
  const std::size_t count = volume.voxels.count();
  for (std::size_t begin = 0; begin < count; begin += blockVoxels) {
    const std::size_t size = std::min(blockVoxels, count - begin);
    Voxels block(type, size);
    volume.voxels.visit([&](auto scalars) {
      std::as_const(block).visit([&](auto target) {
        using To = std::remove_const_t<typename decltype(target)::element_type>;
        To* to = block.as<To>().data();
        for (std::size_t i = 0; i < size; ++i)
          to[i] = static_cast<To>(volume.slope * static_cast<double>(scalars[begin + i]) + volume.intercept);
      });
    });
    write(block.data(), block.byteCount());
  }
}

class Output {
 public:
  enum class Mode { Plain, Gzip, GzipAtEnd };
  Output(const fs::path& path, Mode mode) : path_(path) {
    // Level 1: volumes are written while someone waits, and noise hardly shrinks further.
    file_ = ::gzopen(path.c_str(), mode == Mode::Plain ? "wbT" : mode == Mode::Gzip ? "wb1" : "ab1");
    if (!file_) throw Error(path, "cannot be written: " + systemCause(), "check the folder and its permissions");
    ::gzbuffer(file_, 256 * 1024);
  }
  ~Output() {
    if (file_) ::gzclose(file_);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  void write(const void* bytes, std::size_t size) {
    if (size > 0 && ::gzwrite(file_, bytes, static_cast<unsigned>(size)) != static_cast<int>(size)) fail();
  }
  void close() {
    gzFile file = file_;
    file_ = nullptr;
    if (::gzclose(file) != Z_OK) fail();
  }

 private:
  [[noreturn]] void fail() {
    throw Error(path_, "cannot be written: " + systemCause(), "check the free space on the disk");
  }
  fs::path path_;
  gzFile file_ = nullptr;
};

constexpr bool bigEndian = std::endian::native == std::endian::big;

/// Seventeen digits bring every double back exactly.
std::ostringstream exactText() {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(17);
  return text;
}

std::string metaImageHeader(const Grid& grid, ScalarType type, const NrrdOptions&) {
  const auto name = [&] {
    switch (type) {
      case ScalarType::UInt8:
        return "MET_UCHAR";
      case ScalarType::Int8:
        return "MET_CHAR";
      case ScalarType::UInt16:
        return "MET_USHORT";
      case ScalarType::Int16:
        return "MET_SHORT";
      case ScalarType::UInt32:
        return "MET_UINT";
      case ScalarType::Int32:
        return "MET_INT";
      case ScalarType::Float32:
        return "MET_FLOAT";
      case ScalarType::Float64:
        break;
    }
    return "MET_DOUBLE";
  };
  auto text = exactText();
  text << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = "
       << (bigEndian ? "True" : "False") << "\nCompressedData = False\nTransformMatrix =";
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row) text << ' ' << grid.direction[axis][row];
  text << "\nOffset = " << grid.origin.x << ' ' << grid.origin.y << ' ' << grid.origin.z
       << "\nCenterOfRotation = 0 0 0\nElementSpacing = " << grid.spacing.x << ' ' << grid.spacing.y << ' '
       << grid.spacing.z << "\nDimSize = " << grid.dims.x << ' ' << grid.dims.y << ' ' << grid.dims.z
       << "\nElementType = " << name() << "\nElementDataFile = LOCAL\n";
  return text.str();
}

std::string nrrdHeader(const Grid& grid, ScalarType type, const NrrdOptions& options) {
  const char* name = type == ScalarType::Float32 ? "float" : type == ScalarType::Float64 ? "double" : nameOf(type);
  auto text = exactText();
  const auto vector = [&](const glm::dvec3& v) { text << " (" << v.x << ',' << v.y << ',' << v.z << ')'; };
  text << "NRRD0004\ntype: " << name << "\ndimension: 3\nspace: left-posterior-superior\nsizes: " << grid.dims.x << ' '
       << grid.dims.y << ' ' << grid.dims.z << "\nspace directions:";
  for (int axis = 0; axis < 3; ++axis) vector(grid.direction[axis] * grid.spacing[axis]);
  text << "\nkinds: domain domain domain\nendian: " << (bigEndian ? "big" : "little")
       << "\nencoding: " << (options.packNrrd ? "gzip" : "raw") << "\nspace origin:";
  vector(grid.origin);
  text << '\n';
  for (const auto& [key, value] : options.nrrdFields) text << key << ":=" << value << '\n';
  text << '\n';
  return text.str();
}

int niftiType(ScalarType type) {
  switch (type) {
    case ScalarType::UInt8:
      return DT_UINT8;
    case ScalarType::Int8:
      return DT_INT8;
    case ScalarType::UInt16:
      return DT_UINT16;
    case ScalarType::Int16:
      return DT_INT16;
    case ScalarType::UInt32:
      return DT_UINT32;
    case ScalarType::Int32:
      return DT_INT32;
    case ScalarType::Float32:
      return DT_FLOAT32;
    case ScalarType::Float64:
      break;
  }
  return DT_FLOAT64;
}

bool isOrthonormal(const glm::dmat3& direction) {
  const glm::dmat3 product = glm::transpose(direction) * direction;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (std::abs(product[column][row] - (column == row ? 1.0 : 0.0)) > 1e-6) return false;
  return true;
}

template <class Header>
void fillNifti(Header& header, const Grid& grid, ScalarType type) {
  using Length = std::remove_reference_t<decltype(header.dim[0])>;
  using Real = std::remove_reference_t<decltype(header.pixdim[0])>;
  header.sizeof_hdr = sizeof(Header);
  header.dim[0] = 3;
  for (int axis = 0; axis < 7; ++axis)
    header.dim[axis + 1] = axis < 3 ? static_cast<Length>(grid.dims[axis]) : Length{1};
  header.datatype = static_cast<short>(niftiType(type));
  header.bitpix = static_cast<short>(8 * sizeOf(type));
  header.scl_slope = 1;
  header.xyzt_units = NIFTI_UNITS_MM;
  // NIfTI's world is RAS, ours is LPS.
  glm::dmat4 ras = grid.worldFromIndex();
  for (int column = 0; column < 4; ++column) {
    ras[column].x = 0.0 - ras[column].x;  // not -x: zeros stay without a sign
    ras[column].y = 0.0 - ras[column].y;
    header.srow_x[column] = static_cast<Real>(ras[column].x);
    header.srow_y[column] = static_cast<Real>(ras[column].y);
    header.srow_z[column] = static_cast<Real>(ras[column].z);
  }
  header.sform_code = NIFTI_XFORM_SCANNER_ANAT;
  for (int axis = 0; axis < 3; ++axis) header.pixdim[axis + 1] = static_cast<Real>(grid.spacing[axis]);
  // A quaternion holds no shear: sheared volumes have the sform alone.
  if (!isOrthonormal(grid.direction)) return;
  glm::dmat3 rotation(ras[0] / grid.spacing.x, ras[1] / grid.spacing.y, ras[2] / grid.spacing.z);
  const bool mirrored = glm::determinant(rotation) < 0.0;
  if (mirrored) rotation[2] = -rotation[2];
  glm::dquat quaternion = glm::quat_cast(rotation);
  // The first part is not stored but implied to be positive.
  if (quaternion.w < 0.0) quaternion = -quaternion;
  header.qform_code = NIFTI_XFORM_SCANNER_ANAT;
  header.quatern_b = static_cast<Real>(quaternion.x);
  header.quatern_c = static_cast<Real>(quaternion.y);
  header.quatern_d = static_cast<Real>(quaternion.z);
  header.qoffset_x = static_cast<Real>(ras[3].x);
  header.qoffset_y = static_cast<Real>(ras[3].y);
  header.qoffset_z = static_cast<Real>(ras[3].z);
  header.pixdim[0] = static_cast<Real>(mirrored ? -1.0 : 1.0);
}

/// NIfTI-1, or NIfTI-2 where an axis is longer than NIfTI-1's 16-bit sizes.
std::string niftiHeader(const Grid& grid, ScalarType type, const NrrdOptions&) {
  constexpr int longestAxis = 32767;
  constexpr std::string_view noExtension("\0\0\0\0", 4);
  std::string bytes;
  const auto append = [&](const auto& header) { bytes.assign(reinterpret_cast<const char*>(&header), sizeof header); };
  if (std::max({grid.dims.x, grid.dims.y, grid.dims.z}) <= longestAxis) {
    nifti_1_header header{};
    fillNifti(header, grid, type);
    header.vox_offset = sizeof header + noExtension.size();
    std::memcpy(header.magic, "n+1", 4);
    append(header);
  } else {
    nifti_2_header header{};
    fillNifti(header, grid, type);
    header.vox_offset = sizeof header + noExtension.size();
    std::memcpy(header.magic, "n+2\0\r\n\032\n", 8);
    append(header);
  }
  return bytes.append(noExtension);
}

using MakeHeader = std::string (*)(const Grid&, ScalarType, const NrrdOptions&);

/// By the file name's ending.
MakeHeader headerOf(const fs::path& path) {
  const std::string name = lowered(path.filename().string());
  if (name.ends_with(".mha")) return metaImageHeader;
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return niftiHeader;
  if (name.ends_with(".nrrd")) return nrrdHeader;
  throw Error(path, "has an ending that names no volume format", "end it in .mha, .nii.gz, .nii or .nrrd");
}

void write(const Volume& volume, const fs::path& path, ScalarType type, const NrrdOptions& options) {
  const std::string name = lowered(path.filename().string());
  const MakeHeader makeHeader = headerOf(path);
  writeAtomically(path, [&](const fs::path& temporary) {
    std::optional<Output> output(std::in_place, temporary,
                                 name.ends_with(".gz") ? Output::Mode::Gzip : Output::Mode::Plain);
    const std::string header = makeHeader(volume.grid, type, options);
    output->write(header.data(), header.size());
    if (makeHeader == nrrdHeader && options.packNrrd) {
      output->close();
      output.emplace(temporary, Output::Mode::GzipAtEnd);
    }
    forEachBlock(volume, type, [&](const std::byte* bytes, std::size_t size) { output->write(bytes, size); });
    output->close();
  });
}

}  // namespace

void writeVolume(const Volume& volume, const fs::path& path, const NrrdOptions& options) {
  headerOf(path);  // before the look at all voxels
  write(volume, path, narrowestType(volume), options);
}

void writeFloats(const Volume& volume, const fs::path& path) { write(volume, path, ScalarType::Float32, {}); }

}  // namespace fenestra::io
