#include "io/dicom/DicomValues.h"

#include <algorithm>
#include <charconv>

#include <dcmtk/dcmdata/dcspchrs.h>

#include "io/base/Text.h"

namespace fenestra::io {

namespace {

/// The text of an element of any VR of text, with its separators; private elements of unknown VR are taken as text.
std::optional<std::string_view> rawText(DcmElement& element) {
  char* text = nullptr;
  Uint32 length = 0;
  if (dynamic_cast<DcmByteString*>(&element))
    return element.getString(text, length).good() && text ? std::string_view(text, length) : std::string_view();
  Uint8* bytes = nullptr;
  if (element.ident() == EVR_UN && element.getUint8Array(bytes).good() && bytes)
    return std::string_view(reinterpret_cast<const char*>(bytes), element.getLength());
  return std::nullopt;
}

std::string_view valueAt(std::string_view text, unsigned long position) {
  for (; position > 0; --position) {
    const std::size_t separator = text.find('\\');
    if (separator == std::string_view::npos) return {};
    text.remove_prefix(separator + 1);
  }
  return text.substr(0, text.find('\\'));
}

/// The number of an element of a binary VR.
std::optional<double> binaryNumber(DcmElement& element, unsigned long position) {
  Float64 fd = 0.0;
  Float32 fl = 0.0F;
  Sint32 sl = 0;
  Uint32 ul = 0;
  Sint16 ss = 0;
  Uint16 us = 0;
  if (element.getFloat64(fd, position).good()) return fd;
  if (element.getFloat32(fl, position).good()) return fl;
  if (element.getUint16(us, position).good()) return us;
  if (element.getSint16(ss, position).good()) return ss;
  if (element.getUint32(ul, position).good()) return ul;
  if (element.getSint32(sl, position).good()) return sl;
  return std::nullopt;
}

}  // namespace

std::optional<double> decimalIn(std::string_view text) {
  std::string word = trimmed(text);
  if (std::count(word.begin(), word.end(), ',') == 1 && word.find('.') == std::string::npos)
    std::replace(word.begin(), word.end(), ',', '.');
  const auto value = numberIn<double>(word);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string decimalText(double value) {
  char text[40];
  for (int digits = 15;; --digits) {
    // Not printf, whose decimal point is the locale's.
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
    if (const auto length = static_cast<std::size_t>(end - text); length <= 16 || digits == 1) return {text, length};
  }
}

bool usesDecimalCommas(DcmItem& item) {
  DcmStack stack;
  while (item.nextObject(stack, OFTrue).good()) {
    DcmObject* object = stack.top();
    if (object->ident() != EVR_DS) continue;
    const auto text = rawText(*static_cast<DcmElement*>(object));
    if (text && text->find(',') != std::string_view::npos) return true;
  }
  return false;
}

std::optional<double> numberOf(DcmItem& item, const DcmTagKey& tag, unsigned long position) {
  DcmElement* element = nullptr;
  if (item.findAndGetElement(tag, element).bad() || !element) return std::nullopt;
  if (const auto text = rawText(*element)) return decimalIn(valueAt(*text, position));
  const auto value = binaryNumber(*element, position);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> integerOf(DcmItem& item, const DcmTagKey& tag) {
  const auto value = numberOf(item, tag);
  // 2^53: up to here every integer is a double.
  if (!value || *value != std::trunc(*value) || std::abs(*value) > 9007199254740992.0) return std::nullopt;
  return static_cast<std::int64_t>(*value);
}

std::string textOf(DcmItem& item, const DcmTagKey& tag) {
  OFString value;
  return item.findAndGetOFStringArray(tag, value).good() ? trimmed({value.data(), value.size()}) : std::string();
}

std::string codeOf(DcmItem& item, const DcmTagKey& tag) {
  std::string code = textOf(item, tag);
  for (char& c : code)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return code;
}

std::string typedTextOf(DcmItem& item, const DcmTagKey& tag, DcmItem* dataset) {
  OFString value, utf8;
  if (item.findAndGetOFStringArray(tag, value).bad()) return {};
  DcmSpecificCharacterSet converter;
  const bool converted =
      converter.selectCharacterSet(dataset ? *dataset : item).good() && converter.convertString(value, utf8).good();
  std::string result =
      trimmed(converted ? std::string_view(utf8.data(), utf8.size()) : std::string_view(value.data(), value.size()));
  if (!converted) std::erase_if(result, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  return result;
}

std::optional<DcmTagKey> privateTag(DcmItem& item, Uint16 group, const char* creator, Uint16 element) {
  // Blocks are reserved from the first one on; no maker uses more than a few in one file.
  for (Uint16 block = 0x10; block < 0x20; ++block)
    if (textOf(item, DcmTagKey(group, block)) == creator)
      return DcmTagKey(group, static_cast<Uint16>(block << 8 | element));
  return std::nullopt;
}

DcmItem* firstItem(DcmItem* item, const DcmTagKey& sequence) {
  DcmItem* found = nullptr;
  return item && item->findAndGetSequenceItem(sequence, found, 0).good() ? found : nullptr;
}

}  // namespace fenestra::io
