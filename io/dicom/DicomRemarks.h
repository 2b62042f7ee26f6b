#pragma once
// What the user must know about the slices of a volume beyond their geometry: values that the headers lack, and where
// the headers contradict each other.

#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/DicomStack.h"

namespace fenestra::io {

/// `files` are the scanned files that the stack's frames refer to.
std::vector<Warning> remarksOn(const DicomStack& stack, const std::vector<DicomFile>& files);

}  // namespace fenestra::io
