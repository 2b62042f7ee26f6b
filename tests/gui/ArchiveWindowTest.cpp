// The Archive dock against real servers: what is found, retrieved and opened, what is said when something is wrong, and
// that nothing of it is kept but the objects.

#include <QDir>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "io/archive/Send.h"
#include "io/archive/WebArchive.h"
#include "tests/gui/ArchiveWindow.h"
#include "tests/io/IoTesting.h"
#include "viewer/archive/CacheRow.h"
#include "viewer/archive/KeyRing.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/Paths.h"

namespace fenestra::viewer::archiveWindowTest {
namespace {

namespace fs = std::filesystem;
using State = Retrievals::State;

std::vector<fs::path> filesOf(const std::vector<tests::MadeStudy>& studies) {
  std::vector<fs::path> folders;
  for (const tests::MadeStudy& each : studies) folders.push_back(each.folder);
  return io::archive::filesToSend(folders);
}

#define FENESTRA_DCMQRSCP(running)                        \
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");          \
  const auto running = tests::startDcmqrscp(root_ / "s"); \
  ASSERT_TRUE(running)

#define FENESTRA_ORTHANC(running)                        \
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");        \
  const auto running = tests::startOrthanc(root_ / "s"); \
  ASSERT_TRUE(running)

TEST_F(ArchiveWindow, ClosedItMakesNothing) {
  EXPECT_FALSE(dock().isVisible());
  EXPECT_FALSE(dock().panelIfMade());
  EXPECT_EQ(archiveThreads().activeThreadCount(), 0);
  dock().toggleViewAction()->trigger();
  EXPECT_TRUE(dock().panelIfMade());
  EXPECT_EQ(archiveThreads().activeThreadCount(), 0) << "it does nothing by itself";
  EXPECT_TRUE(shown().contains(QStringLiteral("nothing goes over the network")));
  EXPECT_FALSE(in<QLineEdit>(archive(), "patientName")->isVisible()) << "off until a server is entered";
}

TEST_F(ArchiveWindow, FindsRetrievesAndOpensInEveryWriting) {
  FENESTRA_ORTHANC(running);
  const std::vector<tests::MadeStudy> studies = tests::makeStudies(root_ / "made");
  io::archive::send(running->server, filesOf(studies));
  enter(entryOf(*running));
  search(QString());
  EXPECT_EQ(archive().model().rowCount(), static_cast<int>(studies.size())) << archive().status().toStdString();
  // A made name's first group is "Family^Given"; another one stands behind it.
  for (const tests::MadeStudy& each : studies) {
    SCOPED_TRACE(each.name);
    const QString name = QString::fromStdString(each.name), family = name.section(QLatin1Char('^'), 0, 0);
    EXPECT_TRUE(find(family).isValid()) << results().join(QLatin1Char('\n')).toStdString();
    EXPECT_TRUE(find(QString::fromStdString(each.id)).isValid());
  }
  for (const tests::MadeStudy& each : studies) {
    SCOPED_TRACE(each.name);
    const QString family = QString::fromStdString(each.name).section(QLatin1Char('^'), 0, 0);
    search(family);
    EXPECT_EQ(archive().model().rowCount(), 1) << archive().status().toStdString();
    EXPECT_TRUE(find(family).isValid());
  }
  search(QStringLiteral("Smith, An"));
  ASSERT_EQ(archive().model().rowCount(), 1) << "the beginning of a name as people write it";
  const QModelIndex study = find(QStringLiteral("Head"));
  ASSERT_TRUE(study.isValid());
  archive().results().expand(study);
  waitFor([&] { return archive().model().rowCount(study) == 1; });
  EXPECT_EQ(archive().model().index(0, ArchiveModel::Images, study).data().toString(), QStringLiteral("3"));
  archive().results().setCurrentIndex(archive().model().index(0, 0, study));
  archive().retrieveSelected(true);
  ASSERT_EQ(retrievals().items().size(), 1u);
  waitFor(retrievals().items().front()->id, State::Done);
  waitFor([&] { return document().hasVolume(); });
  EXPECT_EQ(document().scene().volume->grid.dims, glm::ivec3(64, 64, 3));
  EXPECT_EQ(document().study().patient.name, "Smith^Anna");
  search(QStringLiteral("Nobody"));
  EXPECT_TRUE(archive().status().startsWith(QStringLiteral("Nothing matches"))) << archive().status().toStdString();
}

TEST_F(ArchiveWindow, NothingOfAPatientOrASecretIsKeptOrShownWhileHidden) {
  FENESTRA_ORTHANC(running);
  const std::vector<tests::MadeStudy> studies = tests::makeStudies(root_ / "made");
  io::archive::send(running->server, filesOf(studies));
  std::string printed;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  int asked = 0;
  archives().setAskSecret([&](const ServerEntry&) {
    ++asked;
    return std::optional(QStringLiteral("secret word"));
  });
  // No key ring runs here: what it would have kept must not go anywhere else.
  ServerEntry kept = webEntryOf(*running);
  kept.keepsSecret = true;
  enter(kept);
  in<QLineEdit>(archive(), "patientId")->setText(QStringLiteral("P-1"));
  in<QLineEdit>(archive(), "accession")->setText(QStringLiteral("A100"));
  search(QStringLiteral("Smith"));
  ASSERT_EQ(archive().model().rowCount(), 1) << archive().status().toStdString();
  archive().form().save(QStringLiteral("Mine"));
  EXPECT_EQ(window_->workspace().preferences.archiveSearches().size(), 1);
  const QModelIndex study = archive().model().index(0, 0, archive().model().index(0, 0));
  archive().results().expand(study);
  waitFor([&] { return archive().model().rowCount(study) == 1; });
  archive().results().setCurrentIndex(study);
  archive().retrieveSelected(true);
  waitFor(retrievals().items().front()->id, State::Done);
  waitFor([&] { return document().hasVolume(); });
  waitUntilDrawn();
  EXPECT_EQ(asked, 1) << "once in a run";
  auto* problem = in<QLabel>(archive(), "archiveKeyRing");
  EXPECT_TRUE(problem->isVisible()) << "there is no key ring";
  EXPECT_TRUE(problem->text().contains(QStringLiteral("key ring"))) << problem->text().toStdString();

  QString refused;
  writeKeyRing(kept, QStringLiteral("secret word"), window_.get(), [&](const QString& why) { refused = why; });
  waitFor([&] { return !refused.isEmpty(); });

  const QStringList words{QStringLiteral("Smith"), QStringLiteral("Anna"),       QStringLiteral("P-1"),
                          QStringLiteral("A100"),  QStringLiteral("2024-01-05"), QStringLiteral("20240105"),
                          QStringLiteral("Head")};
  for (const char* word : {"Smith", "P-1", "A100", "Head"}) EXPECT_TRUE(shown().contains(QLatin1String(word))) << word;
  QTest::keyClick(window_.get(), Qt::Key_H);
  ASSERT_TRUE(options().hidesPatient());
  for (const QString& word : words) EXPECT_FALSE(shown().contains(word)) << word.toStdString();
  QTest::keyClick(window_.get(), Qt::Key_H);
  EXPECT_TRUE(shown().contains(QStringLiteral("Smith"))) << "it comes back";

  window_->close();
  window_.reset();
  printed = testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();
  const auto expectClean = [&](const std::string& text, const std::string& where) {
    EXPECT_EQ(text.find("secret word"), std::string::npos) << where;
    for (const QString& word : words)
      EXPECT_EQ(text.find(word.toStdString()), std::string::npos) << word.toStdString() << " in " << where << text;
  };
  expectClean(printed, "what was printed");
  const fs::path settings = toPath(QSettings().fileName()).parent_path();
  bool namesServer = false;
  for (const auto& entry : fs::recursive_directory_iterator(settings))
    if (entry.is_regular_file()) {
      const std::string text = tests::readFile(entry.path());
      namesServer |= text.find("Web archive") != std::string::npos && text.find("Mine") != std::string::npos;
      expectClean(text, entry.path().string());
    }
  EXPECT_TRUE(namesServer) << "the test looks where the servers and searches are";
  for (const auto& entry : fs::recursive_directory_iterator(root_ / "cache")) {
    for (const QString& word : words)
      EXPECT_EQ(entry.path().filename().string().find(word.toStdString()), std::string::npos) << entry.path();
    EXPECT_EQ(fs::status(entry.path()).permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none)
        << entry.path();
  }
}

TEST_F(ArchiveWindow, ATestSaysWhatIsWrong) {
  FENESTRA_ORTHANC(running);
  const auto test = [&](const ServerEntry& entry) {
    enter(entry);
    in<QToolButton>(archive(), "archiveTest")->click();
    waitFor([&] { return !archive().isBusy(); });
    return archive().status().toStdString();
  };
  ServerEntry entry = entryOf(*running);
  EXPECT_NE(test(entry).find("Test archive answers"), std::string::npos) << archive().status().toStdString();
  entry.title = QStringLiteral("WRONG");
  EXPECT_NE(test(entry).find("AE title"), std::string::npos) << archive().status().toStdString();
  entry.port = tests::freePort();
  EXPECT_NE(test(entry).find("nothing listens on port"), std::string::npos) << archive().status().toStdString();
  archives().remove(entry.id);
  // A wrong password is asked for again.
  QStringList given{QStringLiteral("secret word"), QStringLiteral("wrong")};
  archives().setAskSecret([&](const ServerEntry&) { return std::optional(given.takeLast()); });
  const ServerEntry web = webEntryOf(*running);
  EXPECT_NE(test(web).find("does not let us in"), std::string::npos) << archive().status().toStdString();
  EXPECT_EQ(archive().status().indexOf(QStringLiteral("wrong")), -1);
  QTest::qWait(20);
  EXPECT_NE(test(web).find("Web archive answers"), std::string::npos) << archive().status().toStdString();
  EXPECT_TRUE(given.isEmpty());
}

TEST_F(ArchiveWindow, ABrokenRetrievalSaysWhyAndGoesOnWithWhatIsMissing) {
  FENESTRA_DCMQRSCP(running);
  const tests::MadeStudy study = tests::makeStudy(root_ / "made", "1.2.3.77", 40);
  io::archive::send(running->server, filesOf({study}));
  ServerEntry entry = entryOf(*running);
  const int port = entry.port;
  // An object has some 8 kB: a part of the 40 comes, and then nothing.
  tests::Proxy stalling(port, {.after = 120'000, .stalls = true});
  entry.port = stalling.port();
  enter(entry);
  const int id = retrievals().add({entry.id, study.uid, {}, QStringLiteral("Forty slices"), false});
  waitFor([&] { return retrievals().find(id)->fraction > 0.1; });
  QElapsedTimer since;
  since.start();
  retrievals().pause(id);
  EXPECT_EQ(retrievals().find(id)->state, State::Stopping);
  waitFor(id, State::Paused);
  const double reached = retrievals().find(id)->fraction;
  EXPECT_LT(reached, 1.0);
  EXPECT_LT(since.elapsed(), 5000) << "workers look every 50 ms; the silence of a minute is not waited for";
  for (const auto& each : fs::recursive_directory_iterator(root_ / "cache")) {
    if (each.path().extension() != ".dcm") continue;
    EXPECT_EQ(each.path().parent_path().extension(), ".part");
  }

  tests::Proxy cutting(port, {.after = 60'000});
  entry.port = cutting.port();
  archives().put(entry);
  retrievals().resume(id);
  waitFor(id, State::Failed);
  EXPECT_FALSE(retrievals().find(id)->message.isEmpty());
  EXPECT_FALSE(retrievals().find(id)->message.contains(QLatin1Char('\n'))) << "one line";
  EXPECT_TRUE(shown().contains(retrievals().find(id)->message)) << "it stays in the list";

  entry.port = port;
  archives().put(entry);
  auto* retry = in<QToolButton>(archive(), "retrievalAct");
  EXPECT_EQ(retry->text(), QStringLiteral("Retry"));
  retry->click();
  waitFor(id, State::Done);
  EXPECT_EQ(tests::objectsIn(retrievals().find(id)->folder), tests::objectsIn(study.folder));
  EXPECT_EQ(in<QToolButton>(archive(), "retrievalAct")->text(), QStringLiteral("Open"));
}

TEST_F(ArchiveWindow, SeveralComeAtOnceAndOneIsCancelled) {
  FENESTRA_DCMQRSCP(running);
  const std::vector<tests::MadeStudy> studies = tests::makeStudies(root_ / "made");
  io::archive::send(running->server, filesOf(studies));
  const tests::Proxy silent(running->server.port, {.after = 0, .stalls = true});
  ServerEntry entry = entryOf(*running), stalled = entryOf(*running);
  stalled.port = silent.port();
  enter(entry);
  archives().put(stalled);
  const int never = retrievals().add({stalled.id, studies[0].uid, {}, QStringLiteral("never"), false});
  std::vector<int> ids;
  for (const tests::MadeStudy& each : studies)
    if (each.uid != studies[0].uid) ids.push_back(retrievals().add({entry.id, each.uid, {}, {}, false}));
  EXPECT_EQ(retrievals().add({entry.id, studies[1].uid, {}, {}, false}), ids[0]) << "once in the list";
  for (const int id : ids) waitFor(id, State::Done);
  EXPECT_EQ(retrievals().find(never)->state, State::Running);
  retrievals().remove(never);
  EXPECT_FALSE(shown().contains(QStringLiteral("never"))) << "at once";
  waitFor([&] { return !retrievals().find(never); });
  EXPECT_FALSE(retrievals().isBusy());
}

TEST_F(ArchiveWindow, TheSettingsShowAndClearTheCache) {
  FENESTRA_DCMQRSCP(running);
  const tests::MadeStudy study = tests::makeStudy(root_ / "made", "1.2.3.78", 3);
  io::archive::send(running->server, filesOf({study}));
  const ServerEntry entry = entryOf(*running);
  enter(entry);
  const int id = retrievals().add({entry.id, study.uid, {}, {}, false});
  waitFor(id, State::Done);
  CacheRow row(archives(), retrievals());
  const auto text = [&] { return in<QLabel>(row, "archiveCache")->text(); };
  waitFor([&] { return !row.isBusy(); });
  EXPECT_TRUE(in<QLabel>(row, "archiveCache")->toolTip().contains(toQString(root_ / "cache")));
  EXPECT_TRUE(text().contains(QStringLiteral("kB"))) << text().toStdString();
  row.clear();
  waitFor([&] { return !row.isBusy() && text().startsWith(QStringLiteral("0 ")); });
  EXPECT_TRUE(fs::is_empty(root_ / "cache"));
  // What was whole comes again when it is opened.
  Q_EMIT archive().openRequested(id);
  waitFor([&] { return document().hasVolume(); });
  row.choose(root_ / "elsewhere");
  EXPECT_EQ(archives().cacheFolder(), root_ / "elsewhere" / "fenestra-archive")
      << "a folder of its own: all in it is the cache's to remove";
}

TEST_F(ArchiveWindow, ASessionIsNotOfferedAPlaceInTheCache) {
  const tests::MadeStudy inside = tests::makeStudy(root_ / "cache" / "study", "1.2.3.82", 2),
                         outside = tests::makeStudy(root_ / "made", "1.2.3.83", 2);
  const auto suggestedFor = [&](const fs::path& data) {
    drop({data});
    fs::path suggested;
    window_->sessions().questions().saveWhere = [&](const fs::path& where) {
      suggested = where;
      return std::nullopt;
    };
    window_->sessions().saveAs();
    return suggested.parent_path();
  };
  EXPECT_EQ(suggestedFor(outside.folder), outside.folder.parent_path());
  EXPECT_EQ(suggestedFor(inside.folder), toPath(QDir::homePath()));
}

TEST_F(ArchiveWindow, RetrievesByCMoveOverTls) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  FENESTRA_PROGRAM_OR_SKIP("openssl", "openssl");
  fs::create_directories(root_);
  const tests::Certificate own = tests::makeCertificate(root_, "server"),
                           client = tests::makeCertificate(root_, "client");
  const auto running = tests::startOrthanc(root_ / "s", own, client);
  ASSERT_TRUE(running);
  const tests::MadeStudy study = tests::makeStudy(root_ / "made", "1.2.3.83", 3);
  io::archive::send(running->server, filesOf({study}));
  ServerEntry entry = entryOf(*running);
  entry.kind = ServerEntry::Kind::DicomTls;
  entry.authorities = toQString(own.certificate);
  entry.certificate = toQString(client.certificate);
  entry.key = toQString(client.key);
  entry.moves = true;
  const int port = std::exchange(entry.ownPort, tests::freePort());
  enter(entry);
  waitFor(retrievals().add({entry.id, study.uid, {}, QStringLiteral("Lost"), false}), State::Failed);
  EXPECT_TRUE(tests::objectsIn(root_ / "cache").empty()) << "the server sends to the port that it knows, not by C-GET";
  entry.ownPort = port;
  archives().put(entry);
  const int id = retrievals().add({entry.id, study.uid, {}, QStringLiteral("Moved"), false});
  waitFor(id, State::Done);
  EXPECT_EQ(tests::objectsIn(root_ / "cache"), tests::objectsIn(study.folder));
}

TEST_F(ArchiveWindow, ServersComeBackWithTheNextWindow) {
  ServerEntry web = newServerEntry();
  web.name = QStringLiteral("Web");
  web.kind = ServerEntry::Kind::Web;
  web.url = QStringLiteral("https://pacs.hospital/dicom-web");
  web.login = ServerEntry::Login::Token;
  ServerEntry tls = newServerEntry();
  tls.name = QStringLiteral("Größe");
  tls.kind = ServerEntry::Kind::DicomTls;
  tls.host = QStringLiteral("pacs.hospital");
  tls.title = QStringLiteral("PACS");
  tls.port = 2762;
  tls.moves = true;
  tls.ownPort = 4711;
  tls.authorities = QStringLiteral("/etc/a.pem");
  archives().put(web);
  archives().put(tls);
  const std::vector<ServerEntry> kept = Archives(window_->workspace().preferences).servers();
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0], web);
  EXPECT_EQ(kept[1], tls);
  // What is no server in a file that was edited by hand is passed over.
  window_->workspace().preferences.setArchiveServers({QVariantMap{{"id", "x"}, {"kind", 9}}, 7, toMap(tls)});
  EXPECT_EQ(Archives(window_->workspace().preferences).servers().size(), 1u);
}

TEST(ArchiveSearch, TypedTextsBecomeKeys) {
  EXPECT_EQ(nameKey(QStringLiteral("smith")), "smith*");
  EXPECT_EQ(nameKey(QStringLiteral(" Smith , Anna ")), "Smith^Anna*");
  EXPECT_EQ(nameKey(QStringLiteral("*anna*")), "*anna*");
  EXPECT_EQ(nameKey(QStringLiteral("Sm?th")), "Sm?th");
  EXPECT_EQ(nameKey(QStringLiteral("山田")), "山田*");
  EXPECT_EQ(nameKey(QString()), "");
  EXPECT_EQ(descriptionKey(QStringLiteral("head")), "*head*");
  EXPECT_EQ(descriptionKey(QStringLiteral("head*")), "head*");
}

}  // namespace
}  // namespace fenestra::viewer::archiveWindowTest
