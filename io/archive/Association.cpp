#include "io/archive/Association.h"

#include <algorithm>

#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmnet/diutil.h>

#include "io/archive/Reach.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::archive {
namespace {

/// What a server says about the titles that we gave, or about its state.
[[noreturn]] void explainRejection(const Server& server, T_ASC_Parameters* parameters) {
  T_ASC_RejectParameters rejection{};
  ASC_getRejectParameters(parameters, &rejection);
  switch (rejection.reason) {
    case ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED:
      refuse(server, "the server does not go by the AE title \"" + server.title + "\"",
             "ask its administrator for its AE title");
    case ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED:
      refuse(server, "the server does not know our AE title \"" + server.ownTitle + "\"",
             "have this title entered at the server, or give one that it knows");
    case ASC_REASON_SP_PRES_TEMPORARYCONGESTION:
    case ASC_REASON_SP_PRES_LOCALLIMITEXCEEDED:
      refuse(server, "the server has too many connections", "try again later");
    default:
      refuse(server, "the server refuses the association without a reason",
             "have our AE title \"" + server.ownTitle + "\" entered at the server");
  }
}

std::string sentenceOf(const OFCondition& result) {
  std::string text = result.text();
  if (const std::size_t line = text.find('\n'); line != std::string::npos) text.resize(line);
  return text;
}

}  // namespace

Association::Association(const Server& server, const std::vector<Context>& contexts, Task& task)
    : server_(server), task_(task), layer_(task.watch(), server, false) {
  prepareDcmtk();
  const std::string host = reach(server, task);
  try {
    request(host, contexts);
  } catch (...) {
    drop();
    throw;
  }
}

Association::~Association() {
  if (association_) ASC_abortAssociation(association_);
  drop();
}

void Association::drop() {
  if (association_) ASC_dropAssociation(association_);
  if (association_) ASC_destroyAssociation(&association_);
  if (network_) ASC_dropNetwork(&network_);
  association_ = nullptr;
  network_ = nullptr;
}

void Association::request(const std::string& host, const std::vector<Context>& contexts) {
  constexpr int seconds = 3600;  // DCMTK's own limit, which the watch's takes the place of
  if (ASC_initializeNetwork(NET_REQUESTOR, 0, seconds, &network_).bad()) throw std::bad_alloc();
  ASC_setTransportLayer(network_, &layer_, 0);
  T_ASC_Parameters* parameters = nullptr;
  if (ASC_createAssociationParameters(&parameters, ASC_MAXIMUMPDUSIZE).bad()) throw std::bad_alloc();
  ASC_setAPTitles(parameters, server_.ownTitle.c_str(), server_.title.c_str(), nullptr);
  const std::string peer = host + ":" + std::to_string(server_.port);
  ASC_setPresentationAddresses(parameters, "localhost", peer.c_str());
  ASC_setTransportLayerType(parameters, layer_.isSecure());
  int id = 1;
  for (const Context& context : contexts) {
    std::vector<const char*> syntaxes;
    for (const std::string& each : context.transferSyntaxes) syntaxes.push_back(each.c_str());
    ASC_addPresentationContext(parameters, static_cast<T_ASC_PresentationContextID>(id), context.abstractSyntax.c_str(),
                               syntaxes.data(), static_cast<int>(syntaxes.size()),
                               context.receives ? ASC_SC_ROLE_SCP : ASC_SC_ROLE_DEFAULT);
    id += 2;  // odd numbers (PS3.8 9.3.2.2)
  }
  T_ASC_Association* made = nullptr;
  const OFCondition result = ASC_requestAssociation(network_, parameters, &made);
  if (result.good()) {
    association_ = made;
    if (ASC_countAcceptedPresentationContexts(association_->params) == 0)
      refuse(server_, "the server accepts none of the services asked for",
             "have them allowed for our AE title \"" + server_.ownTitle + "\" at the server");
    return;
  }
  T_ASC_Parameters* said = made ? made->params : parameters;
  try {
    explain(result, said);
  } catch (...) {
    if (made) {
      ASC_destroyAssociation(&made);
    } else {
      ASC_destroyAssociationParameters(&parameters);
    }
    throw;
  }
}

void Association::explain(const OFCondition& result, T_ASC_Parameters* parameters) {
  if (result == DUL_ASSOCIATIONREJECTED) explainRejection(server_, parameters);
  if (watch().end() == Watch::End::Stopped) throw Cancelled();
  if (watch().end() == Watch::End::Silent)
    refuse(
        server_,
        "something listens there that does not answer as a DICOM server" + std::string(server_.tls ? " with TLS" : ""),
        server_.tls ? "check the port, and whether the server uses TLS there"
                    : "check the port; a server that expects TLS is named dicoms://");
  if (result.module() == OFM_dcmtls)
    refuse(server_, "no secure connection: " + sentenceOf(result),
           "name the authority that signed the server's certificate");
  refuse(server_, "what listens there is no DICOM server, or closes the connection at once",
         server_.tls ? "check the port, and whether the server asks for a certificate of ours"
                     : "check the port; a server that expects TLS is named dicoms://");
}

T_ASC_PresentationContextID Association::contextOf(const std::string& abstractSyntax,
                                                   const std::string& transferSyntax) const {
  return transferSyntax.empty()
             ? ASC_findAcceptedPresentationContextID(association_, abstractSyntax.c_str())
             : ASC_findAcceptedPresentationContextID(association_, abstractSyntax.c_str(), transferSyntax.c_str());
}

std::string Association::syntaxOf(T_ASC_PresentationContextID context) const {
  T_ASC_PresentationContext accepted{};
  const OFCondition found = ASC_findAcceptedPresentationContext(association_->params, context, &accepted);
  return found.good() ? accepted.acceptedTransferSyntax : "";
}

T_ASC_PresentationContextID Association::require(const std::string& abstractSyntax, const char* service) const {
  if (const auto id = contextOf(abstractSyntax)) return id;
  refuse(server_, std::string("the server does not offer ") + service,
         "have it allowed for our AE title \"" + server_.ownTitle + "\" at the server");
}

void Association::check(const OFCondition& result, const std::string& doing) {
  if (result.good()) return;
  switch (watch().end()) {
    case Watch::End::Stopped:
      throw Cancelled();
    case Watch::End::Silent:
      refuse(server_,
             "the server was silent for " + std::to_string(watch().silence().count() / 1000) + " s while " + doing,
             "try again; what came is kept");
    case Watch::End::TooLarge:
      refuse(server_, "the server sends more than one message may hold while " + doing, "it may be no DICOM server");
    case Watch::End::None:
      break;
  }
  isGarbled_ = result != DUL_NETWORKCLOSED && result != DUL_PEERABORTEDASSOCIATION && result != DUL_READTIMEOUT;
  refuse(server_, "the connection broke while " + doing, "try again; what came is kept");
}

T_DIMSE_Message Association::receive(T_ASC_PresentationContextID& context, const std::string& doing) {
  T_DIMSE_Message message{};
  DcmDataset* detail = nullptr;
  watch().beginMessage(1u << 20);
  const OFCondition result = DIMSE_receiveCommand(association_, DIMSE_BLOCKING, 0, &context, &message, &detail);
  delete detail;
  check(result, doing);
  return message;
}

std::unique_ptr<DcmDataset> Association::receiveData(T_ASC_PresentationContextID context, const std::string& doing) {
  DcmDataset* data = nullptr;
  watch().beginMessage(server_.limits.answerBytes);
  const OFCondition result =
      DIMSE_receiveDataSetInMemory(association_, DIMSE_BLOCKING, 0, &context, &data, nullptr, nullptr);
  std::unique_ptr<DcmDataset> owned(data);
  check(result, doing);
  return owned;
}

bool Association::hasMessage() const { return association_ && ASC_dataWaiting(association_, 0); }

std::optional<T_DIMSE_Message> Association::receiveUnlessEnded(T_ASC_PresentationContextID& context,
                                                               const std::string& doing) {
  T_DIMSE_Message message{};
  DcmDataset* detail = nullptr;
  watch().beginMessage(1u << 20);
  const OFCondition result = DIMSE_receiveCommand(association_, DIMSE_BLOCKING, 0, &context, &message, &detail);
  delete detail;
  if (watch().end() != Watch::End::None) check(result, doing);
  if (result.good()) return message;
  if (result == DUL_PEERREQUESTEDRELEASE)
    ASC_acknowledgeRelease(association_);
  else if (result != DUL_PEERABORTEDASSOCIATION)
    ASC_abortAssociation(association_);
  drop();
  return std::nullopt;
}

void Association::release() {
  if (!association_) return;
  ASC_releaseAssociation(association_);
  drop();
}

std::string meaningOf(unsigned status) {
  switch (status) {
    case 0x0110:
      return "processing failure";
    case 0x0117:
      return "invalid object instance";
    case 0x0122:
      return "class of objects not supported";
    case 0x0124:
      return "not authorised";
    case 0xa801:
      return "move destination unknown";
    case 0xfe00:
      return "cancelled";
    default:
      break;
  }
  if (status >> 8 == 0xa7) return "out of resources";
  if (status >> 8 == 0xa9) return "data do not match the class of objects";
  if (status >> 8 == 0xaa) return "cannot do what is asked";
  if (status >> 12 == 0xc) return "unable to process";
  return "failure";
}

void refuseStatus(const Server& server, const char* service, unsigned status) {
  char code[8];
  std::snprintf(code, sizeof code, "%04X", status);
  const std::string answer = std::string("the server answers ") + service + " with " + code + ", " + meaningOf(status);
  if (status == 0xa801)
    refuse(
        server, "the server does not know where to send objects for the AE title \"" + server.ownTitle + "\"",
        "have this title entered at the server with this machine's address and port " + std::to_string(server.ownPort));
  refuse(server, answer, "ask its administrator, or try other keys");
}

}  // namespace fenestra::io::archive
