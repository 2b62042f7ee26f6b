#pragma once
// A DICOM file as the elements that it is written of, to damage them one by one.

#include <cstdint>
#include <string>
#include <vector>

namespace fenestra::tests {

/// An explicit little-endian file, its sequences with explicit lengths. Tags are group · 65536 + element. Naming an
/// element that the file does not have throws std::out_of_range.
class DicomBytes {
 public:
  explicit DicomBytes(const std::string& file);

  /// Replaces an element's value, or adds the element. Values are padded to an even length; those of encapsulated
  /// pixels are their items.
  void set(std::uint32_t tag, const std::string& vr, std::string value);
  void drop(std::uint32_t tag);
  /// Stores the element's bytes under the VR "unknown", as servers do with elements that they do not know.
  void makeUnknown(std::uint32_t tag);
  std::string& value(std::uint32_t tag);

  std::string preamble;  ///< 128 bytes, "DICM" and the meta header
  std::string bytes() const;

 private:
  struct Element {
    std::uint32_t tag = 0;
    std::string vr, value;
    bool undefinedLength = false;
  };
  std::vector<Element>::iterator at(std::uint32_t tag);
  Element& existing(std::uint32_t tag);

  std::vector<Element> elements_;
};

std::string shortValue(int value);  ///< two bytes, little-endian

}  // namespace fenestra::tests
