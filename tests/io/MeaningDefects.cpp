// Whole files whose headers a reader may misunderstand: units of length, decimal commas, and axes beyond the third.

#include "tests/io/AnalyzeBytes.h"
#include "tests/io/Defects.h"
#include "tests/io/FileMakers.h"
#include "tests/io/IoTesting.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

/// A row whose volume must have this spacing, mm.
Defect spaced(std::string name, Make make, Expected expected, glm::dvec3 spacing) {
  Defect defect{std::move(name), std::move(make), std::move(expected)};
  defect.spacing = spacing;
  return defect;
}

/// Voxels of 700 x 800 x 2500 in the unit.
Make nrrdIn(const std::string& unit) {
  return nrrd({{"space directions", "(700,0,0) (0,800,0) (0,0,2500)"},
               {"space origin", "(-30000,-40000,100000)"},
               {"space units", "\"" + unit + "\" \"" + unit + "\" \"" + unit + "\""}});
}
Make metaImageIn(const std::string& unit, const std::string& spacing = "700 800 2500") {
  return metaImage({{"ElementSpacing", spacing}, {"DistanceUnits", unit}});
}
Make niftiIn(int units, double scale) {
  return nifti(
      {.sform = 1, .units = units, .srow = {-0.7 * scale, 0, 0, 0, 0, -0.8 * scale, 0, 0, 0, 0, 2.5 * scale, 0}});
}
Make analyzeIn(const std::string& unit, std::array<float, 3> spacing) {
  return [=](const fs::path& folder) {
    AnalyzeSpec spec;
    spec.unit = unit;
    spec.spacing = spacing;
    writeFile(folder / "a.hdr", analyzeHeader(spec));
    writeFile(folder / "a.img", counting(24));
    return folder / "a.hdr";
  };
}

std::vector<Defect> unitDefects() {
  const glm::dvec3 micro(0.7, 0.8, 2.5);
  const Expected unplaced = warning("does not say how its axes lie in the patient"),
                 unknown = warning("its unit of length \"cubit\" is not known; lengths are read as millimetres"),
                 unsided = warning("do not say which side is left");
  std::vector<Defect> all;
  for (const char* word :
       {"microns", "micron", "um", "UM", "\xC2\xB5m", "\xCE\xBCm", "\xB5m", "micrometers", "micrometre"})
    all.push_back(
        spaced("nrrd in unit " + std::to_string(all.size() + 1) + " of micrometres", nrrdIn(word), opens, micro));
  const std::vector<Defect> others{
      spaced("nrrd in nanometres", nrrdIn("nm"), opens, 1e-3 * micro),
      spaced("nrrd in centimetres", nrrd({{"space units", "\"cm\" \"cm\" \"cm\""}}), opens, glm::dvec3(10)),
      spaced("nrrd in metres",
             nrrd({{"space units", "\"m\" \"m\" \"m\""}, {"space directions", "(0.001,0,0) (0,0.002,0) (0,0,0.003)"}}),
             opens, {1, 2, 3}),
      spaced("nrrd in inches", nrrd({{"space units", "\"inches\" \"inch\" \"in\""}}), opens, glm::dvec3(25.4)),
      spaced("nrrd in millimetres across and micrometres along",
             nrrd({{"space units", "\"mm\" \"mm\" \"um\""}, {"space directions", "(1,0,0) (0,1,0) (0,0,2500)"}}), opens,
             {1, 1, 2.5}),
      spaced("nrrd in units without quotes", nrrd({{"space units", "cm cm cm"}}), opens, glm::dvec3(10)),
      spaced("nrrd in no unit", nrrd({{"space units", "\"\" \"\" \"\""}}), opens, glm::dvec3(1)),
      spaced("nrrd with units of its own axes",
             unplacedNrrd({{"spacings", "700 800 2500"}, {"units", "\"um\" \"um\" \"um\""}}), unplaced, micro),
      spaced("nrrd with units of its own axes of several kinds",
             unplacedNrrd({{"spacings", "700 0.8 0.25"}, {"units", "\"microns\" \"mm\" \"cm\""}}), unplaced, micro),
      spaced("nrrd of three times with units of its own axes",
             nrrd({{"dimension", "4"},
                   {"sizes", "3 2 3 4"},
                   {"kinds", "list domain domain domain"},
                   {"space", "-"},
                   {"space directions", "-"},
                   {"space origin", "-"},
                   {"spacings", "nan 700 800 2500"},
                   {"units", "\"\" \"um\" \"um\" \"um\""}},
                  counting(72)),
             unplaced, micro),
      spaced("nrrd with directions and units of its own axes",
             nrrd({{"space directions", "(700,0,0) (0,800,0) (0,0,2500)"}, {"units", "\"um\" \"um\" \"um\""}}), opens,
             micro),
      spaced("nrrd in an unknown unit", nrrd({{"space units", "\"cubit\" \"cubit\" \"cubit\""}}), unknown,
             glm::dvec3(1)),
      {"nrrd in an unknown unit of implausible size", nrrdIn("cubit"),
       error("its unit of length \"cubit\" is not known; lengths are read as millimetres, and then its geometry is not "
             "plausible")},
      spaced("metaimage in micrometres", metaImageIn("um"), opens, micro),
      spaced("metaimage in centimetres", metaImageIn("cm", "1 2 3"), opens, {10, 20, 30}),
      spaced("metaimage in no unit", metaImageIn("?", "1 2 3"), opens, {1, 2, 3}),
      spaced("metaimage in an unknown unit", metaImageIn("cubit", "1 2 3"), unknown, {1, 2, 3}),
      spaced("nifti in metres", niftiIn(1, 1e-3), opens, micro),
      spaced("nifti in millimetres and seconds", niftiIn(10, 1), opens, micro),
      spaced("nifti in micrometres", niftiIn(3, 1e3), opens, micro),
      spaced("nifti in no unit", niftiIn(0, 1), opens, micro),
      spaced("nifti in an unknown unit", niftiIn(5, 1), warning("its unit of length \"number 5\" is not known"), micro),
      spaced("analyze in micrometres", analyzeIn("um", {700, 800, 2500}), unsided, micro),
      spaced("analyze in millimetres", analyzeIn("mm", {0.7f, 0.8f, 2.5f}), unsided, micro),
      spaced("analyze in an unknown unit", analyzeIn("ell", {1, 2, 3}), warning("length \"ell\" is not known"),
             {1, 2, 3}),
  };
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::vector<Defect> commaDefects() {
  return {
      spaced("nrrd with decimal commas as spacings", unplacedNrrd({{"spacings", "0,7 0,8 2,5"}}),
             warning("its spacings has decimal commas; it is read as 0.7 0.8 2.5"), {0.7, 0.8, 2.5}),
      {"nrrd with decimal commas as directions", nrrd({{"space directions", "(0,7,0,0) (0,0,8,0) (0,0,2,5)"}}),
       error("vectors of 4 numbers in a space of 3")},
      {"nrrd with decimal commas in all directions",
       nrrd({{"space directions", "(0,7,0,0,0,0) (0,0,0,8,0,0) (0,0,0,0,2,5)"}}),
       error("'space directions' is not understood")},
      {"nrrd with decimal commas as origin", nrrd({{"space origin", "(0,5,1,2)"}}),
       error("'space origin' is not understood: it has vectors of 4 numbers")},
      {"nrrd of numbers with decimal commas",
       nrrd({{"encoding", "ascii"}, {"type", "float"}},
            "0,5 1,5 2,5 3,5 4,5 5,5 6,5 7,5 8,5 9,5 0,5 1,5 2,5 3,5 4,5 5,5 6,5 7,5 8,5 9,5 0,5 1,5 2,5 3,5"),
       error("holds more numbers than its header describes, and commas between them")},
      {"nrrd of numbers divided by commas",
       nrrd({{"encoding", "ascii"}}, "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24\n"), opens},
      spaced("metaimage with decimal commas as spacing", metaImage({{"ElementSpacing", "0,7 0,8 2,5"}}),
             warning("its ElementSpacing has decimal commas; it is read as 0.7 0.8 2.5"), {0.7, 0.8, 2.5}),
      {"metaimage with decimal commas as offset", metaImage({{"Offset", "0,5 -1,25 3"}}),
       warning("its Offset has decimal commas; it is read as 0.5 -1.25 3")},
      {"metaimage with a decimal comma as slope", metaImage({{"ElementToIntensityFunctionSlope", "0,5"}}),
       warning("it is read as 0.5")},
      {"metaimage with two commas in a number", metaImage({{"ElementSpacing", "1,000,5 1 1"}}),
       error("its header's ElementSpacing is not understood")},
  };
}

std::vector<Defect> axisDefects() {
  const Expected seconds = warning("number 2 is shown; --time N chooses another"),
                 fourth = warning("its header gives length 0 for dimension 4; 1 is assumed");
  const auto pairOf = [](std::vector<std::int16_t> dims) {
    return [=](const fs::path& folder) {
      AnalyzeSpec spec;
      spec.dims = dims;
      writeFile(folder / "a.hdr", analyzeHeader(spec));
      writeFile(folder / "a.img", counting(24));
      return folder / "a.hdr";
    };
  };
  const Fields five{{"NDims", "5"}, {"ElementSpacing", "1 1 1 1 1"}, {"Offset", "0 0 0 0 0"}};
  const auto metaOfFive = [&](const char* dims) {
    Fields fields = five;
    fields["DimSize"] = dims;
    return fields;
  };
  const Fields vectors{{"dimension", "4"},
                       {"sizes", "3 2 3 4"},
                       {"kinds", "vector domain domain domain"},
                       {"space directions", "none (1,0,0) (0,1,0) (0,0,1)"}};
  // As ITK, and with it SimpleITK, writes an image of four dimensions.
  const Fields itk{{"dimension", "4"},
                   {"space", "-"},
                   {"space dimension", "4"},
                   {"sizes", "2 3 4 3"},
                   {"kinds", "domain domain domain domain"},
                   {"space directions", "(1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,2)"},
                   {"space origin", "(0,0,0,0)"}};
  Fields itkPlain = itk;
  for (const char* name : {"space dimension", "space directions", "space origin"}) itkPlain[name] = "-";
  itkPlain["spacings"] = "1 1 1 2";
  return {
      {"nifti of no time points", nifti({.dims = {2, 3, 4, 0}}), fourth},
      {"nifti of no slices", nifti({.dims = {2, 3, 0}}), warning("length 0 for dimension 3; 1 is assumed")},
      {"nifti of seven dimensions of which three have no length", nifti({.dims = {2, 3, 4, 0, 1, 0, 0}}),
       warning("length 0 for dimension 4, 6, 7; 1 is assumed")},
      {"nifti of no time points in the other byte order",
       [](const fs::path& folder) {
         NiftiSpec spec{
             .swapped = true, .dims = {2, 3, 4, 0}, .sform = 1, .srow = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
         writeFile(folder / "a.nii", niftiHeader(spec) + counting(24));
         return folder / "a.nii";
       },
       fourth},
      {"nifti 2 of no time points", nifti({.two = true, .dims = {2, 3, 4, 0}}), fourth},
      {"analyze of no time points", pairOf({2, 3, 4, 0}), fourth},
      {"nrrd of vectors", nrrd(vectors, counting(72)), warning("the file holds 3 volumes (time points or layers)")},
      {"nrrd's second component", nrrd(vectors, counting(72)), seconds, "", 2},
      {"nrrd of four domains", nrrd(itk, counting(72)), seconds, "", 2},
      {"nrrd of four domains without directions", nrrd(itkPlain, counting(72)), seconds, "", 2},
      {"metaimage of five dimensions", metaImage(metaOfFive("2 3 4 1 1")), opens},
      {"metaimage of two by three time points", metaImage(metaOfFive("2 3 4 2 3"), counting(144)),
       warning("the file holds 6 volumes")},
      {"metaimage of a time point in the fifth dimension", metaImage(metaOfFive("2 3 4 1 2"), counting(48)), seconds,
       "", 2},
      {"metaimage of ten dimensions",
       metaImage({{"NDims", "10"},
                  {"DimSize", "2 3 4 1 1 1 1 1 1 1"},
                  {"ElementSpacing", "1 1 1 1 1 1 1 1 1 1"},
                  {"Offset", "0 0 0 0 0 0 0 0 0 0"}}),
       opens},
      {"metaimage of too many time points", metaImage(metaOfFive("2 3 4 1000000 1000000")),
       error("its header's DimSize is not understood")},
      {"metaimage of five dimensions, one of no length", metaImage(metaOfFive("2 3 4 1 0")),
       error("its header's DimSize is not understood")},
  };
}

}  // namespace

std::vector<Defect> meaningDefects() {
  std::vector<Defect> all = unitDefects();
  for (const auto& part : {commaDefects(), axisDefects()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace fenestra::tests
