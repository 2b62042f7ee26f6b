// The table of labels: its numbers, order, copies, and when it is made.

#include <gtest/gtest.h>

#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "tests/gui/Conventions.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/model/CsvText.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/LabelTable.h"

namespace fenestra::viewer::labelTableTest {
namespace {

class LabelTableWindow : public Window {
 protected:
  LabelTable& table() { return panel<LabelTable>(); }
  QTreeWidget& list() { return *table().list(); }
  void showTable() {
    window_->findChild<QDockWidget*>(QStringLiteral("labelTableDock"))->show();
    window_->findChild<QDockWidget*>(QStringLiteral("labelTableDock"))->raise();
    ASSERT_TRUE(waitForRows());
  }
  bool waitForRows() {
    return QTest::qWaitFor([this] { return table().isDone() && list().topLevelItemCount() > 0; }, patience);
  }
  QString cell(int row, int column) { return list().topLevelItem(row)->text(column); }
};

TEST_F(LabelTableWindow, TellsWhatTheVoxelsMeasure) {
  EXPECT_EQ(list().topLevelItemCount(), 0) << "nothing is computed before it is open";
  showTable();
  ASSERT_EQ(list().topLevelItemCount(), 2);
  EXPECT_EQ(cell(0, LabelTable::Name), QStringLiteral("body"));
  EXPECT_EQ(cell(1, LabelTable::Name), QStringLiteral("marker"));
  // The marker: 7 voxels of 2 mm along each axis, all of 900 HU.
  EXPECT_EQ(cell(1, LabelTable::Volume), volumeText(0.343 * 8.0));
  EXPECT_EQ(cell(1, LabelTable::Mean), QStringLiteral("900.0"));
  EXPECT_EQ(cell(1, LabelTable::Deviation), QStringLiteral("0.0"));
  EXPECT_EQ(cell(1, LabelTable::Extent), QStringLiteral("14.0 × 14.0 × 14.0"));
  EXPECT_EQ(list().headerItem()->text(LabelTable::Mean), QStringLiteral("Mean, HU"));
  EXPECT_EQ(cell(1, LabelTable::SeenByC1), QString()) << "nothing is in focus";
}

TEST_F(LabelTableWindow, IsSortedByAColumnsNumbers) {
  showTable();
  for (const auto& [column, first] : {std::pair(LabelTable::Volume, "marker"), std::pair(LabelTable::Mean, "body"),
                                      std::pair(LabelTable::Extent, "marker"), std::pair(LabelTable::Name, "body")}) {
    list().sortByColumn(column, Qt::AscendingOrder);
    EXPECT_EQ(cell(0, LabelTable::Name), QLatin1String(first)) << column;
    list().sortByColumn(column, Qt::DescendingOrder);
    EXPECT_EQ(cell(1, LabelTable::Name), QLatin1String(first)) << column;
  }
}

TEST_F(LabelTableWindow, AClickPutsTheCrosshairIntoTheLabel) {
  showTable();
  const QRect row = list().visualItemRect(list().topLevelItem(1));
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, QPoint(20, row.center().y()));
  EXPECT_LT(glm::distance(cursor().position(), markerCentre), 1e-9);
  EXPECT_EQ(document().labelAt(cursor().position())->value, marker);
}

TEST_F(LabelTableWindow, TellsTheSharesThatThePlacedCamerasSee) {
  document().focusOn(marker);
  placement().place();
  waitUntilDrawn();
  const auto share = placement().share(marker);
  ASSERT_TRUE(share);
  showTable();
  EXPECT_EQ(cell(1, LabelTable::SeenByC1), QStringLiteral("%1 %").arg(std::lround(100.0 * share->c1)));
  EXPECT_EQ(cell(1, LabelTable::SeenByC2), QStringLiteral("%1 %").arg(std::lround(100.0 * share->c2)));
  EXPECT_EQ(cell(0, LabelTable::SeenByC1), QString());
  const QString last = table().csv().section(QStringLiteral("\r\n"), 2, 2);
  EXPECT_EQ(last.section(QLatin1Char(','), -2, -2), csvNumber(share->c1));
}

TEST_F(LabelTableWindow, IsMadeAnewWhenLabelsChange) {
  showTable();
  document().renameLabel(marker, QStringLiteral("A, \"quoted\" name"));
  ASSERT_TRUE(QTest::qWaitFor(
      [this] { return table().isDone() && list().topLevelItemCount() == 2 && cell(0, 0).startsWith(QLatin1Char('A')); },
      patience));
  EXPECT_TRUE(table().csv().contains(QStringLiteral("\r\n2,\"A, \"\"quoted\"\" name\",343,2.744,900,0,900,900,HU,")))
      << table().csv().toStdString();
  document().setLabels(nullptr);
  EXPECT_EQ(list().topLevelItemCount(), 0);
  EXPECT_TRUE(table().findChild<QLabel*>()->text().startsWith(QStringLiteral("This study has no labels")));
  EXPECT_FALSE(table().findChild<QPushButton*>()->isEnabled());
}

TEST_F(LabelTableWindow, CopiesNumbersThatEveryProgramReads) {
  showTable();
  list().setCurrentItem(list().topLevelItem(1));
  QTest::keyClick(&list(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("marker\t2.74 ml\t900.0\t0.0\t14.0")));
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German));
  table().findChild<QPushButton*>()->click();
  QLocale::setDefault(before);
  const QString csv = QString::fromUtf8(QGuiApplication::clipboard()->mimeData()->data(QStringLiteral("text/csv")));
  EXPECT_TRUE(csv.startsWith(QStringLiteral("label,name,voxels,volume_ml,mean,sd,min,max,unit,")));
  EXPECT_TRUE(csv.contains(QStringLiteral("\r\n2,marker,343,2.744,900,0,900,900,HU,10,-24,10,24,-10,24,17,-17,17,")))
      << csv.toStdString();
}

}  // namespace
}  // namespace fenestra::viewer::labelTableTest

namespace fenestra::viewer {

void Conventions::addListGestures(Cases& cases) {
  const auto prepare = [this]() -> QTreeWidget& {
    auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("labelTableDock"));
    dock->show();
    dock->raise();
    QTreeWidget& list = *panel<LabelTable>().list();
    EXPECT_TRUE(QTest::qWaitFor([&] { return list.topLevelItemCount() == 2; }, patience));
    return list;
  };
  cases["DICOM tags and label table: Click on a label"] = [this, prepare] {
    QTreeWidget& list = prepare();
    cursor().moveTo({0, 0, 0});
    // The row's middle may be out of sight: its columns are wider than the panel.
    const int y = list.visualItemRect(list.topLevelItem(1)).center().y();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, QPoint(20, y));
    EXPECT_EQ(document().labelAt(cursor().position())->value, marker);
  };
  cases["DICOM tags and label table: Ctrl+C, right click"] = [this, prepare] {
    QTreeWidget& list = prepare();
    list.setCurrentItem(list.topLevelItem(1));
    for (QAction* entry : list.actions()) {
      QGuiApplication::clipboard()->clear();
      entry->trigger();
      EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("marker")));
    }
    EXPECT_EQ(list.contextMenuPolicy(), Qt::ActionsContextMenu);
    QGuiApplication::clipboard()->clear();
    QTest::keyClick(&list, Qt::Key_C, Qt::ControlModifier);
    EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("marker\t")));
    window_->findChild<QDockWidget*>(QStringLiteral("labelTableDock"))->hide();
  };
}

}  // namespace fenestra::viewer
