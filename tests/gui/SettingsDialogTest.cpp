// The settings dialog: what it changes takes effect at once, in the menus too.

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "io/VolumeWriter.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/dialogs/SettingsDialog.h"
#include "viewer/files/Sessions.h"
#include "viewer/panels/ColourButton.h"

namespace fenestra::viewer::settingsDialogTest {
namespace {

class Settings : public Window {
 protected:
  Preferences& preferences() { return window_->workspace().preferences; }
};

TEST_F(Settings, ARowForEachPreferenceShowsAndChangesIt) {
  SettingsDialog dialog(preferences(), window_.get());
  dialog.show();
  for (const PreferenceEntry& entry : preferenceTable()) {
    SCOPED_TRACE(entry.key);
    auto* control = dialog.findChild<QWidget*>(QLatin1String(entry.key));
    ASSERT_TRUE(control);
    EXPECT_FALSE(control->toolTip().isEmpty());
    if (auto* box = qobject_cast<QCheckBox*>(control)) {
      EXPECT_EQ(box->isChecked(), entry.otherwise != 0);
      QTest::keyClick(box, Qt::Key_Space);
      EXPECT_EQ(preferences().isOn(entry.which), entry.otherwise == 0);
    } else if (auto* colour = qobject_cast<ColourButton*>(control)) {
      Q_EMIT colour->edited({1.0, 0.5, 0.0});
      EXPECT_EQ(preferences().value(entry.which), 0xff8000);
    } else if (auto* choice = qobject_cast<QComboBox*>(control)) {
      EXPECT_EQ(choice->count(), entry.high + 1);
      EXPECT_EQ(choice->currentIndex(), entry.otherwise);
      QTest::keyClick(choice, Qt::Key_Down);
      EXPECT_EQ(preferences().value(entry.which), entry.otherwise + 1);
    } else {
      auto* number = qobject_cast<QSpinBox*>(control);
      ASSERT_TRUE(number);
      EXPECT_EQ(number->value(), entry.otherwise);
      QTest::keyClick(number, Qt::Key_Up);
      EXPECT_EQ(preferences().value(entry.which), entry.otherwise + 1);
    }
  }
  QPushButton* defaults = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults);
  QTest::mouseClick(defaults, Qt::LeftButton);
  for (const PreferenceEntry& entry : preferenceTable()) {
    EXPECT_EQ(preferences().value(entry.which), entry.otherwise) << entry.key;
    if (auto* box = dialog.findChild<QCheckBox*>(QLatin1String(entry.key))) {
      EXPECT_EQ(box->isChecked(), entry.otherwise != 0);
    }
  }
}

TEST_F(Settings, BackgroundAndUnitAreThoseOfDataOpenedNext) {
  const std::filesystem::path file = tests::scratchFolder() / "ball.nii.gz";
  io::writeVolume(*markedBall().scene.volume, file);
  const Look before = document().look();
  preferences().set(Preference::Background, 0x204060);
  preferences().set(Preference::WidthUnit, static_cast<int>(WidthUnit::Millimetre));
  EXPECT_EQ(document().look(), before) << "what is open stays as it is";
  const auto openFile = [&](const std::filesystem::path& path) {
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    window_->open({path});
    ASSERT_TRUE(opened.count() > 0 || opened.wait(patience));
    waitUntilDrawn();
  };
  openFile(file);
  EXPECT_LT(glm::distance(document().look().background, glm::dvec3(0x20, 0x40, 0x60) / 255.0), 1e-12);
  EXPECT_EQ(document().look().cutaway.unit, WidthUnit::Millimetre);
  const QColor corner = picture(volume(0)).pixelColor(4, picture(volume(0)).height() / 2);
  EXPECT_EQ(corner.rgb() & 0xffffffu, 0x204060u);
  EXPECT_FALSE(document().undoStack().canUndo());
  // A session has its own.
  const std::filesystem::path session = file.parent_path() / "a.fenestra";
  window_->sessions().controller().save(session);
  ASSERT_TRUE(window_->sessions().controller().waitUntilSaved());
  const Look saved = document().look();
  preferences().restoreDefaults();
  openFile(session);
  EXPECT_EQ(document().look().background, saved.background);
  EXPECT_EQ(document().look().cutaway.unit, saved.cutaway.unit);
}

TEST_F(Settings, TakeEffectAtOnce) {
  preferences().set(Preference::AnimatedCameras, 0);
  EXPECT_FALSE(cameras().isAnimated());
  EXPECT_FALSE(window_->findChild<QAction*>(QStringLiteral("animated"))->isChecked());
  window_->findChild<QAction*>(QStringLiteral("animated"))->trigger();
  EXPECT_TRUE(preferences().isOn(Preference::AnimatedCameras) && cameras().isAnimated());
  preferences().set(Preference::HidesPatient, 1);
  EXPECT_TRUE(options().hidesPatient());
  const QColor dark = QApplication::palette().window().color();
  preferences().set(Preference::LightTheme, 1);
  EXPECT_GT(QApplication::palette().window().color().lightness(), dark.lightness() + 50);
  preferences().set(Preference::LightTheme, 0);
  EXPECT_EQ(QApplication::palette().window().color(), dark);
}

}  // namespace
}  // namespace fenestra::viewer::settingsDialogTest
