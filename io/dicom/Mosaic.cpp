#include "io/dicom/Mosaic.h"

#include <cmath>
#include <cstring>
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

}  // namespace

// The tiles follow row by row. The stored position is that of the whole picture laid around the slices' centre.
void splitMosaic(DcmItem& dataset, DicomFile& file) {
  file.mosaicUnsplit = true;
  const Uint8* csa = nullptr;
  unsigned long size = 0;
  if (dataset.findAndGetUint8Array(DcmTag(0x0029, 0x1010, EVR_OB), csa, &size).bad() || !csa) return;
  const auto count = csaNumbers(csa, size, "NumberOfImagesInMosaic");
  const auto normal = csaNumbers(csa, size, "SliceNormalVector");
  const double step = numberOf(dataset, DCM_SpacingBetweenSlices).value_or(file.frames[0].thickness);
  // 1024: more slices than a mosaic of any scanner holds.
  if (count.empty() || !(count[0] >= 1 && count[0] <= 1024) || normal.size() != 3 || !(step > 0.0)) return;
  const DicomFrame whole = file.frames[0];
  const int tiles = static_cast<int>(std::ceil(std::sqrt(count[0])));
  if (!whole.hasGeometry || whole.size.x % tiles != 0 || whole.size.y % tiles != 0) return;

  file.mosaicUnsplit = false;
  file.frames.clear();
  const glm::ivec2 tile = whole.size / tiles;
  const glm::dvec2 margin = glm::dvec2(whole.size - tile) * 0.5 * whole.spacing;
  for (int slice = 0; slice < static_cast<int>(count[0]); ++slice) {
    DicomFrame frame = whole;
    frame.tile = glm::ivec2(slice % tiles, slice / tiles) * tile;
    frame.size = tile;
    frame.position =
        whole.position + whole.axes * margin + glm::dvec3(normal[0], normal[1], normal[2]) * (step * slice);
    file.frames.push_back(frame);
  }
}

}  // namespace fenestra::io
