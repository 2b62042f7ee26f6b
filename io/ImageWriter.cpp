#include "io/ImageWriter.h"
#include "io/base/AtomicFile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

#include <png.h>
#include <zlib.h>

#include "io/base/ByteStream.h"
#include "io/base/Error.h"
#include "io/base/Text.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

Picture readPng(const fs::path& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const auto refuse = [&] {
    throw Error(path, std::string("is no readable PNG (") + image.message + ")", "the file is damaged");
  };
  if (!png_image_begin_read_from_file(&image, path.c_str())) refuse();
  const bool colour = image.format & PNG_FORMAT_FLAG_COLOR, alpha = image.format & PNG_FORMAT_FLAG_ALPHA;
  image.format = alpha ? PNG_FORMAT_RGBA : colour ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  // 2^28 pixels: larger than any screen, and it bounds what a damaged header makes us allocate.
  if (static_cast<std::uint64_t>(image.width) * image.height > (1u << 28)) {
    png_image_free(&image);
    throw Error(path, "is larger than 268 million pixels", "the file is damaged");
  }
  Picture picture;
  picture.size = {static_cast<int>(image.width), static_cast<int>(image.height)};
  picture.channels = static_cast<int>(PNG_IMAGE_PIXEL_CHANNELS(image.format));
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr)) refuse();
  picture.values.resize(bytes.size());
  std::transform(bytes.begin(), bytes.end(), picture.values.begin(),
                 [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; });
  return picture;
}

/// The layers that writeLayer writes: 2-D, float32, uncompressed, local.
Picture readLayer(const fs::path& path) {
  const auto refuse = [&](const std::string& cause) {
    throw Error(path, cause, "only layers as 2-D float MetaImage, and PNG, can be read");
  };
  const auto stream = openStream(path, 0, Packing::None);
  Picture picture;
  picture.channels = 1;
  std::string line;
  bool msb = false, isFloat = false;
  constexpr std::size_t longestLine = 4096;
  for (char c = 0;;) {
    line.clear();
    while (stream->read(reinterpret_cast<std::byte*>(&c), 1) == 1 && c != '\n' && line.size() < longestLine) line += c;
    const std::size_t equals = line.find('=');
    if (c != '\n' || equals == std::string::npos) refuse("has no MetaImage header");
    const std::string name = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
    if (name == "DimSize") {
      const auto dims = numbersIn<int>(value);
      if (!dims || dims->size() != 2 || (*dims)[0] < 1 || (*dims)[1] < 1) refuse("has no two dimensions");
      picture.size = {(*dims)[0], (*dims)[1]};
    } else if (name == "ElementNumberOfChannels") {
      picture.channels = numberIn<int>(value).value_or(0);
    } else if (name == "ElementType") {
      isFloat = value == "MET_FLOAT";
    } else if (name == "BinaryDataByteOrderMSB" || name == "ElementByteOrderMSB") {
      msb = value == "True";
    } else if (name == "CompressedData" && value == "True") {
      refuse("is compressed");
    } else if (name == "ElementDataFile") {
      if (value != "LOCAL") refuse("keeps its values in another file");
      break;
    }
  }
  if (!isFloat || picture.channels < 1 || picture.channels > 4 || picture.size.x < 1) refuse("is no float layer");
  const std::uint64_t count = static_cast<std::uint64_t>(picture.size.x) * static_cast<std::uint64_t>(picture.size.y) *
                              static_cast<std::uint64_t>(picture.channels);
  if (count * sizeof(float) > fs::file_size(path)) refuse("ends too early");
  picture.values.resize(count);
  stream->readAll(reinterpret_cast<std::byte*>(picture.values.data()), count * sizeof(float), path);
  if (msb != (std::endian::native == std::endian::big)) refuse("is in another byte order");
  return picture;
}

/// Length, type, data and CRC-32 of type and data, numbers with the most significant byte first (PNG specification,
/// 5.3); the data are the keyword, a zero and the text (11.3.4.3).
std::string textChunk(const PngText& text) {
  const std::string content = "tEXt" + text.keyword + '\0' + text.text;
  const auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
    return bytes;
  };
  const auto* bytes = reinterpret_cast<const Bytef*>(content.data());
  const auto sum = static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(content.size())));
  return number(static_cast<std::uint32_t>(content.size() - 4)) + content + number(sum);
}

}  // namespace

void writePng(const fs::path& path, glm::ivec2 size, int channels, std::span<const std::uint8_t> pixels,
              const std::vector<PngText>& texts) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(size.x);
  image.height = static_cast<png_uint_32>(size.y);
  image.format = channels == 4 ? PNG_FORMAT_RGBA : channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  if (pixels.size() != PNG_IMAGE_SIZE(image)) throw std::invalid_argument("writePng: pixels do not fill the picture");
  const auto refuse = [&] {
    throw Error(path, std::string("cannot be written (") + image.message + ")", "check the picture's size");
  };
  std::vector<std::uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(image));
  png_alloc_size_t count = bytes.size();
  if (!png_image_write_to_memory(&image, bytes.data(), &count, 0, pixels.data(), 0, nullptr)) refuse();
  // libpng's simple interface writes no text. Texts may stand anywhere before the last chunk, IEND, which has no data.
  constexpr std::size_t lastChunk = 12;
  const std::size_t front = count - lastChunk;
  std::string chunk;
  for (const PngText& text : texts) chunk += textChunk(text);
  writeAtomically(path, [&](const fs::path& temporary) {
    writeBytes(temporary, {{bytes.data(), front}, {chunk.data(), chunk.size()}, {bytes.data() + front, lastChunk}});
  });
}

std::vector<PngText> readPngTexts(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8> head{};  // the signature, then length and type of each chunk
  if (!file.read(head.data(), head.size()) || png_sig_cmp(reinterpret_cast<png_const_bytep>(head.data()), 0, 8) != 0)
    throw Error(path, "is no PNG", "name a picture that ends in .png");
  std::vector<PngText> texts;
  constexpr std::streamoff sumBytes = 4, longest = 1 << 20;
  while (file.read(head.data(), head.size())) {
    std::streamoff length = 0;
    for (int i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(head[static_cast<std::size_t>(i)]);
    if (std::string_view(head.data() + 4, 4) != "tEXt" || length > longest) {
      file.seekg(length + sumBytes, std::ios::cur);
      continue;
    }
    std::string content(static_cast<std::size_t>(length), '\0');
    if (!file.read(content.data(), length)) break;
    file.seekg(sumBytes, std::ios::cur);
    if (const std::size_t end = content.find('\0'); end != std::string::npos)
      texts.push_back({content.substr(0, end), content.substr(end + 1)});
  }
  return texts;
}

void writeLayer(const fs::path& path, glm::ivec2 size, int channels, std::span<const float> values) {
  if (values.size() !=
      static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(channels))
    throw std::invalid_argument("writeLayer: values do not fill the layer");
  const std::string header = "ObjectType = Image\nNDims = 2\nBinaryData = True\nBinaryDataByteOrderMSB = " +
                             std::string(std::endian::native == std::endian::big ? "True" : "False") +
                             "\nCompressedData = False\nElementSpacing = 1 1\nDimSize = " + std::to_string(size.x) +
                             " " + std::to_string(size.y) + "\nElementNumberOfChannels = " + std::to_string(channels) +
                             "\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
  writeAtomically(path, [&](const fs::path& temporary) {
    writeBytes(temporary, {{header.data(), header.size()}, {values.data(), values.size_bytes()}});
  });
}

Picture readPicture(const fs::path& path) {
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) throw Error(path, "does not exist", "name a PNG picture or a layer (.mha)");
  std::array<std::uint8_t, 8> magic{};
  const std::size_t got =
      openStream(path, 0, Packing::None)->read(reinterpret_cast<std::byte*>(magic.data()), magic.size());
  return got == magic.size() && png_sig_cmp(magic.data(), 0, magic.size()) == 0 ? readPng(path) : readLayer(path);
}

}  // namespace fenestra::io
