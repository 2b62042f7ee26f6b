// info --tags: the DICOM attributes of a slice's file.

#include <filesystem>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/Commands.h"
#include "app/cli/Report.h"
#include "io/VolumeReader.h"
#include "io/base/SessionName.h"
#include "io/dicom/TagList.h"
#include "io/study/ReadStudy.h"

namespace fenestra::cli {
namespace {

using TagJson = nlohmann::ordered_json;

TagJson describe(const std::vector<io::DicomTag>& tags, bool withPatient) {
  TagJson list = TagJson::array();
  for (const io::DicomTag& tag : tags) {
    TagJson json{{"tag", tag.number()}, {"vr", tag.vr}, {"name", tag.name}};
    if (!tag.creator.empty()) json["creator"] = tag.creator;
    if (tag.isSequence()) {
      json["item_count"] = tag.itemCount;
      json["items"] = TagJson::array();
      for (const io::DicomTagItem& item : tag.items)
        json["items"].push_back({{"number", item.number}, {"tags", describe(item.tags, withPatient)}});
    } else {
      json["bytes"] = tag.bytes;
      if (tag.identifies && !withPatient)
        json["hidden"] = true;
      else if (tag.hasText)
        json["value"] = tag.value;
    }
    list.push_back(std::move(json));
  }
  return list;
}

/// The slices of the data. Headers tell those of a series that is no session's; all else is opened.
io::ListedSlices slicesOf(const io::DataRequest& data) {
  if (!data.path.empty() && !data.session && !io::isSession(data.path)) {
    io::OpenOptions options;
    options.series = data.series;
    options.time = data.time;
    options.raw = data.raw;
    options.spacing = data.spacing;
    options.progress = progressOnTerminal();
    if (std::optional<io::ListedSlices> listed = io::listSlices(data.path, options)) return std::move(*listed);
  }
  io::Study study = io::openData(data, progressOnTerminal());
  if (study.format != "DICOM")
    throw io::Error(data.source(), "has no DICOM attributes: its format is " + study.format,
                    "name the DICOM files that it was made from; info without --tags tells its geometry");
  if (study.slices.empty())
    throw io::Error(data.source(), "is an archive, and --tags reads single files", "unpack it and open the folder");
  return {std::move(study.series), std::move(study.slices)};
}

}  // namespace

void tags(const InfoOptions& options) {
  const auto [series, slices] = slicesOf(options.data);
  const int count = static_cast<int>(slices.size());
  const int slice = options.slice.value_or(count / 2);
  if (slice < 0 || slice >= count)
    throw io::Error(options.data.source(), "there is no slice " + std::to_string(slice),
                    "slices run from 0 to " + std::to_string(count - 1));
  const io::SliceSource source = slices[static_cast<std::size_t>(slice)];
  const std::filesystem::path& file = series.files.at(source.file);
  std::vector<io::DicomTag> all = io::readDicomTags(file, source.frame);
  // Before the search: what is hidden must not be found by guessing.
  if (!options.withPatient) io::hidePatient(all);
  printJson(TagJson{{"source", options.data.source()},
                    {"file", file.string()},
                    {"slice", slice},
                    {"slices", count},
                    {"frame", source.frame},
                    {"tags", describe(io::tagsHolding(all, options.search), options.withPatient)}});
}

}  // namespace fenestra::cli
