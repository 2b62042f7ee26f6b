#pragma once
// From a path that the user chose to a study that a document can show.

#include "io/session/OpenSession.h"
#include "viewer/model/Document.h"

namespace fenestra::viewer {

/// What to read.
struct PathsToOpen {
  std::filesystem::path volume;
  std::string series;            ///< as in io::OpenOptions
  std::filesystem::path labels;  ///< a label map for it; may be empty
};

/// Interprets files that the user dropped or named together. Files of one folder whose names are not those of whole
/// volumes are slices, so the folder is opened; otherwise one is the volume and the other its label map: a folder is a
/// volume, and so is the first file unless its name alone speaks of labels. Several folders are opened as the folder
/// that holds them and nothing else. `paths` must not be empty. Throws io::Error for other combinations.
PathsToOpen interpret(const std::vector<std::filesystem::path>& paths);

/// Opens a volume with the transfer function that suits it and otherwise `look`, without its focus
/// and strokes, which belong to other data. Throws io::Error, io::Cancelled.
Study readStudy(const PathsToOpen& paths, const Look& look, const io::Progress& progress);

/// Opens a session with its data. Throws io::DataMissing, io::Error, io::Cancelled.
Study readSession(const std::filesystem::path& file, const io::SessionPlaces& places, const io::Progress& progress);

/// Reads the data of an open session again from where they are, with the slices placed in another way. Throws
/// io::Error, io::Cancelled.
Study readAgain(const io::Session& session, io::Regularise regularise, const io::Progress& progress);

}  // namespace fenestra::viewer
