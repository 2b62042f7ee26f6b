// What becomes of each setting when a study opens: the table in the code, the one in the user guide, and the window.

#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include <QSignalSpy>

#include "io/VolumeWriter.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/FileOpener.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/SettingOwners.h"

namespace fenestra::viewer::settingOwnersTest {
namespace {

TEST(SettingOwners, TheUserGuideHasTheSameTable) {
  std::ifstream file(std::string(FENESTRA_SOURCE_DIR) + "/resources/guide/look.md");
  std::stringstream text;
  text << file.rdbuf();
  std::map<std::string, std::string> guide;
  static const std::regex row("\\| ([^|]+) \\| (data|look|habit) \\|");
  const std::string page = text.str();
  for (std::sregex_iterator at(page.begin(), page.end(), row), end; at != end; ++at) guide[(*at)[1]] = (*at)[2];
  std::map<std::string, std::string> code;
  for (const OwnedSetting& setting : ownedSettings()) code[setting.name] = nameOf(setting.owner);
  EXPECT_EQ(guide, code);
}

class SettingOwnersWindow : public Window {
 protected:
  void SetUp() override {
    makeWindow();
    if (HasFatalFailure()) return;
    file_ = tests::scratchFolder() / "ball.nii.gz";
    io::writeVolume(*markedBall().scene.volume, file_);
    openFile();
  }

  void openFile() {
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    window_->findChild<FileOpener*>()->open({file_});
    ASSERT_TRUE(opened.count() > 0 || opened.wait(patience));
    document().undoStack().setClean();
  }

  template <class Change>
  void edit(const Change& change) {
    Look look = document().look();
    change(look);
    document().edit(QStringLiteral("test"), std::move(look));
  }

  /// How a setting is changed, and its value as a text.
  struct Probe {
    std::function<void()> change;
    std::function<bool()> isChanged;
  };
  std::map<std::string, Probe> probes();

  std::filesystem::path file_;
};

std::map<std::string, SettingOwnersWindow::Probe> SettingOwnersWindow::probes() {
  const Look plain = document().look();
  const auto ofLook = [this, plain](auto change, auto value) {
    return Probe{[this, change] { edit(change); },
                 [this, plain, value] { return value(document().look()) != value(plain); }};
  };
  const glm::dvec3 cursorBefore = cursor().position();
  const auto poseBefore = cameras().pose();
  const WindowLevel windowBefore = document().window();
  const QByteArray layoutBefore = views().saveLayout();
  PlacementSettings placed = placement().settings();
  placed.options.weights.coverage = 2.25;
  BrushSettings brushed = brush().settings();
  brushed.radius = 55.0;
  return {
      {"Focus", ofLook(
                    [](Look& l) {
                      l.focus = ValueFocus{{0.0, 50.0}};
                    },
                    [](const Look& l) { return l.focus; })},
      {"Roles, colours and opacity of structures",
       ofLook([](Look& l) { l.labels = {{.label = 2, .role = LabelRole::Hidden}}; },
              [](const Look& l) { return l.labels; })},
      {"Crop box and clip planes", ofLook(
                                       [](Look& l) {
                                         l.clipping.planes = {{glm::dvec3(1, 0, 0), 5.0}};
                                       },
                                       [](const Look& l) { return l.clipping; })},
      {"Brush strokes", ofLook(
                            [](Look& l) {
                              BrushStroke stroke;
                              stroke.anchors = {glm::dvec3(1.0)};
                              l.strokes = {stroke};
                            },
                            [](const Look& l) { return l.strokes; })},
      {"Carved parts", ofLook(
                           [](Look& l) {
                             Removal removal;
                             removal.points = {glm::dvec3(0.0)};
                             l.removals = {removal};
                           },
                           [](const Look& l) { return l.removals; })},
      {"Measures",
       {[this] {
          document().setMeasures({Measure{.points = {glm::dvec3(0.0), glm::dvec3(5.0)}}}, QStringLiteral("Distance"));
        },
        [this] { return !document().measures().empty(); }}},
      {"Path of the curved reformat",
       {[this] {
          document().setPath({glm::dvec3(0.0), glm::dvec3(9.0)}, QStringLiteral("Path"));
        },
        [this] { return !document().path().empty(); }}},
      {"Window and level, inverted greys",
       {[this] {
          document().setWindow({123.0, 45.0});
          document().setInverted(true);
        },
        [this, windowBefore] { return document().window() != windowBefore || document().isInverted(); }}},
      {"Crosshair",
       {[this] {
          cursor().moveTo({9.0, 8.0, 7.0});
        },
        [this, cursorBefore] { return cursor().position() != cursorBefore; }}},
      {"Turned and thick slices",
       {[this] {
          window_->workspace().planes.setFollow(SlicePlane::Axial, PlaneFollow::C1);
          window_->workspace().planes.setSlab(SlicePlane::Coronal, {5.0, SlabMode::Mean});
        },
        [this] { return window_->workspace().planes.poses() != std::array<PlanePose, 3>(); }}},
      {"Cameras and frozen openings",
       {[this] {
          cameras().orbit(0, 0.5, 0.2);
          cameras().setFrozen({OpeningView{cameras().camera(0), {10, 10}, 1.0}, std::nullopt});
        },
        [this, poseBefore] { return cameras().pose() != poseBefore || cameras().frozen()[0].has_value(); }}},
      {"Flips and turns of slices",
       {[this] { slice(SlicePlane::Axial)->turnClockwise(); },
        // Neurological convention mirrors, too, and is a habit.
        [this] { return slice(SlicePlane::Axial)->turn().quarters != 0; }}},
      {"Undo",
       {[this] { edit([](Look& l) { l.shading.ambient = 0.4; }); },
        [this] { return document().undoStack().canUndo(); }}},
      {"Notices",
       {[this] { window_->notices().add(NoticeBar::Kind::Error, NoticeBar::Subject::Study, QStringLiteral("of A")); },
        [this] { return window_->notices().texts().contains(QStringLiteral("of A")); }}},
      {"Transfer function and shift",
       ofLook([](Look& l) { l.context.shift = 40.0; }, [](const Look& l) { return l.context; })},
      {"Method",
       ofLook([](Look& l) { l.method.kind = kindOf<methods::Sculpt>; }, [](const Look& l) { return l.method; })},
      {"Opening, border and axis",
       ofLook([](Look& l) { l.cutaway.openWidth = 53.0; }, [](const Look& l) { return l.cutaway.openWidth; })},
      {"Context edges",
       ofLook([](Look& l) { l.contextLayer.strength = 0.1; }, [](const Look& l) { return l.contextLayer; })},
      {"Light, occlusion and shadows",
       ofLook([](Look& l) { l.shading.occlusion = 0.6; }, [](const Look& l) { return l.shading; })},
      {"Between voxels", ofLook([](Look& l) { l.reconstruction = Reconstruction::Cubic; },
                                [](const Look& l) { return l.reconstruction; })},
      {"Smoothing of labels", ofLook([](Look& l) { l.labelSmoothing = LabelSmoothing::Strong; },
                                     [](const Look& l) { return l.labelSmoothing; })},
      {"Edges", ofLook([](Look& l) { l.edges = l.edges == Edges::Off ? Edges::Smooth : Edges::Off; },
                       [](const Look& l) { return l.edges; })},
      {"Hide the table", ofLook([](Look& l) { l.hideTable = false; }, [](const Look& l) { return l.hideTable; })},
      {"Unit of widths, background",
       {[this] {
          window_->workspace().preferences.set(Preference::WidthUnit, 1);
          window_->workspace().preferences.set(Preference::Background, 0x202020);
        },
        [this] {
          return document().look().cutaway.unit == WidthUnit::Millimetre && document().look().background.x > 0.1;
        }}},
      {"Quality at rest",
       {[this] { views().setAtRest(Quality::Draft, 3.0); }, [this] { return views().atRest().maxError == 3.0; }}},
      {"Linked views", {[this] { cameras().setLinked(false); }, [this] { return !cameras().isLinked(); }}},
      {"Cameras that follow the path",
       {[this] { options().setFollowsPath(true); }, [this] { return options().followsPath(); }}},
      {"How cameras are placed",
       {[this, placed] { placement().setSettings(placed); },
        [this, placed] { return placement().settings() == placed; }}},
      {"Cross, text, label colours, measures, planes shown",
       {[this] {
          options().setCrosshair(false);
          options().setText(false);
          options().setLabels(false);
          options().setMeasures(false);
          options().setPlanes(true);
        },
        [this] {
          return !options().crosshair() && !options().text() && !options().labels() && !options().measures() &&
                 options().planes();
        }}},
      {"Click chooses the focus", {[this] { options().setGrows(false); }, [this] { return !options().grows(); }}},
      {"Size and softness of brushes",
       {[this, brushed] { brush().setSettings(brushed); }, [this, brushed] { return brush().settings() == brushed; }}},
      {"Hide the patient", {[this] { options().setHidesPatient(true); }, [this] { return options().hidesPatient(); }}},
      {"Neurological convention",
       {[this] { options().setNeurological(true); }, [this] { return options().isNeurological(); }}},
      {"Layout of the window",
       {[this] { views().toggleMaximised(slice(SlicePlane::Axial)); }, [this] { return views().isMaximised(); }}},
  };
}

TEST_F(SettingOwnersWindow, EachRowIsTrueOfAStudyThatOpens) {
  std::map<std::string, Probe> all = probes();
  for (const OwnedSetting& setting : ownedSettings()) {
    ASSERT_TRUE(all.contains(setting.name)) << setting.name;
    all[setting.name].change();
    const bool showsLater = std::string(setting.name) == "Unit of widths, background";  // when something is opened
    EXPECT_TRUE(showsLater || all[setting.name].isChanged()) << setting.name << ": the test changes nothing";
  }
  document().undoStack().setClean();
  openFile();
  for (const OwnedSetting& setting : ownedSettings())
    EXPECT_EQ(all[setting.name].isChanged(), setting.owner == SettingOwner::Habit) << setting.name;
}

TEST_F(SettingOwnersWindow, AStudyStartsFromTheChosenLook) {
  io::LookPreset preset;
  preset.name = "wide";
  preset.unit = document().scene().volume->unit;
  preset.look.cutaway.openWidth = 41.0;
  preset.look.context.function.nodes = {{-50.0, {glm::dvec3(1.0), 0.0}}, {50.0, {glm::dvec3(0.5), 2.0}}};
  window_->findChild<FileOpener*>()->setChosenLook(&preset);
  edit([](Look& look) { look.cutaway.openWidth = 12.0; });
  document().undoStack().setClean();
  openFile();
  EXPECT_EQ(document().look().cutaway.openWidth, 41.0) << "as chosen, not as it was changed since";
  EXPECT_EQ(document().look().context.function, preset.look.context.function);
  preset.unit = "Bq/ml";
  window_->findChild<FileOpener*>()->setChosenLook(&preset);
  openFile();
  EXPECT_EQ(document().look().cutaway.openWidth, 41.0);
  EXPECT_NE(document().look().context.function, preset.look.context.function) << "made for values of another unit";
  window_->findChild<FileOpener*>()->setChosenLook(nullptr);
  openFile();
  EXPECT_EQ(document().look().cutaway.openWidth, Cutaway().openWidth);
}

TEST_F(SettingOwnersWindow, ASessionsHabitsEndWithIt) {
  const io::Session mine = window_->sessions().controller().session();
  io::Study study = markedBall();
  study.session = mine;
  study.session.linked = false;
  study.session.overlays.text = false;
  study.session.placement.samples = 48;
  study.session.maxError = 2.0;
  study.restoresSession = true;
  open(study);
  EXPECT_FALSE(options().text());
  EXPECT_EQ(views().atRest().maxError, 2.0);
  openFile();
  EXPECT_TRUE(options().text());
  EXPECT_TRUE(cameras().isLinked());
  EXPECT_EQ(placement().settings().sampling.count, mine.placement.samples);
  EXPECT_EQ(views().atRest().maxError, mine.maxError);
}

}  // namespace
}  // namespace fenestra::viewer::settingOwnersTest
