// Presets in the window: pictures of them, and the user's own, which are kept, renamed, deleted, exported and imported.

#include <map>

#include <QAbstractItemView>
#include <QApplication>
#include <QSignalSpy>
#include <QTest>

#include "io/TransferFunctionFile.h"
#include "rendering/settings/LookStyle.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/model/Preferences.h"
#include "viewer/panels/AppearancePanel.h"

namespace fenestra::viewer::presetWindowTest {
namespace {

namespace fs = std::filesystem;

class PresetWindow : public Window {
 protected:
  void SetUp() override {
    ASSERT_TRUE(gl_.available) << gl_.problem.toStdString();
    folder_ = tests::scratchFolder();
    useScratchSettings();
    makeWindow();
  }
  void makeWindow() {
    window_ = std::make_unique<MainWindow>(
        MainWindow::Setup{.gl = gl_, .atRest = Effort{.quality = Quality::Draft}, .remember = true});
    window_->resize(1280, 800);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), patience));
    QApplication::setActiveWindow(window_.get());
    setAutomatic(false);
    open(markedBall());
    PresetQuestions& questions = picker().questions();
    questions.name = [this](const QString&) { return answer_; };
    questions.mayReplace = questions.mayDelete = [this](const QString&) { return ++asked_, agrees_; };
    questions.importWhich = [this] { return std::optional(file_); };
    questions.exportWhere = [this](const QString&) { return std::optional(file_); };
  }
  PresetPicker& picker() { return panel<AppearancePanel>().presets(); }
  QString notices() { return window_->notices().texts().join(QLatin1Char(' ')); }
  LookLibrary& library() { return window_->workspace().looks; }
  void choose(const QString& name) {
    const int row = picker().box()->findText(name, Qt::MatchExactly);
    ASSERT_GE(row, 0) << name.toStdString();
    picker().box()->setCurrentIndex(row);
    Q_EMIT picker().box()->activated(row);
  }
  void keepAs(const QString& name) {
    answer_ = name;
    picker().keepLook();
  }
  /// Changes something of each part of the look.
  void edit() {
    Look look = document().look();
    look.context.function.nodes = {{-150.0, {{0.2, 0.4, 0.9}, 0.0}}, {300.0, {{0.2, 0.4, 0.9}, 0.7}}};
    look.context.preset.clear();
    look.context.shift = 12.5;
    look.focusAppearance = {{0.1, 0.9, 0.3}, 0.75};
    look.cutaway.openWidth = 33.0;
    look.contextLayer.strength = 0.25;
    look.shading.lightAzimuth = 50.0;
    look.background = {0.1, 0.2, 0.3};
    document().edit(QStringLiteral("Test"), look);
  }

  fs::path folder_, file_;
  QString answer_;
  bool agrees_ = true;
  int asked_ = 0;
};

TEST_F(PresetWindow, AKeptLookComesBackWholeAsOneStep) {
  document().focusOn(marker);
  edit();
  waitUntilDrawn();
  const Look kept = document().look();
  const QImage seen = picture(volume(0));
  keepAs(QStringLiteral("Gefäße / 1"));
  ASSERT_EQ(library().entries().size(), 1u);
  EXPECT_EQ(library().entries()[0].file.parent_path(), folder_ / "Fenestra tests" / "looks")
      << "in the user's configuration";
  EXPECT_EQ(picker().box()->currentText(), QStringLiteral("Gefäße / 1"));

  choose(QStringLiteral("CT bone"));
  Look other = document().look();
  other.cutaway = {};
  other.background = {};
  other.focusAppearance = {};
  document().edit(QStringLiteral("Test"), other);
  EXPECT_EQ(picker().box()->currentText(), QStringLiteral("CT bone"));
  const int steps = document().undoStack().count();
  choose(QStringLiteral("Gefäße / 1"));
  EXPECT_EQ(document().look(), kept) << "the focus stays";
  EXPECT_EQ(document().undoStack().count(), steps + 1);
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), seen) << "to the bit";
  document().undoStack().undo();
  EXPECT_EQ(document().look(), other);
  document().undoStack().redo();
  document().setShift(3.0);
  EXPECT_EQ(picker().box()->currentIndex(), -1) << "edited";
}

TEST_F(PresetWindow, Thorough_ALabelsOwnFunctionGoesWithTheLook) {
  const auto functionOf = [&](std::uint16_t label) { return document().labelSetting(label).function; };
  document().focusOn(marker);
  const TransferFunction own{{{0.0, {{1.0, 0.0, 0.0}, 0.25}}, {900.0, {{0.0, 0.0, 1.0}, 2.0}}}};
  document().setLabelSetting({.label = marker, .opacity = 0.5, .function = own}, QStringLiteral("Test"));
  edit();
  waitUntilDrawn();
  const Look kept = document().look();
  const QImage seen = picture(volume(0));
  keepAs(QStringLiteral("Mine"));
  file_ = folder_ / "mine.json";
  picker().exportPreset();
  document().setLabelSetting({.label = marker, .opacity = 0.5}, QStringLiteral("Test"));
  EXPECT_EQ(picker().box()->currentIndex(), -1) << "edited";
  choose(QStringLiteral("Mine"));
  EXPECT_EQ(document().look(), kept);
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), seen) << "to the bit";

  // Other data with other values for the same names.
  io::Study another = markedBall();
  auto labels =
      std::make_shared<LabelMap>(LabelMap{.grid = another.scene.labels->grid,
                                          .voxels = Voxels(ScalarType::UInt8, another.scene.labels->voxels.count()),
                                          .labels = {{1, "marker"}, {2, "body"}}});
  const auto from = another.scene.labels->voxels.as<std::uint8_t>();
  const auto to = labels->voxels.as<std::uint8_t>();
  std::transform(from.begin(), from.end(), to.begin(), [](std::uint8_t value) { return value == 0 ? 0 : 3 - value; });
  another.scene.labels = labels;
  open(another);
  picker().importPreset();
  EXPECT_EQ(functionOf(1), own);
  EXPECT_FALSE(functionOf(2));
  EXPECT_EQ(document().labelSetting(1).opacity, 1.0) << "opacity belongs to the data";
}

TEST_F(PresetWindow, ExportedAndImportedOnAnotherVolumeItIsTheSameLook) {
  edit();
  const Look first = document().look();
  file_ = folder_ / "mine.json";
  picker().exportPreset();
  ASSERT_TRUE(fs::exists(file_));
  io::Study another = markedBall();
  const auto volume = std::const_pointer_cast<Volume>(another.scene.volume);  // not shared yet
  volume->slope = 2.0;
  volume->intercept = -100.0;
  volume->computeRange();
  window_.reset();
  makeWindow();
  open(another);
  document().focusOn(body);
  EXPECT_NE(styleOf(document().look()), styleOf(first));
  picker().importPreset();
  EXPECT_EQ(styleOf(document().look()), styleOf(first));
  EXPECT_TRUE(document().isFocused(body));
  EXPECT_EQ(picker().box()->currentText(), QStringLiteral("mine"));
  picker().importPreset();
  EXPECT_EQ(library().entries().size(), 2u) << "a second one gets a name of its own";
  EXPECT_TRUE(library().find(QStringLiteral("mine 2")));
}

TEST_F(PresetWindow, PresetsAreRenamedReplacedAndDeletedAfterAsking) {
  keepAs(QStringLiteral("A"));
  edit();
  agrees_ = false;
  keepAs(QStringLiteral("A"));
  EXPECT_EQ(asked_, 1);
  EXPECT_NE(library().find(QStringLiteral("A"))->preset.look, styleOf(document().look())) << "not replaced";
  keepAs(QString());
  EXPECT_EQ(library().entries().size(), 1u) << "cancelled";
  agrees_ = true;
  keepAs(QStringLiteral("A"));
  EXPECT_EQ(library().find(QStringLiteral("A"))->preset.look, styleOf(document().look()));
  answer_ = QStringLiteral("B");
  picker().renamePreset();
  ASSERT_EQ(library().entries().size(), 1u);
  EXPECT_EQ(picker().box()->currentText(), QStringLiteral("B"));
  EXPECT_EQ(std::distance(fs::directory_iterator(library().entries()[0].file.parent_path()), {}), 1);
  window_.reset();
  makeWindow();
  EXPECT_TRUE(library().find(QStringLiteral("B"))) << "another run finds it";
  choose(QStringLiteral("B"));
  picker().deletePreset();
  EXPECT_TRUE(library().entries().empty());
}

TEST_F(PresetWindow, TheMenuOffersWhatCanBeDone) {
  const auto enabled = [this] {
    Q_EMIT picker().menu()->aboutToShow();
    std::map<std::string, bool> all;
    for (const QAction* action : picker().menu()->actions())
      if (!action->isSeparator()) all[action->text().toStdString()] = action->isEnabled();
    return all;
  };
  EXPECT_TRUE(enabled()["Keep this look as a preset…"]);
  EXPECT_FALSE(enabled()["Delete…"]);
  keepAs(QStringLiteral("A"));
  document().setShift(1.0);
  EXPECT_FALSE(enabled()["Rename…"]);
  choose(QStringLiteral("A"));
  EXPECT_TRUE(enabled()["Rename…"]);
  EXPECT_TRUE(enabled()["Delete…"]);
}

TEST_F(PresetWindow, AFileThatIsNoPresetIsNamedAndChangesNothing) {
  file_ = folder_ / "bad.json";
  tests::writeFile(file_, R"({"format": "fenestra-look", "version": 9})");
  const Look before = document().look();
  QSignalSpy failed(&picker(), &PresetPicker::failed);
  picker().importPreset();
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("bad.json")));
  EXPECT_TRUE(notices().contains(QStringLiteral("bad.json")));
  EXPECT_EQ(document().look(), before);
  EXPECT_TRUE(library().entries().empty());
  file_ = folder_ / "no such folder" / "a.json";
  picker().exportPreset();
  EXPECT_EQ(failed.count(), 2);
}

TEST_F(PresetWindow, AUnitOfOtherValuesIsAWarning) {
  file_ = folder_ / "mr.json";
  io::writeLook(file_, {"MR look", "", styleOf(document().look()), {}});
  QSignalSpy warned(&picker(), &PresetPicker::warned);
  picker().importPreset();
  ASSERT_EQ(warned.count(), 1);
  EXPECT_TRUE(warned[0][0].toString().contains(QStringLiteral("MR look")));
  EXPECT_TRUE(notices().contains(QStringLiteral("MR look")));
}

TEST_F(PresetWindow, AKeptFileThatCannotBeReadIsNamedAtTheStart) {
  keepAs(QStringLiteral("A"));
  tests::writeFile(Preferences().looksFolder() / "spoilt.json", "{}");
  makeWindow();
  EXPECT_TRUE(notices().contains(QStringLiteral("spoilt.json"))) << "it outlives the study that opens";
}

TEST_F(PresetWindow, TheOpenListShowsPicturesOfTheVolume) {
  keepAs(QStringLiteral("A"));
  QComboBox& box = *picker().box();
  const auto pictures = [&] {
    std::vector<QImage> all;
    for (int row = 0; row + 1 < box.count(); ++row)
      all.push_back(box.itemIcon(row).pixmap(QSize(64, 56)).toImage().convertToFormat(QImage::Format_RGB32));
    return all;
  };
  const auto areDrawn = [this] { return picker().hasAllPictures(); };
  EXPECT_FALSE(areDrawn()) << "before the list is opened nothing is drawn";
  QTest::mouseClick(&box, Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor(areDrawn, patience));
  for (const Qt::Key key : {Qt::Key_Home, Qt::Key_Down, Qt::Key_Return}) QTest::keyClick(box.view(), key);
  EXPECT_EQ(document().preset(), "ct-bone") << "chosen in the list";
  const std::vector<QImage> drawn = pictures();
  ASSERT_EQ(drawn.size(), io::transferFunctionPresets().size() + 1);
  const auto lit = [](const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) count += qGray(picture.pixel(x, y)) > 20;
    return static_cast<double>(count) / (picture.width() * picture.height());
  };
  // A ball fills the middle; in the preset for bone the cube alone is left of it.
  EXPECT_GT(lit(drawn.back()), 0.3);
  const int bone = box.findText(QStringLiteral("CT bone"));
  EXPECT_GT(lit(drawn.at(static_cast<std::size_t>(bone))), 0.02);
  EXPECT_NE(drawn.at(static_cast<std::size_t>(bone)), drawn.back());
  keepAs(QStringLiteral("B"));
  EXPECT_TRUE(box.itemData(0, Qt::UserRole + 2).toBool()) << "pictures of the volume are kept";
  open(markedBall());
  EXPECT_FALSE(box.itemData(0, Qt::UserRole + 2).toBool()) << "until there is another one";
}

TEST_F(PresetWindow, KeysAndTheWheelOnTheClosedBoxNeverAskForAFile) {
  keepAs(QStringLiteral("A"));
  QComboBox& box = *picker().box();
  int questions = 0;
  picker().questions().functionWhich = [&]() -> std::optional<fs::path> { return ++questions, std::nullopt; };
  choose(box.itemText(0));
  box.setFocus();
  const int lastPreset = box.count() - 2;
  for (int i = 0; i < box.count() + 3; ++i) QTest::keyClick(&box, Qt::Key_Down);
  EXPECT_EQ(box.currentIndex(), lastPreset);
  EXPECT_EQ(box.currentText(), QStringLiteral("A"));
  QTest::keyClick(&box, Qt::Key_End);
  QTest::keyClick(&box, Qt::Key_PageDown);
  QTest::keyClicks(&box, QStringLiteral("From a file"));
  wheel(&box, -3);
  EXPECT_EQ(questions, 0);
  QTest::keyClick(&box, Qt::Key_Home);
  EXPECT_EQ(box.currentIndex(), 0);
  // The open list offers it.
  QTest::mouseClick(&box, Qt::LeftButton);
  for (const Qt::Key key : {Qt::Key_End, Qt::Key_Return}) QTest::keyClick(box.view(), key);
  EXPECT_EQ(questions, 1);
  EXPECT_EQ(box.currentIndex(), 0);
}

TEST_F(PresetWindow, AListThatIsOpenWhenTheWindowGoesIsNoProblem) {
  picker().box()->showPopup();
  picker().box()->hidePopup();
  window_.reset();
  makeWindow();
  picker().box()->showPopup();
  open(markedBall());
  picker().box()->hidePopup();
  waitUntilDrawn();
}

}  // namespace
}  // namespace fenestra::viewer::presetWindowTest
