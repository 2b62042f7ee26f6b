#pragma once
// What a retrieval asks for, and what of it is not here yet. Private to io/archive.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/archive/Cache.h"
#include "io/archive/Records.h"
#include "io/archive/Server.h"

namespace fenestra::io::archive {

/// What a server says of an object with several frames.
struct Frames {
  int count = 0;
  std::uint64_t bytes = 0;  ///< of all without compression; 0 where it does not tell
};

/// Objects of one series that are asked for: their class by their UID.
struct Wanted {
  std::string study, series;
  std::map<std::string, std::string> objects;
  std::map<std::string, int> numbers = {};    ///< Instance Number by UID, where it is known
  std::map<std::string, Frames> frames = {};  ///< by UID, where there are several
};

/// The objects of `study` that answers at the level of images name, by series.
std::vector<Wanted> wantedIn(const std::vector<Attributes>& images, const std::string& study);
/// Those that the cache lacks.
Wanted missingOf(const Wanted& wanted, const Cache& cache);
/// The objects in an order in which few of them show all of the series: the middle one by its number first, then what
/// halves the gaps that are left.
std::vector<std::string> middleFirst(const Wanted& wanted);
/// Makes room for what is wanted, and never by what is there of it.
void makeRoom(const std::vector<Wanted>& all, const Cache& cache, const Limits& limits);

}  // namespace fenestra::io::archive
