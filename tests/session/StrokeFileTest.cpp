// Strokes in a file of their own: they come back to the bit, and any other file is one clear error.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "io/session/StrokeFile.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::strokeFileTest {
namespace {

namespace fs = std::filesystem;

BrushStrokes someStrokes() {
  BrushStroke first;
  first.anchors = {{0.1, -0.0, 1.0 / 3.0}, {1e-300, 123456789.0123456789, -5.0}};
  first.radius = std::nextafter(5.0, 6.0);
  first.softness = 0.0;
  BrushStroke second;
  second.mode = BrushMode::Strengthen;
  second.anchors = {{1.0, 2.0, 3.0}};
  second.amount = 1.0;
  second.toSurface = second.coversFocus = second.hidden = true;
  second.view = 1;
  return {first, second};
}

TEST(StrokeFile, BringsStrokesBackToTheBit) {
  const fs::path folder = scratchFolder();
  io::writeStrokes(folder / "a.json", someStrokes());
  const BrushStrokes read = io::readStrokes(folder / "a.json");
  EXPECT_EQ(read, someStrokes());
  EXPECT_TRUE(std::signbit(read[0].anchors[0].y)) << "minus zero is not zero";
  io::writeStrokes(folder / "b.json", read);
  EXPECT_EQ(readFile(folder / "a.json"), readFile(folder / "b.json"));
}

TEST(StrokeFile, MissingMembersHaveTheirDefaults) {
  const fs::path file = scratchFolder() / "a.json";
  writeFile(file, R"({"format": "fenestra-strokes", "version": 1, "strokes": [{"anchors": [[1, 2, 3]]}]})");
  BrushStroke expected;
  expected.anchors = {{1.0, 2.0, 3.0}};
  EXPECT_EQ(io::readStrokes(file), BrushStrokes{expected});
}

TEST(StrokeFile, SaysWhereTheMistakeIs) {
  const fs::path file = scratchFolder() / "a.json";
  const auto error = [&](const std::string& strokes) {
    writeFile(file, R"({"format": "fenestra-strokes", "version": 1, "strokes": )" + strokes + "}");
    return errorOf([&] { io::readStrokes(file); });
  };
  const auto expectSaid = [&](const std::string& strokes, const std::string& part) {
    const std::string said = error(strokes);
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  expectSaid(R"([{}, {"radius": 0}])", "\"/strokes/1/radius\" is out of range");
  expectSaid(R"([{"anchors": [[1, 2]]}])", "\"/strokes/0/anchors/0\" is not a list of 3");
  expectSaid(R"([{"anchors": [[1, 2, "3"]]}])", "\"/strokes/0/anchors/0/2\" is not a number");
  expectSaid(R"([{"mode": "erase"}])", "\"/strokes/0/mode\" is none of restore, open, fade, strengthen");
  expectSaid(R"([{"view": 2}])", "out of range");
  expectSaid(R"([{"view": 0.5}])", "is not a whole number");
  expectSaid(R"([{"hidden": 1}])", "is neither true nor false");
  expectSaid(R"([{"radius": 1, "radius": 2}])", "has the member \"radius\" twice");
  expectSaid("7", "\"/strokes\" is not a list");
  writeFile(file, R"({"format": "fenestra-strokes", "version": 2})");
  EXPECT_NE(errorOf([&] { io::readStrokes(file); }).find("newer version"), std::string::npos);
  writeFile(file, R"({"nodes": []})");
  EXPECT_NE(errorOf([&] { io::readStrokes(file); }).find("is not a file of strokes"), std::string::npos);
}

TEST(StrokeFile, WritesNoNumberThatIsNone) {
  BrushStrokes strokes = someStrokes();
  strokes[0].depth = std::numeric_limits<double>::quiet_NaN();
  const fs::path file = scratchFolder() / "a.json";
  EXPECT_THROW(io::writeStrokes(file, strokes), std::invalid_argument);
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace fenestra::tests::strokeFileTest
