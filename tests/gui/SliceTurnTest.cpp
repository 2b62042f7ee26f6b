// Slices that are flipped, turned, in true size and played: what shows, letters, measures and clicks stay right.

#include <cmath>
#include <set>

#include <QAction>
#include <QLabel>
#include <QScreen>
#include <QSignalSpy>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "viewer/views/Cine.h"

namespace fenestra::viewer::sliceTurnTest {
namespace {

class SliceTurn : public Window {
 protected:
  SliceView* axial() { return slice(SlicePlane::Axial); }
  /// Where the marker is in the axial slice, from -1 to 1 across and down.
  QPointF place() {
    const std::optional<QPointF> at = green(axial());
    EXPECT_TRUE(at);
    return at.value_or(QPointF());
  }
  /// The picture shows the marker where the view says that it is, and a click there finds it.
  void expectConsistent() {
    const QPointF said = axial()->widgetFromWorld(markerCentre), middle = QRectF(axial()->rect()).center();
    const QPointF seen = place();
    EXPECT_NEAR(seen.x(), (said.x() - middle.x()) / middle.x(), 0.03);
    EXPECT_NEAR(seen.y(), (said.y() - middle.y()) / middle.y(), 0.03);
    EXPECT_LT(glm::distance(axial()->worldFromWidget(said), markerCentre), 1.5) << "within the slice's thickness";
    const glm::dvec3 right = axial()->worldFromWidget(middle + QPointF(10, 0)) - axial()->worldFromWidget(middle);
    EXPECT_LT(glm::distance(glm::normalize(right), glm::normalize(axial()->screenRight())), 1e-9)
        << "which the letters are drawn by";
    const glm::dvec3 down = axial()->worldFromWidget(middle + QPointF(0, 10)) - axial()->worldFromWidget(middle);
    EXPECT_LT(glm::distance(glm::normalize(down), glm::normalize(axial()->screenDown())), 1e-9);
  }
};

}  // namespace

TEST_F(SliceTurn, FlipsAndTurnsShowAndAnswerAlike) {
  document().focusOn(marker);  // its tint is strong enough to be told from white
  cursor().moveTo(markerCentre);
  waitUntilDrawn();
  const QPointF before = place();
  ASSERT_GT(before.x(), 0.1) << "to the patient's left, which is right on the screen";
  ASSERT_LT(before.y(), -0.1) << "anterior, which is up";
  expectConsistent();
  axial()->flipAcross();
  EXPECT_NEAR(place().x(), -before.x(), 0.03);
  EXPECT_NEAR(place().y(), before.y(), 0.03);
  expectConsistent();
  axial()->flipDown();
  EXPECT_NEAR(place().x(), -before.x(), 0.03);
  EXPECT_NEAR(place().y(), -before.y(), 0.03);
  expectConsistent();
  axial()->resetView();
  EXPECT_NEAR(place().x(), before.x(), 0.03);
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const QPointF last = axial()->widgetFromWorld(markerCentre) - QRectF(axial()->rect()).center();
    axial()->turnClockwise();
    const QPointF now = axial()->widgetFromWorld(markerCentre) - QRectF(axial()->rect()).center();
    EXPECT_GT(last.x() * now.y() - last.y() * now.x(), 0.0) << "clockwise, as y goes down";
    expectConsistent();
    // A flip of what shows, however it is turned.
    axial()->flipAcross();
    const QPointF flipped = axial()->widgetFromWorld(markerCentre) - QRectF(axial()->rect()).center();
    EXPECT_NEAR(flipped.x(), -now.x(), 1e-6);
    EXPECT_NEAR(flipped.y(), now.y(), 1e-6);
    expectConsistent();
    axial()->flipAcross();
  }
  EXPECT_EQ(axial()->turn(), SliceView::Turn{}) << "four quarters are none";
}

TEST_F(SliceTurn, TheMouseMovesATurnedPictureWithIt) {
  cursor().moveTo(markerCentre);
  axial()->turnClockwise();
  axial()->flipAcross();
  const glm::dvec3 held = axial()->worldFromWidget({100, 100});
  drag(axial(), {100, 100}, {140, 80}, Qt::MiddleButton);
  EXPECT_LT(glm::distance(axial()->worldFromWidget({140, 80}), held), 1e-6);
  const glm::dvec3 fixed = axial()->worldFromWidget(QRectF(axial()->rect()).center());
  wheel(axial(), 2, Qt::ControlModifier);
  EXPECT_LT(glm::distance(axial()->worldFromWidget(QRectF(axial()->rect()).center()), fixed), 0.5)
      << "zoomed around the mouse, up to half a pixel";
  QTest::mouseClick(axial(), Qt::LeftButton, {}, axial()->widgetFromWorld(markerCentre).toPoint());
  EXPECT_TRUE(document().isFocused(marker));
}

TEST_F(SliceTurn, AMeasureIsAsLongHoweverThePictureLies) {
  cursor().moveTo(markerCentre);
  const QPoint from(120, 110), to(180, 150);
  const double before = glm::distance(axial()->worldFromWidget(from), axial()->worldFromWidget(to));
  for (int quarter = 0; quarter < 4; ++quarter) {
    axial()->turnClockwise();
    // The view is not square, so a turned slice fits at another scale.
    const double wanted =
        quarter % 2 == 1 ? before
                         : glm::distance(axial()->worldFromWidget({120, 110}), axial()->worldFromWidget({180, 150}));
    window_->workspace().measuring.toggle(MeasureKind::Distance);
    drag(axial(), from, to);
    window_->workspace().measuring.stop();
    ASSERT_EQ(document().measures().size(), 1u);
    const Measure& drawn = document().measures().front();
    EXPECT_NEAR(glm::distance(drawn.points[0], drawn.points[1]), wanted, 1e-6);
    EXPECT_LT((axial()->widgetFromWorld(drawn.points[0]) - QPointF(from)).manhattanLength(), 1e-6);
    document().setMeasures({}, {});
  }
}

TEST_F(SliceTurn, NeurologicalHasLeftOnTheLeftAndSaysSo) {
  document().focusOn(marker);
  cursor().moveTo(markerCentre);
  waitUntilDrawn();
  const QPointF before = place();
  window_->workspace().preferences.set(Preference::Neurological, 1);
  EXPECT_NEAR(place().x(), -before.x(), 0.03);
  expectConsistent();
  EXPECT_LT(axial()->screenRight().x, 0.0);
  EXPECT_LT(slice(SlicePlane::Coronal)->screenRight().x, 0.0);
  EXPECT_EQ(slice(SlicePlane::Sagittal)->turn(), SliceView::Turn{}) << "which has neither left nor right";
  bool named = false;
  for (const QLabel* label : window_->findChildren<QLabel*>())
    named |= label->isVisible() && label->text() == QStringLiteral("Neurological convention");
  EXPECT_TRUE(named);
  axial()->flipAcross();
  EXPECT_GT(axial()->screenRight().x, 0.0);
  window_->workspace().preferences.set(Preference::Neurological, 0);
}

TEST_F(SliceTurn, TrueSizeIsThatOfTheScreen) {
  const QSizeF millimetres = axial()->screen()->physicalSize();
  const double perMm = axial()->screen()->geometry().width() / millimetres.width();
  ASSERT_TRUE(axial()->showTrueSize());
  const QPointF a = axial()->widgetFromWorld({0, 0, 0}), b = axial()->widgetFromWorld({10, 0, 0});
  EXPECT_NEAR(std::hypot(b.x() - a.x(), b.y() - a.y()), 10.0 * perMm, 1e-6);
  EXPECT_TRUE(axial()->isTrueSize());
  wheel(axial(), 1, Qt::ControlModifier);
  EXPECT_FALSE(axial()->isTrueSize());
}

TEST_F(SliceTurn, CinePlaysAllSlicesRoundAndStops) {
  cursor().moveTo({0, 0, 0});
  Cine cine(cursor());
  cine.setSlicesPerSecond(60);
  std::set<int> seen;
  QObject::connect(&cursor(), &SliceCursor::moved, &cine, [&] { seen.insert(axial()->slice()); });
  cine.play(*axial());
  EXPECT_TRUE(QTest::qWaitFor([&] { return seen.size() == 48u; }, patience)) << seen.size() << " of 48";
  EXPECT_TRUE(cine.stop());
  EXPECT_FALSE(cine.stop());
  const int speed = cine.slicesPerSecond();
  cine.changeSpeed(1);
  EXPECT_EQ(cine.slicesPerSecond(), speed) << "the fastest";
  cine.changeSpeed(-1);
  EXPECT_LT(cine.slicesPerSecond(), speed);
  cine.play(*axial());
  views().arrange(*findArrangement("pair"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !cine.isPlaying(); }, patience)) << "out of sight";
}

}  // namespace fenestra::viewer::sliceTurnTest
