#pragma once
// From single slices to volumes: which belong together, in which order, on which grid, and what is odd about them.
// Geometry alone; reads no files and no pixels.

#include <vector>

#include "io/dicom/DicomStack.h"

namespace fenestra::io {

/// The volumes among the frames of one series, largest first. `files` are the scanned files that frames refer to.
/// Slices are told apart by size, orientation, spacing, frame of reference, frame type, stack, and the attributes of
/// ImageParts.h; frames of reference of single slices are none and do not count. A slice further away than ten times
/// the usual distance, and the second and later frames at one position (Repeats.h), form volumes of their own.
std::vector<DicomStack> stackFrames(const std::vector<DicomFrame>& frames, const std::vector<DicomFile>& files);

}  // namespace fenestra::io
