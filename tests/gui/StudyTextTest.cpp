// Patient and study in the corners of the pictures, and nowhere else; window and level by number; inversion.

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QSettings>
#include <QStatusBar>
#include <QTest>

#include "io/session/SessionFile.h"
#include "io/study/ReadStudy.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/dialogs/WindowLevelDialog.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/PatientLines.h"

namespace fenestra::viewer::studyTextTest {
namespace {

io::PatientText somebody() { return {"Vermeer^Johanna^Maria", "QX-4711", "F", "19500102"}; }

io::Study studyOfSomebody() {
  io::Study study = markedBall();
  study.patient = somebody();
  study.series.modality = "CT";
  study.series.description = "Thorax 1.0 B70";
  study.series.study = "Staging";
  study.series.date = "20200304";
  return study;
}

TEST(PatientLines, AreWrittenAsPeopleReadThem) {
  const io::SeriesInfo series = studyOfSomebody().series;
  EXPECT_EQ(patientLines(somebody(), series),
            (QStringList{"Vermeer, Johanna Maria", "ID QX-4711", "F · born 1950-01-02", "Staging", "Thorax 1.0 B70",
                         "2020-03-04"}));
  EXPECT_EQ(patientLines({"Yamada^Tarou=山田^太郎", "", "", ""}, {}), QStringList{"Yamada, Tarou"});
  EXPECT_EQ(patientLines({"^", "", "O", "about 1950"}, {}), QStringList{"O · born about 1950"});
  EXPECT_TRUE(patientLines({}, {}).isEmpty());
}

TEST(PatientLines, HoldNothingWithoutAGlyph) {
  const std::string nul("47\0 11", 6), escape = "4\x1b$B711",
                                       broken =
                                           "47\xff"
                                           "11";
  EXPECT_EQ(patientLines({"", nul, "", ""}, {}), QStringList{"ID 47 11"});
  EXPECT_EQ(patientLines({"", escape, "", ""}, {}), QStringList{"ID 4$B711"});
  EXPECT_EQ(patientLines({"", broken, "", ""}, {}), QStringList{"ID 4711"});
}

TEST(PatientLines, ComeFromTheDicomFiles) {
  const auto folder = tests::scratchFolder() / "study";
  std::filesystem::create_directories(folder);
  for (int image = 0; image < 2; ++image) {
    tests::DicomSpec spec;
    spec.instance += "." + std::to_string(image);
    spec.position = glm::dvec3(0, 0, image);
    spec.patientName = "Müller^Jörg";
    spec.patientId = "0815";
    spec.birthDate = "19611231";
    spec.sex = "M";
    spec.study = "Schädel";
    spec.date = "20190705";
    tests::writeDicom(folder / std::to_string(image), spec);
  }
  io::StudyRequest request;
  request.path = folder;
  const io::Study study = io::readStudy(request);
  EXPECT_EQ(patientLines(study.patient, study.series),
            (QStringList{"Müller, Jörg", "ID 0815", "M · born 1961-12-31", "Schädel", "2019-07-05"}));
  // The session holds none of these texts.
  const std::string session = io::textOf(study.session, folder / "s.fenestra");
  for (const char* secret : {"ller", "0815", "19611231", "Sch"}) EXPECT_EQ(session.find(secret), std::string::npos);
}

class StudyWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    open(studyOfSomebody());
  }
  /// The picture of a view on screen.
  QImage onScreen(QWidget* view) { return view->grab().toImage(); }
};

TEST_F(StudyWindow, OneKeyHidesThePatientAndTheStudy) {
  SliceView* axial = slice(SlicePlane::Axial);
  const QImage with = onScreen(axial);
  QTest::keyClick(window_.get(), Qt::Key_H);
  EXPECT_TRUE(options().hidesPatient());
  const QImage without = onScreen(axial);
  EXPECT_NE(without, with);
  // The picture is that of data that names no patient.
  open(markedBall());
  EXPECT_EQ(onScreen(axial), without);
  QTest::keyClick(window_.get(), Qt::Key_H);
  EXPECT_EQ(onScreen(axial), without);
}

TEST_F(StudyWindow, ThePatientIsInThe3DViewsToo) {
  const QImage with = volume(0)->grabSurface();
  options().setHidesPatient(true);
  EXPECT_NE(volume(0)->grabSurface(), with);
}

TEST_F(StudyWindow, PicturesTitleAndSessionsNameNobody) {
  const QImage picture = window_->picture(), asked = window_->picture(MainWindow::Patient::Shown);
  EXPECT_NE(picture, asked);
  EXPECT_FALSE(options().hidesPatient()) << "only while the picture was taken";
  options().setHidesPatient(true);
  EXPECT_EQ(window_->picture(), picture);
  const std::string session = io::textOf(
      [&] {
        io::Session shown = window_->sessions().controller().session();
        shown.phantom = io::SessionPhantom{"torso"};
        return shown;
      }(),
      "/tmp/s.fenestra");
  for (const char* secret : {"Vermeer", "4711", "1950", "Staging", "Thorax"}) {
    EXPECT_FALSE(window_->windowTitle().contains(QLatin1String(secret))) << secret;
    EXPECT_EQ(session.find(secret), std::string::npos) << secret;
  }
}

TEST_F(StudyWindow, HidingIsRememberedAndHidesNamesInTheRecentList) {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(tests::scratchFolder().string()));
  QCoreApplication::setOrganizationName(QStringLiteral("Fenestra tests"));
  Preferences(Preferences::Mode::Stored).addRecent("/data/Vermeer Johanna/CT");
  const auto entries = [](MainWindow& window) {
    QStringList texts;
    for (QMenu* menu : window.findChildren<QMenu*>())
      if (menu->title() == QStringLiteral("&Recent")) {
        Q_EMIT menu->aboutToShow();
        for (const QAction* action : menu->actions()) texts << action->text();
      }
    return texts.join(QLatin1Char('|'));
  };
  {
    MainWindow window({.gl = gl_});
    EXPECT_TRUE(entries(window).contains(QStringLiteral("Vermeer")));
    for (QAction* action : window.findChildren<QAction*>())
      if (action->text() == QStringLiteral("&Hide the patient")) action->trigger();
    EXPECT_FALSE(entries(window).contains(QStringLiteral("Vermeer")));
  }
  MainWindow again({.gl = gl_});
  EXPECT_TRUE(again.workspace().options.hidesPatient());
  EXPECT_FALSE(entries(again).contains(QStringLiteral("Vermeer")));
}

TEST_F(StudyWindow, WindowAndLevelAreTypedAsNumbers) {
  QTest::keyClick(window_.get(), Qt::Key_W);
  auto* dialog = window_->findChild<WindowLevelDialog*>();
  ASSERT_TRUE(dialog);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog, patience));
  QApplication::setActiveWindow(dialog);  // Xvfb has no window manager to do it
  for (QAction* action : window_->findChildren<QAction*>())
    if (action->shortcut() == QKeySequence(Qt::Key_W)) action->trigger();
  EXPECT_EQ(window_->findChildren<WindowLevelDialog*>().size(), 1) << "the one that is open comes to the front";
  EXPECT_EQ(dialog->windowWidth()->value(), document().window().width);
  EXPECT_EQ(dialog->windowWidth()->suffix(), QStringLiteral(" HU"));
  dialog->windowWidth()->setFocus();
  dialog->windowWidth()->selectAll();
  QTest::keyClicks(dialog->windowWidth(), QStringLiteral("1234.5"));
  QTest::keyClick(dialog->windowWidth(), Qt::Key_Tab);
  dialog->level()->selectAll();
  QTest::keyClicks(dialog->level(), QStringLiteral("-67"));
  QTest::keyClick(dialog->level(), Qt::Key_Tab);
  EXPECT_EQ(document().window(), (WindowLevel{1234.5, -67.0}));
  // And the other way: a preset shows in the boxes.
  document().setWindow({1500.0, -500.0});
  EXPECT_EQ(dialog->windowWidth()->value(), 1500.0);
  EXPECT_EQ(dialog->level()->value(), -500.0);
  auto* inverted = dialog->findChild<QCheckBox*>();
  inverted->setChecked(true);
  EXPECT_TRUE(document().isInverted());
  dialog->close();
}

TEST_F(StudyWindow, TheIKeyInverts) {
  SliceView* axial = slice(SlicePlane::Axial);
  options().setText(false);
  options().setLabels(false);
  options().setCrosshair(false);
  cursor().moveTo(markerCentre);
  const auto at = [&](glm::dvec3 world) {
    const QImage image = axial->grab().toImage();
    const QPointF place = axial->widgetFromWorld(world) * image.devicePixelRatio();
    return image.pixelColor(place.toPoint()).red();
  };
  const glm::dvec3 air(-46.0, -46.0, markerCentre.z);
  EXPECT_EQ(at(markerCentre), 255);
  EXPECT_EQ(at(air), 0);
  QTest::keyClick(window_.get(), Qt::Key_I);
  EXPECT_EQ(at(markerCentre), 0);
  EXPECT_EQ(at(air), 255);
  EXPECT_TRUE(window_->sessions().controller().session().inverted);
  QTest::keyClick(window_.get(), Qt::Key_1);
  EXPECT_FALSE(document().isInverted()) << "the data's own window";

  io::Study inverted = markedBall();
  inverted.session.inverted = true;
  open(inverted);
  cursor().moveTo(markerCentre);
  EXPECT_EQ(at(markerCentre), 0);
}

TEST_F(StudyWindow, NamesWhatIsUnderTheMouseIn3DToo) {
  document().focusOn(marker);
  waitUntilDrawn();
  const std::optional<QPointF> at = volume(0)->widgetFromWorld(markerCentre);
  ASSERT_TRUE(at);
  const glm::dvec3 crosshair = cursor().position();
  const auto move = [this](QPoint place) {
    QMouseEvent event(QEvent::MouseMove, place, volume(0)->mapToGlobal(place), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(volume(0), &event);
  };
  move(at->toPoint());
  const auto text = [&] {
    QStringList texts;
    for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>()) texts << label->text();
    return texts.join(QLatin1Char('|'));
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return text().contains(QStringLiteral("900 HU")); }, patience))
      << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("marker"))) << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("mm"))) << text().toStdString();
  EXPECT_EQ(cursor().position(), crosshair) << "the crosshair stays";
  move({3, volume(0)->height() / 2});  // the background
  EXPECT_TRUE(QTest::qWaitFor([&] { return !text().contains(QStringLiteral("900 HU")); }, patience));
}

}  // namespace
}  // namespace fenestra::viewer::studyTextTest
