// Key images: what comes back, how the list is edited, and that sessions keep it.

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "io/session/SessionFile.h"
#include "tests/gui/Conventions.h"
#include "tests/support/TestData.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/SessionController.h"
#include "viewer/panels/KeyImagesPanel.h"

namespace fenestra::viewer::keyImagesTest {
namespace {

class KeyImageList : public Window {
 protected:
  KeyImages& images() { return window_->workspace().keyImages; }
  SlicePlanes& planes() { return window_->workspace().planes; }
  QListWidget& list() { return *panel<KeyImagesPanel>().list(); }
  void keep() { QTest::keyClick(window_.get(), Qt::Key_D, Qt::ControlModifier); }
  void showPanel() {
    auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("keyImagesDock"));
    dock->show();
    dock->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return list().isVisible(); }, patience));
  }
  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const io::KeyImage& each : document().keyImages()) names.push_back(each.name);
    return names;
  }
  QPoint placeOf(int row) { return list().visualItemRect(list().item(row)).center(); }
};

TEST_F(KeyImageList, AClickBringsBackAllThatThePicturesAreMadeOf) {
  document().focusOn(marker);
  cameras().orbit(0, 0.4, 0.2);
  cursor().moveTo(markerCentre);
  document().setWindow({321.0, 12.0});
  document().setInverted(true);
  const PlaneAxes axes = planes().axes(SlicePlane::Sagittal);
  planes().setAxes(SlicePlane::Sagittal, turned(axes, axes.down, 0.5));
  planes().setSlab(SlicePlane::Axial, {7.0, SlabMode::Mean});
  const Look look = document().look();
  const ViewLink::Pose pose = cameras().pose();
  const auto poses = planes().poses();
  showPanel();
  keep();
  ASSERT_EQ(document().keyImages().size(), 1u);

  document().focusOn(body);
  document().setShift(50.0);
  cameras().orbit(0, -1.0, 0.3);
  cursor().moveTo({0, 0, 0});
  document().setInverted(false);
  document().resetWindow();
  planes().resetAll();
  planes().setSlab(SlicePlane::Axial, {});
  waitUntilDrawn();
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOf(0));
  EXPECT_EQ(document().look(), look);
  EXPECT_EQ(cameras().pose().cameras, pose.cameras);
  EXPECT_EQ(planes().poses(), poses);
  EXPECT_LT(glm::distance(cursor().position(), markerCentre), 1e-9);
  EXPECT_EQ(document().window(), (WindowLevel{321.0, 12.0}));
  EXPECT_TRUE(document().isInverted());
  document().undoStack().undo();
  EXPECT_NE(cameras().pose().cameras, pose.cameras) << "going back is undone";
  EXPECT_TRUE(document().isFocused(body)) << "in one step";
  document().undoStack().redo();
  EXPECT_EQ(cameras().pose().cameras, pose.cameras);
  EXPECT_EQ(document().look(), look);
}

TEST_F(KeyImageList, TheCamerasStayThoughTheFocusPlacesThem) {
  setAutomatic(true);
  document().focusOn(body);
  waitUntilDrawn();
  cameras().orbit(0, 0.7, 0.1);
  const auto kept = cameras().pose().cameras;
  keep();
  document().focusOn(marker);
  waitUntilDrawn();
  ASSERT_NE(cameras().pose().cameras, kept) << "a focus places the cameras";
  images().show(0);
  QTest::qWait(400);  // longer than placing waits for a next focus
  waitUntilDrawn();
  EXPECT_EQ(cameras().pose().cameras, kept);
}

TEST_F(KeyImageList, ALabelThatIsGoneLeavesTheFocus) {
  document().focusOn(marker);
  keep();
  document().setLabels(nullptr);
  images().show(0);
  EXPECT_EQ(document().focus(), Focus(std::monostate{}));
  waitUntilDrawn();
}

TEST_F(KeyImageList, IsNamedOrderedAndUndone) {
  showPanel();
  for (int i = 0; i < 3; ++i) keep();
  EXPECT_EQ(names(), (std::vector<std::string>{"Key image 1", "Key image 2", "Key image 3"}));
  ASSERT_EQ(list().count(), 3);
  EXPECT_FALSE(KeyImages::pictureOf(document().keyImages()[0]).isNull());
  list().setCurrentRow(2);
  const auto arrows = panel<KeyImagesPanel>().findChildren<QToolButton*>();
  arrows[0]->click();
  EXPECT_EQ(names(), (std::vector<std::string>{"Key image 1", "Key image 3", "Key image 2"}));
  EXPECT_EQ(list().currentRow(), 1);
  arrows[1]->click();
  EXPECT_EQ(names()[2], "Key image 3");
  document().undoStack().undo();
  EXPECT_EQ(names()[1], "Key image 3");
  images().rename(0, QStringLiteral("  كيس \n é  "));
  EXPECT_EQ(names()[0], QStringLiteral("كيس é").toStdString());
  images().rename(0, QStringLiteral("   "));
  EXPECT_EQ(names()[0], QStringLiteral("كيس é").toStdString());
  images().rename(0, QString(300, QChar(0x4e2d)));
  EXPECT_LE(names()[0].size(), io::KeyImage::longestName);
  list().setCurrentRow(1);
  panel<KeyImagesPanel>().findChildren<QPushButton*>()[1]->click();
  EXPECT_EQ(document().keyImages().size(), 2u);
  document().undoStack().undo();
  EXPECT_EQ(document().keyImages().size(), 3u);
}

TEST_F(KeyImageList, SessionsKeepIt) {
  keep();
  images().rename(0, QStringLiteral("Stenosis"));
  io::Session session = window_->sessions().controller().session();
  session.phantom = {"head", 32};
  const std::filesystem::path file = tests::scratchFolder() / "a.fenestra";
  io::writeSession(file, session);
  io::Study again = markedBall();
  again.session = io::readSession(file);
  const std::vector<io::KeyImage> kept = document().keyImages();
  open(markedBall());
  EXPECT_TRUE(document().keyImages().empty()) << "they belong to the study";
  open(again);
  EXPECT_EQ(document().keyImages(), kept);
}

}  // namespace
}  // namespace fenestra::viewer::keyImagesTest

namespace fenestra::viewer {

void Conventions::addKeyImageGestures(Cases& cases) {
  const auto prepare = [this]() -> QListWidget& {
    auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("keyImagesDock"));
    dock->show();
    dock->raise();
    document().setKeyImages({}, {});
    cursor().moveTo(markerCentre);
    press("Ctrl+D");
    cursor().moveTo({0, 0, 0});
    QListWidget& list = *panel<KeyImagesPanel>().list();
    EXPECT_TRUE(QTest::qWaitFor([&] { return list.count() == 1; }, patience));
    list.setCurrentRow(0);
    return list;
  };
  cases["Key images: Click, Return"] = [this, prepare] {
    QListWidget& list = prepare();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(0)).center());
    EXPECT_LT(glm::distance(cursor().position(), markerCentre), 1e-9);
    cursor().moveTo({0, 0, 0});
    QTest::keyClick(&list, Qt::Key_Return);
    EXPECT_LT(glm::distance(cursor().position(), markerCentre), 1e-9);
  };
  cases["Key images: F2"] = [this, prepare] {
    QListWidget& list = prepare();
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_F2);
    auto* box = list.findChild<QLineEdit*>();
    ASSERT_TRUE(box);
    box->setText(QStringLiteral("Stenosis"));
    QTest::keyClick(box, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return document().keyImages()[0].name == "Stenosis"; }, patience));
    window_->findChild<QDockWidget*>(QStringLiteral("keyImagesDock"))->hide();
  };
}

}  // namespace fenestra::viewer
