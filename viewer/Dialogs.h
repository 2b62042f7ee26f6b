#pragma once
// The window's questions and explanations.

#include <optional>
#include <string>

#include "rendering/gpu/Schedule.h"
#include "viewer/model/Document.h"
#include "viewer/views/GlSupport.h"

class QWidget;

namespace fenestra::viewer {

/// Lets the user pick another series of the study. Returns its id, or nothing when the user keeps the shown one.
std::optional<std::string> askForSeries(const Study& study, QWidget* parent);
/// Lists what keys and mouse do.
void showKeys(QWidget* parent);
void showAbout(const GlSupport& gl, std::optional<Schedule> schedule, QWidget* parent);

}  // namespace fenestra::viewer
