#include "io/PhantomFile.h"

#include <set>

#include <gtest/gtest.h>

namespace fenestra::io::phantomFileTest {
namespace {

/// A description with one body whose members are `members`.
std::string withBody(const std::string& members) {
  return R"({"name": "N", "extent": [10, 20, 30], "background": -1000, "bodies": [{)" + members + "}]}";
}
std::string withShape(const std::string& shape) {
  return withBody(R"("name": "b", "label": 1, "value": 5, "colour": [1, 0.5, 0], "shapes": [)" + shape + "]");
}

template <class S>
S onlyShape(const std::string& shape) {
  const Phantom phantom = parsePhantom(withShape(shape), "test");
  EXPECT_EQ(phantom.bodies.at(0).shapes.size(), 1u);
  return std::get<S>(phantom.bodies.at(0).shapes.at(0));
}

TEST(PhantomFile, readsEveryMember) {
  const Phantom phantom =
      parsePhantom(withShape(R"({"type": "ellipsoid", "centre": [1, 2, 3], "semiAxes": [4, 5, 6]})"), "test");
  EXPECT_EQ(phantom.name, "N");
  EXPECT_EQ(phantom.extent, glm::dvec3(10, 20, 30));
  EXPECT_EQ(phantom.background, -1000.0);
  const PhantomBody& body = phantom.bodies.at(0);
  EXPECT_EQ(body.name, "b");
  EXPECT_EQ(body.label, 1);
  EXPECT_EQ(body.value, 5.0);
  EXPECT_EQ(body.colour, glm::dvec3(1, 0.5, 0));
  const auto& ellipsoid = std::get<Ellipsoid>(body.shapes.at(0));
  EXPECT_EQ(ellipsoid.centre, glm::dvec3(1, 2, 3));
  EXPECT_EQ(ellipsoid.semiAxes, glm::dvec3(4, 5, 6));
  EXPECT_EQ(ellipsoid.axes, glm::dmat3(1.0));
}

TEST(PhantomFile, rotatesAboutXThenYThenZ) {
  const auto box =
      onlyShape<Box>(R"({"type": "box", "centre": [0, 0, 0], "semiAxes": [1, 2, 3], "rotation": [90, 0, 90]})");
  // x → x → y; y → z → z
  EXPECT_NEAR(glm::distance(box.axes[0], glm::dvec3(0, 1, 0)), 0.0, 1e-15);
  EXPECT_NEAR(glm::distance(box.axes[1], glm::dvec3(0, 0, 1)), 0.0, 1e-15);
}

TEST(PhantomFile, chainsAndArcsAreCapsules) {
  const Phantom chain = parsePhantom(
      withShape(R"({"type": "chain", "points": [[0, 0, 0], [1, 0, 0], [1, 2, 0]], "radius": 0.5})"), "test");
  ASSERT_EQ(chain.bodies[0].shapes.size(), 2u);
  EXPECT_EQ(std::get<Capsule>(chain.bodies[0].shapes[1]).b, glm::dvec3(1, 2, 0));
  const Phantom arc = parsePhantom(
      withShape(
          R"({"type": "arc", "centre": [0, 0, 5], "u": [2, 0, 0], "v": [0, 3, 0], "from": 0, "to": 90, "steps": 4, "radius": 1})"),
      "test");
  ASSERT_EQ(arc.bodies[0].shapes.size(), 4u);
  EXPECT_EQ(std::get<Capsule>(arc.bodies[0].shapes[0]).a, glm::dvec3(2, 0, 5));
  EXPECT_NEAR(glm::distance(std::get<Capsule>(arc.bodies[0].shapes[3]).b, glm::dvec3(0, 3, 5)), 0.0, 1e-15);
}

TEST(PhantomFile, mirrorAddsTheOtherSide) {
  const Phantom phantom = parsePhantom(
      withShape(
          R"({"type": "ellipsoid", "centre": [4, 1, 0], "semiAxes": [1, 2, 3], "rotation": [0, 0, 30], "mirror": true})"),
      "test");
  ASSERT_EQ(phantom.bodies[0].shapes.size(), 2u);
  for (double x = -6.0; x <= 6.0; x += 0.37)
    for (double y = -2.0; y <= 4.0; y += 0.41)
      EXPECT_EQ(contains(phantom.bodies[0].shapes[0], {x, y, 0.3}),
                contains(phantom.bodies[0].shapes[1], {-x, y, 0.3}));
}

TEST(PhantomFile, insetShrinksAnEarlierBody) {
  const Phantom phantom = parsePhantom(
      R"({"name": "N", "extent": [9, 9, 9], "background": 0, "bodies": [
        {"name": "skin", "label": 1, "value": 1, "colour": [0, 0, 0], "shapes": [
          {"type": "box", "centre": [0, 0, 0], "semiAxes": [3, 4, 5]},
          {"type": "chain", "points": [[0, 0, 0], [5, 0, 0]], "radius": 2}]},
        {"name": "fat", "label": 2, "value": 2, "colour": [0, 0, 0], "inset": {"of": "skin", "by": 0.5}}]})",
      "test");
  EXPECT_EQ(std::get<Box>(phantom.bodies[1].shapes[0]).semiAxes, glm::dvec3(2.5, 3.5, 4.5));
  EXPECT_EQ(std::get<Capsule>(phantom.bodies[1].shapes[1]).radius, 1.5);
}

TEST(PhantomFile, complainsAboutWhatIsWrong) {
  const std::string good = R"("name": "b", "label": 1, "value": 5, "colour": [1, 0.5, 0])";
  const struct {
    std::string text, cause;
  } cases[] = {
      {"", "is not JSON"},
      {"[1, 2", "is not JSON"},
      {"[]", "an object in braces is expected"},
      {"{}", "\"name\" is missing"},
      {R"({"name": "N", "extent": [1, 1], "background": 0, "bodies": []})", "\"extent\" must be three numbers"},
      {R"({"name": "N", "extent": [1, 0, 1], "background": 0, "bodies": []})", "\"extent\" must be positive"},
      {R"({"name": "N", "extent": [1, 1e999, 1], "background": 0, "bodies": []})", "too large"},
      {R"({"name": "N", "extent": [1, 1, 1], "background": 0, "bodies": []})", "at least one body"},
      {R"({"name": 3, "extent": [1, 1, 1], "background": 0, "bodies": []})", "\"name\" must be a text"},
      {R"({"name": "N", "extent": [1, 1, 1], "background": 0, "bodies": [], "colour": 1})", "unknown key \"colour\""},
      {withBody(""), "body \"number 1\": \"name\" is missing"},
      {withBody(good), "body \"b\": has no shapes"},
      {withBody(R"("name": "b", "label": 65536, "value": 5, "colour": [1, 1, 1])"), "\"label\" must be a whole number"},
      {withBody(R"("name": "b", "label": 1.5, "value": 5, "colour": [1, 1, 1])"), "\"label\" must be a whole number"},
      {withBody(R"("name": "b", "label": 1, "value": "5", "colour": [1, 1, 1])"), "\"value\" must be a number"},
      {withBody(R"("name": "b", "label": 1, "value": 5, "colour": [1, 1, 2])"), "from 0 to 1"},
      {withBody(good + R"(, "inset": {"of": "skin", "by": 1})"), "names no earlier body: \"skin\""},
      {withShape("7"), "a shape must be an object"},
      {withShape(R"({"type": "cone"})"), "unknown shape \"cone\""},
      {withShape(R"({"type": "box", "centre": [0, 0, 0], "semiAxes": [1, -1, 1]})"), "\"semiAxes\" must be positive"},
      {withShape(R"({"type": "box", "centre": [0, 0, 0], "semiAxes": [1, 1, 1], "radius": 2})"),
       "unknown key \"radius\""},
      {withShape(R"({"type": "box", "centre": [0, 0, 0], "semiAxes": [1, 1, 1], "mirror": 1})"), "\"mirror\" must be"},
      {withShape(R"({"type": "chain", "points": [[0, 0, 0]], "radius": 2})"), "at least two points"},
      {withShape(R"({"type": "chain", "points": [[0, 0, 0], [0, 0, 1]], "radius": 0})"), "\"radius\" must be positive"},
      {withShape(
           R"({"type": "arc", "centre": [0, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "from": 0, "to": 9, "steps": 1e9, "radius": 1})"),
       "\"steps\" must be a whole number"},
  };
  for (const auto& c : cases) {
    try {
      parsePhantom(c.text, "file.json");
      ADD_FAILURE() << "accepted: " << c.text;
    } catch (const Error& error) {
      EXPECT_EQ(error.file(), "file.json");
      EXPECT_NE(error.cause().find(c.cause), std::string::npos) << error.cause() << "\nexpected: " << c.cause;
      EXPECT_FALSE(error.hint().empty());
    }
  }
}

TEST(PhantomFile, unknownNamesListTheKnownOnes) {
  try {
    loadPhantom("foot");
    ADD_FAILURE() << "found a foot";
  } catch (const Error& error) {
    EXPECT_NE(error.hint().find("head"), std::string::npos);
    EXPECT_NE(error.hint().find("torso"), std::string::npos);
  }
}

TEST(PhantomFile, builtInPhantomsHaveWellNamedLabels) {
  const std::vector<std::string> names = phantomNames();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()), (std::set<std::string>{"head", "torso"}));
  for (const std::string& name : names) {
    const Phantom phantom = loadPhantom(name);
    std::set<std::string> bodies;
    for (const PhantomBody& body : phantom.bodies) EXPECT_TRUE(bodies.insert(body.name).second) << body.name;
    // Every label can be seen: none lies wholly under later bodies or outside the box.
    const Phantom::Rasterised raster = phantom.rasterise(128);
    std::set<std::uint16_t> present;
    raster.labels->voxels.visit([&](auto voxels) { present.insert(voxels.begin(), voxels.end()); });
    for (const Label& label : raster.labels->labels)
      EXPECT_TRUE(present.count(label.value)) << name << ": " << label.name;
  }
}

glm::dvec3 centreOf(const Phantom::Rasterised& raster, const std::string& name) {
  const Grid& grid = raster.volume->grid;
  glm::dvec3 sum(0.0);
  int count = 0;
  for (const Label& label : raster.labels->labels) {
    if (label.name != name) continue;
    glm::ivec3 i;
    for (i.z = 0; i.z < grid.dims.z; ++i.z)
      for (i.y = 0; i.y < grid.dims.y; ++i.y)
        for (i.x = 0; i.x < grid.dims.x; ++i.x)
          if (raster.labels->value(i) == label.value) {
            sum += glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(i), 1.0));
            ++count;
          }
  }
  EXPECT_GT(count, 0) << name;
  return sum / static_cast<double>(count);
}

TEST(PhantomFile, torsoIsAnatomicallyOriented) {
  const Phantom::Rasterised torso = loadPhantom("torso").rasterise(96);
  EXPECT_GT(centreOf(torso, "left ventricle").x, 20.0);
  EXPECT_LT(centreOf(torso, "liver").x, -30.0);
  EXPECT_GT(centreOf(torso, "spleen").x, 50.0);
  EXPECT_LT(centreOf(torso, "right kidney").x, -40.0);
  EXPECT_GT(centreOf(torso, "left kidney").z, centreOf(torso, "right kidney").z);
  EXPECT_GT(centreOf(torso, "spine").y, centreOf(torso, "sternum").y + 100.0);
  EXPECT_GT(centreOf(torso, "trachea").z, centreOf(torso, "pelvis").z + 300.0);
}

TEST(PhantomFile, torsoLesionLiesInTheLungBehindARib) {
  const Phantom torso = loadPhantom("torso");
  const auto labelOf = [&](const std::string& name) {
    for (const PhantomBody& body : torso.bodies)
      if (body.name == name) return body.label;
    ADD_FAILURE() << name;
    return std::uint16_t{0};
  };
  const auto lesion = std::find_if(torso.bodies.begin(), torso.bodies.end(),
                                   [](const PhantomBody& body) { return body.name == "lesion"; });
  ASSERT_NE(lesion, torso.bodies.end());
  const auto& ball = std::get<Ellipsoid>(lesion->shapes.at(0));
  EXPECT_EQ(ball.semiAxes, glm::dvec3(6.0));
  // Seen from the patient's right, a rib is met first; the lung surrounds the lesion.
  const glm::dvec3 eye = ball.centre - glm::dvec3(300.0, 0.0, 0.0), left(1.0, 0.0, 0.0);
  const auto rib = torso.firstHit(eye, left, {labelOf("ribs")}), hit = torso.firstHit(eye, left, {lesion->label});
  ASSERT_TRUE(rib && hit);
  EXPECT_LT(*rib, *hit);
  for (const glm::dvec3 side : {glm::dvec3(-7, 0, 0), glm::dvec3(7, 0, 0), glm::dvec3(0, 7, 0), glm::dvec3(0, 0, -7)})
    EXPECT_EQ(torso.label(ball.centre + side), labelOf("right lung"));
}

}  // namespace
}  // namespace fenestra::io::phantomFileTest
