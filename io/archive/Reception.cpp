#include "io/archive/Reception.h"

#include <unistd.h>
#include <algorithm>
#include <mutex>
#include <optional>

#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmnet/dul.h>

#include "io/archive/Classes.h"

namespace fenestra::io::archive {
namespace {

/// DCMTK takes a connected socket by a global variable.
std::mutex handingOver;

void rejectTitle(T_ASC_Association* association, T_ASC_RejectParametersReason reason) {
  const T_ASC_RejectParameters rejection{ASC_RESULT_REJECTEDPERMANENT, ASC_SOURCE_SERVICEUSER, reason};
  ASC_rejectAssociation(association, &rejection);
}

}  // namespace

OFCondition Reception::receiveAssociation(int socket, WatchedLayer& layer, T_ASC_Network*& network,
                                          T_ASC_Association*& association) {
  constexpr int seconds = 3600;  // the watch's limits take their place
  std::unique_lock lock(handingOver);
  const auto taken = [&] {
    dcmExternalSocketHandle.set(-1);
    lock.unlock();
  };
  layer.onConnection(taken);  // a handshake that never ends holds nobody else up
  dcmExternalSocketHandle.set(socket);
  OFCondition result = ASC_initializeNetwork(NET_ACCEPTOR, 0, seconds, &network);
  if (result.good()) {
    ASC_setTransportLayer(network, &layer, 0);
    result = ASC_receiveAssociation(network, &association, ASC_MAXIMUMPDUSIZE, nullptr, nullptr, layer.isSecure(),
                                    DUL_NOBLOCK, seconds);
  }
  if (lock.owns_lock()) taken();
  layer.onConnection({});
  return result;
}

void Reception::serve(int socket, const std::atomic<bool>& stops) {
  ++serving_;
  Activity activity;
  Watch watch([&stops] { return !stops; }, server_.limits.introduction, activity);
  T_ASC_Network* network = nullptr;
  T_ASC_Association* association = nullptr;
  std::optional<WatchedLayer> layer;  // outlives the association
  try {
    layer.emplace(watch, server_, true);
    const bool isReceived = receiveAssociation(socket, *layer, network, association).good();
    watch.setSilence(server_.limits.silence);
    if (!isReceived)
      ++connections_;
    else if (negotiate(association))
      converse(association, watch);
  } catch (const Error&) {  // of TLS's files, or of a disk that has become full
    ++connections_;
    if (!network) close(socket);
  }
  if (association) {
    ASC_dropAssociation(association);
    ASC_destroyAssociation(&association);
  }
  if (network) ASC_dropNetwork(&network);
  --serving_;
}

bool Reception::negotiate(T_ASC_Association* association) {
  DIC_AE calling{}, called{}, responding{};
  ASC_getAPTitles(association->params, calling, sizeof calling, called, sizeof called, responding, sizeof responding);
  if (called != server_.ownTitle || calling != server_.title) {
    ++titles_;
    rejectTitle(association, called != server_.ownTitle ? ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED
                                                        : ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED);
    return false;
  }
  std::vector<std::string> known = packedSyntaxes();
  known.insert(known.begin(), plainSyntaxes().begin(), plainSyntaxes().end());
  bool accepts = false;
  for (int i = 0; i < ASC_countPresentationContexts(association->params); ++i) {
    T_ASC_PresentationContext proposed{};
    ASC_getPresentationContext(association->params, i, &proposed);
    const auto* const begin = proposed.proposedTransferSyntaxes;
    const auto* const end = begin + proposed.transferSyntaxCount;
    const auto* const syntax = std::find_if(
        begin, end, [&](const char* each) { return std::find(known.begin(), known.end(), each) != known.end(); });
    const auto id = proposed.presentationContextID;
    if (!service_.classes.contains(proposed.abstractSyntax)) {
      ASC_refusePresentationContext(association->params, id, ASC_P_ABSTRACTSYNTAXNOTSUPPORTED);
    } else if (syntax == end) {
      ASC_refusePresentationContext(association->params, id, ASC_P_TRANSFERSYNTAXESNOTSUPPORTED);
    } else {
      // A server that provides the service proposes the role for that, or leaves roles out.
      ASC_acceptPresentationContext(association->params, id, *syntax,
                                    service_.isOfPeer ? proposed.proposedRole : ASC_SC_ROLE_DEFAULT);
      accepts = true;
    }
  }
  if (accepts) return ASC_acknowledgeAssociation(association).good();
  ++classes_;
  rejectTitle(association, ASC_REASON_SU_NOREASON);
  return false;
}

void Reception::converse(T_ASC_Association* association, Watch& watch) {
  for (;;) {
    T_ASC_PresentationContextID context = 0;
    T_DIMSE_Message request{};
    DcmDataset* detail = nullptr;
    watch.beginMessage(1u << 20);
    const OFCondition result = DIMSE_receiveCommand(association, DIMSE_BLOCKING, 0, &context, &request, &detail);
    delete detail;
    if (result == DUL_PEERREQUESTEDRELEASE) {
      ASC_acknowledgeRelease(association);
      return;
    }
    if (result.good() && service_.receive(association, context, request, watch)) continue;
    if (result.good()) ASC_abortAssociation(association);
    return;
  }
}

}  // namespace fenestra::io::archive
