#include "io/dicom/ImageParts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <utility>

#include "io/base/Text.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io {
namespace {

/// An attribute in a functional group, or in the dataset (0,0).
struct Source {
  DcmTagKey sequence, tag;
};
const DcmTagKey wholeDataset(0, 0);

struct Row {
  PartingAttribute attribute;
  bool number = false;
  std::vector<Source> sources = {};                        ///< the first with a value counts
  std::string (*own)(const Scopes&, int index) = nullptr;  ///< what no plain attribute gives; before the sources
};

constexpr const char* kernelName = "reconstruction kernel";

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

bool isMr(const Scopes& scopes) { return codeOf(scopes.dataset, DCM_Modality) == "MR"; }

/// A word of Image Type, from its third value on, as what the image holds; empty for other words.
std::string componentNamed(const std::string& word) {
  static constexpr std::array<std::pair<const char*, const char*>, 19> names = {{{"M", "magnitude"},
                                                                                 {"MAGNITUDE", "magnitude"},
                                                                                 {"P", "phase"},
                                                                                 {"PHASE", "phase"},
                                                                                 {"PHASE MAP", "phase"},
                                                                                 {"R", "real"},
                                                                                 {"REAL", "real"},
                                                                                 {"I", "imaginary"},
                                                                                 {"IMAGINARY", "imaginary"},
                                                                                 {"VELOCITY MAP", "velocity"},
                                                                                 {"W", "water"},
                                                                                 {"WATER", "water"},
                                                                                 {"F", "fat"},
                                                                                 {"FAT", "fat"},
                                                                                 {"IP", "in phase"},
                                                                                 {"IN_PHASE", "in phase"},
                                                                                 {"OP", "out of phase"},
                                                                                 {"OPP_PHASE", "out of phase"},
                                                                                 {"OUT_PHASE", "out of phase"}}};
  const auto at = std::find_if(names.begin(), names.end(), [&](const auto& name) { return word == name.first; });
  return at == names.end() ? std::string() : at->second;
}

/// Magnitude, phase, real or imaginary part; water or fat. MR alone: the letters mean other things elsewhere.
std::string componentOf(const Scopes& scopes, int) {
  if (!isMr(scopes)) return {};
  std::string found;
  const std::vector<std::string> words = split(codeOf(scopes.dataset, DCM_ImageType), '\\');
  for (std::size_t i = 2; i < words.size(); ++i)
    if (const std::string name = componentNamed(trimmed(words[i])); !name.empty() && name != found)
      found += (found.empty() ? "" : " ") + name;
  if (!found.empty()) return found;
  if (const auto tag = privateTag(scopes.dataset, 0x0043, "GEMS_PARM_01", 0x2f)) {
    static constexpr std::array<const char*, 4> names = {"magnitude", "phase", "real", "imaginary"};
    const auto number = integerOf(scopes.dataset, *tag);
    if (number && *number >= 0 && *number < 4) return names[static_cast<std::size_t>(*number)];
  }
  return {};
}

/// The number of a private element, which implicit coding stores as bytes of unknown type.
std::optional<double> privateNumber(DcmItem& item, const DcmTagKey& tag) {
  Uint8* bytes = nullptr;
  DcmElement* element = nullptr;
  if (item.findAndGetElement(tag, element).bad() || !element) return std::nullopt;
  if (const auto value = numberOf(item, tag)) return value;
  if (element->ident() != EVR_UN || element->getUint8Array(bytes).bad() || !bytes) return std::nullopt;
  float single = 0.0F;
  double number = 0.0;
  if (element->getLength() == sizeof single) {
    std::memcpy(&single, bytes, sizeof single);
    number = static_cast<double>(single);
  } else if (element->getLength() == sizeof number) {
    std::memcpy(&number, bytes, sizeof number);
  } else {
    return std::nullopt;
  }
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// The makers' own places of the b-value, from before the standard had one.
std::string ownBValue(const Scopes& scopes, int) {
  if (!isMr(scopes)) return {};
  struct Place {
    Uint16 group;
    const char* creator;
    Uint16 element;
  };
  static constexpr std::array<Place, 4> places = {{{0x0019, "SIEMENS MR HEADER", 0x0c},
                                                   {0x0043, "GEMS_PARM_01", 0x39},
                                                   {0x2001, "Philips Imaging DD 001", 0x03},
                                                   {0x0065, "Image Private Header", 0x09}}};
  for (const auto& [group, creator, element] : places) {
    const auto tag = privateTag(scopes.dataset, group, creator, element);
    const auto value = tag ? privateNumber(scopes.dataset, *tag) : std::nullopt;
    // GE adds 10^9 to b-values of several directions.
    if (value) return numberText(group == 0x0043 ? std::fmod(*value, 1e5) : *value);
  }
  return {};
}

/// The entry of a vector with a value a frame (NM, C.8.4.8).
template <Uint16 element>
std::string vectorEntry(const Scopes& scopes, int index) {
  const auto value = numberOf(scopes.dataset, DcmTagKey(0x0054, element), static_cast<unsigned long>(index));
  return value ? numberText(*value) : std::string();
}

/// What an image shows.
std::vector<Row> rowsThatAlwaysPart() {
  using enum Parting;
  return {
      {{"echo time", "ms", Always}, true, {{DCM_MREchoSequence, DCM_EffectiveEchoTime}, {wholeDataset, DCM_EchoTime}}},
      {{"echo number", "", Always}, true, {{wholeDataset, DCM_EchoNumbers}}},
      {{"flip angle", "degrees", Always},
       true,
       {{DCM_MRTimingAndRelatedParametersSequence, DCM_FlipAngle}, {wholeDataset, DCM_FlipAngle}}},
      {{"image component", "", Always},
       false,
       {{DCM_MRImageFrameTypeSequence, DCM_ComplexImageComponent}, {wholeDataset, DCM_ComplexImageComponent}},
       componentOf},
      {{"b-value", "s/mm^2", Always},
       true,
       {{DCM_MRDiffusionSequence, DCM_DiffusionBValue}, {wholeDataset, DCM_DiffusionBValue}},
       ownBValue},
      {{"velocity encoding", "", Always}, false, {{DCM_MRVelocityEncodingSequence, DCM_VelocityEncodingDirection}}},
      {{"magnetization transfer", "", Always}, false, {{DCM_MRModifierSequence, DCM_MagnetizationTransfer}}},
      {{"tube voltage", "kV", Always}, true, {{DCM_CTXRayDetailsSequence, DCM_KVP}, {wholeDataset, DCM_KVP}}},
      {{"energy weighting", "", Always}, true, {{wholeDataset, DCM_EnergyWeightingFactor}}},
      {{kernelName, "", Always},
       false,
       {{DCM_CTReconstructionSequence, DCM_ConvolutionKernel}, {wholeDataset, DCM_ConvolutionKernel}}},
      {{"contrast phase", "", Always},
       false,
       {{DCM_ContrastBolusUsageSequence, DCM_ContrastBolusAgentPhase}, {wholeDataset, DCM_ContrastBolusAgentPhase}}},
      {{"energy window", "", Always}, false, {}, vectorEntry<0x0010>},
  };
}

/// When an image was acquired, and what it was called.
std::vector<Row> rowsThatPartRepeats() {
  using enum Parting;
  return {
      {{"series number", "", WherePlacesRepeat}, true, {{wholeDataset, DCM_SeriesNumber}}},
      {{"slice thickness", "mm", WherePlacesRepeat},
       true,
       {{DCM_PixelMeasuresSequence, DCM_SliceThickness}, {wholeDataset, DCM_SliceThickness}}},
      {{"temporal position", "", WherePlacesRepeat},
       true,
       {{DCM_FrameContentSequence, DCM_TemporalPositionIndex}, {wholeDataset, DCM_TemporalPositionIdentifier}}},
      {{"cardiac phase", "%", WherePlacesRepeat},
       true,
       {{DCM_CardiacSynchronizationSequence, DCM_NominalPercentageOfCardiacPhase},
        {wholeDataset, DCM_NominalPercentageOfCardiacPhase}}},
      {{"trigger time", "ms", WherePlacesRepeat},
       true,
       {{DCM_CardiacSynchronizationSequence, DCM_NominalCardiacTriggerDelayTime}, {wholeDataset, DCM_TriggerTime}}},
      {{"time slot", "", WherePlacesRepeat}, false, {}, vectorEntry<0x0070>},
      {{"time slice", "", WherePlacesRepeat}, false, {}, vectorEntry<0x0100>},
      {{"phase of acquisition", "", WherePlacesRepeat}, false, {}, vectorEntry<0x0030>},
      {{"R-R interval", "", WherePlacesRepeat}, false, {}, vectorEntry<0x0060>},
      {{"detector", "", WherePlacesRepeat}, false, {}, vectorEntry<0x0020>},
      {{"acquisition number", "", WherePlacesRepeat},
       true,
       {{DCM_FrameContentSequence, DCM_FrameAcquisitionNumber}, {wholeDataset, DCM_AcquisitionNumber}}},
      {{"frame reference time", "ms", WherePlacesRepeat}, true, {{wholeDataset, DCM_FrameReferenceTime}}},
      {{"inversion time", "ms", WherePlacesRepeat}, true, {{wholeDataset, DCM_InversionTime}}},
      {{"repetition time", "ms", WherePlacesRepeat},
       true,
       {{DCM_MRTimingAndRelatedParametersSequence, DCM_RepetitionTime}, {wholeDataset, DCM_RepetitionTime}}},
      {{"image type", "", WherePlacesRepeat}, false, {{wholeDataset, DCM_ImageType}}},
      {{"sequence name", "", WherePlacesRepeat}, false, {{wholeDataset, DCM_SequenceName}}},
      {{"diffusion direction", "", WherePlacesRepeat}, false, {{wholeDataset, DCM_DiffusionGradientOrientation}}},
      {{"contrast agent", "", WherePlacesRepeat}, false, {{wholeDataset, DCM_ContrastBolusAgent}}},
      {{"acquisition time", "", WherePlacesRepeat}, false, {{wholeDataset, DCM_AcquisitionTime}}},
      {{"content time", "", WherePlacesRepeat}, false, {{wholeDataset, DCM_ContentTime}}},
  };
}

const std::vector<Row>& rows() {
  static const std::vector<Row> table = [] {
    std::vector<Row> all = rowsThatAlwaysPart();
    for (Row& row : rowsThatPartRepeats()) all.push_back(std::move(row));
    return all;
  }();
  return table;
}

std::string valueOf(const Scopes& scopes, const Row& row, const Source& source) {
  const auto read = [&](DcmItem* item) -> std::string {
    if (!item) return {};
    if (!row.number) return textOf(*item, source.tag);
    const auto value = numberOf(*item, source.tag);
    return value ? numberText(*value) : std::string();
  };
  if (source.sequence == wholeDataset) return read(&scopes.dataset);
  std::string value = read(firstItem(scopes.perFrame, source.sequence));
  return value.empty() ? read(firstItem(scopes.shared, source.sequence)) : value;
}

}  // namespace

const std::vector<PartingAttribute>& partingAttributes() {
  static const std::vector<PartingAttribute> attributes = [] {
    std::vector<PartingAttribute> all;
    for (const Row& row : rows()) all.push_back(row.attribute);
    return all;
  }();
  return attributes;
}

std::vector<std::string> partsOf(const Scopes& scopes, int index) {
  std::vector<std::string> values;
  values.reserve(rows().size());
  const bool grouped = scopes.perFrame || scopes.shared;
  for (const Row& row : rows()) {
    std::string value = row.own ? row.own(scopes, index) : std::string();
    for (const Source& source : row.sources)
      if (value.empty() && (grouped || source.sequence == wholeDataset)) value = valueOf(scopes, row, source);
    values.push_back(std::move(value));
  }
  return values;
}

std::string kernelOf(const std::vector<std::string>& parts) {
  const std::vector<PartingAttribute>& attributes = partingAttributes();
  for (std::size_t i = 0; i < std::min(parts.size(), attributes.size()); ++i)
    if (std::string_view(attributes[i].name) == kernelName) return parts[i];
  return {};
}

std::string partText(std::size_t attribute, const std::string& value) {
  const PartingAttribute& row = partingAttributes()[attribute];
  if (value.empty()) return std::string("no ") + row.name;
  return std::string(row.name) + " " + value + (*row.unit ? std::string(" ") + row.unit : "");
}

}  // namespace fenestra::io
