// info --tags: the attributes of a DICOM file, as they stand there.

#include <nlohmann/json.hpp>

#include "app/cli/Commands.h"
#include "app/cli/Report.h"
#include "io/VolumeReader.h"
#include "io/base/FileStart.h"
#include "io/deidentify/Profile.h"
#include "io/dicom/DicomStart.h"
#include "io/dicom/TagList.h"

namespace fenestra::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json describe(const std::vector<io::DicomAttribute>& attributes) {
  Json list = Json::array();
  for (const io::DicomAttribute& attribute : attributes) {
    Json& row = list.emplace_back(Json{{"tag", attribute.tag()}, {"vr", attribute.vr}, {"name", attribute.name}});
    if (!attribute.creator.empty()) row["creator"] = attribute.creator;
    if (attribute.vr != "SQ") row["value"] = attribute.isHidden ? Json(nullptr) : Json(attribute.value);
    if (attribute.isHidden) row["hidden"] = true;
    if (attribute.items.empty()) continue;
    row["items"] = Json::array();
    for (const std::vector<io::DicomAttribute>& item : attribute.items) row["items"].push_back(describe(item));
  }
  return list;
}

/// Files of the series in the order of its slices.
std::vector<fs::path> sliceFiles(const io::DataRequest& data) {
  if (data.path.empty()) throw io::Error(data.source(), "is no DICOM file", "name a DICOM file or folder");
  if (fs::is_regular_file(data.path) && io::looksLikeDicom(io::FileStart(data.path))) return {data.path};
  const std::vector<io::SeriesInfo> series =
      io::listSeries(data.path, {.series = data.series, .raw = data.raw, .progress = progressOnTerminal()});
  for (const io::SeriesInfo& each : series) {
    if (!data.series.empty() && each.id != data.series) continue;
    if (each.files.empty() || !io::looksLikeDicom(io::FileStart(each.files.front()))) break;
    return each.files;
  }
  if (!data.series.empty()) throw io::Error(data.source(), "has no series " + data.series, io::WayOut::ChooseSeries);
  throw io::Error(data.source(), "holds no DICOM files that can be read in place",
                  "name a DICOM file or folder, unpacked");
}

}  // namespace

void infoTags(const InfoOptions& options) {
  const std::vector<fs::path> files = sliceFiles(options.data);
  const auto count = static_cast<int>(files.size());
  const int slice = options.slice.value_or(count / 2);
  if (slice < 0 || slice >= count)
    throw io::Error(options.data.source(), "there is no file " + std::to_string(slice),
                    "files run from 0 to " + std::to_string(count - 1) + ", in the order of their slices");
  const fs::path& file = files[static_cast<std::size_t>(slice)];
  std::vector<io::DicomAttribute> attributes = io::readAttributes(file);
  // A log or a pasted text must not name a patient by accident.
  if (!options.descriptions)
    io::hideValues(attributes, [](const io::DicomAttribute& attribute) {
      return (attribute.group & 1U) != 0 || io::deidentify::rowOf(attribute.group, attribute.element) != nullptr;
    });
  if (!options.search.empty()) attributes = io::attributesWith(attributes, options.search);
  printJson(Json{{"file", file.string()}, {"slice", slice}, {"files", count}, {"tags", describe(attributes)}});
}

}  // namespace fenestra::cli
