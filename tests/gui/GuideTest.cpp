// The window of the user guide: what F1 opens, the search, the way back, and that what the pages name is in the window.

#include <set>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTabBar>
#include <QTest>
#include <QTextBlock>
#include <QToolButton>

#include "tests/gui/PseudoLocale.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/guide/Guide.h"
#include "viewer/guide/GuideWindow.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer::guideTest {
namespace {

/// Headings of the page that is shown, as they are in links.
QStringList headingsOf(const QTextDocument& page) {
  QStringList headings;
  for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
    if (block.blockFormat().headingLevel() > 0) headings << anchorOf(block.text());
  return headings;
}

class GuideOfWindow : public Window {
 protected:
  void pressF1(QWidget* on) {
    QApplication::setActiveWindow(window_.get());
    on->setFocus();
    QTest::keyClick(on, Qt::Key_F1);
    ASSERT_NE(window_->guide().window(), nullptr);
  }
  GuideWindow& shown() { return *window_->guide().window(); }
  QString page() { return shown().text().source().fileName(); }
  QToolButton* button(const char* text) {
    for (auto* each : shown().findChildren<QToolButton*>())
      if (each->text() == QLatin1String(text)) return each;
    return nullptr;
  }
  QDockWidget* dock(const char* name) { return window_->findChild<QDockWidget*>(QLatin1String(name)); }
};

TEST_F(GuideOfWindow, F1OpensThePageOfWhatHasTheFocus) {
  pressF1(slice(SlicePlane::Axial));
  EXPECT_EQ(page(), QStringLiteral("slices.md"));
  pressF1(volume(1));
  EXPECT_EQ(page(), QStringLiteral("cameras.md"));
  pressF1(dock("focusDock")->findChild<QLineEdit*>());
  EXPECT_EQ(page(), QStringLiteral("focus.md"));
  pressF1(window_->findChild<SliderSpin*>(QStringLiteral("open_width"))->box());
  EXPECT_EQ(page(), QStringLiteral("opening.md"));
}

TEST_F(GuideOfWindow, F1OpensThePageOfTheTabThatWasBroughtToTheFront) {
  slice(SlicePlane::Axial)->setFocus();
  for (const auto& [name, file] :
       {std::pair{"brushDock", "brush.md"}, {"clippingDock", "opening.md"}, {"contextLayerDock", "opening.md"}}) {
    QDockWidget* raised = dock(name);
    raised->raise();
    ASSERT_TRUE(QTest::qWaitFor([raised] { return !raised->visibleRegion().isEmpty(); }, patience));
    QTest::qWait(20);
    window_->guide().open();
    EXPECT_EQ(page().toStdString(), file) << name;
    QApplication::setActiveWindow(window_.get());
  }
  QDockWidget* cameras = dock("camerasDock");
  auto* fold = cameras->findChild<QToolButton*>(QStringLiteral("fold"));
  if (!cameras->widget()->isHidden()) fold->click();
  fold->click();
  window_->guide().open();
  EXPECT_EQ(page().toStdString(), "cameras.md") << "a panel that was folded";
}

TEST_F(GuideOfWindow, EveryDockAndViewHasAPageWithItsHeading) {
  for (QDockWidget* each : window_->findChildren<QDockWidget*>()) {
    each->show();
    each->raise();
    QTest::qWait(20);
    window_->guide().open();
    EXPECT_FALSE(shown().text().toPlainText().isEmpty()) << each->objectName().toStdString();
    if (const QString anchor = shown().text().source().fragment(); !anchor.isEmpty()) {
      EXPECT_TRUE(headingsOf(*shown().text().document()).contains(anchor)) << anchor.toStdString();
    }
    QApplication::setActiveWindow(window_.get());
  }
}

TEST_F(GuideOfWindow, GoesBackAndForward) {
  window_->guide().open(QStringLiteral("focus"));
  EXPECT_FALSE(button("Back")->isEnabled());
  window_->guide().open(QStringLiteral("brush"));
  window_->guide().open(QStringLiteral("keys"));
  EXPECT_TRUE(shown().text().toPlainText().contains(QStringLiteral("Ctrl+Shift+S"))) << "made from the menus";
  QApplication::setActiveWindow(&shown());
  QTest::keyClick(&shown(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(page(), QStringLiteral("brush.md"));
  button("Back")->click();
  EXPECT_EQ(page(), QStringLiteral("focus.md"));
  button("Forward")->click();
  button("Forward")->click();
  EXPECT_EQ(page(), QStringLiteral("keys.md"));
  EXPECT_TRUE(shown().text().toPlainText().contains(QStringLiteral("Ctrl+Shift+S")));
  EXPECT_FALSE(button("Forward")->isEnabled());
}

TEST_F(GuideOfWindow, TheListOfContentsFollowsAndLeads) {
  window_->guide().open(QStringLiteral("brush"));
  auto* list = shown().findChild<QListWidget*>();
  ASSERT_EQ(list->count(), guidePages().size());
  ASSERT_NE(list->currentItem(), nullptr);
  EXPECT_EQ(list->currentItem()->text(), QStringLiteral("The brush"));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(1)).center());
  EXPECT_EQ(page(), QStringLiteral("data.md"));
}

TEST_F(GuideOfWindow, FindsOnThePageAndGoesOnAtItsTop) {
  window_->guide().open(QStringLiteral("focus"));
  auto* search = shown().findChild<QLineEdit*>();
  auto* notFound = [&]() -> QLabel* {
    for (auto* label : shown().findChildren<QLabel*>())
      if (label->text() == QStringLiteral("Not on this page")) return label;
    return nullptr;
  }();
  QApplication::setActiveWindow(&shown());
  QTest::keyClick(&shown(), Qt::Key_F, Qt::ControlModifier);
  QTest::keyClicks(search, QStringLiteral("tolerance"));
  const QTextCursor first = shown().text().textCursor();
  EXPECT_EQ(first.selectedText(), QStringLiteral("tolerance"));
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_GT(shown().text().textCursor().position(), first.position());
  for (int i = 0; i < 50 && shown().text().textCursor().position() != first.position(); ++i)
    QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(shown().text().textCursor().position(), first.position());
  EXPECT_TRUE(notFound->isHidden());
  QTest::keyClicks(search, QStringLiteral("xyz"));
  EXPECT_FALSE(notFound->isHidden());
  search->clear();
  QTest::keyClicks(search, QStringLiteral("a"));
  EXPECT_TRUE(notFound->isHidden());
}

TEST_F(GuideOfWindow, PicturesFitTheText) {
  window_->guide().open(QStringLiteral("first-minute"));
  int pictures = 0;
  for (QTextBlock block = shown().text().document()->begin(); block.isValid(); block = block.next())
    for (auto part = block.begin(); !part.atEnd(); ++part)
      if (const QTextImageFormat format = part.fragment().charFormat().toImageFormat(); format.isValid()) {
        const auto picture =
            shown().text().document()->resource(QTextDocument::ImageResource, format.name()).value<QImage>();
        EXPECT_FALSE(picture.isNull()) << format.name().toStdString();
        EXPECT_LE(picture.deviceIndependentSize().width(), GuideBrowser::textWidth);
        ++pictures;
      }
  EXPECT_GE(pictures, 5);
}

TEST_F(GuideOfWindow, ShowsNoUntranslatedText) {
  PseudoLocale locale;
  QCoreApplication::installTranslator(&locale);
  GuideWindow guide([] { return QString(); });
  QCoreApplication::removeTranslator(&locale);
  QStringList texts{guide.windowTitle()};
  for (const auto* each : guide.findChildren<QToolButton*>())
    if (each->isVisibleTo(&guide)) texts << each->text();
  for (const auto* each : guide.findChildren<QLabel*>()) texts << each->text();
  texts << guide.findChild<QLineEdit*>()->placeholderText() << guide.findChild<QLineEdit*>()->toolTip();
  int translated = 0;
  for (const QString& text : texts)
    if (!text.isEmpty()) {
      EXPECT_TRUE(text.startsWith(opens)) << text.toStdString();
      ++translated;
    }
  EXPECT_GE(translated, 7);
}

/// The words of an entry, as the guide writes it.
QString plain(QString text) {
  return text.remove(QLatin1Char('&')).remove(QStringLiteral("…")).section(QStringLiteral("  "), 0, 0);
}

/// "File → Export → A picture" of every entry.
void addEntries(const QList<QAction*>& actions, const QString& path, QSet<QString>& entries) {
  for (QAction* action : actions) {
    if (action->isSeparator()) continue;
    const QString here = path.isEmpty() ? plain(action->text()) : path + QStringLiteral(" → ") + plain(action->text());
    entries << here;
    if (action->menu()) addEntries(action->menu()->actions(), here, entries);
  }
}

TEST_F(GuideOfWindow, NamesMenusKeysAndPanelsThatThereAre) {
  QSet<QString> entries, keys, panels;
  addEntries(window_->menuBar()->actions(), {}, entries);
  const std::function<void(const QList<QAction*>&)> addKeys = [&](const QList<QAction*>& actions) {
    for (QAction* action : actions) {
      if (action->menu()) addKeys(action->menu()->actions());
      if (!action->shortcut().isEmpty()) keys << action->shortcut().toString(QKeySequence::NativeText);
    }
  };
  addKeys(window_->menuBar()->actions());
  for (const QDockWidget* each : window_->findChildren<QDockWidget*>()) panels << each->windowTitle();
  // Keys of gestures and of lists.
  keys += QSet<QString>{"Ctrl", "Shift", "Alt", "Space", "Delete", "1", "3", "7"};

  int paths = 0, named = 0, docks = 0;
  for (const GuidePage& page : guidePages()) {
    QFile file(QStringLiteral(":/guide/") + page.file);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << page.file.toStdString();
    const QString text = QString::fromUtf8(file.readAll()).replace(QLatin1Char('\n'), QLatin1Char(' '));
    SCOPED_TRACE(page.file.toStdString());
    static const QRegularExpression path(QStringLiteral("\\*([^*]+ → [^*]+)\\*")),
        key(QStringLiteral("`([^`]{1,14})`")), panel(QStringLiteral("panel \\*\\*([^*]+)\\*\\*"));
    for (auto found = path.globalMatch(text); found.hasNext(); ++paths) {
      const QString entry = found.next().captured(1);
      EXPECT_TRUE(entries.contains(entry)) << entry.toStdString();
    }
    for (auto found = panel.globalMatch(text); found.hasNext(); ++docks) {
      const QString name = found.next().captured(1);
      EXPECT_TRUE(panels.contains(name)) << name.toStdString();
    }
    static const QRegularExpression isKey(
        QStringLiteral("^((Ctrl|Shift|Alt)\\+)*(\\S|F\\d+|Esc|Backspace|Space|Delete|Ctrl|Shift|Alt)$"));
    for (auto found = key.globalMatch(text); found.hasNext();) {
      const QString name = found.next().captured(1);
      if (!isKey.match(name).hasMatch()) continue;
      ++named;
      EXPECT_TRUE(keys.contains(name)) << name.toStdString();
    }
  }
  EXPECT_GE(paths, 30);
  EXPECT_GE(named, 40);
  EXPECT_GE(docks, 8);
}

}  // namespace
}  // namespace fenestra::viewer::guideTest
