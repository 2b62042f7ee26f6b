#include "viewer/dialogs/KeyBindings.h"

#include <algorithm>
#include <map>

#include <QAction>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMenu>
#include <QMenuBar>

#include "viewer/model/Preferences.h"

namespace fenestra::viewer {
namespace {

const QLatin1String keysFormat("fenestra-keys");
constexpr int keysVersion = 1;

QString portable(const QKeySequence& keys) { return keys.toString(QKeySequence::PortableText); }

}  // namespace

KeyBindings::KeyBindings(const QMenuBar& menus, Preferences& preferences, QObject* parent)
    : QObject(parent), preferences_(preferences) {
  add(menus.actions(), {});
  if (const QByteArray stored = preferences_.keys(); !stored.isEmpty()) fromJson(stored);
}

void KeyBindings::add(const QList<QAction*>& actions, const QString& menu) {
  for (QAction* action : actions) {
    if (action->menu()) {
      add(action->menu()->actions(), menu.isEmpty() ? nameOf(*action) : menu);
      continue;
    }
    const QString id = action->objectName().isEmpty() ? portable(action->shortcut()) : action->objectName();
    if (!action->isSeparator() && !id.isEmpty()) entries_.push_back({action, id, menu, action->shortcuts()});
  }
}

QString KeyBindings::nameOf(const QAction& action) {
  return QString(action.text()).remove(QLatin1Char('&')).remove(QStringLiteral("…"));
}

const KeyBindings::Entry* KeyBindings::owner(const QKeySequence& keys) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&keys](const Entry& each) { return each.action->shortcuts().contains(keys); });
  return found == entries_.end() ? nullptr : &*found;
}

const KeyBindings::Entry* KeyBindings::entryOf(const QAction& action) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&action](const Entry& each) { return each.action == &action; });
  return found == entries_.end() ? nullptr : &*found;
}

bool KeyBindings::isOfViews(const QKeySequence& keys) {
  if (keys.isEmpty()) return false;
  const QKeyCombination first = keys[0];
  switch (first.key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      return (first.keyboardModifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      return first.keyboardModifiers() == Qt::NoModifier || first.keyboardModifiers() == Qt::ShiftModifier;
    default:
      return false;
  }
}

void KeyBindings::give(QAction& action, const QList<QKeySequence>& keys) {
  // The tool tip ends with the first key in brackets where there is one.
  const auto ending = [&action] {
    return QStringLiteral(" (%1)").arg(action.shortcut().toString(QKeySequence::NativeText));
  };
  QString tip = action.toolTip();
  if (!action.shortcut().isEmpty() && tip.endsWith(ending())) tip.chop(ending().size());
  action.setShortcuts(keys);
  action.setToolTip(action.shortcut().isEmpty() ? tip : tip + ending());
}

void KeyBindings::set(const QAction& action, const QList<QKeySequence>& keys) {
  const Entry* entry = entryOf(action);
  if (!entry) return;
  QList<QKeySequence> own;
  for (const QKeySequence& each : keys) {
    if (each.isEmpty() || isOfViews(each) || own.contains(each)) continue;
    own << each;
    const Entry* before = owner(each);
    if (!before || before == entry) continue;
    QList<QKeySequence> rest = before->action->shortcuts();
    rest.removeAll(each);
    give(*before->action, rest);
  }
  give(*entry->action, own);
  store();
}

void KeyBindings::reset(const QAction& action) {
  if (const Entry* entry = entryOf(action)) set(action, entry->defaults);
}

void KeyBindings::resetAll() {
  for (const Entry& each : entries_) give(*each.action, each.defaults);
  store();
}

QByteArray KeyBindings::json(bool onlyChanged) const {
  QJsonArray list;
  for (const Entry& each : entries_) {
    if (onlyChanged && each.action->shortcuts() == each.defaults) continue;
    QJsonArray keys;
    for (const QKeySequence& key : each.action->shortcuts()) keys.append(portable(key));
    list.append(QJsonObject{{QStringLiteral("action"), each.id},
                            {QStringLiteral("name"), nameOf(*each.action)},
                            {QStringLiteral("keys"), keys}});
  }
  if (onlyChanged && list.isEmpty()) return {};
  return QJsonDocument(QJsonObject{{QStringLiteral("format"), keysFormat},
                                   {QStringLiteral("version"), keysVersion},
                                   {QStringLiteral("keys"), list}})
      .toJson();
}

QByteArray KeyBindings::toJson() const { return json(false); }

void KeyBindings::store() {
  preferences_.setKeys(json(true));
  Q_EMIT changed();
}

QString KeyBindings::fromJson(const QByteArray& text) {
  QJsonParseError problem;
  const QJsonObject whole = QJsonDocument::fromJson(text, &problem).object();
  if (problem.error != QJsonParseError::NoError)
    return tr("It is not JSON, from character %1 on: %2.").arg(problem.offset).arg(problem.errorString());
  if (whole.value(QLatin1String("format")) != keysFormat)
    return tr("It does not hold Fenestra's keys: choose a file that Export in this dialog wrote.");
  if (whole.value(QLatin1String("version")).toInt() != keysVersion)
    return tr("It was written by a newer version of Fenestra.");
  std::map<QString, QList<QKeySequence>> wanted;
  for (const Entry& each : entries_) wanted[each.id] = each.defaults;
  for (const QJsonValue& value : whole.value(QLatin1String("keys")).toArray()) {
    const QString id = value.toObject().value(QLatin1String("action")).toString();
    if (!wanted.contains(id)) continue;
    wanted[id].clear();
    for (const QJsonValue& key : value.toObject().value(QLatin1String("keys")).toArray()) {
      const auto keys = QKeySequence::fromString(key.toString(), QKeySequence::PortableText);
      if (keys.isEmpty() || keys[0].key() == Qt::Key_unknown)
        return tr("\"%1\", of \"%2\", is no key.").arg(key.toString(), id);
      if (isOfViews(keys)) return tr("%1, of \"%2\", is a key of the views.").arg(key.toString(), id);
      wanted[id] << keys;
    }
  }
  std::map<QString, QString> owners;
  for (const auto& [id, keys] : wanted)
    for (const QKeySequence& key : keys)
      if (const auto [before, isNew] = owners.emplace(portable(key), id); !isNew && before->second != id)
        return tr("%1 is the key of both \"%2\" and \"%3\".").arg(portable(key), before->second, id);
  for (const Entry& each : entries_) give(*each.action, wanted[each.id]);
  store();
  return {};
}

}  // namespace fenestra::viewer
