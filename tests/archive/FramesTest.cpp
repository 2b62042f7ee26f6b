// One frame of an object that comes slowly is here before the object: the same values as the object has there, and
// nothing where a server has no frames or sends what was not asked for.

#include <atomic>

#include <gtest/gtest.h>

#include "io/archive/Send.h"
#include "io/archive/Wanted.h"
#include "io/archive/WebAnswers.h"
#include "io/archive/WebArchive.h"
#include "io/archive/WebFrame.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::archiveFramesTest {
namespace fs = std::filesystem;
namespace archive = io::archive;
namespace {

archive::WebServer serverAt(const std::string& url) {
  archive::WebServer server = archive::parseWebServer(url).value();
  server.user = "reader";
  server.secret = archive::Secret("secret word");
  return server;
}

/// The values of `frame` as the whole object has them there.
std::vector<double> valuesAt(const fs::path& object, int frame) {
  const io::OpenedVolume whole = io::openVolume(object);
  const glm::ivec3 size = whole.volume->grid.dims;
  std::vector<double> values;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) values.push_back(whole.volume->value({x, y, frame - 1}));
  return values;
}

/// An object with 3 frames of 2×4 samples of 16 bits.
const std::string metadata = R"([{"00080060": {"vr": "CS", "Value": ["MR"]}, "00280002": {"vr": "US", "Value": [1]},
  "00280004": {"vr": "CS", "Value": ["MONOCHROME2"]}, "00280008": {"vr": "IS", "Value": [3]},
  "00280010": {"vr": "US", "Value": [2]}, "00280011": {"vr": "US", "Value": [4]},
  "00280100": {"vr": "US", "Value": [16]}, "00280101": {"vr": "US", "Value": [12]},
  "00280102": {"vr": "US", "Value": [11]}, "00280103": {"vr": "US", "Value": [0]}}])";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST(ArchiveFrames, OneIsWhatTheObjectHasThere) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  const archive::WebServer server = serverAt(running->web);
  int number = 0;
  for (const Syntax syntax : {Syntax::ExplicitLittle, Syntax::ExplicitBig, Syntax::Rle, Syntax::JpegLs}) {
    const MadeFrames made = makeFrames(folder / "made", "1.2.3.7" + std::to_string(number++), 5, syntax);
    SCOPED_TRACE(made.uid);
    archive::send(server, {made.file});
    const fs::path file = folder / "frame";
    ASSERT_TRUE(archive::fetchFrame(server, {made.uid, made.series, made.object, 4}, file));
    const io::OpenedVolume frame = io::openVolume(file);
    EXPECT_TRUE(realValues(*frame.volume) == valuesAt(made.file, 4));
    EXPECT_FALSE(realValues(*frame.volume) == valuesAt(made.file, 3));
    EXPECT_EQ(frame.volume->defaultWindow().level, 40.0);
    EXPECT_EQ(frame.volume->grid.spacing.x, 0.75);
    EXPECT_EQ(frame.volume->grid.spacing.y, 0.5);
    fs::remove(file);
    for (const int none : {0, 6}) {
      EXPECT_FALSE(archive::fetchFrame(server, {made.uid, made.series, made.object, none}, file));
      EXPECT_FALSE(fs::exists(file));
    }
  }
}

TEST(ArchiveFrames, TheMiddleOneIsHereWhileTheObjectIsOnItsWay) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  const MadeFrames made = makeFrames(folder / "made", "1.2.3.76", 60);
  archive::send(serverAt(running->web), {made.file});
  // Each connection lets through as much as a frame needs, but less than the object.
  const Proxy proxy(std::stoi(running->web.substr(running->web.rfind(':') + 1)), {.after = 200'000, .stalls = true});
  archive::WebServer server = serverAt("http://127.0.0.1:" + std::to_string(proxy.port()) + "/dicom-web");
  const archive::Cache cache(folder / "cache");
  std::vector<archive::ArrivedObject> arrived;
  std::vector<double> values;
  std::atomic<bool> isHere = false;
  const archive::Retrieval retrieval{made.uid, made.series, archive::Way::Get, [&](const archive::ArrivedObject& each) {
                                       arrived.push_back(each);
                                       values = realValues(*io::openVolume(each.file).volume);
                                       isHere = true;
                                     }};
  const auto untilHere = [&](double, std::string_view) { return !isHere; };
  server.limits.silence = std::chrono::seconds(1);
  server.limits.frameAhead = std::chrono::hours(1);
  EXPECT_NE(errorOf([&] { archive::retrieve(server, retrieval, cache, untilHere); }).find("was silent"),
            std::string::npos);
  EXPECT_TRUE(arrived.empty()) << "the object is near enough";

  server.limits.silence = std::chrono::seconds(60);
  server.limits.frameAhead = std::chrono::milliseconds(100);
  EXPECT_THROW(archive::retrieve(server, retrieval, cache, untilHere), io::Cancelled);
  ASSERT_EQ(arrived.size(), 1u);
  EXPECT_EQ(arrived[0].frame, 31);
  EXPECT_EQ(arrived[0].frames, 60);
  EXPECT_EQ(arrived[0].total, 1u);
  EXPECT_EQ(arrived[0].series, made.series);
  EXPECT_TRUE(values == valuesAt(made.file, 31));
  EXPECT_FALSE(fs::exists(arrived[0].file)) << "nothing of it stays";
  EXPECT_TRUE(cache.held(made.uid, made.series).empty());

  server.url = running->web;
  const archive::Retrieved got = archive::retrieve(server, {made.uid, made.series, {}, retrieval.arrived}, cache);
  EXPECT_EQ(arrived.back().frame, 0) << "the object is told last";
  EXPECT_TRUE(objectsIn(got.series.at(0).folder) == objectsIn(made.file.parent_path()));
}

TEST(ArchiveFrames, WhatWasNotAskedForIsNone) {
  const std::string type = R"(multipart/related; type="application/octet-stream"; boundary=b)";
  const std::string samples(16, 'x'), part = "--b\r\n\r\n" + samples, message = part + "\r\n--b--\r\n";
  const auto fetches = [&](const std::string& said, const std::string& answer) {
    const Answering answering(
        [&](const std::string& request) { return request.find("/metadata ") != std::string::npos ? said : answer; });
    const fs::path file = scratchFolder() / "frame";
    bool isFetched = false;
    try {
      isFetched = archive::fetchFrame(answering.server(), {"1.2", "1.2.3", "1.2.3.4", 2}, file);
    } catch (const io::Error&) {
      // One of a server that cannot be spoken to; the retrieval goes on without.
    }
    EXPECT_EQ(fs::exists(file), isFetched);
    return isFetched;
  };
  const std::string said = answerOf("200 OK", "application/dicom+json", metadata);
  const auto of = [](const std::string& kind, const std::string& body) { return answerOf("200 OK", kind, body); };
  EXPECT_TRUE(fetches(said, of(type, message)));
  EXPECT_TRUE(fetches(said, of(R"(multipart/related; type="application/octet-stream; transfer-syntax=)"
                               R"(1.2.840.10008.1.2.1"; boundary=b)",
                               message)))
      << "as Orthanc writes it";
  const std::vector<std::pair<const char*, std::string>> rows{
      {"none", answerOf("404 Not Found", "text/plain", "")},
      {"cannot decode", answerOf("500 Internal Server Error", "application/json", "{}")},
      {"no parts", of("application/octet-stream", samples)},
      {"an object", of(R"(multipart/related; type="application/dicom"; boundary=b)", message)},
      {"compressed", of(R"(multipart/related; type="image/jls"; boundary=b)", message)},
      {"big endian", of(type + "; transfer-syntax=1.2.840.10008.1.2.2", message)},
      {"too short", of(type, "--b\r\n\r\n" + samples.substr(1) + "\r\n--b--\r\n")},
      {"too long", of(type, "--b\r\n\r\n" + samples + "yy\r\n--b--\r\n")},
      {"two parts", of(type, part + "\r\n" + message)},
      {"an empty part more", of(type, part + "\r\n--b\r\n\r\n\r\n--b--\r\n")},
      {"no end of the part", of(type, part)},
      {"no end of the message", of(type, part + "\r\n--b\r\n")},
      {"endless", of(type, "--b\r\n\r\n" + std::string(1u << 20, 'x') + "\r\n--b--\r\n")},
      {"cut off", changed(of(type, message), "Content-Length: ", "Content-Length: 9")}};
  for (const auto& [name, answer] : rows) EXPECT_FALSE(fetches(said, answer)) << name;
  EXPECT_FALSE(fetches(answerOf("404 Not Found", "text/plain", ""), of(type, message)));
}

TEST(ArchiveFrames, AreReadByWhatTheirGroupsSay) {
  const auto header =
      archive::frameHeaderIn(changed(metadata, R"("00280010")",
                                     R"("52009229": {"vr": "SQ", "Value": [{"00289145": {"vr": "SQ", "Value": [{
                   "00281052": {"vr": "DS", "Value": ["-1"]}, "00281053": {"vr": "DS", "Value": [1]}}]}}]},
                 "52009230": {"vr": "SQ", "Value": [{}, {"00289145": {"vr": "SQ", "Value": [{
                   "00281052": {"vr": "DS", "Value": ["-1024.5"]}, "00281053": {"vr": "DS", "Value": [2]}}]}}]},
                 "00280030": {"vr": "DS", "Value": [0.5]}, "00281050": {"vr": "DS", "Value": [40, 300]}, "00280010")"),
                             2);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->bytes(), 16u);
  EXPECT_EQ(header->bitsStored, 12);
  ASSERT_EQ(header->meaning.size(), 3u) << "a spacing of one number is none";
  EXPECT_EQ(header->meaning[0].numbers, std::vector<double>{40.0});
  EXPECT_EQ(header->meaning[1].numbers, std::vector<double>{-1024.5}) << "the frame's own, before the shared one";
  EXPECT_EQ(header->meaning[2].numbers, std::vector<double>{2.0});
  EXPECT_FALSE(archive::frameHeaderIn(metadata, 4)) << "of 3";
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"MONOCHROME2", "RGB"},
           {R"("MR")", R"("SEG")"},
           {R"("Value": [16])", R"("Value": [1])"},
           {R"("Value": [16])", R"("Value": [-16])"},
           {R"("Value": [16])", R"("Value": ["1e9"])"},
           {R"("Value": [4])", R"("Value": [])"},
           {R"("Value": [4])", R"("Value": [4.5])"},
           {R"("Value": [4])", R"("Value": {})"},
           {R"("00280010": {"vr": "US", "Value": [2]})", R"("00280010": 2)"},
           {"[{", "[{}, {"}})
    EXPECT_FALSE(archive::frameHeaderIn(changed(metadata, from, to), 2)) << to;
  for (const char* text : {"", "[]", "{}", "[[]]", "[1", "null"}) EXPECT_FALSE(archive::frameHeaderIn(text, 1)) << text;
}

TEST(ArchiveFrames, AreCountedByWhatASearchSays) {
  const auto framesOf = [](const archive::Attributes& said) {
    archive::Attributes record{{"SOPInstanceUID", "1.2.3.4"}, {"SeriesInstanceUID", "1.2.3"}};
    record.insert(said.begin(), said.end());
    const archive::Wanted wanted = archive::wantedIn({record}, "1.2").at(0);
    const auto at = wanted.frames.find("1.2.3.4");
    return at == wanted.frames.end() ? archive::Frames{} : at->second;
  };
  EXPECT_EQ(framesOf({}).count, 0);
  EXPECT_EQ(framesOf({{"NumberOfFrames", "1"}}).count, 0) << "an image of its own";
  EXPECT_EQ(framesOf({{"NumberOfFrames", "9"}}).count, 9);
  EXPECT_EQ(framesOf({{"NumberOfFrames", "9"}}).bytes, 0u) << "unknown";
  EXPECT_EQ(framesOf({{"NumberOfFrames", "-9"}}).count, 0);
  EXPECT_EQ(framesOf({{"NumberOfFrames", "9"}, {"Rows", "4"}, {"Columns", "8"}, {"BitsAllocated", "16"}}).bytes, 576u);
  EXPECT_EQ(framesOf({{"NumberOfFrames", "2147483647"},
                      {"Rows", "2147483647"},
                      {"Columns", "2147483647"},
                      {"BitsAllocated", "16"}})
                .bytes,
            0u);
}

}  // namespace fenestra::tests::archiveFramesTest
