#include "io/archive/Transport.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <cerrno>

#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmtls/tlscond.h>

namespace fenestra::io::archive {
namespace {

class WatchedConnection : public DcmTransportConnection {
 public:
  WatchedConnection(DcmNativeSocketType socket, DcmTransportConnection* inner, Watch& watch)
      : DcmTransportConnection(socket), inner_(inner), watch_(watch) {
    // Calls return after this time at the latest, so that one within a record of TLS can be given up, too.
    const timeval most{0, 100'000};
    setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &most, sizeof most);
    setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &most, sizeof most);
    const int on = 1;
    setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  }

  OFCondition clientSideHandshake() override {
    return handshake([&] { return inner_->clientSideHandshake(); });
  }
  OFCondition serverSideHandshake() override {
    return handshake([&] { return inner_->serverSideHandshake(); });
  }
  OFCondition renegotiate(const char* suite) override { return inner_->renegotiate(suite); }

  ssize_t read(void* bytes, size_t count) override {
    for (;;) {
      if (!ready()) return failed();
      errno = 0;
      const ssize_t got = inner_->read(bytes, count);
      if (got > 0) return watch_.count(static_cast<std::uint64_t>(got)) ? got : failed();
      if (got == 0 || !isToRepeat()) return got;
    }
  }

  /// All of the bytes: DCMTK takes a part for a failure.
  ssize_t write(void* bytes, size_t count) override {
    auto* next = static_cast<char*>(bytes);
    for (size_t left = count; left > 0;) {
      if (!watch_.wait(getSocket(), POLLOUT)) return failed();
      errno = 0;
      const ssize_t put = inner_->write(next, left);
      if (put <= 0 && !isToRepeat()) return -1;
      if (put <= 0) continue;
      watch_.sent();
      next += put;
      left -= static_cast<size_t>(put);
    }
    return static_cast<ssize_t>(count);
  }

  void close() override { inner_->close(); }
  void closeTransportConnection() override { inner_->closeTransportConnection(); }
  unsigned long getPeerCertificateLength() override { return inner_->getPeerCertificateLength(); }
  unsigned long getPeerCertificate(void* buffer, unsigned long size) override {
    return inner_->getPeerCertificate(buffer, size);
  }
  /// DCMTK's own limits on time are whole seconds of all data; ours is on silence.
  OFBool networkDataAvailable(int seconds) override {
    return seconds == 0 ? inner_->networkDataAvailable(0) : ready();  // 0: a question that does not wait
  }
  OFBool isTransparentConnection() override { return OFFalse; }
  OFString& dumpConnectionParameters(OFString& text) override { return inner_->dumpConnectionParameters(text); }

 private:
  bool ready() {
    if (inner_->networkDataAvailable(0)) return true;
    // A server that sends a message in parts waits up to 40 ms for an acknowledgement that is delayed.
    const int on = 1;
    setsockopt(getSocket(), IPPROTO_TCP, TCP_QUICKACK, &on, sizeof on);
    return watch_.wait(getSocket(), POLLIN);
  }
  static bool isToRepeat() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }
  static ssize_t failed() {
    errno = ECONNABORTED;
    return -1;
  }

  template <class Step>
  OFCondition handshake(const Step& step) {
    for (;;) {
      const OFCondition result = step();
      const bool reads = result == DCMTLS_EC_TLSReadOperationDidNotComplete;
      if (!reads && result != DCMTLS_EC_TLSWriteOperationDidNotComplete) return result;
      if (!watch_.wait(getSocket(), reads ? POLLIN : POLLOUT)) return result;
    }
  }

  std::unique_ptr<DcmTransportConnection> inner_;
  Watch& watch_;
};

void require(OFCondition result, const std::filesystem::path& file, const char* what) {
  if (result.bad())
    throw Error(file, std::string("cannot be read as ") + what, "name a file in PEM that is not encrypted");
}

}  // namespace

WatchedLayer::WatchedLayer(Watch& watch, const Server& server, bool accepts) : watch_(watch) {
  if (!server.tls) return;
  const TlsFiles& files = *server.tls;
  secure_ = std::make_unique<DcmTLSTransportLayer>(accepts ? NET_ACCEPTOR : NET_REQUESTOR, nullptr, OFTrue);
  // BCP 195 (PS3.15 B.9); the extended one would refuse many servers that are in use.
  secure_->setTLSProfile(TSP_Profile_BCP195);
  require(secure_->addTrustedCertificateFile(files.authorities.c_str(), DCF_Filetype_PEM), files.authorities,
          "certificates");
  if (!files.certificate.empty()) {
    require(secure_->setPrivateKeyFile(files.key.c_str(), DCF_Filetype_PEM), files.key, "a private key");
    require(secure_->setCertificateFile(files.certificate.c_str(), DCF_Filetype_PEM), files.certificate,
            "a certificate");
    if (!secure_->checkPrivateKeyMatchesCertificate())
      throw Error(files.key, "is not the key of the certificate", "name the key that belongs to the certificate");
  }
  secure_->setCertificateVerification(DCV_requireCertificate);
  require(secure_->activateCipherSuites(), files.authorities, "a choice of ciphers");
}

DcmTransportConnection* WatchedLayer::createConnection(DcmNativeSocketType socket, OFBool secure) {
  if (onConnection_) onConnection_();
  DcmTransportConnection* inner = secure && secure_ ? secure_->createConnection(socket, OFTrue)
                                                    : DcmTransportLayer::createConnection(socket, OFFalse);
  return inner ? new WatchedConnection(socket, inner, watch_) : nullptr;
}

}  // namespace fenestra::io::archive
