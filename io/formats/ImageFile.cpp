#include "io/formats/ImageFile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/base/Memory.h"
#include "io/base/PlausibleGrid.h"
#include "io/base/Text.h"
#include "io/base/Units.h"
#include "io/formats/VoxelText.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t blockBytes = 4u << 20;

std::uint64_t fileBytes(const fs::path& file) {
  std::error_code failure;
  const std::uint64_t bytes = fs::file_size(file, failure);
  if (failure) throw Error(file, "cannot be opened: " + failure.message(), "check the path and its permissions");
  return bytes;
}

std::uint64_t offsetAfterLines(const VoxelSource& source, const fs::path& file) {
  std::uint64_t offset = source.offset;
  if (source.lines == 0) return offset;
  const auto stream = openStream(file, offset, Packing::None);
  std::vector<std::byte> buffer(64 * 1024);
  std::uint64_t lines = 0;
  while (const std::size_t got = stream->read(buffer.data(), buffer.size()))
    for (std::size_t i = 0; i < got; ++i) {
      ++offset;
      if (buffer[i] == std::byte{'\n'} && ++lines == source.lines) return offset;
    }
  throw Error(file, "has fewer lines than its header skips", "the file is truncated or its header is wrong");
}

std::uint64_t unpackedBytes(const fs::path& file, std::uint64_t offset, Packing packing) {
  const auto stream = openStream(file, offset, packing);
  std::vector<std::byte> buffer(64 * 1024);
  std::uint64_t bytes = 0;
  while (const std::size_t got = stream->read(buffer.data(), buffer.size())) bytes += got;
  return bytes;
}

/// The stream of one file's voxels, positioned on byte `begin` of them; `bytes` is what it must hold.
std::unique_ptr<ByteStream> openShare(const ImageFile& image, const fs::path& file, std::uint64_t bytes,
                                      std::uint64_t begin) {
  const VoxelSource& source = image.source;
  if (source.open) return source.open(begin);
  const std::uint64_t offset = offsetAfterLines(source, file);
  if (source.packing == Packing::None && source.text == VoxelText::None) {
    const std::uint64_t size = fileBytes(file);
    const std::uint64_t first = source.skip == VoxelSource::atEnd ? size - std::min(size, bytes)
                                                                  : offset + static_cast<std::uint64_t>(source.skip);
    return openStream(file, first + begin, Packing::None);
  }
  auto stream = openStream(file, offset, source.packing);
  if (source.skip == VoxelSource::atEnd) {
    const std::uint64_t all = unpackedBytes(file, offset, source.packing);
    stream->skip(all - std::min(all, bytes));
  } else {
    stream->skip(static_cast<std::uint64_t>(source.skip));
  }
  if (source.text == VoxelText::Decimal)
    stream = decimalScalars(std::move(stream), image.type, bytes / sizeOf(image.type), file);
  else if (source.text == VoxelText::Hexadecimal)
    stream = hexadecimalBytes(std::move(stream), file);
  stream->skip(begin);
  return stream;
}

/// Throws when the files cannot hold what the header describes: before anything is allocated.
void checkSizes(const ImageFile& image, std::uint64_t voxels, std::uint64_t bytes) {
  const VoxelSource& source = image.source;
  checkMemory(image.path, saturatingProduct(voxels, sizeOf(image.type)));
  if (source.open) return;
  if (source.files.empty() || bytes % source.files.size() != 0)
    throw Error(image.path, "its voxels do not divide among its " + std::to_string(source.files.size()) + " data files",
                "check the header's sizes and its list of data files");
  const std::uint64_t share = bytes / source.files.size();
  for (const fs::path& file : source.files) {
    const std::uint64_t size = fileBytes(file);
    std::uint64_t skipped = source.offset;
    if (source.skip > 0 && source.packing == Packing::None) skipped += static_cast<std::uint64_t>(source.skip);
    const std::uint64_t held = size - std::min(size, skipped);
    // A deflate stream grows by 1032 at most (zlib's technical notes); a number takes a digit and a separator.
    std::uint64_t most = held;
    if (source.packing == Packing::Deflate) most = saturatingProduct(held, 1032);
    if (source.packing == Packing::Bzip2) most = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t numbers = share / sizeOf(image.type);
    const std::uint64_t needed = source.text == VoxelText::Decimal       ? numbers * 2 - 1
                                 : source.text == VoxelText::Hexadecimal ? share * 2
                                                                         : share;
    if (most >= needed) continue;
    if (source.text == VoxelText::Decimal)
      throw Error(file,
                  "holds " + std::to_string(held) + " characters of voxels where its header describes " +
                      std::to_string(numbers) + " numbers",
                  "the file is truncated or its header is wrong");
    throw Error(file,
                "holds " + std::to_string(held) + (source.packing == Packing::None ? "" : " packed") +
                    " bytes of voxels where its header describes " + std::to_string(needed),
                "the file is truncated or its header is wrong");
  }
}

/// Turns a block of one of the file's volumes into this machine's byte order, and appends the wanted layers of it to
/// their sinks.
void appendBlock(const ImageFile& image, std::span<std::byte> block, std::size_t volume, Layers layers,
                 std::vector<VoxelSink>& sinks) {
  const bool swap = image.source.text != VoxelText::Decimal && !image.source.open &&
                    image.bigEndian != (std::endian::native == std::endian::big);
  const auto interleaved = static_cast<std::size_t>(image.interleaved);
  const auto first = static_cast<std::size_t>(layers.first);
  visitElement(image.type, [&](auto scalar) {
    using T = decltype(scalar);
    const std::span<T> values(reinterpret_cast<T*>(block.data()), block.size() / sizeof(T));
    if constexpr (sizeof(T) > 1)
      if (swap)
        for (T& value : values) value = byteSwapped(value);
    if (interleaved == 1) {
      sinks[volume - first].append(std::span<const T>(values));
      return;
    }
    std::vector<T> one(values.size() / interleaved);
    for (std::size_t i = 0; i < interleaved; ++i) {
      const std::size_t layer = volume * interleaved + i;
      if (layer < first || layer - first >= sinks.size()) continue;
      for (std::size_t v = 0; v < one.size(); ++v) one[v] = values[v * interleaved + i];
      sinks[layer - first].append(std::span<const T>(one));
    }
  });
}

}  // namespace

void setDims(ImageFile& image, std::int64_t x, std::int64_t y, std::int64_t z) {
  for (const std::int64_t dim : {x, y, z})
    if (dim < 1 || dim > std::numeric_limits<int>::max())
      throw Error(
          image.path,
          "its header says " + std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z) + " voxels",
          "the header is damaged");
  image.grid.dims = {static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)};
}

bool setGeometry(Grid& grid, const glm::dmat3& columns, const glm::dvec3& origin) {
  glm::dmat3 direction;
  glm::dvec3 spacing;
  for (int axis = 0; axis < 3; ++axis) {
    spacing[axis] = glm::length(columns[axis]);
    direction[axis] = columns[axis] / spacing[axis];
    if (!std::isfinite(spacing[axis]) || !(spacing[axis] > 0.0) || !std::isfinite(origin[axis])) return false;
  }
  if (!areIndependent(direction)) return false;
  // Adding zero turns a -0 that a change of signs left into 0.
  grid.spacing = spacing;
  grid.direction = direction + glm::dmat3(0.0);
  grid.origin = origin + 0.0;
  return true;
}

double millimetresOf(ImageFile& image, std::string_view unit) {
  if (isNoUnit(unit)) return 1.0;
  if (const auto length = millimetresIn(unit)) return *length;
  if (image.unknownUnit.empty()) image.warnings.push_back({Warning::Kind::NoGeometry, unknownUnit(unit), {image.path}});
  image.unknownUnit = unit;
  return 1.0;
}

std::optional<std::vector<double>> headerNumbers(ImageFile& image, const std::string& name, const std::string& text) {
  if (auto numbers = numbersIn<double>(text)) return numbers;
  std::vector<double> numbers;
  std::string read;
  for (const std::string& word : words(text)) {
    const auto point = numberIn<double>(word), comma = commaNumberIn(word);
    if (!point && !comma) return std::nullopt;
    numbers.push_back(point ? *point : *comma);
    if (!read.empty()) read += ' ';
    read += plainNumber(numbers.back());
  }
  image.warnings.push_back(
      {Warning::Kind::NoGeometry, "its " + name + " has decimal commas; it is read as " + read, {image.path}});
  return numbers;
}

void checkGeometry(const ImageFile& image) {
  const auto wrong = implausibility(image.grid);
  if (wrong && !image.unknownUnit.empty())
    throw Error(image.path, unknownUnit(image.unknownUnit) + ", and then its geometry is not plausible: " + *wrong,
                "write the file's lengths in mm, or in a unit such as um, cm or m");
  checkGeometry(image.path, image.grid);
}

std::string numberedName(const std::string& pattern, long number, const fs::path& header) {
  const auto refuse = [&]() -> std::string {
    throw Error(header, "its data file pattern '" + pattern + "' is not understood", "use one %d, as in slice%03d.raw");
  };
  const std::size_t percent = pattern.find('%');
  if (percent == std::string::npos) return refuse();
  std::size_t at = percent + 1;
  const bool zeros = at < pattern.size() && pattern[at] == '0';
  std::size_t width = 0;
  while (at < pattern.size() && pattern[at] >= '0' && pattern[at] <= '9' && width < 100)
    width = width * 10 + static_cast<std::size_t>(pattern[at++] - '0');
  if (at >= pattern.size() || (pattern[at] != 'd' && pattern[at] != 'i' && pattern[at] != 'u') || width > 20 ||
      pattern.find('%', at) != std::string::npos)
    return refuse();
  std::string digits = std::to_string(number);
  if (digits.size() < width) digits.insert(0, width - digits.size(), zeros ? '0' : ' ');
  return pattern.substr(0, percent) + digits + pattern.substr(at + 1);
}

fs::path besideHeader(const fs::path& header, const std::string& name) { return header.parent_path() / fs::path(name); }

void refuseOutside(const ImageFile& image) {
  const auto resolved = [&](const fs::path& path) {
    std::error_code failure;
    const fs::path result = fs::weakly_canonical(fs::absolute(path), failure);
    if (failure)
      throw Error(image.path, "names a file that cannot exist (" + failure.message() + ")", "the header is damaged");
    return result;
  };
  const fs::path folder = resolved(image.path).parent_path();
  for (const fs::path& file : image.source.files) {
    if (file == image.path) continue;
    const fs::path inside = resolved(file).lexically_relative(folder);
    if (inside.empty() || *inside.begin() == "..")
      throw Error(image.path, "names voxels outside its folder (" + file.string() + ")", WayOut::AllowOutside);
  }
}

namespace {

/// The voxels of each layer; warns where some were rounded.
std::vector<Voxels> takenFrom(std::vector<VoxelSink>& sinks, const ImageFile& image, std::vector<Warning>& warnings) {
  std::vector<Voxels> result;
  bool lossy = false;
  for (VoxelSink& sink : sinks) {
    lossy |= sink.lossy();
    result.push_back(sink.take());
  }
  if (lossy)
    warnings.push_back({Warning::Kind::PrecisionLoss,
                        "some 64-bit integers are beyond 2^53 and were rounded to the nearest double",
                        {image.path}});
  return result;
}

}  // namespace

std::vector<Voxels> readVoxels(const ImageFile& image, Layers layers, const Progress& progress,
                               std::vector<Warning>& warnings) {
  const std::uint64_t dims[] = {static_cast<std::uint64_t>(image.grid.dims.x),
                                static_cast<std::uint64_t>(image.grid.dims.y),
                                static_cast<std::uint64_t>(image.grid.dims.z)};
  const std::uint64_t voxels = saturatingProduct(saturatingProduct(dims[0], dims[1]), dims[2]);
  const std::uint64_t scalars = saturatingProduct(voxels, static_cast<std::uint64_t>(image.layers()));
  const std::uint64_t bytes = saturatingProduct(scalars, sizeOf(image.type));
  // Before the sizes are compared: a product that saturated compares as too large for any file and any machine.
  checkSizes(image, saturatingProduct(voxels, static_cast<std::uint64_t>(layers.count)), bytes);

  const std::size_t interleaved = static_cast<std::size_t>(image.interleaved);
  const std::size_t first = static_cast<std::size_t>(layers.first),
                    end = first + static_cast<std::size_t>(layers.count);
  const std::size_t firstVolume = first / interleaved, endVolume = (end + interleaved - 1) / interleaved;
  std::vector<VoxelSink> sinks;
  for (std::size_t layer = first; layer < end; ++layer) sinks.emplace_back(static_cast<std::size_t>(voxels));

  const std::size_t voxelBytes = sizeOf(image.type) * interleaved;
  const std::uint64_t share = image.source.open ? bytes : bytes / image.source.files.size(),
                      begin = voxels * voxelBytes * firstVolume;
  const std::uint64_t wanted = voxels * voxelBytes * (endVolume - firstVolume);
  auto file = static_cast<std::size_t>(begin / share);
  std::uint64_t leftInFile = share - begin % share;
  auto stream = openShare(image, image.source.files[file], share, begin % share);
  std::vector<std::byte> block(std::max(blockBytes / voxelBytes, std::size_t{1}) * voxelBytes);

  std::uint64_t done = 0;
  for (std::size_t volume = firstVolume; volume < endVolume; ++volume) {
    for (std::uint64_t voxel = 0; voxel < voxels;) {
      if (progress && !progress(static_cast<double>(done) / static_cast<double>(wanted), "reading voxels"))
        throw Cancelled();
      const std::size_t count =
          static_cast<std::size_t>(std::min<std::uint64_t>(block.size() / voxelBytes, voxels - voxel));
      for (std::size_t filled = 0; filled < count * voxelBytes;) {
        if (leftInFile == 0) {
          stream = openShare(image, image.source.files[++file], share, 0);
          leftInFile = share;
        }
        const std::size_t piece =
            static_cast<std::size_t>(std::min<std::uint64_t>(count * voxelBytes - filled, leftInFile));
        stream->readAll(block.data() + filled, piece, image.source.files[file]);
        filled += piece;
        leftInFile -= piece;
        // One read beyond the voxels meets the packed stream's end and its checksum.
        std::byte beyond{};
        if (leftInFile == 0 && image.source.packing != Packing::None) stream->read(&beyond, 1);
      }
      appendBlock(image, {block.data(), count * voxelBytes}, volume, layers, sinks);
      voxel += count;
      done += count * voxelBytes;
    }
  }
  return takenFrom(sinks, image, warnings);
}

ImageFile describeRaw(const fs::path& path, const RawDescription& description) {
  ImageFile image;
  image.path = path;
  image.format = "raw";
  setDims(image, description.dims.x, description.dims.y, description.dims.z);
  image.grid.spacing = description.spacing;
  switch (description.type) {
    case ScalarType::UInt8:
      image.type = ElementType::UInt8;
      break;
    case ScalarType::Int8:
      image.type = ElementType::Int8;
      break;
    case ScalarType::UInt16:
      image.type = ElementType::UInt16;
      break;
    case ScalarType::Int16:
      image.type = ElementType::Int16;
      break;
    case ScalarType::UInt32:
      image.type = ElementType::UInt32;
      break;
    case ScalarType::Int32:
      image.type = ElementType::Int32;
      break;
    case ScalarType::Float32:
      image.type = ElementType::Float32;
      break;
    case ScalarType::Float64:
      image.type = ElementType::Float64;
      break;
  }
  image.bigEndian = description.bigEndian;
  image.source.files = {path};
  image.source.offset = description.skip;
  const std::uint64_t held = fileBytes(path);
  const std::uint64_t described =
      saturatingProduct(saturatingProduct(saturatingProduct(static_cast<std::uint64_t>(description.dims.x),
                                                            static_cast<std::uint64_t>(description.dims.y)),
                                          static_cast<std::uint64_t>(description.dims.z)),
                        sizeOf(image.type));
  const std::uint64_t voxelBytes = held - std::min<std::uint64_t>(held, description.skip);
  if (voxelBytes > described)
    image.warnings.push_back({Warning::Kind::Other,
                              "the file holds " + std::to_string(voxelBytes) +
                                  " bytes of voxels, the description uses the first " + std::to_string(described),
                              {path}});
  return image;
}

}  // namespace fenestra::io
