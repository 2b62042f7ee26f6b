// DICOMweb: Orthanc's plug-in holds, finds and returns studies; broken, hostile and wrongly addressed answers give one
// sentence each. The forms of messages, piece by piece.

#include <unistd.h>
#include <set>

#include <gtest/gtest.h>

#include "io/archive/Multipart.h"
#include "io/archive/WebAnswers.h"
#include "io/archive/WebArchive.h"
#include "io/archive/WebPicture.h"
#include "io/archive/Wildcards.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::archiveWebTest {
namespace fs = std::filesystem;
namespace archive = io::archive;
namespace {

archive::WebServer webOf(const RunningServer& running) {
  archive::WebServer server = archive::parseWebServer(running.web).value();
  server.user = "reader";
  server.secret = archive::Secret("secret word");
  return server;
}

std::set<std::string> webFinds(const archive::WebServer& server, const archive::Attributes& keys) {
  std::set<std::string> found;
  for (const archive::Attributes& record : archive::find(server, {archive::Level::Study, keys}).records)
    found.insert(archive::valueOf(record, "StudyInstanceUID"));
  return found;
}

/// The answer to a search: objects of one series of a study "1.2", each with a UID of its own.
std::string answerWithObjects(int count) {
  std::string body = "[";
  for (int i = 0; i < count; ++i)
    body += std::string(i == 0 ? "" : ",") + R"({"0020000D": {"vr": "UI", "Value": ["1.2"]}, )" +
            R"("0020000E": {"vr": "UI", "Value": ["1.2.3"]}, "00080018": {"vr": "UI", "Value": ["1.2.3.)" +
            std::to_string(i) + R"("]}})";
  return answerOf("200 OK", "application/dicom+json", body + "]");
}

/// The error of retrieving three objects where what answers for the series' objects is `answer`.
std::string errorOfRetrieving(const std::string& answer, const archive::Limits& limits) {
  const Answering answering([&](const std::string& request) {
    return request.find('?') != std::string::npos ? answerWithObjects(3) : answer;
  });
  archive::WebServer server = answering.server();
  server.limits = limits;
  const archive::Cache cache(scratchFolder() / "cache");
  const std::string error = errorOf([&] { archive::retrieve(server, {"1.2", "1.2.3"}, cache); });
  EXPECT_EQ(cache.bytes(), 0u) << "nothing half-written stays";
  return error;
}

/// The parts of a message that comes `step` bytes at a time; "FAILED" at its end when it is refused.
std::vector<std::string> partsOf(const std::string& message, std::size_t step) {
  std::vector<std::string> parts;
  std::string part;
  archive::Multipart multipart(
      "b", {[&] { part.clear(); }, [&](std::string_view bytes) { part += bytes; }, [&] { parts.push_back(part); }});
  for (std::size_t at = 0; at < message.size(); at += step)
    if (!multipart.push(std::string_view(message).substr(at, step))) {
      parts.push_back("FAILED");
      break;
    }
  if (!multipart.isComplete()) parts.push_back("INCOMPLETE");
  return parts;
}

}  // namespace

TEST(ArchiveWeb, OrthancHoldsFindsAndReturnsFiveStudies) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  if (!fs::exists("/usr/share/orthanc/plugins/libOrthancDicomWeb.so"))
    GTEST_SKIP() << "needs Orthanc's plug-in of Debian's package orthanc-dicomweb";
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  const archive::WebServer server = webOf(*running);
  const std::vector<MadeStudy> studies = makeStudies(folder / "studies");
  archive::echo(server);
  for (const archive::Sent& each : archive::send(server, archive::filesToSend({folder / "studies"})))
    EXPECT_TRUE(each.accepted) << each.text;
  for (const MadeStudy& study : studies) {
    SCOPED_TRACE(study.name);
    const std::set<std::string> only{study.uid};
    EXPECT_EQ(webFinds(server, {{"PatientID", study.id}}), only);
    EXPECT_EQ(webFinds(server, {{"AccessionNumber", study.accession}}), only);
    EXPECT_EQ(webFinds(server, {{"StudyDate", study.date}}), only);
    EXPECT_EQ(webFinds(server, {{"PatientName", study.name.substr(0, study.name.find('^')) + "*"}}), only);
    const archive::Answers answers = archive::find(server, {archive::Level::Study, {{"PatientID", study.id}}});
    ASSERT_EQ(answers.records.size(), 1u);
    EXPECT_EQ(archive::valueOf(answers.records[0], "PatientName"), study.name);
  }
  EXPECT_EQ(webFinds(server, {{"PatientName", "Smith^Anna"}}).size(), 1u);
  EXPECT_EQ(webFinds(server, {{"PatientName", "山田*"}}), std::set<std::string>{studies[4].uid});
  EXPECT_TRUE(webFinds(server, {{"PatientName", "Möller*"}}).empty());
  EXPECT_EQ(webFinds(server, {{"StudyDate", "20240101-20241231"}}).size(), 3u);
  EXPECT_TRUE(webFinds(server, {{"PatientID", "nobody"}}).empty());
  EXPECT_EQ(archive::find(server, {archive::Level::Patient, {{"PatientID", "P-?"}}}).records.size(), 5u);
  const archive::Answers series = archive::find(server, {archive::Level::Series, {{"PatientID", "P-2"}}});
  ASSERT_EQ(series.records.size(), 1u);
  EXPECT_EQ(archive::valueOf(series.records[0], "SeriesInstanceUID"), studies[1].series);

  const archive::Cache cache(folder / "cache");
  const archive::Retrieved got = archive::retrieve(server, {studies[1].uid, ""}, cache);
  ASSERT_EQ(got.series.size(), 1u);
  EXPECT_EQ(got.series[0].received, 3u);
  EXPECT_EQ(objectsIn(got.series[0].folder), objectsIn(studies[1].folder));
  EXPECT_EQ(archive::retrieve(server, {studies[1].uid, ""}, cache).series[0].received, 0u);
  fs::remove(got.series[0].folder / (archive::cacheName(studies[1].series + ".2") + ".dcm"));
  EXPECT_EQ(archive::retrieve(server, {studies[1].uid, ""}, cache).series[0].received, 1u) << "only what is missing";
  const std::vector<archive::Attributes> headers = archive::metadata(server, studies[1].uid, studies[1].series);
  ASSERT_EQ(headers.size(), 3u);
  EXPECT_EQ(archive::valueOf(headers[0], "PatientName"), studies[1].name);
  EXPECT_EQ(archive::valueOf(headers[0], "Rows"), "64");

  const auto picture = archive::pictureOf(server, studies[1].uid, studies[1].series, 3, 64);
  ASSERT_TRUE(picture);
  EXPECT_TRUE(picture->bytes.starts_with("\xff\xd8\xff"));
  EXPECT_FALSE(archive::pictureOf(server, studies[1].uid, "1.2.3.4.5", 3, 64)) << "a series that is not there";

  archive::WebServer stranger = server;
  stranger.secret = archive::Secret("wrong");
  const std::string refused = errorOf([&] { archive::echo(stranger); });
  EXPECT_NE(refused.find("does not let us in"), std::string::npos) << refused;
  EXPECT_EQ(refused.find("wrong"), std::string::npos) << "no secret in a message";
  archive::WebServer elsewhere = server;
  elsewhere.url += "-not";
  EXPECT_NE(errorOf([&] { archive::echo(elsewhere); }).find("HTTP 404"), std::string::npos);
}

TEST(ArchiveWeb, SendsNoSecretInClear) {
  for (const char* address : {"http://archive.example/dicom-web", "http://127.archive.example/dicom-web",
                              "http://localhost.example:8042", "http://128.0.0.1"}) {
    archive::WebServer plain = archive::parseWebServer(address).value();
    plain.secret = archive::Secret("token");
    EXPECT_NE(errorOf([&] { archive::echo(plain); }).find("in clear"), std::string::npos) << address;
  }
  EXPECT_FALSE(archive::parseWebServer("http://localhost:80@archive.example/"));
}

TEST(ArchiveWeb, ResumesAfterACutConnection) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  const archive::WebServer server = webOf(*running);
  const MadeStudy study = makeStudy(folder / "studies", "1.2.3.95", 12);
  archive::send(server, archive::filesToSend({study.folder}));
  const archive::Cache cache(folder / "cache");
  const int port = std::stoi(running->web.substr(running->web.rfind(':') + 1));
  for (const bool stalls : {false, true}) {
    const Proxy proxy(port, {.after = 40'000, .stalls = stalls});
    archive::WebServer broken = server;
    broken.url = "http://127.0.0.1:" + std::to_string(proxy.port()) + "/dicom-web";
    broken.limits.silence = std::chrono::milliseconds(300);
    const std::string error = errorOf([&] { archive::retrieve(broken, {study.uid, ""}, cache); });
    EXPECT_NE(error.find(stalls ? "the server was silent" : "the connection broke"), std::string::npos) << error;
    EXPECT_FALSE(fs::exists(cache.folderOf(study.uid, study.series)));
  }
  const std::size_t held = cache.held(study.uid, study.series).size();
  EXPECT_GT(held, 0u);
  const archive::Retrieved got = archive::retrieve(server, {study.uid, ""}, cache);
  EXPECT_EQ(got.series.at(0).received, 12u - held);
  EXPECT_EQ(objectsIn(got.series[0].folder), objectsIn(study.folder));
}

TEST(ArchiveWeb, TrustsOnlyCertificatesOfTheAuthoritiesNamed) {
  // Not Orthanc: Debian's crashes when it is asked over TLS.
  FENESTRA_PROGRAM_OR_SKIP("openssl", "openssl");
  const fs::path folder = scratchFolder();
  const Certificate own = makeCertificate(folder, "server"), other = makeCertificate(folder, "other");
  fs::create_directories(folder / "dicom-web");
  writeFile(folder / "dicom-web/studies?limit=1", answerOf("200 OK", "application/dicom+json", "[]"));
  const int port = freePort();
  const Program program(
      {"sh", "-c",
       "cd '" + folder.string() + "' && exec openssl s_server -quiet -HTTP -cert server.pem -key server.key -accept " +
           std::to_string(port)},
      folder / "log");
  ASSERT_TRUE(eventually([&] {
    const int open = connectTo(port);
    if (open >= 0) close(open);
    return open >= 0;
  })) << readFile(folder / "log");
  archive::WebServer server =
      archive::parseWebServer("https://127.0.0.1:" + std::to_string(port) + "/dicom-web").value();
  EXPECT_TRUE(server.isEncrypted());
  EXPECT_NE(errorOf([&] { archive::echo(server); }).find("certificate is not trusted"), std::string::npos);
  server.authorities = other.certificate;
  EXPECT_NE(errorOf([&] { archive::echo(server); }).find("certificate is not trusted"), std::string::npos);
  server.authorities = own.certificate;
  archive::echo(server);
}

TEST(ArchiveWebAnswers, BrokenOnesGiveOneSentence) {
  const auto errorFor = [](const std::string& answer) {
    const Answering answering([&](const std::string&) { return answer; });
    archive::WebServer server = answering.server();
    server.limits.answerBytes = 100'000;
    return errorOf([&] { archive::find(server, {}); });
  };
  const std::string type = "application/dicom+json";
  const std::vector<std::pair<std::string, std::string>> rows{
      {answerOf("200 OK", "text/html", "<html>"), "not of DICOMweb"},
      {answerOf("200 OK", type, R"([{"0020000D")"), "not of DICOMweb"},
      {answerOf("200 OK", type, "[1]"), "not of DICOMweb"},
      {answerOf("200 OK", type, std::string(50'000, '[')), "not of DICOMweb"},
      {answerOf("200 OK", type, std::string(200'000, ' ')), "more than an answer may hold"},
      {answerOf("302 Found\r\nLocation: http://127.0.0.1:1/", type, ""), "sends us elsewhere"},
      {answerOf("500 Internal Server Error", type, ""), "HTTP 500"},
      {"HTTP/1.1 200 OK\r\nContent-Length: 1000\r\n\r\n[", "the connection broke"},
      {"SSH-2.0-OpenSSH\r\n", "no web server"},
      {"", "no web server"}};
  for (const auto& [answer, sentence] : rows) {
    const std::string error = errorFor(answer);
    EXPECT_NE(error.find(sentence), std::string::npos) << answer.substr(0, 60) << ": " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(ArchiveWebAnswers, FillNeitherMemoryNorDisk) {
  archive::Limits limits;
  limits.answerBytes = 10'000;
  limits.objectBytes = 8'000;
  const std::string failure = answerOf("500 Internal Server Error", "text/plain", std::string(20'000, 'x'));
  EXPECT_NE(errorOfRetrieving(failure, limits).find("more than an answer may hold"), std::string::npos);
  const auto message = [](std::size_t bytes) {
    return answerOf("200 OK", "multipart/related; boundary=b", "--b\r\n\r\n" + std::string(bytes, 'x') + "\r\n--b--");
  };
  EXPECT_NE(errorOfRetrieving(message(9'000), limits).find("more than an object may hold"), std::string::npos);
  EXPECT_NE(errorOfRetrieving(message(7'000), limits).find("did not come"), std::string::npos);
}

TEST(ArchiveWebPictures, AreOfTheMiddleObjectOrNone) {
  const std::string png = "\x89PNG\r\n\x1a\n and so on", jpeg = "\xff\xd8\xff and so on";
  std::vector<std::string> asked;
  std::string rendered, thumbnail;
  const Answering answering([&](const std::string& request) {
    asked.push_back(request.substr(0, request.find(" HTTP")));
    if (request.find("/rendered?") != std::string::npos) return rendered;
    if (request.find("/thumbnail?") != std::string::npos) return thumbnail;
    // A server that matches by no number.
    return request.find("InstanceNumber=") != std::string::npos ? answerOf("204 No Content", "", "")
                                                                : answerWithObjects(1);
  });
  const std::string none = answerOf("404 Not Found", "text/plain", "");
  const auto got = [&](const std::string& first, const std::string& second) {
    asked.clear();
    rendered = first;
    thumbnail = second;
    const auto picture = archive::pictureOf(answering.server(), "1.2", "1.2.3", 41, 32);
    return picture ? picture->bytes : "none";
  };
  EXPECT_EQ(got(answerOf("200 OK", "image/png", png), none), png);
  ASSERT_EQ(asked.size(), 3u);
  EXPECT_NE(asked[0].find("/studies/1.2/series/1.2.3/instances?limit=1&InstanceNumber=21&"), std::string::npos);
  EXPECT_NE(asked[1].find("&offset=20&"), std::string::npos);
  EXPECT_NE(asked[2].find("/instances/1.2.3.0/rendered?viewport=32,32"), std::string::npos);
  EXPECT_EQ(got(none, answerOf("200 OK", "image/jpeg", jpeg)), jpeg);
  EXPECT_EQ(got(none, none), "none");
  EXPECT_EQ(got(answerOf("200 OK", "image/svg+xml", "<svg/>"), answerOf("200 OK", "video/mp4", "x")), "none");
  rendered = answerOf("200 OK", "image/png", png + std::string(20u << 20, 'x'));
  EXPECT_NE(errorOf([&] { archive::pictureOf(answering.server(), "1.2", "1.2.3", 41, 32); }), "") << "20 MB";
  rendered = answerOf("401 Unauthorized", "", "");
  EXPECT_THROW(archive::pictureOf(answering.server(), "1.2", "1.2.3", 41, 32), archive::LoginRefused);
}

TEST(ArchiveWebPictures, CouldShowNamesUnlessAScannerMadeThem) {
  const std::string ct = "1.2.840.10008.5.1.4.1.1.2", us = "1.2.840.10008.5.1.4.1.1.6.1";
  EXPECT_FALSE(archive::couldShowNames("", ct, "ORIGINAL\\PRIMARY\\AXIAL"));
  EXPECT_FALSE(archive::couldShowNames("NO", us, ""));
  EXPECT_TRUE(archive::couldShowNames("YES", ct, "ORIGINAL\\PRIMARY\\AXIAL"));
  EXPECT_TRUE(archive::couldShowNames("", ct, "DERIVED\\SECONDARY\\OTHER")) << "a report of doses";
  EXPECT_TRUE(archive::couldShowNames("", ct, "")) << "of a server that does not say";
  EXPECT_TRUE(archive::couldShowNames("", us, "ORIGINAL\\PRIMARY"));
}

TEST(ArchiveWebAnswers, ComeOnceFromAServerWithoutPages) {
  const Answering answering([](const std::string&) { return answerWithObjects(1000); });
  const archive::Answers answers = archive::find(
      answering.server(), {archive::Level::Image, {{"StudyInstanceUID", "1.2"}, {"SeriesInstanceUID", "1.2.3"}}});
  EXPECT_EQ(answers.records.size(), 1000u);
  EXPECT_TRUE(answers.complete);
}

TEST(ArchiveWebAnswers, AreMatchedWhereTheServerCannot) {
  for (const auto& [pattern, text] : std::vector<std::pair<std::string, std::string>>{{"Müller*", "Müller^Jürgen"},
                                                                                      {"m?ller^*", "Müller^Jürgen"},
                                                                                      {"*", ""},
                                                                                      {"山田*", "Yamada=山田^太郎"},
                                                                                      {"a*b*c", "aXbbYc"},
                                                                                      {"smith^anna", "Smith^Anna"}})
    EXPECT_TRUE(archive::matches(pattern, text)) << pattern;
  for (const auto& [pattern, text] : std::vector<std::pair<std::string, std::string>>{
           {"Möller*", "Müller^Jürgen"}, {"?", ""}, {"?", "ab"}, {"a*b", "abc"}, {"", "a"}})
    EXPECT_FALSE(archive::matches(pattern, text)) << pattern;
}

TEST(ArchiveWebAnswers, SayNamesNumbersAndLists) {
  const auto found = archive::attributesInJson(R"([{
    "00100010": {"vr": "PN", "Value": [{"Alphabetic": "Yamada^Tarou", "Phonetic": "やまだ^たろう"}]},
    "00280010": {"vr": "US", "Value": [512]}, "00080061": {"vr": "CS", "Value": ["CT", "SEG"]},
    "00081115": {"vr": "SQ", "Value": [{"0020000E": {"vr": "UI", "Value": ["1.2"]}}]},
    "00090010": {"vr": "LO", "Value": ["private"]}, "nonsense": {"vr": "LO", "Value": ["x"]},
    "00100020": {"vr": "LO"}, "00100030": {"vr": "DA", "Value": [null]}, "00100040": 5}])");
  ASSERT_TRUE(found && found->size() == 1);
  EXPECT_EQ(found->front(),
            (archive::Attributes{
                {"PatientName", "Yamada^Tarou==やまだ^たろう"}, {"Rows", "512"}, {"ModalitiesInStudy", "CT\\SEG"}}));
  EXPECT_TRUE(archive::attributesInJson("")->empty()) << "HTTP 204";
  EXPECT_FALSE(archive::storeAnswerIn("{}"));
  const auto failed =
      archive::storeAnswerIn(R"({"00081198": {"vr": "SQ", "Value": [{"00081197": {"vr": "US", "Value": [42752]}}]}})");
  ASSERT_TRUE(failed);
  EXPECT_FALSE(failed->accepted);
  EXPECT_EQ(failed->reason, 0xa700u);
}

TEST(ArchiveMultipart, PartsAreTheSameInPiecesOfAnySize) {
  const std::string message =
      "--b\r\nContent-Type: application/dicom\r\n\r\none\r\n--b\r\n\r\nt\r\n--\r\nwo\r\n--b  \r\nA: "
      "1\r\n\r\n\r\n--b--\r\n";
  const std::vector<std::string> parts{"one", "t\r\n--\r\nwo", ""};
  for (std::size_t step = 1; step <= message.size(); ++step) EXPECT_EQ(partsOf(message, step), parts) << step;
  EXPECT_EQ(partsOf(message.substr(0, 46), 7), std::vector<std::string>{"INCOMPLETE"});
  EXPECT_EQ(partsOf(std::string(100'000, 'x'), 4096), (std::vector<std::string>{"FAILED", "INCOMPLETE"}));
  EXPECT_EQ(archive::boundaryIn("multipart/related; type=\"application/dicom\"; boundary=\"a b\""), "a b");
  EXPECT_EQ(archive::boundaryIn("Multipart/Related;Boundary=x"), "x");
  EXPECT_FALSE(archive::boundaryIn("application/json; boundary=x"));
  EXPECT_FALSE(archive::boundaryIn("multipart/related"));
}

}  // namespace fenestra::tests::archiveWebTest
