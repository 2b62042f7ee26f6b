// Keys that the user changes: conflicts are named, and files keep them.

#include <set>

#include <QAction>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "tests/gui/WindowFixture.h"
#include "viewer/dialogs/KeyBindings.h"
#include "viewer/dialogs/KeysDialog.h"

namespace fenestra::viewer::keysDialogTest {
namespace {

/// A menu bar with three entries: two with keys, one without.
class Keys : public testing::Test {
 protected:
  Keys() {
    QMenu* menu = bar.addMenu(QStringLiteral("&View"));
    reset = menu->addAction(QStringLiteral("&Reset"));
    reset->setShortcut(QKeySequence(QStringLiteral("R")));
    reset->setToolTip(QStringLiteral("Brings the body back (R)"));
    look = menu->addAction(QStringLiteral("&Look"));
    look->setShortcuts({QKeySequence(QStringLiteral("Shift+A")), QKeySequence(QStringLiteral("Num+1"))});
    bare = menu->addAction(QStringLiteral("&Bare…"));
    bare->setObjectName(QStringLiteral("bare"));
    menu->addAction(QStringLiteral("comes and goes"));
  }
  static QKeySequence key(const char* text) { return QKeySequence(QLatin1String(text)); }

  Preferences preferences{Preferences::Mode::Transient};
  QMenuBar bar;
  QAction *reset, *look, *bare;
};

}  // namespace

TEST_F(Keys, AKeyIsTakenFromTheEntryThatHasIt) {
  KeyBindings keys(bar, preferences);
  ASSERT_EQ(keys.entries().size(), 3u);
  EXPECT_EQ(keys.owner(key("R"))->action, reset);
  keys.set(*bare, {key("R")});
  EXPECT_EQ(bare->shortcut(), key("R"));
  EXPECT_TRUE(reset->shortcut().isEmpty());
  EXPECT_EQ(reset->toolTip(), QStringLiteral("Brings the body back"));
  keys.set(*bare, {key("Num+1")});
  EXPECT_EQ(look->shortcuts(), QList<QKeySequence>{key("Shift+A")}) << "its other key stays";
  keys.resetAll();
  EXPECT_EQ(reset->shortcut(), key("R"));
  EXPECT_EQ(reset->toolTip(), QStringLiteral("Brings the body back (R)"));
  EXPECT_EQ(look->shortcuts().size(), 2);
  EXPECT_TRUE(bare->shortcut().isEmpty());
  EXPECT_TRUE(preferences.keys().isEmpty()) << "nothing is stored that is as it comes";
}

TEST_F(Keys, TheViewsOwnKeysCannotBeTaken) {
  KeyBindings keys(bar, preferences);
  for (const char* own : {"Up", "Left", "Home", "End", "PgUp", "PgDown", "Tab", "Space"}) {
    EXPECT_TRUE(KeyBindings::isOfViews(key(own))) << own;
    keys.set(*reset, {key(own)});
    EXPECT_TRUE(reset->shortcut().isEmpty()) << own;
  }
  for (const char* free : {"Ctrl+Up", "Ctrl+PgUp", "F6", "Num+1"}) EXPECT_FALSE(KeyBindings::isOfViews(key(free)));
}

TEST_F(Keys, TheNextStartHasThem) {
  {
    KeyBindings keys(bar, preferences);
    keys.set(*reset, {key("F6")});
    keys.set(*look, {key("R")});
  }
  reset->setShortcut(key("R"));
  look->setShortcuts({key("Shift+A"), key("Num+1")});
  const KeyBindings again(bar, preferences);
  EXPECT_EQ(reset->shortcut(), key("F6"));
  EXPECT_EQ(look->shortcuts(), QList<QKeySequence>{key("R")});
  EXPECT_EQ(again.entries()[0].defaults, QList<QKeySequence>{key("R")});
}

TEST_F(Keys, FilesKeepThemAndDamagedOnesChangeNothing) {
  KeyBindings keys(bar, preferences);
  keys.set(*reset, {key("F6")});
  keys.set(*bare, {key("Ctrl+Shift+B")});
  const QByteArray file = keys.toJson();
  keys.resetAll();
  EXPECT_EQ(keys.fromJson(file), QString());
  EXPECT_EQ(reset->shortcut(), key("F6"));
  EXPECT_EQ(bare->shortcut(), key("Ctrl+Shift+B"));

  const QByteArray head = R"({"format": "fenestra-keys", "version": 1, "keys": [)";
  const std::pair<QByteArray, const char*> damaged[] = {
      {"{", "not JSON"},
      {"[]", "does not hold"},
      {"{}", "does not hold"},
      {R"({"format": "fenestra-keys", "version": 2})", "newer"},
      {head + R"({"action": "R", "keys": ["Hyper+Q+nonsense"]}]})", "is no key"},
      {head + R"({"action": "R", "keys": ["Up"]}]})", "key of the views"},
      {head + R"({"action": "R", "keys": ["F7"]}, {"action": "bare", "keys": ["F7"]}]})", "both"},
      {head + R"({"action": "bare", "keys": ["Shift+A"]}]})", "both"}};
  for (const auto& [text, says] : damaged) {
    SCOPED_TRACE(text.toStdString());
    EXPECT_TRUE(keys.fromJson(text).contains(QLatin1String(says))) << keys.fromJson(text).toStdString();
    EXPECT_EQ(reset->shortcut(), key("F6"));
    EXPECT_EQ(bare->shortcut(), key("Ctrl+Shift+B"));
  }
  EXPECT_EQ(keys.fromJson(head + R"({"action": "of another version", "keys": ["F7"]}]})"), QString());
  EXPECT_EQ(reset->shortcut(), key("R")) << "what a file does not name is as it comes";
}

TEST_F(Keys, TheDialogNamesAConflictAndAsks) {
  KeyBindings keys(bar, preferences);
  KeysDialog dialog(keys);
  dialog.show();
  auto* list = dialog.findChild<QTreeWidget*>(QStringLiteral("keyList"));
  auto* box = dialog.findChild<QKeySequenceEdit*>(QStringLiteral("key"));
  auto* take = dialog.findChild<QPushButton*>(QStringLiteral("takeKey"));
  auto* says = dialog.findChild<QLabel*>(QStringLiteral("keySays"));
  list->setCurrentItem(list->topLevelItem(2));
  const auto type = [&](const char* text) {
    box->setKeySequence(key(text));
    Q_EMIT box->editingFinished();
  };
  type("F6");
  EXPECT_EQ(bare->shortcut(), key("F6")) << "a free key is given at once";
  type("R");
  EXPECT_EQ(bare->shortcut(), key("F6")) << "not before the user says so";
  EXPECT_TRUE(says->text().contains(QStringLiteral("View → Reset"))) << says->text().toStdString();
  ASSERT_TRUE(take->isEnabled());
  take->click();
  EXPECT_EQ(bare->shortcut(), key("R"));
  EXPECT_TRUE(reset->shortcut().isEmpty());
  EXPECT_EQ(list->topLevelItem(0)->text(2), QString());
  type("Home");
  EXPECT_EQ(bare->shortcut(), key("R"));
  EXPECT_TRUE(says->text().contains(QStringLiteral("key of the views")));
  dialog.findChild<QPushButton*>(QStringLiteral("resetKeys"))->click();
  EXPECT_EQ(reset->shortcut(), key("R"));
}

TEST_F(Window, EveryMenuEntryThatStaysHasAnIdOfItsOwn) {
  Preferences preferences(Preferences::Mode::Transient);
  const KeyBindings keys(*qobject_cast<QMainWindow*>(window_.get())->menuBar(), preferences);
  std::set<QString> ids;
  for (const KeyBindings::Entry& each : keys.entries())
    EXPECT_TRUE(ids.insert(each.id).second) << each.id.toStdString();
  EXPECT_GT(ids.size(), 60u);
}

}  // namespace fenestra::viewer::keysDialogTest
