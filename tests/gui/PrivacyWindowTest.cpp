// Data that names a patient stays where it was read from. A study whose files name one is opened, looked at and worked
// on with the patient hidden; nothing that the window then shows, keeps, prints or writes may hold a word of it.

#include <iostream>

#include <QAbstractButton>
#include <QAction>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QTest>
#include <QTimer>

#include "io/ImageWriter.h"
#include "io/session/LookFile.h"
#include "rendering/settings/LookStyle.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/exports/Exports.h"
#include "viewer/exports/PictureExports.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer::privacyWindowTest {
namespace {

namespace fs = std::filesystem;

/// Words of the study's text, and of the folder that it lies in.
const std::vector<std::string> secrets{"Vermeer",   "Johanna",   "QX-4711", "19500102", "1950-01-02",
                                       "Restaging", "ThoraxB70", "ACC9931", "20200304", "2020-03-04"};

std::vector<std::string> secretsIn(const std::string& text) {
  std::vector<std::string> found;
  for (const std::string& secret : secrets)
    if (text.find(secret) != std::string::npos) found.push_back(secret);
  return found;
}

/// 24 slices of 24 x 24 pixels with a bright block in them, and a segmentation whose description names the patient.
void writeStudy(const fs::path& folder) {
  constexpr int side = 24;
  fs::create_directories(folder);
  for (int z = 0; z < side; ++z) {
    tests::DicomSpec slice;
    slice.columns = slice.rows = side;
    slice.instance += "." + std::to_string(z);
    slice.position = glm::dvec3(0, 0, z);
    slice.description = "ThoraxB70";
    slice.patientName = "Vermeer^Johanna";
    slice.patientId = "QX-4711";
    slice.birthDate = "19500102";
    slice.sex =
        std::string("F");  // GCC 12 warns wrongly of overlap where a text of one letter is assigned (GCC bug 105651)
    slice.accessionNumber = "ACC9931";
    slice.study = "Restaging";
    slice.date = "20200304";
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const bool inside = x > 6 && x < 18 && y > 6 && y < 18 && z > 6 && z < 18;
        slice.words.push_back(inside ? 900 : 40);
      }
    tests::writeDicom(folder / ("slice" + std::to_string(z)), slice);
  }
  tests::SegSpec segmentation;
  segmentation.columns = segmentation.rows = side;
  segmentation.description = "Liver of Vermeer";
  segmentation.segments = {{1, "Leber", {}}};
  std::vector<int> pixels(side * side, 0);
  for (int y = 8; y < 16; ++y) std::fill_n(pixels.begin() + y * side + 8, 8, 1);
  for (int z = 8; z < 16; ++z) segmentation.frames.push_back({1, glm::dvec3(0, 0, z), pixels});
  tests::writeSeg(folder / "seg.dcm", segmentation);
}

/// All texts of a widget and of what is in it, tool tips and menus included.
QString textsIn(const QWidget& window) {
  QStringList texts{window.windowTitle()};
  QList<const QWidget*> widgets{&window};
  for (const QWidget* child : window.findChildren<QWidget*>()) widgets << child;
  for (const QWidget* widget : widgets) {
    texts << widget->toolTip() << widget->windowTitle() << widget->accessibleName();
    if (const auto* label = qobject_cast<const QLabel*>(widget)) texts << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) texts << button->text();
  }
  for (const QAction* action : window.findChildren<QAction*>()) texts << action->text() << action->toolTip();
  return texts.join(QLatin1Char('\n'));
}

}  // namespace

/// A window as a user has it, with settings and copies of unsaved work in folders of the test's own.
class PrivacyWindow : public Window {
 protected:
  void SetUp() override {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    useScratchSettings();
    root_ = tests::scratchFolder();
    makeUserWindow();
  }
  void TearDown() override {
    window_.reset();
    const std::string all = printed();
    testing::internal::GetCapturedStderr();
    testing::internal::GetCapturedStdout();
    if (HasFailure()) std::cout << all;  // the failures are in it
  }
  /// What was printed since the test began.
  std::string printed() {
    printed_ += testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    return printed_;
  }
  void makeUserWindow() {
    window_.reset();
    window_ = std::make_unique<MainWindow>(MainWindow::Setup{.gl = gl_, .atRest = Effort{.quality = Quality::Draft}});
    window_->resize(1280, 800);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), patience));
    QApplication::setActiveWindow(window_.get());
    setAutomatic(false);
    SessionQuestions& questions = window_->sessions().questions();
    questions.saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
  }
  template <class Done>
  void waitFor(const Done& done) {
    ASSERT_TRUE(QTest::qWaitFor(done, patience)) << window_->notices().texts().join(QLatin1Char('\n')).toStdString();
  }
  void expectNoSecretsIn(const fs::path& folder) {
    int files = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      ++files;
      EXPECT_EQ(secretsIn(tests::readFile(entry.path())), std::vector<std::string>{}) << entry.path();
      EXPECT_EQ(secretsIn(entry.path().filename().string()), std::vector<std::string>{});
    }
    EXPECT_GT(files, 0) << folder;
  }
  void expectNoSecretsShown() {
    // Some menus are filled when they open.
    for (QMenu* menu : window_->findChildren<QMenu*>()) Q_EMIT menu->aboutToShow();
    EXPECT_EQ(secretsIn(textsIn(*window_).toStdString()), std::vector<std::string>{});
    EXPECT_EQ(secretsIn(window_->statusBar()->currentMessage().toStdString()), std::vector<std::string>{});
  }
  fs::path root_;
  std::string printed_;
};

TEST_F(PrivacyWindow, Thorough_NothingNamesAHiddenPatient) {
  const fs::path data = root_ / "study", written = root_ / "written", copies = root_ / "copies";
  fs::create_directories(written);
  writeStudy(data);
  // The study does name its patient, or the test would find nothing whatever the window did.
  ASSERT_EQ(secretsIn(tests::readFile(data / "slice0")).size(), secrets.size() - 2) << "all but the dates as shown";
  drop({data});
  window_->sessions().startRecovery(copies);
  QTest::keyClick(window_.get(), Qt::Key_H);
  ASSERT_TRUE(options().hidesPatient());
  window_->openLabels(data / "seg.dcm");
  waitFor([&] { return document().labels() != nullptr; });
  document().focusOn(1);
  document().setMeasures({{.points = {glm::dvec3(8, 8, 12), glm::dvec3(16, 8, 12)}}}, QStringLiteral("Distance"));
  waitUntilDrawn();

  SessionController& sessions = window_->sessions().controller();
  sessions.autosave();
  sessions.waitUntilSaved();
  ASSERT_FALSE(fs::is_empty(copies));
  expectNoSecretsIn(copies);
  sessions.save(written / "work.fenestra");
  ASSERT_TRUE(sessions.waitUntilSaved());

  Exports& exports = window_->exports();
  const auto idle = [&] { return !exports.job().isRunning(); };
  for (const char* name : {"all.nrrd", "all.nii", "all.mha", "all.dcm"}) {
    exports.writeLabels(written / name, Exports::Labels::All);
    waitFor(idle);
    ASSERT_TRUE(fs::exists(written / name)) << name;
  }
  for (const char* name : {"focus.stl", "focus.ply", "focus.obj"}) {
    exports.writeSurface(written / name, io::SurfaceFrame::Lps);
    waitFor(idle);
    ASSERT_TRUE(fs::exists(written / name)) << name;
  }
  exports.writeMeasures(written / "measures.csv");
  waitFor(idle);
  window_->pictures().writePicture(written / "views.png",
                                   {.volumes = views().volumeViews(), .slices = views().sliceViews()});
  waitFor([&] { return !window_->pictures().isBusy(); });
  io::writeLook(written / "look.json", {"look", "HU", styleOf(document().look()), {}});
  expectNoSecretsIn(written);

  expectNoSecretsShown();
  const fs::path settings = toPath(QSettings().fileName()).parent_path();
  ASSERT_NE(settings.string().find(root_.string()), std::string::npos);
  window_->close();
  window_.reset();
  expectNoSecretsIn(settings);
  if (HasFailure()) return;  // a failure prints what it found
  EXPECT_EQ(secretsIn(printed()), std::vector<std::string>{});
}

TEST_F(PrivacyWindow, AFolderNamedAfterItsPatientIsNotStored) {
  const fs::path data = root_ / "Vermeer Johanna 19500102", other = root_ / "phantoms", written = root_ / "qt";
  writeStudy(data);
  fs::create_directories(other);
  fs::create_directories(written);
  const QSettings now(QSettings::UserScope, QStringLiteral("QtProject"));
  const QString qtBefore = QFileInfo(now.fileName()).absolutePath();
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, toQString(written));
  const auto askFrom = [&](const fs::path& folder) {
    QTimer accepter;
    QObject::connect(&accepter, &QTimer::timeout, [&] {
      if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget()))
        QMetaObject::invokeMethod(dialog, "accept");
    });
    accepter.start(20);
    const auto chosen = askForFolder(window_.get(), {QStringLiteral("Test"), {}, toQString(folder)});
    EXPECT_EQ(chosen, folder);
  };
  const auto kept = [&] {
    std::string all;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(written))
      if (entry.is_regular_file()) all += tests::readFile(entry.path());
    return all;
  };
  Preferences& preferences = window_->workspace().preferences;
  preferences.set(Preference::HidesPatient, 1);
  askFrom(data);
  EXPECT_EQ(secretsIn(kept()), std::vector<std::string>{});
  drop({data});
  EXPECT_EQ(preferences.recent().size(), 1u);
  expectNoSecretsIn(toPath(QSettings().fileName()).parent_path());
  // Qt remembers a dialog's folder in memory, too, and stores it after the next one.
  preferences.set(Preference::HidesPatient, 0);
  askFrom(other);
  EXPECT_NE(kept().find("phantoms"), std::string::npos) << "otherwise Qt keeps a history";
  EXPECT_EQ(secretsIn(kept()), std::vector<std::string>{});
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, qtBefore);
}

TEST_F(PrivacyWindow, AFolderNamedAfterItsPatientIsNotShown) {
  const fs::path data = root_ / "Vermeer Johanna 19500102";
  writeStudy(data);
  fs::rename(data / "seg.dcm", data / "Vermeer.dcm");
  drop({data});
  EXPECT_FALSE(secretsIn(textsIn(*window_).toStdString()).empty()) << "the notice names the segmentation";
  const QImage picture = window_->picture();
  options().setHidesPatient(true);
  EXPECT_EQ(window_->picture(), picture) << "saved pictures hide the patient always";
  expectNoSecretsShown();
  options().setHidesPatient(false);
  EXPECT_FALSE(secretsIn(textsIn(*window_).toStdString()).empty());
}

}  // namespace fenestra::viewer::privacyWindowTest
