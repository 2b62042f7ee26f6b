#pragma once
// The attributes of a DICOM file, as lists and searches show them. Texts are UTF-8.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fenestra::io {

struct DicomTag;

/// An item of a sequence; `number` counts from 1 in the file.
struct DicomTagItem {
  std::size_t number = 0;
  std::vector<DicomTag> tags;
};

/// One attribute (PS3.5 7.1).
struct DicomTag {
  std::uint16_t group = 0, element = 0;
  std::string vr;        ///< "PN"
  std::string name;      ///< keyword of PS3.6, "PatientName", or that of DCMTK's list of private ones; empty: unknown
  std::string creator;   ///< who owns a private attribute; empty otherwise, and where its block has no owner
  std::string value;     ///< several are parted by backslashes; empty where only the size is told
  bool hasText = false;  ///< false: a sequence, or bytes of which only the size is told
  std::uint64_t bytes = 0;    ///< of the stored value, of compressed pixels all fragments; 0 for sequences
  bool identifies = false;    ///< the value may identify the patient; see readDicomTags()
  std::size_t itemCount = 0;  ///< of a sequence in the file
  std::vector<DicomTagItem> items;

  bool isSequence() const { return vr == "SQ"; }
  /// "0010,0010"
  std::string number() const;
};

/// The attributes of a file, its meta header first, up to the pixel data, of which the size is told. Values of more
/// than 64 KiB, and binary ones, are told by their size. Of the functional groups of single frames, which may be
/// thousands, only those of the stored frame `frame`, from 0, are listed. A file that gzip packed is unpacked.
///
/// `identifies` follows PS3.15 E.1, on the side of hiding: all of group 0010; names, dates, times, ages, addresses and
/// titles of stations by their VR; free texts but a few that describe the machine; UIDs but those of the standard; and
/// private and unknown attributes. Throws Error when the file cannot be read.
std::vector<DicomTag> readDicomTags(const std::filesystem::path& path, std::size_t frame);

/// Removes the values that may identify the patient; `identifies` says where.
void hidePatient(std::vector<DicomTag>& tags);

/// Those whose number, name, creator or value holds `text`, letters of ASCII in either case. A sequence whose own
/// texts do is kept as it is, another with what is found within it. All of them for an empty text.
std::vector<DicomTag> tagsHolding(const std::vector<DicomTag>& tags, std::string_view text);

}  // namespace fenestra::io
