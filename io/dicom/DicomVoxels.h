#pragma once
// The pixels of a stack of slices as voxels.

#include <map>
#include <string>

#include "io/base/Reading.h"
#include "io/dicom/DicomStack.h"
#include "io/dicom/SharedProgress.h"

namespace fenestra::io {

/// How stored samples become voxels: one map for the whole volume, or each slice's own applied on the way.
struct Mapping {
  ScalarType type = ScalarType::UInt8;
  double slope = 1.0, intercept = 0.0;  ///< of the volume
  bool applied = false;                 ///< voxels are real values already
};
Mapping mappingOf(const DicomStack& stack, const std::vector<DicomFile>& files);

struct DecodedStack {
  Voxels voxels;                                      ///< unusable when a file failed
  std::map<std::size_t, std::string> failed;          ///< causes, by index of the file
  std::map<std::size_t, std::size_t> samplesOutside;  ///< samples that the header rules out, by index of the file
  std::map<std::size_t, std::size_t> bytesBehind;     ///< behind the last RLE run, by index of the file
};
/// Throws Error, Cancelled.
DecodedStack decodeStack(const DicomStack& stack, const std::vector<DicomFile>& files, const Mapping& mapping,
                         const ProgressPart& part);

}  // namespace fenestra::io
