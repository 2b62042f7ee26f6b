// Sessions in the window: a saved session comes back bit for bit, including its pictures, and the command line draws
// the same.

#include "tests/gui/SessionWindowFixture.h"

namespace fenestra::viewer::sessionWindowTest {
namespace {

/// The handles that turn planes show under the mouse; a window that is opened again has it nowhere.
void takeMouseOff(SliceView& slice) {
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&slice, &leave);
}

TEST_F(SessionWindow, SavedAndReopenedShowsTheSamePictures) {
  work();
  const std::vector<QImage> before = pictures();
  save(file_);
  const Look look = document().look();
  restart();
  open(file_);
  EXPECT_EQ(document().look(), look);
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_TRUE(window_->notices().texts().isEmpty())
      << window_->notices().texts().join(QStringLiteral("; ")).toStdString();
  const std::vector<QImage> after = pictures();
  for (std::size_t view = 0; view < before.size(); ++view) EXPECT_EQ(before[view], after[view]) << "view " << view;
  save(folder_ / "again.fenestra");
  EXPECT_EQ(readFile(file_), readFile(folder_ / "again.fenestra"));
}

TEST_F(SessionWindow, KeepsAPaintedRegion) {
  Look look = document().look();
  look.method.kind = kindOf<methods::Selection>;
  document().edit(QStringLiteral("method"), std::move(look));
  cursor().moveTo(glm::dvec3(0.0));
  SelectionBrush& brush = window_->workspace().selection;
  brush.setSettings({.radius = 7.5, .softness = 0.4});
  brush.setActive(true);
  SliceView* axial = slice(SlicePlane::Axial);
  const auto at = [&](double x) { return axial->widgetFromWorld({x, 0.0, 0.0}).toPoint(); };
  drag(axial, at(-15.0), at(15.0));
  drag(axial, at(0.0), at(1.0), Qt::LeftButton, Qt::ShiftModifier);
  brush.setActive(false);
  takeMouseOff(*axial);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  waitUntilDrawn();
  ASSERT_EQ(document().region()->painted.size(), 2u);
  const RegionFocus painted = *document().region();
  EXPECT_EQ(painted.painted.front().softness, 0.4);
  const std::vector<QImage> before = pictures();
  save(file_);
  restart();
  open(file_);
  ASSERT_TRUE(document().region());
  EXPECT_EQ(*document().region(), painted);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  waitUntilDrawn();
  const std::vector<QImage> after = pictures();
  for (std::size_t view = 0; view < before.size(); ++view) EXPECT_EQ(before[view], after[view]) << "view " << view;
}

TEST_F(SessionWindow, ASessionEntersTheDocumentOnce) {
  work();
  save(file_);
  restart();
  std::vector<std::unique_ptr<QSignalSpy>> spies;
  for (const auto signal : {&Document::volumeChanged, &Document::focusChanged, &Document::transferFunctionChanged,
                            &Document::cutawayChanged, &Document::shadingChanged, &Document::strokesChanged,
                            &Document::windowChanged, &Document::sceneChanged})
    spies.push_back(std::make_unique<QSignalSpy>(&document(), signal));
  open(file_);
  for (const auto& spy : spies) EXPECT_EQ(spy->count(), 1) << spy->signal().toStdString();
}

TEST_F(SessionWindow, TheCommandLineAgreesWithTheWindow) {
  work();
  save(file_);
  expectCommandLineAgrees();
}

TEST_F(SessionWindow, AFrozenOpeningStaysFrozenOnTheCommandLineToo) {
  work();
  QTest::keyClick(window_.get(), Qt::Key_F);
  cameras().orbit(0, 0.4, 0.1);
  waitUntilDrawn();
  ASSERT_TRUE(cameras().isFrozen());
  const ViewLink::Frozen frozen = cameras().frozen();
  save(file_);
  expectCommandLineAgrees();
  restart();
  open(file_);
  EXPECT_EQ(cameras().frozen(), frozen);
}

TEST_F(SessionWindow, TheQualitySphereIsFilledAndTheCamerasStay) {
  setAutomatic(true);
  document().focusOn(marker);
  ASSERT_TRUE(QTest::qWaitFor([&] { return placement().measured() && !cameras().isFlying(); }, patience));
  waitUntilDrawn();
  const ViewLink::Pair where = cameras().pose().cameras;
  save(file_);
  restart();
  open(file_);
  ASSERT_TRUE(QTest::qWaitFor([&] { return placement().measured() != nullptr; }, patience));
  EXPECT_EQ(cameras().pose().cameras, where);
  EXPECT_FALSE(window_->isWindowModified());
}

TEST_F(SessionWindow, LinkedCamerasStayLinkedAndUnlinkedOnesDoNot) {
  for (const bool linked : {false, true}) {
    cameras().setLinked(linked);
    cameras().orbit(0, 0.3, 0.1);
    save(file_);
    cameras().setLinked(!linked);
    open(file_);
    EXPECT_EQ(cameras().isLinked(), linked);
    EXPECT_EQ(window_->findChild<QAction*>(QStringLiteral("link"))->isChecked(), linked);
    PlacementSettings settings = placement().settings();
    settings.follow = false;
    placement().setSettings(settings);
    const Camera partner = cameras().camera(1);
    drag(volume(0), {200, 150}, {260, 150});
    EXPECT_EQ(cameras().camera(1) != partner, linked);
  }
}

TEST_F(SessionWindow, CamerasStandWhereTheyStood) {
  cameras().setProjection(Projection::Orthographic);
  cameras().orbit(0, 1.1, -0.6);
  cameras().pan(1, 13.7, -4.2);
  cameras().zoom(0, 1.7);
  const ViewLink::Pose pose = cameras().pose();
  save(file_);
  const Camera posterior = Camera::standard(StandardView::Posterior, document().scene().volume->grid);
  cameras().place({posterior, posterior.beside()});
  ASSERT_NE(cameras().pose(), pose);
  open(file_);
  EXPECT_EQ(cameras().pose(), pose);
  cameras().reset();
  EXPECT_EQ(cameras().pose().cameras, pose.home);
}

TEST_F(SessionWindow, KeepsTheLayoutAndWhatIsDrawnOverThePictures) {
  views().toggleMaximised(slice(SlicePlane::Coronal));
  options().setText(false);
  options().setLabels(false);
  PlacementSettings settings = placement().settings();
  settings.sampling.count = 48;
  settings.options.weights.coverage = 2.5;
  settings.options.region = placement::Region::Stream;
  placement().setSettings(settings);
  save(file_);
  views().showAll();
  options().setText(true);
  placement().setSettings({});
  open(file_);
  EXPECT_TRUE(views().isMaximised());
  EXPECT_TRUE(slice(SlicePlane::Coronal)->isVisible());
  EXPECT_FALSE(volume(0)->isVisible());
  EXPECT_FALSE(options().text());
  EXPECT_TRUE(options().crosshair());
  EXPECT_EQ(placement().settings(), settings);
}

TEST_F(SessionWindow, AGrownRegionIsGrownAgain) {
  grow();
  document().addSeed({-20.0, 10.0, 17.0}, false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  document().setTolerance(77.7);
  waitUntilDrawn();
  const std::vector<QImage> before = pictures();
  const Look look = document().look();
  save(file_);
  expectCommandLineAgrees();
  restart();
  open(file_);
  EXPECT_EQ(document().look(), look);
  EXPECT_TRUE(document().isWhole()) << "it is grown before it shows";
  EXPECT_EQ(pictures(), before);
  EXPECT_FALSE(window_->isWindowModified());
}

TEST_F(SessionWindow, ARegionWithinABallIsGrownAgain) {
  options().setGrows(true);
  document().setLabels(nullptr);
  cursor().moveTo(markerCentre);
  SliceView* axial = slice(SlicePlane::Axial);
  const auto at = [&](double x) { return axial->widgetFromWorld(markerCentre + glm::dvec3(x, 0.0, 0.0)).toPoint(); };
  drag(axial, at(0.0), at(5.0), Qt::LeftButton, Qt::ShiftModifier);
  takeMouseOff(*axial);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  waitUntilDrawn();
  const RegionFocus region = *document().region();
  EXPECT_NEAR(region.ball, 5.0, 1.0);
  EXPECT_EQ(region.rule, RegionRule::Tissues);
  const double volume = document().regionVolume();
  const std::vector<QImage> before = pictures();
  save(file_);
  expectCommandLineAgrees();
  restart();
  open(file_);
  ASSERT_TRUE(document().region());
  EXPECT_EQ(*document().region(), region);
  EXPECT_EQ(document().regionVolume(), volume);
  EXPECT_EQ(pictures(), before);
}

}  // namespace
}  // namespace fenestra::viewer::sessionWindowTest
