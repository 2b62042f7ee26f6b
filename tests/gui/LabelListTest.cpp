// The list of labels, driven as a user drives it: clicks on its columns, and undo.

#include <QLineEdit>
#include <QMenu>
#include <QSpinBox>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelList.h"
#include "viewer/panels/LabelModel.h"

namespace fenestra::viewer::labelListTest {
namespace {

class LabelListWindow : public Window {
 protected:
  LabelList& list() { return *panel<FocusPanel>().list(); }
  QModelIndex cell(int row, int column) { return list().model()->index(row, column); }
  /// The row of a label.
  int rowOf(std::uint16_t label) {
    for (int row = 0; row < list().model()->rowCount(); ++row)
      if (list().labelAt(cell(row, 0)) == label) return row;
    return -1;
  }
  void click(const QModelIndex& index) {
    list().scrollTo(index);
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(index).center());
  }
  /// Chooses an entry of the menu that a click opens.
  void choose(const QModelIndex& index, const QString& entry) {
    click(index);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_TRUE(menu);
    for (QAction* action : menu->actions())
      if (action->text() == entry) QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
    ASSERT_FALSE(QApplication::activePopupWidget());
  }
  /// Undoes the last step, and checks that the look is `before` to the bit; then does it again.
  void expectUndone(const Look& before) {
    const Look after = document().look();
    EXPECT_FALSE(after == before);
    document().undoStack().undo();
    EXPECT_EQ(document().look(), before);
    document().undoStack().redo();
    EXPECT_EQ(document().look(), after);
  }
};

TEST_F(LabelListWindow, RolesAreChosenInTheirColumn) {
  const int row = rowOf(marker);
  ASSERT_GE(row, 0);
  const QImage before = picture(volume(0));
  Look look = document().look();
  choose(cell(row, LabelModel::Role), QStringLiteral("Hidden"));
  EXPECT_EQ(document().roleOf(marker), LabelRole::Hidden);
  expectUndone(look);
  waitUntilDrawn();
  look = document().look();
  choose(cell(row, LabelModel::Role), QStringLiteral("Focus"));
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{marker}}));
  EXPECT_TRUE(document().look().labels.empty()) << "being in focus is said once";
  expectUndone(look);
  look = document().look();
  choose(cell(row, LabelModel::Role), QStringLiteral("Protected"));
  EXPECT_EQ(document().focus(), Focus());
  EXPECT_EQ(document().roleOf(marker), LabelRole::Protected);
  expectUndone(look);
  choose(cell(row, LabelModel::Role), QStringLiteral("Context"));
  EXPECT_TRUE(document().look().labels.empty());
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), before) << "as at first";
}

TEST_F(LabelListWindow, Thorough_AClickIn3DMeetsAProtectedStructureInTheOpening) {
  constexpr std::uint16_t shield = 3;
  const glm::dvec3 before(17.0, -32.0, 17.0);  // in front of the marker, as the camera looks from anterior
  io::Study study = markedBall();
  const auto volume = std::const_pointer_cast<Volume>(study.scene.volume);  // not shared yet
  const auto labels = std::const_pointer_cast<LabelMap>(study.scene.labels);
  const Grid& grid = volume->grid;
  for (int i = 0; i < 6 * 6 * 6; ++i) {
    const glm::ivec3 index =
        glm::ivec3(glm::round((before - grid.origin) / grid.spacing)) - 3 + glm::ivec3(i % 6, i / 6 % 6, i / 36);
    labels->voxels.as<std::uint8_t>()[grid.offset(index)] = shield;
    volume->voxels.as<std::int16_t>()[grid.offset(index)] = 500;
  }
  labels->labels.push_back({shield, "shield"});
  open(study);
  options().setGrows(false);
  document().focusOn(marker);
  const auto met = [&] {
    waitUntilDrawn();
    QTest::mouseClick(this->volume(0), Qt::LeftButton, {}, this->volume(0)->widgetFromWorld(before)->toPoint());
    const Label* label = document().labelAt(cursor().position());
    return label ? label->value : 0;
  };
  EXPECT_EQ(met(), marker) << "the shield is cut away";
  choose(cell(rowOf(shield), LabelModel::Role), QStringLiteral("Protected"));
  EXPECT_EQ(met(), shield);
  EXPECT_LT(cursor().position().y, before.y) << "on its surface, not in it";
  click(cell(rowOf(shield), LabelModel::Visible));
  EXPECT_EQ(met(), marker) << "what is invisible is not kept";
  click(cell(rowOf(shield), LabelModel::Visible));
  options().setGrows(true);
  EXPECT_EQ(met(), shield);
  EXPECT_TRUE(document().isFocused(shield)) << "a click makes it the focus";
}

TEST_F(LabelListWindow, AnInvisibleLabelIsNotTintedOnSlices) {
  QTest::keyClick(window_.get(), Qt::Key_C);  // the crosshair is green, too
  cursor().moveTo(markerCentre);
  document().focusOn(marker);
  waitUntilDrawn();
  ASSERT_TRUE(green(slice(SlicePlane::Axial)));
  const Look look = document().look();
  click(cell(rowOf(marker), LabelModel::Visible));
  EXPECT_FALSE(document().labelSetting(marker).visible);
  EXPECT_FALSE(green(slice(SlicePlane::Axial)));
  waitUntilDrawn();
  EXPECT_FALSE(green(volume(0))) << "in focus, but not drawn";
  expectUndone(look);
  click(cell(rowOf(marker), LabelModel::Visible));
  EXPECT_TRUE(document().look().labels.empty());
  waitUntilDrawn();
  EXPECT_TRUE(green(volume(0)));
}

TEST_F(LabelListWindow, OpacityAndColourAreSteps) {
  QTest::keyClick(window_.get(), Qt::Key_C);
  document().focusOn(marker);
  waitUntilDrawn();
  Look look = document().look();
  const QModelIndex opacity = cell(rowOf(marker), LabelModel::Opacity);
  EXPECT_EQ(opacity.data().toString(), QStringLiteral("100 %"));
  click(opacity);
  auto* box = list().viewport()->findChild<QSpinBox*>();
  ASSERT_TRUE(box);
  box->setValue(35);
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return document().labelSetting(marker).opacity == 0.35; }, patience));
  EXPECT_EQ(opacity.data().toString(), QStringLiteral("35 %"));
  expectUndone(look);
  document().undoStack().undo();

  list().model()->setData(cell(rowOf(marker), LabelModel::Colour), QColor(255, 0, 0));
  EXPECT_EQ(document().labelSetting(marker).colour, glm::dvec3(1.0, 0.0, 0.0));
  expectUndone(look);
  waitUntilDrawn();
  EXPECT_FALSE(green(volume(0))) << "it is red now";
}

TEST_F(LabelListWindow, ANameIsChangedInPlace) {
  const QModelIndex name = cell(rowOf(marker), LabelModel::Name);
  const auto before = document().labels();
  list().setCurrentIndex(name);
  QTest::keyClick(&list(), Qt::Key_F2);
  auto* line = list().viewport()->findChild<QLineEdit*>();
  ASSERT_TRUE(line);
  line->setText(QStringLiteral("lesion"));
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().labels()->find(marker)->name == "lesion"; }, patience));
  EXPECT_FALSE(document().labelsAreInFile());
  document().undoStack().undo();
  EXPECT_EQ(document().labels()->labels, before->labels);
}

TEST_F(LabelListWindow, LabelsWithoutVoxelsAreFoldedAway) {
  io::Study study = markedBall();
  auto labels = std::make_shared<LabelMap>();
  labels->grid = study.scene.labels->grid;
  labels->voxels = Voxels(study.scene.labels->voxels.type(), study.scene.labels->voxels.count());
  std::copy_n(study.scene.labels->voxels.data(), labels->voxels.byteCount(), labels->voxels.data());
  labels->labels = study.scene.labels->labels;
  const int present = static_cast<int>(labels->labels.size());
  labels->labels.push_back({200, "spleen"});
  labels->labels.push_back({201, "pancreas"});
  study.scene.labels = labels;
  open(study);
  ASSERT_EQ(list().model()->rowCount(), present + 1);
  const QModelIndex folded = cell(present, 0);
  EXPECT_EQ(folded.data().toString(), QStringLiteral("2 labels without voxels"));
  EXPECT_FALSE(list().isExpanded(folded));
  click(folded);
  EXPECT_TRUE(list().isExpanded(folded));
  EXPECT_EQ(list().model()->index(1, 0, folded).data().toString(), QStringLiteral("pancreas"));
  QTest::keyClicks(panel<FocusPanel>().filter(), QStringLiteral("spl"));
  ASSERT_EQ(list().model()->rowCount(), 1);
  EXPECT_EQ(list().model()->rowCount(cell(0, 0)), 1);
}

TEST_F(LabelListWindow, LabelsAreFoundByTheirWordsInAnyOrder) {
  io::Study study = markedBall();
  auto labels = std::make_shared<LabelMap>();
  labels->grid = study.scene.labels->grid;
  labels->voxels = Voxels(study.scene.labels->voxels.type(), study.scene.labels->voxels.count());
  std::copy_n(study.scene.labels->voxels.data(), labels->voxels.byteCount(), labels->voxels.data());
  labels->labels = {{body, "kidney_left"}, {marker, "adrenal_gland_left (upper)"}};
  study.scene.labels = labels;
  open(study);
  QLineEdit& filter = *panel<FocusPanel>().filter();
  const auto found = [&](const char* text) {
    filter.setText(QString::fromLatin1(text));
    QStringList names;
    for (int row = 0; row < list().model()->rowCount(); ++row) names << cell(row, 0).data().toString();
    return names;
  };
  const QString kidney = QStringLiteral("kidney_left"), gland = QStringLiteral("adrenal_gland_left (upper)");
  for (const char* text : {"kidney_left", "kidney left", "Left kidney", " left  kid"})
    EXPECT_EQ(found(text), QStringList{kidney}) << text;
  EXPECT_EQ(found("left (up"), QStringList{gland}) << "characters of patterns stand for themselves";
  EXPECT_EQ(found("left"), (QStringList{kidney, gland}));
  EXPECT_TRUE(list().emptyText().isEmpty());
  EXPECT_EQ(found("right kidney"), QStringList{});
  EXPECT_FALSE(list().emptyText().isEmpty()) << "an empty list says why";
  EXPECT_EQ(found(""), (QStringList{kidney, gland}));
}

TEST_F(LabelListWindow, LabelsOfALargeMapAreFoldedAwayOnceItIsRead) {
  io::Study study;
  auto volume = std::make_shared<Volume>();
  auto labels = std::make_shared<LabelMap>();
  volume->grid = labels->grid = {.dims = glm::ivec3(168), .spacing = glm::dvec3(1.0), .origin = glm::dvec3(0.0)};
  volume->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
  labels->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
  std::fill_n(volume->voxels.as<std::uint8_t>().data(), volume->voxels.count(), std::uint8_t{0});
  std::fill_n(labels->voxels.as<std::uint8_t>().data(), labels->voxels.count(), std::uint8_t{0});
  labels->voxels.as<std::uint8_t>().back() = 2;
  labels->labels = {{1, "absent"}, {2, "present"}, {3, "absent too"}};
  volume->computeRange();
  study.scene.volume = volume;
  study.scene.labels = labels;
  open(study);
  ASSERT_TRUE(QTest::qWaitFor([&] { return list().model()->rowCount() == 2; }, patience));
  EXPECT_EQ(list().labelAt(cell(0, 0)), 2);
  EXPECT_EQ(cell(1, 0).data().toString(), QStringLiteral("2 labels without voxels"));
  // Another map comes while one is read: the rows are those of the last.
  document().setLabels(nullptr);
  document().setLabels(labels);
  document().setLabels(nullptr);
  EXPECT_EQ(list().model()->rowCount(), 0);
  waitUntilDrawn();
  EXPECT_EQ(list().model()->rowCount(), 0);
}

TEST_F(LabelListWindow, TheShareThatIsSeenShowsOnceCamerasArePlaced) {
  document().focusOn(marker);
  waitUntilDrawn();
  const auto seen = [&] { return cell(rowOf(marker), LabelModel::Seen).data().toString(); };
  EXPECT_EQ(seen(), QString());
  placement().place();
  ASSERT_TRUE(QTest::qWaitFor([&] { return placement().measured() != nullptr; }, patience));
  waitUntilDrawn();
  const auto share = placement().share(marker);
  ASSERT_TRUE(share);
  // This is the only label in focus, so its share is that of the focus.
  EXPECT_NEAR(share->both, placement().share().value(), 1e-12);
  EXPECT_LE(std::max(share->c1, share->c2), share->both);
  EXPECT_GE(share->c1 + share->c2, share->both);
  EXPECT_EQ(seen(), QStringLiteral("%1 %").arg(std::lround(100.0 * share->both)));
  EXPECT_FALSE(placement().share(99));
}

}  // namespace
}  // namespace fenestra::viewer::labelListTest
