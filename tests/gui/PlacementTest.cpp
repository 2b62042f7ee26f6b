// Placing the cameras, behind the window: without widgets and without OpenGL.

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "rendering/viewpoints/LiveSync.h"
#include "rendering/viewpoints/Sphere.h"
#include "tests/gui/Patience.h"
#include "tests/support/TestData.h"
#include "viewer/model/Document.h"
#include "viewer/model/Mollweide.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/Preferences.h"

namespace fenestra::viewer::placementTest {
namespace {

constexpr double tolerance = 1e-9;  ///< error of unit vectors after a few operations in double precision
/// The direction whose descriptors are best.
const glm::dvec3 bestDirection = glm::normalize(glm::dvec3(1.0, -2.0, 0.5));

/// Measures nothing: the nearer a candidate is to bestDirection, the more it covers. Two surface points, one seen from
/// each half of the sphere.
class FakeBackend : public PlacementBackend {
 public:
  struct Log {
    int begun = 0, slices = 0;
    bool broken = false;
  };
  explicit FakeBackend(std::shared_ptr<Log> log) : log_(std::move(log)) {}

  void begin(const Scene&, const placement::Sampling& sampling, const placement::Options&) override {
    if (log_->broken) throw std::runtime_error("no memory");
    ++log_->begun;
    slicesLeft_ = 3;
    measured_ = {};
    for (const glm::dvec3 direction : placement::ringDirections(*placement::sideOf(sampling.count))) {
      placement::Candidate candidate;
      candidate.direction = direction;
      const double near = 0.5 + 0.5 * glm::dot(direction, bestDirection);
      candidate.sums.count = 1.0;
      candidate.descriptors.coverage = candidate.descriptors.location = near;
      candidate.seen = {glm::dot(direction, bestDirection) > 0.0 ? 1u : 2u};
      measured_.candidates.push_back(candidate);
    }
    measured_.spread = measured_.candidates.size();
    measured_.surfacePoints = 2;
  }
  bool advance() override {
    ++log_->slices;
    return --slicesLeft_ == 0;
  }
  double progress() const override { return 1.0 - slicesLeft_ / 3.0; }
  const placement::Measured& measured() const override { return measured_; }
  QImage picture(const Scene&, const Camera&, QSize size) override { return QImage(size, QImage::Format_RGB32); }

 private:
  std::shared_ptr<Log> log_;
  int slicesLeft_ = 0;
  placement::Measured measured_;
};

io::Study study() {
  auto volume = std::make_shared<Volume>();
  auto labels = std::make_shared<LabelMap>();
  volume->grid = labels->grid = {.dims = glm::ivec3(8), .spacing = glm::dvec3(2.0)};
  volume->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
  labels->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
  for (Voxels* voxels : {&volume->voxels, &labels->voxels})
    std::ranges::fill(voxels->as<std::uint8_t>(), std::uint8_t{0});
  labels->voxels.as<std::uint8_t>()[0] = 1;
  labels->voxels.as<std::uint8_t>()[1] = 2;
  volume->computeRange();
  labels->labels = {{1, "first", {1, 0, 0}}, {2, "second", {0, 1, 0}}};
  io::Study made;
  made.scene.volume = volume;
  made.scene.labels = labels;
  made.scene.look.context.function.nodes = {{100.0, {{1, 1, 1}, 1.0}}};
  return made;
}

class Placement : public testing::Test {
 protected:
  void SetUp() override {
    placement_.setBackend(std::make_unique<FakeBackend>(log_));
    document_.open(study());
    const Grid& grid = document_.scene().volume->grid;
    cameras_.place({Camera::standard(StandardView::Anterior, grid), Camera::standard(StandardView::Left, grid)});
  }

  bool arrive() {
    return QTest::qWaitFor([&] { return !placement_.isBusy() && !cameras_.isFlying(); }, patience);
  }
  glm::dvec3 direction(int view) { return directionOf(cameras_.camera(view)); }
  void change(void (*edit)(PlacementSettings&)) {
    PlacementSettings settings = placement_.settings();
    edit(settings);
    placement_.setSettings(settings);
  }

  std::shared_ptr<FakeBackend::Log> log_ = std::make_shared<FakeBackend::Log>();
  Document document_;
  ViewLink cameras_;
  PlacementController placement_{document_, cameras_};
};

TEST_F(Placement, AChosenFocusIsMeasuredAndBothCamerasFlyToTheAnswer) {
  document_.focusOn(1);
  EXPECT_TRUE(placement_.isBusy());
  EXPECT_EQ(placement_.measured(), nullptr);
  EXPECT_FALSE(placement_.share());
  ASSERT_TRUE(arrive());
  ASSERT_NE(placement_.measured(), nullptr);
  const auto answer = placement::choose(*placement_.measured(), placement_.settings().options, true);
  EXPECT_LE(glm::distance(direction(0), placement_.measured()->candidates[*answer.c1].direction), tolerance);
  EXPECT_LE(glm::distance(direction(1), placement_.measured()->candidates[*answer.c2].direction), tolerance);
  EXPECT_NEAR(*placement_.share(), answer.share, tolerance);
  const Camera placed = cameras_.camera(0);
  cameras_.orbit(0, 1.0, 0.3);
  cameras_.reset();
  EXPECT_EQ(cameras_.camera(0), placed) << "reset goes back to the answer";
  // One after the other, C1 is the best view; 192 directions lie 15 degrees apart.
  change([](PlacementSettings& settings) { settings.joint = false; });
  ASSERT_TRUE(arrive());
  EXPECT_GT(glm::dot(direction(0), bestDirection), std::cos(glm::radians(15.0)));
}

TEST_F(Placement, OpeningAStudyLeavesItsCameras) {
  io::Study focused = study();
  focused.scene.look.focus = LabelFocus{{1}};
  document_.open(focused);
  EXPECT_FALSE(placement_.isBusy());
  EXPECT_TRUE(placement_.canPlace());
  placement_.place();
  ASSERT_TRUE(arrive());
  EXPECT_EQ(log_->begun, 1);
}

TEST_F(Placement, AFocusTakenBackAtOnceIsNotPlaced) {
  document_.focusOn(1);
  ASSERT_TRUE(arrive());
  cameras_.orbit(0, 0.5, 0.2);
  const Camera mine = cameras_.camera(0);
  document_.focusOn(2);
  document_.focusOn(1);
  EXPECT_FALSE(placement_.isBusy());
  EXPECT_NE(placement_.measured(), nullptr);
  EXPECT_EQ(cameras_.camera(0), mine);
  document_.setFocus(std::monostate{});
  EXPECT_FALSE(placement_.isBusy());
  EXPECT_EQ(placement_.measured(), nullptr);
  EXPECT_EQ(log_->begun, 1);
}

TEST_F(Placement, WeightsRegionAndSearchMeasureNothing) {
  document_.focusOn(1);
  ASSERT_TRUE(arrive());
  change([](PlacementSettings& settings) {
    settings.options.weights = {.coverage = -1.0, .location = 0.0};
    settings.joint = false;
  });
  EXPECT_TRUE(cameras_.isFlying());
  ASSERT_TRUE(arrive());
  EXPECT_LT(glm::dot(direction(0), bestDirection), -std::cos(glm::radians(15.0)));
  change([](PlacementSettings& settings) {
    settings.options.region = placement::Region::Stream;
    settings.joint = true;
  });
  ASSERT_TRUE(arrive());
  EXPECT_TRUE(placement::inRegion(direction(0), direction(1), placement_.settings().options));
  EXPECT_EQ(log_->begun, 1);
  change([](PlacementSettings& settings) { settings.sampling.count = 48; });
  ASSERT_TRUE(arrive());
  EXPECT_EQ(log_->begun, 2);
  EXPECT_EQ(placement_.measured()->spread, 48u);
}

TEST_F(Placement, C2FollowsATurnedC1ButNotTheOtherWayRound) {
  document_.focusOn(1);
  ASSERT_TRUE(arrive());
  cameras_.zoom(1, 2.0);
  const double distance = glm::distance(cameras_.camera(1).eye, cameras_.camera(1).target);
  const double held = glm::dot(direction(0), direction(1));
  for (int step = 0; step < 10; ++step) {
    cameras_.orbit(0, 0.09, 0.04);
    QTest::qWait(5);
    EXPECT_NEAR(glm::dot(direction(0), direction(1)), held, tolerance) << "while C1 turns, C2 turns along";
  }
  EXPECT_TRUE(placement_.isBusy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return cameras_.isFlying(); }, patience));
  ASSERT_TRUE(arrive());
  const auto dual = placement::chooseDual(*placement_.measured(), direction(0), placement_.settings().options);
  EXPECT_LE(glm::distance(direction(1), placement_.measured()->candidates[*dual.c2].direction), tolerance);
  EXPECT_NEAR(glm::distance(cameras_.camera(1).eye, cameras_.camera(1).target), distance, 1e-6) << "its zoom stays";

  const double relation = glm::dot(direction(0), direction(1));
  cameras_.orbit(1, 0.3, 0.1);
  EXPECT_NEAR(glm::dot(direction(0), direction(1)), relation, tolerance);
  change([](PlacementSettings& settings) { settings.follow = false; });
  cameras_.orbit(0, 0.3, 0.1);
  EXPECT_FALSE(placement_.isBusy());
  EXPECT_NEAR(glm::dot(direction(0), direction(1)), relation, tolerance);
}

TEST_F(Placement, GoingSomewhereKeepsTheZoomAndTurnsALinkedC2Along) {
  const double relation = glm::dot(direction(0), direction(1));
  cameras_.zoom(0, 3.0);
  const double distance = glm::distance(cameras_.camera(0).eye, cameras_.camera(0).target);
  placement_.goTo(bestDirection);
  ASSERT_TRUE(arrive());
  EXPECT_LE(glm::distance(direction(0), bestDirection), tolerance);
  EXPECT_NEAR(glm::dot(direction(0), direction(1)), relation, tolerance);
  EXPECT_NEAR(glm::distance(cameras_.camera(0).eye, cameras_.camera(0).target), distance, 1e-6);
}

TEST_F(Placement, GoingSomewhereLeavesAnUnlinkedC2Alone) {
  cameras_.setLinked(false);
  cameras_.orbit(1, 0.4, 0.8);
  const Camera second = cameras_.camera(1);
  placement_.goTo(bestDirection);
  ASSERT_TRUE(arrive());
  EXPECT_LE(glm::distance(direction(0), bestDirection), tolerance);
  EXPECT_EQ(cameras_.camera(1), second);
}

TEST_F(Placement, TheBestFewAreDistinctAndInOrder) {
  document_.focusOn(1);
  ASSERT_TRUE(arrive());
  const std::vector<std::size_t> best = placement_.best(5);
  ASSERT_EQ(best.size(), 5u);
  const auto& candidates = placement_.measured()->candidates;
  const auto quality = [&](std::size_t i) {
    return placement::quality(candidates[i].descriptors, placement_.settings().options.weights);
  };
  for (std::size_t a = 0; a < best.size(); ++a)
    for (std::size_t b = a + 1; b < best.size(); ++b) {
      EXPECT_LE(glm::dot(candidates[best[a]].direction, candidates[best[b]].direction),
                std::cos(glm::radians(30.0)) + tolerance);
      EXPECT_GE(quality(best[a]), quality(best[b]));
    }
}

TEST_F(Placement, CanBeCancelledAndTellsWhatWentWrong) {
  document_.focusOn(1);
  placement_.place();
  EXPECT_TRUE(placement_.isMeasuring());
  placement_.cancel();
  EXPECT_FALSE(placement_.isBusy());
  EXPECT_EQ(placement_.measured(), nullptr);
  log_->broken = true;
  placement_.place();
  EXPECT_FALSE(placement_.isBusy());
  EXPECT_TRUE(placement_.note().contains(QStringLiteral("no memory")));
}

TEST(PlacementPreferences, KeepTheSettingsAndDropNonsense) {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(tests::scratchFolder().string()));
  QCoreApplication::setOrganizationName(QStringLiteral("Fenestra tests"));
  QSettings().remove(QStringLiteral("placement"));
  Preferences preferences;
  EXPECT_EQ(preferences.placement(), PlacementSettings());
  PlacementSettings settings;
  settings.sampling.count = 588;
  settings.sampling.refined = true;
  settings.options.region = placement::Region::Stream;
  settings.options.streamHalfWidth = 7.5;
  settings.options.shareWeight = 0.25;
  settings.options.weights = {-0.5, 2.0, 0.125, 0.1, 0.2, 0.3, 0.4, -0.6};
  settings.joint = false;
  settings.follow = settings.automatic = false;
  settings.byPick = true;
  settings.liveSync = {{0.5, 0.25, 1.5, 2.5}, 75.0};
  preferences.setPlacement(settings);
  EXPECT_EQ(Preferences().placement(), settings);

  QSettings stored;
  stored.setValue(QStringLiteral("placement/samples"), 100);  // no count of directions
  stored.setValue(QStringLiteral("placement/streamHalfWidth"), -3.0);
  stored.setValue(QStringLiteral("placement/weightDepth"), QStringLiteral("nan"));
  stored.setValue(QStringLiteral("placement/weightCoverage"), QStringLiteral("much"));
  const PlacementSettings read = Preferences().placement(), defaults;
  EXPECT_EQ(read.sampling.count, defaults.sampling.count);
  EXPECT_EQ(read.options.streamHalfWidth, defaults.options.streamHalfWidth);
  EXPECT_EQ(read.options.weights.visibility, defaults.options.weights.visibility);
  EXPECT_EQ(read.options.weights.coverage, defaults.options.weights.coverage);
  EXPECT_EQ(read.options.weights.stability, settings.options.weights.stability);
}

TEST(Flight, TurnsEvenlyEndsExactlyAndStopsAtATouch) {
  const Grid grid{.dims = glm::ivec3(10), .spacing = glm::dvec3(2.0)};
  const Camera from = Camera::standard(StandardView::Anterior, grid), to = Camera::standard(StandardView::Left, grid);
  const Camera half = between(from, to, 0.5);
  EXPECT_NEAR(glm::dot(directionOf(half), directionOf(from)), std::sqrt(0.5), tolerance);
  EXPECT_NEAR(glm::dot(directionOf(half), directionOf(to)), std::sqrt(0.5), tolerance);
  EXPECT_NEAR(glm::dot(half.axes().up, glm::dvec3(0, 0, 1)), 1.0, tolerance);
  EXPECT_EQ(between(from, to, 1.0), to);

  ViewLink link;
  link.place({from, from.beside()});
  const ViewLink::Pair goal{to, Camera::standard(StandardView::Superior, grid)};
  link.flyTo(goal, goal);
  QSignalSpy landed(&link, &ViewLink::landed);
  ASSERT_TRUE(landed.wait(patience));
  EXPECT_EQ(link.camera(0), goal[0]);
  EXPECT_EQ(link.camera(1), goal[1]);
  link.flyTo({from, from}, goal);
  EXPECT_TRUE(link.isFlying());
  link.orbit(0, 0.1, 0.0);
  EXPECT_FALSE(link.isFlying());
  EXPECT_NE(link.camera(0), from);
}

TEST(Flight, CanBeFinishedAndTurnedOff) {
  const Grid grid{.dims = glm::ivec3(10), .spacing = glm::dvec3(2.0)};
  const Camera from = Camera::standard(StandardView::Anterior, grid), to = Camera::standard(StandardView::Left, grid);
  ViewLink link;
  link.place({from, from.beside()});
  link.flyTo({to, from}, {to, from});
  EXPECT_TRUE(link.isFlying());
  QSignalSpy landed(&link, &ViewLink::landed);
  link.finishFlight();
  EXPECT_FALSE(link.isFlying());
  EXPECT_EQ(link.camera(0), to);
  EXPECT_EQ(link.camera(1), from);
  EXPECT_EQ(landed.count(), 1);
  link.finishFlight();
  EXPECT_EQ(landed.count(), 1) << "there was no flight";

  link.flyTo({from, to}, {from, to});
  link.setAnimated(false);
  EXPECT_FALSE(link.isFlying());
  EXPECT_EQ(link.camera(1), to);
  link.flyTo({to, from}, {to, from});
  EXPECT_FALSE(link.isFlying());
  EXPECT_EQ(link.camera(0), to);
  EXPECT_EQ(landed.count(), 3);
}

TEST(PlacementPreferences, KeepWhetherTheCamerasAreAnimated) {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(tests::scratchFolder().string()));
  QCoreApplication::setOrganizationName(QStringLiteral("Fenestra tests"));
  QSettings().remove(QStringLiteral("picture"));
  EXPECT_TRUE(Preferences().isOn(Preference::AnimatedCameras));
  Preferences preferences;
  preferences.set(Preference::AnimatedCameras, 0);
  EXPECT_FALSE(Preferences().isOn(Preference::AnimatedCameras));
  QSettings().remove(QStringLiteral("picture"));
}

TEST(Mollweide, ShowsDirectionsWhereTheyAreReadBack) {
  for (const glm::dvec3 direction : placement::ringDirections(5)) {
    const std::optional<glm::dvec3> back = directionFromMap(mapFromDirection(direction));
    ASSERT_TRUE(back);
    // Near the poles the map's height changes with the 1.5th power of the angle, which costs half of the digits.
    EXPECT_LE(glm::distance(*back, direction), 1e-7);
  }
  // The map is flat at the poles, where a position keeps a third of the digits.
  const auto expectAt = [](glm::dvec3 direction, glm::dvec2 position) {
    EXPECT_LE(glm::distance(mapFromDirection(direction), position), 1e-4);
  };
  expectAt({0, -1, 0}, {0, 0});  // anterior in the middle
  expectAt({1, 0, 0}, {1, 0});   // left on the right
  expectAt({0, 0, 1}, {0, 1});   // superior on top
  EXPECT_FALSE(directionFromMap({1.5, 0.9}));
}

/// Cameras for points clicked on slices.
class Picking : public Placement {
 protected:
  void SetUp() override {
    Placement::SetUp();
    change([](PlacementSettings& settings) { settings.byPick = true; });
  }
  /// The views rated for a pick on the first label, at the corner of the volume.
  placement::RatedViews rated(glm::dvec3 last) {
    return placement::rateViews(document_.scene(), {document_.scene().labels, {1}}, corner, 4,
                                placement_.settings().liveSync, placement_.settings().options, last);
  }

  static constexpr glm::dvec3 corner{0.0, 0.0, 0.0};
};

TEST_F(Picking, APickTurnsBothCamerasToItsStructure) {
  cameras_.setPose({{facing(cameras_.camera(0), bestDirection), cameras_.camera(1)}, cameras_.pose().home});
  const placement::RatedViews expected = rated(bestDirection);
  ASSERT_TRUE(expected.c1 && expected.c2);
  QSignalSpy leaving(&placement_, &PlacementController::leaving);
  placement_.pick(corner);
  EXPECT_TRUE(placement_.isBusy());
  ASSERT_TRUE(arrive());
  EXPECT_EQ(leaving.count(), 1);
  EXPECT_TRUE(placement_.note().isEmpty()) << placement_.note().toStdString();
  EXPECT_LT(glm::distance(direction(0), expected.directions[*expected.c1]), tolerance);
  EXPECT_LT(glm::distance(direction(1), expected.directions[*expected.c2]), tolerance);
  for (const int view : {0, 1}) EXPECT_EQ(cameras_.camera(view).target, corner);
  EXPECT_EQ(log_->begun, 0) << "nothing is measured for it";
  // With the history alone, the camera stays where it is, but for the nearest candidate.
  change([](PlacementSettings& settings) { settings.liveSync.weights = {0.0, 1.0, 0.0, 0.0}; });
  const glm::dvec3 before = direction(0);
  placement_.pick(corner);
  ASSERT_TRUE(arrive());
  EXPECT_LT(glm::distance(direction(0), before), tolerance);
}

TEST_F(Picking, OfSeveralPicksTheLastCountsAndADoubleClickIsNone) {
  const glm::dvec3 before = direction(0);
  placement_.pick(corner);
  EXPECT_TRUE(placement_.isBusy());
  QSignalSpy changes(&placement_, &PlacementController::changed);
  placement_.forgetPick();
  EXPECT_FALSE(placement_.isBusy());
  EXPECT_EQ(changes.count(), 1) << "whoever waits for the answer goes on";
  EXPECT_FALSE(placement_.isBusy());
  QTest::qWait(400);  // twice the delay of a pick
  EXPECT_EQ(direction(0), before);
  placement_.pick({2.0, 0.0, 0.0});  // the second label
  placement_.pick(corner);
  ASSERT_TRUE(arrive());
  EXPECT_EQ(cameras_.camera(0).target, corner);
}

TEST_F(Picking, APickWithoutAStructureSaysSoAndMovesNothing) {
  const ViewLink::Pose before = cameras_.pose();
  for (const glm::dvec3 nothing : {glm::dvec3(8.0), glm::dvec3(500.0)}) {  // in air, and outside
    placement_.pick(nothing);
    ASSERT_TRUE(arrive());
    EXPECT_FALSE(placement_.note().isEmpty());
    EXPECT_EQ(cameras_.pose(), before);
  }
  placement_.pick(corner);
  ASSERT_TRUE(arrive());
  EXPECT_TRUE(placement_.note().isEmpty());
}

TEST_F(Picking, AFocusIsNotPlacedForMeanwhile) {
  document_.focusOn(1);
  QTest::qWait(400);  // twice the delay after which it would be
  ASSERT_TRUE(arrive());
  EXPECT_EQ(log_->begun, 0);
  placement_.place();  // but on request
  ASSERT_TRUE(arrive());
  EXPECT_EQ(log_->begun, 1);
}

TEST_F(Picking, WithoutTheModeAPickDoesNothing) {
  change([](PlacementSettings& settings) { settings.byPick = false; });
  const ViewLink::Pose before = cameras_.pose();
  placement_.pick(corner);
  EXPECT_FALSE(placement_.isBusy());
  EXPECT_EQ(cameras_.pose(), before);
}

}  // namespace
}  // namespace fenestra::viewer::placementTest
