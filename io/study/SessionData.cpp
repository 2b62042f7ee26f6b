#include "io/study/SessionData.h"

#include <algorithm>
#include <map>
#include <system_error>

#include "io/LabelReader.h"
#include "io/LabelTable.h"
#include "io/VolumeReader.h"
#include "io/base/Archive.h"
#include "io/base/Contents.h"
#include "io/study/StudyRequest.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;

/// Limits of a search, so that a session in a home folder does not make it walk a whole archive.
constexpr std::size_t mostEntries = 100000, mostFolders = 64;
constexpr int deepest = 16;

std::string described(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return std::string("\"").append((relative.empty() ? path : relative).string()).append("\"");
}

bool isWithin(const fs::path& path, const fs::path& folder) {
  std::error_code failure;
  const fs::path from = fs::canonical(folder, failure),
                 relative = fs::weakly_canonical(path, failure).lexically_relative(from);
  return !relative.empty() && *relative.begin() != "..";
}

/// Whether files have exactly these contents; cheap comparisons come first.
bool hold(const std::vector<fs::path>& files, const Contents& contents, const Progress& progress) {
  if (files.size() != contents.files) return false;
  std::uint64_t bytes = 0;
  for (const fs::path& file : files) {
    std::error_code failure;
    bytes += fs::file_size(file, failure);
    if (failure) return false;
  }
  return bytes == contents.bytes && contentsOf(files, progress) == contents;
}

/// Files and folders below a folder that data may have moved to.
class Search {
 public:
  Search(const fs::path& folder, const SessionData& data, const Progress& progress) : data_(data) {
    std::error_code failure;
    std::map<fs::path, std::size_t> filesBelow;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failure);
    std::vector<fs::path> same, others;
    for (std::size_t seen = 0; !failure && entry != fs::recursive_directory_iterator() && seen < mostEntries;
         entry.increment(failure), ++seen) {
      if (progress && !progress(0.0, "looking for moved data")) throw Cancelled();
      std::error_code unknown;
      const fs::path& path = entry->path();
      if (path.filename() == data.path.filename()) named_.push_back(path);
      if (entry->is_regular_file(unknown)) {
        if (data.contents.files == 1 && entry->file_size(unknown) == data.contents.bytes) alike_.push_back(path);
        for (fs::path above = path.parent_path(); above != folder.parent_path() && !above.empty();
             above = above.parent_path())
          ++filesBelow[above];
      }
      if (entry.depth() >= deepest) entry.disable_recursion_pending();
    }
    std::sort(named_.begin(), named_.end());
    std::sort(alike_.begin(), alike_.end());
    // The folder with the fewest other files is the best candidate; its parent folders hold more.
    std::vector<std::pair<std::size_t, fs::path>> folders;
    for (const auto& [path, files] : filesBelow)
      if (files >= data.contents.files) folders.emplace_back(files, path);
    std::sort(folders.begin(), folders.end());
    if (folders.size() > mostFolders) folders.resize(mostFolders);
    for (auto& [files, path] : folders) alike_.push_back(std::move(path));
  }

  /// The first place whose files, as `filesAt` lists them, have the contents of the data.
  template <class FilesAt>
  fs::path find(const FilesAt& filesAt, const Progress& progress) const {
    for (const std::vector<fs::path>* places : {&named_, &alike_})
      for (const fs::path& place : *places) try {
          if (hold(filesAt(place), data_.contents, progress)) return place;
        } catch (const Error&) {  // not the data
        }
    return {};
  }

 private:
  const SessionData& data_;
  std::vector<fs::path> named_, alike_;
};

template <class Data>
struct Opened {
  Data data;
  Contents contents;
  std::vector<fs::path> files;
};
// Clang deduces no aggregate's arguments before version 17.
template <class Data>
Opened(Data, Contents, std::vector<fs::path>) -> Opened<Data>;

/// Where data of the path `before` are now that `found` has their contents: in an archive, the file that they were
/// there; else `found` itself.
fs::path memberAt(const fs::path& found, const fs::path& before) {
  std::error_code unknown;
  if (!fs::is_regular_file(found, unknown)) return found;
  for (fs::path archive = before.parent_path(); archive.has_relative_path(); archive = archive.parent_path())
    if (archive.filename() == found.filename()) return found / before.lexically_relative(archive);
  return found;
}

/// Opens data by `open(path)`, which also says what they hold.
template <class Open, class FilesAt>
auto openMoved(DataMissing::Data which, SessionData& data, const fs::path& place, const fs::path& folder,
               const Progress& progress, std::vector<Warning>& warnings, const Open& open, const FilesAt& filesAt) {
  const bool labels = which == DataMissing::Data::Labels;
  const std::string kind = labels ? "the label map " : "the volume ";
  const WayOut way = labels ? WayOut::FindLabels : WayOut::FindVolume;
  const bool known = !data.contents.hash.empty();
  const auto take = [&](const fs::path& path, auto opened) {
    data.path = fs::absolute(path);
    data.contents = std::move(opened.contents);
    data.files = std::move(opened.files);
    return std::move(opened.data);
  };
  const auto warnOfChange = [&](const fs::path& path) {
    warnings.push_back({Warning::Kind::ChangedData,
                        kind + described(path, folder) + " is not what it was when the session was saved",
                        {path}});
  };

  if (!place.empty()) {
    auto opened = open(place);
    if (known && opened.contents != data.contents) warnOfChange(place);
    return take(place, std::move(opened));
  }

  std::string problem = kind + described(data.path, folder) + " is not there";
  std::error_code failure;
  if (fs::exists(data.path, failure) || archiveMember(data.path)) {
    try {
      auto opened = open(data.path);
      if (known && opened.contents == data.contents) return take(data.path, std::move(opened));
      if (isWithin(data.path, folder)) {
        if (known) warnOfChange(data.path);
        return take(data.path, std::move(opened));
      }
      problem = kind + described(data.path, folder) + " is not what it was when the session was saved";
    } catch (const Error& error) {
      problem = kind + described(data.path, folder) + " cannot be opened: " + error.cause();
    }
  }
  const fs::path found =
      known ? memberAt(Search(folder, data, progress).find(filesAt, progress), data.path) : fs::path();
  if (found.empty()) throw DataMissing(which, data.path, problem, way);
  warnings.push_back(
      {Warning::Kind::MovedData,
       kind + "was found at " + described(found, folder) + ", no longer at " + described(data.path, folder),
       {}});
  return take(found, open(found));
}

/// Files whose contents identify a volume or a label map: those of the series, and the named one.
std::vector<fs::path> filesOf(const fs::path& path, std::vector<fs::path> files) {
  std::error_code failure;
  const bool listed = std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    return file == path || fs::equivalent(file, path, failure);
  });
  if (!listed && fs::is_regular_file(path, failure)) files.push_back(path);
  return files;
}
std::vector<fs::path> labelFilesAt(const fs::path& path, bool allowOutside) {
  return filesOf(path, labelFiles(path, allowOutside));
}

OpenedVolume openSessionVolume(const DataRequest& request, SessionVolume& data, const fs::path& folder,
                               const Progress& progress, std::vector<Warning>& warnings) {
  const auto openAt = [&](const fs::path& path) {
    OpenOptions options;
    options.regularise = data.regularise;
    options.modality = data.modality;
    options.series = data.series;
    if (data.time > 1) options.time = data.time;
    options.raw = data.raw;
    options.spacing = data.spacing;
    options.allowOutside = request.allowOutside;
    options.progress = partOf(progress, 0.0, 0.7);
    OpenedVolume volume;
    try {
      volume = openVolume(path, options);
    } catch (const Error&) {
      if (request.data.empty() || options.series.empty()) throw;
      // A newly exported study has other UIDs.
      options.series.clear();
      volume = openVolume(path, options);
    }
    std::vector<fs::path> files = filesOf(path, volume.series.files);
    return Opened{std::move(volume), contentsOf(files, partOf(progress, 0.7, 0.8)), files};
  };
  const auto filesAt = [&](const fs::path& path) {
    OpenOptions options;
    options.raw = data.raw;
    options.spacing = data.spacing;
    options.allowOutside = request.allowOutside;
    for (const SeriesInfo& series : listSeries(path, options))
      if (data.series.empty() || data.series == seriesKey(series.id)) return filesOf(path, series.files);
    return std::vector<fs::path>();
  };
  return openMoved(DataMissing::Data::Volume, data, request.data, folder, progress, warnings, openAt, filesAt);
}

/// The table of names that was chosen for a session's labels; empty, with a warning, where it cannot be used any more.
fs::path sessionTable(const DataRequest& request, SessionLabels& data, std::vector<Warning>& warnings) {
  if (!request.labelTable.empty()) data.table = fs::absolute(request.labelTable);
  if (data.table.empty() || !request.labelTable.empty()) return data.table;
  try {
    if (!readLabelTable(data.table).empty()) return data.table;
  } catch (const Error&) {  // it is not there
  }
  warnings.push_back({Warning::Kind::ChangedData,
                      "the table of label names \"" + data.table.filename().string() +
                          "\" that the session names cannot be read; the label map's own names are shown",
                      {data.table}});
  return {};
}

OpenedLabels openSessionLabels(const DataRequest& request, SessionLabels& data, const fs::path& folder,
                               const Grid& grid, const Progress& progress, std::vector<Warning>& warnings) {
  const fs::path table = sessionTable(request, data, warnings);
  const auto filesAt = [&](const fs::path& path) { return labelFilesAt(path, request.allowOutside); };
  const auto openAt = [&](const fs::path& path) {
    OpenedLabels labels = openLabels(path, grid, partOf(progress, 0.8, 0.9), request.allowOutside, table);
    std::vector<fs::path> files = filesAt(path);
    return Opened{std::move(labels), contentsOf(files, partOf(progress, 0.9, 1.0)), files};
  };
  return openMoved(DataMissing::Data::Labels, data, request.labels, folder, progress, warnings, openAt, filesAt);
}

}  // namespace

SessionVolume sessionVolume(const fs::path& path, const VolumeInfo& volume, const OpenOptions& options) {
  SessionVolume data;
  data.path = fs::absolute(path);
  data.files = filesOf(path, volume.series.files);
  if (volume.format == "DICOM")
    data.series = seriesKey(volume.series.id);
  else
    data.time = std::max(volume.series.time, 1);
  data.raw = options.raw;
  data.spacing = options.spacing;
  data.regularise = options.regularise;
  data.modality = volume.modality;
  return data;
}

SessionLabels sessionLabels(const fs::path& path, const fs::path& table) {
  SessionLabels data;
  if (!table.empty()) data.table = fs::absolute(table);
  data.path = fs::absolute(path);
  data.files = labelFilesAt(path, true);  // they have been opened
  return data;
}

void noteContents(Session& session, const Progress& progress) {
  for (SessionData* data : {static_cast<SessionData*>(&session.volume), static_cast<SessionData*>(&session.labels)}) {
    if (data->path.empty() || !data->contents.hash.empty()) continue;
    try {
      data->contents = contentsOf(data->files, progress);
    } catch (const Error&) {
      data->contents = {};
    }
  }
}

void openSessionData(const DataRequest& request, Study& study, const Progress& progress) {
  const fs::path folder = fs::absolute(request.path).parent_path();
  study.session.volume.regularise = request.regularise.value_or(study.session.volume.regularise);
  takeVolume(openSessionVolume(request, study.session.volume, folder, progress, study.warnings), study);
  if (request.labels.empty() && study.session.labels.path.empty()) return;
  const Grid& grid = study.scene.volume->grid;
  OpenedLabels labels = openSessionLabels(request, study.session.labels, folder, grid, progress, study.warnings);
  study.scene.labels = std::move(labels.labels);
  std::move(labels.warnings.begin(), labels.warnings.end(), std::back_inserter(study.warnings));
}

}  // namespace fenestra::io
