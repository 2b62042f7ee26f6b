// Pictures of the whole window to look at: sizes, themes and a long language, at the display's pixel ratio.
//
//   FENESTRA_SCREENSHOTS=FOLDER QT_SCALE_FACTOR=1.5 xvfb-run -a -s "-screen 0 4000x2600x24" gui_window_tests
//   with --gtest_filter=Screenshots.*

#include <QApplication>
#include <QDockWidget>
#include <QSignalSpy>
#include <QTest>

#include "io/study/ReadStudy.h"
#include "tests/gui/PseudoLocale.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/dialogs/SpacingDialog.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer::screenshotsTest {
namespace {

const QSize sizes[] = {{1024, 700}, {1366, 768}, {1600, 1000}, {1920, 1080}, {1920, 1200}};

class Screenshots : public Window {
 protected:
  void SetUp() override {
    folder_ = qEnvironmentVariable("FENESTRA_SCREENSHOTS");
    if (folder_.isEmpty()) GTEST_SKIP() << "FENESTRA_SCREENSHOTS names no folder";
  }
  void shoot(const QString& name) {
    Window::SetUp();
    document().focusOn(marker);
    for (const QSize& size : sizes) {
      window_->resize(size);
      waitUntilDrawn();
      save(window_->picture(MainWindow::Patient::Shown), name);
    }
    window_.reset();
  }
  void save(const QImage& picture, const QString& name) {
    const qreal ratio = window_->devicePixelRatioF();
    ASSERT_TRUE(picture.save(QStringLiteral("%1/%2-%3x%4-at-%5.png")
                                 .arg(folder_, name)
                                 .arg(qRound(picture.width() / ratio))
                                 .arg(qRound(picture.height() / ratio))
                                 .arg(ratio)));
  }

  QString folder_;
};

TEST_F(Screenshots, Dark) { shoot(QStringLiteral("dark")); }

TEST_F(Screenshots, Light) {
  applyStyle(*qApp, Theme::Light);
  shoot(QStringLiteral("light"));
  applyStyle(*qApp, Theme::Dark);
}

TEST_F(Screenshots, LongLanguage) {
  PseudoLocale locale;
  QCoreApplication::installTranslator(&locale);
  shoot(QStringLiteral("long"));
  QCoreApplication::removeTranslator(&locale);
}

/// A study with a notice opened over another: what shows at once, and when all is drawn.
TEST_F(Screenshots, AStudyOverAnother) {
  FENESTRA_TEST_DATA_OR_SKIP(series, "labelled/totalsegmentator-dicom/example_ct_dicom");
  FENESTRA_TEST_DATA_OR_SKIP(uneven, "dicom/ct-missing-slice");
  Window::SetUp();
  for (const QSize& size : {QSize(1366, 768), QSize(1920, 1080)}) {
    window_->resize(size);
    for (const auto& [path, name] : {std::pair{uneven, "uneven"}, std::pair{series, "series"}}) {
      open(markedBall());
      document().focusOn(marker);
      waitUntilDrawn();
      QSignalSpy opened(window_.get(), &MainWindow::opened);
      window_->open(std::vector{path});
      ASSERT_TRUE(opened.wait(patience));
      save(window_->picture(MainWindow::Patient::Shown), QStringLiteral("at-once-") + QLatin1String(name));
      document().growFrom(cursor().position());
      waitUntilDrawn();
      save(window_->picture(MainWindow::Patient::Shown), QStringLiteral("drawn-") + QLatin1String(name));
    }
  }
}

/// All that the window says of a study: notices of each kind, the patient, chips, and what is awaited.
TEST_F(Screenshots, Notices) {
  Window::SetUp();
  io::Study study = markedBall();
  study.patient = {"Vermeer^Johanna^Maria", "QX-19500102-4711", "F", "19500102"};
  study.series = {};
  study.series.modality = "MR";
  study.series.description = "t1_mprage_sag_p2_iso_1.0";
  study.series.study = "Head without contrast";
  study.series.number = 4;
  study.series.part = "echo time 2.46 ms";
  study.series.thickness = study.series.step = 1.0;
  study.otherSeries = {study.series, study.series};
  study.otherSeries[0].part = "echo time 4.92 ms";
  study.otherSeries[1].description = "Scout";
  study.otherSeries[1].part.clear();
  study.otherSeries[1].number = 1;
  study.reason = {"the thinnest %1, %2", {"acquired volume", "1.0 mm"}};
  study.warnings = {{io::Warning::Kind::MissingSlices, "2 slices are missing", {"a.dcm"}},
                    {io::Warning::Kind::TimePoints, "number 1 is shown", {}, io::WayOut::ChooseTime},
                    io::tableWarning()};
  for (const QSize& size : {QSize(1366, 768), QSize(1920, 1080)}) {
    window_->resize(size);
    open(study);
    window_->notices().addError(NoticeBar::Subject::Opening,
                                QStringLiteral("/data/study/brain.nii: is shorter than its header says; get the file "
                                               "again from its source"));
    document().focusOn(marker);
    waitUntilDrawn();
    save(window_->picture(MainWindow::Patient::Shown), QStringLiteral("notices"));
    views().setAwaits(true);
    QTest::qWait(500);
    save(window_->grab().toImage(), QStringLiteral("awaits"));
    views().setAwaits(false);
    waitUntilDrawn();
  }
  auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("seriesDock"));
  dock->show();
  QTest::qWait(300);
  save(window_->picture(MainWindow::Patient::Shown), QStringLiteral("series"));
  dock->hide();
  SpacingDialog size(QStringLiteral("stack does not say how large its voxels are. Say it here:"), window_.get());
  size.show();
  QTest::qWait(100);
  save(size.grab().toImage(), QStringLiteral("spacing"));
}

}  // namespace
}  // namespace fenestra::viewer::screenshotsTest
