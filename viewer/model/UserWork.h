#pragma once
// What counts as work that a user would miss.

#include <QString>

#include "rendering/settings/Focus.h"

namespace fenestra::viewer {

/// Whether a step of the history has to be done again by hand. A step that moves cameras has not, and one that chose
/// the focus has not while the present focus is what a click makes: none, one structure, one seed.
bool isWork(const QString& step, const Focus& present);

}  // namespace fenestra::viewer
