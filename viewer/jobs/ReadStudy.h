#pragma once
// From a path that the user chose to a study that a document can show.

#include "viewer/model/Document.h"

namespace fenestra::viewer {

/// Opens a volume with the transfer function that suits it; `looks` gives everything of the scene that does not belong
/// to the data (cutaway, context layer, shading). `series` as in io::OpenOptions. Throws io::Error, io::Cancelled.
Study readStudy(const std::filesystem::path& path, const std::string& series, const Scene& looks,
                const io::Progress& progress);

/// What a set of files that was dropped or named together means: files of one folder that no single-file format claims
/// are slices, so their folder is opened; otherwise the first is the volume and the second its label map.
struct PathsToOpen {
  std::filesystem::path volume;
  std::filesystem::path labels;  ///< empty: none
};
/// `paths` must not be empty. Throws io::Error when there are more files than a volume and its label map.
PathsToOpen interpret(const std::vector<std::filesystem::path>& paths);

}  // namespace fenestra::viewer
