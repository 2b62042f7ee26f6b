// The settings dialog: what it changes takes effect at once, in the menus too.

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "viewer/SettingsDialog.h"

namespace fenestra::viewer {
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
}  // namespace fenestra::viewer
