#pragma once
// NIfTI headers of known content.

#include <cstdint>
#include <string>
#include <vector>

namespace fenestra::tests {

/// NIfTI-1 and NIfTI-2 headers, field by field at the offsets that nifti1.h and nifti2.h give.
struct NiftiSpec {
  bool two = false, swapped = false, pair = false;
  std::vector<std::int64_t> dims{2, 3, 4};
  int datatype = 4;
  float slope = 0, intercept = 0;
  std::vector<double> pixdim{1, 1, 1, 1};
  int qform = 0, sform = 0, units = 2;
  std::vector<double> quatern{0, 0, 0, 0, 0, 0};
  std::vector<double> srow{};
};

/// The header with its four bytes of extension flag.
std::string niftiHeader(const NiftiSpec& spec);

}  // namespace fenestra::tests
