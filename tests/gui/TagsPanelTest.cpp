// The list of DICOM tags: the file of the slice in view, search, copy, and what is hidden with the patient.

#include <gtest/gtest.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QTest>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "io/study/ReadStudy.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/TagsPanel.h"

namespace fenestra::viewer::tagsPanelTest {
namespace {

namespace fs = std::filesystem;

/// Slices of 16 × 16 pixels, 1 mm apart but for gaps, with their instance numbers from the top down, so that the order
/// of the files is not that of the places.
io::Study writeSlices(const fs::path& folder, const std::vector<double>& heights) {
  fs::create_directories(folder);
  for (std::size_t image = 0; image < heights.size(); ++image) {
    tests::DicomSpec spec;
    spec.patientName = "Vermeer^Johanna";
    spec.patientId = "QX-1";
    spec.date = "20210203";
    spec.kernel = "B30f";
    spec.instance = "1.2.9." + std::to_string(image);
    spec.instanceNumber = static_cast<int>(heights.size() - image);
    spec.columns = spec.rows = 16;
    spec.position = glm::dvec3(0, 0, heights[image]);
    spec.words.assign(256, 100);
    tests::writeDicom(folder / ("Vermeer-" + std::to_string(heights.size() - image)), spec);
  }
  io::DataRequest request;
  request.path = folder;
  return io::openData(request);
}

class TagList : public ::testing::Test {
 protected:
  void open(io::Study study) {
    workspace_.document.open(std::move(study));
    workspace_.cursor.setGrid(workspace_.document.study().scene.volume->grid);
  }
  QTreeWidget& list() { return *panel_.list(); }
  /// The row of a tag; null without one.
  QTreeWidgetItem* row(const char* tag) {
    for (QTreeWidgetItemIterator it(&list()); *it; ++it)
      if ((*it)->text(0) == QLatin1String(tag)) return *it;
    return nullptr;
  }
  QString value(const char* tag) {
    const QTreeWidgetItem* found = row(tag);
    return found ? found->text(3) : QStringLiteral("no such row");
  }
  bool waitForInstance(const char* uid) {
    return QTest::qWaitFor([&] { return value("(0008,0018)") == QLatin1String(uid); }, patience);
  }
  bool waitForText(const char* part) {
    return QTest::qWaitFor([&] { return panel_.text().contains(QLatin1String(part)); }, patience);
  }

  Workspace workspace_{Preferences::Mode::Transient};
  TagsPanel panel_{workspace_.document, workspace_.cursor, workspace_.planes, workspace_.options};
};

TEST_F(TagList, FollowsTheCrosshairToTheFileOfItsSlice) {
  open(writeSlices(tests::scratchFolder() / "study", {0, 1, 2, 3}));
  panel_.show();
  for (const int slice : {2, 0, 3}) {
    workspace_.cursor.moveTo({8, 8, slice});
    ASSERT_TRUE(waitForInstance(("1.2.9." + std::to_string(slice)).c_str())) << slice;
    EXPECT_EQ(panel_.text(), QStringLiteral("Slice %1 of 4 · Vermeer-%2").arg(slice + 1).arg(4 - slice));
  }
  EXPECT_EQ(value("(0010,0010)"), QStringLiteral("Vermeer^Johanna"));
  EXPECT_EQ(row("(0010,0010)")->text(1), QStringLiteral("PN"));
  EXPECT_EQ(row("(0010,0010)")->text(2), QStringLiteral("PatientName"));
  EXPECT_EQ(value("(7fe0,0010)"), QLocale().formattedDataSize(512)) << "of pixels their size alone";
}

TEST_F(TagList, SearchesAndCopies) {
  open(writeSlices(tests::scratchFolder() / "study", {0, 1, 2}));
  panel_.show();
  ASSERT_TRUE(waitForInstance("1.2.9.1"));
  panel_.search()->setText(QStringLiteral("b30F"));
  ASSERT_EQ(list().topLevelItemCount(), 1);
  EXPECT_EQ(value("(0018,1210)"), QStringLiteral("B30f"));
  list().setCurrentItem(list().topLevelItem(0));
  QTest::keyClick(&list(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("(0018,1210)\tSH\tConvolutionKernel\tB30f"));
  list().setCurrentItem(list().topLevelItem(0), 3);
  list().actions().constFirst()->trigger();
  EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("B30f"));
  panel_.search()->clear();
  EXPECT_GT(list().topLevelItemCount(), 10);
}

TEST_F(TagList, HidesThePatientAndFindsNothingHidden) {
  open(writeSlices(tests::scratchFolder() / "study", {0, 1, 2}));
  panel_.show();
  ASSERT_TRUE(waitForInstance("1.2.9.1"));
  workspace_.options.setHidesPatient(true);
  QString all = panel_.text();
  for (QTreeWidgetItemIterator it(&list()); *it; ++it)
    for (int column = 0; column < 4; ++column) all += (*it)->text(column) + (*it)->toolTip(column);
  for (const char* secret : {"Vermeer", "QX-1", "20210203", "1.2.9.1"})
    EXPECT_FALSE(all.contains(QLatin1String(secret))) << secret;
  EXPECT_EQ(value("(0010,0010)"), QStringLiteral("hidden"));
  EXPECT_EQ(value("(0018,1210)"), QStringLiteral("B30f")) << "the machine's settings stay";
  panel_.search()->setText(QStringLiteral("Vermeer"));
  EXPECT_EQ(list().topLevelItemCount(), 0);
  workspace_.options.setHidesPatient(false);
  EXPECT_EQ(value("(0010,0010)"), QStringLiteral("Vermeer^Johanna"));
}

TEST_F(TagList, SaysWhyASliceHasNoFile) {
  open(writeSlices(tests::scratchFolder() / "study", {0, 1, 2}));
  panel_.show();
  panel_.setPlane(SlicePlane::Axial);
  ASSERT_TRUE(waitForInstance("1.2.9.1"));
  const PlaneAxes axes = workspace_.planes.axes(SlicePlane::Axial);
  workspace_.planes.setAxes(SlicePlane::Axial, turned(axes, axes.right, 0.3));
  ASSERT_TRUE(waitForText("This plane is turned"));
  EXPECT_EQ(list().topLevelItemCount(), 0);
  panel_.setPlane(SlicePlane::Coronal);
  ASSERT_TRUE(waitForInstance("1.2.9.1"));
  EXPECT_TRUE(panel_.text().startsWith(QStringLiteral("Slice 2 of 3, at the crosshair")));
  panel_.setPlane({});

  open(writeSlices(tests::scratchFolder() / "gaps", {0, 1, 2, 3, 5, 6, 7}));
  ASSERT_TRUE(workspace_.document.study().geometry) << "the series lies unevenly";
  EXPECT_TRUE(waitForText("do not lie evenly"));
  open(markedBall());
  EXPECT_TRUE(waitForText("no DICOM series"));
  EXPECT_EQ(list().topLevelItemCount(), 0);
}

TEST_F(TagList, SaysThatAFileIsGone) {
  const fs::path folder = tests::scratchFolder() / "study";
  open(writeSlices(folder, {0, 1, 2}));
  fs::remove_all(folder);
  panel_.show();
  const auto isTold = [this] {
    return panel_.text().contains(QStringLiteral("Vermeer-2")) && !panel_.text().startsWith(QStringLiteral("Slice"));
  };
  ASSERT_TRUE(QTest::qWaitFor(isTold, patience)) << panel_.text().toStdString();
  EXPECT_EQ(list().topLevelItemCount(), 0);
  workspace_.options.setHidesPatient(true);
  EXPECT_EQ(panel_.text(), QStringLiteral("The file of this slice cannot be read."));
}

TEST_F(TagList, HoldsNothingWhileItIsHidden) {
  open(writeSlices(tests::scratchFolder() / "study", {0, 1, 2}));
  QTest::qWait(200);  // longer than the list waits before it reads
  EXPECT_EQ(list().topLevelItemCount(), 0);
  panel_.show();
  ASSERT_TRUE(waitForInstance("1.2.9.1"));
  panel_.hide();
  EXPECT_EQ(list().topLevelItemCount(), 0);
}

}  // namespace

TEST_F(Window, Thorough_TheTagsFollowTheActiveSlice) {
  const fs::path folder = tests::scratchFolder() / "study";
  writeSlices(folder, {0, 1, 2, 3, 4, 5, 6, 7});
  drop({folder});
  auto& tags = panel<TagsPanel>();
  QTest::keyClick(window_.get(), Qt::Key_T, Qt::ControlModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return tags.list()->topLevelItemCount() > 0; }, patience));
  QApplication::setActiveWindow(window_.get());  // or no view gets the keyboard's focus
  slice(SlicePlane::Coronal)->setFocus();
  EXPECT_TRUE(QTest::qWaitFor([&] { return tags.text().contains(QStringLiteral("at the crosshair")); }, patience));
  slice(SlicePlane::Axial)->setFocus();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !tags.text().contains(QStringLiteral("at the crosshair")); }, patience));
  const QString before = tags.text();
  wheel(slice(SlicePlane::Axial), 1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return tags.text() != before; }, patience));
  EXPECT_TRUE(tags.text().startsWith(QStringLiteral("Slice %1 of 8").arg(slice(SlicePlane::Axial)->slice() + 1)));
}

}  // namespace fenestra::viewer::tagsPanelTest
