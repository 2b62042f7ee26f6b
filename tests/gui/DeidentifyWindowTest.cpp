// De-identified copies of what is open, from the window: the table before, the folder, the map, the archive.

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "io/VolumeReader.h"
#include "io/archive/Query.h"
#include "tests/gui/ArchiveWindow.h"
#include "tests/io/IoTesting.h"
#include "viewer/results/DeidentifyDialog.h"

namespace fenestra::viewer::deidentifyWindowTest {
namespace {

namespace fs = std::filesystem;

class DeidentifyWindow : public ArchiveWindow {
 protected:
  /// Opens five slices and the dialog, whose table is full.
  DeidentifyDialog* openDialog() {
    study_ = tests::makeStudy(root_ / "made", "1.2.3.95", 5);
    drop({study_.folder});
    auto* entry = window_->findChild<QAction*>(QStringLiteral("deidentify"));
    EXPECT_TRUE(entry->isEnabled());
    entry->trigger();
    auto* dialog = window_->findChild<DeidentifyDialog*>();
    EXPECT_TRUE(dialog);
    waitFor([&] { return !dialog->isPreviewing(); });
    return dialog;
  }
  QCheckBox& box(const char* name) { return *in<QCheckBox>(*window_->findChild<DeidentifyDialog*>(), name); }
  /// What the table says of an attribute; empty: nothing.
  QString becomes(const char* attribute) {
    const auto* table = in<QTreeWidget>(*window_->findChild<DeidentifyDialog*>(), "deidentifyTable");
    for (int i = 0; i < table->topLevelItemCount(); ++i)
      if (table->topLevelItem(i)->text(0).endsWith(QLatin1Char(' ') + QLatin1String(attribute)))
        return table->topLevelItem(i)->text(1);
    return {};
  }
  void save() {
    auto* dialog = window_->findChild<DeidentifyDialog*>();
    auto* button = in<QPushButton>(*dialog, "deidentifySave");
    ASSERT_TRUE(button->isEnabled());
    button->click();
    waitFor([&] { return !dialog->isBusy(); });
  }
  std::string status() {
    return in<QLabel>(*window_->findChild<DeidentifyDialog*>(), "deidentifyStatus")->text().toStdString();
  }

  tests::MadeStudy study_;
};

TEST_F(DeidentifyWindow, ShowsWhatChangesAndWritesCopies) {
  auto* entry = window_->findChild<QAction*>(QStringLiteral("deidentify"));
  EXPECT_FALSE(entry->isEnabled()) << "nothing is open";
  DeidentifyDialog* dialog = openDialog();
  EXPECT_EQ(becomes("PatientName"), QStringLiteral("emptied"));
  EXPECT_EQ(becomes("StudyDate"), QStringLiteral("emptied"));
  EXPECT_EQ(becomes("SOPInstanceUID"), QStringLiteral("replaced by a new UID"));
  box("deidentifyDates").setChecked(true);
  box("deidentifyUids").setChecked(true);
  EXPECT_FALSE(box("deidentifyFace").isEnabled()) << "changed pixels need UIDs of their own";
  waitFor([&] { return !dialog->isPreviewing(); });
  EXPECT_EQ(becomes("StudyDate"), QString());
  EXPECT_EQ(becomes("SOPInstanceUID"), QString());
  box("deidentifyUids").setChecked(false);
  EXPECT_FALSE(in<QPushButton>(*dialog, "deidentifySave")->isEnabled()) << "there is no place for copies";

  fs::create_directories(root_ / "out" / "de-identified");
  dialog->setFolder(QString::fromStdString((root_ / "out").string()));
  dialog->setMap(QString::fromStdString((root_ / "map.tsv").string()));
  save();
  const fs::path copies = root_ / "out" / "de-identified-2";
  EXPECT_EQ(status(), "5 copies are in " + copies.string() + ".");
  const io::OpenedVolume before = io::openVolume(study_.folder), after = io::openVolume(copies);
  EXPECT_EQ(tests::realValues(*after.volume), tests::realValues(*before.volume));
  EXPECT_EQ(after.patient.name, "");
  EXPECT_EQ(after.series.date, before.series.date);
  EXPECT_NE(tests::readFile(root_ / "map.tsv").find(study_.series + "\t2.25."), std::string::npos);
  dialog->reject();
}

TEST_F(DeidentifyWindow, SendsCopiesAndKeepsNone) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const auto running = tests::startOrthanc(root_ / "s");
  ASSERT_TRUE(running);
  archives().put(entryOf(*running));
  DeidentifyDialog* dialog = openDialog();
  box("deidentifyToArchive").setChecked(true);
  save();
  EXPECT_EQ(status(), "Accepted: 5 of 5.");
  const auto studies = io::archive::find(running->server, {}).records;
  ASSERT_EQ(studies.size(), 1u);
  EXPECT_EQ(io::archive::valueOf(studies[0], "PatientName"), "");
  EXPECT_NE(io::archive::valueOf(studies[0], "PatientID"), study_.id);
  EXPECT_NE(io::archive::valueOf(studies[0], "StudyInstanceUID"), study_.uid);
  dialog->reject();
}

TEST_F(DeidentifyWindow, SaysThatThereIsNoFace) {
  DeidentifyDialog* dialog = openDialog();
  box("deidentifyFace").setChecked(true);
  fs::create_directories(root_ / "out");
  dialog->setFolder(QString::fromStdString((root_ / "out").string()));
  save();
  EXPECT_NE(status().find("no face is found in the series"), std::string::npos) << status();
  EXPECT_TRUE(fs::is_empty(root_ / "out"));
  dialog->reject();
}

}  // namespace
}  // namespace fenestra::viewer::deidentifyWindowTest
