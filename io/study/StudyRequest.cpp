#include "io/study/StudyRequest.h"

#include "io/session/SessionFile.h"
#include "rendering/settings/LookStyle.h"

namespace fenestra::io {

namespace {

/// In another style, but for a session's transfer function.
void restyle(StudyRequest& request, const Look& style) {
  Look look = restyled(request.look, style);
  if (request.session) look.context = request.look.context;
  request.look = std::move(look);
}

}  // namespace

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

void StudyRequest::makePlain() {
  restyle(*this, Look{});
  startsPlain = true;
}

void StudyRequest::makeStarting() {
  restyle(*this, startingLook());
  startsPlain = false;
}

void StudyRequest::makeBare() {
  if (!session) makePlain();
  const Look bare = bareLook();
  look.contextLayer = bare.contextLayer;
  look.cutaway.borderWidth = bare.cutaway.borderWidth;
  look.cutaway.borderColour = bare.cutaway.borderColour;
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
  if (request.focusLabels.size() > 1) return LabelFocus{{1, 2}};  // several labels have programs of their own
  return labelled ? Focus(LabelFocus()) : Focus();
}

}  // namespace fenestra::io
