// Presets of a look in files of their own: they come back to the bit on any volume, and any other file is one clear
// error.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/TransferFunctionFile.h"
#include "io/session/LookFile.h"
#include "rendering/settings/LookStyle.h"
#include "tests/io/IoTesting.h"
#include "tests/session/SchemaTesting.h"
#include "tests/session/SessionTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::lookFileTest {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const fs::path published = FENESTRA_LOOK_SCHEMA;

io::LookPreset somePreset(const fs::path& folder) {
  const TransferFunction function{{{-20.0, {{0.2, 0.4, 1.0}, 0.0}}, {150.0, {{0.9, 0.3, 0.2}, 0.75}}}};
  return {"Gefäße", "HU", styleOf(fullSession(folder).look), {}, {{"Leber", function}, {"7", {}}}};
}

/// A volume with labels of those names, and unnamed ones.
SetScene sceneWith(const std::vector<Label>& labels) {
  auto volume = std::make_shared<Volume>();
  volume->unit = "HU";
  auto map = std::make_shared<LabelMap>();
  map->labels = labels;
  SetScene scene;
  scene.volume = volume;
  scene.labels = map;
  return scene;
}

TEST(LookFile, BringsEverythingBackToTheBit) {
  const fs::path folder = scratchFolder();
  const io::LookPreset preset = somePreset(folder);
  io::writeLook(folder / "a.json", preset);
  const io::LookPreset read = io::readLook(folder / "a.json");
  EXPECT_EQ(read, preset);
  io::writeLook(folder / "b.json", read);
  EXPECT_EQ(readFile(folder / "a.json"), readFile(folder / "b.json"));
}

TEST(LookFile, HoldsNothingOfTheData) {
  const fs::path folder = scratchFolder();
  const Look look = fullSession(folder).look;
  io::writeLook(folder / "a.json", {"x", "HU", look, {}});
  const io::LookPreset read = io::readLook(folder / "a.json");
  EXPECT_EQ(read.look, styleOf(look));
  EXPECT_EQ(read.look.focus, Focus());
  EXPECT_TRUE(read.look.strokes.empty() && read.look.removals.empty() && read.look.labels.empty() &&
              read.look.context.file.empty());
  EXPECT_EQ(readFile(folder / "a.json").find(folder.string()), std::string::npos) << "no path of the user's";
}

TEST(LookFile, LabelsAreFoundAgainByNameOrByTheValueOfUnnamedOnes) {
  const fs::path file = scratchFolder() / "a.json";
  const TransferFunction liver{{{0.0, {{1.0, 0.0, 0.0}, 0.5}}}}, unnamed{{{10.0, {{0.0, 1.0, 0.0}, 0.25}}}};
  SetScene first = sceneWith({{1, "liver"}, {2, ""}, {3, "spleen"}});
  first.look.labels = {{.label = 1, .opacity = 0.5, .function = liver}, {.label = 2, .function = unnamed}};
  io::writeLook(file, io::presetOf("x", first));
  const io::LookPreset preset = io::readLook(file);
  ASSERT_EQ(preset.labels, (std::vector<io::LabelFunction>{{"liver", liver}, {"2", unnamed}}));
  EXPECT_EQ(io::restyled(first, preset), first.look);

  SetScene second = sceneWith({{1, "spleen"}, {2, ""}, {9, "liver"}});
  second.look.labels = {{.label = 1, .role = LabelRole::Hidden, .function = liver}};
  const Look result = io::restyled(second, preset);
  EXPECT_EQ(settingFor(result.labels, 9).function, liver) << "by name, whatever its value";
  EXPECT_EQ(settingFor(result.labels, 9).opacity, 1.0) << "opacity and role belong to the data";
  EXPECT_EQ(settingFor(result.labels, 2).function, unnamed);
  EXPECT_EQ(settingFor(result.labels, 1), (LabelSetting{.label = 1, .role = LabelRole::Hidden}))
      << "of one material, as in the preset";
  second.labels = nullptr;
  EXPECT_EQ(io::restyled(second, preset).labels, second.look.labels) << "settings of labels that are not there stay";
}

TEST(LookFile, OnAnotherVolumeTheLookIsTheSame) {
  const fs::path folder = scratchFolder();
  const Look first = fullSession(folder).look;
  io::writeLook(folder / "a.json", {"x", "HU", first, {}});
  Look second;
  second.focus = LabelFocus{{4, 9}};
  second.labels = {{.label = 4, .opacity = 0.5}};
  second.strokes = {someStroke(BrushMode::Open)};
  second.removals = {someRemoval(RemovalShape::Ball)};
  second.context.preset = "mr";
  const Look result = restyled(second, io::readLook(folder / "a.json").look);
  EXPECT_EQ(styleOf(result), styleOf(first));
  EXPECT_EQ(result.context.shifted(), first.context.shifted());
  EXPECT_EQ(result.focus, second.focus);
  EXPECT_EQ(result.labels, second.labels);
  EXPECT_EQ(result.strokes, second.strokes);
  EXPECT_EQ(result.removals, second.removals);
}

TEST(LookFile, IsWhatThePublishedSchemaSays) {
  const fs::path folder = scratchFolder(), made = folder / published.filename();
  writeFile(made, io::lookSchema());
  EXPECT_TRUE(readFile(published) == readFile(made)) << "the list has changed: cp " << made << " " << published;
  io::writeLook(folder / "full.json", somePreset(folder));
  io::writeLook(folder / "plain.json", {});
  EXPECT_EQ(mistakesIn(published, {folder / "full.json", folder / "plain.json"}), std::vector<std::string>());
}

TEST(LookFile, KeepsWhatItDoesNotKnow) {
  const fs::path folder = scratchFolder();
  io::writeLook(folder / "a.json", somePreset(folder));
  Json root = Json::parse(readFile(folder / "a.json"));
  root["later"] = {{"a", 1.5}};
  root["cutaway"]["sharpness"] = 0.25;
  root["nodes"][1]["gloss"] = "high";
  writeFile(folder / "b.json", root.dump());
  io::LookPreset read = io::readLook(folder / "b.json");
  EXPECT_EQ(read.look, somePreset(folder).look);
  read.name = "Another";
  io::writeLook(folder / "c.json", read);
  root["name"] = "Another";
  EXPECT_EQ(Json::parse(readFile(folder / "c.json")), root);
}

TEST(LookFile, MissingMembersHaveTheirDefaults) {
  const fs::path file = scratchFolder() / "a.json";
  writeFile(file, R"({"format": "fenestra-look", "version": 1, "name": "x", "nodes": []})");
  io::LookPreset expected;
  expected.name = "x";
  EXPECT_EQ(io::readLook(file), expected);
}

TEST(LookFile, SaysWhereTheMistakeIs) {
  const fs::path file = scratchFolder() / "a.json";
  const auto expectSaid = [&](const std::string& text, const std::string& part) {
    writeFile(file, text);
    const std::string said = errorOf([&] { io::readLook(file); });
    EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_NE(said.find(file.string()), std::string::npos) << said;
  };
  const auto withMembers = [](const std::string& members) {
    return R"({"format": "fenestra-look", "version": 1, "name": "x", )" + members + "}";
  };
  expectSaid("", "JSON");
  expectSaid("[]", "is not a preset of a look");
  expectSaid(R"({"format": "fenestra-session", "version": 1})", "is not a preset of a look");
  expectSaid(R"({"format": "fenestra-look", "version": 2})", "was written by a newer version");
  expectSaid(R"({"format": "fenestra-look", "version": 1})", "lacks \"name\"");
  expectSaid(withMembers(R"("unit": "HU")"), "lacks \"nodes\"");
  expectSaid(withMembers(R"("nodes": [{"value": 1}, {"value": 0}])"), "not in order");
  expectSaid(withMembers(R"("nodes": [], "cutaway": {"open_width": -1})"), "\"/cutaway/open_width\" is out of range");
  expectSaid(withMembers(R"("nodes": [{"extinction": 1e999}])"), "");
  expectSaid(withMembers(R"("nodes": [{"colour": [0, 2, 0]}])"), "\"/nodes/0/colour/1\" is out of range");
}

TEST(LookFile, SaysWhereTheUnitsDiffer) {
  const io::LookPreset preset{"Bone", "HU", {}, {}};
  EXPECT_EQ(io::mismatchOf(preset, "HU"), "");
  EXPECT_NE(io::mismatchOf(preset, "").find("without a unit"), std::string::npos);
}

TEST(LookFile, AFileThatIsNotThereIsAnError) {
  EXPECT_NE(errorOf([] { io::readLook(scratchFolder() / "none.json"); }), "");
}

}  // namespace
}  // namespace fenestra::tests::lookFileTest
