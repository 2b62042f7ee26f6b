// Sending what is open to an archive, with the server's answer to each object.

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "io/archive/Query.h"
#include "tests/gui/ArchiveWindow.h"
#include "viewer/archive/SendDialog.h"

namespace fenestra::viewer::archiveSendTest {
namespace {

TEST_F(ArchiveWindow, SendsTheOpenSeriesAndItsLabels) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const auto running = tests::startOrthanc(root_ / "s");
  ASSERT_TRUE(running);
  auto* entry = window_->findChild<QAction*>(QStringLiteral("sendToArchive"));
  EXPECT_FALSE(entry->isEnabled());
  open(markedBall());
  EXPECT_FALSE(entry->isEnabled()) << "no DICOM";
  const tests::MadeStudy study = tests::makeStudy(root_ / "made", "1.2.3.79", 5);
  drop({study.folder});
  ASSERT_TRUE(entry->isEnabled());
  auto labels = std::make_shared<LabelMap>();
  labels->grid = document().scene().volume->grid;
  labels->voxels = Voxels(ScalarType::UInt8, labels->grid.voxelCount());
  labels->voxels.as<std::uint8_t>()[70] = 1;
  labels->labels = {{1, "spot", {1.0, 0.0, 0.0}}};
  document().setLabels(labels, {});
  entry->trigger();
  EXPECT_TRUE(dock().isVisible()) << "without a server, the dock says how to enter one";
  archives().put(entryOf(*running));
  entry->trigger();
  auto* dialog = window_->findChild<SendDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_TRUE(io::archive::find(running->server, {}).records.empty()) << "nothing is sent before the user says so";
  in<QCheckBox>(*dialog, "sendSeries")->setChecked(true);
  EXPECT_TRUE(in<QCheckBox>(*dialog, "sendLabels")->isChecked());
  auto* commit = in<QCheckBox>(*dialog, "sendCommit");
  EXPECT_FALSE(commit->isChecked()) << "our port is opened for who asks for it alone";
  commit->setChecked(true);
  in<QPushButton>(*dialog, "sendNow")->click();
  waitFor([&] { return !dialog->isBusy(); });
  auto* answers = in<QTreeWidget>(*dialog, "sendAnswers");
  EXPECT_EQ(in<QLabel>(*dialog, "sendStatus")->text().toStdString(),
            "Accepted: 6 of 6.\nConfirmed to be kept: 6 of 6.");
  ASSERT_EQ(answers->topLevelItemCount(), 6);
  EXPECT_EQ(answers->topLevelItem(5)->text(1), QStringLiteral("accepted, kept"));
  commit->setChecked(false);
  in<QPushButton>(*dialog, "sendNow")->click();
  waitFor([&] { return !dialog->isBusy(); });
  const std::string status = in<QLabel>(*dialog, "sendStatus")->text().toStdString();
  EXPECT_EQ(status, "Accepted: 6 of 6.");
  ASSERT_EQ(answers->topLevelItemCount(), 6);
  EXPECT_EQ(answers->topLevelItem(5)->text(0), QStringLiteral("Labels"));
  EXPECT_EQ(answers->topLevelItem(5)->text(1), QStringLiteral("accepted"));
  const io::archive::Answers series =
      io::archive::find(running->server, {io::archive::Level::Series, {{"StudyInstanceUID", study.uid}}});
  std::set<std::string> kinds;
  for (const io::archive::Attributes& each : series.records) kinds.insert(io::archive::valueOf(each, "Modality"));
  EXPECT_EQ(kinds, (std::set<std::string>{"CT", "SEG"})) << "in the study that they belong to";
  dialog->reject();
}

TEST_F(ArchiveWindow, AServerThatConfirmsNothingIsSaidInTheDialog) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const auto running = tests::startDcmqrscp(root_ / "s");
  ASSERT_TRUE(running);
  drop({tests::makeStudy(root_ / "made", "1.2.3.81", 2).folder});
  archives().put(entryOf(*running));
  tests::RunningServer web;
  web.web = "http://127.0.0.1:1/dicom-web";
  archives().put(webEntryOf(web));
  dock().showSendDialog();
  auto* dialog = window_->findChild<SendDialog*>();
  auto* commit = in<QCheckBox>(*dialog, "sendCommit");
  EXPECT_TRUE(commit->isEnabled());
  dialog->findChild<QComboBox*>()->setCurrentIndex(1);
  EXPECT_FALSE(commit->isEnabled()) << "DICOMweb has none";
  dialog->findChild<QComboBox*>()->setCurrentIndex(0);
  commit->setChecked(true);
  in<QCheckBox>(*dialog, "sendSeries")->setChecked(true);
  in<QPushButton>(*dialog, "sendNow")->click();
  waitFor([&] { return !dialog->isBusy(); });
  const std::string status = in<QLabel>(*dialog, "sendStatus")->text().toStdString();
  EXPECT_NE(status.find("Accepted: 2 of 2.\nNone is confirmed to be kept: "), std::string::npos) << status;
  EXPECT_NE(status.find("does not offer storage commitment"), std::string::npos) << status;
  EXPECT_EQ(in<QTreeWidget>(*dialog, "sendAnswers")->topLevelItem(1)->text(1), QStringLiteral("accepted"));
}

TEST_F(ArchiveWindow, AServerThatIsGoneIsSaidInTheDialog) {
  const tests::MadeStudy study = tests::makeStudy(root_ / "made", "1.2.3.80", 2);
  drop({study.folder});
  tests::RunningServer none;
  none.server.host = "127.0.0.1";
  none.server.title = "NONE";
  none.server.port = tests::freePort();
  archives().put(entryOf(none));
  dock().showSendDialog();
  auto* dialog = window_->findChild<SendDialog*>();
  EXPECT_FALSE(in<QPushButton>(*dialog, "sendNow")->isEnabled()) << "nothing is chosen";
  in<QCheckBox>(*dialog, "sendSeries")->setChecked(true);
  in<QPushButton>(*dialog, "sendNow")->click();
  waitFor([&] { return !dialog->isBusy(); });
  EXPECT_TRUE(in<QLabel>(*dialog, "sendStatus")->text().contains(QStringLiteral("nothing listens on port")))
      << in<QLabel>(*dialog, "sendStatus")->text().toStdString();
  EXPECT_TRUE(in<QPushButton>(*dialog, "sendNow")->isEnabled()) << "to be tried again";
}

}  // namespace
}  // namespace fenestra::viewer::archiveSendTest
