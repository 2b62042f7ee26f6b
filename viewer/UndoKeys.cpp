#include "viewer/UndoKeys.h"

#include <QAbstractSpinBox>
#include <QCoreApplication>
#include <QKeyEvent>

namespace fenestra::viewer {

UndoKeys::UndoKeys(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
  const bool inBox =
      qobject_cast<QAbstractSpinBox*>(watched) || (watched && qobject_cast<QAbstractSpinBox*>(watched->parent()));
  if (event->type() != QEvent::ShortcutOverride || !inBox) return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo))
    return QObject::eventFilter(watched, event);
  event->ignore();  // the box does not claim the key, so the menu gets it
  return true;
}

}  // namespace fenestra::viewer
