// Slices of a series on its way are seen before it is whole, and never taken for the whole.

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QUrl>

#include "io/archive/Send.h"
#include "tests/gui/ArchiveWindow.h"
#include "viewer/archive/ArrivalView.h"

namespace fenestra::viewer::archiveArrivalTest {
namespace {

using State = Retrievals::State;

TEST_F(ArchiveWindow, ShowsTheFirstSliceOfFiveHundredAndOpensTheWhole) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const auto running = tests::startDcmqrscp(root_ / "s");
  ASSERT_TRUE(running);
  const tests::MadeStudy study = tests::makeStudy(root_ / "made", "1.2.3.78", 500);
  io::archive::send(running->server, io::archive::filesToSend({study.folder}));
  ServerEntry entry = entryOf(*running);
  enter(entry);
  // A part of the objects comes, of some 8 kB each, and then nothing: the window has to show what is there.
  const int port = entry.port;
  tests::Proxy stalling(port, {.after = 1'500'000, .stalls = true});
  entry.port = stalling.port();
  archives().put(entry);
  QElapsedTimer since;
  since.start();
  const int id = retrievals().add({entry.id, study.uid, study.series, QStringLiteral("Five hundred slices"), true});
  ArrivalView* view = dock().arrivals();
  ASSERT_TRUE(view);
  waitFor([&] { return view->isVisible() && !view->picture().isNull(); });
  std::printf("first slice of 500 shown after %lld ms\n", static_cast<long long>(since.elapsed()));
  EXPECT_EQ(view->picture().size(), QSize(64, 64) * 16) << "in square pixels, as large as a slice may be shown";
  EXPECT_FALSE(document().hasVolume());
  EXPECT_LT(view->slicesHere(), 500);
  EXPECT_TRUE(in<QLabel>(*view, "arrivalText")->text().contains(QStringLiteral("Not whole")));
  EXPECT_TRUE(view->rect().contains(window_->centralWidget()->rect())) << "it covers what was open before";

  in<QPushButton>(*view, "arrivalCancel")->click();
  EXPECT_FALSE(view->isVisible()) << "at once";
  waitFor(id, State::Paused);
  EXPECT_FALSE(document().hasVolume()) << "nothing half-loaded";

  entry.port = port;
  archives().put(entry);
  retrievals().resume(id);
  waitFor([&] { return view->isVisible(); });
  bool wasBetween = false;
  waitFor([&] {
    wasBetween = wasBetween || (!view->isVisible() && !document().hasVolume());
    return document().hasVolume();
  });
  EXPECT_FALSE(wasBetween) << "the slice stays until the study is open";
  EXPECT_EQ(document().scene().volume->grid.dims, glm::ivec3(64, 64, 500));
  EXPECT_FALSE(view->isVisible());
}

TEST_F(ArchiveWindow, ShowsAFrameOfAnObjectThatComesSlowly) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const auto running = tests::startOrthanc(root_ / "s");
  ASSERT_TRUE(running);
  constexpr int frames = 60;
  const tests::MadeFrames made = tests::makeFrames(root_ / "made", "1.2.3.77", frames);
  ASSERT_TRUE(io::archive::send(running->server, {made.file}).at(0).accepted);
  ServerEntry entry = webEntryOf(*running);
  archives().put(entry);
  archives().setAskSecret([](const ServerEntry&) { return QStringLiteral("secret word"); });
  enter(entry);
  // A quarter of the object comes, and then nothing.
  const QString url = entry.url;
  tests::Proxy stalling(QUrl(url).port(), {.after = 130'000, .stalls = true});
  entry.url = QStringLiteral("http://127.0.0.1:%1/dicom-web").arg(stalling.port());
  archives().put(entry);
  const int id = retrievals().add({entry.id, made.uid, made.series, QStringLiteral("One object"), true});
  ArrivalView* view = dock().arrivals();
  waitFor([&] { return view->isVisible() && !view->picture().isNull(); });
  EXPECT_FALSE(document().hasVolume());
  EXPECT_EQ(view->slicesHere(), 1);
  EXPECT_TRUE(in<QLabel>(*view, "arrivalText")
                  ->text()
                  .contains(QStringLiteral("frame %1 of %2").arg(frames / 2 + 1).arg(frames)));
  EXPECT_EQ(view->picture().size(), QSize(1024, 683)) << "pixels of 0.75 x 0.5 mm";

  in<QPushButton>(*view, "arrivalCancel")->click();
  waitFor(id, State::Paused);
  EXPECT_FALSE(view->isVisible());
  entry.url = url;
  archives().put(entry);
  retrievals().resume(id);
  waitFor([&] { return document().hasVolume(); });
  EXPECT_EQ(document().scene().volume->grid.dims, glm::ivec3(64, 64, frames));
  EXPECT_FALSE(view->isVisible());
}

}  // namespace
}  // namespace fenestra::viewer::archiveArrivalTest
