#pragma once
// The keys of the window's actions: as they come, or as the user has changed them.

#include <optional>
#include <vector>

#include <QByteArray>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

class QAction;
class QMenuBar;

namespace fenestra::viewer {

class Preferences;

class KeyBindings : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    QAction* action;
    QString id;    ///< of the action in files, the same in all languages: its object's name, or else its default keys
    QString menu;  ///< the menu that it is in, as shown
    QList<QKeySequence> defaults;
  };

  /// Takes the actions that `menus` hold now, with their keys as the defaults, and gives them the keys that the user
  /// has chosen. Entries that come and go, such as those of recent files, have no id and are left out. `preferences`
  /// and `menus` outlive this.
  KeyBindings(const QMenuBar& menus, Preferences& preferences, QObject* parent = nullptr);

  const std::vector<Entry>& entries() const { return entries_; }
  static QString nameOf(const QAction& action);  ///< its text without mnemonics and dots

  /// The entry that has this key; null: none.
  const Entry* owner(const QKeySequence& keys) const;
  /// Whether the views take this key themselves, such as arrows, so that no action can have it.
  static bool isOfViews(const QKeySequence& keys);
  /// Gives an action these keys, and takes them from those that have them. Keys of the views are left out.
  void set(const QAction& action, const QList<QKeySequence>& keys);
  void reset(const QAction& action);
  void resetAll();

  /// All actions with their keys, as JSON: { "format": "fenestra-keys", "version": 1,
  /// "keys": [ { "action": id, "name": text, "keys": [ "Ctrl+R" ] } ] }.
  QByteArray toJson() const;
  /// Takes keys over from such a file; actions that it does not name get their defaults, and names of actions that are
  /// not here are passed over. Returns what is wrong, upon which nothing is changed; empty: nothing.
  QString fromJson(const QByteArray& json);

 Q_SIGNALS:
  void changed();

 private:
  void add(const QList<QAction*>& actions, const QString& menu);
  const Entry* entryOf(const QAction& action) const;
  static void give(QAction& action, const QList<QKeySequence>& keys);
  QByteArray json(bool onlyChanged) const;
  void store();

  Preferences& preferences_;
  std::vector<Entry> entries_;
};

}  // namespace fenestra::viewer
