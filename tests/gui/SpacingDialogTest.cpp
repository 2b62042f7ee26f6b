// The dialog that asks for the size of voxels, and a stack of TIFF that is opened by it.

#include <optional>

#include <QAction>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "tests/gui/WindowFixture.h"
#include "tests/io/TiffFiles.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/dialogs/SpacingDialog.h"
#include "viewer/files/Sessions.h"

namespace fenestra::viewer::spacingDialogTest {
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

/// Eight slices that do not say how large their voxels are.
std::filesystem::path writeStack() {
  const std::filesystem::path folder = tests::scratchFolder() / "stack";
  std::filesystem::create_directories(folder);
  tests::TiffSpec spec{.width = 16, .height = 16, .pages = 1};
  for (int i = 0; i < 8; ++i) {
    spec.first = 256 * i;
    tests::writeTiff(folder / ("slice" + std::to_string(i) + ".tif"), spec);
  }
  return folder;
}

/// Does something that makes the window ask, and says `millimetres`. Returns what the fields held before.
glm::dvec3 answered(MainWindow& window, double millimetres, const std::function<void()>& act,
                    const std::function<bool()>& isDone) {
  std::optional<glm::dvec3> before;
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, [&] {
    auto* dialog = window.findChild<SpacingDialog*>();
    if (!dialog || !dialog->isVisible()) return;
    before = dialog->spacing();
    answer.stop();
    for (QDoubleSpinBox* field : dialog->fields()) field->setValue(millimetres);
    dialog->accept();
  });
  answer.start(20);
  act();
  EXPECT_TRUE(QTest::qWaitFor(isDone, patience));
  EXPECT_TRUE(before.has_value()) << "the window did not ask";
  return before.value_or(glm::dvec3(-1.0));
}

TEST_F(SpacingWindow, AStackWithoutASizeIsOpenedWithTheOneThatIsSaid) {
  const std::filesystem::path folder = writeStack();
  const auto isOpen = [this] { return document().scene().volume->grid.dims == glm::ivec3(16, 16, 8); };
  answered(
      *window_, 0.02, [&] { window_->open(std::vector<std::filesystem::path>{folder}); }, isOpen);
  EXPECT_EQ(document().scene().volume->grid.spacing, glm::dvec3(0.02));
}

TEST_F(SpacingWindow, AStackThatIsNamedAtTheStartIsAskedAbout) {
  io::StudyRequest request;
  request.path = writeStack();
  const auto isOpen = [this] { return document().scene().volume->grid.dims == glm::ivec3(16, 16, 8); };
  answered(
      *window_, 0.03, [&] { window_->sessions().open([request] { return request; }); }, isOpen);
  EXPECT_EQ(document().scene().volume->grid.spacing, glm::dvec3(0.03));
  EXPECT_TRUE(window_->notices().texts().filter(QStringLiteral("how large")).isEmpty());
}

TEST_F(SpacingWindow, ASizeThatWasSaidWronglyIsCorrectedInTheMenu) {
  QAction* size = nullptr;
  for (QAction* each : window_->findChildren<QAction*>())
    if (each->text() == QStringLiteral("Si&ze of the voxels…")) size = each;
  ASSERT_NE(size, nullptr);
  EXPECT_FALSE(size->isEnabled()) << "other formats say it themselves";
  const std::filesystem::path folder = writeStack();
  const auto has = [this](double millimetres) {
    return [this, millimetres] { return document().scene().volume->grid.spacing == glm::dvec3(millimetres); };
  };
  answered(
      *window_, 0.02, [&] { window_->open(std::vector<std::filesystem::path>{folder}); }, has(0.02));
  ASSERT_TRUE(size->isEnabled());
  EXPECT_EQ(answered(
                *window_, 0.05, [&] { size->trigger(); }, has(0.05)),
            glm::dvec3(0.02));
}

}  // namespace
}  // namespace fenestra::viewer::spacingDialogTest
