#pragma once
// A label's name as the user reads it.

#include <QCoreApplication>
#include <QString>

#include "rendering/volume/LabelMap.h"

namespace fenestra::viewer {

/// The label's name, or its value where it has no name.
inline QString nameOf(const Label& label) {
  return label.name.empty() ? QCoreApplication::translate("LabelName", "label %1").arg(label.value)
                            : QString::fromStdString(label.name);
}

}  // namespace fenestra::viewer
