#pragma once
// What a click on a structure does to the focus.

#include <Qt>

#include <glm/glm.hpp>

namespace fenestra::viewer {

class Document;

/// A click at a world position. Plain: the label there becomes the focus; where there is none, a region grows if
/// `grows`. While a region is in the focus, Shift adds the place to it and Ctrl takes it away. Otherwise, with Ctrl the
/// label joins or leaves the focus.
void clickStructure(Document& document, glm::dvec3 world, Qt::KeyboardModifiers modifiers, bool grows);

}  // namespace fenestra::viewer
