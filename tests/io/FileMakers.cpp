#include "tests/io/FileMakers.h"

#include "tests/io/IoTesting.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

Make file(const char* name, const std::string& bytes) {
  return [=](const fs::path& folder) {
    writeFile(folder / name, bytes);
    return folder / name;
  };
}

std::string counting(int count) {
  std::vector<std::int16_t> values;
  for (int i = 0; i < count; ++i) values.push_back(static_cast<std::int16_t>(i));
  return bytesOf(values);
}

Make nifti(NiftiSpec spec, const std::string& voxels) {
  if (spec.sform == 0 && spec.qform == 0) {
    spec.sform = 1;
    spec.srow = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  }
  return file("a.nii", niftiHeader(spec) + voxels);
}
Make niftiPlain(NiftiSpec spec) { return file("a.nii", niftiHeader(spec) + counting(24)); }
Make niftiSform(const std::vector<double>& rows) { return nifti({.sform = 1, .srow = rows}); }

std::string nrrdBytes(const Fields& fields, const std::string& voxels) {
  Fields all{{"type", "short"},
             {"dimension", "3"},
             {"space", "left-posterior-superior"},
             {"sizes", "2 3 4"},
             {"space directions", "(1,0,0) (0,1,0) (0,0,1)"},
             {"space origin", "(0,0,0)"},
             {"endian", "little"},
             {"encoding", "raw"}};
  for (const auto& [name, value] : fields) all[name] = value;
  std::string header = "NRRD0004\n";
  // A data file's list ends the header.
  for (const auto& [name, value] : all)
    if (value != "-" && name != "data file") header += name + ": " + value + "\n";
  if (all.contains("data file")) return header + "data file: " + all["data file"] + "\n";
  return header + "\n" + voxels;
}
Make nrrd(const Fields& fields, const std::string& voxels) { return file("a.nrrd", nrrdBytes(fields, voxels)); }
Make unplacedNrrd(Fields fields) {
  fields.insert({{"space", "-"}, {"space directions", "-"}, {"space origin", "-"}});
  return nrrd(fields);
}

Make metaImage(const Fields& fields, const std::string& voxels) {
  Fields all{{"NDims", "3"},
             {"DimSize", "2 3 4"},
             {"ElementSpacing", "1 1 1"},
             {"Offset", "0 0 0"},
             {"ElementType", "MET_SHORT"},
             {"BinaryData", "True"},
             {"ElementDataFile", "LOCAL"}};
  for (const auto& [name, value] : fields) all[name] = value;
  std::string header;
  for (const auto& [name, value] : all)
    if (value != "-" && name != "ElementDataFile") header += name + " = " + value + "\n";
  return file("a.mha", header + "ElementDataFile = " + all["ElementDataFile"] + "\n" + voxels);
}

Make outside(const char* name, const std::string& header) {
  return [=](const fs::path& folder) {
    fs::create_directories(folder / "inner");
    writeFile(folder / "voxels.raw", counting(24));
    writeFile(folder / "inner" / name, header);
    return folder / "inner" / name;
  };
}
std::string metaHeader(const std::string& dataFile) {
  return "NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1\nElementType = MET_SHORT\nElementDataFile = " + dataFile +
         "\n";
}

}  // namespace fenestra::tests
