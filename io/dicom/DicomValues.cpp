#include "io/dicom/DicomValues.h"

#include <algorithm>

#include <dcmtk/dcmdata/dcspchrs.h>

#include "io/base/Text.h"

namespace fenestra::io {

std::optional<double> numberOf(DcmItem& item, const DcmTagKey& tag, unsigned long position) {
  Float64 value = 0.0;
  if (item.findAndGetFloat64(tag, value, position).bad() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::int64_t> integerOf(DcmItem& item, const DcmTagKey& tag) {
  Uint16 us = 0;
  if (item.findAndGetUint16(tag, us).good()) return us;
  Uint32 ul = 0;
  if (item.findAndGetUint32(tag, ul).good()) return ul;
  long is = 0;
  if (item.findAndGetLongInt(tag, is).good()) return is;
  return std::nullopt;
}

std::string textOf(DcmItem& item, const DcmTagKey& tag) {
  OFString value;
  return item.findAndGetOFStringArray(tag, value).good() ? trimmed({value.data(), value.size()}) : std::string();
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

DcmItem* firstItem(DcmItem* item, const DcmTagKey& sequence) {
  DcmItem* found = nullptr;
  return item && item->findAndGetSequenceItem(sequence, found, 0).good() ? found : nullptr;
}

}  // namespace fenestra::io
