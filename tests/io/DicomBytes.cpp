#include "tests/io/DicomBytes.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "tests/io/IoTesting.h"

namespace fenestra::tests {
namespace {

std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

bool hasLongLength(const std::string& vr) {
  constexpr std::string_view longOnes = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
  return longOnes.find(vr) != std::string_view::npos;
}

}  // namespace

std::string shortValue(int value) { return bytesOf(static_cast<std::uint16_t>(value)); }

DicomBytes::DicomBytes(const std::string& file) {
  // The group length is the first element of the meta header, at 132; its value counts from 144 on.
  std::size_t at = 144 + number(file, 140, 4);
  preamble = file.substr(0, at);
  while (at < file.size()) {
    Element element;
    element.tag = number(file, at, 2) << 16 | number(file, at + 2, 2);
    element.vr = file.substr(at + 4, 2);
    const bool isLong = hasLongLength(element.vr);
    const std::uint32_t length = isLong ? number(file, at + 8, 4) : number(file, at + 6, 2);
    at += isLong ? 12 : 8;
    element.undefinedLength = isLong && length == 0xffffffff;
    // Compressed pixels are the last element. Sequences need the writer's explicit lengths.
    element.value = file.substr(at, element.undefinedLength ? std::string::npos : length);
    at += element.value.size();
    elements_.push_back(std::move(element));
  }
}

std::vector<DicomBytes::Element>::iterator DicomBytes::at(std::uint32_t tag) {
  return std::find_if(elements_.begin(), elements_.end(), [&](const Element& element) { return element.tag == tag; });
}

void DicomBytes::set(std::uint32_t tag, const std::string& vr, std::string value) {
  if (value.size() % 2 != 0) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
  auto element = at(tag);
  if (element == elements_.end()) {
    element = std::find_if(elements_.begin(), elements_.end(), [&](const Element& other) { return other.tag > tag; });
    element = elements_.insert(element, Element{.tag = tag, .vr = {}, .value = {}});
  }
  element->vr = vr;
  element->value = std::move(value);
}

DicomBytes::Element& DicomBytes::existing(std::uint32_t tag) {
  const auto element = at(tag);
  if (element == elements_.end()) throw std::out_of_range("the file has no such element");
  return *element;
}

void DicomBytes::drop(std::uint32_t tag) {
  existing(tag);
  elements_.erase(at(tag));
}

void DicomBytes::makeUnknown(std::uint32_t tag) { existing(tag).vr = "UN"; }

std::string& DicomBytes::value(std::uint32_t tag) { return existing(tag).value; }

std::string DicomBytes::bytes() const {
  std::string file = preamble;
  for (const Element& element : elements_) {
    file += shortValue(static_cast<int>(element.tag >> 16)) + shortValue(static_cast<int>(element.tag & 0xffff));
    file += element.vr;
    const auto length = element.undefinedLength ? 0xffffffff : static_cast<std::uint32_t>(element.value.size());
    file += hasLongLength(element.vr) ? std::string(2, '\0') + bytesOf(length) : shortValue(static_cast<int>(length));
    file += element.value;
  }
  return file;
}

}  // namespace fenestra::tests
