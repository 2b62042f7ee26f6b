#pragma once
// Why the brush can have no effect at a place of a picture, and what would let it.

#include <optional>
#include <span>

#include <QString>

#include "rendering/scene/Scene.h"
#include "rendering/settings/BrushStroke.h"
#include "viewer/model/Brush.h"

namespace fenestra::viewer {

class Document;

enum class BrushObstacle {
  NoFocus,         ///< nothing is cut open without one
  CutawayOff,      ///< the opening is switched off
  NothingIsCut,    ///< the method opens nothing
  NothingThere,    ///< the background
  NothingRemoved,  ///< Restore: the context is whole there
  SparesFocus,     ///< Restore: the focus lies there and must not be covered
  ReachedFocus,    ///< Open: the focus is free there
  EdgesOff,        ///< Fade, Strengthen: the context's edges are not drawn at all
  OffFocus,        ///< Fade, Strengthen: no focus there, over which edges would be drawn
};

/// Why a stroke would change nothing at the points that it touches (Renderer::pickBrush; empty where it touches
/// nothing), the first of which is its centre. Empty when it has an effect at any of them.
std::optional<BrushObstacle> obstacleTo(const BrushSettings& settings, const Look& look,
                                        std::span<const std::optional<BrushPoint>> points);
/// One short sentence without its full stop.
QString textOf(BrushObstacle obstacle);
/// The remedy: what would let the stroke have an effect; empty where no setting does.
QString remedyOf(BrushObstacle obstacle);
/// Applies the remedy.
void applyRemedy(BrushObstacle obstacle, Brush& brush, Document& document);

}  // namespace fenestra::viewer
