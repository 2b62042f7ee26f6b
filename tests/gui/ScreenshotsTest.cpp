// Pictures of the whole window to look at: sizes, themes and a long language, at the display's pixel ratio.
//
//   FENESTRA_SCREENSHOTS=FOLDER QT_SCALE_FACTOR=1.5 xvfb-run -a -s "-screen 0 4000x2600x24" gui_window_tests
//   with --gtest_filter=Screenshots.*

#include <QApplication>
#include <QDockWidget>
#include <QTest>

#include "tests/gui/PseudoLocale.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {
namespace {

const QSize sizes[] = {{1024, 700}, {1600, 1000}, {1920, 1200}};

class Screenshots : public Window {
 protected:
  void SetUp() override {
    folder_ = qEnvironmentVariable("FENESTRA_SCREENSHOTS");
    if (folder_.isEmpty()) GTEST_SKIP() << "FENESTRA_SCREENSHOTS names no folder";
  }
  void shoot(const QString& name) {
    Window::SetUp();
    document().focusOn(marker);
    for (const QSize& size : sizes) {
      window_->resize(size);
      waitUntilDrawn();
      const QImage picture = window_->picture();
      ASSERT_TRUE(picture.save(QStringLiteral("%1/%2-%3x%4-at-%5.png")
                                   .arg(folder_, name)
                                   .arg(size.width())
                                   .arg(size.height())
                                   .arg(window_->devicePixelRatioF())));
    }
    window_.reset();
  }

  QString folder_;
};

TEST_F(Screenshots, Dark) { shoot(QStringLiteral("dark")); }

TEST_F(Screenshots, Light) {
  applyStyle(*qApp, Theme::Light);
  shoot(QStringLiteral("light"));
  applyStyle(*qApp, Theme::Dark);
}

TEST_F(Screenshots, LongLanguage) {
  PseudoLocale locale;
  QCoreApplication::installTranslator(&locale);
  shoot(QStringLiteral("long"));
  QCoreApplication::removeTranslator(&locale);
}

}  // namespace
}  // namespace fenestra::viewer
