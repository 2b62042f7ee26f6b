// The window answers while archives are slow, silent or hold much. Timed: the machine is its own.

#include <algorithm>

#include <QElapsedTimer>
#include <QTest>
#include <QTimer>
#include <QTreeView>

#include "io/archive/Send.h"
#include "tests/gui/ArchiveWindow.h"

namespace fenestra::viewer::archiveAnswersTest {
namespace {

/// The longest time, ms, between two turns of the event loop.
class LongestGap {
 public:
  LongestGap() {
    QObject::connect(&timer_, &QTimer::timeout, [this] { longest_ = std::max(longest_, since_.restart()); });
    since_.start();
    timer_.start(1);
  }
  qint64 longest() const { return longest_; }

 private:
  QTimer timer_;
  QElapsedTimer since_;
  qint64 longest_ = 0;
};

constexpr qint64 most = 100;  // ms, in which a person takes an answer for immediate

class ArchiveAnswers : public ArchiveWindow {};

TEST_F(ArchiveAnswers, WithTenThousandStudies) {
  dock().show();
  QTest::qWait(200);
  std::vector<io::archive::Attributes> studies;
  for (int i = 0; i < 10'000; ++i)
    studies.push_back({{"PatientName", "Doe^" + std::to_string(i)},
                       {"PatientID", std::to_string(i)},
                       {"StudyInstanceUID", "1.2.3." + std::to_string(i)},
                       {"StudyDate", "20240101"},
                       {"ModalitiesInStudy", "CT\\SEG"}});
  const auto tree = treeOfStudies(studies);  // by a worker, in a search
  tests::RunningServer none;
  none.server.host = "127.0.0.1";
  none.server.title = "NONE";
  archives().put(entryOf(none));
  QTest::qWait(100);
  const LongestGap gap;
  archive().showStudies(tree, studies.size(), true, false);
  QTest::qWait(200);
  archive().results().expand(archive().model().index(0, 0));
  options().setHidesPatient(true);
  QTest::qWait(200);
  archive().results().scrollToBottom();
  QTest::qWait(200);
  EXPECT_LT(gap.longest(), most);
}

TEST_F(ArchiveAnswers, WhileServersStallAndAreCancelled) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const auto running = tests::startDcmqrscp(root_ / "s");
  ASSERT_TRUE(running);
  const tests::MadeStudy study = tests::makeStudy(root_ / "made", "1.2.3.81", 60);
  io::archive::send(running->server, io::archive::filesToSend({study.folder}));
  const tests::Proxy silent(running->server.port, {.after = 0, .stalls = true});
  ServerEntry entry = entryOf(*running), stalled = entry;
  stalled.id = QStringLiteral("stalled");
  stalled.port = silent.port();
  enter(entry);
  archives().put(stalled);
  QTest::qWait(300);  // the dock comes and the views get their new sizes
  waitUntilDrawn();
  const LongestGap gap;
  const int stalls = retrievals().add({stalled.id, study.uid, {}, {}, false});
  search(QStringLiteral("x"));
  const int comes = retrievals().add({entry.id, study.uid, {}, {}, false});
  QTest::qWait(300);
  retrievals().pause(stalls);
  waitFor(stalls, Retrievals::State::Paused);
  retrievals().resume(stalls);
  retrievals().remove(stalls);
  waitFor([&] { return !retrievals().find(stalls); });
  retrievals().pause(comes);
  retrievals().resume(comes);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !retrievals().isBusy(); }, patience));
  EXPECT_LT(gap.longest(), most);
}

}  // namespace
}  // namespace fenestra::viewer::archiveAnswersTest
