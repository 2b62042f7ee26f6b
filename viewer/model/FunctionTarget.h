#pragma once
// What an editor of transfer functions can show and edit: the context's function, and how the focus looks. The focus is
// of one material, or of one for each label, so that its function is a box over a range of values, or a level.

#include <compare>
#include <cstdint>
#include <vector>

#include <QString>

#include "rendering/scene/Look.h"
#include "viewer/model/FunctionEdit.h"

namespace fenestra::viewer {

class Document;

struct FunctionTarget {
  enum class Kind : std::uint8_t { Context, Focus, Label };
  Kind kind = Kind::Context;
  std::uint16_t label = 0;  ///< in focus
  bool operator==(const FunctionTarget&) const = default;
};

/// The context, the focus where there is one, and each label of a focus of labels.
std::vector<FunctionTarget> targetsOf(const Document& document);
QString nameOf(const FunctionTarget& target, const Document& document);

/// The target's function over values of the volume, its shift included. That of a level spans `axis`.
TransferFunction functionOf(const FunctionTarget& target, const Document& document, ValueRange axis);
/// Whether nodes can be added and deleted, and have colours of their own.
inline bool hasNodes(const FunctionTarget& target) { return target.kind == FunctionTarget::Kind::Context; }
/// Whether moves along the values have an effect.
bool hasValues(const FunctionTarget& target, const Document& document);
/// Whether its colour is set here.
bool hasColour(const FunctionTarget& target, const Document& document);
/// What moving a part of the function moves: of a box or level, a corner takes its edge along, and every move of
/// opacity is that of the whole.
TransferFunction movedOf(const FunctionTarget& target, const TransferFunction& function, Grip grip, double valueBy,
                         double opacityBy);
/// Shows `function`, which was made from functionOf(), as one step of the history; steps of one gesture merge. `start`
/// is the look when the gesture began: nodes that come back to it are those of its preset again.
void setFunction(const FunctionTarget& target, Document& document, const TransferFunction& function, const Look& start);

}  // namespace fenestra::viewer
