#pragma once
// DICOM files of known content, written with DCMTK.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::tests {

/// One frame's functional groups.
struct FrameSpec {
  glm::dvec3 position{0.0};
  double slope = 1.0, intercept = 0.0;
  std::string type = "ORIGINAL\\PRIMARY\\AXIAL\\NONE";
};

enum class Syntax { ImplicitLittle, ExplicitLittle, ExplicitBig, Deflated, Rle, JpegLossless, JpegLs };

struct DicomSpec {
  std::string sopClass = "1.2.840.10008.5.1.4.1.1.2";  ///< CT Image Storage
  std::string instance = "1.2.3.4.5";
  std::string series = "1.2.3.4";
  std::string modality = "CT";
  std::string description;
  std::string patientName, patientId, birthDate, sex, accessionNumber, study, date;
  std::string seriesNumber, imageType, thickness, kernel;
  Syntax syntax = Syntax::ExplicitLittle;
  int columns = 4, rows = 3;
  int bitsAllocated = 16, bitsStored = 16, highBit = 15;
  bool isSigned = true;
  std::string photometric = "MONOCHROME2";
  int samplesPerPixel = 1;
  std::vector<std::uint32_t> words;  ///< as allocated, rows · columns · frames; empty: 0, 1, 2, …
  std::optional<glm::dvec3> position = glm::dvec3(0.0);
  glm::dvec3 row{1, 0, 0}, column{0, 1, 0};
  std::string pixelSpacing = "1\\1";  ///< rows \ columns
  std::string frameOfReference = "1.2.3";
  std::optional<std::string> slope, intercept;
  std::string window;  ///< "centre width"
  int instanceNumber = 1;
  int acquisitionNumber = 1;
  std::vector<FrameSpec> frames;          ///< enhanced multi-frame when not empty
  std::string doseScaling, frameOffsets;  ///< RT dose
  int numberOfFrames = 1;                 ///< without functional groups
  bool explicitLengths = false;           ///< of sequences
};

/// 40×30 pixels of 12 bits. DCMTK's JPEG-LS encoder overruns its buffer with images of a few pixels.
DicomSpec pictureSpec(Syntax syntax = Syntax::ExplicitLittle);

void writeDicom(const std::filesystem::path& path, const DicomSpec& spec);

/// An image record of a DICOMDIR.
struct DirectoryRecord {
  std::string fileId;  ///< parts between backslashes
  bool inUse = true;
};
void writeDicomDir(const std::filesystem::path& path, const std::vector<DirectoryRecord>& records);

}  // namespace fenestra::tests
