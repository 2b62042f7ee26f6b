// Closing a study: nothing of it stays, and the next one opens as after a start.

#include <QAction>
#include <QDialog>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "viewer/dialogs/WindowLevelDialog.h"
#include "viewer/files/Sessions.h"
#include "viewer/guide/WelcomePage.h"

namespace fenestra::viewer::closeStudyTest {
namespace {

class CloseStudy : public Window {
 protected:
  QAction* entry(const char* text) {
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->text().remove(QLatin1Char('&')) == QLatin1String(text)) return action;
    return nullptr;
  }
  bool isWelcoming() { return window_->findChild<WelcomePage*>()->isVisible(); }
};

}  // namespace

TEST_F(CloseStudy, LetsGoOfVoxelsAndLabels) {
  document().focusOn(marker);
  waitUntilDrawn();
  const std::weak_ptr<const Volume> volume = document().scene().volume;
  const std::weak_ptr<const LabelMap> labels = document().scene().labels;
  window_->sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
  entry("Close study")->trigger();
  EXPECT_TRUE(isWelcoming());
  EXPECT_FALSE(document().hasVolume());
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Fenestra"));
  // Work in the background that was asked to stop ends soon.
  EXPECT_TRUE(QTest::qWaitFor([&] { return volume.expired() && labels.expired(); }, patience))
      << volume.use_count() << " and " << labels.use_count() << " still hold them";
  for (const char* text : {"Close study", "Reset view", "Save session", "Copy picture"}) {
    ASSERT_TRUE(entry(text)) << text;
    EXPECT_FALSE(entry(text)->isEnabled()) << text;
  }
  open(markedBall());
  EXPECT_FALSE(isWelcoming());
  EXPECT_TRUE(std::holds_alternative<std::monostate>(document().focus()));
  document().focusOn(marker);
  waitUntilDrawn();
  EXPECT_TRUE(green(this->volume(0))) << "it is drawn as before";
  EXPECT_TRUE(entry("Close study")->isEnabled());
}

TEST_F(CloseStudy, AsksForUnsavedWork) {
  document().setMeasures({{MeasureKind::Distance, {{0, 0, 1}, {9, 0, 1}}, {1, 0, 0}, {0, 1, 0}}},
                         QStringLiteral("Distance"));
  int asked = 0;
  auto answer = SessionQuestions::Answer::Cancel;
  window_->sessions().questions().saveChanges = [&](const QStringList&) {
    ++asked;
    return answer;
  };
  entry("Close study")->trigger();
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(document().hasVolume()) << "cancelled";
  EXPECT_EQ(document().measures().size(), 1u);
  answer = SessionQuestions::Answer::Discard;
  entry("Close study")->trigger();
  EXPECT_EQ(asked, 2);
  EXPECT_FALSE(document().hasVolume());
  EXPECT_TRUE(document().measures().empty());
}

TEST_F(CloseStudy, LeavesNothingToClickOn) {
  document().growFrom(markerCentre);
  window_->sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
  entry("Close study")->trigger();
  EXPECT_FALSE(document().hasVolume());
  // What a user may still reach: entries that are enabled and ask for no file, and the window's size.
  for (const char* text : {"Invert", "Crosshair", "Label overlay", "Link the 3-D views", "Next view", "Slices alone",
                           "Five views", "All views", "Light theme", "Light theme"})
    if (QAction* action = entry(text); action && action->isEnabled()) action->trigger();
  window_->resize(1100, 750);
  QTest::qWait(300);
  EXPECT_TRUE(isWelcoming());
  EXPECT_FALSE(document().awaitsGrowth());
  open(markedBall());
  EXPECT_FALSE(isWelcoming());
}

}  // namespace fenestra::viewer::closeStudyTest
