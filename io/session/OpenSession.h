#pragma once
// A session with its data: found where the session says, or where they have moved to.
//
// What lies at the recorded path is used when its contents are those that were saved. Changed contents are used, with a
// warning, only within the session's folder: a session that someone sends must not open whatever it points at
// elsewhere. Data that are not there are looked for below the session's folder, by name and then by contents; only
// equal contents count as found. For the rest the user is asked.

#include <memory>
#include <vector>

#include "io/session/Session.h"

namespace fenestra::io {

/// The session's data are not to be found, or not what they were; who reads the session must say where they are.
class DataMissing : public Error {
 public:
  enum class Data : std::uint8_t { Volume, Labels };
  DataMissing(Data data, const std::filesystem::path& file, std::string cause, std::string hint)
      : Error(file, std::move(cause), std::move(hint)), data_(data) {}
  Data data() const { return data_; }

 private:
  Data data_;
};

/// Where the user says that data are; empty: where the session says. What is there is used whatever it holds.
struct SessionPlaces {
  std::filesystem::path volume, labels;
};

struct OpenedSession {
  Session session;      ///< its data where and as they were found
  OpenedVolume volume;  ///< its warnings moved to `warnings`
  std::shared_ptr<const LabelMap> labels;
  std::vector<Warning> warnings;  ///< of the data, and what has moved or changed
};

/// Reads the session and opens its data. Throws DataMissing, Error, Cancelled.
OpenedSession openSession(const std::filesystem::path& file, const SessionPlaces& places = {},
                          const Progress& progress = {});

/// Open data as a session keeps them, without contents.
SessionVolume sessionVolume(const std::filesystem::path& path, const OpenedVolume& volume,
                            const std::optional<RawDescription>& raw = {});
SessionData sessionLabels(const std::filesystem::path& path);
/// Hashes what is not hashed yet, which takes a while. Files that cannot be read leave contents unknown: a session can
/// be saved while the disk with its data is away. Throws Cancelled.
void noteContents(Session& session, const Progress& progress = {});

}  // namespace fenestra::io
