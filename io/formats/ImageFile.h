#pragma once
// What a volume file's header says, the same for every format, and how its voxels are read.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/base/ByteStream.h"
#include "io/base/FileStart.h"
#include "io/base/LabelReading.h"
#include "io/base/Reading.h"
#include "io/base/VoxelSink.h"

namespace fenestra::io {

/// Voxels written as text.
enum class VoxelText : std::uint8_t {
  None,        ///< they are bytes
  Decimal,     ///< numbers
  Hexadecimal  ///< two digits a byte
};

/// Where the voxels are: `files` one after the other, each holding an equal share of them.
struct VoxelSource {
  static constexpr std::int64_t atEnd = -1;

  std::vector<std::filesystem::path> files;
  std::uint64_t offset = 0;  ///< bytes in each file before anything else (an attached header)
  std::uint64_t lines = 0;   ///< lines after them to skip
  std::int64_t skip = 0;     ///< then bytes to skip, of the unpacked data; atEnd: the voxels are the last bytes
  Packing packing = Packing::None;
  VoxelText text = VoxelText::None;
  /// Where the voxels are no stretch of bytes of the files: opens all of them, in this machine's byte order, from a
  /// byte on. The reader of the header has checked that the files can hold them.
  std::function<std::unique_ptr<ByteStream>(std::uint64_t begin)> open = {};
};

struct ImageFile {
  std::filesystem::path path;
  std::string format;  ///< as OpenedVolume::format
  Grid grid;
  ElementType type = ElementType::UInt8;
  bool bigEndian = false;
  double slope = 1.0, intercept = 0.0;  ///< real value = slope · stored + intercept
  std::int64_t interleaved = 1;         ///< scalars at each voxel, one of each layer
  std::int64_t volumes = 1;             ///< volumes one after the other
  Modality modality = Modality::Unknown;
  std::vector<Warning> warnings;
  std::string missingSpacing;                 ///< why the size of voxels has to be asked for; empty: it is known
  std::string unknownUnit;                    ///< of length, read as millimetres; empty: there is none
  std::map<std::string, std::string> fields;  ///< the file's own key/value pairs (NRRD)
  VoxelSource source;

  std::int64_t layers() const { return interleaved * volumes; }
};

/// Sets the grid's dims, checked: all in 1..2^31-1. Throws Error.
void setDims(ImageFile& image, std::int64_t x, std::int64_t y, std::int64_t z);
/// Sets spacing, direction and origin from the columns of an affine (world LPS mm from index). Returns false, and
/// leaves the grid, when the columns are not three finite independent vectors.
bool setGeometry(Grid& grid, const glm::dmat3& columns, const glm::dvec3& origin);
/// `unit`'s length in mm. Where the word is unknown, warns that lengths are read as millimetres; checkGeometry() names
/// the unit then.
double millimetresOf(ImageFile& image, std::string_view unit);
/// Numbers of the header's field `name`, also with decimal commas, which a warning then tells; empty unless every word
/// is a number.
std::optional<std::vector<double>> headerNumbers(ImageFile& image, const std::string& name, const std::string& text);
/// "name%03d.raw" with a number in place of the one integer conversion. Throws Error (naming `header`) for other
/// patterns.
std::string numberedName(const std::string& pattern, long number, const std::filesystem::path& header);
/// `name` as a header at `header` means it: relative to the header's folder.
std::filesystem::path besideHeader(const std::filesystem::path& header, const std::string& name);

bool looksLikeNifti(const FileStart& start);
bool looksLikeNrrd(const FileStart& start);
bool looksLikeMetaImage(const FileStart& start);
bool looksLikeMgh(const FileStart& start);
bool looksLikeTiff(const FileStart& start);
/// Whether a folder holds files that are named as TIFF.
bool hasTiffFiles(const std::filesystem::path& folder);
bool looksLikeAnalyze(const FileStart& start);

/// Each reads the header alone and throws Error for what cannot become a scalar volume.
ImageFile readNiftiHeader(const std::filesystem::path& path);
ImageFile readNrrdHeader(const std::filesystem::path& path);
ImageFile readMetaImageHeader(const std::filesystem::path& path);
ImageFile readMghHeader(const std::filesystem::path& path);
ImageFile readAnalyzeHeader(const std::filesystem::path& path);
/// The label table in the extensions of a NIfTI header; empty where there is none. Labels may have noColour. `image` is
/// what readNiftiHeader() gave.
std::vector<Label> niftiLabels(const ImageFile& image);
/// A TIFF file, or a folder of numbered ones. `spacing` as in OpenOptions.
ImageFile readTiffHeader(const std::filesystem::path& path, const std::optional<glm::dvec3>& spacing);
ImageFile describeRaw(const std::filesystem::path& path, const RawDescription& description);

/// Throws Error when the geometry is not plausible.
void checkGeometry(const ImageFile& image);

/// Throws Error when the header names voxel files that are neither in its own folder nor below it: a header from a
/// stranger could name any file of the machine.
void refuseOutside(const ImageFile& image);

struct Layers {
  std::int64_t first = 0, count = 1;
};
/// Reads these layers, one Voxels each, in the narrowest types. Checks the sizes against the files before anything is
/// allocated. Adds to `warnings`. Throws Error, Cancelled.
std::vector<Voxels> readVoxels(const ImageFile& image, Layers layers, const Progress& progress,
                               std::vector<Warning>& warnings);

/// `value` with its bytes in the other order.
template <class T>
T byteSwapped(T value) {
  auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

}  // namespace fenestra::io
