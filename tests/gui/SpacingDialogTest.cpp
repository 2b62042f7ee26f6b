// The dialog that asks for the size of voxels, and a stack of TIFF that is opened by it.

#include <QDialogButtonBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "tests/gui/WindowFixture.h"
#include "tests/io/TiffFiles.h"
#include "tests/support/TestData.h"
#include "viewer/dialogs/SpacingDialog.h"

namespace fenestra::viewer {
namespace {

class SpacingWindow : public Window {};

TEST_F(SpacingWindow, TheDialogTakesThreePositiveNumbers) {
  SpacingDialog dialog(QStringLiteral("a.tif does not say how large its voxels are."), window_.get());
  QPushButton* open = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
  EXPECT_FALSE(open->isEnabled());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_FALSE(open->isEnabled());
    dialog.fields()[axis]->setValue(0.01 * static_cast<double>(axis + 1));
  }
  EXPECT_TRUE(open->isEnabled());
  EXPECT_EQ(dialog.spacing(), glm::dvec3(0.01, 0.02, 0.03));
  dialog.fields()[1]->setValue(0.0);
  EXPECT_FALSE(open->isEnabled());
}

TEST_F(SpacingWindow, AStackWithoutASizeIsOpenedWithTheOneThatIsSaid) {
  const std::filesystem::path folder = tests::scratchFolder() / "stack";
  std::filesystem::create_directories(folder);
  tests::TiffSpec spec{.width = 16, .height = 16, .pages = 1};
  for (int i = 0; i < 8; ++i) {
    spec.first = 256 * i;
    tests::writeTiff(folder / ("slice" + std::to_string(i) + ".tif"), spec);
  }
  bool asked = false;
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, [&] {
    auto* dialog = window_->findChild<SpacingDialog*>();
    if (!dialog || !dialog->isVisible()) return;
    asked = true;
    answer.stop();
    for (QDoubleSpinBox* field : dialog->fields()) field->setValue(0.02);
    dialog->accept();
  });
  answer.start(20);
  window_->open(std::vector<std::filesystem::path>{folder});
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return document().hasVolume() && document().scene().volume->grid.dims == glm::ivec3(16, 16, 8); }, 30000));
  EXPECT_TRUE(asked);
  EXPECT_EQ(document().scene().volume->grid.spacing, glm::dvec3(0.02));
}

}  // namespace
}  // namespace fenestra::viewer
