#include "io/archive/Classes.h"

#include <dcmtk/dcmdata/dcuid.h>

namespace fenestra::io::archive {

const std::vector<std::string>& plainSyntaxes() {
  static const std::vector<std::string> syntaxes{UID_LittleEndianExplicitTransferSyntax,
                                                 UID_LittleEndianImplicitTransferSyntax};
  return syntaxes;
}

const std::vector<std::string>& packedSyntaxes() {
  static const std::vector<std::string> syntaxes{
      UID_JPEGProcess14SV1TransferSyntax,     UID_JPEGProcess14TransferSyntax,
      UID_JPEGProcess1TransferSyntax,         UID_JPEGProcess2_4TransferSyntax,
      UID_JPEGLSLosslessTransferSyntax,       UID_JPEGLSLossyTransferSyntax,
      UID_JPEG2000LosslessOnlyTransferSyntax, UID_JPEG2000TransferSyntax,
      UID_RLELosslessTransferSyntax,          UID_DeflatedExplicitVRLittleEndianTransferSyntax,
      UID_BigEndianExplicitTransferSyntax};
  return syntaxes;
}

std::vector<Context> receivingContexts(const std::set<std::string>& classes) {
  std::set<std::string> proposed = classes;
  if (proposed.empty() || proposed.contains(""))
    for (int i = 0; i < numberOfDcmLongSCUStorageSOPClassUIDs; ++i) proposed.insert(dcmLongSCUStorageSOPClassUIDs[i]);
  proposed.erase("");
  constexpr std::size_t most = 127;  // one of 128 is the retrieval's own
  const bool isEachApart = proposed.size() * (1 + packedSyntaxes().size()) <= most;
  std::vector<Context> contexts;
  for (const std::string& each : proposed) {
    contexts.push_back({each, plainSyntaxes(), true});
    if (!isEachApart) continue;
    for (const std::string& packed : packedSyntaxes()) contexts.push_back({each, {packed}, true});
  }
  if (contexts.size() > most) contexts.resize(most);
  return contexts;
}

}  // namespace fenestra::io::archive
