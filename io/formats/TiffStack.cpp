// Stacks of TIFF pages: a file of several, or a folder of numbered files.

#include <algorithm>
#include <cstring>
#include <map>

#include "io/base/Memory.h"
#include "io/base/NaturalOrder.h"
#include "io/base/Text.h"
#include "io/base/VolumeEnding.h"
#include "io/formats/ImageFile.h"
#include "io/formats/TiffFile.h"
#include "io/formats/TiffMeaning.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// A name in pieces that are numbers and pieces that are not; two names of one series differ in numbers alone.
struct NumberedName {
  std::string form;                   ///< with a '#' in place of each number
  std::vector<std::int64_t> numbers;  ///< as far as they fit

  explicit NumberedName(const std::string& name) {
    for (std::size_t at = 0; at < name.size();) {
      std::size_t end = at;
      while (end < name.size() && name[end] >= '0' && name[end] <= '9') ++end;
      if (end == at) {
        form += name[at++];
        continue;
      }
      form += '#';
      numbers.push_back(numberIn<std::int64_t>(name.substr(at, end - at)).value_or(0));
      at = end;
    }
  }
};

std::vector<fs::path> tiffFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure)) {
    std::error_code unknown;
    if (entry->is_regular_file(unknown) && isTiffName(entry->path())) files.push_back(entry->path());
  }
  if (failure) throw Error(folder, "cannot be listed: " + failure.message(), "check its permissions");
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return isBeforeNaturally(a.filename().string(), b.filename().string());
  });
  return files;
}

/// Says which numbers are missing among those of the files, where one number counts them.
void warnOfGaps(const std::vector<fs::path>& files, ImageFile& image) {
  std::vector<NumberedName> names;
  for (const fs::path& file : files) names.emplace_back(file.filename().string());
  std::vector<std::size_t> changing;
  for (std::size_t i = 0; i < names.front().numbers.size(); ++i)
    if (std::any_of(names.begin(), names.end(),
                    [&](const auto& name) { return name.numbers[i] != names[0].numbers[i]; }))
      changing.push_back(i);
  if (changing.size() != 1 || files.size() < 3) return;
  const std::size_t counter = changing.front();
  const auto step = [&](std::size_t i) { return names[i].numbers[counter] - names[i - 1].numbers[counter]; };
  std::int64_t usual = step(1);
  for (std::size_t i = 2; i < names.size(); ++i) usual = std::min(usual, step(i));
  std::size_t gaps = 0;
  std::string first;
  for (std::size_t i = 1; i < names.size(); ++i) {
    if (usual < 1 || step(i) == usual) continue;
    if (++gaps == 1) first = files[i - 1].filename().string() + " is followed by " + files[i].filename().string();
  }
  if (gaps > 0)
    image.warnings.push_back({Warning::Kind::MissingSlices,
                              "the numbers of its files have " + std::to_string(gaps) + (gaps == 1 ? " gap" : " gaps") +
                                  " (" + first + "); the slices there are shown too near",
                              {}});
}

/// The files of a folder whose names differ in numbers alone, the largest such group.
std::vector<fs::path> seriesIn(const fs::path& folder, ImageFile& image) {
  const std::vector<fs::path> files = tiffFilesIn(folder);
  std::map<std::string, std::vector<fs::path>> groups;
  for (const fs::path& file : files) groups[NumberedName(file.filename().string()).form].push_back(file);
  if (groups.empty()) throw Error(folder, "holds no TIFF files", "name a folder of .tif files");
  const auto largest = std::max_element(groups.begin(), groups.end(),
                                        [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  std::vector<fs::path> others;
  for (const fs::path& file : files)
    if (NumberedName(file.filename().string()).form != largest->first) others.push_back(file);
  if (!others.empty())
    image.warnings.push_back({Warning::Kind::Other,
                              std::to_string(others.size()) + " of " + std::to_string(files.size()) +
                                  " TIFF files left out, whose names are not of the series (" +
                                  others.front().filename().string() + ")",
                              others});
  warnOfGaps(largest->second, image);
  return largest->second;
}

/// The pages of all files, which must be alike.
struct Stack {
  std::vector<TiffPageOf> pages;
  std::int64_t pagesOfFile = 0;  ///< the same in each
  std::string description;       ///< of the first file
  bool bigEndian = false;
};

Stack readStack(const std::vector<fs::path>& files) {
  Stack stack;
  for (const fs::path& file : files) {
    TiffDirectory directory = readTiffPages(file);
    const auto count = static_cast<std::int64_t>(directory.pages.size());
    if (stack.pages.empty()) {
      stack.description = directory.description;
      stack.pagesOfFile = count;
      stack.bigEndian = directory.bigEndian;
    }
    if (count != stack.pagesOfFile)
      throw Error(
          file, "has " + std::to_string(count) + " pages where the first file has " + std::to_string(stack.pagesOfFile),
          "put files of one stack alone into a folder");
    for (const TiffPage& page : directory.pages) {
      stack.pages.push_back({file, page});
      const TiffPage& first = stack.pages.front().page;
      if (page.width != first.width || page.height != first.height || page.type != first.type)
        throw Error(file,
                    "has a page of " + std::to_string(page.width) + " x " + std::to_string(page.height) +
                        (page.type != first.type ? " pixels of another type" : "") + " where the first page has " +
                        std::to_string(first.width) + " x " + std::to_string(first.height),
                    "put pages of one size and type alone into a stack");
    }
  }
  return stack;
}

/// Bytes that files can hold when unpacked: LZW and deflate expand a byte to some 2600 and 1032 at most.
void checkTiffSizes(const Stack& stack) {
  constexpr std::uint64_t mostExpansion = 2600;
  std::map<fs::path, std::uint64_t> described;
  bool compressed = false;
  for (const TiffPageOf& each : stack.pages) {
    described[each.file] += each.page.bytes();
    compressed |= each.page.isCompressed;
  }
  for (const auto& [file, bytes] : described) {
    std::error_code failure;
    const std::uint64_t held = fs::file_size(file, failure);
    if (bytes > saturatingProduct(held, compressed ? mostExpansion : 1))
      throw Error(file, "holds " + std::to_string(held) + " bytes where its pages describe " + std::to_string(bytes),
                  "the file is truncated or damaged");
  }
}

/// Sets dims, and the pages in the order of volumes. Files of several pages each are volumes of their own.
void setPages(Stack stack, std::size_t files, ImageFile& image) {
  const TiffPage& first = stack.pages.front().page;
  const auto pages = static_cast<std::int64_t>(stack.pages.size());
  TiffOrder order{.slices = pages};
  if (files > 1 && stack.pagesOfFile > 1)
    order = {.slices = stack.pagesOfFile, .times = static_cast<std::int64_t>(files), .order = "ZCT"};
  else if (const auto given = tiffOrder(stack.description); given && files == 1 && given->pages() == pages)
    order = *given;
  setDims(image, first.width, first.height, order.slices);
  image.volumes = order.channels * order.times;
  image.type = first.type;
  checkTiffSizes(stack);
  std::vector<TiffPageOf> sorted;
  for (std::int64_t time = 0; time < order.times; ++time)
    for (std::int64_t channel = 0; channel < order.channels; ++channel)
      for (std::int64_t slice = 0; slice < order.slices; ++slice)
        sorted.push_back(stack.pages[static_cast<std::size_t>(order.pageOf(slice, channel, time))]);
  image.source.open = [sorted](std::uint64_t begin) { return openTiffPages(sorted, begin); };
}

/// ImageJ writes stacks of over 4 GB as one page with the others behind it, which no tag tells.
bool setBarePages(const Stack& stack, ImageFile& image) {
  const auto order = tiffOrder(stack.description);
  const TiffPage& page = stack.pages.front().page;
  if (stack.pages.size() != 1 || !order || order->images < 2) return false;
  // They follow the first one's pixels, so that the directory stands before.
  if (page.isCompressed || order->channels * order->times != 1 || page.firstStrip < page.place)
    throw Error(image.path, "has one page of the " + std::to_string(order->images) + " that its description counts",
                "save it as a sequence of files");
  setDims(image, page.width, page.height, order->images);
  image.type = page.type;
  image.bigEndian = stack.bigEndian;
  image.source.skip = static_cast<std::int64_t>(page.firstStrip);
  return true;
}

void setSpacing(const Stack& stack, const std::optional<glm::dvec3>& told, ImageFile& image) {
  const auto warn = [&](const std::string& text, WayOut way = WayOut::None) {
    image.warnings.push_back({Warning::Kind::NoGeometry, text, {image.path}, way});
  };
  const std::string axes =
      "TIFF does not say how its axes lie in the patient; they are taken as left, posterior, superior";
  if (told) {
    image.grid.spacing = *told;
    warn(axes);
    return;
  }
  const TiffSpacing said = tiffSpacing(stack.pages.front().page, stack.description);
  if (said.millimetres.x == 0.0) {
    image.missingSpacing = "does not say how large its voxels are";
    if (!said.unknownUnit.empty()) image.missingSpacing += ", in a unit that is known";
    if (!said.printResolution.empty()) image.missingSpacing += " (" + said.printResolution + " are those of a print)";
    return;
  }
  const bool hasStep = said.millimetres.z > 0.0;
  image.grid.spacing = hasStep ? said.millimetres : glm::dvec3(glm::dvec2(said.millimetres), said.millimetres.x);
  const glm::dvec3& size = image.grid.spacing;
  warn(axes + "; voxels are " + plainNumber(size.x) + " x " + plainNumber(size.y) + " x " + plainNumber(size.z) +
           " mm by " + said.source +
           (hasStep || image.grid.dims.z == 1
                ? ""
                : ", which does not give the distance of slices: the width of a pixel is taken"),
       WayOut::CorrectVoxelSize);
}

void warnOfPages(const Stack& stack, ImageFile& image) {
  const auto count = [&](const auto& is) {
    return std::count_if(stack.pages.begin(), stack.pages.end(), [&](const TiffPageOf& each) { return is(each.page); });
  };
  const auto warn = [&](std::ptrdiff_t pages, const std::string& text) {
    if (pages > 0)
      image.warnings.push_back(
          {Warning::Kind::Other, std::to_string(pages) + (pages == 1 ? " page " : " pages ") + text, {image.path}});
  };
  warn(count([](const TiffPage& page) { return page.whiteIsZero; }),
       "count from white to black; the values are turned round, so that bright is high");
  warn(count([](const TiffPage& page) { return page.hasPalette; }),
       "have a palette of colours; the stored numbers are shown");
  warn(count([](const TiffPage& page) { return page.orientation != 1; }),
       "say that they are to be turned or mirrored; they are shown as stored");
}

/// Says when a page alone is one of a series of files.
void warnOfSiblings(ImageFile& image) {
  const NumberedName name(image.path.filename().string());
  if (name.numbers.empty()) return;
  std::error_code failure;
  std::size_t series = 0;
  for (fs::directory_iterator entry(image.path.parent_path().empty() ? "." : image.path.parent_path(), failure);
       !failure && entry != fs::directory_iterator(); entry.increment(failure))
    if (isTiffName(entry->path()) && NumberedName(entry->path().filename().string()).form == name.form) ++series;
  if (series > 1)
    image.warnings.push_back({Warning::Kind::Other,
                              "it is one of " + std::to_string(series) +
                                  " files that are numbered alike; open their folder for the whole stack",
                              {image.path}});
}

}  // namespace

bool looksLikeTiff(const FileStart& start) {
  const std::span<const std::byte> bytes = start.stored();
  const auto is = [&](const char* magic) { return bytes.size() >= 8 && std::memcmp(bytes.data(), magic, 4) == 0; };
  return is("II*\0") || is("MM\0*") || is("II+\0") || is("MM\0+");
}

bool hasTiffFiles(const fs::path& folder) {
  // A folder that cannot be listed is another reader's to report.
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure))
    if (isTiffName(entry->path())) return true;
  return false;
}

ImageFile readTiffHeader(const fs::path& path, const std::optional<glm::dvec3>& spacing) {
  ImageFile image;
  image.path = path;
  image.format = "TIFF";
  std::error_code unknown;
  const std::vector<fs::path> files =
      fs::is_directory(path, unknown) ? seriesIn(path, image) : std::vector<fs::path>{path};
  const Stack stack = readStack(files);
  if (files.front() == path && stack.pages.size() == 1) warnOfSiblings(image);
  image.source.files = files;
  warnOfPages(stack, image);
  if (files.size() != 1 || !setBarePages(stack, image)) setPages(stack, files.size(), image);
  setSpacing(stack, spacing, image);
  return image;
}

}  // namespace fenestra::io
