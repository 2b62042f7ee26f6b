// Every text of the window can be translated: under a pseudo-locale, which marks what it translates and makes it a
// third longer, no unmarked text shows and none is cut off.

#include <set>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QProgressBar>
#include <QRegularExpression>
#include <QTabBar>
#include <QTest>
#include <QTimer>

#include "tests/gui/CutTexts.h"
#include "tests/gui/PseudoLocale.h"
#include "tests/gui/WindowFixture.h"

namespace fenestra::viewer::translationTest {
namespace {

/// The words of a text outside of marks that are no data, key or symbol.
QStringList unmarkedWords(QString text) {
  static const QString driver = probeOpenGl().renderer;
  if (!driver.isEmpty()) text.remove(driver);
  static const std::set<QString> data{QStringLiteral("Fenestra"), QStringLiteral("body"),  QStringLiteral("marker"),
                                      QStringLiteral("Ctrl"),     QStringLiteral("Shift"), QStringLiteral("Alt"),
                                      QStringLiteral("Esc"),      QStringLiteral("HU"),    QStringLiteral("Return"),
                                      QStringLiteral("Enter"),    QStringLiteral("Space"), QStringLiteral("Del"),
                                      QStringLiteral("nbsp")};
  QString plain;
  int depth = 0;
  for (const QChar each : text) {
    if (each == opens) ++depth;
    if (depth == 0) plain += each;
    if (each == closes) --depth;
  }
  plain.remove(QRegularExpression(QStringLiteral("<[^>]*>")));
  plain.remove(QLatin1Char('&'));
  QStringList words;
  static const QRegularExpression word(QStringLiteral("\\p{L}{2,}"));
  for (auto found = word.globalMatch(plain); found.hasNext();)
    if (const QString each = found.next().captured(); !data.contains(each)) words << each;
  return words;
}

/// The texts that a widget itself shows, or would show.
QStringList textsOf(const QWidget& widget) {
  QStringList texts{widget.toolTip(), widget.statusTip(), widget.whatsThis()};
  if (widget.isWindow() || qobject_cast<const QDockWidget*>(&widget)) texts << widget.windowTitle();
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts << label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) texts << button->text();
  if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) texts << group->title();
  if (const auto* menu = qobject_cast<const QMenu*>(&widget)) texts << menu->title();
  if (const auto* box = qobject_cast<const QSpinBox*>(&widget))
    texts << box->prefix() << box->suffix() << box->specialValueText();
  if (const auto* box = qobject_cast<const QDoubleSpinBox*>(&widget))
    texts << box->prefix() << box->suffix() << box->specialValueText();
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) texts << line->placeholderText();
  if (const auto* progress = qobject_cast<const QProgressBar*>(&widget)) texts << progress->text();
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
    for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i) << tabs->tabToolTip(i);
  if (const auto* choice = qobject_cast<const QComboBox*>(&widget)) {
    texts << choice->placeholderText();
    for (int i = 0; i < choice->count(); ++i)
      texts << choice->itemText(i) << choice->itemData(i, Qt::ToolTipRole).toString();
  }
  if (const auto* header = qobject_cast<const QHeaderView*>(&widget); header && header->model())
    for (int i = 0; i < header->count(); ++i) texts << header->model()->headerData(i, header->orientation()).toString();
  for (const QAction* action : widget.actions()) texts << action->text() << action->toolTip();
  return texts;
}

/// The untranslated texts of a window and everything in it.
QStringList untranslatedIn(const QWidget& window) {
  QStringList found;
  QList<const QWidget*> widgets{&window};
  for (const QWidget* child : window.findChildren<QWidget*>()) widgets << child;
  for (const QWidget* widget : widgets)
    for (const QString& text : textsOf(*widget))
      if (const QStringList words = unmarkedWords(text); !words.isEmpty())
        found << QStringLiteral("\"%1\" in %2").arg(text, placeOf(widget));
  found.removeDuplicates();
  return found;
}

class PseudoWindow : public Window {
 protected:
  void SetUp() override {
    QCoreApplication::installTranslator(&locale_);
    Window::SetUp();
  }
  void TearDown() override {
    window_.reset();
    QCoreApplication::removeTranslator(&locale_);
  }
  /// Every panel is in front once.
  void forEachPanel(const std::function<void(QDockWidget&)>& use) {
    for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      use(*dock);
    }
  }
  QList<QAction*> entries(const QList<QAction*>& actions) {
    QList<QAction*> all;
    for (QAction* action : actions)
      if (QMenu* menu = action->menu()) {
        Q_EMIT menu->aboutToShow();
        all += entries(menu->actions());
      } else if (!action->isSeparator()) {
        all << action;
      }
    return all;
  }

  PseudoLocale locale_;
};

TEST_F(PseudoWindow, TheWindowShowsNoUntranslatedText) {
  EXPECT_FALSE(unmarkedWords(QStringLiteral("Opening")).isEmpty()) << "the test would notice";
  EXPECT_EQ(untranslatedIn(*window_).join(QLatin1Char('\n')).toStdString(), "");
  document().focusOn(marker);
  document().growFrom(markerCentre);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().growth() != nullptr; }, patience));
  brush().toggle(false);
  forEachPanel([this](QDockWidget& dock) {
    EXPECT_EQ(untranslatedIn(*window_).join(QLatin1Char('\n')).toStdString(), "") << dock.objectName().toStdString();
  });
}

TEST_F(PseudoWindow, TheMenusShowNoUntranslatedText) {
  for (const QAction* entry : entries(window_->menuBar()->actions())) {
    EXPECT_TRUE(unmarkedWords(entry->text()).isEmpty()) << entry->text().toStdString();
    EXPECT_TRUE(unmarkedWords(entry->toolTip()).isEmpty()) << entry->toolTip().toStdString();
  }
  for (const QAction* entry : window_->menuBar()->actions())
    EXPECT_TRUE(unmarkedWords(entry->text()).isEmpty()) << entry->text().toStdString();
}

TEST_F(PseudoWindow, Thorough_TheDialogsShowNoUntranslatedText) {
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  document().focusOn(marker);
  waitUntilDrawn();
  int dialogs = 0;
  for (QAction* entry : entries(window_->menuBar()->actions())) {
    if (!entry->isEnabled() || !entry->text().contains(QChar(0x2026))) continue;  // … opens a dialog
    SCOPED_TRACE(entry->text().toStdString());
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      ++dialogs;
      if (qobject_cast<QFileDialog*>(dialog)) {
        EXPECT_TRUE(unmarkedWords(dialog->windowTitle()).isEmpty()) << dialog->windowTitle().toStdString();
      } else {
        EXPECT_EQ(untranslatedIn(*dialog).join(QLatin1Char('\n')).toStdString(), "");
        EXPECT_EQ(cutIn(*dialog).join(QLatin1Char('\n')).toStdString(), "");
      }
      dialog->reject();
    });
    look.start(50);
    entry->trigger();
    QTest::qWait(80);
    look.stop();
    for (QWidget* window : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QDialog*>(window); dialog && dialog->isVisible()) {
        ++dialogs;
        EXPECT_EQ(untranslatedIn(*dialog).join(QLatin1Char('\n')).toStdString(), "");
        dialog->reject();
      }
  }
  EXPECT_GE(dialogs, 8);
}

TEST_F(PseudoWindow, TheWelcomePageShowsItsTextsTranslatedAndWhole) {
  MainWindow window({.gl = gl_, .remember = false});
  window.resize(1024, 700);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, patience));
  QTest::qWait(20);
  EXPECT_EQ(untranslatedIn(window).join(QLatin1Char('\n')).toStdString(), "");
  EXPECT_EQ(cutIn(window).join(QLatin1Char('\n')).toStdString(), "");
}

TEST_F(PseudoWindow, CornerTextsLeaveTheLettersAlone) {
  window_->resize(1024, 700);
  document().setInverted(true);  // which adds a word
  options().setCrosshair(false);
  waitUntilDrawn();
  for (SliceView* view : views().sliceViews()) {
    const QImage with = view->grab().toImage();
    options().setText(false);
    const QImage without = view->grab().toImage();
    options().setText(true);
    ASSERT_NE(with, without);
    // Half a letter, its halo and a gap on either side of the middle.
    constexpr int half = 10, height = 20;
    for (const int top : {0, view->height() - height}) {
      const QRect letter(view->width() / 2 - half, top, 2 * half, height);
      EXPECT_EQ(with.copy(letter), without.copy(letter)) << view->objectName().toStdString() << ", " << top;
    }
  }
}

TEST_F(PseudoWindow, LongTextsAreNotCut) {
  window_->resize(1600, 1000);
  document().focusOn(marker);
  waitUntilDrawn();
  forEachPanel([this](QDockWidget& dock) {
    QTest::qWait(20);
    EXPECT_EQ(cutIn(*window_).join(QLatin1Char('\n')).toStdString(), "") << dock.objectName().toStdString();
  });
}

}  // namespace
}  // namespace fenestra::viewer::translationTest
