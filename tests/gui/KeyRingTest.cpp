// A server's password in the desktop's key ring, of GNOME, which tests/gui/key-ring.sh starts.

#include <QLabel>
#include <QTest>
#include <QToolButton>

#include "tests/gui/ArchiveWindow.h"
#include "tests/io/IoTesting.h"
#include "viewer/archive/KeyRing.h"

namespace fenestra::viewer::keyRingTest {
namespace {

namespace fs = std::filesystem;

/// A DICOMweb server that lets in "reader" with the password "secret word".
class LockedServer {
 public:
  tests::RunningServer running() const {
    tests::RunningServer running;
    running.web = answering_.server().url;
    return running;
  }

 private:
  tests::Answering answering_{[](const std::string& request) {
    const bool isKnown = request.find("Basic cmVhZGVyOnNlY3JldCB3b3Jk\r\n") != std::string::npos;  // RFC 7617
    return isKnown ? tests::answerOf("200 OK", "application/dicom+json", "[]")
                   : tests::answerOf("401 Unauthorized", "text/plain", "");
  }};
};

class KeyRing : public ArchiveWindow {
 protected:
  void SetUp() override {
    if (!qEnvironmentVariableIsSet("FENESTRA_KEY_RING"))
      GTEST_SKIP() << "needs a key ring of its own: tests/gui/key-ring.sh starts one, as the suite gui_key_ring does";
    ArchiveWindow::SetUp();
    archives().setAskSecret([this](const ServerEntry&) {
      ++asked_;
      return std::optional(given_);
    });
    entry_ = webEntryOf(server_.running());
    entry_.keepsSecret = true;
  }
  std::string test() {
    in<QToolButton>(archive(), "archiveTest")->click();
    waitFor([&] { return !archive().isBusy(); });
    return archive().status().toStdString();
  }
  bool keeps(const ServerEntry& entry, const std::optional<QString>& secret) {
    return QTest::qWaitFor([&] { return readKeyRing(entry, window_.get()).secret == secret; }, patience);
  }

  LockedServer server_;
  ServerEntry entry_;
  QString given_ = QStringLiteral("secret word");
  int asked_ = 0;
};

TEST_F(KeyRing, KeepsAPasswordForTheNextRun) {
  enter(entry_);
  EXPECT_NE(test().find("answers"), std::string::npos) << archive().status().toStdString();
  EXPECT_EQ(asked_, 1);
  EXPECT_TRUE(keeps(entry_, QStringLiteral("secret word")));
  EXPECT_FALSE(in<QLabel>(archive(), "archiveKeyRing")->isVisible()) << "nothing is wrong";
  Archives next(window_->workspace().preferences);
  ASSERT_EQ(next.servers().size(), 1u);
  const std::optional<AnyServer> reached = next.reach(next.servers()[0]);
  ASSERT_TRUE(reached) << "nobody can be asked, and nobody has to";
  EXPECT_EQ(std::get<io::archive::WebServer>(*reached).secret.reveal(), "secret word");
  std::size_t files = 0;
  for (const fs::path& root : {fs::path(qEnvironmentVariable("FENESTRA_KEY_RING").toStdString()),
                               fs::path(QSettings().fileName().toStdString()).parent_path(), root_})
    for (const auto& each : fs::recursive_directory_iterator(root))
      if (each.is_regular_file()) {
        ++files;
        EXPECT_EQ(tests::readFile(each.path()).find("secret word"), std::string::npos) << each.path();
      }
  EXPECT_GE(files, 2u) << "the ring's file and the settings";
}

TEST_F(KeyRing, ForgetsAPasswordThatIsRefusedOrNoLongerWanted) {
  given_ = QStringLiteral("wrong");
  enter(entry_);
  EXPECT_NE(test().find("does not let us in"), std::string::npos) << archive().status().toStdString();
  EXPECT_TRUE(keeps(entry_, std::nullopt)) << "refused";
  given_ = QStringLiteral("secret word");
  EXPECT_NE(test().find("answers"), std::string::npos) << archive().status().toStdString();
  EXPECT_EQ(asked_, 2);
  ASSERT_TRUE(keeps(entry_, given_));

  ServerEntry elsewhere = entry_;
  elsewhere.url = QStringLiteral("http://127.0.0.1:1/dicom-web");
  EXPECT_TRUE(keeps(elsewhere, std::nullopt)) << "a file of settings that was edited by hand";
  archives().put(elsewhere);
  EXPECT_TRUE(keeps(entry_, std::nullopt)) << "another address";
  archives().put(entry_);
  test();
  ASSERT_TRUE(keeps(entry_, given_));
  ServerEntry unkept = entry_;
  unkept.keepsSecret = false;
  archives().put(unkept);
  EXPECT_TRUE(keeps(entry_, std::nullopt)) << "the box is not ticked any more";
  archives().put(entry_);
  test();
  ASSERT_TRUE(keeps(entry_, given_));
  archives().remove(entry_.id);
  EXPECT_TRUE(keeps(entry_, std::nullopt)) << "the server is removed";
}

}  // namespace
}  // namespace fenestra::viewer::keyRingTest
