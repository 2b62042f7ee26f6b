#include "io/dicom/TagList.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/dcmdata/dcpixel.h>

#include "io/base/Text.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/PackedFiles.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Longer values are cut there: a list is read line by line.
constexpr std::size_t longestValue = 1024;
/// More binary values than this are data rather than something to read.
constexpr unsigned long mostNumbers = 64;

/// Cuts a UTF-8 text after at most longestValue bytes, between characters, and blanks its control characters.
std::string shownText(std::string text) {
  if (text.size() > longestValue) {
    std::size_t end = longestValue;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    text.resize(end);
    text += "…";
  }
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
  return text;
}

std::string sizeText(std::uint64_t bytes) { return std::to_string(bytes) + " bytes"; }

std::string pixelText(DcmPixelData& pixels) {
  E_TransferSyntax syntax = EXS_Unknown;
  const DcmRepresentationParameter* parameter = nullptr;
  pixels.getOriginalRepresentationKey(syntax, parameter);
  DcmPixelSequence* fragments = nullptr;
  if (!DcmXfer(syntax).isEncapsulated() || pixels.getEncapsulatedRepresentation(syntax, parameter, fragments).bad() ||
      !fragments)
    return sizeText(pixels.getLength());
  std::uint64_t bytes = 0;
  for (unsigned long i = 0; i < fragments->card(); ++i) {
    DcmPixelItem* fragment = nullptr;
    if (fragments->getItem(fragment, i).good()) bytes += fragment->getLength();
  }
  return sizeText(bytes) + ", compressed";
}

bool isData(DcmElement& element) {
  switch (element.ident()) {
    case EVR_OB:
    case EVR_OW:
    case EVR_OF:
    case EVR_OD:
    case EVR_OL:
    case EVR_OV:
    case EVR_ox:
    case EVR_UN:
      return true;
    default:
      return !dynamic_cast<DcmByteString*>(&element) && element.getVM() > mostNumbers;
  }
}

/// `dataset` names the character set where `item` does not.
std::string valueOf(DcmElement& element, DcmItem& item, DcmItem& dataset) {
  if (auto* pixels = dynamic_cast<DcmPixelData*>(&element)) return pixelText(*pixels);
  if (isData(element)) return element.getLength() == 0 ? std::string() : sizeText(element.getLength());
  const bool namesItsOwn = item.tagExistsWithValue(DCM_SpecificCharacterSet);
  return shownText(typedTextOf(item, element.getTag(), namesItsOwn ? nullptr : &dataset));
}

std::vector<DicomAttribute> attributesOf(DcmItem& item, DcmItem& dataset) {
  std::vector<DicomAttribute> attributes;
  for (unsigned long i = 0; i < item.card(); ++i) {
    DcmElement* element = item.getElement(i);
    DicomAttribute& attribute = attributes.emplace_back();
    DcmTag tag = element->getTag();
    attribute.group = tag.getGTag();
    attribute.element = tag.getETag();
    attribute.vr = DcmVR(element->ident()).getValidVRName();
    if (tag.isPrivate() && !tag.isPrivateReservation()) {
      const DcmTagKey reservation(tag.getGTag(), static_cast<Uint16>(tag.getETag() >> 8));
      attribute.creator = shownText(textOf(item, reservation));
      if (!attribute.creator.empty()) tag.setPrivateCreator(attribute.creator.c_str());
    }
    if (const std::string name = tag.getTagName(); name != DcmTag_ERROR_TagName) attribute.name = name;
    auto* sequence = dynamic_cast<DcmSequenceOfItems*>(element);
    if (!sequence || dynamic_cast<DcmPixelSequence*>(element)) {
      attribute.value = valueOf(*element, item, dataset);
      continue;
    }
    for (unsigned long nested = 0; nested < sequence->card(); ++nested)
      attribute.items.push_back(attributesOf(*sequence->getItem(nested), dataset));
  }
  return attributes;
}

bool holds(std::string_view text, std::string_view wanted) {
  return lowered(std::string(text)).find(wanted) != std::string::npos;
}

}  // namespace

std::string DicomAttribute::tag() const {
  std::array<char, 12> text{};
  std::snprintf(text.data(), text.size(), "(%04X,%04X)", static_cast<unsigned>(group), static_cast<unsigned>(element));
  return text.data();
}

std::vector<DicomAttribute> readAttributes(const fs::path& file) {
  PackedFiles packed;
  DcmFileFormat object;
  loadObject(packed.contentOf(file), object);
  DcmDataset& dataset = *object.getDataset();
  std::vector<DicomAttribute> attributes = attributesOf(*object.getMetaInfo(), dataset);
  std::vector<DicomAttribute> ofDataset = attributesOf(dataset, dataset);
  std::move(ofDataset.begin(), ofDataset.end(), std::back_inserter(attributes));
  return attributes;
}

void hideValues(std::vector<DicomAttribute>& attributes, const std::function<bool(const DicomAttribute&)>& hides) {
  const std::function<bool(const DicomAttribute&)> always = [](const DicomAttribute&) { return true; };
  for (DicomAttribute& attribute : attributes) {
    attribute.isHidden = hides(attribute);
    if (attribute.isHidden) attribute.value.clear();
    for (std::vector<DicomAttribute>& item : attribute.items) hideValues(item, attribute.isHidden ? always : hides);
  }
}

std::vector<DicomAttribute> attributesWith(const std::vector<DicomAttribute>& attributes, std::string_view text) {
  const std::string wanted = lowered(std::string(text));
  std::vector<DicomAttribute> found;
  for (const DicomAttribute& attribute : attributes) {
    if (holds(attribute.tag(), wanted) || holds(attribute.name, wanted) || holds(attribute.value, wanted)) {
      found.push_back(attribute);
      continue;
    }
    DicomAttribute around = attribute;
    around.items.clear();
    for (const std::vector<DicomAttribute>& item : attribute.items)
      if (std::vector<DicomAttribute> inside = attributesWith(item, text); !inside.empty())
        around.items.push_back(std::move(inside));
    if (!around.items.empty()) found.push_back(std::move(around));
  }
  return found;
}

}  // namespace fenestra::io
