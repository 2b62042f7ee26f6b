// The window in its languages, on the screen of a small laptop, and what it tells assistive programs.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "tests/gui/CutTexts.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/dialogs/SettingsDialog.h"
#include "viewer/model/Languages.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer::languageWindowTest {
namespace {

class LanguageWindow : public Window, public testing::WithParamInterface<Language> {
 protected:
  void SetUp() override {
    speak(GetParam().code);
    Window::SetUp();
    if (HasFatalFailure()) return;
    window_->resize(1366, 768);
    document().focusOn(marker);
    waitUntilDrawn();
  }
  void TearDown() override {
    window_.reset();
    speak("en");
  }
};

TEST_P(LanguageWindow, Thorough_NoTextIsCutOnASmallLaptop) {
  EXPECT_EQ(window_->size(), QSize(1366, 768)) << "the window is wider than the screen";
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QTest::qWait(20);
    EXPECT_EQ(cutIn(*window_).join(QLatin1Char('\n')).toStdString(), "") << dock->objectName().toStdString();
  }
  SettingsDialog settings(window_->workspace().preferences, window_.get());
  settings.show();
  QTest::qWait(20);
  EXPECT_EQ(cutIn(settings).join(QLatin1Char('\n')).toStdString(), "");
}

/// The letters behind & of a menu's entries, each with the entry that it belongs to; `found` gets those that clash.
void checkMnemonics(const QList<QAction*>& entries, QStringList& found) {
  std::map<QString, QString> taken;
  static const QRegularExpression letter(QStringLiteral("&([^&\\s])"));
  for (QAction* entry : entries) {
    if (QMenu* menu = entry->menu()) {
      Q_EMIT menu->aboutToShow();
      checkMnemonics(menu->actions(), found);
    }
    const auto match = letter.match(entry->text());
    if (!match.hasMatch() || !entry->isVisible()) continue;
    const auto [at, isNew] = taken.try_emplace(match.captured(1).toUpper(), entry->text());
    if (!isNew) found << QStringLiteral("\"%1\" and \"%2\"").arg(at->second, entry->text());
  }
}

TEST_P(LanguageWindow, Thorough_EachMnemonicOfAMenuIsForOneEntry) {
  QStringList found;
  checkMnemonics(window_->menuBar()->actions(), found);
  EXPECT_EQ(found.join(QLatin1Char('\n')).toStdString(), "");
}

INSTANTIATE_TEST_SUITE_P(All, LanguageWindow, testing::ValuesIn(languages.begin() + 1, languages.end()),
                         [](const auto& info) { return std::string(info.param.code); });

class Accessible : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    if (HasFatalFailure()) return;
    document().focusOn(marker);
    waitUntilDrawn();
  }
};

/// What the keyboard reaches. Fields within such controls do not count, nor the bar without tabs that Qt keeps beyond
/// the window's edge for docks that are hidden.
bool isControl(const QWidget& widget) {
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget); tabs && tabs->count() == 0) return false;
  return widget.isVisible() && widget.focusPolicy() != Qt::NoFocus && !widget.focusProxy() && !widget.isWindow() &&
         !qobject_cast<const QAbstractSpinBox*>(widget.parentWidget()) &&
         !qobject_cast<const QComboBox*>(widget.parentWidget());
}

TEST_F(Accessible, EveryControlHasANameAndARole) {
  int controls = 0;
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QTest::qWait(20);
    for (QWidget* widget : window_->findChildren<QWidget*>()) {
      if (!isControl(*widget)) continue;
      ++controls;
      QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
      ASSERT_TRUE(told) << placeOf(widget).toStdString();
      EXPECT_FALSE(told->text(QAccessible::Name).isEmpty()) << placeOf(widget).toStdString();
      const QAccessible::Role role = told->role();
      EXPECT_TRUE(role != QAccessible::NoRole && role != QAccessible::Client) << placeOf(widget).toStdString();
    }
  }
  EXPECT_GT(controls, 100);
}

TEST_F(Accessible, ControlsAreCalledAsTheirRows) {
  const auto nameOf = [this](const char* row, const char* type) {
    for (const QWidget* child : window_->findChild<QWidget*>(QLatin1String(row))->findChildren<QWidget*>())
      if (child->inherits(type)) return child->accessibleName().toStdString();
    return std::string("none");
  };
  EXPECT_EQ(nameOf("open_width", "QSlider"), "Opening");
  EXPECT_EQ(nameOf("open_width", "QDoubleSpinBox"), "Opening");
  EXPECT_EQ(nameOf("border_width", "QSlider"), "Border");
  EXPECT_EQ(slice(SlicePlane::Axial)->accessibleName(), "Axial");
  EXPECT_EQ(QAccessible::queryAccessibleInterface(volume(0))->role(), QAccessible::Graphic);
}

/// Relative luminance and contrast of WCAG 2.1.
double luminance(const QColor& colour) {
  const auto linear = [](double part) {
    return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}
double contrast(const QColor& a, const QColor& b) {
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

TEST(Contrast, TextsStandOutInBothThemes) {
  constexpr double least = 4.5;  // WCAG 2.1, AA; texts of what is switched off are exempt
  EXPECT_NEAR(contrast(Qt::black, Qt::white), 21.0, 1e-9);
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    for (const TextColours& pair : textColours(theme))
      EXPECT_GE(contrast(pair.text, pair.ground), least) << pair.where << (theme == Theme::Dark ? ", dark" : ", light");
    applyStyle(*qApp, theme);
    const QPalette palette = qApp->palette();
    for (const auto& [text, ground] : {std::pair{QPalette::WindowText, QPalette::Window},
                                       {QPalette::Text, QPalette::Base},
                                       {QPalette::Text, QPalette::AlternateBase},
                                       {QPalette::PlaceholderText, QPalette::Base},
                                       {QPalette::ButtonText, QPalette::Button},
                                       {QPalette::ToolTipText, QPalette::ToolTipBase},
                                       {QPalette::HighlightedText, QPalette::Highlight},
                                       {QPalette::Link, QPalette::Window}})
      EXPECT_GE(contrast(palette.color(text), palette.color(ground)), least) << text << " on " << ground;
  }
  applyStyle(*qApp, Theme::Dark);
}

TEST(Contrast, TheCrossOfANoticeStandsOutInBothThemes) {
  constexpr double least = 3.0;  // WCAG 2.1, AA, for what is no text
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    applyStyle(*qApp, theme);
    NoticeBar bar;
    bar.add(NoticeBar::Kind::Warning, NoticeBar::Subject::Study, QStringLiteral("w"));
    bar.resize(300, bar.sizeHint().height());
    bar.show();
    const QImage cross = bar.findChild<QToolButton*>()->grab().toImage();
    double greatest = 1.0;
    for (int y = 0; y < cross.height(); ++y)
      for (int x = 0; x < cross.width(); ++x)
        greatest = std::max(greatest, contrast(cross.pixelColor(x, y), cross.pixelColor(1, 1)));
    EXPECT_GE(greatest, least) << (theme == Theme::Dark ? "dark" : "light");
  }
  applyStyle(*qApp, Theme::Dark);
}

}  // namespace
}  // namespace fenestra::viewer::languageWindowTest
