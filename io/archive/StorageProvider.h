#pragma once
// Receives the objects that a server sends for our C-MOVE, and lets no one else in (storage service class provider,
// PS3.4 annex B): the Provider takes associations for the classes asked for, the Intake the objects asked for. Private
// to io/archive; include in .cpp files alone.

#include <set>
#include <string>

#include "io/archive/Intake.h"
#include "io/archive/Provider.h"

namespace fenestra::io::archive {

/// `intake` outlives what uses it.
inline Service storageService(std::set<std::string> classes, Intake& intake) {
  return {std::move(classes), false,
          [&intake](T_ASC_Association* association, T_ASC_PresentationContextID context, const T_DIMSE_Message& request,
                    Watch& watch) {
            return request.CommandField == DIMSE_C_STORE_RQ &&
                   intake.receive(association, context, request.msg.CStoreRQ, watch).good();
          }};
}

class StorageProvider : public Provider {
 public:
  /// Both outlive this. Throws Error as Provider does.
  StorageProvider(const Server& server, std::set<std::string> classes, Intake& intake)
      : Provider(server, storageService(std::move(classes), intake)) {}
};

}  // namespace fenestra::io::archive
