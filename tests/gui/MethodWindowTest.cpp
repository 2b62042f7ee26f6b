// Choosing a method in the window: its own rows, pictures, undo, sessions, and what it does not have.

#include <utility>

#include <QComboBox>
#include <QSpinBox>
#include <QTest>

#include "rendering/settings/Settings.h"
#include "tests/gui/PseudoLocale.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/panels/CarvingRows.h"
#include "viewer/panels/ContextLayerPanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/ImportanceList.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer::methodWindowTest {
namespace {

class MethodWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    if (HasFatalFailure() || IsSkipped()) return;
    setAutomatic(false);
    document().focusOn(marker);
    waitUntilDrawn();
  }
  template <class Control>
  Control* control(const char* key) {
    auto* found = panel<CutawayPanel>().findChild<Control*>(QLatin1String(key));
    EXPECT_NE(found, nullptr) << key;
    return found;
  }
  /// As a click on an entry of the list does.
  template <class E>
  void choose(const char* key, E value) {
    auto* box = control<QComboBox>(key);
    const int row = box->findData(static_cast<int>(value));
    box->setCurrentIndex(row);
    Q_EMIT box->activated(row);
  }
  bool shows(const char* key) { return control<QWidget>(key)->isVisibleTo(&panel<CutawayPanel>()); }
};

TEST_F(MethodWindow, ListsEachMethodWithAToolTip) {
  const auto* box = control<QComboBox>("kind");
  ASSERT_EQ(box->count(), static_cast<int>(wordsOf(MethodKind{}).size()));
  for (int row = 0; row < box->count(); ++row)
    EXPECT_GT(box->itemData(row, Qt::ToolTipRole).toString().size(), 40) << row;
}

TEST_F(MethodWindow, NothingMovesUnderTheMouseWhenAMethodIsChosen) {
  const auto* box = control<QComboBox>("kind");
  // From top to bottom: longer labels may take some of a control's width.
  const auto place = [](const QWidget* widget) {
    return std::pair(widget->mapToGlobal(QPoint()).y(), widget->height());
  };
  const auto before = place(box), width = place(control<SliderSpin>("open_width"));
  forEachMethod([&]<class M>() {
    choose("kind", kindOf<M>);
    // Layouts run when their events are delivered.
    QApplication::processEvents();
    EXPECT_EQ(place(box), before) << M::word;
    EXPECT_EQ(place(control<SliderSpin>("open_width")), width) << M::word;
  });
}

TEST_F(MethodWindow, ShowsARowOfEachSettingOfTheChosenMethodAlone) {
  forEachMethod([&]<class Chosen>() {
    choose("kind", kindOf<Chosen>);
    forEachMethod([&]<class M>() {
      int rows = 0;
      forEachSetting<M>([&](const auto& setting) { rows += shows(setting.key); });
      const auto settings = static_cast<int>(std::tuple_size_v<decltype(settingsOf<M>)>);
      if (!std::same_as<M, Chosen>)
        EXPECT_EQ(rows, 0) << Chosen::word << " shows rows of " << M::word;
      else if (std::same_as<M, methods::Importance>)
        EXPECT_EQ(rows, 2) << "some have a meaning for one of its modes alone";
      else
        EXPECT_EQ(rows, settings) << M::word;
    });
  });
}

TEST_F(MethodWindow, ParametersOutliveAnotherMethodAndComeBackByUndo) {
  const auto method = [&]() -> const Method& { return document().look().method; };
  const int steps = document().undoStack().index();
  choose("kind", kindOf<methods::Cone>);
  control<SliderSpin>("cone_angle")->box()->setValue(60.0);
  choose("kind", kindOf<methods::ClearView>);
  control<SliderSpin>("lens_radius")->box()->setValue(40.0);
  choose("kind", kindOf<methods::Cone>);
  EXPECT_EQ(method().chosen(), ChosenMethod(methods::Cone{.angle = 60.0}));
  EXPECT_EQ(control<SliderSpin>("cone_angle")->value(), 60.0);
  control<SliderSpin>("cone_angle")->box()->setValue(20.0);
  EXPECT_EQ(document().undoStack().index(), steps + 6);

  document().undoStack().undo();
  EXPECT_EQ(method().chosen(), ChosenMethod(methods::Cone{.angle = 60.0}));
  document().undoStack().undo();
  EXPECT_EQ(method().chosen(), ChosenMethod(methods::ClearView{.radius = 40.0}));
  EXPECT_EQ(control<SliderSpin>("lens_radius")->value(), 40.0);
  document().undoStack().undo();
  EXPECT_EQ(method().chosen(), ChosenMethod(methods::ClearView{}));
  document().undoStack().undo();
  EXPECT_EQ(method().chosen(), ChosenMethod(methods::Cone{.angle = 60.0}));
  document().undoStack().undo();
  EXPECT_EQ(method().chosen(), ChosenMethod(methods::Cone{}));
  document().undoStack().undo();
  EXPECT_EQ(method(), Method());
  EXPECT_EQ(control<SliderSpin>("cone_angle")->value(), methods::Cone{}.angle);
  while (document().undoStack().canRedo()) document().undoStack().redo();
  EXPECT_EQ(method().chosen(), ChosenMethod(methods::Cone{.angle = 20.0}));
}

TEST_F(MethodWindow, Thorough_EachHasItsOwnRowsAndIsAStepOfTheHistory) {
  const QImage adaptive = picture(volume(0));
  auto* width = control<SliderSpin>("open_width");
  EXPECT_TRUE(width->isEnabled());
  const int steps = document().undoStack().index();

  choose("kind", kindOf<methods::Cone>);
  EXPECT_EQ(document().look().method.kind, kindOf<methods::Cone>);
  EXPECT_EQ(document().undoStack().index(), steps + 1);
  EXPECT_TRUE(shows("cone_angle"));
  EXPECT_FALSE(shows("importance"));
  EXPECT_FALSE(width->isEnabled());
  EXPECT_TRUE(width->toolTip().contains(QStringLiteral("no width")));
  EXPECT_TRUE(control<SliderSpin>("border_width")->isEnabled());
  waitUntilDrawn();
  const QImage cone = picture(volume(0));
  EXPECT_NE(cone, adaptive);
  control<SliderSpin>("cone_angle")->box()->setValue(60.0);
  EXPECT_EQ(document().look().method.of<methods::Cone>().angle, 60.0);
  waitUntilDrawn();
  EXPECT_NE(picture(volume(0)), cone);

  choose("kind", kindOf<methods::Importance>);
  EXPECT_FALSE(shows("cone_angle"));
  EXPECT_TRUE(shows("importance") && shows("importance_angle"));
  EXPECT_FALSE(shows("importance_opacity") || shows("sparseness"));
  choose("importance", ImportanceMode::Average);
  EXPECT_TRUE(shows("importance_opacity") && shows("sparseness"));
  EXPECT_FALSE(shows("importance_angle"));
  choose("sparseness", Sparseness::ScreenDoor);
  EXPECT_EQ(document().look().method.of<methods::Importance>().sparseness, Sparseness::ScreenDoor);
  waitUntilDrawn();
  EXPECT_NE(picture(volume(0)), adaptive);

  while (document().undoStack().index() > steps) document().undoStack().undo();
  EXPECT_EQ(document().look().method, Method());
  EXPECT_FALSE(shows("importance") || shows("cone_angle"));
  EXPECT_TRUE(width->isEnabled());
  waitUntilDrawn();
  ASSERT_EQ(picture(volume(0)).size(), adaptive.size()) << "the panel's rows leave the views their place";
  EXPECT_EQ(picture(volume(0)), adaptive) << "to the bit";
}

TEST_F(MethodWindow, Thorough_LabelsHaveLevelsOfImportance) {
  auto& list = *panel<CutawayPanel>().findChild<ImportanceList*>();
  EXPECT_FALSE(list.isVisibleTo(&panel<CutawayPanel>()));
  const int width = panel<CutawayPanel>().width();
  choose("kind", kindOf<methods::Importance>);
  EXPECT_TRUE(list.isVisibleTo(&panel<CutawayPanel>()));
  waitUntilDrawn();
  EXPECT_EQ(panel<CutawayPanel>().width(), width);
  const QImage one = picture(volume(0));
  const int steps = document().undoStack().index();
  ASSERT_EQ(list.table()->rowCount(), 1) << "the focus";
  const auto box = [&](int row) { return qobject_cast<QSpinBox*>(list.table()->cellWidget(row, 1)); };
  EXPECT_EQ(box(0)->value(), mostImportant);

  // A label that the focus lies in gets a level, and then another one.
  ASSERT_GT(list.more()->count(), 0);
  const auto other = static_cast<std::uint16_t>(list.more()->itemData(0).toUInt());
  Q_EMIT list.more()->activated(0);
  EXPECT_EQ(document().labelSetting(other).importance, 1);
  EXPECT_EQ(document().undoStack().index(), steps + 1);
  ASSERT_EQ(list.table()->rowCount(), 2);
  waitUntilDrawn();
  EXPECT_NE(picture(volume(0)), one);
  const int row =
      document().isFocused(static_cast<std::uint16_t>(list.table()->item(0, 0)->data(Qt::UserRole).toUInt())) ? 1 : 0;
  box(row)->setValue(2);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().labelSetting(other).importance == 2; }, patience));
  // A label of level 0 is like all that has no level.
  box(row)->setValue(0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return list.table()->rowCount() == 1; }, patience));
  EXPECT_EQ(document().labelSetting(other), LabelSetting{.label = other});
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), one) << "to the bit";
  document().undoStack().undo();
  EXPECT_EQ(list.table()->rowCount(), 2);

  choose("kind", kindOf<methods::Adaptive>);
  EXPECT_FALSE(list.isVisibleTo(&panel<CutawayPanel>()));
}

TEST_F(MethodWindow, Thorough_ClearViewHasALensInPlaceOfWidthAndBorder) {
  const QImage adaptive = picture(volume(0));
  const int steps = document().undoStack().index(), width = panel<CutawayPanel>().width();
  choose("kind", kindOf<methods::ClearView>);
  waitUntilDrawn();
  EXPECT_EQ(panel<CutawayPanel>().width(), width);
  for (const char* key : {"lens_radius", "lens_place", "lens_bends", "lens_fade", "lens_rim"})
    EXPECT_TRUE(shows(key)) << key;
  for (const char* key : {"cone_angle", "importance", "importance_angle"}) EXPECT_FALSE(shows(key)) << key;
  for (const char* key : {"open_width", "border_width", "border_colour"})
    EXPECT_FALSE(control<QWidget>(key)->isEnabled()) << key;
  EXPECT_TRUE(control<SliderSpin>("border_width")->toolTip().contains(QStringLiteral("rim")));
  QImage before = picture(volume(0));
  EXPECT_NE(before, adaptive);
  const auto expectChanged = [&](const char* what) {
    waitUntilDrawn();
    const QImage now = picture(volume(0));
    EXPECT_NE(now, before) << what;
    before = now;
  };
  control<SliderSpin>("lens_radius")->box()->setValue(40.0);
  EXPECT_EQ(document().look().method.of<methods::ClearView>().radius, 40.0);
  expectChanged("radius");
  control<SliderSpin>("lens_bends")->box()->setValue(0.0);
  EXPECT_EQ(document().look().method.of<methods::ClearView>().bends, 0.0);
  expectChanged("bends");
  control<QDoubleSpinBox>("lens_rim")->setValue(10.0);
  EXPECT_EQ(document().look().method.of<methods::ClearView>().rim, 10.0);
  expectChanged("rim");
  choose("lens_fade", LensFade::Curvature);
  EXPECT_EQ(document().look().method.of<methods::ClearView>().fade, LensFade::Curvature);
  expectChanged("fade");
  choose("lens_place", LensPlace::OverCrosshair);
  waitUntilDrawn();
  before = picture(volume(0));
  const glm::dvec3 crosshair = cursor().position();
  cursor().moveTo(document().scene().volume->grid.centre() + glm::dvec3(20.0, -10.0, 15.0));
  expectChanged("crosshair");
  cursor().moveTo(crosshair);
  EXPECT_EQ(document().undoStack().index(), steps + 6);
  while (document().undoStack().index() > steps) document().undoStack().undo();
  EXPECT_TRUE(control<SliderSpin>("border_width")->isEnabled());
  EXPECT_FALSE(control<SliderSpin>("border_width")->toolTip().contains(QStringLiteral("rim")));
  waitUntilDrawn();
  ASSERT_EQ(picture(volume(0)).size(), adaptive.size());
  EXPECT_EQ(picture(volume(0)), adaptive) << "to the bit";
}

TEST_F(MethodWindow, Thorough_ContextPreservingCutsNothingAway) {
  const QImage adaptive = picture(volume(0));
  const int steps = document().undoStack().index(), width = panel<CutawayPanel>().width();
  const bool hasEdges = panel<ContextLayerPanel>().isEnabled();
  choose("kind", kindOf<methods::ContextPreserving>);
  waitUntilDrawn();
  EXPECT_EQ(panel<CutawayPanel>().width(), width);
  for (const char* key : {"fade_reach", "fade_sharpness"}) EXPECT_TRUE(shows(key)) << key;
  for (const char* key : {"cone_angle", "importance", "importance_angle", "lens_radius", "focal_size"})
    EXPECT_FALSE(shows(key)) << key;
  for (const char* key : {"open_width", "border_width", "border_colour", "axis_offset", "axis_direction", "unit"})
    EXPECT_FALSE(control<QWidget>(key)->isEnabled()) << key;
  for (const char* key : {"open_width", "border_width"})
    EXPECT_TRUE(control<SliderSpin>(key)->toolTip().contains(QStringLiteral("cuts nothing away"))) << key;
  EXPECT_TRUE(hasEdges);
  EXPECT_FALSE(panel<ContextLayerPanel>().isEnabled());
  QImage before = picture(volume(0));
  EXPECT_NE(before, adaptive);
  for (const char* key : {"fade_reach", "fade_sharpness"}) {
    control<SliderSpin>(key)->box()->setValue(1.5);
    waitUntilDrawn();
    EXPECT_NE(picture(volume(0)), before) << key;
    before = picture(volume(0));
  }
  EXPECT_EQ(document().look().method.of<methods::ContextPreserving>().reach, 1.5);
  EXPECT_EQ(document().look().method.of<methods::ContextPreserving>().sharpness, 1.5);
  // Without a focus there is something to see, too.
  document().setFocus({});
  waitUntilDrawn();
  const QImage faded = picture(volume(0));
  control<SliderSpin>("fade_reach")->box()->setValue(0.0);
  waitUntilDrawn();
  EXPECT_NE(picture(volume(0)), faded);
  while (document().undoStack().index() > steps) document().undoStack().undo();
  EXPECT_TRUE(control<SliderSpin>("open_width")->isEnabled() && panel<ContextLayerPanel>().isEnabled());
  waitUntilDrawn();
  ASSERT_EQ(picture(volume(0)).size(), adaptive.size());
  EXPECT_EQ(picture(volume(0)), adaptive) << "to the bit";
}

TEST_F(MethodWindow, Thorough_AFocalRegionHasAShapeASizeAndAFallOff) {
  const QImage adaptive = picture(volume(0));
  const int steps = document().undoStack().index(), width = panel<CutawayPanel>().width();
  choose("kind", kindOf<methods::FocalRegion>);
  waitUntilDrawn();
  EXPECT_EQ(panel<CutawayPanel>().width(), width);
  for (const char* key : {"focal_shape", "focal_size", "focal_fall_off"}) EXPECT_TRUE(shows(key)) << key;
  for (const char* key : {"fade_reach", "fade_sharpness", "lens_radius"}) EXPECT_FALSE(shows(key)) << key;
  EXPECT_FALSE(control<SliderSpin>("open_width")->isEnabled() || panel<ContextLayerPanel>().isEnabled());
  QImage before = picture(volume(0));
  EXPECT_NE(before, adaptive);
  const auto expectChange = [&](const char* key) {
    waitUntilDrawn();
    EXPECT_NE(picture(volume(0)), before) << key;
    before = picture(volume(0));
  };
  control<SliderSpin>("focal_size")->box()->setValue(12.0);
  expectChange("focal_size");
  control<SliderSpin>("focal_fall_off")->box()->setValue(9.0);
  expectChange("focal_fall_off");
  choose("focal_shape", FocalShape::Box);
  expectChange("focal_shape");
  const Method& method = document().look().method;
  EXPECT_TRUE(method.of<methods::FocalRegion>().size == 12.0 && method.of<methods::FocalRegion>().fallOff == 9.0 &&
              method.of<methods::FocalRegion>().shape == FocalShape::Box);
  // Without a focus, the region lies in the middle of the volume.
  document().setFocus({});
  expectChange("focus");
  control<SliderSpin>("focal_size")->box()->setValue(30.0);
  expectChange("focal_size, without a focus");
  while (document().undoStack().index() > steps) document().undoStack().undo();
  waitUntilDrawn();
  ASSERT_EQ(picture(volume(0)).size(), adaptive.size());
  EXPECT_EQ(picture(volume(0)), adaptive) << "to the bit";
}

TEST_F(MethodWindow, WallsFollowTheSlices) {
  const QImage adaptive = picture(volume(0));
  const int steps = document().undoStack().index(), width = panel<CutawayPanel>().width();
  const glm::dvec3 crosshair = cursor().position();
  const WindowLevel window = document().window();
  choose("kind", kindOf<methods::Walls>);
  waitUntilDrawn();
  EXPECT_EQ(panel<CutawayPanel>().width(), width);
  for (const char* key : {"wall_placement", "wall_axial", "wall_sagittal", "wall_coronal", "wall_outlines"})
    EXPECT_TRUE(shows(key)) << key;
  EXPECT_TRUE(control<SliderSpin>("open_width")->isEnabled());
  std::array<QImage, 2> before{picture(volume(0)), picture(volume(1))};
  EXPECT_NE(before[0], adaptive);
  const auto expectChange = [&](const char* what) {
    waitUntilDrawn();
    for (const int view : {0, 1}) {
      EXPECT_NE(picture(volume(view)), before[static_cast<std::size_t>(view)]) << what << ", C" << view + 1;
      before[static_cast<std::size_t>(view)] = picture(volume(view));
    }
  };
  cursor().step(sliceGeometry(document().scene().volume->grid, SlicePlane::Axial), 3);
  expectChange("another slice");
  document().setWindow({0.5 * window.width, window.level});
  expectChange("another window");
  document().setInverted(true);
  expectChange("inverted");
  const WallTool::Handle handle = volume(0)->wallTool().handles().at(1);
  EXPECT_EQ(handle.plane, SlicePlane::Sagittal);
  EXPECT_EQ(volume(0)->wallTool().handles().size(), 3u);
  const QPoint from = volume(0)->widgetFromWorld(handle.at)->toPoint();
  const QPoint to = volume(0)->widgetFromWorld(handle.at + 6.0 * handle.along)->toPoint();
  const glm::dvec3 start = cursor().position();
  drag(volume(0), from, to);
  EXPECT_NEAR(cursor().position().x - start.x, 6.0, 1.0) << "to the pixel";
  expectChange("dragged");
  control<QCheckBox>("wall_axial")->click();
  EXPECT_FALSE(document().look().method.of<methods::Walls>().axial);
  EXPECT_EQ(volume(0)->wallTool().handles().size(), 2u);
  expectChange("without the axial wall");
  choose("wall_placement", WallPlacement::Inside);
  waitUntilDrawn();
  EXPECT_NE(picture(volume(0)), before[0]);
  while (document().undoStack().index() > steps) document().undoStack().undo();
  EXPECT_TRUE(volume(0)->wallTool().handles().empty());
  cursor().moveTo(crosshair);
}

TEST_F(MethodWindow, Thorough_AnExplodedViewHasADegreeAndPlanes) {
  cameras().setAnimated(false);
  cameras().orbit(0, 0.3, 0.2);  // the patient's axes are not the view's
  waitUntilDrawn();
  const QImage adaptive = picture(volume(0));
  const int steps = document().undoStack().index(), width = panel<CutawayPanel>().width();
  choose("kind", kindOf<methods::Explode>);
  waitUntilDrawn();
  EXPECT_EQ(panel<CutawayPanel>().width(), width);
  for (const char* key : {"explosion", "explosion_planes", "explosion_axes"}) EXPECT_TRUE(shows(key)) << key;
  for (const char* key : {"focal_size", "fade_reach", "lens_radius"}) EXPECT_FALSE(shows(key)) << key;
  EXPECT_FALSE(control<SliderSpin>("open_width")->isEnabled() || panel<ContextLayerPanel>().isEnabled());
  QImage before = picture(volume(0));
  EXPECT_NE(before, adaptive);
  const auto expectChange = [&](const char* key) {
    waitUntilDrawn();
    EXPECT_NE(picture(volume(0)), before) << key;
    before = picture(volume(0));
  };
  control<SliderSpin>("explosion")->box()->setValue(0.9);
  expectChange("explosion");
  choose("explosion_planes", ExplosionPlanes::Three);
  expectChange("explosion_planes");
  choose("explosion_axes", ExplosionAxes::View);
  expectChange("explosion_axes");
  const Method& method = document().look().method;
  EXPECT_TRUE(method.of<methods::Explode>().degree == 0.9 &&
              method.of<methods::Explode>().planes == ExplosionPlanes::Three &&
              method.of<methods::Explode>().axes == ExplosionAxes::View);
  document().setFocus({});
  expectChange("focus");
  while (document().undoStack().index() > steps) document().undoStack().undo();
}

TEST_F(MethodWindow, Thorough_AGhostedSelectionKeepsEdgesInItsOpening) {
  const QImage adaptive = picture(volume(0));
  const int steps = document().undoStack().index(), width = panel<CutawayPanel>().width();
  choose("kind", kindOf<methods::Selection>);
  waitUntilDrawn();
  EXPECT_EQ(panel<CutawayPanel>().width(), width);
  const std::vector<const char*> keys{"ghost_strength", "ghost_edge", "ghost_outline"};
  for (const char* key : keys) EXPECT_TRUE(shows(key)) << key;
  for (const char* key : {"fade_reach", "focal_size", "lens_radius"}) EXPECT_FALSE(shows(key)) << key;
  EXPECT_TRUE(control<SliderSpin>("open_width")->isEnabled() && panel<ContextLayerPanel>().isEnabled());
  QImage before = picture(volume(0));
  EXPECT_NE(before, adaptive);
  const std::vector<double> values{0.5, 3.0, 1.0};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    control<SliderSpin>(keys[i])->box()->setValue(values[i]);
    waitUntilDrawn();
    EXPECT_NE(picture(volume(0)), before) << keys[i];
    before = picture(volume(0));
  }
  const Method& method = document().look().method;
  EXPECT_TRUE(method.of<methods::Selection>().strength == 0.5 && method.of<methods::Selection>().edge == 3.0 &&
              method.of<methods::Selection>().outline == 1.0);
  while (document().undoStack().index() > steps) document().undoStack().undo();
  waitUntilDrawn();
  ASSERT_EQ(picture(volume(0)).size(), adaptive.size());
  EXPECT_EQ(picture(volume(0)), adaptive) << "to the bit";
}

TEST_F(MethodWindow, Thorough_PeelingHasAnAmountASideAndAShape) {
  cameras().setAnimated(false);
  const QImage adaptive = picture(volume(0));
  const int steps = document().undoStack().index(), width = panel<CutawayPanel>().width();
  choose("kind", kindOf<methods::Peel>);
  waitUntilDrawn();
  EXPECT_EQ(panel<CutawayPanel>().width(), width);
  for (const char* key : {"peel", "peel_side", "peel_turn", "peel_depth", "peel_radius", "peel_margin"})
    EXPECT_TRUE(shows(key)) << key;
  for (const char* key : {"explosion", "focal_size", "ghost_edge"}) EXPECT_FALSE(shows(key)) << key;
  EXPECT_FALSE(control<SliderSpin>("open_width")->isEnabled() || panel<ContextLayerPanel>().isEnabled());
  QImage before = picture(volume(0));
  EXPECT_NE(before, adaptive);
  const auto expectChange = [&](const char* key) {
    waitUntilDrawn();
    EXPECT_NE(picture(volume(0)), before) << key;
    before = picture(volume(0));
  };
  const std::vector<std::pair<const char*, double>> values{
      {"peel", 0.6}, {"peel_turn", 35.0}, {"peel_depth", 0.2}, {"peel_radius", 30.0}, {"peel_margin", 3.0}};
  for (const auto& [key, value] : values) {
    control<SliderSpin>(key)->box()->setValue(value);
    expectChange(key);
  }
  choose("peel_side", PeelSide::Left);
  expectChange("peel_side");
  const Method& method = document().look().method;
  EXPECT_TRUE(method.of<methods::Peel>().amount == 0.6 && method.of<methods::Peel>().turn == 35.0 &&
              method.of<methods::Peel>().depth == 0.2 && method.of<methods::Peel>().radius == 30.0 &&
              method.of<methods::Peel>().margin == 3.0 && method.of<methods::Peel>().side == PeelSide::Left);
  while (document().undoStack().index() > steps) document().undoStack().undo();
  waitUntilDrawn();
  ASSERT_EQ(picture(volume(0)).size(), adaptive.size());
  EXPECT_EQ(picture(volume(0)), adaptive) << "to the bit";
}

TEST_F(MethodWindow, Thorough_ALayerIsPeeledOffWhenTheMethodIsChosenAndBackWhenItIsLeft) {
  const auto shown = [&] { return volume(0)->shownScene().look.method; };
  cameras().setAnimated(true);
  choose("kind", kindOf<methods::Peel>);
  const double amount = document().look().method.of<methods::Peel>().amount;
  EXPECT_LT(shown().of<methods::Peel>().amount, 0.5 * amount);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown().of<methods::Peel>().amount == amount; }, patience));
  waitUntilDrawn();
  choose("kind", kindOf<methods::Adaptive>);
  EXPECT_EQ(shown().kind, kindOf<methods::Peel>);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown() == document().look().method; }, patience));
  waitUntilDrawn();
  cameras().setAnimated(false);
}

TEST_F(MethodWindow, Thorough_PartsMoveOutWhenTheMethodIsChosenAndBackWhenItIsLeft) {
  const auto shown = [&] { return volume(0)->shownScene().look.method; };
  cameras().setAnimated(true);
  choose("kind", kindOf<methods::Explode>);
  const double degree = document().look().method.of<methods::Explode>().degree;
  EXPECT_LT(shown().of<methods::Explode>().degree, 0.5 * degree);
  double last = 0.0;
  const auto arrived = [&] {
    EXPECT_GE(shown().of<methods::Explode>().degree, last) << "further out";
    last = shown().of<methods::Explode>().degree;
    return last == degree;
  };
  EXPECT_TRUE(QTest::qWaitFor(arrived, patience));
  waitUntilDrawn();
  choose("kind", kindOf<methods::Cone>);
  EXPECT_EQ(document().look().method.kind, kindOf<methods::Cone>);
  EXPECT_EQ(shown().kind, kindOf<methods::Explode>);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown() == document().look().method; }, patience));
  waitUntilDrawn();
  cameras().setAnimated(false);
  choose("kind", kindOf<methods::Explode>);
  EXPECT_EQ(shown(), document().look().method);
  choose("kind", kindOf<methods::Adaptive>);
  EXPECT_EQ(shown(), document().look().method);
}

TEST_F(MethodWindow, WithoutAnOpeningThereIsNothingToChoose) {
  Look look = document().look();
  look.cutaway.enabled = false;
  document().edit(QStringLiteral("off"), look);
  EXPECT_FALSE(control<QComboBox>("kind")->isEnabled());
}

TEST_F(MethodWindow, TextsAreTranslated) {
  PseudoLocale locale;
  QCoreApplication::installTranslator(&locale);
  CutawayPanel shown(document(), window_->workspace().carving);
  Look look = document().look();
  look.method.kind = kindOf<methods::Cone>;
  document().edit(QStringLiteral("cone"), look);
  QStringList texts;
  for (const char* key : {"kind", "importance", "sparseness", "lens_fade", "focal_shape", "wall_placement",
                          "explosion_planes", "explosion_axes", "peel_side"}) {
    const auto* box = shown.findChild<QComboBox*>(QLatin1String(key));
    texts << box->toolTip();
    for (int row = 0; row < box->count(); ++row)
      texts << box->itemText(row) << box->itemData(row, Qt::ToolTipRole).toString();
  }
  for (const char* key :
       {"cone_angle", "importance_angle", "importance_opacity", "open_width", "lens_radius", "lens_bends", "fade_reach",
        "fade_sharpness", "focal_size", "focal_fall_off", "explosion", "ghost_strength", "ghost_edge", "ghost_outline",
        "peel", "peel_turn", "peel_depth", "peel_radius", "peel_margin"})
    texts << shown.findChild<SliderSpin*>(QLatin1String(key))->toolTip();
  look.method.kind = kindOf<methods::ClearView>;
  document().edit(QStringLiteral("lens"), look);
  const auto* rim = shown.findChild<QDoubleSpinBox*>(QStringLiteral("lens_rim"));
  texts << rim->toolTip() << rim->prefix();
  for (const char* key : {"open_width", "border_width"})
    texts << shown.findChild<SliderSpin*>(QLatin1String(key))->toolTip();
  look.method.kind = kindOf<methods::ContextPreserving>;
  document().edit(QStringLiteral("fading"), look);
  for (const char* key : {"open_width", "border_width"})
    texts << shown.findChild<SliderSpin*>(QLatin1String(key))->toolTip();
  const auto* rows = shown.findChild<CarvingRows*>();
  for (const QToolButton* button : {rows->carve(), rows->restore()}) texts << button->text() << button->toolTip();
  for (int row = 0; row < rows->shape()->count(); ++row)
    texts << rows->shape()->itemText(row) << rows->shape()->itemData(row, Qt::ToolTipRole).toString();
  QCoreApplication::removeTranslator(&locale);
  EXPECT_GE(texts.size(), 68);
  for (const QString& text : texts) EXPECT_TRUE(text.startsWith(opens)) << text.toStdString();
}

}  // namespace
}  // namespace fenestra::viewer::methodWindowTest
