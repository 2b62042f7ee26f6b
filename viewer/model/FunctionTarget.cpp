#include "viewer/model/FunctionTarget.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "viewer/model/Document.h"
#include "viewer/model/LabelName.h"

namespace fenestra::viewer {
namespace {

using Kind = FunctionTarget::Kind;

struct Text {
  Q_DECLARE_TR_FUNCTIONS(FunctionTarget)
};

const ValueFocus* rangeOf(const FunctionTarget& target, const Document& document) {
  return target.kind == Kind::Focus ? std::get_if<ValueFocus>(&document.focus()) : nullptr;
}

/// The function of a part of the focus; empty where there is none.
std::optional<TransferFunction> functionIn(const FunctionTarget& target, const Document& document) {
  if (target.kind == Kind::Label) return document.labelSetting(target.label).function;
  return target.kind == Kind::Focus ? document.look().focusAppearance.function : std::nullopt;
}

void showFunction(const FunctionTarget& target, Document& document, std::optional<TransferFunction> function) {
  if (target.kind == Kind::Label) {
    LabelSetting setting = document.labelSetting(target.label);
    setting.function = std::move(function);
    if (setting != document.labelSetting(target.label)) document.setLabelSetting(setting, Text::tr("Focus"));
    return;
  }
  Look look = document.look();
  look.focusAppearance.function = std::move(function);
  if (look != document.look()) document.edit(Text::tr("Focus"), std::move(look));
}

OpticalProperties materialOf(const FunctionTarget& target, const Document& document) {
  const Look& look = document.look();
  if (target.kind != Kind::Label) return {look.focusAppearance.colour, look.focusAppearance.extinction};
  return focusMaterial({document.scene().volume, document.labels(), look}, target.label);
}

/// The opacity setting with which a label in focus has that extinction; the inverse of opticalExtinction.
double opacitySetting(double extinction, double full) {
  constexpr double thickness = 10.0;  // mm
  if (full <= 0.0) return 1.0;
  return std::clamp(std::expm1(-extinction * thickness) / std::expm1(-full * thickness), 0.0, 1.0);
}

void setContext(Document& document, const TransferFunction& function, const ContextFunction& start) {
  Look look = document.look();
  ContextFunction& context = look.context;
  TransferFunction unshifted = function;
  for (TransferFunction::Node& node : unshifted.nodes) node.value -= context.shift;
  // Nodes that did not move keep their values to the bit.
  const TransferFunction shown = context.shifted();
  if (shown.nodes.size() == function.nodes.size())
    for (std::size_t node = 0; node < function.nodes.size(); ++node)
      if (function.nodes[node].value == shown.nodes[node].value)
        unshifted.nodes[node].value = context.function.nodes[node].value;
  if (unshifted == context.function) return;
  context = {.preset = {}, .file = {}, .function = std::move(unshifted), .shift = context.shift};
  if (context.function == start.function && context.shift == start.shift) context = start;
  document.edit(Text::tr("Transfer function"), std::move(look));
}

void setLabel(Document& document, std::uint16_t label, const OpticalProperties& material) {
  const OpticalProperties before = materialOf({Kind::Label, label}, document);
  LabelSetting setting = document.labelSetting(label);
  if (material.extinction != before.extinction)
    setting.opacity = opacitySetting(material.extinction, document.look().focusAppearance.extinction);
  if (material.colour != before.colour) setting.colour = material.colour;
  if (setting != document.labelSetting(label)) document.setLabelSetting(setting, Text::tr("Focus"));
}

void setFocus(Document& document, const TransferFunction& function, bool isRange) {
  Look look = document.look();
  const OpticalProperties& material = function.nodes[isRange ? 1 : 0].properties;
  look.focusAppearance.colour = material.colour;
  look.focusAppearance.extinction = material.extinction;
  if (isRange) {
    const ValueRange& all = document.scene().volume->range;
    std::get<ValueFocus>(look.focus).values = {std::clamp(function.nodes.front().value, all.low, all.high),
                                               std::clamp(function.nodes.back().value, all.low, all.high)};
  }
  if (look != document.look()) document.edit(Text::tr("Focus"), std::move(look));
}

}  // namespace

std::vector<FunctionTarget> targetsOf(const Document& document) {
  std::vector<FunctionTarget> targets{{}};
  if (!std::holds_alternative<std::monostate>(document.focus())) targets.push_back({Kind::Focus});
  if (const auto* focus = std::get_if<LabelFocus>(&document.focus()))
    for (const std::uint16_t label : focus->labels) targets.push_back({Kind::Label, label});
  return targets;
}

QString nameOf(const FunctionTarget& target, const Document& document) {
  if (target.kind == Kind::Context) return Text::tr("Context");
  if (target.kind == Kind::Focus) return Text::tr("Focus");
  const Label* label = document.labels() ? document.labels()->find(target.label) : nullptr;
  return Text::tr("Focus: %1").arg(nameOf(label ? *label : Label{target.label, {}, {}}));
}

bool canBeByValue(const FunctionTarget& target, const Document& document) {
  return target.kind == Kind::Label ||
         (target.kind == Kind::Focus && !std::holds_alternative<LabelFocus>(document.focus()));
}

bool isByValue(const FunctionTarget& target, const Document& document) {
  return canBeByValue(target, document) && functionIn(target, document);
}

void setByValue(const FunctionTarget& target, Document& document, bool byValue, ValueRange values) {
  if (!canBeByValue(target, document) || byValue == isByValue(target, document)) return;
  if (!byValue) return showFunction(target, document, std::nullopt);
  // A label's opacity comes on top of the function, as it does of the material.
  const OpticalProperties material{materialOf(target, document).colour, document.look().focusAppearance.extinction};
  showFunction(target, document, TransferFunction{{{values.low, material}, {values.high, material}}});
}

void showByValue(const FunctionTarget& target, Document& document, const TransferFunction& function) {
  if (canBeByValue(target, document)) showFunction(target, document, function);
}

TransferFunction functionOf(const FunctionTarget& target, const Document& document, ValueRange axis) {
  if (target.kind == Kind::Context) return document.look().context.shifted();
  if (isByValue(target, document)) return *functionIn(target, document);
  const OpticalProperties material = materialOf(target, document);
  const ValueFocus* range = rangeOf(target, document);
  if (!range) return {{{axis.low, material}, {axis.high, material}}};
  const OpticalProperties nothing{material.colour, 0.0};
  return {{{range->values.low, nothing},
           {range->values.low, material},
           {range->values.high, material},
           {range->values.high, nothing}}};
}

bool hasNodes(const FunctionTarget& target, const Document& document) {
  return target.kind == Kind::Context || isByValue(target, document);
}

bool hasValues(const FunctionTarget& target, const Document& document) {
  return hasNodes(target, document) || rangeOf(target, document);
}

bool hasColour(const FunctionTarget& target, const Document& document) {
  return target.kind != Kind::Focus || hasNodes(target, document) || rangeOf(target, document);
}

TransferFunction movedOf(const FunctionTarget& target, const Document& document, const TransferFunction& function,
                         Grip grip, double valueBy, double opacityBy) {
  if (hasNodes(target, document)) return moved(function, grip, valueBy, opacityBy);
  TransferFunction result = function;
  const bool isRange = function.nodes.size() == 4;
  if (isRange && valueBy != 0.0 && grip.part != Grip::Part::Plateau) {
    Grip along{grip.part, 0};
    if (grip.part == Grip::Part::Node) along.part = grip.node < 2 ? Grip::Part::LeftEdge : Grip::Part::RightEdge;
    result = moved(function, along, valueBy, 0.0);
  }
  const std::size_t first = isRange ? 1 : 0;
  const double extinction = result.nodes[first].properties.extinction;
  if (opacityBy != 0.0)
    for (const std::size_t node : {first, first + 1})
      result.nodes[node].properties.extinction = extinctionFromOpacity(opacityFromExtinction(extinction) + opacityBy);
  return result;
}

void setFunction(const FunctionTarget& target, Document& document, const TransferFunction& function,
                 const Look& start) {
  if (isByValue(target, document)) return showFunction(target, document, function);
  switch (target.kind) {
    case Kind::Context:
      return setContext(document, function, start.context);
    case Kind::Focus:
      return setFocus(document, function, rangeOf(target, document));
    case Kind::Label:
      return setLabel(document, target.label, function.nodes.front().properties);
  }
}

}  // namespace fenestra::viewer
