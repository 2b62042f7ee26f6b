#include "io/archive/StorageProvider.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmnet/dul.h>

#include "io/archive/Classes.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::archive {
namespace {

/// DCMTK takes a connected socket by a global variable.
std::mutex handingOver;

void rejectTitle(T_ASC_Association* association, T_ASC_RejectParametersReason reason) {
  const T_ASC_RejectParameters rejection{ASC_RESULT_REJECTEDPERMANENT, ASC_SOURCE_SERVICEUSER, reason};
  ASC_rejectAssociation(association, &rejection);
}

}  // namespace

StorageProvider::StorageProvider(const Server& server, std::set<std::string> classes, Intake& intake)
    : server_(server), classes_(std::move(classes)), intake_(intake) {
  prepareDcmtk();
  listen();
  listening_ = std::thread([this] { run(); });
}

StorageProvider::~StorageProvider() {
  stops_ = true;
  listening_.join();
  for (Served& each : served_) each.thread.join();
  for (const Waiting& each : waiting_) close(each.socket);
  close(socket_);
}

Refusals StorageProvider::refusals() const { return {connections_, titles_, classesRefused_, 0}; }

void StorageProvider::listen() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(server_.ownPort));
  const std::string place = server_.interface + ":" + std::to_string(server_.ownPort);
  if (inet_pton(AF_INET, server_.interface.c_str(), &address.sin_addr) != 1)
    throw Error(place, "is no address of this machine", "give the address that the server sends to, in figures");
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (socket_ >= 0 && bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      ::listen(socket_, SOMAXCONN) == 0)
    return;
  const std::string why = std::strerror(errno);
  if (socket_ >= 0) close(socket_);
  throw Error(place, "cannot be listened on: " + why,
              "give a free port of this machine, and have it entered at the server");
}

void StorageProvider::run() {
  while (!stops_) {
    pollfd waited{socket_, POLLIN, 0};
    constexpr int step = 20;  // ms; connections that wait are looked at as often
    if (poll(&waited, 1, step) > 0) admit();
    sortWaiting();
  }
}

void StorageProvider::admit() {
  for (int accepted = -1; !stops_ && (accepted = accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC)) >= 0;) {
    if (waiting_.size() >= server_.limits.waitingConnections) sortWaiting();
    if (waiting_.size() >= server_.limits.waitingConnections) {  // the one that waits longest makes room
      close(waiting_.front().socket);
      waiting_.erase(waiting_.begin());
      ++connections_;
    }
    waiting_.push_back({accepted, std::chrono::steady_clock::now()});
  }
}

StorageProvider::Introduction StorageProvider::introductionOf(int socket) const {
  std::array<unsigned char, 6> start{};
  const ssize_t there = recv(socket, start.data(), start.size(), MSG_PEEK | MSG_DONTWAIT);
  if (there < 0) return errno == EAGAIN || errno == EINTR ? Introduction::Expected : Introduction::Wrong;
  if (there == 0) return Introduction::Wrong;
  constexpr unsigned char handshake = 0x16, associateRequest = 0x01;  // RFC 8446 5.1; PS3.8 9.3.2
  if (server_.tls) return start[0] == handshake ? Introduction::Complete : Introduction::Wrong;
  if (start[0] != associateRequest) return Introduction::Wrong;
  if (there < static_cast<ssize_t>(start.size())) return Introduction::Expected;
  const std::uint32_t length = static_cast<std::uint32_t>(start[2]) << 24 | static_cast<std::uint32_t>(start[3]) << 16 |
                               static_cast<std::uint32_t>(start[4]) << 8 | start[5];
  constexpr std::uint32_t most = 1u << 16;  // 128 contexts with ten transfer syntaxes each
  if (length > most) return Introduction::Wrong;
  int bytes = 0;
  ioctl(socket, FIONREAD, &bytes);
  return static_cast<std::uint32_t>(bytes) >= length + start.size() ? Introduction::Complete : Introduction::Expected;
}

void StorageProvider::sortWaiting() {
  for (auto each = served_.begin(); each != served_.end();) {
    if (!each->isOver) {
      ++each;
      continue;
    }
    each->thread.join();
    each = served_.erase(each);
  }
  const auto now = std::chrono::steady_clock::now();
  for (auto each = waiting_.begin(); each != waiting_.end();) {
    const Introduction introduction = introductionOf(each->socket);
    const bool isComplete = introduction == Introduction::Complete;
    const bool isLate = now - each->since > (isComplete ? server_.limits.silence : server_.limits.introduction);
    if (isComplete && served_.size() < server_.limits.associations) {
      Served& served = served_.emplace_back();
      served.thread = std::thread([this, &served, socket = each->socket] {
        serve(socket);
        served.isOver = true;
      });
    } else if (introduction != Introduction::Wrong && !isLate) {
      ++each;
      continue;
    } else {
      ++connections_;
      close(each->socket);
    }
    each = waiting_.erase(each);
  }
}

OFCondition StorageProvider::receiveAssociation(int socket, WatchedLayer& layer, T_ASC_Network*& network,
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

void StorageProvider::serve(int socket) {
  Activity activity;
  Watch watch([this] { return !stops_; }, server_.limits.introduction, activity);
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
}

bool StorageProvider::negotiate(T_ASC_Association* association) {
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
    if (!classes_.contains(proposed.abstractSyntax)) {
      ASC_refusePresentationContext(association->params, id, ASC_P_ABSTRACTSYNTAXNOTSUPPORTED);
    } else if (syntax == end) {
      ASC_refusePresentationContext(association->params, id, ASC_P_TRANSFERSYNTAXESNOTSUPPORTED);
    } else {
      ASC_acceptPresentationContext(association->params, id, *syntax);
      accepts = true;
    }
  }
  if (accepts) return ASC_acknowledgeAssociation(association).good();
  ++classesRefused_;
  rejectTitle(association, ASC_REASON_SU_NOREASON);
  return false;
}

void StorageProvider::converse(T_ASC_Association* association, Watch& watch) {
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
    if (result.good() && request.CommandField == DIMSE_C_STORE_RQ &&
        intake_.receive(association, context, request.msg.CStoreRQ, watch).good())
      continue;
    if (result.good()) ASC_abortAssociation(association);
    return;
  }
}

}  // namespace fenestra::io::archive
