#include "viewer/model/PathOpening.h"

#include <utility>

#include "viewer/model/Document.h"
#include "viewer/model/PathTube.h"

namespace fenestra::viewer {

PathOpening::PathOpening(Document& document) : document_(document) {
  const auto forget = [this] { before_ = std::monostate{}; };
  connect(&document, &Document::volumeChanged, this, forget);
  connect(&document, &Document::labelsChanged, this, forget);
}

bool PathOpening::isOpen() const { return tubeRadius(document_.focus(), document_.path()).has_value(); }

double PathOpening::radius() const { return tubeRadius(document_.focus(), document_.path()).value_or(radius_); }

void PathOpening::setOpen(bool on) {
  if (on == isOpen() || document_.path().empty()) return;
  Look look = document_.look();
  if (on)
    before_ = std::exchange(look.focus, tubeAround(document_.path(), radius_));
  else
    look.focus = before_;  // kept: undo may bring the tube back
  document_.edit(tr("Opening along the path"), std::move(look));
}

void PathOpening::setRadius(double mm) {
  radius_ = mm;
  if (!isOpen() || radius() == mm) return;
  Look look = document_.look();
  look.focus = tubeAround(document_.path(), mm);
  document_.edit(tr("Radius of the opening"), std::move(look));
}

}  // namespace fenestra::viewer
