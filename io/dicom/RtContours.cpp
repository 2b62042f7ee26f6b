#include "io/dicom/RtContours.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "io/base/Text.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// The text of Contour Data. A contour of more than 64 KiB fits no explicit DS; such files say UN.
std::string contourText(DcmItem& contour) {
  DcmElement* element = nullptr;
  if (contour.findAndGetElement(DCM_ContourData, element).bad() || !element) return {};
  Uint8* bytes = nullptr;
  if (element->ident() == EVR_UN && element->getUint8Array(bytes).good() && bytes)
    return {reinterpret_cast<const char*>(bytes), element->getLength()};
  // The raw text: DCMTK looks for each value of a string array from the first one on.
  char* value = nullptr;
  Uint32 length = 0;
  return element->getString(value, length).good() && value ? std::string(value, length) : std::string();
}

/// A contour's points, or why it has none: "has ...".
struct Points {
  Contour points;
  std::string fault;
};

Points pointsOf(DcmItem& contour) {
  const std::string all = contourText(contour);
  std::vector<double> numbers;
  for (std::string_view rest = all; !rest.empty();) {
    const std::size_t end = rest.find('\\');
    std::string_view word = rest.substr(0, end);
    constexpr std::string_view padding(" \t\r\n\0", 5);
    word.remove_prefix(std::min(word.find_first_not_of(padding), word.size()));
    word = word.substr(0, word.find_last_not_of(padding) + 1);
    const auto value = numberIn<double>(word);
    // A kilometre: beyond any scanner, and far from where arithmetic fails.
    if (!value || !(std::abs(*value) <= 1e6))
      return {{},
              "has the coordinate \"" + std::string(word.substr(0, 32)) + "\", which is no position in millimetres"};
    numbers.push_back(*value);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  if (numbers.size() % 3 != 0)
    return {{}, "has " + std::to_string(numbers.size()) + " coordinates, which are no whole points"};
  const auto held = static_cast<std::int64_t>(numbers.size() / 3);
  const std::int64_t declared = integerOf(contour, DCM_NumberOfContourPoints).value_or(held);
  if (declared != held) return {{}, "has " + std::to_string(held) + " points but says " + std::to_string(declared)};
  Points read;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    read.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return read;
}

/// The structures in the file's order, with unique labels.
std::vector<Structure> structuresIn(DcmDataset& dataset, const fs::path& path) {
  std::vector<Structure> structures;
  std::set<std::int64_t> numbers;
  forEachItem(dataset, DCM_StructureSetROISequence, [&](DcmItem& item) {
    Structure structure;
    structure.number = integerOf(item, DCM_ROINumber).value_or(-1);
    structure.label.name = typedTextOf(item, DCM_ROIName, &dataset);
    if (!numbers.insert(structure.number).second)
      refuseDamaged(path, "two of its structures have the number " + std::to_string(structure.number));
    structures.push_back(std::move(structure));
  });
  if (structures.empty()) refuseDamaged(path, "it describes no structures");
  if (structures.size() > greatestLabel) refuseDamaged(path, "it has more structures than fit 16 bits");
  std::set<std::int64_t> taken;
  const auto isLabel = [](std::int64_t number) { return number >= 1 && number <= greatestLabel; };
  for (const Structure& structure : structures)
    if (isLabel(structure.number)) taken.insert(structure.number);
  std::int64_t next = 1;
  for (Structure& structure : structures) {
    std::int64_t value = structure.number;
    if (!isLabel(value)) {
      while (taken.contains(next)) ++next;
      value = next;
      taken.insert(value);
    }
    structure.label.value = static_cast<std::uint16_t>(value);
    structure.label.colour = noColour;
    if (structure.label.name.empty()) structure.label.name = "label " + std::to_string(value);
  }
  return structures;
}

/// The values of an attribute, divided by blanks.
std::string spaced(std::string values) {
  std::replace(values.begin(), values.end(), '\\', ' ');
  return values;
}

/// Adds the contours of one item to its structure.
void addContours(DcmItem& item, Structure& structure, StructureSet& set) {
  forEachItem(item, DCM_ContourSequence, [&](DcmItem& contour) {
    Points read = pointsOf(contour);
    const std::string type = codeOf(contour, DCM_ContourGeometricType);
    const bool closed = type.empty() || type == "CLOSED_PLANAR" || type == "CLOSEDPLANAR_XOR";
    if (!read.fault.empty())
      set.faults.push_back("a contour of " + structure.label.name + " " + read.fault);
    else if (closed && read.points.size() >= 3)
      structure.contours.push_back(std::move(read.points));
    else
      ++set.open;
  });
}

}  // namespace

StructureSet readContours(DcmDataset& dataset, const fs::path& path) {
  StructureSet set;
  set.structures = structuresIn(dataset, path);
  if (!dataset.tagExists(DCM_ROIContourSequence)) refuseDamaged(path, "it has no contours");
  forEachItem(dataset, DCM_ROIContourSequence, [&](DcmItem& item) {
    const std::int64_t number = integerOf(item, DCM_ReferencedROINumber).value_or(-1);
    const auto at = std::find_if(set.structures.begin(), set.structures.end(),
                                 [&](const Structure& structure) { return structure.number == number; });
    if (at == set.structures.end()) {
      std::size_t contours = 0;
      forEachItem(item, DCM_ContourSequence, [&](DcmItem&) { ++contours; });
      if (contours == 0) return;
      set.undescribed += contours;
      set.strangers.insert(number);
      return;
    }
    if (const auto colour = numbersIn<double>(spaced(textOf(item, DCM_ROIDisplayColor))); colour && colour->size() == 3)
      at->label.colour = glm::clamp(glm::dvec3((*colour)[0], (*colour)[1], (*colour)[2]) / 255.0, 0.0, 1.0);
    addContours(item, *at, set);
  });
  const bool kept = set.open > 0 || std::any_of(set.structures.begin(), set.structures.end(),
                                                [](const Structure& each) { return !each.contours.empty(); });
  if (!kept && !set.faults.empty()) refuseDamaged(path, set.faults.front());
  if (!kept && set.undescribed > 0)
    refuseDamaged(path, "it has contours of structure " + std::to_string(*set.strangers.begin()) +
                            ", which it does not describe, and no others");
  return set;
}

void warnOfLeftOut(const StructureSet& set, const fs::path& path, std::vector<Warning>& warnings) {
  const auto warn = [&](const std::string& text) { warnings.push_back({Warning::Kind::Other, text, {path}}); };
  const auto contours = [](std::size_t count) {
    return std::to_string(count) + (count == 1 ? " contour" : " contours");
  };
  if (!set.faults.empty()) {
    constexpr std::size_t shown = 3;
    std::string why;
    for (std::size_t i = 0; i < std::min(shown, set.faults.size()); ++i) why += (i ? ", " : "") + set.faults[i];
    if (set.faults.size() > shown) why += ", and " + std::to_string(set.faults.size() - shown) + " others";
    warn(contours(set.faults.size()) + " left out, which cannot be read: " + why);
  }
  if (set.undescribed > 0) {
    std::string numbers;
    for (const std::int64_t number : set.strangers)
      numbers.append(numbers.empty() ? "" : ", ").append(std::to_string(number));
    warn(contours(set.undescribed) + " left out: of structure " + numbers + ", which it does not describe");
  }
  if (set.open > 0)
    warn(std::to_string(set.open) + " of its contours left out: points or open lines, which enclose nothing");
}

}  // namespace fenestra::io
