#pragma once
// Where the data of a session are: at their recorded place, or where they have moved to.
//
// Data at the recorded path are used when their contents are unchanged. Fenestra reports changed data and uses them
// only within the session's folder: a session from a stranger must not open arbitrary files elsewhere. Missing data are
// searched below the session's folder, by name and then by contents; only equal contents count as found. Otherwise the
// user is asked.

#include <filesystem>
#include <string>
#include <utility>

#include "io/base/Error.h"
#include "io/base/Reading.h"
#include "io/session/Session.h"

namespace fenestra::io {

struct DataRequest;
struct Study;

/// The session's data are missing or have changed; the caller must say where they are.
class DataMissing : public Error {
 public:
  enum class Data : std::uint8_t { Volume, Labels };
  DataMissing(Data data, const std::filesystem::path& file, std::string cause, WayOut way)
      : Error(file, std::move(cause), way), data_(data) {}
  Data data() const { return data_; }

 private:
  Data data_;
};

/// Opens the data of study.session, which then says where they are and what they hold. Data at places that the request
/// names are used whatever their contents. Throws DataMissing, Error, Cancelled.
void openSessionData(const DataRequest& request, Study& study, const Progress& progress);

/// Open data as a session keeps them, without contents.
SessionVolume sessionVolume(const std::filesystem::path& path, const VolumeInfo& volume,
                            const OpenOptions& options = {});
SessionLabels sessionLabels(const std::filesystem::path& path, const std::filesystem::path& table = {});
/// Hashes the data that have no hash yet, which takes a while. Unreadable files leave the contents unknown, so that a
/// session can be saved while the disk with its data is not mounted. Throws Cancelled.
void noteContents(Session& session, const Progress& progress = {});

}  // namespace fenestra::io
