#pragma once
// The window's questions and explanations.

#include <optional>
#include <string>

#include "viewer/model/Document.h"
#include "viewer/views/GlSupport.h"

class QWidget;

namespace fenestra::viewer {

/// Lets the user pick another series of the study; its id, or empty when the shown one stays.
std::optional<std::string> askForSeries(const Study& study, QWidget* parent);
/// What keys and mouse do.
void showKeys(QWidget* parent);
void showAbout(const GlSupport& gl, QWidget* parent);

}  // namespace fenestra::viewer
