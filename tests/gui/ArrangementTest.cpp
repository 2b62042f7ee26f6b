// Layouts of the views: which show, what a hidden one costs, what is remembered.

#include <algorithm>

#include <QAction>
#include <QActionGroup>
#include <QDataStream>
#include <QInputDialog>
#include <QSplitter>
#include <QTest>
#include <QTimer>

#include "io/session/Session.h"
#include "tests/gui/WindowFixture.h"

namespace fenestra::viewer::arrangementTest {
namespace {

class ArrangementWindow : public Window {
 protected:
  std::vector<std::string> shown() {
    std::vector<std::string> names;
    constexpr const char* slices[] = {"axial", "sagittal", "coronal"};
    for (const VolumeView* view : views().volumeViews())
      if (view->isVisible()) names.emplace_back(view->index() == 0 ? "C1" : "C2");
    for (const SliceView* view : views().sliceViews())
      if (view->isVisible()) names.emplace_back(slices[static_cast<std::size_t>(view->plane())]);
    return names;
  }
  QRect placeOf(QWidget* view) { return {view->mapTo(&views(), QPoint(0, 0)), view->size()}; }
  QAction* entry(const QString& text) {
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->text().remove(QLatin1Char('&')) == text) return action;
    return nullptr;
  }
};

}  // namespace

TEST_F(ArrangementWindow, EachShowsItsViewsAndNoOther) {
  for (const Arrangement& each : arrangements()) {
    SCOPED_TRACE(each.id);
    views().arrange(each);
    waitUntilDrawn();
    for (const char* view : {"C1", "C2", "axial", "sagittal", "coronal"}) {
      const auto names = shown();
      EXPECT_EQ(std::find(names.begin(), names.end(), view) != names.end(), each.shows(view)) << view;
    }
    EXPECT_TRUE(views().activeView()->isVisible());
  }
}

TEST_F(ArrangementWindow, LaysViewsWhereTheMenusPictureSays) {
  views().arrange(*findArrangement("large3d"));
  waitUntilDrawn();
  EXPECT_GT(volume(0)->width(), 2 * slice(SlicePlane::Axial)->width() - 10);
  EXPECT_LT(placeOf(slice(SlicePlane::Axial)).bottom(), placeOf(slice(SlicePlane::Sagittal)).top());
  EXPECT_LT(placeOf(slice(SlicePlane::Sagittal)).bottom(), placeOf(slice(SlicePlane::Coronal)).top());
  views().arrange(*findArrangement("four"));
  waitUntilDrawn();
  EXPECT_LT(placeOf(slice(SlicePlane::Axial)).right(), placeOf(volume(0)).left());
  EXPECT_LT(placeOf(slice(SlicePlane::Axial)).bottom(), placeOf(slice(SlicePlane::Coronal)).top());
  EXPECT_NEAR(volume(0)->width(), slice(SlicePlane::Coronal)->width(), 8);
  views().arrange(*findArrangement("slices"));
  waitUntilDrawn();
  EXPECT_EQ(placeOf(slice(SlicePlane::Axial)).top(), placeOf(slice(SlicePlane::Coronal)).top());
  EXPECT_NEAR(slice(SlicePlane::Axial)->height(), views().height(), 8);
}

TEST_F(ArrangementWindow, AHiddenViewDrawsNothing) {
  views().arrange(*findArrangement("slices"));
  waitUntilDrawn();
  int drawn = 0;
  QObject::connect(&views(), &ViewArea::drawn, &views(), [&] { ++drawn; });
  cameras().orbit(0, 0.4, 0.2);
  document().focusOn(marker);
  waitUntilDrawn();
  QTest::qWait(200);  // longer than pictures wait for rest, 150 ms
  EXPECT_EQ(drawn, 0);
  views().arrange(arrangements().front());
  waitUntilDrawn();
  EXPECT_GT(drawn, 0) << "and what has changed meanwhile shows";
  EXPECT_TRUE(green(volume(0)));
}

TEST_F(ArrangementWindow, KeepsTheSizesOfEach) {
  views().arrange(*findArrangement("large3d"));
  waitUntilDrawn();
  auto* rows = qobject_cast<QSplitter*>(volume(0)->parentWidget()->parentWidget());
  ASSERT_TRUE(rows);
  rows->setSizes({600, 200});
  waitUntilDrawn();
  const int width = volume(0)->width();
  views().arrange(*findArrangement("pair"));
  waitUntilDrawn();
  EXPECT_NE(volume(0)->width(), width);
  views().arrange(*findArrangement("large3d"));
  waitUntilDrawn();
  EXPECT_NEAR(volume(0)->width(), width, 2);
}

TEST_F(ArrangementWindow, AMaximisedViewHasItsNeighboursOneKeyAway) {
  views().arrange(*findArrangement("large3d"));
  views().toggleMaximised(slice(SlicePlane::Axial));
  const std::vector<std::vector<std::string>> wanted{{"sagittal"}, {"coronal"}, {"C1"}, {"C2"}, {"axial"}};
  for (const auto& each : wanted) {
    views().showNeighbour(1);
    EXPECT_EQ(shown(), each);
    EXPECT_TRUE(views().isMaximised());
    EXPECT_EQ(views().activeView(), QApplication::focusWidget());
  }
  views().showNeighbour(-1);
  EXPECT_EQ(shown(), std::vector<std::string>{"C2"});
  views().showAll();
  EXPECT_EQ(shown(), (std::vector<std::string>{"C1", "axial", "sagittal", "coronal"})) << "those of the arrangement";
  EXPECT_EQ(views().activeView(), volume(0)) << "C2 is hidden again";
}

TEST_F(ArrangementWindow, SessionsKeepIt) {
  views().arrange(*findArrangement("four"));
  views().toggleMaximised(slice(SlicePlane::Coronal));
  io::Session session;
  views().describe(session);
  views().showAll();
  views().arrange(*findArrangement("pair"));
  views().restore(session);
  EXPECT_EQ(shown(), std::vector<std::string>{"coronal"});
  views().showAll();
  EXPECT_EQ(views().arrangement().id, std::string("four"));
}

TEST_F(ArrangementWindow, LayoutsOfBeforeAreOfFiveViews) {
  // What was written before there were arrangements: the states of three splitters alone.
  QByteArray before;
  {
    QSplitter rows(Qt::Vertical), upper(Qt::Horizontal), lower(Qt::Horizontal);
    for (int i = 0; i < 2; ++i) rows.addWidget(new QWidget);
    for (int i = 0; i < 2; ++i) upper.addWidget(new QWidget);
    for (int i = 0; i < 3; ++i) lower.addWidget(new QWidget);
    rows.setSizes({300, 300});
    QDataStream stream(&before, QIODevice::WriteOnly);
    stream << rows.saveState() << upper.saveState() << lower.saveState();
  }
  views().arrange(*findArrangement("slices"));
  views().restoreLayout(before);
  EXPECT_EQ(shown().size(), 5u);
  EXPECT_EQ(&views().arrangement(), &arrangements().front());
  waitUntilDrawn();
  EXPECT_LT(placeOf(volume(0)).bottom(), placeOf(slice(SlicePlane::Axial)).top());

  for (const QByteArray& damaged :
       {QByteArray(), QByteArray("x"), before.left(before.size() / 2), QByteArray(40, '\xff')}) {
    views().restoreLayout(damaged);
    waitUntilDrawn();
    EXPECT_EQ(shown().size(), 5u);
  }
}

TEST_F(ArrangementWindow, TheUsersOwnIsKeptByName) {
  views().arrange(*findArrangement("beside"));
  QTimer::singleShot(0, [] {
    auto* ask = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
    ASSERT_TRUE(ask);
    ask->setTextValue(QStringLiteral("Reading & report"));
    ask->accept();
  });
  window_->findChild<QAction*>(QStringLiteral("keepLayout"))->trigger();
  views().arrange(arrangements().front());
  QAction* own = nullptr;
  for (QAction* action : window_->findChildren<QAction*>())
    if (action->text() == QStringLiteral("Reading && report") && qobject_cast<QActionGroup*>(action->parent()))
      own = action;
  ASSERT_TRUE(own);
  own->trigger();
  EXPECT_EQ(shown(), (std::vector<std::string>{"C1", "axial"}));
  EXPECT_EQ(window_->workspace().preferences.ownLayouts().size(), 1);
}

TEST_F(ArrangementWindow, TheNextStartHasTheLastOne) {
  useScratchSettings();
  const MainWindow::Setup setup{.gl = {.problem = QStringLiteral("slices are enough here")}};
  {
    MainWindow window(setup);
    window.show();
    window.views().arrange(*findArrangement("axial"));
    window.close();
  }
  {
    MainWindow again(setup);
    EXPECT_EQ(again.views().arrangement().id, std::string("axial"));
    again.views().arrange(arrangements().front());
    again.close();
  }
}

}  // namespace fenestra::viewer::arrangementTest
