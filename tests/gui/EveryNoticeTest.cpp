// The state behind each notice about data and labels, forced, and the notice seen. Those about pictures, exports,
// sessions, verifying, presets and strokes are with the tests of what they are about.

#include <QLabel>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>

#include "io/VolumeWriter.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/Sessions.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelEditPanel.h"
#include "viewer/panels/RegionPanel.h"

namespace fenestra::viewer::everyNoticeTest {
namespace {

class EveryNotice : public Window {
 protected:
  /// Whether a notice on screen says it.
  bool says(const char* text) {
    const auto labels = window_->notices().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->isVisible() && label->text().contains(QString::fromUtf8(text));
    });
  }
  std::string all() { return window_->notices().texts().join(QLatin1Char('\n')).toStdString(); }
  QPushButton* button(const char* text) {
    for (auto* each : window_->notices().findChildren<QPushButton*>())
      if (each->isVisible() && each->text() == QString::fromUtf8(text)) return each;
    return nullptr;
  }
};

TEST_F(EveryNotice, OfWhatLiesBesideTheStudy) {
  io::Study study = markedBall();
  EXPECT_EQ(all(), "");
  study.otherSeries.resize(2);
  study.reason = {"the thinnest %1, %2", {"acquired volume", "1.0 mm"}};
  open(study);
  EXPECT_TRUE(says("There are 3 series here") && says("the thinnest acquired volume, 1.0 mm")) << all();
  EXPECT_NE(button("Choose…"), nullptr);

  study.series.times = 3;
  study.series.time = 2;
  open(study);
  EXPECT_TRUE(says("There are 3 time points here; this is number 2")) << all();

  study = markedBall();
  study.scene.labels = nullptr;
  study.segmentations = {{"/missing/seg.dcm", "SEG", "liver", {"liver"}}};
  open(study);
  EXPECT_TRUE(says("A segmentation of this series lies beside it")) << all();
  ASSERT_NE(button("Open"), nullptr);
  button("Open")->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return says("/missing/seg.dcm"); }, patience)) << all();

  study.segmentations.push_back({"/missing/rt.dcm", "RTSTRUCT", "heart", {"heart"}});
  open(study);
  EXPECT_TRUE(says("2 segmentations of this series lie beside it")) << all();
}

TEST_F(EveryNotice, OfWhatTheReaderFound) {
  io::Study study = markedBall();
  study.warnings = {{io::Warning::Kind::NoGeometry, "places are guessed", {"a.dcm"}},
                    {io::Warning::Kind::Recognised, "taken for a CT", {}, io::WayOut::SayModality}};
  study.geometry.emplace();
  study.geometry->findings = {{io::Warning::Kind::MissingSlices, "1 slice is missing", {"b.dcm"}}};
  study.geometry->applied = io::Regularise::Linear;
  study.geometry->sheared = true;
  study.warnings.push_back(study.geometry->findings.front());
  open(study);
  EXPECT_TRUE(says("Places are guessed.") && says("1 slice is missing.")) << all();
  EXPECT_FALSE(says("taken for a CT"));
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains(QStringLiteral("taken for a CT")));
  for (const char* name : {"Files…", "Report…", "Load as is", "Make straight"})
    EXPECT_NE(button(name), nullptr) << name;
}

TEST_F(EveryNotice, OfOpeningAndSavingThatFails) {
  const std::filesystem::path folder = tests::scratchFolder();
  window_->open(std::vector{folder / "none.nii"});
  EXPECT_TRUE(QTest::qWaitFor([&] { return says("none.nii"); }, patience)) << all();
  window_->openLabels(folder / "no-labels.nii");
  EXPECT_TRUE(QTest::qWaitFor([&] { return says("no-labels.nii"); }, patience)) << all();
  EXPECT_TRUE(says("none.nii")) << "no error hides another";
  window_->sessions().controller().save(folder / "no such folder" / "a.fenestra");
  EXPECT_TRUE(QTest::qWaitFor([&] { return says("no such folder"); }, patience)) << all();
  window_->open(std::vector{folder, folder / "a.nii"});
  EXPECT_TRUE(says("folder")) << all();
}

TEST_F(EveryNotice, OfLabelsThatDoNotFit) {
  Volume labels;
  labels.grid = {.dims = glm::ivec3(4), .spacing = glm::dvec3(20.0), .origin = glm::dvec3(-30.0)};
  labels.voxels = Voxels(ScalarType::UInt8, labels.grid.voxelCount());
  for (std::uint8_t& value : labels.voxels.as<std::uint8_t>()) value = 1;
  const std::filesystem::path file = tests::scratchFolder() / "labels.nii";
  io::writeVolume(labels, file);
  window_->openLabels(file);
  EXPECT_TRUE(QTest::qWaitFor([&] { return says("resampled to the volume's grid by nearest label"); }, patience))
      << all();
}

TEST_F(EveryNotice, OfALabelEditThatFails) {
  document().focusOn(marker);
  const std::shared_ptr<const LabelMap> before = document().labels();
  LabelEditPanel& edits = *panel<FocusPanel>().labelEdits();
  edits.distance()->setValue(20.0);  // the marker is 14 mm wide
  QTest::mouseClick(edits.button(LabelOperation::Shrink), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return says("Nothing would be left of the label"); }, patience)) << all();
  EXPECT_EQ(document().labels(), before) << "the label stays as it was";
  edits.distance()->setValue(2.0);
  QTest::mouseClick(edits.button(LabelOperation::Shrink), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return all().empty(); }, patience)) << "an edit has succeeded: " << all();
}

TEST_F(EveryNotice, OfLabelsThatReadingAgainWouldDrop) {
  document().growFrom(markerCentre);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  QTest::mouseClick(panel<FocusPanel>().region()->keep(), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !document().labelsAreInFile(); }, patience));
  window_->sessions().regularise(io::Regularise::Off);
  EXPECT_TRUE(says("reading the data again would drop them")) << all();
  EXPECT_TRUE(document().labels());
}

TEST_F(EveryNotice, OfALabelThatTakesFromOthers) {
  document().growFrom(markerCentre);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  QTest::mouseClick(panel<FocusPanel>().region()->keep(), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return says("lies over other labels and took"); }, patience)) << all();
}

}  // namespace
}  // namespace fenestra::viewer::everyNoticeTest
