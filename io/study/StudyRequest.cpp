#include "io/study/StudyRequest.h"

#include "io/session/SessionFile.h"

namespace fenestra::io {

std::string DataRequest::source() const { return phantom.empty() ? path.string() : "phantom " + phantom; }

std::filesystem::path DataRequest::labelSource() const {
  return labels.empty() ? std::filesystem::path(source()) : labels;
}

void StudyRequest::startFrom(Session from) {
  look = from.look;
  quality = from.quality;
  maxError = from.maxError;
  slices = {from.crosshair, from.window, from.inverted};
  session = std::move(from);
}

StudyRequest requestOfSession(const std::filesystem::path& file) {
  StudyRequest request;
  request.path = file;
  request.startFrom(readSession(file));
  return request;
}

Focus expectedFocus(const StudyRequest& request) {
  if (request.focusRange) return ValueFocus();
  const bool labelled = !request.focusLabels.empty() || !request.region.empty() || !request.phantom.empty();
  return labelled ? Focus(LabelFocus()) : Focus();
}

}  // namespace fenestra::io
