#pragma once
// What is compared with other readers: every place of the collection that holds DICOM, and the rows that say why a
// volume differs there.

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "io/VolumeReader.h"

namespace fenestra::tests {

/// A part of a path, and why what lies there differs from another reader's reading.
struct Difference {
  const char* path;
  const char* why;
};

/// The first row whose path is part of `place`'s; null: there is none.
const Difference* differenceAt(std::span<const Difference> rows, const std::filesystem::path& place);

/// Folders of DICOM files, and single files where a folder holds unrelated ones; archives are unpacked. Empty where the
/// collection is not here.
std::vector<std::filesystem::path> dicomPlaces();

/// "N compared, N agree, N explained", for the test's output.
struct DifferentialCounts {
  int compared = 0, agreeing = 0, explained = 0;
  std::string text() const;
};

/// The series at a place; empty where it holds no DICOM image, such as letters, references and segmentations.
std::vector<io::SeriesInfo> imageSeriesAt(const std::filesystem::path& place);

/// Opens each series of a place, with its planes where they are, and counts it: agreeing where `differenceOf` says
/// nothing, explained where a row does. Others fail the test.
void compareSeries(const std::filesystem::path& place, const std::vector<io::SeriesInfo>& series,
                   std::span<const Difference> rows,
                   const std::function<std::string(const io::OpenedVolume&)>& differenceOf, DifferentialCounts& counts);

}  // namespace fenestra::tests
