#pragma once
// Makers of small volume files for the tables of defects: each returns a function that writes its file into a folder
// and returns the path. All hold 2 x 3 x 4 voxels of 16 bits that count from 0, unless told otherwise.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/io/NiftiBytes.h"

namespace fenestra::tests {

using Make = std::function<std::filesystem::path(const std::filesystem::path&)>;
/// Header fields by name; those with the value "-" are left out.
using Fields = std::map<std::string, std::string>;

Make file(const char* name, const std::string& bytes);
/// 0 to count - 1, as bytes.
std::string counting(int count);

/// With an sform of its own where `spec` has neither sform nor qform.
Make nifti(NiftiSpec spec, const std::string& voxels = counting(24));
Make niftiPlain(NiftiSpec spec);
Make niftiSform(const std::vector<double>& rows);

/// `fields` replace the header's.
std::string nrrdBytes(const Fields& fields, const std::string& voxels = counting(24));
Make nrrd(const Fields& fields, const std::string& voxels = counting(24));
/// Without a space, directions and origin.
Make unplacedNrrd(Fields fields);

Make metaImage(const Fields& fields, const std::string& voxels = counting(24));
/// A header that names `dataFile`.
std::string metaHeader(const std::string& dataFile);
/// A header in a folder of its own, and voxels beside that folder.
Make outside(const char* name, const std::string& header);

}  // namespace fenestra::tests
