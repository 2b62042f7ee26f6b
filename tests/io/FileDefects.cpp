#include <limits>
#include <numeric>

#include "tests/io/AnalyzeBytes.h"
#include "tests/io/Defects.h"
#include "tests/io/FileMakers.h"
#include "tests/io/IoTesting.h"
#include "tests/io/MghBytes.h"
#include "tests/io/NiftiBytes.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

std::string withReturns(const std::string& lines) {
  std::string all;
  for (const char c : lines) all += c == '\n' ? "\r\n" : std::string(1, c);
  return all;
}

std::vector<Defect> niftiDefects() {
  const Expected ignoredSform = warning("its sform is not three independent axes");
  const Expected implausible = error("its geometry is not plausible");
  const Expected scaling = warning("its scl_slope or scl_inter is no number; values are shown as stored");
  const Expected pixdim = warning("its pixdim is not three positive numbers; 1 mm is assumed");
  const NiftiSpec sided{.sform = 1, .srow = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  const float floatNan = std::numeric_limits<float>::quiet_NaN(),
              floatInfinite = std::numeric_limits<float>::infinity();
  return {
      {"nifti", nifti({}), opens},
      {"nifti with NaN in its sform", niftiSform({nan, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}), ignoredSform},
      {"nifti with a zero sform", niftiSform({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), ignoredSform},
      {"nifti with a flat sform", niftiSform({1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0}), ignoredSform},
      {"nifti with a bad sform and a qform",
       nifti({.qform = 1, .sform = 1, .srow = {nan, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}),
       warning("the qform takes its place")},
      {"nifti with an infinite origin", niftiSform({1, 0, 0, infinite, 0, 1, 0, 0, 0, 0, 1, 0}), ignoredSform},
      {"nifti with NaN in its qform", nifti({.qform = 1, .quatern = {nan, 0, 0, 0, 0, 0}}),
       warning("its qform is no rotation")},
      {"nifti with voxels of 1e30 mm", niftiSform({1e30, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}), implausible},
      {"nifti with voxels of 1e-20 mm", niftiSform({1e-20, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}), implausible},
      {"nifti at 1e20 mm", niftiSform({1, 0, 0, 1e20, 0, 1, 0, 0, 0, 0, 1, 0}), implausible},
      {"nifti without orientation", niftiPlain({}), warning("the file stores no orientation")},
      {"nifti with zero pixdim", niftiPlain({.pixdim = {1, 0, 1, 1}}), pixdim},
      {"nifti with NaN as pixdim", niftiPlain({.pixdim = {1, nan, 1, 1}}), pixdim},
      {"nifti with negative pixdim", niftiPlain({.pixdim = {1, -2, 1, 1}}), warning("its pixdim is negative")},
      {"nifti with NaN as slope", nifti({.slope = floatNan}), scaling},
      {"nifti with infinite slope", nifti({.slope = floatInfinite}), scaling},
      {"nifti with NaN as intercept", nifti({.slope = 1, .intercept = floatNan}), scaling},
      {"nifti with bytes behind its voxels", nifti({}, counting(24) + "end"), opens},
      {"packed nifti in two pieces", file("a.nii.gz", gzipped(niftiHeader(sided)) + gzipped(counting(24))), opens},
      {"packed nifti with zeros behind it",
       file("a.nii.gz", gzipped(niftiHeader(sided) + counting(24)) + std::string(512, '\0')), opens},
      {"nifti that names no offset",
       [=](const fs::path& folder) {
         std::string header = niftiHeader(sided);
         header.replace(108, 4, bytesOf(0.0F));
         writeFile(folder / "a.nii", header + counting(24));
         return folder / "a.nii";
       },
       opens},
      {"nifti of colours", nifti({.datatype = 128}), error("holds colours")},
      {"nifti of complex numbers", nifti({.datatype = 32}), error("data type 32")},
      {"nifti of an unknown type", nifti({.datatype = 999}), error("data type 999")},
      {"nifti of no dimensions", nifti({.dims = {}}), error("gives 0 dimensions")},
      {"nifti of zero columns", nifti({.dims = {0, 3, 4}}), error("its header says 0 x 3 x 4 voxels")},
      {"nifti of negative rows", nifti({.dims = {2, -3, 4}}), error("its header says 2 x -3 x 4 voxels")},
      {"nifti of vectors", nifti({.dims = {2, 3, 4, 1, 3}}), error("holds vectors of 3 components")},
      {"nifti of a negative number of time points", nifti({.dims = {2, 3, 4, -1}}), error("a dimension of no length")},
      {"nifti of no time points but vectors", nifti({.dims = {2, 3, 4, 0, 3}}), error("a dimension of no length")},
      {"nifti of 20000 a side", nifti({.dims = {20000, 20000, 20000}}), error("larger than this machine's memory")},
      {"nifti cut", nifti({}, counting(10)), error("holds 20 bytes of voxels where its header describes 48")},
      {"nifti without its voxels", nifti({.pair = true}), error("a .hdr file needs the .img file beside it")},
      {"nifti cut in its header", file("a.nii", niftiHeader({}).substr(0, 200)),
       error("its content is something else")},
      {"packed nifti cut",
       [](const fs::path& folder) {
         const std::string packed = gzipped(niftiHeader({}) + counting(24));
         writeFile(folder / "a.nii.gz", packed.substr(0, packed.size() - 20));
         return folder / "a.nii.gz";
       },
       error("ends too early")},
      {"nifti of three time points", nifti({.dims = {2, 3, 4, 3}}, counting(72)),
       warning("holds 3 volumes (time points or layers); number 1 is shown; --time N chooses another")},
      {"nifti's third time point", nifti({.dims = {2, 3, 4, 3}}, counting(72)), warning("number 3 is shown"), "", 3},
      {"nifti's time point beyond the last", nifti({.dims = {2, 3, 4, 3}}, counting(72)), error("has no time point 7"),
       "", 7},
  };
}

std::vector<Defect> nrrdDefects() {
  const Expected implausible = error("its geometry is not plausible");
  const auto notUnderstood = [](const std::string& name) {
    return error("its header's '" + name + "' is not understood");
  };
  std::string hex;
  for (const char c : counting(24)) {
    constexpr const char* digits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    hex += {digits[byte >> 4], digits[byte & 15]};
    if (hex.size() % 9 == 0) hex += '\n';
  }
  const Fields withTime{{"dimension", "4"},
                        {"space", "left-posterior-superior-time"},
                        {"sizes", "2 3 4 3"},
                        {"space directions", "(1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,2)"},
                        {"space origin", "(0,0,0,0)"}};
  return {
      {"nrrd", nrrd({}), opens},
      {"nrrd with returns at its lines' ends",
       file("a.nrrd", withReturns("NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
                                  "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nendian: "
                                  "little\nencoding: raw\n\n") +
                          counting(24)),
       opens},
      {"nrrd in short words", nrrd({{"space", "LPS"}, {"type", "int16_t"}, {"encoding", "RAW"}}), opens},
      {"nrrd with bytes behind its voxels", nrrd({}, counting(24) + "end"), opens},
      {"nrrd with a comment and a key", nrrd({{"# made by", "hand"}, {"key:", "=value"}}), opens},
      {"packed nrrd with zeros behind it", nrrd({{"encoding", "gz"}}, gzipped(counting(24)) + std::string(512, '\0')),
       opens},
      {"nrrd in hexadecimal", nrrd({{"encoding", "hex"}}, hex), opens},
      {"nrrd of half its hexadecimal digits", nrrd({{"encoding", "hex"}}, hex.substr(0, 50)),
       error("where its header")},
      {"nrrd of other digits", nrrd({{"encoding", "hex"}}, std::string(200, 'x')), error("no hexadecimal digits")},
      {"nrrd of two dimensions",
       nrrd({{"dimension", "2"},
             {"sizes", "6 4"},
             {"space", "-"},
             {"space dimension", "2"},
             {"space directions", "(1,0) (0,2)"},
             {"space origin", "(5,6)"}}),
       warning("does not say how its axes lie in the patient")},
      {"nrrd with time", nrrd(withTime, counting(72)), warning("--time N chooses another")},
      {"nrrd's second time point", nrrd(withTime, counting(72)), warning("number 2 is shown"), "", 2},
      {"nrrd with directions of another length", nrrd({{"space directions", "(1,0) (0,1,0) (0,0,1)"}}),
       notUnderstood("space directions")},
      {"nrrd with directions in a plane", nrrd({{"space directions", "(1,0,0) (2,0,0) (0,0,1)"}}),
       notUnderstood("space directions")},
      {"nrrd with NaN as direction", nrrd({{"space directions", "(nan,0,0) (0,1,0) (0,0,1)"}}),
       notUnderstood("space directions")},
      {"nrrd with zero as direction", nrrd({{"space directions", "(0,0,0) (0,1,0) (0,0,1)"}}),
       notUnderstood("space directions")},
      {"nrrd with voxels of 1e30 mm", nrrd({{"space directions", "(1e30,0,0) (0,1,0) (0,0,1)"}}), implausible},
      {"nrrd at 1e20 mm", nrrd({{"space origin", "(1e20,0,0)"}}), implausible},
      {"nrrd with text as origin", nrrd({{"space origin", "here"}}), notUnderstood("space origin")},
      {"nrrd of an unknown space", nrrd({{"space", "outer"}}), error("its space 'outer' is not supported")},
      {"nrrd without spacings", unplacedNrrd({}), warning("its header has no spacings; 1 mm is assumed")},
      {"nrrd with NaN as spacing", unplacedNrrd({{"spacings", "1 nan 1"}}), warning("its spacings are not positive")},
      {"nrrd with zero spacing", unplacedNrrd({{"spacings", "1 0 1"}}), warning("its spacings are not positive")},
      {"nrrd with negative spacing", unplacedNrrd({{"spacings", "1 -2 1"}}), warning("its spacings are negative")},
      {"nrrd without sizes", nrrd({{"sizes", "-"}}), error("its header has no sizes")},
      {"nrrd of other sizes than dimensions", nrrd({{"dimension", "2"}}), notUnderstood("sizes")},
      {"nrrd of zero rows", nrrd({{"sizes", "2 0 4"}}), error("its header says 2 x 0 x 4 voxels")},
      {"nrrd of 2000000000 a side", nrrd({{"sizes", "2000000000 2000000000 2000000000"}}),
       error("its geometry is not plausible")},
      {"nrrd without type", nrrd({{"type", "-"}}), error("its header has no type")},
      {"nrrd of blocks", nrrd({{"type", "block"}}), error("has voxels of type 'block'")},
      {"nrrd without endianness", nrrd({{"endian", "-"}}), notUnderstood("endian")},
      {"nrrd of an unknown encoding", nrrd({{"encoding", "zip"}}), error("its encoding 'zip' is not supported")},
      {"nrrd cut", nrrd({}, counting(10)), error("holds 20 bytes of voxels where its header describes 48")},
      {"packed nrrd of noise", nrrd({{"encoding", "gzip"}}, std::string(500, '\x33')),
       error("its compressed data are damaged")},
      {"nrrd of words", nrrd({{"encoding", "ascii"}}, std::string(200, 'w')), error("where a number of its type")},
      {"nrrd of too few numbers", nrrd({{"encoding", "ascii"}}, "1 2 3 4"),
       error("holds 7 characters of voxels where its header describes 24 numbers")},
      {"nrrd of colours",
       nrrd({{"dimension", "4"},
             {"sizes", "3 2 3 4"},
             {"kinds", "RGB-color domain domain domain"},
             {"space directions", "none (1,0,0) (0,1,0) (0,0,1)"}},
            counting(72)),
       error("holds 3 values at each voxel (rgb-color)")},
      {"nrrd with a line that is no field", file("a.nrrd", "NRRD0004\nnonsense\n\n"), error("a line that is no field")},
      {"nrrd of a missing file", nrrd({{"data file", "absent.raw"}}), error("cannot be opened")},
      {"nrrd of a file outside", outside("a.nhdr", nrrdBytes({{"data file", "../voxels.raw"}})),
       error("names voxels outside its folder")},
      {"nrrd of a file of the machine", outside("a.nhdr", nrrdBytes({{"data file", "/etc/passwd"}})),
       error("allow it with --allow-outside")},
      {"nrrd with a wild pattern", nrrd({{"data file", "s%s 1 4 1"}}), error("pattern 's%s' is not understood")},
      {"nrrd skipping more lines than it has", nrrd({{"line skip", "999999"}}),
       error("fewer lines than its header skips")},
  };
}

std::vector<Defect> metaImageDefects() {
  const Expected implausible = error("its geometry is not plausible");
  const auto notUnderstood = [](const std::string& name) { return error("its header's " + name); };
  return {
      {"metaimage", metaImage({}), opens},
      {"metaimage with returns at its lines' ends",
       file("a.mha", withReturns("NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1\nOffset = 0 0 0\nElementType = "
                                 "MET_SHORT\nElementDataFile = LOCAL\n") +
                         counting(24)),
       opens},
      {"metaimage with a position and an orientation",
       metaImage({{"Offset", "-"}, {"Position", "1 2 3"}, {"Orientation", "1 0 0 0 1 0 0 0 1"}}), opens},
      {"metaimage with an origin and a rotation",
       metaImage({{"Offset", "-"}, {"Origin", "1 2 3"}, {"Rotation", "1 0 0 0 1 0 0 0 1"}}), opens},
      {"metaimage with a size of elements alone", metaImage({{"ElementSpacing", "-"}, {"ElementSize", "1 1 1"}}),
       opens},
      {"metaimage with bytes behind its voxels", metaImage({}, counting(24) + "end"), opens},
      {"metaimage whose header's size is to be found", metaImage({{"HeaderSize", "-1"}}), opens},
      {"metaimage without spacing", metaImage({{"ElementSpacing", "-"}}),
       warning("no ElementSpacing; 1 mm is assumed")},
      {"metaimage with negative spacing", metaImage({{"ElementSpacing", "1 -2 1"}}),
       warning("its ElementSpacing is negative; the sign is ignored")},
      {"metaimage with zero spacing", metaImage({{"ElementSpacing", "1 0 1"}}), notUnderstood("ElementSpacing")},
      {"metaimage with NaN as spacing", metaImage({{"ElementSpacing", "1 nan 1"}}), notUnderstood("ElementSpacing")},
      {"metaimage with text as spacing", metaImage({{"ElementSpacing", "wide"}}), notUnderstood("ElementSpacing")},
      {"metaimage with voxels of 1e30 mm", metaImage({{"ElementSpacing", "1e30 1 1"}}), implausible},
      {"metaimage at 1e20 mm", metaImage({{"Offset", "1e20 0 0"}}), implausible},
      {"metaimage with an infinite offset", metaImage({{"Offset", "inf 0 0"}}), notUnderstood("ElementSpacing")},
      {"metaimage with a flat matrix", metaImage({{"TransformMatrix", "1 0 0 1 0 0 0 0 1"}}),
       notUnderstood("ElementSpacing or TransformMatrix")},
      {"metaimage with a zero matrix", metaImage({{"TransformMatrix", "0 0 0 0 0 0 0 0 0"}}),
       notUnderstood("TransformMatrix")},
      {"metaimage with half a matrix", metaImage({{"TransformMatrix", "1 0 0"}}), notUnderstood("TransformMatrix")},
      {"metaimage with slope 0", metaImage({{"ElementToIntensityFunctionSlope", "0"}}),
       warning("ElementToIntensityFunctionSlope is 0; 1 is assumed")},
      {"metaimage with NaN as slope", metaImage({{"ElementToIntensityFunctionSlope", "nan"}}),
       notUnderstood("ElementToIntensityFunctionSlope")},
      {"metaimage of an unknown type", metaImage({{"ElementType", "MET_OTHER"}}), error("type 'MET_OTHER'")},
      {"metaimage of colours", metaImage({{"ElementNumberOfChannels", "3"}}), error("holds 3 values at each voxel")},
      {"metaimage of zero rows", metaImage({{"DimSize", "2 0 4"}}), error("its header says 2 x 0 x 4 voxels")},
      {"metaimage of 100 dimensions", metaImage({{"NDims", "100"}}), notUnderstood("DimSize")},
      {"metaimage cut", metaImage({}, counting(10)), error("holds 20 bytes of voxels where its header describes 48")},
      {"packed metaimage of noise", metaImage({{"CompressedData", "True"}}, std::string(500, '\x33')),
       error("its compressed data are damaged")},
      {"metaimage of a missing file", metaImage({{"ElementDataFile", "absent.raw"}}), error("cannot be opened")},
      {"metaimage of a file outside", outside("a.mhd", metaHeader("../voxels.raw")),
       error("names voxels outside its folder")},
      {"metaimage of a file of the machine", outside("a.mhd", metaHeader("/etc/passwd")),
       error("allow it with --allow-outside")},
      {"metaimage of a list outside", outside("a.mhd", metaHeader("LIST\n../voxels.raw")),
       error("names voxels outside its folder")},
      {"metaimage of three time points",
       metaImage({{"NDims", "4"}, {"DimSize", "2 3 4 3"}, {"ElementSpacing", "1 1 1 1"}, {"Offset", "0 0 0 0"}},
                 counting(72)),
       warning("number 2 is shown"), "", 2},
      {"metaimage without a data file", file("a.mha", "NDims = 3\nDimSize = 2 3 4\n"),
       error("its content is something else")},
  };
}

std::vector<std::int16_t> numbers(int count) {
  std::vector<std::int16_t> values(static_cast<std::size_t>(count));
  std::iota(values.begin(), values.end(), std::int16_t{0});
  return values;
}

std::vector<Defect> mghDefects() {
  const auto mgh = [](const MghSpec& spec, int voxels = 24) { return file("a.mgh", mghFile(spec, numbers(voxels))); };
  constexpr float notANumber = std::numeric_limits<float>::quiet_NaN(), huge = 1e30f;
  const Expected unusable = error("its header gives no usable geometry"),
                 implausible = error("its geometry is not plausible"), noMgh = error("is named .mgh but its content");
  const std::string packed = gzipped(mghFile(MghSpec{}, numbers(24)));
  return {
      {"mgh", mgh({}), opens},
      {"mgh without orientation", mgh({.hasGeometry = false}), warning("stores no orientation")},
      {"mgh of colours", mgh({.type = 6}), error("MGH data type 6")},
      {"mgh of zero rows", mgh({.dims = {2, 0, 4}}), noMgh},
      {"mgh of -3 columns", mgh({.dims = {-3, 3, 4}}), noMgh},
      {"mgh of 2e9 slices", mgh({.dims = {2, 3, 2'000'000'000}}), implausible},
      {"mgh of no frames", mgh({.frames = 0}), noMgh},
      {"mgh of two frames", mgh({.frames = 2}, 48), warning("the file holds 2 volumes")},
      {"mgh with spacing 0", mgh({.spacing = {0.0f, 1.0f, 1.0f}}), unusable},
      {"mgh with NaN as spacing", mgh({.spacing = {notANumber, 1.0f, 1.0f}}), unusable},
      {"mgh with voxels of 1e30 mm", mgh({.spacing = {huge, 1.0f, 1.0f}}), implausible},
      {"mgh with flat axes", mgh({.axes = {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}}}), unusable},
      {"mgh at NaN", mgh({.centre = {notANumber, 0.0f, 0.0f}}), unusable},
      {"mgh at 1e30 mm", mgh({.centre = {huge, 0.0f, 0.0f}}), implausible},
      {"mgh cut", mgh({}, 10), error("holds 20 bytes of voxels where its header describes 48")},
      {"packed mgh cut in its stream", file("a.mgz", packed.substr(0, packed.size() - 12)), error("ends too early")},
  };
}

/// Header and voxels in two files.
std::vector<Defect> analyzeDefects() {
  const auto pair = [](const AnalyzeSpec& spec, int voxels = 24) {
    return [=](const fs::path& folder) {
      writeFile(folder / "a.hdr", analyzeHeader(spec));
      writeFile(folder / "a.img", bytesOf(numbers(voxels), spec.swapped));
      return folder / "a.hdr";
    };
  };
  constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
  const Expected unsided = warning("do not say which side is left"), sizeAssumed = warning("are taken as 1 mm"),
                 implausible = error("its geometry is not plausible");
  return {
      {"analyze", pair({}), unsided},
      {"analyze in the other byte order", pair({.swapped = true}), unsided},
      {"analyze with spacing 0", pair({.spacing = {0, 1, 1}}), sizeAssumed},
      {"analyze with NaN as spacing", pair({.spacing = {notANumber, 1, 1}}), sizeAssumed},
      {"analyze with voxels of 1e30 mm", pair({.spacing = {1e30f, 1, 1}}), implausible},
      {"analyze of a negative offset", pair({.offset = -5}), error("its header gives no voxel offset")},
      {"analyze of an offset that is no number", pair({.offset = notANumber}), error("gives no voxel offset")},
      {"analyze of an offset beyond its end", pair({.offset = 1000}), error("holds 0 bytes of voxels")},
      {"analyze of an unknown orientation", pair({.orientation = 77}), unsided},
      {"analyze of two time points", pair({.dims = {2, 3, 4, 2}}, 48), warning("the file holds 2 volumes")},
      {"analyze cut", pair({}, 10), error("holds 20 bytes of voxels where its header describes 48")},
      {"analyze without its voxels", file("a.hdr", analyzeHeader({})), error("a.img")},
  };
}

std::vector<Defect> otherDefects() {
  return {
      {"raw", file("a.raw", counting(24)), opens, "2x3x4:int16"},
      {"raw of too few bytes", file("a.raw", counting(10)), error("holds 20 bytes of voxels"), "2x3x4:int16"},
      {"raw of more bytes than described", file("a.raw", counting(30)), warning("the description uses the first 48"),
       "2x3x4:int16"},
      {"raw beyond its end", file("a.raw", counting(24)), error("holds 0 bytes of voxels"), "2x3x4:int16:skip=9999"},
      {"raw with a time point", file("a.raw", counting(24)), error("has no time point 2"), "2x3x4:int16", 2},
      {"an empty file", file("a.dcm", ""), error("is empty")},
      {"a missing file", [](const fs::path& folder) { return folder / "absent.nii"; }, error("does not exist")},
      {"a jpeg picture", file("a.jpg", "\xff\xd8\xff\xe0..JFIF"), error("is a JPEG picture, not a volume")},
      {"a bmp picture", file("a.bmp", std::string("BM\x76\x2\0\0\0\0\0\0\x36\0\0\0", 14)),
       error("is a BMP picture, not a volume")},
      {"a rar archive", file("a.rar", std::string("Rar!\x1a\x07\1\0", 8)),
       error("is a RAR archive, not a volume; unpack it")},
      {"a minc file", file("a.mnc", "\x89HDF\r\n\x1a\n..."), error("is an HDF5 file (MINC, MATLAB or others)")},
      {"a vtk file", file("a.vtk", "# vtk DataFile Version 3.0\n"), error("is a VTK file, not a volume; convert it")},
      {"a letter named as a volume", file("a.nii", "Dear colleague"), error("is named .nii but its content")},
      {"a letter", file("a.txt", "Dear colleague"), error("holds no volume in a known format")},
  };
}

}  // namespace

std::vector<Defect> fileDefects() {
  std::vector<Defect> all;
  for (const auto& part :
       {niftiDefects(), nrrdDefects(), metaImageDefects(), mghDefects(), analyzeDefects(), otherDefects()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace fenestra::tests
