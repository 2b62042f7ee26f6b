// The list of what is open: patients, studies, series.

#include <gtest/gtest.h>

#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "io/study/ReadStudy.h"
#include "tests/gui/Patience.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/model/Document.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/panels/SeriesPanel.h"

namespace fenestra::viewer::seriesPanelTest {
namespace {

namespace fs = std::filesystem;

/// Two series of two patients: a scout of one image, and three slices with a bright left half.
io::Study writeStudy(const fs::path& folder) {
  fs::create_directories(folder);
  for (int image = 0; image < 4; ++image) {
    tests::DicomSpec spec;
    spec.series = image == 0 ? "1.2.1" : "1.2.2";
    spec.description = image == 0 ? "Scout" : "Head 1.0";
    spec.date = "20210203";
    spec.study = image == 0 ? "" : "Head";
    spec.patientName = "Vermeer^Johanna";
    spec.patientId = image == 0 ? "QX-1" : "QX-2";
    if (image > 0) {
      spec.seriesNumber = "4";
      spec.thickness = "1.5";
      spec.kernel = "B30f";
    }
    spec.instance = "1.2.9." + std::to_string(image);
    spec.columns = spec.rows = 16;
    spec.window = "50 100";
    spec.position = glm::dvec3(0, 0, image);
    for (int i = 0; i < 256; ++i) spec.words.push_back(i % 16 < 8 ? 100 : 0);
    tests::writeDicom(folder / std::to_string(image), spec);
  }
  io::DataRequest request;
  request.path = folder;
  return io::openData(request);
}

class SeriesList : public ::testing::Test {
 protected:
  void open(io::Study study) { document_.open(std::move(study)); }
  std::vector<QString> titles() const {
    std::vector<QString> titles;
    for (const QTreeWidgetItem* row : panel_.rows()) titles.push_back(row->text(0));
    return titles;
  }
  QColor colourAt(int row, double across) const {
    const QSize size = panel_.list()->iconSize();
    const QImage picture = panel_.rows()[static_cast<std::size_t>(row)]->icon(0).pixmap(size).toImage();
    return picture.pixelColor(static_cast<int>(across * picture.width()), picture.height() / 2);
  }

  Document document_;
  ViewOptions options_;
  SeriesPanel panel_{document_, options_};
};

TEST_F(SeriesList, ShowsPatientsStudiesAndSeriesWithTheirPictures) {
  open(writeStudy(tests::scratchFolder() / "study"));
  panel_.show();
  ASSERT_EQ(panel_.list()->topLevelItemCount(), 2);
  const QTreeWidgetItem* scout = panel_.list()->topLevelItem(0);
  const QTreeWidgetItem* head = panel_.list()->topLevelItem(1);
  EXPECT_EQ(scout->text(0), QStringLiteral("Vermeer, Johanna (QX-1)"));
  EXPECT_EQ(head->text(0), QStringLiteral("Vermeer, Johanna (QX-2)"));
  EXPECT_EQ(head->child(0)->text(0), QStringLiteral("2021-02-03 · Head"));
  EXPECT_EQ(titles(), (std::vector<QString>{QStringLiteral("Scout\nCT\n1 image"),
                                            QStringLiteral("4 · Head 1.0\nCT · 1.5 mm, every 1 mm · B30f\n3 images")}));
  // The pictures come from another thread.
  for (int row = 0; row < 2; ++row) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return colourAt(row, 0.25) == QColor(Qt::white); }, patience)) << row;
    EXPECT_EQ(colourAt(row, 0.75), QColor(Qt::black)) << row;
  }
  EXPECT_TRUE(panel_.rows()[1]->font(0).bold()) << "the thinner volume is open";
  EXPECT_FALSE(panel_.rows()[0]->font(0).bold());
  EXPECT_TRUE(panel_.rows()[1]->data(0, Qt::AccessibleTextRole).toString().endsWith(QStringLiteral("open")));
}

TEST_F(SeriesList, KeepsItsOrderWhicheverSeriesIsOpen) {
  io::Study study = writeStudy(tests::scratchFolder() / "study");
  open(study);
  panel_.show();
  const std::vector<QString> before = titles();
  std::swap(study.series, study.otherSeries.front());
  open(study);
  EXPECT_EQ(titles(), before);
  EXPECT_TRUE(panel_.rows()[0]->font(0).bold());
}

TEST_F(SeriesList, SaysWhatTellsVolumesOfASeriesApart) {
  io::Study study = writeStudy(tests::scratchFolder() / "study");
  study.series.part = "echo time 4.92 ms";
  study.series.time = 2;
  study.series.times = 5;
  open(study);
  panel_.show();
  EXPECT_EQ(titles()[1].section(QLatin1Char('\n'), 0, 0),
            QStringLiteral("4 · Head 1.0 · echo time 4.92 ms · time point 2 of 5"));
}

TEST_F(SeriesList, HidesNamesAndWhateverSomebodyTyped) {
  open(writeStudy(tests::scratchFolder() / "study"));
  panel_.show();
  options_.setHidesPatient(true);
  QString all;
  for (QTreeWidgetItemIterator it(panel_.list()); *it; ++it)
    all += (*it)->text(0) + (*it)->toolTip(0) + (*it)->data(0, Qt::AccessibleTextRole).toString();
  for (const char* secret : {"Vermeer", "QX", "Head 1.0", "Scout", "2021"})
    EXPECT_FALSE(all.contains(QLatin1String(secret))) << all.toStdString();
  EXPECT_EQ(panel_.list()->topLevelItem(0)->text(0), QStringLiteral("Patient 1"));
  EXPECT_EQ(panel_.list()->topLevelItem(1)->text(0), QStringLiteral("Patient 2"));
  EXPECT_EQ(panel_.list()->topLevelItem(1)->child(0)->text(0), QStringLiteral("Study 1"));
}

TEST_F(SeriesList, OpensAnotherSeriesOnly) {
  open(writeStudy(tests::scratchFolder() / "study"));
  panel_.show();
  QSignalSpy chosen(&panel_, &SeriesPanel::chosen);
  Q_EMIT panel_.list()->itemActivated(panel_.rows()[1], 0);
  Q_EMIT panel_.list()->itemActivated(panel_.list()->topLevelItem(0), 0);
  EXPECT_TRUE(chosen.isEmpty()) << "the series that is open, and a patient";
  Q_EMIT panel_.list()->itemActivated(panel_.rows()[0], 0);
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toString(), QStringLiteral("1.2.1"));
}

TEST_F(SeriesList, ADragBringsTheSeries) {
  open(writeStudy(tests::scratchFolder() / "study"));
  panel_.show();
  QAbstractItemModel& model = *panel_.list()->model();
  const QModelIndex study = model.index(0, 0, model.index(0, 0));
  const std::unique_ptr<QMimeData> drag(model.mimeData({model.index(0, 0, study)}));
  ASSERT_NE(drag, nullptr);
  EXPECT_EQ(SeriesPanel::seriesOf(*drag), QStringLiteral("1.2.1"));
  EXPECT_EQ(SeriesPanel::seriesOf(QMimeData()), QString());
}

TEST_F(SeriesList, HoldsNothingWhileItIsHidden) {
  open(writeStudy(tests::scratchFolder() / "study"));
  EXPECT_EQ(panel_.list()->topLevelItemCount(), 0);
  panel_.show();
  EXPECT_EQ(panel_.list()->topLevelItemCount(), 2);
  panel_.hide();
  EXPECT_EQ(panel_.list()->topLevelItemCount(), 0);
}

}  // namespace
}  // namespace fenestra::viewer::seriesPanelTest
