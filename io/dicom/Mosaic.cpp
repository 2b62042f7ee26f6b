#include "io/dicom/Mosaic.h"

#include <cmath>
#include <cstring>
#include <iomanip>
#include <locale>
#include <sstream>
#include <vector>

#include "io/base/Text.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io {
namespace {

/// Numbers of one element of a Siemens CSA header (version SV10): tags of named strings.
std::vector<double> csaNumbers(const Uint8* data, unsigned long size, const std::string& name) {
  const auto word = [&](unsigned long at) -> std::uint64_t {
    if (at + 4 > size) return 0;
    return std::uint64_t{data[at]} | std::uint64_t{data[at + 1]} << 8 | std::uint64_t{data[at + 2]} << 16 |
           std::uint64_t{data[at + 3]} << 24;
  };
  std::vector<double> values;
  if (size < 16 || std::memcmp(data, "SV10", 4) != 0) return values;
  const std::uint64_t tags = word(8);
  unsigned long at = 16;
  for (std::uint64_t tag = 0; tag < tags && at + 84 <= size; ++tag) {
    const char* tagName = reinterpret_cast<const char*>(data + at);
    const bool wanted = std::string(tagName, ::strnlen(tagName, 64)) == name;
    const std::uint64_t items = word(at + 76);
    at += 84;
    for (std::uint64_t item = 0; item < items && at + 16 <= size; ++item) {
      const std::uint64_t length = word(at + 4);
      at += 16;
      if (length > size - at) return values;
      const char* itemText = reinterpret_cast<const char*>(data + at);
      const auto value = numberIn<double>(trimmed({itemText, ::strnlen(itemText, length)}));
      if (wanted && value) values.push_back(*value);
      at += (length + 3) / 4 * 4;
      if (at > size) return values;
    }
    if (wanted) return values;
  }
  return values;
}

const DcmTagKey siemensHeader(0x0029, 0x1010);

/// Most slices of a picture: more than a mosaic of any scanner holds.
constexpr double mostSlices = 1024;

/// Tiles of a picture follow row by row, in the smallest square that holds `count` of them; empty where it does not
/// divide. Their positions are the whole picture's.
std::vector<DicomFrame> tilesOf(const DicomFrame& whole, double count) {
  const int tiles = static_cast<int>(std::ceil(std::sqrt(count)));
  if (whole.size.x % tiles != 0 || whole.size.y % tiles != 0) return {};
  const glm::ivec2 tile = whole.size / tiles;
  std::vector<DicomFrame> frames(static_cast<std::size_t>(count), whole);
  for (int slice = 0; slice < static_cast<int>(count); ++slice) {
    DicomFrame& frame = frames[static_cast<std::size_t>(slice)];
    frame.tile = glm::ivec2(slice % tiles, slice / tiles) * tile;
    frame.size = tile;
  }
  return frames;
}

/// Siemens: the private header gives the number of slices and the direction they follow in. The stored position is that
/// of the whole picture laid around the slices' centre.
std::vector<DicomFrame> siemensTiles(DcmItem& dataset, const DicomFrame& whole) {
  const auto mosaic = siemensMosaic(dataset);
  const double declared = whole.thickness > 0.0 ? whole.thickness : whole.step;
  const double step = numberOf(dataset, DCM_SpacingBetweenSlices).value_or(declared);
  if (!mosaic || !(step > 0.0) || !whole.hasGeometry) return {};
  std::vector<DicomFrame> frames = tilesOf(whole, mosaic->slices);
  for (std::size_t slice = 0; slice < frames.size(); ++slice) {
    const glm::dvec2 margin = glm::dvec2(whole.size - frames[slice].size) * 0.5 * whole.spacing;
    frames[slice].position =
        whole.position + whole.axes * margin + mosaic->normal * (step * static_cast<double>(slice));
  }
  return frames;
}

/// United Imaging: an item for each slice gives its own position, of its own first pixel.
std::vector<DicomFrame> unitedTiles(DcmItem& dataset, const DicomFrame& whole, double count, const DcmTagKey& slices) {
  std::vector<DicomFrame> frames = tilesOf(whole, count);
  std::size_t slice = 0;
  bool placed = true;
  forEachItem(dataset, slices, [&](DcmItem& item) {
    const auto position = numbersOf<3>(item, DCM_ImagePositionPatient);
    placed = placed && position.has_value();
    if (placed && slice < frames.size()) frames[slice].position = *position;
    ++slice;
  });
  if (!placed || slice != frames.size() || !whole.hasAxes) return {};
  for (DicomFrame& frame : frames) frame.hasGeometry = true;
  return frames;
}

/// An element of a CSA header with texts of numbers, which csaNumbers() reads.
std::string csaElement(const std::string& name, const std::vector<double>& values) {
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
  };
  std::string element = name + std::string(64 - name.size(), '\0');
  element += word(values.size()) + std::string("FD\0\0", 4) + word(4) + word(values.size()) + word(77);
  for (const double value : values) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::setprecision(17) << value;
    const std::size_t length = text.str().size();
    element += word(length) + word(length) + word(77) + word(length) + text.str();
    element += std::string((4 - length % 4) % 4, '\0');
  }
  return element;
}

}  // namespace

std::optional<SiemensMosaic> siemensMosaic(DcmItem& dataset) {
  const Uint8* csa = nullptr;
  unsigned long size = 0;
  if (dataset.findAndGetUint8Array(siemensHeader, csa, &size).bad() || !csa) return std::nullopt;
  const auto count = csaNumbers(csa, size, "NumberOfImagesInMosaic");
  const auto normal = csaNumbers(csa, size, "SliceNormalVector");
  if (count.empty() || !(count[0] >= 1 && count[0] <= mostSlices) || normal.size() != 3) return std::nullopt;
  return SiemensMosaic{count[0], {normal[0], normal[1], normal[2]}};
}

void writeSiemensMosaic(const SiemensMosaic& mosaic, DcmItem& dataset) {
  std::string csa("SV10\4\3\2\1\2\0\0\0M\0\0\0", 16);
  csa += csaElement("NumberOfImagesInMosaic", {mosaic.slices});
  csa += csaElement("SliceNormalVector", {mosaic.normal.x, mosaic.normal.y, mosaic.normal.z});
  dataset.putAndInsertString(DcmTag(0x0029, 0x0010, EVR_LO), "SIEMENS CSA HEADER");
  dataset.putAndInsertUint8Array(DcmTag(siemensHeader, EVR_OB), reinterpret_cast<const Uint8*>(csa.data()),
                                 static_cast<unsigned long>(csa.size()));
}

void splitMosaic(DcmItem& dataset, DicomFile& file) {
  const DicomFrame& whole = file.frames[0];
  std::vector<DicomFrame> frames;
  constexpr const char* united = "Image Private Header";
  const auto countTag = file.modality == "MR" ? privateTag(dataset, 0x0065, united, 0x50) : std::nullopt;
  const double count = countTag ? numberOf(dataset, *countTag).value_or(0.0) : 0.0;
  if (count > 1.0 && count <= mostSlices && count == std::floor(count))
    frames = unitedTiles(dataset, whole, count, DcmTagKey(0x0065, static_cast<Uint16>(countTag->getElement() + 1)));
  else if (codeOf(dataset, DCM_ImageType).find("MOSAIC") != std::string::npos)
    frames = siemensTiles(dataset, whole);
  else
    return;
  file.mosaicUnsplit = frames.empty();
  if (!frames.empty()) file.frames = std::move(frames);
}

}  // namespace fenestra::io
