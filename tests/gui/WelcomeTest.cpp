// The window before anything is open, and the guided tour.

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "io/PhantomFile.h"
#include "io/session/SessionFile.h"
#include "tests/gui/PseudoLocale.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/Sessions.h"
#include "viewer/guide/Guide.h"
#include "viewer/guide/Tour.h"
#include "viewer/guide/WelcomePage.h"

namespace fenestra::viewer::welcomeTest {
namespace {

io::Study torso() {
  const io::OpenedPhantom phantom = io::openPhantom("torso", 96);
  io::Study study;
  study.scene.volume = phantom.volume.volume;
  study.scene.labels = phantom.labels;
  study.scene.look.context.function = markedBall().scene.look.context.function;
  return study;
}

class Welcome : public Window {
 protected:
  void SetUp() override { makeWindow(); }
  void addTorso() {
    window_->addSample(QStringLiteral("Torso"), [](const Look&, const io::Progress&) { return torso(); });
    window_->tour().setAnimated(false);
    cameras().setAnimated(false);
  }
  WelcomePage& page() { return *window_->findChild<WelcomePage*>(); }
  QPushButton* button(const char* text) {
    for (auto* each : window_->findChildren<QPushButton*>())
      if (each->text() == QString::fromUtf8(text)) return each;
    return nullptr;
  }
  QStringList recent() {
    QStringList texts;
    for (const auto* each : page().findChildren<QPushButton*>(QStringLiteral("recent"))) texts << each->text();
    return texts;
  }
  void startTour() {
    addTorso();
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    QTest::mouseClick(page().findChild<QPushButton*>(QStringLiteral("startTour")), Qt::LeftButton);
    ASSERT_TRUE(opened.count() > 0 || opened.wait(patience));
    waitUntilDrawn();
  }
};

TEST_F(Welcome, OffersPhantomsTourAndOwnData) {
  EXPECT_TRUE(page().isVisible());
  EXPECT_FALSE(page().findChild<QPushButton*>(QStringLiteral("startTour"))->isEnabled()) << "no phantom, no tour";
  addTorso();
  EXPECT_TRUE(page().findChild<QPushButton*>(QStringLiteral("startTour"))->isEnabled());
  ASSERT_NE(button("Open a folder…"), nullptr);
  ASSERT_NE(button("Open a file…"), nullptr);
  const auto* hardware = page().findChild<QLabel*>(QStringLiteral("hardware"));
  EXPECT_TRUE(hardware->text().contains(gl_.renderer)) << hardware->text().toStdString();
  EXPECT_EQ(hardware->text().contains(QStringLiteral("No graphics card")), gl_.software);

  QSignalSpy opened(window_.get(), &MainWindow::opened);
  QTest::mouseClick(button("Torso"), Qt::LeftButton);
  ASSERT_TRUE(opened.count() > 0 || opened.wait(patience));
  EXPECT_FALSE(page().isVisible());
  EXPECT_FALSE(window_->tour().step()) << "a phantom that is opened for itself starts no tour";
}

TEST_F(Welcome, ComesBackWhenReadingFails) {
  window_->open([](const io::Progress&) -> io::Study { throw io::Error("study", "is damaged", "choose another"); });
  EXPECT_TRUE(page().findChildren<QPushButton*>().front()->visibleRegion().isEmpty()) << "while it is read";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_->notices().texts().isEmpty(); }, patience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return button("Open a file…")->isVisible(); }, patience));
}

TEST_F(Welcome, SaysWhatIsMissingWithoutOpenGl) {
  const GlSupport none{.problem = QStringLiteral("No OpenGL context can be made on this display.")};
  MainWindow window({.gl = none, .remember = false});
  const auto* hardware = window.findChild<QLabel*>(QStringLiteral("hardware"));
  EXPECT_TRUE(hardware->text().contains(none.problem)) << hardware->text().toStdString();
}

TEST_F(Welcome, LinksTheGuide) {
  Q_EMIT page().findChild<QLabel*>(QStringLiteral("guide"))->linkActivated(QStringLiteral("guide"));
  EXPECT_NE(window_->guide().window(), nullptr);
}

/// Preferences that are stored, in a folder of the test's own.
class WelcomeBack : public Welcome {
 protected:
  void SetUp() override {
    useScratchSettings();
    const std::filesystem::path folder = tests::scratchFolder();
    Preferences preferences;
    preferences.addRecent(folder / "Vermeer" / "scan.nii");
    preferences.addRecent(folder / "Vermeer" / "work.fenestra");
    window_ = std::make_unique<MainWindow>(MainWindow::Setup{.gl = gl_, .remember = true});
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), patience));
  }
  void TearDown() override {
    window_.reset();
    QSettings().clear();
  }
};

TEST_F(WelcomeBack, ListsSessionsAndStudiesLatestFirst) {
  ASSERT_EQ(recent().size(), 2);
  EXPECT_TRUE(recent()[0].startsWith(QStringLiteral("work.fenestra  ·  session"))) << recent()[0].toStdString();
  EXPECT_TRUE(recent()[1].startsWith(QStringLiteral("scan.nii  ·  study"))) << recent()[1].toStdString();
  QTest::mouseClick(page().findChildren<QPushButton*>(QStringLiteral("recent"))[1], Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_->notices().texts().isEmpty(); }, patience));
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("scan.nii"))) << "it was opened, and is gone";
}

TEST_F(WelcomeBack, NamesNothingWhileThePatientIsHidden) {
  window_->workspace().preferences.set(Preference::HidesPatient, 1);
  ASSERT_FALSE(recent().isEmpty());
  for (const QString& text : recent()) {
    EXPECT_FALSE(text.contains(QStringLiteral("Vermeer"))) << text.toStdString();
    EXPECT_FALSE(text.contains(QStringLiteral("scan"))) << text.toStdString();
  }
}

using GuidedTour = Welcome;

TEST_F(GuidedTour, DoesEachStepWithTheMouse) {
  startTour();
  Tour& tour = window_->tour();
  ASSERT_EQ(tour.step(), 0);
  const auto press = [&](const char* text) {
    QTest::mouseClick(button(text), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tour.isActing(); }, patience));
    waitUntilDrawn();
  };
  const QSize views = window_->views().size();
  press("Next");
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{20}})) << "the left kidney";
  const Camera before = cameras().camera(0);
  press("Next");
  EXPECT_NE(cameras().camera(0), before);
  const double width = document().look().cutaway.openWidth;
  press("Next");
  EXPECT_GT(document().look().cutaway.openWidth, width);
  press("Next");
  EXPECT_EQ(document().look().strokes.size(), 1u);
  EXPECT_FALSE(brush().isActive());
  press("Next");
  EXPECT_EQ(tour.step(), tour.steps() - 1);
  EXPECT_EQ(window_->views().size(), views) << "the bar keeps its height";
  press("Done");
  EXPECT_FALSE(tour.step());
  EXPECT_FALSE(tour.isVisible());
}

TEST_F(GuidedTour, ItsTextsFitIntoASmallWindow) {
  startTour();
  window_->resize(960, 600);
  waitUntilDrawn();
  Tour& tour = window_->tour();
  for (int step = 0; step < tour.steps(); ++step, tour.next()) {
    waitUntilDrawn();
    for (const auto* label : tour.findChildren<QLabel*>()) {
      EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
    }
  }
}

TEST_F(GuidedTour, MovesAMouseThatIsSeen) {
  startTour();
  window_->tour().setAnimated(true);
  window_->tour().next();
  EXPECT_TRUE(window_->tour().isActing());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_->tour().isActing(); }, patience));
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{20}}));
}

TEST_F(GuidedTour, EndsWithAnotherStudyAndByItsButton) {
  startTour();
  window_->tour().setAnimated(true);
  window_->tour().next();
  window_->tour().end();
  EXPECT_FALSE(window_->tour().isActing());
  EXPECT_FALSE(window_->tour().isVisible());
  window_->tour().setAnimated(false);
  open(markedBall());
  EXPECT_FALSE(window_->tour().step());
}

TEST_F(GuidedTour, DoesNotBeginWhenTheUserKeepsTheOpenStudy) {
  addTorso();
  open(markedBall());
  document().setRole(marker, LabelRole::Hidden);
  window_->sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Cancel; };
  window_->tour().start();
  QTest::qWait(50);
  EXPECT_FALSE(window_->tour().step());
  open(markedBall());
  EXPECT_FALSE(window_->tour().step()) << "nor when the next study is opened";
}

TEST_F(GuidedTour, ShowsNoUntranslatedText) {
  PseudoLocale locale;
  QCoreApplication::installTranslator(&locale);
  Tour& tour = window_->tour();
  startTour();
  int texts = 0;
  for (int step = 0; step < tour.steps(); ++step, tour.next()) {
    for (const auto* label : tour.findChildren<QLabel*>())
      if (!label->text().isEmpty()) {
        EXPECT_TRUE(label->text().startsWith(opens)) << label->text().toStdString();
        ++texts;
      }
  }
  QCoreApplication::removeTranslator(&locale);
  EXPECT_GE(texts, 12);
}

}  // namespace
}  // namespace fenestra::viewer::welcomeTest
