#pragma once
// What an editor of transfer functions can show and edit: the context's function, and how the focus looks. The focus or
// a label in it is of one material, which shows as a box over a range of values or as a level, or it has a function.

#include <compare>
#include <cstdint>
#include <vector>

#include <QString>

#include "rendering/settings/Look.h"
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

/// Whether a function can take the place of the material: of a label, a range of values and a grown region. Whether it
/// does.
bool canBeByValue(const FunctionTarget& target, const Document& document);
bool isByValue(const FunctionTarget& target, const Document& document);
/// Gives the target a function, or its one material again, as one step of the history. The function starts with two
/// points at the ends of `values`, both of the material, so that the picture stays as it is until one is moved.
void setByValue(const FunctionTarget& target, Document& document, bool byValue, ValueRange values);

/// Shows the target by `function`, as one step of the history; canBeByValue() is true of it.
void showByValue(const FunctionTarget& target, Document& document, const TransferFunction& function);

/// The target's function over values of the volume, its shift included and a label's opacity left out. That of a level
/// spans `axis`.
TransferFunction functionOf(const FunctionTarget& target, const Document& document, ValueRange axis);
/// Whether nodes can be added and deleted, and have colours of their own.
bool hasNodes(const FunctionTarget& target, const Document& document);
/// Whether moves along the values have an effect.
bool hasValues(const FunctionTarget& target, const Document& document);
/// Whether its colour is set here.
bool hasColour(const FunctionTarget& target, const Document& document);
/// What moving a part of the function moves: of nodes, that part; of a box or level, a corner takes its edge along, and
/// every move of opacity is that of the whole.
TransferFunction movedOf(const FunctionTarget& target, const Document& document, const TransferFunction& function,
                         Grip grip, double valueBy, double opacityBy);
/// Shows `function`, which was made from functionOf(), as one step of the history; steps of one gesture merge. `start`
/// is the look when the gesture began: nodes that come back to it are those of its preset again.
void setFunction(const FunctionTarget& target, Document& document, const TransferFunction& function, const Look& start);

}  // namespace fenestra::viewer
