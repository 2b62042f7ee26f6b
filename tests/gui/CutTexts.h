#pragma once
// Where a window's texts are cut off, and where a widget is, in words.

#include <QAbstractButton>
#include <QLabel>
#include <QMetaObject>
#include <QStringList>
#include <QWidget>

namespace fenestra::viewer {

inline QString placeOf(const QObject* object) {
  QString place;
  for (; object; object = object->parent())
    place = QString::fromLatin1(object->metaObject()->className()) + QLatin1Char(' ') + object->objectName() +
            (place.isEmpty() ? QString() : QStringLiteral(" > ") + place);
  return place;
}

/// Labels and buttons in sight that are narrower or lower than their text.
inline QStringList cutIn(const QWidget& window) {
  QStringList found;
  const auto check = [&](const QWidget* widget, const QString& text) {
    if (!widget->isVisible() || widget->visibleRegion().isEmpty() || text.isEmpty()) return;
    const QSize wanted = widget->minimumSizeHint().expandedTo(QSize(0, 0));
    // A panel scrolls its contents vertically alone, so that no widget may be cut off at its sides.
    const bool cutAside = widget->visibleRegion().boundingRect().width() < widget->width();
    if (widget->width() < wanted.width() || widget->height() < wanted.height() || cutAside)
      found << QStringLiteral("\"%1\" %2x%3 of %4x%5 in %6")
                   .arg(text)
                   .arg(widget->width())
                   .arg(widget->height())
                   .arg(wanted.width())
                   .arg(wanted.height())
                   .arg(placeOf(widget));
  };
  for (const QLabel* label : window.findChildren<QLabel*>()) check(label, label->text());
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) check(button, button->text());
  return found;
}

}  // namespace fenestra::viewer
