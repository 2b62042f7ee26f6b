#pragma once
// What the Basic Application Level Confidentiality Profile of DICOM PS3.15 annex E does with each attribute. The table
// E.1-1 is data: resources/deidentify/profile.tsv.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace fenestra::io::deidentify {

/// Options of PS3.15 E.3, each of which relaxes the profile.
struct Options {
  bool retainDates = false;       ///< E.3.6.1: dates and times stay
  bool retainUids = false;        ///< E.3.9
  bool cleanDescriptors = false;  ///< E.3.5: descriptions keep the words that are known to be harmless
  bool cleanGraphics = false;     ///< E.3.3: annotations keep their shapes, and such words
  bool removeFace = false;        ///< E.3.2: faces are taken out of the pixels of CT and MR; not with retainUids
};

enum class Action : std::uint8_t {
  Keep,
  Remove,
  Empty,
  Dummy,   ///< a value of the VR that says nothing; of a sequence: its items stay, and their values become dummies
  NewUid,  ///< of a sequence: its items stay, with new UIDs
  Clean
};
/// One English word for a report.
const char* wordOf(Action action);

/// A row of the table.
struct Row {
  std::uint32_t tag = 0;   ///< group · 65536 + element; digits that stand for any are 0
  std::uint32_t mask = 0;  ///< of the digits of the tag that count
  std::string actions;     ///< as in the table: "X/Z/D"
  bool dates = false, uids = false, descriptors = false, graphics = false;  ///< options that have an entry in it
  std::string keyword;
};
/// All rows, by tag.
std::span<const Row> rows();
/// Empty where the table does not list the attribute.
const Row* rowOf(std::uint16_t group, std::uint16_t element);

/// The profile alone. The table leaves a choice between actions to the kind of object: X where the attribute may be
/// absent (type 3), Z where it may be empty (type 2), D or U where it must have a value (type 1). The last one of a row
/// is valid in each of these cases, so it is taken whatever the object.
Action basicAction(const Row& row);
/// With options: where one of them keeps the attribute it is kept; otherwise, where one cleans it, it is cleaned.
Action actionOf(const Row& row, const Options& options);

}  // namespace fenestra::io::deidentify
