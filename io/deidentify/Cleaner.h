#pragma once
// Takes out of a DICOM object what names people. Include in .cpp files alone.

#include "io/deidentify/Changes.h"
#include "io/deidentify/NewUids.h"
#include "io/deidentify/OwnNames.h"
#include "io/deidentify/Profile.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::deidentify {

/// Treats each attribute of an object, however deep it is nested, by the profile's table. Attributes that the table
/// does not list:
/// - private ones, and those that the standard does not have, go; so do texts and sequences of unknown VR, which nobody
///   can examine, and the rest of an overlay whose data goes;
/// - UIDs are replaced unless they name a kind of object or coding, or are the standard's own;
/// - names of people, dates and times become empty (dates stay where they are retained);
/// - texts that hold a word by which the object names people become dummies;
/// - all else stays: pixels, geometry, how the picture was taken, codes.
class Cleaner {
 public:
  /// All must outlive this object.
  Cleaner(const Options& options, NewUids& uids, Changes& changes)
      : options_(options), uids_(uids), changes_(changes) {}

  /// The dataset of one object, with what says how it was de-identified (PS3.15 E.1.1, PS3.3 C.7.1.1).
  void clean(DcmItem& object);

 private:
  /// Where an attribute stands.
  enum class Within { Plain, Dummy, Clean };

  void cleanItem(DcmItem& item, Within within);
  Action actionFor(DcmElement& element, Within within) const;
  Action unlisted(DcmElement& element, Within within) const;
  void apply(DcmItem& item, DcmElement& element, Action action, Within within);
  void nested(DcmElement& sequence, Within within);
  void replaceUids(DcmElement& element);
  bool cleanText(DcmElement& element) const;
  void record(DcmElement& element, Action action);

  const Options& options_;
  NewUids& uids_;
  Changes& changes_;
  const OwnNames* names_ = nullptr;
};

}  // namespace fenestra::io::deidentify
