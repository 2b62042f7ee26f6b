// Sessions as files: they come back to the bit, by the published schema, from older versions, and with what a newer
// version added; a crash while saving leaves a whole one.

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/base/AtomicFile.h"
#include "io/session/SessionFile.h"
#include "io/session/SessionSchema.h"
#include "tests/io/IoTesting.h"
#include "tests/session/SchemaTesting.h"
#include "tests/session/SessionTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::sessionFileTest {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path saved(const io::Session& session, const std::string& name = "a.fenestra") {
  const fs::path file = scratchFolder() / name;
  io::writeSession(file, session);
  return file;
}

const fs::path published = FENESTRA_SCHEMA;

TEST(SessionFile, BringsEverythingBackToTheBit) {
  const fs::path folder = scratchFolder();
  const io::Session session = fullSession(folder);
  io::writeSession(folder / "a.fenestra", session);
  const io::Session read = io::readSession(folder / "a.fenestra");
  EXPECT_EQ(read, session);
  EXPECT_TRUE(std::signbit(read.crosshair->x)) << "minus zero is not zero";
  io::writeSession(folder / "b.fenestra", read);
  EXPECT_EQ(readFile(folder / "a.fenestra"), readFile(folder / "b.fenestra"));
}

TEST(SessionFile, ARegionComesBackToTheBit) {
  const fs::path folder = scratchFolder();
  for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(1.0 / 3.0)}) {
    io::Session session = fullSession(folder);
    session.look.focus = RegionFocus{{{0.1, -1.0 / 7.0, 1e-17}, {1.0, 2.0, 3.0}}, {{-0.3, 4.0, 5.0}}, tolerance};
    io::writeSession(folder / "a.fenestra", session);
    EXPECT_EQ(io::readSession(folder / "a.fenestra"), session);
    std::get<RegionFocus>(session.look.focus).rule = RegionRule::Tissues;
    std::get<RegionFocus>(session.look.focus).ball = 10.0 / 3.0;
    io::writeSession(folder / "a.fenestra", session);
    EXPECT_EQ(io::readSession(folder / "a.fenestra"), session);
  }
  io::Session session = fullSession(folder);
  session.look.focus = RegionFocus{{}, {{1.0, 2.0, 3.0}}, {}};
  io::writeSession(folder / "a.fenestra", session);
  EXPECT_THROW(io::readSession(folder / "a.fenestra"), io::Error) << "there is no seed inside";
  const SelectionStroke line{{{0.1, -1.0 / 7.0, 1e-17}, {1.0, 2.0, 3.0}}, 1.0 / 3.0, 0.7, false};
  for (const std::vector<glm::dvec3>& inside : {std::vector<glm::dvec3>(), {{1.0, 2.0, 3.0}}}) {
    session.look.focus = RegionFocus{inside, {}, {}, {{{{-4.0, 5.0, 6.0}}, 12.5}, line}};
    io::writeSession(folder / "a.fenestra", session);
    EXPECT_EQ(io::readSession(folder / "a.fenestra"), session);
  }
  session.look.focus = RegionFocus{{}, {}, {}, {{{}, 12.5}}};
  io::writeSession(folder / "a.fenestra", session);
  EXPECT_THROW(io::readSession(folder / "a.fenestra"), io::Error) << "a stroke without a point";
}

TEST(SessionFile, AnyDoubleComesBackToTheBit) {
  const fs::path folder = scratchFolder();
  std::mt19937_64 random(5);
  io::Session session = fullSession(folder);
  auto& nodes = session.look.context.function.nodes;
  nodes.clear();
  while (nodes.size() < 20000) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) nodes.push_back({value, {{0.5, 0.5, 0.5}, std::abs(value)}});
  }
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  io::writeSession(folder / "a.fenestra", session);
  const io::Session read = io::readSession(folder / "a.fenestra");
  ASSERT_EQ(read.look.context.function.nodes.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto &was = nodes[i], &is = read.look.context.function.nodes[i];
    ASSERT_EQ(std::memcmp(&was.value, &is.value, sizeof(double)), 0) << was.value;
    ASSERT_EQ(std::memcmp(&was.properties.extinction, &is.properties.extinction, sizeof(double)), 0);
  }
}

TEST(SessionFile, WritesNoNumberThatIsNone) {
  const fs::path folder = scratchFolder();
  for (const double none : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    io::Session session = fullSession(folder);
    session.views[1].camera.eye.z = none;
    EXPECT_THROW(io::writeSession(folder / "a.fenestra", session), std::invalid_argument);
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(SessionFile, ThePublishedSchemaIsMadeFromTheListOfMembers) {
  const fs::path made = scratchFolder() / published.filename();
  writeFile(made, io::sessionSchema());
  EXPECT_TRUE(readFile(published) == readFile(made)) << "the list has changed: cp " << made << " " << published;
}

TEST(SessionFile, IsWhatThePublishedSchemaSays) {
  const fs::path folder = scratchFolder();
  std::vector<fs::path> files;
  const auto add = [&](const io::Session& session) {
    files.push_back(folder / (std::to_string(files.size()) + ".fenestra"));
    io::writeSession(files.back(), session);
  };
  io::Session session = fullSession(folder);
  add(session);
  session.look.context.preset = "ct-bone";
  session.look.context.file.clear();
  session.look.focus = LabelFocus{{1, 7}};
  add(session);
  session.look.focus = RegionFocus{{{1.0, 2.0, 3.0}}, {}, {}};
  add(session);
  session.look.focus = RegionFocus{{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}, {{7.0, 8.0, 9.0}}, 12.5};
  add(session);
  session.look.focus =
      RegionFocus{{}, {}, {}, {{{{1.0, 2.0, 3.0}}, 4.0, 0.5, true}, {{{1.0, 2.0, 3.0}}, 4.0, 0.0, false}}};
  add(session);
  session.look.focus = LabelFocus{{1, 7}};
  session.volume = {};
  session.phantom = io::SessionPhantom{"head", 64};
  add(session);
  io::Session plain;
  plain.volume.path = folder / "a.nii";
  add(plain);
  EXPECT_EQ(mistakesIn(published, files), std::vector<std::string>());
}

TEST(SessionFile, TheSchemaRefusesWhatTheReaderRefuses) {
  const fs::path folder = scratchFolder();
  const Json good = Json::parse(readFile(saved(fullSession(folder))));
  const std::vector<std::pair<std::string, Json>> wrong{
      {"/linked", 1},
      {"/quality", "best"},
      {"/max_error", 1e-300},
      {"/cutaway/open_width", -1},
      {"/cutaway/unit", "cm"},
      {"/context_layer/colour/1", 1.5},
      {"/shading/shininess", -1},
      {"/views", Json::array()},
      {"/views/0/size", Json{0, 5}},
      {"/views/0/size/1", 20000},
      {"/views/1/camera/eye", Json{1, 2}},
      {"/views/1/camera/vertical_fov", 180},
      {"/strokes/0/anchors/1/0", "1"},
      {"/strokes/2/radius", 0},
      {"/removals/0/size", 0},
      {"/removals/1/shape", "cone"},
      {"/removals/2/bends/0/radius", 0},
      {"/context/nodes/0/colour/2", 1.5},
      {"/volume/bytes", -1},
      {"/volume/raw/dims", Json{1, 2, 3, 4}},
      {"/volume/raw/type", "int64"},
      {"/placement/samples", 1e6},
      {"/planes", Json::array()},
      {"/planes/0/slab/thickness", 101},
      {"/planes/1/axes/right/0", 2},
      {"/planes/2/follow", "C3"},
      {"/focus", 3},
      {"/focus", {{"inside", Json::array({Json{1, 2}})}}},
      {"/focus", {{"inside", Json::array({Json{1, 2, 3}})}, {"tolerance", -1}}},
  };
  std::vector<fs::path> files;
  for (const auto& [pointer, value] : wrong) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    files.push_back(folder / (std::to_string(files.size()) + ".fenestra"));
    writeFile(files.back(), bad.dump());
    const std::string said = errorOf([&] { io::readSession(files.back()); });
    EXPECT_NE(said.find(pointer), std::string::npos) << said;
  }
  const std::vector<std::string> mistakes = mistakesIn(published, files);
  for (std::size_t i = 0; i < files.size(); ++i)
    EXPECT_TRUE(std::any_of(mistakes.begin(), mistakes.end(), [&](const std::string& mistake) {
      return mistake.starts_with(files[i].string() + ": /");
    })) << wrong[i].first;
}

TEST(SessionFile, RefusesAxesOfASliceThatAreNotPerpendicular) {
  io::Session session = fullSession(scratchFolder());
  session.planes[1].axes->down = {0.0, 0.6, -0.8};
  const std::string said = errorOf([&] { io::readSession(saved(session)); });
  EXPECT_NE(said.find("no perpendicular unit vectors"), std::string::npos) << said;
}

TEST(SessionFile, RefusesKeyImagesThatNobodyMakes) {
  const io::Session good = fullSession(scratchFolder());
  const std::pair<const char*, std::function<void(io::Session&)>> wrong[] = {
      {"too long a name", [](io::Session& bad) { bad.keyImages[1].name.assign(201, 'x'); }},
      {"too large a picture", [](io::Session& bad) { bad.keyImages[1].picture.assign((1 << 18) + 1, 'A'); }},
      {"more key images", [](io::Session& bad) { bad.keyImages.assign(501, bad.keyImages[1]); }},
      {"no perpendicular unit vectors",
       [](io::Session& bad) {
         bad.keyImages[0].planes[1].axes->down = {0, 0.6, -0.8};
       }},
      {"low exceeds its high", [](io::Session& bad) {
         bad.keyImages[1].look.focus = ValueFocus{{2.0, 1.0}};
       }}};
  for (const auto& [says, spoil] : wrong) {
    io::Session bad = good;
    spoil(bad);
    const std::string said = errorOf([&] { io::readSession(saved(bad)); });
    EXPECT_NE(said.find(says), std::string::npos) << said;
  }
}

TEST(SessionFile, KeepsWhatItDoesNotKnowAtEveryLevel) {
  const fs::path folder = scratchFolder(), file = folder / "a.fenestra";
  io::writeSession(file, fullSession(folder));
  Json root = Json::parse(readFile(file));
  const Json extra{{"deep", {1, 2.5, {{"er", nullptr}}}}, {"text", "é\u0001\"\\"}, {"large", 18446744073709551615u}};
  for (const char* place : {"", "/volume", "/volume/raw", "/labels", "/focus", "/context", "/context/nodes/1",
                            "/cutaway", "/context_layer", "/shading", "/views/1", "/views/0/camera", "/home/1",
                            "/window", "/overlays", "/placement", "/placement/weights", "/strokes/2", "/removals/1"})
    root[Json::json_pointer(place)]["of_tomorrow"] = extra;
  writeFile(file, root.dump());
  const auto unknownPlaces = [](const fs::path& path) {
    int places = 0;
    const std::function<void(const Json&)> count = [&](const Json& value) {
      if (value.is_object() && value.contains("of_tomorrow")) ++places;
      if (value.is_structured())
        for (const Json& each : value) count(each);
    };
    count(Json::parse(readFile(path)));
    return places;
  };
  ASSERT_EQ(unknownPlaces(file), 19);

  io::Session session = io::readSession(file);
  io::writeSession(folder / "b.fenestra", session);
  EXPECT_EQ(Json::parse(readFile(folder / "b.fenestra")), root) << "nothing but the order may differ";
  io::writeSession(folder / "c.fenestra", io::readSession(folder / "b.fenestra"));
  EXPECT_EQ(readFile(folder / "b.fenestra"), readFile(folder / "c.fenestra"));

  // What was edited keeps what belongs to it; what is gone takes its own along.
  session.look.cutaway.openWidth = 77.0;
  session.views[1].camera.eye.x += 1.0;
  session.look.strokes.erase(session.look.strokes.begin());
  io::writeSession(file, session);
  EXPECT_EQ(unknownPlaces(file), 19);
  root = Json::parse(readFile(file));
  EXPECT_TRUE(root["strokes"][1].contains("of_tomorrow"));
  EXPECT_EQ(root["views"][1]["of_tomorrow"], extra);
  session.look.strokes.pop_back();
  io::writeSession(file, session);
  EXPECT_EQ(unknownPlaces(file), 18);
}

TEST(SessionFile, OpensAnOlderVersion) {
  const fs::path sample = fs::path(FENESTRA_SESSION_SAMPLES) / "version-1.fenestra";
  const io::Session session = io::readSession(sample);
  EXPECT_EQ(session.volume.path, sample.parent_path() / "head.nii.gz");
  EXPECT_EQ(session.labels.path, sample.parent_path() / "labels" / "head.nii.gz");
  EXPECT_EQ(session.look.cutaway.openWidth, 12.5);
  EXPECT_EQ(session.look.cutaway.borderWidth, 3.0);
  EXPECT_EQ(session.views[0].camera.eye, glm::dvec3(10.0, -500.25, 30.0));
  EXPECT_EQ(session.views[1].camera.projection, Projection::Orthographic);
  EXPECT_EQ(session.home[1], session.views[1].camera);
  EXPECT_EQ(session.look.focus, Focus(LabelFocus{{3, 5}}));
  EXPECT_EQ(session.views[0].size, io::SessionView().size) << "it had no size";
  EXPECT_EQ(session.planes, (std::array<io::SessionPlane, 3>())) << "its slices were the volume's own";
  EXPECT_TRUE(session.keyImages.empty());
  const fs::path file = saved(session);
  const Json written = Json::parse(readFile(file));
  EXPECT_EQ(written["version"], io::sessionVersion);
  EXPECT_FALSE(written.contains("cameras"));
  EXPECT_EQ(written["note"], "kept by whoever does not know it");
  EXPECT_EQ(io::readSession(file), session);
}

TEST(SessionFile, OpensOneFromBeforeThereWerePaths) {
  const fs::path folder = scratchFolder(), file = folder / "a.fenestra";
  io::Session session = fullSession(folder);
  session.path = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.5}};
  io::writeSession(file, session);
  Json root = Json::parse(readFile(file));
  ASSERT_EQ(root.erase("path"), 1u);
  writeFile(file, root.dump());
  session.path.clear();
  EXPECT_EQ(io::readSession(file), session);
}

TEST(SessionFile, OpensTheOpacityOfLabelsOfVersion3AsThatOf30Millimetres) {
  const fs::path sample = fs::path(FENESTRA_SESSION_SAMPLES) / "version-3.fenestra";
  const io::Session session = io::readSession(sample);
  const LabelSettings& labels = session.look.labels;
  EXPECT_NEAR(settingFor(labels, 2).opacity, 1.0 - 0.6 * 0.6 * 0.6, 1e-15);
  EXPECT_EQ(settingFor(labels, 2).role, LabelRole::Protected);
  EXPECT_EQ(settingFor(labels, 3).opacity, 0.0);
  EXPECT_EQ(settingFor(labels, 5).opacity, 1.0);
  const fs::path file = saved(session);
  EXPECT_EQ(io::readSession(file).look.labels, labels) << "what is saved is of this version";
}

TEST(SessionFile, RefusesANewerVersionAndOtherFiles) {
  const fs::path file = saved(fullSession(scratchFolder()));
  Json root = Json::parse(readFile(file));
  root["version"] = io::sessionVersion + 1;
  writeFile(file, root.dump());
  EXPECT_NE(errorOf([&] { io::readSession(file); }).find("newer version"), std::string::npos);
  for (const char* text : {"{}", "[]", "3", "\"fenestra-session\"", R"({"format": 3})", R"({"format": "vtk"})"}) {
    writeFile(file, text);
    EXPECT_NE(errorOf([&] { io::readSession(file); }).find("is not a session"), std::string::npos) << text;
  }
  EXPECT_NE(errorOf([&] { io::readSession(file.parent_path() / "none.fenestra"); }).find("does not exist"),
            std::string::npos);
}

TEST(SessionFile, KeepsPathsRelative) {
  const fs::path folder = scratchFolder();
  fs::create_directories(folder / "sessions" / "mine");
  fs::create_directories(folder / "patient's  é");
  const auto pathOf = [](const fs::path& file) { return Json::parse(readFile(file))["volume"]["path"]; };
  io::Session session = fullSession(folder);
  session.volume.path = folder / "patient's  é";
  const fs::path deep = folder / "sessions" / "mine" / "a.fenestra";
  io::writeSession(deep, session);
  EXPECT_EQ(pathOf(deep), "../../patient's  é");
  EXPECT_EQ(io::readSession(deep).volume.path, folder / "patient's  é");
  EXPECT_EQ(readFile(deep).find(folder.string()), std::string::npos)
      << "a session must not name the folders above its own";

  session.volume.path = folder / "sessions" / "mine";
  io::writeSession(deep, session);
  EXPECT_EQ(pathOf(deep), ".");
  EXPECT_EQ(io::readSession(deep).volume.path, folder / "sessions" / "mine");

  // Behind a link, ".." is resolved as the system does.
  fs::create_directory_symlink(folder / "sessions" / "mine", folder / "link");
  session.volume.path = folder / "patient's  é";
  io::writeSession(folder / "link" / "b.fenestra", session);
  EXPECT_EQ(pathOf(folder / "link" / "b.fenestra"), "../../patient's  é");
  EXPECT_EQ(io::readSession(folder / "link" / "b.fenestra").volume.path, folder / "patient's  é");

  session.volume.path = folder / "\xff\xfe.nii";
  EXPECT_NE(errorOf([&] { io::writeSession(deep, session); }).find("not UTF-8"), std::string::npos);
}

/// 200 times, a program that saves one session over another without end is killed at a random moment.
TEST(SessionFile, IsWholeWheneverSavingIsKilled) {
  const fs::path folder = scratchFolder(), file = folder / "a.fenestra";
  io::Session a = fullSession(folder), b = a;
  for (int i = 0; i < 40; ++i) a.look.strokes.push_back(someStroke(BrushMode::Restore, 50));
  b.look.strokes.push_back(someStroke(BrushMode::Restore, 4000));
  const std::string textOfA = io::textOf(a, file), textOfB = io::textOf(b, file);
  io::writeSession(file, a);
  std::mt19937 random(1);
  int halfWritten = 0, sawA = 0, sawB = 0;
  // On a busy machine fewer of the moments fall into a save, so more of them are tried.
  constexpr int kills = 200, mostKills = 10 * kills;
  const auto sawEnough = [&] { return halfWritten > kills / 10 && sawA > 0 && sawB > 0; };
  for (int kill = 0; kill < kills || (!sawEnough() && kill < mostKills); ++kill) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      // The second half of writeSession, once the text is made; before that, the file is not touched.
      io::writeText(file, textOfB);
      if (::write(ready[1], "", 1) != 1) ::_exit(1);
      for (;;) {
        io::writeText(file, textOfA);
        io::writeText(file, textOfB);
      }
    }
    // A process of a sanitizer takes its time to start: the moment counts from its first save on.
    char started = 0;
    EXPECT_EQ(::read(ready[0], &started, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
    ::usleep(std::uniform_int_distribution<useconds_t>(0, 9000)(random));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
    const std::string text = readFile(file);
    ASSERT_TRUE(text == textOfA || text == textOfB) << "after kill " << kill << ": " << text.size() << " bytes";
    (text == textOfA ? sawA : sawB)++;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path() != file) {
        ++halfWritten;
        fs::remove(entry.path());
      }
  }
  // Otherwise no process was stopped at a moment in which a save could have been damaged.
  EXPECT_GT(halfWritten, kills / 10);
  EXPECT_GT(sawA, 0);
  EXPECT_GT(sawB, 0);
}

}  // namespace
}  // namespace fenestra::tests::sessionFileTest
