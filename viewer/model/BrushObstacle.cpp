#include "viewer/model/BrushObstacle.h"

#include <variant>

#include "viewer/model/Document.h"

namespace fenestra::viewer {
namespace {

/// mm along the ray; a picture does not show less.
constexpr double leastStretch = 0.01;

std::optional<BrushObstacle> obstacleAt(const BrushSettings& settings, const Look& look,
                                        const std::optional<BrushPoint>& point) {
  if (!point || !point->hitsContext) return BrushObstacle::NothingThere;
  switch (settings.mode) {
    case BrushMode::Restore:
      if (point->removed < leastStretch) return BrushObstacle::NothingRemoved;
      if (point->meetsFocus && !settings.coversFocus) return BrushObstacle::SparesFocus;
      return std::nullopt;
    case BrushMode::Open:
      if (point->meetsFocus && point->beforeFocus < leastStretch) return BrushObstacle::ReachedFocus;
      return std::nullopt;
    case BrushMode::Fade:
    case BrushMode::Strengthen:
      break;
  }
  if (look.contextLayer.strength <= 0.0) return BrushObstacle::EdgesOff;
  if (!point->meetsFocus) return BrushObstacle::OffFocus;
  return std::nullopt;
}

}  // namespace

std::optional<BrushObstacle> obstacleTo(const BrushSettings& settings, const Look& look,
                                        std::span<const std::optional<BrushPoint>> points) {
  if (std::holds_alternative<std::monostate>(look.focus)) return BrushObstacle::NoFocus;
  if (!look.cutaway.enabled) return BrushObstacle::CutawayOff;
  if (stagesOf(look.method).start == MethodStages::Start::Entry) return BrushObstacle::NothingIsCut;
  std::optional<BrushObstacle> first;
  for (const std::optional<BrushPoint>& point : points) {
    const std::optional<BrushObstacle> obstacle = obstacleAt(settings, look, point);
    if (!obstacle) return std::nullopt;
    if (!first) first = obstacle;
  }
  return first;
}

QString textOf(BrushObstacle obstacle) {
  switch (obstacle) {
    case BrushObstacle::NoFocus:
      return Brush::tr("Nothing is open: choose a focus first");
    case BrushObstacle::CutawayOff:
      return Brush::tr("The opening is switched off");
    case BrushObstacle::NothingIsCut:
      return Brush::tr("This method cuts nothing away");
    case BrushObstacle::NothingThere:
      return Brush::tr("Nothing is there");
    case BrushObstacle::NothingRemoved:
      return Brush::tr("Nothing was removed here");
    case BrushObstacle::SparesFocus:
      return Brush::tr("The brush may not cover the focus");
    case BrushObstacle::ReachedFocus:
      return Brush::tr("Open down to the focus already");
    case BrushObstacle::EdgesOff:
      return Brush::tr("The context's edges are switched off");
    case BrushObstacle::OffFocus:
      break;
  }
  return Brush::tr("Edges are drawn over the focus alone");
}

QString remedyOf(BrushObstacle obstacle) {
  switch (obstacle) {
    case BrushObstacle::CutawayOff:
      return Brush::tr("switch the opening on");
    case BrushObstacle::NothingRemoved:
      return Brush::tr("open instead");
    case BrushObstacle::SparesFocus:
      return Brush::tr("let it cover the focus");
    case BrushObstacle::ReachedFocus:
      return Brush::tr("restore instead");
    case BrushObstacle::EdgesOff:
      return Brush::tr("switch the edges on");
    case BrushObstacle::NothingIsCut:
      return Brush::tr("take the adaptive cutaway");
    case BrushObstacle::NoFocus:
    case BrushObstacle::NothingThere:
    case BrushObstacle::OffFocus:
      break;
  }
  return {};
}

void applyRemedy(BrushObstacle obstacle, Brush& brush, Document& document) {
  BrushSettings settings = brush.settings();
  Look look = document.look();
  switch (obstacle) {
    case BrushObstacle::CutawayOff:
      look.cutaway.enabled = true;
      return document.edit(Brush::tr("Open the context"), std::move(look));
    case BrushObstacle::NothingIsCut:
      look.method.kind = kindOf<methods::Adaptive>;
      return document.edit(Brush::tr("Method"), std::move(look));
    case BrushObstacle::EdgesOff:
      look.contextLayer.strength = ContextLayer{}.strength;
      return document.edit(Brush::tr("Context's edges"), std::move(look));
    case BrushObstacle::NothingRemoved:
      settings.mode = BrushMode::Open;
      break;
    case BrushObstacle::ReachedFocus:
      settings.mode = BrushMode::Restore;
      break;
    case BrushObstacle::SparesFocus:
      settings.coversFocus = true;
      break;
    case BrushObstacle::NoFocus:
    case BrushObstacle::NothingThere:
    case BrushObstacle::OffFocus:
      break;
  }
  brush.setSettings(settings);
}

}  // namespace fenestra::viewer
