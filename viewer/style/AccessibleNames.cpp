#include "viewer/style/AccessibleNames.h"

#include <algorithm>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessibleWidget>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

namespace fenestra::viewer {
namespace {

bool holds(const QLayoutItem* item, const QWidget* widget) {
  if (!item) return false;
  if (item->widget()) return item->widget() == widget || item->widget()->isAncestorOf(widget);
  const QLayout* layout = const_cast<QLayoutItem*>(item)->layout();
  for (int i = 0; layout && i < layout->count(); ++i)
    if (holds(layout->itemAt(i), widget)) return true;
  return false;
}

/// The first widget of a row's field.
const QWidget* firstOf(QLayoutItem* item) {
  while (item && item->layout() && item->layout()->count() > 0) item = item->layout()->itemAt(0);
  return item ? item->widget() : nullptr;
}

QString withoutMnemonic(QString text) {
  // Chinese puts the letter behind the text, in brackets.
  text.remove(QRegularExpression(QStringLiteral("\\(&\\p{L}\\)")));
  text.remove(QLatin1Char('&'));
  return text.trimmed();
}

struct RowLabel {
  QString text;
  bool isFirst = false;  ///< the control is the first of its row
};

RowLabel rowLabelOf(const QWidget& control) {
  for (const QWidget* parent = control.parentWidget(); parent; parent = parent->parentWidget())
    for (QFormLayout* form : parent->findChildren<QFormLayout*>())
      for (int row = 0; row < form->rowCount(); ++row) {
        QLayoutItem* field = form->itemAt(row, QFormLayout::FieldRole);
        QLayoutItem* label = form->itemAt(row, QFormLayout::LabelRole);
        if (!label || !holds(field, &control)) continue;
        const auto* text = qobject_cast<QLabel*>(label->widget());
        const QWidget* first = firstOf(field);
        if (text && !text->text().isEmpty())
          return {withoutMnemonic(text->text()), first == &control || (first && first->isAncestorOf(&control))};
      }
  return {};
}

bool hasLetters(const QString& text) {
  return std::any_of(text.begin(), text.end(), [](QChar each) { return each.isLetter(); });
}

/// A control that the keyboard reaches and that has no text to be called by.
bool wantsName(const QWidget& widget) {
  if (widget.focusPolicy() == Qt::NoFocus || !widget.accessibleName().isEmpty() || widget.isWindow()) return false;
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return !hasLetters(button->text());
  if (qobject_cast<const QAbstractSpinBox*>(widget.parentWidget()) ||
      qobject_cast<const QComboBox*>(widget.parentWidget()))
    return false;  // the field within it
  return !qobject_cast<const QLabel*>(&widget) && !qobject_cast<const QMenu*>(&widget) &&
         !qobject_cast<const QMenuBar*>(&widget);
}

class Namer : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() == QEvent::Show && object->isWidgetType())
      if (auto* widget = static_cast<QWidget*>(object); wantsName(*widget))
        widget->setAccessibleName(controlName(*widget));
    return false;
  }
};

/// Whether a class of the program draws itself: its first base outside of the program is a bare widget.
bool drawsItself(const QWidget& widget) {
  const QMetaObject* type = widget.metaObject();
  if (!QByteArrayView(type->className()).startsWith("fenestra::")) return false;
  while (type && QByteArrayView(type->className()).startsWith("fenestra::")) type = type->superClass();
  return type &&
         (type->className() == QByteArrayView("QWidget") || type->className() == QByteArrayView("QOpenGLWidget"));
}

QAccessibleInterface* graphicOf(const QString&, QObject* object) {
  auto* widget = qobject_cast<QWidget*>(object);
  if (!widget || widget->focusPolicy() == Qt::NoFocus || widget->layout() || !drawsItself(*widget)) return nullptr;
  return new QAccessibleWidget(widget, QAccessible::Graphic, widget->accessibleName());
}

}  // namespace

void nameControls() {
  static const bool once = [] {
    QAccessible::installFactory(graphicOf);
    return true;
  }();
  Q_UNUSED(once)
  qApp->installEventFilter(new Namer(qApp));
}

QString controlName(const QWidget& control) {
  const QString tip = control.toolTip().section(QLatin1Char('\n'), 0, 0);
  if (const RowLabel label = rowLabelOf(control); !label.text.isEmpty())
    return label.isFirst || tip.isEmpty() ? label.text : QStringLiteral("%1: %2").arg(label.text, tip);
  if (!tip.isEmpty()) return tip;
  if (const auto* field = qobject_cast<const QLineEdit*>(&control); field && !field->placeholderText().isEmpty())
    return field->placeholderText();
  for (const QWidget* parent = &control; parent; parent = parent->parentWidget()) {
    if (parent != &control && !parent->accessibleName().isEmpty()) return parent->accessibleName();
    if (const auto* group = qobject_cast<const QGroupBox*>(parent)) return withoutMnemonic(group->title());
    if (qobject_cast<const QDockWidget*>(parent) || parent->isWindow()) return withoutMnemonic(parent->windowTitle());
  }
  return {};
}

}  // namespace fenestra::viewer
