// Stacks of TIFF pages, whole, damaged and contradictory.

#include "tests/io/Defects.h"
#include "tests/io/FileMakers.h"
#include "tests/io/IoTesting.h"
#include "tests/io/TiffFiles.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

const Expected unplaced = warning("TIFF does not say how its axes lie in the patient");

Make tiff(const TiffSpec& spec) {
  return [=](const fs::path& folder) {
    writeTiff(folder / "a.tif", spec);
    return folder / "a.tif";
  };
}
/// A folder of these files.
Make stack(const std::vector<std::pair<std::string, TiffSpec>>& files) {
  return [=](const fs::path& folder) {
    fs::create_directories(folder / "stack");
    for (const auto& [name, spec] : files) writeTiff(folder / "stack" / name, spec);
    return folder / "stack";
  };
}
/// A file with other bytes; `change` may cut it.
Make changed(const TiffSpec& spec, const std::function<void(std::string&)>& change) {
  return [=](const fs::path& folder) {
    writeTiff(folder / "a.tif", spec);
    std::string bytes = readFile(folder / "a.tif");
    change(bytes);
    writeFile(folder / "a.tif", bytes);
    return folder / "a.tif";
  };
}

/// A row whose voxels' size is told.
Defect told(std::string name, Make make, Expected expected) {
  Defect defect{"tiff " + std::move(name), std::move(make), std::move(expected)};
  defect.told = glm::dvec3(0.01, 0.01, 0.02);
  if (defect.expected.outcome != Outcome::Error) defect.spacing = defect.told;
  return defect;
}
Defect sized(std::string name, const TiffSpec& spec, glm::dvec3 spacing, Expected expected) {
  Defect defect{"tiff " + std::move(name), tiff(spec), std::move(expected)};
  defect.spacing = spacing;
  return defect;
}
Defect unsized(std::string name, const TiffSpec& spec, const std::string& says) {
  return {"tiff " + std::move(name), tiff(spec), error(says)};
}

/// In little-endian classic TIFF: the value of a tag of the first directory.
void setTag(std::string& bytes, int tag, std::uint32_t value) {
  const auto number = [&](std::size_t at, int size) {
    std::uint32_t result = 0;
    for (int i = size - 1; i >= 0; --i)
      result = result * 256 + static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    return result;
  };
  const std::size_t directory = number(4, 4);
  for (std::uint32_t i = 0; i < number(directory, 2); ++i) {
    const std::size_t at = directory + 2 + 12 * i;
    if (number(at, 2) != static_cast<std::uint32_t>(tag)) continue;
    bytes.replace(at + 2, 2, bytesOf(std::uint16_t{4}));
    bytes.replace(at + 8, 4, bytesOf(value));
  }
}

std::vector<Defect> sizeDefects() {
  const std::string imageJ = "ImageJ=1.53t\nimages=4\nslices=4\n";
  const Expected guessed = warning("which does not give the distance of slices: the width of a pixel is taken");
  TiffSpec print{.resolution = 72.0, .unit = 2};
  return {
      told("with a size that is told", tiff({}), unplaced),
      sized("of ImageJ in micrometres", {.description = imageJ + "unit=micron\nspacing=5.0\n", .resolution = 0.5},
            {0.002, 0.002, 0.005}, warning("voxels are 0.002 x 0.002 x 0.005 mm by ImageJ's description")),
      sized("of ImageJ in escaped micrometres",
            {.description = imageJ + "unit=\\u00B5m\nspacing=5.0\n", .resolution = 0.5}, {0.002, 0.002, 0.005},
            unplaced),
      sized("of ImageJ in Latin-1 micrometres",
            {.description = imageJ + "unit=\xB5m\nspacing=5.0\n", .resolution = 0.5}, {0.002, 0.002, 0.005}, unplaced),
      sized("of ImageJ in inches", {.description = imageJ + "unit=inch\nspacing=0.5\n", .resolution = 2.54},
            {10, 10, 12.7}, unplaced),
      sized("of ImageJ without a distance of slices", {.description = imageJ + "unit=mm\n", .resolution = 4.0},
            glm::dvec3(0.25), guessed),
      sized("with pixels per centimetre", {.resolution = 1000.0, .unit = 3}, glm::dvec3(0.01), guessed),
      sized("with pixels per inch", {.resolution = 2540.0, .unit = 2}, glm::dvec3(0.01), guessed),
      unsized("without a size", {}, "does not say how large its voxels are; say it in mm, with --spacing"),
      unsized("with the resolution of a print", print, "(72 pixels an inch are those of a print)"),
      unsized("with a resolution of no unit", {.resolution = 100.0, .unit = 1},
              "does not say how large its voxels are"),
      unsized("of ImageJ in pixels", {.description = imageJ + "unit=pixel\n", .resolution = 1.0},
              "does not say how large"),
      unsized("of ImageJ in an unknown unit", {.description = imageJ + "unit=cubit\n", .resolution = 1.0},
              "how large its voxels are, in a unit that is known"),
  };
}

std::vector<Defect> pageDefects() {
  const auto one = [](int first, int width = 2) { return TiffSpec{.width = width, .pages = 1, .first = first}; };
  return {
      told("of four bits", tiff({.bits = 4}), error("has pixels of 4 bits")),
      told("of colours", tiff({.bits = 8, .samples = 3, .photometric = 2}),
           error("holds colours: 3 values at each pixel")),
      told("of white that is zero", tiff({.photometric = 0}), warning("4 pages count from white to black")),
      told("of a palette", tiff({.bits = 8, .photometric = 3}), warning("4 pages have a palette of colours")),
      told("of turned pages", tiff({.orientation = 3}), warning("4 pages say that they are to be turned")),
      told("with thumbnails", tiff({.thumbnails = 2}), unplaced),
      told("of ImageJ with fewer pages than counted",
           tiff({.pages = 1, .description = "ImageJ=1.53t\nimages=9\nslices=9\n"}),
           error("has one page of the 9 that its description counts")),
      told("of ImageJ, packed, with fewer pages than counted",
           tiff({.pages = 1, .compression = 5, .description = "ImageJ=1.53t\nimages=9\nslices=9\n"}),
           error("has one page of the 9 that its description counts")),
      told("folder", stack({{"s1.tif", one(0)}, {"s2.tif", one(6)}, {"s3.tif", one(12)}}), unplaced),
      told("folder with a gap", stack({{"s1.tif", one(0)}, {"s2.tif", one(6)}, {"s5.tif", one(12)}}),
           warning("the numbers of its files have 1 gap (s2.tif is followed by s5.tif)")),
      told("folder with another picture", stack({{"s1.tif", one(0)}, {"s2.tif", one(6)}, {"overview.tif", one(0, 7)}}),
           warning("1 of 3 TIFF files left out, whose names are not of the series (overview.tif)")),
      told("folder of pages of several sizes", stack({{"s1.tif", one(0)}, {"s2.tif", one(6, 3)}}),
           error("has a page of 3 x 3 where the first page has 2 x 3")),
      told("folder of files of several lengths", stack({{"s1.tif", {.pages = 2}}, {"s2.tif", {.pages = 3}}}),
           error("has 3 pages where the first file has 2")),
      told(
          "page of a folder",
          [=](const fs::path& folder) {
            return stack({{"s1.tif", one(0)}, {"s2.tif", one(6)}})(folder) / "s2.tif";
          },
          warning("it is one of 2 files that are numbered alike")),
      told("folder of times", stack({{"t1.tif", {}}, {"t2.tif", {.first = 24}}}), warning("the file holds 2 volumes")),
      told(
          "folder with a damaged file",
          [=](const fs::path& folder) {
            const fs::path path = stack({{"s1.tif", one(0)}, {"s2.tif", one(6)}})(folder);
            writeFile(path / "s2.tif", "II*");
            return path;
          },
          error("s2.tif: is no TIFF file that can be read")),
      {"tiff spacing for another format",
       nifti({}),
       error("says itself how large its voxels are"),
       "",
       {},
       {},
       glm::dvec3(1)},
  };
}

std::vector<Defect> damageDefects() {
  const TiffSpec little{.pages = 1, .mode = "wl"}, packed{.pages = 1, .compression = 8, .mode = "wl"};
  return {
      told("cut in its pixels",
           changed({.pages = 4, .mode = "wl"}, [](std::string& bytes) { bytes.resize(bytes.size() / 2); }),
           error("a.tif")),
      told("cut in its header", changed(little, [](std::string& bytes) { bytes.resize(6); }), error("a.tif")),
      told("of a million rows", changed(little, [](std::string& bytes) { setTag(bytes, 257, 1'000'000); }),
           error("where its pages describe")),
      told("of 65535 rows and columns, packed",
           changed(packed,
                   [](std::string& bytes) {
                     setTag(bytes, 256, 65535);
                     setTag(bytes, 257, 65535);
                   }),
           error("where its pages describe")),
      told("of no columns", changed(little, [](std::string& bytes) { setTag(bytes, 256, 0); }), error("a.tif")),
      told("of strips beyond its end",
           changed({.height = 2, .pages = 1, .mode = "wl"}, [](std::string& bytes) { setTag(bytes, 273, 1u << 30); }),
           error("has a page that does not decode")),
      told("of noise as packed pixels",
           changed(packed, [](std::string& bytes) { std::fill_n(bytes.begin() + 8, 12, '\x5a'); }),
           error("has a page that does not decode")),
      told("whose directories run in a circle, once round",
           changed(little,
                   [](std::string& bytes) {
                     // The place of the next directory stands behind the entries of this one.
                     const std::size_t at =
                         static_cast<unsigned char>(bytes[4]) + 256u * static_cast<unsigned char>(bytes[5]);
                     const std::size_t entries = static_cast<unsigned char>(bytes[at]);
                     bytes.replace(at + 2 + 12 * entries, 4, bytes.substr(4, 4));
                   }),
           unplaced),
      told("of an unknown packing", changed(little, [](std::string& bytes) { setTag(bytes, 259, 60000); }),
           error("is compressed in a way that cannot be read")),
  };
}

}  // namespace

std::vector<Defect> tiffDefects() {
  std::vector<Defect> all = sizeDefects();
  for (const auto& part : {pageDefects(), damageDefects()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace fenestra::tests
