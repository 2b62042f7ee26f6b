#pragma once
// Takes faces out of the pixels of CT and MR images of a head (PS3.15 E.3.2, Clean Recognizable Visual Features).
// Include in .cpp files alone.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomFile.h"
#include "rendering/segmentation/Face.h"

namespace fenestra::io::deidentify {

class FaceRemoval {
 public:
  /// Finds the faces of all series among the files, each in the largest volume of its series. Throws Cancelled.
  FaceRemoval(const std::vector<std::filesystem::path>& files, const Progress& progress);

  /// Blanks the face in the pixels of an object that was read from `file`; they become uncompressed. Returns why that
  /// cannot be done, as a clause; empty: it is done. Throws Error where the pixels cannot be decoded.
  std::string removeFrom(DcmDataset& object, const std::filesystem::path& file) const;
  /// Makes an object say what removeFrom() did; it comes after cleaning, which would take the words away.
  static void sayRemoved(DcmDataset& object);

  /// Whether the object holds pictures, of which a face must be taken out.
  static bool concerns(DcmItem& object);

 private:
  struct Found {
    segmentation::FaceSearch search;
    double background = 0.0;  ///< the real value of air, which takes the place of the face
  };
  static Found findIn(const std::vector<DicomFile>& files, const Progress& progress);

  std::map<std::string, Found> found_;  ///< by Series Instance UID
};

}  // namespace fenestra::io::deidentify
