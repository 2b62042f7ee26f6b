#pragma once
// The window's explanations.

#include <optional>

#include "rendering/gpu/Schedule.h"
#include "viewer/views/GlSupport.h"

class QWidget;

namespace fenestra::viewer {

/// Lists what keys and mouse do.
void showKeys(QWidget* parent);
void showAbout(const GlSupport& gl, std::optional<Schedule> schedule, QWidget* parent);

}  // namespace fenestra::viewer
