#pragma once
// What a label is called where the user reads it.

#include <QCoreApplication>
#include <QString>

#include "rendering/scene/LabelMap.h"

namespace fenestra::viewer {

/// Its own name, or its value where it has none.
inline QString nameOf(const Label& label) {
  return label.name.empty() ? QCoreApplication::translate("LabelName", "label %1").arg(label.value)
                            : QString::fromStdString(label.name);
}

}  // namespace fenestra::viewer
