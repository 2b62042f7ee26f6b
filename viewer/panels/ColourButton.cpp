#include "viewer/panels/ColourButton.h"

#include <QColorDialog>
#include <QPixmap>

#include "viewer/style/Overlay.h"

namespace fenestra::viewer {

ColourButton::ColourButton(const QString& title, QWidget* parent) : QToolButton(parent) {
  setToolTip(title);
  setIconSize({32, 14});
  connect(this, &QToolButton::clicked, this, [this, title] {
    const QColor chosen = QColorDialog::getColor(toColour(colour_), this, title);
    if (chosen.isValid()) Q_EMIT edited(fromColour(chosen));
  });
}

void ColourButton::setColour(glm::dvec3 colour) {
  colour_ = colour;
  QPixmap swatch(iconSize());
  swatch.fill(toColour(colour));
  setIcon(swatch);
}

}  // namespace fenestra::viewer
