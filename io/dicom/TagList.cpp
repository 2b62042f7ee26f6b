#include "io/dicom/TagList.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <utility>

#include <dcmtk/dcmdata/dcspchrs.h>

#include "io/base/Text.h"
#include "io/base/Words.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/PackedFiles.h"

namespace fenestra::io {
namespace {

constexpr std::uint64_t longestText = 65536;  // bytes; longer ones are tables, not texts to read

bool isFreeText(DcmEVR vr) {
  constexpr std::array texts = {EVR_LO, EVR_LT, EVR_SH, EVR_ST, EVR_UC, EVR_UT, EVR_UR, EVR_AE};
  return std::find(texts.begin(), texts.end(), vr) != texts.end();
}

/// Texts that describe the machine or the standard's codes.
bool isTechnical(const DcmTagKey& tag) {
  static const std::array known = {DCM_Manufacturer,
                                   DCM_ManufacturerModelName,
                                   DCM_SoftwareVersions,
                                   DCM_ConvolutionKernel,
                                   DCM_SequenceName,
                                   DCM_ReceiveCoilName,
                                   DCM_TransmitCoilName,
                                   DCM_RescaleType,
                                   DCM_ModalityLUTType,
                                   DCM_CodeValue,
                                   DCM_CodingSchemeDesignator,
                                   DCM_CodingSchemeVersion,
                                   DCM_ImplementationVersionName};
  return std::find(known.begin(), known.end(), tag) != known.end();
}

bool mayIdentify(DcmElement& element, const std::string& value) {
  const DcmTagKey tag = element.getTag();
  const DcmEVR vr = element.ident();
  if (tag.isPrivateReservation()) return false;
  if (tag.isPrivate() || tag.getGroup() == 0x0010 || vr == EVR_UN) return true;
  if (vr == EVR_PN || vr == EVR_DA || vr == EVR_DT || vr == EVR_TM || vr == EVR_AS) return true;
  if (vr == EVR_UI) return !value.empty() && !value.starts_with("1.2.840.10008.");
  return isFreeText(vr) && !isTechnical(tag);
}

/// Converts texts of one item to UTF-8.
class ItemText {
 public:
  /// An item without a character set of its own has that of what it lies in (PS3.5 6.1.2.4 and 7.5.3).
  ItemText(DcmItem& item, const std::string& inherited) {
    OFString own;
    set_ = item.findAndGetOFStringArray(DCM_SpecificCharacterSet, own).good() && !own.empty()
               ? std::string(own.data(), own.size())
               : inherited;
    known_ = converter_.selectCharacterSet(OFString(set_.c_str())).good();
  }
  const std::string& set() const { return set_; }

  std::string of(DcmElement& element, std::string_view text) {
    const DcmEVR vr = element.ident();
    if (std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80 && c != 0x1b; }))
      return std::string(text);
    // Code extensions end at delimiters (PS3.5 6.1.2.5.3), which differ by the VR.
    const bool oneValue = vr == EVR_ST || vr == EVR_LT || vr == EVR_UT;
    const OFString delimiters(vr == EVR_PN ? "\\^=" : oneValue ? "" : "\\");
    OFString utf8;
    if (known_ && element.isAffectedBySpecificCharacterSet() &&
        converter_.convertString(OFString(text.data(), text.size()), utf8, delimiters).good())
      return {utf8.data(), utf8.size()};
    std::string ascii(text);
    std::erase_if(ascii, [](char c) { return static_cast<unsigned char>(c) >= 0x80 || c == 0x1b; });
    return ascii;
  }

 private:
  DcmSpecificCharacterSet converter_;
  std::string set_;
  bool known_ = false;
};

/// The stored value as text; empty for binary ones.
std::optional<std::string> storedText(DcmElement& element) {
  switch (element.ident()) {
    case EVR_OB:
    case EVR_OW:
    case EVR_OF:
    case EVR_OD:
    case EVR_OL:
    case EVR_OV:
    case EVR_ox:
    case EVR_px:
    case EVR_lt:
    case EVR_PixelData:
    case EVR_OverlayData:
      return std::nullopt;
    case EVR_UN: {
      // An implicit VR tells nothing of private ones, most of which are texts.
      Uint8* bytes = nullptr;
      if (element.getUint8Array(bytes).bad() || !bytes) return std::string();
      const std::string text = trimmed({reinterpret_cast<const char*>(bytes), element.getLength()});
      const bool isText = std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
      return isText && !text.empty() ? std::optional(text) : std::nullopt;
    }
    default:
      break;
  }
  OFString text;
  if (element.getOFStringArray(text).bad()) return std::nullopt;
  return trimmed({text.data(), text.size()});
}

class TagReader {
 public:
  explicit TagReader(std::size_t frame) : frame_(frame) {}

  std::vector<DicomTag> read(DcmItem& item, const std::string& characterSet) {
    ItemText text(item, characterSet);
    std::vector<DicomTag> tags;
    for (unsigned long i = 0; i < item.card(); ++i) tags.push_back(read(*item.getElement(i), text));
    return tags;
  }

 private:
  DicomTag read(DcmElement& element, ItemText& text) {
    DicomTag tag;
    DcmTag own = element.getTag();
    tag.group = own.getGroup();
    tag.element = own.getElement();
    tag.vr = DcmVR(element.ident()).getValidVRName();
    if (const char* creator = own.getPrivateCreator()) tag.creator = creator;
    const std::string name = own.getTagName();
    if (own.isPrivateReservation())
      tag.name = "PrivateCreator";
    else if (name != DcmTag_ERROR_TagName)
      tag.name = name;
    if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(&element); sequence && element.ident() == EVR_SQ) {
      addItems(*sequence, text, tag);
      return tag;
    }
    tag.bytes = element.getLengthField();
    std::optional<std::string> value;
    if (tag.bytes <= longestText) value = storedText(element);
    tag.hasText = value.has_value();
    if (value) tag.value = text.of(element, *value);
    tag.identifies = mayIdentify(element, tag.value);
    return tag;
  }

  void addItems(DcmSequenceOfItems& sequence, const ItemText& text, DicomTag& tag) {
    tag.itemCount = sequence.card();
    const bool perFrame = sequence.getTag() == DCM_PerFrameFunctionalGroupsSequence;
    std::size_t number = 0;
    for (DcmObject* next = nullptr; (next = sequence.nextInContainer(next));) {
      ++number;
      if (perFrame && number != frame_ + 1) continue;
      if (auto* item = dynamic_cast<DcmItem*>(next)) tag.items.push_back({number, read(*item, text.set())});
    }
  }

  std::size_t frame_;
};

/// The pixels of a file whose header was read up to them.
std::optional<DicomTag> pixelTag(DcmDataset& dataset, const std::filesystem::path& path) {
  const std::optional<PixelPlace> pixels = pixelsOf(dataset, path);
  if (!pixels || pixels->isPrivate) return std::nullopt;
  DicomTag tag;
  tag.group = 0x7fe0;
  if (pixels->floatBytes > 0) {
    const bool isDouble = pixels->floatBytes == 8;
    tag.element = isDouble ? 0x0009 : 0x0008;
    tag.name = isDouble ? "DoubleFloatPixelData" : "FloatPixelData";
    tag.vr = isDouble ? "OD" : "OF";
  } else {
    tag.element = 0x0010;
    tag.name = "PixelData";
    tag.vr = pixels->encapsulated || integerOf(dataset, DCM_BitsAllocated).value_or(16) <= 8 ? "OB" : "OW";
  }
  tag.bytes = pixels->length;
  if (pixels->encapsulated) {
    // Their length is not told. Next to nothing follows the fragments.
    std::error_code failure;
    const std::uint64_t all = std::filesystem::file_size(path, failure);
    if (!failure && all > pixels->offset) tag.bytes = all - pixels->offset;
  }
  return tag;
}

bool holds(const DicomTag& tag, const std::string& text) {
  for (const std::string* each : {&tag.name, &tag.creator, &tag.value})
    if (lowered(*each).find(text) != std::string::npos) return true;
  return tag.number().find(text) != std::string::npos || ("(" + tag.number() + ")").find(text) != std::string::npos;
}

}  // namespace

std::string DicomTag::number() const {
  std::array<char, 12> text{};
  std::snprintf(text.data(), text.size(), "%04x,%04x", group, element);
  return text.data();
}

std::vector<DicomTag> readDicomTags(const std::filesystem::path& path, std::size_t frame) {
  PackedFiles packed;
  const std::filesystem::path content = packed.contentOf(path);
  DcmFileFormat file;
  try {
    loadHeader(content, file);
    TagReader reader(frame);
    std::vector<DicomTag> tags = reader.read(*file.getMetaInfo(), {});
    for (DicomTag& tag : reader.read(*file.getDataset(), {})) tags.push_back(std::move(tag));
    if (std::optional<DicomTag> pixels = pixelTag(*file.getDataset(), content)) tags.push_back(std::move(*pixels));
    return tags;
  } catch (const Error& error) {
    throw Error(path, error.cause(), error.hint());
  }
}

void hidePatient(std::vector<DicomTag>& tags) {
  for (DicomTag& tag : tags) {
    if (tag.identifies) tag.value.clear();
    for (DicomTagItem& item : tag.items) hidePatient(item.tags);
  }
}

std::vector<DicomTag> tagsHolding(const std::vector<DicomTag>& tags, std::string_view text) {
  const std::string wanted = lowered(std::string(text));
  std::vector<DicomTag> found;
  for (const DicomTag& tag : tags) {
    if (holds(tag, wanted)) {
      found.push_back(tag);
      continue;
    }
    DicomTag part = tag;
    part.items.clear();
    for (const DicomTagItem& item : tag.items)
      if (std::vector<DicomTag> within = tagsHolding(item.tags, text); !within.empty())
        part.items.push_back({item.number, std::move(within)});
    if (!part.items.empty()) found.push_back(std::move(part));
  }
  return found;
}

}  // namespace fenestra::io
