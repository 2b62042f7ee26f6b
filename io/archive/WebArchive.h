#pragma once
// What Query.h, Retrieve.h and Send.h do, with a server that speaks DICOMweb: QIDO-RS, WADO-RS and STOW-RS (PS3.18 10.4
// to 10.6). Queries ask for no more than servers commonly match: keys without sequences, and no fuzzy matching.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "io/archive/Cache.h"
#include "io/archive/Query.h"
#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "io/archive/WebServer.h"

namespace fenestra::io::archive {

std::chrono::milliseconds echo(const WebServer& server, const Progress& progress = {});
Answers find(const WebServer& server, const Query& query, const Progress& progress = {});
/// Retrieval::way has no meaning here.
Retrieved retrieve(const WebServer& server, const Retrieval& retrieval, const Cache& cache,
                   const Progress& progress = {});
std::vector<Sent> send(const WebServer& server, const std::vector<std::filesystem::path>& files,
                       const Progress& progress = {});

/// The attributes of a series' objects, without their pixels.
std::vector<Attributes> metadata(const WebServer& server, const std::string& study, const std::string& series,
                                 const Progress& progress = {});

}  // namespace fenestra::io::archive
