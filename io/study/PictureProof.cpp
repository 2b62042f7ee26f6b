#include "io/study/PictureProof.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "io/base/Contents.h"
#include "io/session/SessionFile.h"

namespace fenestra::io {

PngText proofOf(const reference::Certificate& certificate, Session session) {
  nlohmann::ordered_json json{{"statement", reference::statementOf(certificate)},
                              {"within", certificate.within},
                              {"share", certificate.share},
                              {"confidence", certificate.confidence},
                              {"pixels", certificate.pixels},
                              {"exceeding", certificate.exceeding},
                              {"seed", certificate.seed},
                              {"greatest", nullptr},
                              {"version", FENESTRA_VERSION}};
  if (std::isfinite(certificate.greatest)) json["greatest"] = certificate.greatest;
  const auto hashes = [&](const char* name, const SessionData& data) {
    if (!data.contents.hash.empty()) json[name] = data.contents.hash;
  };
  hashes("data", session.volume);
  hashes("labels", session.labels);
  session.volume.path.clear();
  session.labels.path.clear();
  json["scene"] = hashOf(textOf(session, "/scene.fenestra"));
  return {"Fenestra certificate", json.dump(-1, ' ', true)};
}

}  // namespace fenestra::io
