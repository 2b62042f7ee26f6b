#pragma once
// The attributes of a DICOM file as a list to read.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fenestra::io {

struct DicomAttribute {
  std::uint16_t group = 0, element = 0;
  std::string vr;       ///< value representation, "PN"
  std::string name;     ///< keyword of DICOM's dictionary, "PatientName"; empty where it knows none
  std::string creator;  ///< owner of the private block that holds it; empty for attributes of the standard
  /// UTF-8, without control characters; numbers in decimal, several values parted by backslashes. Long values end with
  /// an ellipsis; of data, of pixels for instance, their size: "524288 bytes". Empty for a sequence.
  std::string value;
  bool isHidden = false;                           ///< see hideValues()
  std::vector<std::vector<DicomAttribute>> items;  ///< of a sequence

  /// "(0010,0010)"
  std::string tag() const;
};

/// What a file holds, its meta header first, each in ascending order of tags. Reads no pixels. Throws Error when the
/// file is no DICOM file, is damaged, or nests too deep.
std::vector<DicomAttribute> readAttributes(const std::filesystem::path& file);

/// Empties and marks the values of attributes for which `hides`, and of what is nested in those.
void hideValues(std::vector<DicomAttribute>& attributes, const std::function<bool(const DicomAttribute&)>& hides);

/// Those whose tag, name or value holds `text`, whatever its case (ASCII), with the sequences around them.
std::vector<DicomAttribute> attributesWith(const std::vector<DicomAttribute>& attributes, std::string_view text);

}  // namespace fenestra::io
