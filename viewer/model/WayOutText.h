#pragma once
// The ways out of errors and warnings (io/base/WayOut.h) in the words of the window: menus, panels and dialogs, where
// the command line names an option.

#include <exception>

#include <QString>

#include "io/base/Reading.h"

namespace fenestra::viewer {

/// A clause without a period; empty for None.
QString windowWords(io::WayOut way);
/// The warning and its way out.
QString windowText(const io::Warning& warning);
/// what(), but for an io::Error with a way out: "PATH: cause; way out". Of any thread.
QString windowText(const std::exception& error);

}  // namespace fenestra::viewer
