#pragma once
// Series and studies from an archive into the cache (C-GET and C-MOVE, PS3.4 annex C). What a broken transfer brought
// is kept apart, and the next one asks for what is missing alone.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/archive/Arrival.h"
#include "io/archive/Cache.h"
#include "io/archive/Refusals.h"
#include "io/archive/Server.h"
#include "io/base/Reading.h"

namespace fenestra::io::archive {

enum class Way : std::uint8_t {
  Get,  ///< over the connection that we open
  Move  ///< over one that the server opens to Server::interface and ownPort
};

struct Retrieval {
  std::string study;   ///< Study Instance UID
  std::string series;  ///< Series Instance UID; empty: all of the study
  Way way = Way::Get;
  /// For whom the objects are shown while others come: the middle of a series is asked for first, then what halves the
  /// gaps, as far as the protocol lets us choose (DICOMweb for every object, DICOM's own protocol for the first one).
  /// Objects that an earlier retrieval left are told of, too, where some are still missing.
  Arrival arrived = {};
};

struct RetrievedSeries {
  std::string study, series;
  std::filesystem::path folder;  ///< in the cache, with all of its objects
  std::size_t objects = 0;       ///< that it has
  std::size_t received = 0;      ///< of these, those that came now; the others were here
};

struct Retrieved {
  std::vector<RetrievedSeries> series;
  Refusals refusals;
};

/// Throws Error, also where objects are missing in the end; Cancelled. Series that are whole by then stay in the cache.
Retrieved retrieve(const Server& server, const Retrieval& retrieval, const Cache& cache, const Progress& progress = {});

}  // namespace fenestra::io::archive
