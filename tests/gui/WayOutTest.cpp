// The window's ways out of errors and warnings lead to menus and panels that it has, and name no option.

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

#include "tests/gui/WindowFixture.h"
#include "viewer/model/WayOutText.h"

namespace fenestra::viewer::wayOutTest {
namespace {

class WayOutWindow : public Window {
 protected:
  static QString plain(QString text) { return text.remove(QLatin1Char('&')).remove(QChar(0x2026)); }

  /// Whether the menu bar has the entry, such as "File → Choose series".
  bool hasEntry(const QString& menu, const QString& name) {
    for (const QAction* top : window_->menuBar()->actions()) {
      if (plain(top->text()) != menu || !top->menu()) continue;
      for (const QAction* entry : top->menu()->actions())
        if (plain(entry->text()) == name) return true;
    }
    return false;
  }
};

TEST_F(WayOutWindow, EachNamesWhatTheWindowHas) {
  static const QRegularExpression entry(
      QStringLiteral("(\\w+) → ([A-Z][a-z]+(?: [a-z]+)*?)(?= has| says| then|,|;|$)"));
  static const QRegularExpression dock(QStringLiteral("panel ([A-Z]\\w+)"));
  int entries = 0;
  for (int i = 1; i < io::wayOutCount; ++i) {
    const QString words = windowWords(static_cast<io::WayOut>(i));
    SCOPED_TRACE(words.toStdString());
    EXPECT_FALSE(words.isEmpty());
    EXPECT_FALSE(words.contains(QStringLiteral("--")));
    EXPECT_FALSE(std::string(io::commandLineWords(static_cast<io::WayOut>(i))).empty());
    int named = 0;
    for (auto at = entry.globalMatch(words); at.hasNext(); ++named) {
      const QRegularExpressionMatch found = at.next();
      EXPECT_TRUE(hasEntry(found.captured(1), found.captured(2))) << found.captured(0).toStdString();
    }
    EXPECT_EQ(named, words.count(QChar(0x2192)));
    entries += named;
    if (const QRegularExpressionMatch found = dock.match(words); found.hasMatch()) {
      const auto docks = window_->findChildren<QDockWidget*>();
      EXPECT_TRUE(std::any_of(docks.begin(), docks.end(), [&](const QDockWidget* each) {
        return each->windowTitle() == found.captured(1);
      })) << found.captured(0).toStdString();
    }
  }
  EXPECT_GE(entries, 5);
}

TEST_F(WayOutWindow, ErrorsOfReadersSpeakOfTheWindow) {
  const io::Error error("/data/a.nrrd", "names voxels outside its folder", io::WayOut::AllowOutside);
  EXPECT_EQ(windowText(error),
            QStringLiteral("/data/a.nrrd: names voxels outside its folder; put the file into the folder "
                           "of its header"));
  EXPECT_NE(std::string(error.what()).find("--allow-outside"), std::string::npos);
  const io::Error other("/data/a.nrrd", "is empty", "get the file again");
  EXPECT_EQ(windowText(other), QString::fromUtf8(other.what()));
  EXPECT_EQ(windowText(io::Warning{io::Warning::Kind::Other, "is odd", {}}), QStringLiteral("is odd"));
}

}  // namespace
}  // namespace fenestra::viewer::wayOutTest
