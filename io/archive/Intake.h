#pragma once
// Objects that come, into the cache: which are let in, how large they may be, and what was refused. Several connections
// may bring objects at once. Private to io/archive; include in .cpp files alone.

#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dimse.h>

#include "io/archive/Arrival.h"
#include "io/archive/Cache.h"
#include "io/archive/Server.h"
#include "io/archive/Wanted.h"
#include "io/archive/Watch.h"

namespace fenestra::io::archive {

class Intake {
 public:
  Intake(const Cache& cache, const Limits& limits, Activity& activity, Arrival arrived = {})
      : cache_(cache), limits_(limits), activity_(activity), arrived_(std::move(arrived)) {}

  /// From here on what is missing of `wanted` is let in, and nothing else. `total`: objects of the series, where
  /// `wanted` does not list all of them.
  void expect(const Wanted& wanted, Wanted missing, std::optional<std::size_t> total = {});
  /// Reads the object that follows a C-STORE request, keeps it where it is wanted, and answers. Bad: the association is
  /// of no more use.
  OFCondition receive(T_ASC_Association* association, T_ASC_PresentationContextID context,
                      const T_DIMSE_C_StoreRQ& request, Watch& watch);

  /// A new file for an object that comes another way; throws Error when the disk is full.
  std::filesystem::path newFile();
  /// Takes such a file in where it is wanted, and removes it otherwise.
  void take(const std::filesystem::path& file);

  /// Removes the object that came last: where what follows it on a connection makes no sense, it may be garbled as
  /// well.
  void dropLast();

  /// Objects that came since expect(), and those refused at all.
  std::size_t received() const { return received_; }
  std::size_t refused() const { return refused_; }
  /// Why objects that were wanted could not be kept, as a clause; empty: they could.
  std::string failure() const;

 private:
  DIC_US verdictOn(const T_DIMSE_C_StoreRQ& request);
  /// `object`: the UID that the file was said to have; empty: none was said.
  DIC_US keep(const std::filesystem::path& file, const std::string& object);
  bool isFull();
  void tell(const std::string& object, const std::filesystem::path& file);
  /// The object that follows as a file. `isWritten`: the disk holds all that came of it.
  OFCondition readInto(const std::filesystem::path& file, T_ASC_Association* association,
                       T_ASC_PresentationContextID context, const T_DIMSE_C_StoreRQ& request, bool& isWritten);
  void noteUnwritten();

  const Cache& cache_;
  const Limits& limits_;
  Activity& activity_;
  const Arrival arrived_;
  mutable std::mutex mutex_;
  Wanted wanted_;          ///< what is missing
  std::size_t total_ = 0;  ///< objects of the series
  std::set<std::string> told_;
  std::filesystem::path part_;
  std::filesystem::path last_;  ///< the object that was kept last; empty: none
  std::string failure_;
  std::atomic<std::size_t> received_ = 0, refused_ = 0, files_ = 0;
};

}  // namespace fenestra::io::archive
