#pragma once
// Opens a session with its data, at their recorded place or where they have moved to.
//
// Data at the recorded path are used when their contents are unchanged. Fenestra reports changed data and uses them
// only within the session's folder: a session from a stranger must not open arbitrary files elsewhere. Missing data are
// searched below the session's folder, by name and then by contents; only equal contents count as found. Otherwise the
// user is asked.

#include <memory>
#include <vector>

#include "io/session/Session.h"

namespace fenestra::io {

/// The session's data are missing or have changed; the caller must say where they are.
class DataMissing : public Error {
 public:
  enum class Data : std::uint8_t { Volume, Labels };
  DataMissing(Data data, const std::filesystem::path& file, std::string cause, std::string hint)
      : Error(file, std::move(cause), std::move(hint)), data_(data) {}
  Data data() const { return data_; }

 private:
  Data data_;
};

/// Places of the data that the user gave; empty: the session's own. Data there are used whatever their contents.
struct SessionPlaces {
  std::filesystem::path volume = {}, labels = {};
  bool allowOutside = false;                  ///< see OpenOptions
  std::optional<Regularise> regularise = {};  ///< of the volume's slices, in place of the session's choice
};

struct OpenedSession {
  Session session;      ///< with the paths and contents of the data that were opened
  OpenedVolume volume;  ///< its warnings moved to `warnings`
  std::shared_ptr<const LabelMap> labels;
  std::vector<Warning> warnings;  ///< of the data, and which of them moved or changed
};

/// Reads the session and opens its data. Throws DataMissing, Error, Cancelled.
OpenedSession openSession(const std::filesystem::path& file, const SessionPlaces& places = {},
                          const Progress& progress = {});
/// The data of `session`, as if it had been read from a file in `folder`.
OpenedSession openSession(Session session, const std::filesystem::path& folder, const SessionPlaces& places,
                          const Progress& progress);

/// Open data as a session keeps them, without contents.
SessionVolume sessionVolume(const std::filesystem::path& path, const OpenedVolume& volume,
                            const OpenOptions& options = {});
SessionData sessionLabels(const std::filesystem::path& path);
/// Hashes the data that have no hash yet, which takes a while. Unreadable files leave the contents unknown, so that a
/// session can be saved while the disk with its data is not mounted. Throws Cancelled.
void noteContents(Session& session, const Progress& progress = {});

}  // namespace fenestra::io
