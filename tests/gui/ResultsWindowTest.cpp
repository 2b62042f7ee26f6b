// Results of a study as DICOM objects, saved from the window and read again.

#include <algorithm>
#include <fstream>
#include <set>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "io/LabelReader.h"
#include "io/archive/Query.h"
#include "io/report/Results.h"
#include "tests/gui/ArchiveWindow.h"
#include "tests/io/DicomWriter.h"
#include "viewer/results/ResultsDialog.h"

namespace fenestra::viewer::resultsWindowTest {
namespace {

namespace fs = std::filesystem;
using io::report::ResultObject;

class ResultsWindow : public ArchiveWindow {
 protected:
  /// Five slices, two labels of which one has no voxels, and a distance.
  void openStudy() {
    study_ = tests::makeStudy(root_ / "made", "1.2.3.90", 5);
    drop({study_.folder});
    auto labels = std::make_shared<LabelMap>();
    labels->grid = document().scene().volume->grid;
    labels->voxels = Voxels(ScalarType::UInt8, labels->grid.voxelCount());
    std::ranges::fill(labels->voxels.as<std::uint8_t>(), std::uint8_t{0});
    for (int x = 3; x < 9; ++x) labels->voxels.as<std::uint8_t>()[labels->grid.offset({x, 5, 2})] = 4;
    labels->labels = {{4, "Niere größer", {1.0, 0.0, 0.0}}, {7, "none", {0.0, 1.0, 0.0}}};
    document().setLabels(labels, {});
    document().setMeasures({{MeasureKind::Distance, {worldOf({3, 5, 2}), worldOf({13, 5, 2})}}}, QStringLiteral("m"));
  }
  glm::dvec3 worldOf(glm::dvec3 index) {
    return document().scene().volume->grid.worldFromIndex() * glm::dvec4(index, 1.0);
  }
  /// What the dialog was before is closed.
  ResultsDialog& dialog() {
    auto* entry = window_->findChild<QAction*>(QStringLiteral("saveResults"));
    EXPECT_TRUE(entry->isEnabled());
    entry->trigger();
    return *window_->findChild<ResultsDialog*>();
  }
  QCheckBox& box(const char* name) { return *in<QCheckBox>(*window_->findChild<ResultsDialog*>(), name); }
  /// Chooses these kinds alone.
  void choose(const std::vector<const char*>& names) {
    for (const char* each : {"resultMeasures", "resultLabels", "resultFocus", "resultPicture", "resultKeys"})
      box(each).setChecked(false);
    for (const char* each : names) {
      EXPECT_TRUE(box(each).isEnabled()) << each;
      box(each).setChecked(true);
    }
  }
  std::string status() {
    return in<QLabel>(*window_->findChild<ResultsDialog*>(), "resultStatus")->text().toStdString();
  }
  void save() {
    auto* dialog = window_->findChild<ResultsDialog*>();
    auto* button = in<QPushButton>(*dialog, "resultSave");
    ASSERT_TRUE(button->isEnabled());
    button->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog->isBusy(); }, patience)) << status();
  }
  fs::path emptyFolder(const char* name) {
    fs::create_directories(root_ / name);
    return root_ / name;
  }
  static std::vector<std::string> filesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& each : fs::directory_iterator(folder)) names.push_back(each.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  static ResultObject read(const fs::path& file) { return io::report::readResult(file).value(); }
  /// Writes each kind of result but the archive's, of a study with a range of values in focus and two key images.
  void writeEachKind(const fs::path& folder) {
    openStudy();
    document().setFocus(ValueFocus{{200.0, 1100.0}, 0.0});
    waitUntilDrawn();
    for (const int slice : {3, 1}) {
      cursor().moveTo(worldOf({10, 10, slice}));
      ASSERT_TRUE(window_->workspace().keyImages.add({}));
    }
    dialog().setFolder(QString::fromStdString(folder.string()));
    choose({"resultMeasures", "resultLabels", "resultFocus", "resultPicture", "resultKeys"});
    in<QLineEdit>(dialog(), "resultDescription")->setText(QStringLiteral("Läsion links"));
    save();
  }
  /// The lines of errors of dciodvfy.
  std::string errorsOf(const fs::path& file) {
    const fs::path log = root_ / "validator.log";
    [[maybe_unused]] const int exit =
        std::system(("dciodvfy '" + file.string() + "' > '" + log.string() + "' 2>&1").c_str());
    std::ifstream lines(log);
    std::string errors;
    for (std::string each; std::getline(lines, each);)
      if (each.starts_with("Error")) errors += file.filename().string() + ": " + each + "\n";
    return errors;
  }

  tests::MadeStudy study_;
};

TEST_F(ResultsWindow, Thorough_EachKindIsWrittenIntoTheStudyAndReadAgain) {
  const fs::path folder = emptyFolder("out");
  writeEachKind(folder);
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"focus.dcm", "key-images.dcm", "measures.dcm", "picture.dcm",
                                                       "segmentation.dcm"}))
      << status();
  for (const std::string& name : filesIn(folder)) {
    const ResultObject each = read(folder / name);
    EXPECT_EQ(each.study, study_.uid) << name;
    EXPECT_EQ(each.description, "Läsion links") << name;
  }
  const ResultObject measures = read(folder / "measures.dcm");
  ASSERT_EQ(measures.values.size(), 6u);
  EXPECT_EQ(measures.values[0].group, "Niere größer");
  EXPECT_EQ(measures.values[0].segment, 1);
  EXPECT_EQ(measures.values[5].group, "distance 1");
  EXPECT_NEAR(measures.values[5].value, *document().measured(0).length, 1e-12);
  EXPECT_EQ(read(folder / "segmentation.dcm").segments, (std::vector<std::string>{"Niere größer"}));

  // The segment holds just the voxels whose value lies in the range: no part is too small at a least size of 0.
  const Volume& volume = *document().scene().volume;
  const auto focus = io::openLabels(folder / "focus.dcm", volume.grid).labels;
  std::size_t inside = 0, wrong = 0;
  glm::ivec3 at;
  for (at.z = 0; at.z < volume.grid.dims.z; ++at.z)
    for (at.y = 0; at.y < volume.grid.dims.y; ++at.y)
      for (at.x = 0; at.x < volume.grid.dims.x; ++at.x) {
        const bool wanted = volume.value(at) >= 200.0 && volume.value(at) <= 1100.0;
        inside += wanted;
        wrong += wanted != (focus->value(at) == 1);
      }
  EXPECT_GT(inside, 1000u);
  EXPECT_EQ(wrong, 0u);

  const ResultObject picture = read(folder / "picture.dcm");
  ASSERT_EQ(picture.texts.size(), 2u);
  EXPECT_EQ(picture.texts[1].find(": "), picture.texts[1].find(':')) << picture.texts[1];
  EXPECT_NE(picture.texts[0].find(picture.texts[1].substr(0, 12)), std::string::npos) << picture.texts[0];
  const ResultObject keys = read(folder / "key-images.dcm");
  ASSERT_EQ(keys.images.size(), 2u);
  EXPECT_EQ(keys.images[0].instance, study_.series + ".2");
  EXPECT_EQ(keys.images[1].instance, study_.series + ".4");
  EXPECT_EQ(keys.texts, (std::vector<std::string>{"Läsion links: Key image 1; Key image 2"}));
}

TEST_F(ResultsWindow, DciodvfyAcceptsEachKind) {
  if (std::system("command -v dciodvfy >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs dciodvfy, of the package dicom3tools";
  const fs::path folder = emptyFolder("valid");
  writeEachKind(folder);
  ASSERT_EQ(filesIn(folder).size(), 5u) << status();
  for (const std::string& name : filesIn(folder)) EXPECT_EQ(errorsOf(folder / name), "");
}

TEST_F(ResultsWindow, NothingThatIsThereIsReplaced) {
  openStudy();
  const fs::path folder = emptyFolder("out");
  std::ofstream(folder / "measures.dcm") << "another's";
  dialog().setFolder(QString::fromStdString(folder.string()));
  choose({"resultMeasures"});
  save();
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"measures-2.dcm", "measures-segments.dcm", "measures.dcm"}));
  EXPECT_EQ(fs::file_size(folder / "measures.dcm"), 9u);
  EXPECT_EQ(read(folder / "measures-segments.dcm").segments, (std::vector<std::string>{"Niere größer"}));
}

TEST_F(ResultsWindow, ARegionAndLabelsInFocusAreSegments) {
  openStudy();
  document().focusOn(4);
  const fs::path folder = emptyFolder("out");
  dialog().setFolder(QString::fromStdString(folder.string()));
  choose({"resultFocus"});
  save();
  EXPECT_EQ(read(folder / "focus.dcm").segments, (std::vector<std::string>{"Niere größer"}));
  document().growFrom(worldOf({30, 30, 2}));
  EXPECT_FALSE(box("resultFocus").isEnabled()) << "it has to grow first";
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  document().openToRegion();
  choose({"resultFocus"});
  save();
  EXPECT_EQ(read(folder / "focus-2.dcm").segments, (std::vector<std::string>{"Region"}));
  const auto labels = io::openLabels(folder / "focus-2.dcm", document().scene().volume->grid).labels;
  EXPECT_EQ(labels->value({30, 30, 2}), 1);
}

TEST_F(ResultsWindow, WhatCannotBeWrittenIsGreyWithItsReason) {
  auto* entry = window_->findChild<QAction*>(QStringLiteral("saveResults"));
  EXPECT_FALSE(entry->isEnabled()) << "nothing is open";
  open(markedBall());
  ResultsDialog& shown = dialog();
  for (const char* each : {"resultMeasures", "resultKeys", "resultToArchive"})
    EXPECT_FALSE(box(each).isEnabled()) << each;
  QStringList texts;
  for (const QLabel* each : shown.findChildren<QLabel*>())
    if (each->isVisible()) texts << each->text();
  const QString all = texts.join(QLatin1Char('\n'));
  EXPECT_TRUE(all.contains(QStringLiteral("not from DICOM files"))) << all.toStdString();
  // Segmentations and pictures are studies of their own then.
  const fs::path folder = emptyFolder("out");
  shown.setFolder(QString::fromStdString(folder.string()));
  choose({"resultLabels", "resultPicture"});
  save();
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"picture.dcm", "segmentation.dcm"})) << status();
  // Another study closes it.
  drop({tests::makeStudy(root_ / "made", "1.2.3.91", 3).folder});
  EXPECT_TRUE(QTest::qWaitFor([&] { return !window_->findChild<ResultsDialog*>(); }, patience));
}

TEST_F(ResultsWindow, AFailureNamesTheFolderAndLeavesNothing) {
  openStudy();
  const fs::path folder = emptyFolder("out");
  std::ofstream(folder / "file") << "no folder";
  dialog().setFolder(QString::fromStdString((folder / "file").string()));
  choose({"resultMeasures", "resultLabels"});
  save();
  EXPECT_NE(status().find((folder / "file").string()), std::string::npos) << status();
  EXPECT_NE(status().find("choose a folder"), std::string::npos) << status();
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"file"}));
  // A series whose files are gone meanwhile fails after the first object was written.
  const fs::path second = emptyFolder("second");
  dialog().setFolder(QString::fromStdString(second.string()));
  document().setFocus(ValueFocus{{200.0, 1100.0}, 0.0});
  choose({"resultPicture", "resultFocus"});
  fs::remove_all(study_.folder);
  save();
  EXPECT_EQ(filesIn(second), std::vector<std::string>{}) << status();
  EXPECT_FALSE(status().empty());
  // Stopped at once.
  dialog();
  in<QPushButton>(dialog(), "resultSave")->click();
  dialog().reject();
  waitFor([&] { return !dialog().isBusy(); });
  EXPECT_EQ(filesIn(second), std::vector<std::string>{}) << status();
}

TEST_F(ResultsWindow, AnArchiveAnswersForEachObject) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const auto running = tests::startOrthanc(root_ / "s");
  ASSERT_TRUE(running);
  archives().put(entryOf(*running));
  openStudy();
  dialog();
  choose({"resultMeasures", "resultPicture"});
  EXPECT_FALSE(box("resultCommit").isEnabled()) << "nothing goes to an archive";
  box("resultToArchive").setChecked(true);
  box("resultCommit").setChecked(true);
  save();
  EXPECT_EQ(status(), "Accepted: 3 of 3.\nConfirmed to be kept: 3 of 3.");
  auto* answers = in<QTreeWidget>(dialog(), "resultAnswers");
  ASSERT_EQ(answers->topLevelItemCount(), 3);
  EXPECT_EQ(answers->topLevelItem(0)->text(0), QStringLiteral("Measures"));
  EXPECT_EQ(answers->topLevelItem(0)->text(1), QStringLiteral("accepted, kept"));
  std::set<std::string> kinds;
  for (const auto& each :
       io::archive::find(running->server, {io::archive::Level::Series, {{"StudyInstanceUID", study_.uid}}}).records)
    kinds.insert(io::archive::valueOf(each, "Modality"));
  EXPECT_EQ(kinds, (std::set<std::string>{"OT", "SEG", "SR"}));
}

}  // namespace
}  // namespace fenestra::viewer::resultsWindowTest
