#include "tests/io/DifferentialPlaces.h"

#include <algorithm>
#include <iostream>
#include <set>

#include <gtest/gtest.h>

#include "io/base/Error.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;
namespace {

bool hasFolders(const fs::path& folder) {
  const fs::directory_iterator entries(folder);
  return std::any_of(begin(entries), end(entries), [](const auto& entry) { return entry.is_directory(); });
}

std::vector<fs::path> placesBelow(const fs::path& top) {
  static const std::set<std::string> unrelated{"enhanced", "pixel-formats", "single-ct", "monochrome1", "12bit"};
  std::set<fs::path> places;
  for (const auto& entry : fs::recursive_directory_iterator(top)) {
    if (!entry.is_regular_file()) continue;
    const fs::path folder = entry.path().parent_path();
    const bool single = unrelated.contains(folder.filename().string());
    if (single || !hasFolders(folder)) places.insert(single ? entry.path() : folder);
  }
  return {places.begin(), places.end()};
}

}  // namespace

const Difference* differenceAt(std::span<const Difference> differences, const fs::path& place) {
  const auto row = std::find_if(differences.begin(), differences.end(), [&](const Difference& each) {
    return place.generic_string().find(each.path) != std::string::npos;
  });
  return row == differences.end() ? nullptr : &*row;
}

std::vector<fs::path> dicomPlaces() {
  std::vector<fs::path> places;
  const auto add = [&](const fs::path& top) {
    if (top.empty()) return;
    const std::vector<fs::path> more = placesBelow(top);
    places.insert(places.end(), more.begin(), more.end());
  };
  for (const char* top : {"dicom", "hard", "labelled/totalsegmentator-dicom"}) add(findTestData(top));
  add(unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head"));
  add(unpackTestData("dicom/ct-tilt-philips-S21610_S2010.tar.xz", "S21610_S2010"));
  return places;
}

std::string DifferentialCounts::text() const {
  return std::to_string(compared) + " compared, " + std::to_string(agreeing) + " agree, " + std::to_string(explained) +
         " explained";
}

std::vector<io::SeriesInfo> imageSeriesAt(const fs::path& place) {
  try {
    std::vector<io::SeriesInfo> series = io::listSeries(place);
    if (!series.front().modality.empty()) return series;
  } catch (const io::Error&) {
  }
  return {};
}

void compareSeries(const fs::path& place, const std::vector<io::SeriesInfo>& series,
                   std::span<const Difference> differences,
                   const std::function<std::string(const io::OpenedVolume&)>& differenceOf,
                   DifferentialCounts& counts) {
  for (const io::SeriesInfo& info : series) {
    const std::string found =
        differenceOf(io::openVolume(place, {.series = info.id, .regularise = io::Regularise::Off}));
    ++counts.compared;
    if (found.empty()) {
      ++counts.agreeing;
      continue;
    }
    const Difference* why = differenceAt(differences, place);
    if (!why) {
      ADD_FAILURE() << place << ", " << info.id << ": " << found;
      continue;
    }
    ++counts.explained;
    std::cout << place.filename() << ": " << found << "; " << why->why << "\n";
  }
}

}  // namespace fenestra::tests
