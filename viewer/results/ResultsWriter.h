#pragma once
// Writes results of a study as DICOM objects to a folder and sends them to an archive; off the GUI thread.

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include <QImage>
#include <QStringList>

#include "io/archive/Send.h"
#include "io/results/StudyResults.h"
#include "rendering/scene/Scene.h"
#include "viewer/archive/SentAnswers.h"

namespace fenestra::viewer {

/// What is to be written, as it was when the user asked for it.
struct ResultsOrder {
  io::ResultSource source;
  QString description;  ///< of the series; may be empty

  bool measures = false;                        ///< the report, with the segments that it is about
  bool labels = false;                          ///< all labels as a segmentation
  bool focus = false;                           ///< the focus as a segmentation
  std::vector<std::uint16_t> focusLabels = {};  ///< those in focus, ascending; empty: the focus is one segment
  Scene scene = {};                             ///< whose focus that is
  QString focusName = {};                       ///< of the one segment

  QImage picture = {};  ///< null: none
  QStringList fidelity = {};
  bool pictureNamesPatient = false;

  std::vector<int> keySlices = {};  ///< as scanned; empty: none
  QString keyText = {};             ///< why

  std::optional<std::filesystem::path> folder = {};  ///< where the files go; unset: nowhere
  using Send =
      std::function<std::vector<io::archive::Sent>(const std::vector<std::filesystem::path>&, const io::Progress&)>;
  Send send = {};  ///< to the archive; empty: nowhere
  using Commit =
      std::function<QString(const std::vector<io::archive::Sent>&, SentAnswers::Commitments&, const io::Progress&)>;
  Commit commit = {};  ///< asks the archive whether it keeps what was sent, as askToCommit(); empty: nobody asks
};

/// What became of it.
struct ResultsOutcome {
  QStringList names;                           ///< of the objects, in the window's words
  std::vector<std::filesystem::path> written;  ///< files in the folder
  std::vector<io::archive::Sent> sent;         ///< as many as names, or none
  QString sendingProblem;                      ///< why none was sent
  SentAnswers::Commitments commitments = {};   ///< what the archive said of keeping them
  QString commitProblem = {};                  ///< why it said nothing
};

/// Writes all objects into a folder of their own first: a failure or a cancel leaves nothing. They are sent, and get
/// their names in the folder last; a name that is taken is left alone, and a number added. Throws io::Error,
/// io::Cancelled.
ResultsOutcome writeResults(const ResultsOrder& order, const io::Progress& progress);

}  // namespace fenestra::viewer
