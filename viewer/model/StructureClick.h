#pragma once
// What a click on a structure does to the focus.

#include <Qt>

#include <glm/glm.hpp>

namespace fenestra::viewer {

class Document;

/// A click at a world position, in any view. With `grows`, a plain one makes the label there the focus, and where there
/// is none, a region grows; while a region is in the focus, Shift adds the place to it and Ctrl takes it away. In all
/// other cases the label joins or leaves the focus with Ctrl, and nothing happens without.
void clickStructure(Document& document, glm::dvec3 world, Qt::KeyboardModifiers modifiers, bool grows);

}  // namespace fenestra::viewer
