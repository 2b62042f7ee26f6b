// The walk of the user guide: does each step of its page on the first minute in the window, and takes the guide's
// pictures. They are compared in structure with those of resources/guide/images.
//
//   packaging/guide-pictures
// takes them anew: with FENESTRA_GUIDE_PICTURES=FOLDER they are written to FOLDER and compared with nothing.

#include <filesystem>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "io/study/ReadStudy.h"
#include "tests/gui/Likeness.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/guide/Tour.h"
#include "viewer/panels/CutawayPanel.h"

namespace fenestra::viewer::guideWalkTest {
namespace {

/// Least likeness of a fresh picture to the stored one. On one machine the palette of the stored pictures leaves 0.996,
/// and a click that lands a voxel further 0.96; other fonts move some letters. Without the opening, or without a panel,
/// it is 0.03 and less, which the walk checks.
constexpr double leastLikeness = 0.7;

/// As the program reads its phantoms.
io::Study readPhantom(const std::string& name, const Look& look, const io::Progress& progress) {
  io::StudyRequest request;
  request.phantom = name;
  request.look = look;
  return io::readStudy(request, progress);
}

class GuideWalk : public Window {
 protected:
  void SetUp() override {
    ASSERT_TRUE(gl_.available) << gl_.problem.toStdString();
    window_ = std::make_unique<MainWindow>(MainWindow::Setup{.gl = gl_, .atRest = Effort{}, .remember = false});
    for (const char* name : {"torso", "head"})
      window_->addSample(QString::fromLatin1(name == std::string("torso") ? "Torso" : "Head"),
                         [name = std::string(name)](const Look& look, const io::Progress& progress) {
                           return readPhantom(name, look, progress);
                         });
    window_->resize(1120, 720);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), patience));
    QApplication::setActiveWindow(window_.get());
    window_->tour().setAnimated(false);
    cameras().setAnimated(false);
    QApplication::processEvents();
  }

  QString folder() const { return qEnvironmentVariable("FENESTRA_GUIDE_PICTURES"); }
  QImage stored(const char* name) const {
    return QImage(QStringLiteral(FENESTRA_SOURCE_DIR "/resources/guide/images/%1.png").arg(QLatin1String(name)));
  }
  /// Writes a picture, or compares it with the stored one.
  void keep(const char* name, const QImage& picture) {
    SCOPED_TRACE(name);
    if (!folder().isEmpty()) {
      EXPECT_TRUE(picture.save(QStringLiteral("%1/%2.png").arg(folder(), QLatin1String(name))));
      return;
    }
    EXPECT_EQ(picture.size(), stored(name).size());
    const double like = likeness(picture, stored(name));
    EXPECT_GE(like, leastLikeness) << name;
    std::cout << "  " << name << ": likeness " << like << "\n";
    if (like < leastLikeness) picture.save(QStringLiteral("%1.fresh.png").arg(QLatin1String(name)));
  }
  void keepWindow(const char* name) {
    waitUntilDrawn();
    keep(name, window_->picture());
  }
  /// A change must make the window unlike the stored picture.
  void expectUnlike(const char* name, const char* change) {
    if (!folder().isEmpty()) return;
    waitUntilDrawn();
    const double like = likeness(window_->picture(), stored(name));
    EXPECT_LT(like, leastLikeness) << name << " with " << change;
    std::cout << "  " << name << " with " << change << ": likeness " << like << "\n";
  }
  QDockWidget* dock(const char* name) { return window_->findChild<QDockWidget*>(QLatin1String(name)); }
  void doStep(int step) {
    window_->tour().perform(step);
    ASSERT_FALSE(window_->tour().isActing());
    waitUntilDrawn();
  }
};

TEST_F(GuideWalk, EachStepOfTheFirstMinuteDoesWhatTheGuideShows) {
  keep("welcome", window_->picture());

  QSignalSpy opened(window_.get(), &MainWindow::opened);
  for (QPushButton* button : window_->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Torso")) QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(opened.count() > 0 || opened.wait(patience));
  keepWindow("opened");
  EXPECT_FALSE(std::holds_alternative<std::monostate>(document().focus()));

  doStep(1);
  const std::uint16_t leftKidney = 20;  // resources/phantoms/torso.json
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{leftKidney}}));
  EXPECT_NE(placement().measured(), nullptr);
  keepWindow("chosen");
  Look look = document().look();
  look.cutaway.enabled = false;
  document().edit(QStringLiteral("closed"), look);
  expectUnlike("chosen", "a closed opening");
  document().undoStack().undo();
  dock("cutawayDock")->hide();
  expectUnlike("chosen", "a panel less");
  dock("cutawayDock")->show();

  const Camera before = cameras().camera(0), beside = cameras().camera(1);
  doStep(2);
  EXPECT_NE(cameras().camera(0), before);
  EXPECT_NE(cameras().camera(1), beside);

  const double width = document().look().cutaway.openWidth;
  doStep(3);
  EXPECT_GT(document().look().cutaway.openWidth, 1.5 * width);
  keepWindow("widened");

  doStep(4);
  ASSERT_EQ(document().look().strokes.size(), 1u);
  EXPECT_FALSE(brush().isActive());
  keepWindow("painted");

  QTimer look2;
  QImage dialogPicture;
  QObject::connect(&look2, &QTimer::timeout, [&] {
    if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
      dialogPicture = dialog->grab().toImage();
      dialog->reject();
    }
  });
  look2.start(50);
  QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
  ASSERT_FALSE(dialogPicture.isNull());
  keep("save-picture", dialogPicture);
}

TEST_F(GuideWalk, ThePanelsAreThoseOfTheGuide) {
  window_->resize(1280, 1150);
  open(readPhantom("torso", {}, {}));
  document().focusOn(20);
  brush().setActive(true);
  for (const auto& [name, picture] : {std::pair{"focusDock", "panel-focus"},
                                      {"cutawayDock", "panel-cutaway"},
                                      {"clippingDock", "panel-clipping"},
                                      {"brushDock", "panel-brush"},
                                      {"camerasDock", "panel-cameras"},
                                      {"contextDock", "panel-context"}}) {
    bringUp(name);
    QTest::qWait(50);
    if (QWidget* focused = QApplication::focusWidget()) focused->clearFocus();  // no frame around it
    waitUntilDrawn();
    keep(picture, dock(name)->grab().toImage());
  }
}

}  // namespace
}  // namespace fenestra::viewer::guideWalkTest
