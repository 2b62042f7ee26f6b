#include "rendering/settings/LookStyle.h"

namespace fenestra {

Look styleOf(Look look) {
  look.focus = {};
  look.labels = {};
  look.clipping = {};
  look.strokes = {};
  look.removals = {};
  look.context.preset.clear();
  look.context.file.clear();
  return look;
}

Look restyled(const Look& look, const Look& style) {
  Look result = styleOf(style);
  result.focus = look.focus;
  result.labels = look.labels;
  result.clipping = look.clipping;
  result.strokes = look.strokes;
  result.removals = look.removals;
  return result;
}

}  // namespace fenestra
