// The models behind the window, without widgets and without OpenGL.

#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <QSettings>
#include <QSignalSpy>

#include "rendering/settings/FlatStack.h"
#include "tests/support/TestData.h"
#include "viewer/model/ActiveTool.h"
#include "viewer/model/Document.h"
#include "viewer/model/DrawingTurns.h"
#include "viewer/model/FramePacer.h"
#include "viewer/model/Preferences.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/StrokeMode.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer::modelTest {
namespace {

/// For lengths and directions of order 1 to 1000 mm after a few rotations in double precision.
constexpr double tolerance = 1e-9;

void expectNear(glm::dvec3 a, glm::dvec3 b, double within = tolerance) {
  EXPECT_LE(glm::distance(a, b), within) << "(" << a.x << " " << a.y << " " << a.z << ") and (" << b.x << " " << b.y
                                         << " " << b.z << ")";
}

Grid cube() { return {.dims = glm::ivec3(10), .spacing = glm::dvec3(2.0), .origin = glm::dvec3(-9.0)}; }

glm::dmat3 worldFromView(const Camera& camera) {
  const Camera::Axes axes = camera.axes();
  return {axes.right, axes.up, -axes.forward};
}

void expectSameTurn(const std::array<Camera, 2>& before, const ViewLink& link) {
  const glm::dmat3 first = worldFromView(link.camera(0)) * glm::transpose(worldFromView(before[0]));
  const glm::dmat3 second = worldFromView(link.camera(1)) * glm::transpose(worldFromView(before[1]));
  for (int column = 0; column < 3; ++column) expectNear(first[column], second[column]);
}

/// Values 0..999 along x, labels 1 for x < 3 and 7 for x > 6.
io::Study study() {
  auto volume = std::make_shared<Volume>();
  auto labels = std::make_shared<LabelMap>();
  volume->grid = labels->grid = cube();
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  labels->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
  auto values = volume->voxels.as<std::int16_t>();
  auto marks = labels->voxels.as<std::uint8_t>();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto x = static_cast<int>(i % 10);
    values[i] = static_cast<std::int16_t>(111 * x);
    marks[i] = x < 3 ? 1 : x > 6 ? 7 : 0;
  }
  volume->computeRange();
  labels->labels = {{1, "first", {1, 0, 0}}, {7, "second", {0, 1, 0}}};
  io::Study made;
  made.scene.volume = volume;
  made.scene.labels = labels;
  made.scene.look.context.function.nodes = {{100.0, {{1, 1, 1}, 0.0}}, {200.0, {{1, 1, 1}, 1.0}}};
  return made;
}

/// Places a pair whose first camera looks from a side of cube().
void placeAt(ViewLink& link, StandardView side) {
  const Camera first = Camera::standard(side, cube());
  link.place({first, first.beside()});
}

TEST(ViewLink, SecondCameraStandsAQuarterTurnToThePatientsLeft) {
  ViewLink link;
  const Grid grid = cube();
  const Camera first = Camera::standard(StandardView::Anterior, grid);
  link.place({first, secondCamera(first, grid)});
  expectNear(link.camera(1).axes().forward, {-1, 0, 0});
  expectNear(link.camera(1).axes().up, {0, 0, 1});
  expectNear(link.camera(1).target, grid.centre());
}

TEST(ViewLink, SecondCameraIsUprightAndOrthogonalForAnObliqueFirst) {
  ViewLink link;
  const Camera first = Camera::fromAngles(50.0, 20.0, cube());
  link.place({first, secondCamera(first, cube())});
  EXPECT_NEAR(glm::dot(link.camera(0).axes().forward, link.camera(1).axes().forward), 0.0, tolerance);
  EXPECT_NEAR(link.camera(1).axes().right.z, 0.0, tolerance);
}

TEST(ViewLink, RotatingOneTurnsTheOtherByTheSameWorldRotation) {
  ViewLink link;
  placeAt(link, StandardView::Anterior);
  for (const int view : {0, 1}) {
    const std::array before{link.camera(0), link.camera(1)};
    link.orbit(view, 0.4, -0.7);
    expectSameTurn(before, link);
    const Camera orbited = before[static_cast<std::size_t>(view)].orbited(0.4, -0.7);
    expectNear(link.camera(view).eye, orbited.eye);
    expectNear(link.camera(view).axes().up, orbited.axes().up);
  }
}

TEST(ViewLink, UnlinkedViewStaysAndIsNotAnnounced) {
  ViewLink link;
  placeAt(link, StandardView::Anterior);
  link.setLinked(false);
  const Camera second = link.camera(1);
  QSignalSpy changed(&link, &ViewLink::changed);
  link.orbit(0, 0.4, 0.1);
  EXPECT_EQ(link.camera(1), second);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed.front().front().toInt(), 0);
}

TEST(ViewLink, StandardViewsFaceTheirSideAndKeepDistanceAndRelation) {
  ViewLink link;
  placeAt(link, StandardView::Anterior);
  link.orbit(0, 0.3, 0.2);
  for (const StandardView side : {StandardView::Posterior, StandardView::Superior, StandardView::Left}) {
    const std::array before{link.camera(0), link.camera(1)};
    link.face(0, side);
    const Camera wanted = Camera::standard(side, cube());
    expectNear(link.camera(0).axes().forward, wanted.axes().forward);
    expectNear(link.camera(0).axes().up, wanted.axes().up);
    EXPECT_NEAR(glm::distance(link.camera(0).eye, link.camera(0).target),
                glm::distance(before[0].eye, before[0].target), tolerance);
    expectSameTurn(before, link);
  }
}

TEST(ViewLink, ZoomIsSharedWhileLinked) {
  ViewLink link;
  placeAt(link, StandardView::Anterior);
  const auto distance = [&](int view) { return glm::distance(link.camera(view).eye, link.camera(view).target); };
  const std::array before{distance(0), distance(1)};
  const glm::dvec3 eye = link.camera(1).axes().forward;
  link.zoom(0, 2.0);
  EXPECT_NEAR(distance(0), before[0] / 2.0, tolerance);
  EXPECT_NEAR(distance(1), before[1] / 2.0, tolerance);
  expectNear(link.camera(1).axes().forward, eye);
  link.setLinked(false);
  link.zoom(1, 0.5);
  EXPECT_NEAR(distance(0), before[0] / 2.0, tolerance);
  EXPECT_NEAR(distance(1), before[1], tolerance);
}

TEST(ViewLink, ProjectionsShowTheTargetAtTheSameSize) {
  ViewLink link;
  placeAt(link, StandardView::Anterior);
  link.zoom(0, 2.5);
  const Camera before = link.camera(0);
  link.setProjection(Projection::Orthographic);
  const Camera parallel = link.camera(0);
  EXPECT_NEAR(parallel.orthographicHeight,
              2.0 * glm::distance(before.eye, before.target) * std::tan(glm::radians(before.verticalFov / 2.0)),
              tolerance);
  // Parallel rays start at the plane through the eye, which must lie in front of the whole volume at any zoom.
  EXPECT_GT(glm::distance(parallel.eye, parallel.target), cube().boundingRadius());
  link.setProjection(Projection::Perspective);
  expectNear(link.camera(0).eye, before.eye);
}

TEST(ViewLink, ResetGoesBackToWhatWasPlaced) {
  ViewLink link;
  placeAt(link, StandardView::Right);
  const std::array placed{link.camera(0), link.camera(1)};
  link.orbit(0, 1.0, 0.5);
  link.pan(1, 3.0, 4.0);
  link.reset();
  EXPECT_EQ(link.camera(0), placed[0]);
  EXPECT_EQ(link.camera(1), placed[1]);
}

TEST(SliceCursor, StepsByWholeSlicesAndStopsAtTheEnds) {
  SliceCursor cursor;
  cursor.setGrid(cube());
  const SliceGeometry axial = sliceGeometry(cube(), SlicePlane::Axial);
  cursor.moveTo({0.3, -0.4, 1.0});
  const int slice = cursor.slice(axial);
  cursor.step(axial, 1);
  EXPECT_EQ(cursor.slice(axial), slice + 1);
  EXPECT_NEAR(cursor.position().x, 0.3, tolerance);
  EXPECT_NEAR(cursor.position().y, -0.4, tolerance);
  cursor.step(axial, 100);
  EXPECT_EQ(cursor.slice(axial), axial.count - 1);
  cursor.step(axial, -100);
  EXPECT_EQ(cursor.slice(axial), 0);
}

TEST(SliceCursor, StaysInsideTheVolume) {
  SliceCursor cursor;
  cursor.setGrid(cube());
  cursor.moveTo({1e6, 0.0, -1e6});
  expectNear(cursor.position(), {9.0, 0.0, -9.0});
}

TEST(Document, TicksAndClicksMakeTheFocus) {
  Document document;
  document.open(study());
  QSignalSpy changed(&document, &Document::focusChanged);
  document.focusOn(7);
  document.setFocused(1, true);
  EXPECT_EQ(std::get<LabelFocus>(document.focus()).labels, (std::vector<std::uint16_t>{1, 7}));
  document.setFocused(1, true);
  EXPECT_EQ(changed.count(), 2) << "no signal without a change";
  document.setFocused(7, false);
  EXPECT_FALSE(document.isFocused(7));
  document.setFocused(1, false);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(document.focus()));
}

TEST(Document, NewLabelsTakeTheOldLabelsFocusAlong) {
  Document document;
  document.open(study());
  document.focusOn(7);
  document.setLabels(nullptr);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(document.focus()));
  document.setFocus(ValueFocus{.values = {0.0, 1.0}});
  document.setLabels(study().scene.labels);
  EXPECT_TRUE(std::holds_alternative<ValueFocus>(document.focus()));
}

TEST(Document, ShiftMovesTheTransferFunctionWithoutAdding) {
  Document document;
  document.open(study());
  document.setShift(50.0);
  document.setShift(-20.0);
  EXPECT_DOUBLE_EQ(document.scene().look.context.shifted().nodes[0].value, 80.0);
  EXPECT_DOUBLE_EQ(document.scene().look.context.shifted().nodes[1].value, 180.0);
}

TEST(Document, KeepsTheTransferFunctionWhenAnotherCannotBeRead) {
  Document document;
  document.open(study());
  const TransferFunction before = document.scene().look.context.shifted();
  EXPECT_THROW(document.setPreset("no-such-preset.json"), io::Error);
  EXPECT_EQ(document.scene().look.context.shifted(), before);
}

TEST(Document, LooksUpVoxelsAndLabelsByPlace) {
  Document document;
  document.open(study());
  EXPECT_EQ(document.voxelAt({-9.9, 0.0, 0.0})->x, 0);
  EXPECT_FALSE(document.voxelAt({-10.1, 0.0, 0.0}));
  EXPECT_FALSE(document.voxelAt({1e300, 0.0, 0.0}));
  ASSERT_NE(document.labelAt({9.0, 0.0, 0.0}), nullptr);
  EXPECT_EQ(document.labelAt({9.0, 0.0, 0.0})->name, "second");
  EXPECT_EQ(document.labelAt({0.0, 0.0, 0.0}), nullptr);
}

TEST(FramePacer, DrawsAtRestQualityWhereThatIsFastEnough) {
  FramePacer pacer;
  pacer.begin(pacer.atRest(), 0.0);
  pacer.drew(pacer.atRest(), FramePacer::budget / 5.0);
  pacer.end(FramePacer::budget / 4.0);
  EXPECT_EQ(pacer.moving(2), pacer.atRest());
  EXPECT_EQ(pacer.framesPerFollowing(), 1);
  EXPECT_FALSE(pacer.beforeRest());
}

/// The last of several frames of a drag, on a machine that needs `full` ms for a draft of a whole view, and `other` ms
/// for the rest of a frame. Milliseconds a frame; the views' efforts.
struct Paced {
  double frame = 0.0;
  Effort leader, follower;
};
Paced drag(FramePacer& pacer, double full, double other) {
  const auto cost = [&](Effort effort) { return full * effort.scale * effort.scale; };
  double now = 1000.0;
  Paced paced;
  for (int frame = 0; frame < 12; ++frame) {
    paced = {other, pacer.moving(2, true), pacer.moving(2, false)};
    for (const Effort& effort : {paced.leader, paced.follower}) {
      pacer.begin(effort, now);
      pacer.drew(effort, cost(effort));
      paced.frame += cost(effort);
    }
    now += paced.frame;
    pacer.end(now);
  }
  return paced;
}

TEST(FramePacer, ShrinksUntilTheFrameFitsItsBudget) {
  FramePacer pacer;
  const Paced paced = drag(pacer, 300.0, 20.0);
  EXPECT_EQ(paced.leader.quality, Quality::Draft);
  EXPECT_LE(paced.frame, FramePacer::budget);
  // Planned for 0.92 of it; a step down of a sixty-fourth in both scales, of about a third, takes a tenth of the time
  // of pictures.
  EXPECT_GT(paced.frame, 0.8 * FramePacer::budget);
  EXPECT_GT(paced.leader.scale, paced.follower.scale) << "more of the time is the view's that is turned";
  EXPECT_EQ(pacer.framesPerFollowing(), 1);
}

TEST(FramePacer, TheSizeOfPicturesStaysWhereTheirTimeHardlyChanges) {
  FramePacer pacer;
  drag(pacer, 300.0, 20.0);
  const Effort leader = pacer.moving(2, true);
  // Up to 5 % to either side, so that the planned scales cross a step somewhere.
  for (const double share : {0.95, 0.97, 1.0, 1.03, 1.05, 1.02, 0.98}) {
    drag(pacer, 300.0 * share, 20.0);
    EXPECT_EQ(pacer.moving(2, true), leader) << share;
  }
  drag(pacer, 200.0, 20.0);
  EXPECT_GT(pacer.moving(2, true).scale, leader.scale);
}

TEST(FramePacer, WhereThereIsNoTimeTheLinkedViewSkipsFrames) {
  FramePacer pacer;
  const Paced paced = drag(pacer, 960.0, 20.0);
  EXPECT_EQ(paced.leader.scale, FramePacer::leastScale);
  EXPECT_EQ(paced.follower.scale, FramePacer::leastFollowingScale);
  EXPECT_GT(paced.frame, FramePacer::budget);
  EXPECT_GT(pacer.framesPerFollowing(), 1);
  const double alone = paced.frame - 960.0 * paced.follower.scale * paced.follower.scale;
  EXPECT_LE(alone, FramePacer::budget) << "the other one keeps the rate";
}

TEST(FramePacer, TheLinkedViewRatherComesLateThanInEveryOtherFrame) {
  FramePacer pacer;
  const Paced paced = drag(pacer, 720.0, 20.0);
  EXPECT_GT(paced.frame, FramePacer::budget);
  EXPECT_EQ(pacer.framesPerFollowing(), 1);
}

TEST(FramePacer, TimeBesideThePicturesDoesNotShrinkThemWithoutEnd) {
  FramePacer pacer;
  EXPECT_GT(drag(pacer, 40.0, 200.0).leader.scale, FramePacer::leastScale);
}

TEST(FramePacer, UnusualTimesAreNoMeasure) {
  FramePacer pacer;
  const Effort before = pacer.moving(1);
  pacer.begin(before, 0.0);
  pacer.drew(before, 4000.0, false);
  pacer.end(4100.0);
  EXPECT_EQ(pacer.moving(1), before);
}

TEST(FramePacer, ADraftComesBeforeASlowPictureAtRest) {
  FramePacer pacer;
  drag(pacer, 400.0, 10.0);
  pacer.refined(pacer.atRest(), 2000.0);
  const std::optional<Effort> first = pacer.beforeRest();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->quality, Quality::Draft);
  EXPECT_GT(first->scale, pacer.moving(2).scale);
  EXPECT_LE(400.0 * first->scale * first->scale, FramePacer::firstAtRest);
  for (int i = 0; i < 20; ++i) pacer.refined(pacer.atRest(), 2.2 * FramePacer::firstAtRest);
  EXPECT_TRUE(pacer.beforeRest());
  for (int i = 0; i < 20; ++i) pacer.refined(pacer.atRest(), 1.8 * FramePacer::firstAtRest);
  EXPECT_FALSE(pacer.beforeRest()) << "fast enough now";
}

TEST(FramePacer, ViewsRefineInTurnTheLeaderFirst) {
  FramePacer pacer;
  pacer.lead(1);
  EXPECT_TRUE(pacer.leads(1));
  EXPECT_TRUE(pacer.mayRefine(0)) << "nothing is to be refined";
  pacer.refine(0, 0);
  EXPECT_TRUE(pacer.mayRefine(0));
  pacer.refine(1, 0);
  EXPECT_TRUE(pacer.mayRefine(1));
  EXPECT_FALSE(pacer.mayRefine(0));
  pacer.refine(1, 1);
  EXPECT_TRUE(pacer.mayRefine(0)) << "its first level comes before the other's second";
  EXPECT_FALSE(pacer.mayRefine(1));
  pacer.refine(0, std::nullopt);
  EXPECT_TRUE(pacer.mayRefine(1));
}

/// The events of DrawingTurns, in order: the number of a view, or -1 for the end of a round.
class ToldTurns {
 public:
  explicit ToldTurns(DrawingTurns& turns) {
    QObject::connect(&turns, &DrawingTurns::turn, &context_, [this](int view) { told_.push_back(view); });
    QObject::connect(&turns, &DrawingTurns::roundEnded, &context_, [this] { told_.push_back(-1); });
  }
  /// The events of one round of the event loop.
  std::vector<int> next() {
    told_.clear();
    QCoreApplication::processEvents();
    return told_;
  }
  QObject& context() { return context_; }

 private:
  QObject context_;
  std::vector<int> told_;
};

TEST(DrawingTurns, EachViewDrawsInAnEventOfItsOwnTheLeaderFirst) {
  FramePacer pacer;
  pacer.lead(1);
  DrawingTurns turns(pacer);
  ToldTurns told(turns);
  turns.ask(0);
  turns.ask(1);
  turns.ask(1);
  EXPECT_EQ(told.next(), std::vector<int>{1});
  EXPECT_EQ(told.next(), (std::vector<int>{0, -1}));
  EXPECT_TRUE(told.next().empty()) << "nothing is to be drawn";
  turns.ask(0);
  EXPECT_EQ(told.next(), (std::vector<int>{0, -1}));
}

TEST(DrawingTurns, ALeaderThatKeepsAskingDoesNotKeepTheOtherOneWaiting) {
  FramePacer pacer;
  DrawingTurns turns(pacer);
  ToldTurns told(turns);
  QObject::connect(&turns, &DrawingTurns::turn, &told.context(), [&](int view) {
    if (view == 0) turns.ask(0);
  });
  turns.ask(0);
  EXPECT_EQ(told.next(), (std::vector<int>{0, -1}));
  turns.ask(1);
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(told.next(), std::vector<int>{0}) << round;
    EXPECT_EQ(told.next(), (std::vector<int>{1, -1})) << round;
    turns.ask(1);
  }
}

/// Preferences are stored in a folder of the test's own.
void useScratchSettings() {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(tests::scratchFolder().string()));
  QCoreApplication::setOrganizationName(QStringLiteral("Fenestra tests"));
}

TEST(Preferences, RecentPathsAreLatestFirstOnceEachAndFew) {
  useScratchSettings();
  Preferences preferences;
  preferences.clearRecent();
  for (int i = 0; i < Preferences::recentCount + 3; ++i) preferences.addRecent("/data/" + std::to_string(i));
  preferences.addRecent("/data/Größe 頭部");
  preferences.addRecent("/data/9");
  const auto recent = preferences.recent();
  ASSERT_EQ(recent.size(), static_cast<std::size_t>(Preferences::recentCount));
  EXPECT_EQ(recent[0], "/data/9");
  EXPECT_EQ(recent[1], "/data/Größe 頭部");
  EXPECT_EQ(recent[2], "/data/10");
}

TEST(Preferences, TheTableIsInTheOrderOfItsNames) {
  for (std::size_t i = 0; i < preferenceTable().size(); ++i) {
    const PreferenceEntry& entry = preferenceTable()[i];
    EXPECT_EQ(static_cast<std::size_t>(entry.which), i);
    EXPECT_TRUE(*entry.key && *entry.name && *entry.description);
    EXPECT_TRUE(entry.low <= entry.otherwise && entry.otherwise <= entry.high && entry.low < entry.high) << entry.key;
  }
}

TEST(Preferences, AreStoredAndNonsenseCountsAsTheDefault) {
  useScratchSettings();
  for (const PreferenceEntry& entry : preferenceTable()) {
    Preferences preferences;
    QSignalSpy changed(&preferences, &Preferences::changed);
    EXPECT_EQ(preferences.value(entry.which), entry.otherwise);
    const int other = entry.otherwise == entry.high ? entry.low : entry.high;
    preferences.set(entry.which, other);
    preferences.set(entry.which, other);
    EXPECT_EQ(changed.size(), 1);
    EXPECT_EQ(Preferences().value(entry.which), other) << entry.key;
    preferences.set(entry.which, entry.high + 1000);
    EXPECT_EQ(preferences.value(entry.which), entry.high);
    if (entry.kind == PreferenceEntry::Kind::Switch) continue;
    QSettings().setValue(QLatin1String(entry.key), QStringLiteral("many"));
    EXPECT_EQ(preferences.value(entry.which), entry.otherwise);
    QSettings().setValue(QLatin1String(entry.key), entry.high + 1);
    EXPECT_EQ(preferences.value(entry.which), entry.otherwise);
  }
  Preferences preferences;
  preferences.restoreDefaults();
  for (const PreferenceEntry& entry : preferenceTable()) EXPECT_EQ(Preferences().value(entry.which), entry.otherwise);
}

TEST(Preferences, RecentDataAreForgottenWhereTheyAreNotKept) {
  useScratchSettings();
  Preferences preferences;
  preferences.addRecent("/data/one");
  preferences.set(Preference::KeepsRecent, 0);
  EXPECT_TRUE(Preferences().recent().empty());
  preferences.addRecent("/data/two");
  EXPECT_TRUE(Preferences().recent().empty());
  preferences.restoreDefaults();
}

TEST(Preferences, APathOpenedWhileThePatientIsHiddenIsNotStored) {
  useScratchSettings();
  Preferences preferences;
  preferences.addRecent("/data/phantom");
  preferences.set(Preference::HidesPatient, 1);
  preferences.addRecent("/data/Vermeer Johanna");
  preferences.addRecent("/data/phantom");
  const std::vector<std::filesystem::path> both{"/data/phantom", "/data/Vermeer Johanna"}, shown{"/data/phantom"};
  EXPECT_EQ(preferences.recent(), both) << "this run knows it";
  EXPECT_EQ(Preferences().recent(), shown);
  preferences.set(Preference::HidesPatient, 0);
  EXPECT_EQ(Preferences().recent(), shown);
  preferences.addRecent("/data/Vermeer Johanna");
  EXPECT_EQ(Preferences().recent().size(), 2u) << "opened again, not hidden";
  preferences.clearRecent();
  EXPECT_TRUE(preferences.recent().empty());
}

TEST(Preferences, DefaultsOfTheLookAreTheUsers) {
  Preferences preferences(Preferences::Mode::Transient);
  Look look;
  look.cutaway.openWidth = 17.0;
  const Look ofScene = look;
  EXPECT_EQ(preferences.startingLook(ofScene), look) << "else, without a choice, those of a scene";
  preferences.set(Preference::Background, 0xff8000);
  preferences.set(Preference::WidthUnit, 1);
  look.background = glm::dvec3(1.0, 128.0 / 255.0, 0.0);
  look.cutaway.unit = WidthUnit::Millimetre;
  EXPECT_EQ(preferences.startingLook(ofScene), look);
}

TEST(Preferences, QualityAtRestIsRememberedAndNonsenseIsNot) {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(tests::scratchFolder().string()));
  QCoreApplication::setOrganizationName(QStringLiteral("Fenestra tests"));
  Preferences preferences;
  for (const Effort& effort : {Effort{.maxError = 2.0}, Effort{.quality = Quality::Draft}, Effort{}}) {
    preferences.setAtRest(effort);
    EXPECT_EQ(Preferences().atRest(), effort);
  }
  QSettings().setValue(QStringLiteral("picture/quality"), 77);
  QSettings().setValue(QStringLiteral("picture/maxError"), QStringLiteral("nan"));
  EXPECT_EQ(Preferences().atRest(), Effort{});
}

TEST(ActiveTool, OneModeAtMostHasTheLeftButton) {
  StrokeMode first, second, third;
  ActiveTool tool({&first, &second, &third});
  const auto active = [&] { return int{first.isActive()} + int{second.isActive()} + int{third.isActive()}; };
  int most = 0;
  QObject::connect(&tool, &ActiveTool::changed, &tool, [&] { most = std::max(most, active()); });
  EXPECT_EQ(tool.mode(), nullptr);
  EXPECT_FALSE(tool.putDown());
  for (StrokeMode* mode : {&first, &second, &third, &first}) {
    mode->setActive(true);
    EXPECT_EQ(tool.mode(), mode);
    EXPECT_EQ(active(), 1);
  }
  EXPECT_EQ(most, 1) << "also while listeners hear of it";
  EXPECT_TRUE(tool.putDown());
  EXPECT_EQ(tool.mode(), nullptr);
  EXPECT_EQ(active(), 0);
}

TEST(FramePacer, TellsTheLastFrameAndForgetsWhatAnotherQualityCost) {
  FramePacer pacer;
  pacer.begin(pacer.atRest(), 100.0);
  pacer.drew(pacer.atRest(), 2.0);
  pacer.begin(pacer.atRest(), 103.0);
  pacer.drew(pacer.atRest(), 3.0);
  pacer.end(110.0);
  ASSERT_TRUE(pacer.last());
  EXPECT_EQ(pacer.last()->milliseconds, 10.0);
  EXPECT_EQ(pacer.last()->views, 2);
  EXPECT_EQ(pacer.moving(1), pacer.atRest());
  pacer.setAtRest(Quality::Normal, 1.0);
  EXPECT_EQ(pacer.atRest().maxError, 1.0);
  EXPECT_LT(pacer.moving(1).scale, 1.0) << "pictures of that quality have not been measured";
}

}  // namespace
}  // namespace fenestra::viewer::modelTest
