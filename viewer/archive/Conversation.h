#pragma once
// What a worker does with a server, whichever protocol it speaks.

#include <utility>

#include "io/archive/Query.h"
#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "io/archive/WebArchive.h"
#include "viewer/archive/Archives.h"

namespace fenestra::viewer {

/// A server to be spoken to from another thread.
class Conversation {
 public:
  Conversation(Archives& archives, QString id, AnyServer server)
      : archives_(archives), id_(std::move(id)), server_(std::move(server)) {}

  /// `act` with the io::archive::Server or WebServer. After a refused login the secret is forgotten, so that it is
  /// asked for again. Throws what `act` throws.
  template <class Act>
  auto run(const Act& act) const {
    try {
      return std::visit(act, server_);
    } catch (const io::archive::LoginRefused&) {
      QMetaObject::invokeMethod(&archives_, [&archives = archives_, id = id_] { archives.forgetSecret(id); });
      throw;
    }
  }

 private:
  Archives& archives_;  ///< outlives all jobs
  QString id_;
  AnyServer server_;
};

}  // namespace fenestra::viewer
