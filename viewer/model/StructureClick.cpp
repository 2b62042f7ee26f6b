#include "viewer/model/StructureClick.h"

#include "viewer/model/Document.h"

namespace fenestra::viewer {

void clickStructure(Document& document, glm::dvec3 world, Qt::KeyboardModifiers modifiers, bool grows) {
  if (!document.voxelAt(world)) return;
  const bool takesAway = modifiers & Qt::ControlModifier;
  if (grows && document.region() && (takesAway || modifiers & Qt::ShiftModifier)) {
    document.addSeed(world, !takesAway);
    return;
  }
  if (!grows && !takesAway) return;
  const Label* label = document.labelAt(world);
  if (label && takesAway)
    document.setFocused(label->value, !document.isFocused(label->value));
  else if (label)
    document.focusOn(label->value);
  else if (grows && !takesAway)
    document.growFrom(world);
}

}  // namespace fenestra::viewer
