#pragma once
// DCMTK's connections under our watch: each read and write waits in short steps, so that a user can cancel at once and
// a silent peer is noticed. Private to io/archive; include in .cpp files alone.

#include <functional>
#include <memory>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/dcmlayer.h>
#include <dcmtk/dcmtls/tlslayer.h>

#include "io/archive/Server.h"
#include "io/archive/Watch.h"

namespace fenestra::io::archive {

/// The transport layer of one network of DCMTK. `watch` must outlive its connections.
class WatchedLayer : public DcmTransportLayer {
 public:
  /// With `tls`, of a requestor or an acceptor. Throws Error when its files cannot be used.
  WatchedLayer(Watch& watch, const Server& server, bool accepts);

  DcmTransportConnection* createConnection(DcmNativeSocketType socket, OFBool secure) override;
  /// Called when a connection is made, before its handshake.
  void onConnection(std::function<void()> act) { onConnection_ = std::move(act); }
  bool isSecure() const { return secure_ != nullptr; }

 private:
  Watch& watch_;
  std::function<void()> onConnection_;
  std::unique_ptr<DcmTLSTransportLayer> secure_;
};

}  // namespace fenestra::io::archive
