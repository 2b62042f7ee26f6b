#pragma once
// The words by which an object names people, and where else they stand. Include in .cpp files alone.

#include <string>
#include <string_view>
#include <vector>

#include "io/deidentify/PlainWords.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::deidentify {

/// What an object says of people: in all attributes that hold a person's name, and in the patient's numbers, the
/// accession number and the date of birth, wherever they are nested.
class OwnNames {
 public:
  explicit OwnNames(DcmItem& object);

  /// Parts of names of three letters or more, and the numbers, in small letters.
  const Names& words() const { return words_; }
  /// Whether a text holds one of them as a word, or a number of four characters or more anywhere.
  bool isNamedIn(std::string_view text) const;

 private:
  void add(DcmItem& item);

  Names words_;
  std::vector<std::string> numbers_;
};

}  // namespace fenestra::io::deidentify
