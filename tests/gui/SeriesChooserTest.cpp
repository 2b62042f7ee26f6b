// The list of a study's series.

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "io/VolumeReader.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/dialogs/SeriesChooser.h"

namespace fenestra::viewer::seriesChooserTest {
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
  io::OpenedVolume opened = io::openVolume(folder);
  io::Study study;
  study.series = std::move(opened.series);
  study.otherSeries = std::move(opened.otherSeries);
  return study;
}

TEST(SeriesChooser, ListsTheSeriesWithTheirPictures) {
  SeriesChooser chooser(writeStudy(tests::scratchFolder() / "study"));
  chooser.show();
  ASSERT_EQ(chooser.list()->topLevelItemCount(), 2);
  const auto text = [&](int row, int column) { return chooser.list()->topLevelItem(row)->text(column); };
  EXPECT_EQ(text(0, SeriesChooser::Patient), QStringLiteral("Vermeer, Johanna (QX-2)"));
  EXPECT_EQ(text(1, SeriesChooser::Patient), QStringLiteral("Vermeer, Johanna (QX-1)"));
  EXPECT_EQ(text(0, SeriesChooser::Number), QStringLiteral("4"));
  EXPECT_EQ(text(1, SeriesChooser::Number), QString());
  EXPECT_EQ(text(0, SeriesChooser::Type), QStringLiteral("CT"));
  EXPECT_EQ(text(0, SeriesChooser::Date), QStringLiteral("2021-02-03"));
  EXPECT_EQ(text(0, SeriesChooser::Description), QStringLiteral("Head 1.0"));
  EXPECT_EQ(text(1, SeriesChooser::Description), QStringLiteral("Scout"));
  EXPECT_EQ(text(0, SeriesChooser::Thickness), QStringLiteral("1.5 mm, every 1 mm"));
  EXPECT_EQ(text(1, SeriesChooser::Thickness), QString());
  EXPECT_EQ(text(0, SeriesChooser::Kernel), QStringLiteral("B30f"));
  EXPECT_EQ(text(0, SeriesChooser::Images), QStringLiteral("3"));
  const auto colourAt = [&](int row, double across) {
    const QImage picture = chooser.list()->topLevelItem(row)->icon(0).pixmap(chooser.list()->iconSize()).toImage();
    return picture.pixelColor(static_cast<int>(across * picture.width()), picture.height() / 2);
  };
  // The pictures come from another thread.
  for (int row = 0; row < 2; ++row) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return colourAt(row, 0.25) == QColor(Qt::white); })) << row;
    EXPECT_EQ(colourAt(row, 0.75), QColor(Qt::black)) << row;
  }
}

TEST(SeriesChooser, SaysWhichPartOfItsSeriesEachVolumeIs) {
  io::Study study = writeStudy(tests::scratchFolder() / "study");
  EXPECT_TRUE(SeriesChooser(study).list()->isColumnHidden(SeriesChooser::Part)) << "no series has parts";
  study.series.part = "echo time 4.92 ms";
  SeriesChooser chooser(study);
  EXPECT_FALSE(chooser.list()->isColumnHidden(SeriesChooser::Part));
  EXPECT_EQ(chooser.list()->topLevelItem(0)->text(SeriesChooser::Part), QStringLiteral("echo time 4.92 ms"));
  EXPECT_EQ(chooser.list()->topLevelItem(1)->text(SeriesChooser::Part), QString());
}

TEST(SeriesChooser, HidesThePatientsNames) {
  io::Study study = writeStudy(tests::scratchFolder() / "study");
  SeriesChooser hidden(study, true);
  EXPECT_EQ(hidden.list()->topLevelItem(0)->text(SeriesChooser::Patient), QStringLiteral("Patient 1"));
  EXPECT_EQ(hidden.list()->topLevelItem(1)->text(SeriesChooser::Patient), QStringLiteral("Patient 2"));
  EXPECT_FALSE(hidden.list()->isColumnHidden(SeriesChooser::Patient));
  study.otherSeries.front().patient = study.series.patient;
  EXPECT_TRUE(SeriesChooser(study, true).list()->isColumnHidden(SeriesChooser::Patient)) << "of one patient";
}

TEST(SeriesChooser, AnswersWithAnotherSeriesOnly) {
  SeriesChooser chooser(writeStudy(tests::scratchFolder() / "study"));
  EXPECT_EQ(chooser.chosen(), std::nullopt) << "the series that is open";
  chooser.list()->setCurrentItem(chooser.list()->topLevelItem(1));
  EXPECT_EQ(chooser.chosen(), "1.2.1");
}

}  // namespace
}  // namespace fenestra::viewer::seriesChooserTest
