// FreeSurfer's MGH, plain (.mgh) or as gzip (.mgz, .mgh.gz). Definition: "MghFormat" of the FreeSurfer wiki; always
// big-endian.

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <span>

#include "io/formats/ImageFile.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t dataOffset = 284;  // 256 bytes for fields behind the first 28

struct Header {
  std::array<std::byte, dataOffset> bytes{};

  template <class T>
  T at(std::size_t offset) const {
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return std::endian::native == std::endian::big ? value : byteSwapped(value);
  }
  glm::dvec3 vector(std::size_t offset) const {
    return {at<float>(offset), at<float>(offset + 4), at<float>(offset + 8)};
  }
};

/// Numbers of FreeSurfer's mri.h.
std::optional<ElementType> elementType(int type) {
  switch (type) {
    case 0:
      return ElementType::UInt8;
    case 1:
      return ElementType::Int32;
    case 3:
      return ElementType::Float32;
    case 4:
      return ElementType::Int16;
    case 10:
      return ElementType::UInt16;
    default:
      return std::nullopt;
  }
}

/// The format has no signature but its version, 1, as the first number.
std::optional<Header> headerIn(const FileStart& start) {
  Header header;
  const std::span<const std::byte> first = start.unpacked();
  if (first.size() < header.bytes.size()) return std::nullopt;
  std::copy_n(first.begin(), header.bytes.size(), header.bytes.begin());
  if (header.at<std::int32_t>(0) != 1) return std::nullopt;
  for (std::size_t offset = 4; offset <= 16; offset += 4)
    if (header.at<std::int32_t>(offset) < 1) return std::nullopt;
  const std::int32_t type = header.at<std::int32_t>(20);
  return type >= 0 && type <= 10 ? std::optional(header) : std::nullopt;
}

/// The header gives the axes' directions and the position of the volume's middle (index dims / 2) in RAS mm.
void readGeometry(ImageFile& image, const Header& header) {
  const glm::dmat3 lpsFromRas(-1, 0, 0, 0, -1, 0, 0, 0, 1);
  glm::dvec3 spacing(1.0), centre(0.0);
  // Without the flag: coronal slices of 1 mm about the origin.
  glm::dmat3 axes{{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
  if (header.at<std::int16_t>(28) > 0) {
    spacing = header.vector(30);
    for (int axis = 0; axis < 3; ++axis) axes[axis] = header.vector(42 + 12 * static_cast<std::size_t>(axis));
    centre = header.vector(78);
  } else {
    image.warnings.push_back({Warning::Kind::NoGeometry,
                              "the file stores no orientation; it is taken as coronal slices of 1 mm",
                              {image.path}});
  }
  glm::dmat3 columns;
  for (int axis = 0; axis < 3; ++axis) columns[axis] = lpsFromRas * axes[axis] * spacing[axis];
  const glm::dvec3 origin = lpsFromRas * centre - columns * (0.5 * glm::dvec3(image.grid.dims));
  if (!setGeometry(image.grid, columns, origin))
    throw Error(image.path, "its header gives no usable geometry", "the header is damaged");
}

}  // namespace

bool looksLikeMgh(const FileStart& start) { return headerIn(start).has_value(); }

ImageFile readMghHeader(const fs::path& path) {
  const auto header = headerIn(FileStart(path));
  if (!header) throw Error(path, "has no MGH header", "the file is damaged or no MGH file");
  ImageFile image;
  image.path = path;
  image.format = "MGH";
  image.bigEndian = true;
  setDims(image, header->at<std::int32_t>(4), header->at<std::int32_t>(8), header->at<std::int32_t>(12));
  image.volumes = header->at<std::int32_t>(16);
  const auto type = elementType(header->at<std::int32_t>(20));
  if (!type)
    throw Error(path, "has voxels of MGH data type " + std::to_string(header->at<std::int32_t>(20)),
                "only scalar volumes can be opened; convert it to float first");
  image.type = *type;
  readGeometry(image, *header);
  image.source.files = {path};
  image.source.skip = dataOffset;
  image.source.packing = isGzip(path) ? Packing::Deflate : Packing::None;
  return image;
}

}  // namespace fenestra::io
