// Pictures with a bound on the error, of scenes that nobody chose: volumes of few values, so that regions are even,
// under functions whose nodes and steps lie at those values, with a focus that ends at them. Scenes made by hand put
// their nodes elsewhere, and so missed what rounding did there.

#include <algorithm>
#include <random>

#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests::randomScenesTest {
namespace {

constexpr glm::ivec2 size{64, 48};
constexpr double bound = 0.5;  // 1/255

using RandomScenes = GlTest;

/// Numbers that are the same on every system, as the distributions of the standard library are not.
class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}

  double share() { return static_cast<double>(random_()) / 4294967296.0; }
  bool oneIn(int n) { return below(n) == 0; }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  glm::dvec3 colour() { return {share(), share(), share()}; }

 private:
  std::mt19937 random_;
};

/// Waves, or values without order, in whole steps.
template <class T>
std::shared_ptr<Volume> steppedVolume(Chance& chance, const Grid& grid, double step, int values, double least = 0.0) {
  const bool ordered = !chance.oneIn(3);
  const glm::dvec3 pace(0.1 + 0.5 * chance.share(), 0.1 + 0.5 * chance.share(), 0.1 + 0.5 * chance.share());
  return volumeOf<T>(grid, [&](glm::ivec3 i) {
    const double wave = 0.25 * (2.0 + std::sin(pace.x * i.x) + std::cos(pace.y * i.y + pace.z * i.z));
    const double place = ordered ? wave : chance.share();
    return least + step * std::min(std::floor(values * place), values - 1.0);
  });
}

struct Made {
  Scene scene;
  Camera camera;
};

/// A scene whose volume has the least value `least`; its voxels are of float32 where that is not 0.
Made madeBy(unsigned seed, double least) {
  Chance chance(seed);
  const auto side = [&] { return 5 + chance.below(16); };
  const glm::ivec3 dims(side(), side(), side());
  const Grid grid = gridOf(dims, {0.7 + chance.below(3), 1.0, 1.0 + chance.below(2)});
  const int values = 2 + chance.below(4);
  const double step = chance.oneIn(2) ? 1.0 : 61.0;
  const auto valueAt = [=](int i) { return least + step * i; };

  Made made;
  Scene& scene = made.scene;
  scene.volume = least != 0.0      ? steppedVolume<float>(chance, grid, step, values, least)
                 : chance.oneIn(2) ? steppedVolume<std::uint8_t>(chance, grid, step, values)
                                   : steppedVolume<std::int16_t>(chance, grid, step, values);
  std::vector<TransferFunction::Node>& nodes = scene.look.context.function.nodes;
  for (int i = 1 + chance.below(4); i >= 0; --i) {
    const double value = chance.oneIn(3) ? least + step * (values - 1) * chance.share() : valueAt(chance.below(values));
    const double extinction = chance.oneIn(2) ? 0.0 : chance.oneIn(2) ? 0.3 * chance.share() : 2.0 * chance.share();
    nodes.push_back({value, {chance.colour(), extinction}});
    if (chance.oneIn(2)) nodes.push_back({value, {chance.colour(), chance.share()}});
  }
  std::ranges::stable_sort(nodes, {}, &TransferFunction::Node::value);
  scene.look.reconstruction = Reconstruction::Linear;
  scene.look.shading.enabled = chance.oneIn(2);
  scene.look.cutaway.enabled = !chance.oneIn(3);
  scene.look.cutaway.openWidth = 6.0;
  const int low = chance.below(values), high = low + chance.below(values - low);
  if (!chance.oneIn(4)) scene.look.focus = ValueFocus{{valueAt(low), valueAt(high)}, 0.0};
  if (chance.oneIn(3)) scene.look.focusAppearance.function = scene.look.context.function;
  made.camera = Camera::fromAngles(chance.oneIn(3) ? 0.0 : 360.0 * chance.share(), 60.0 * chance.share() - 30.0, grid,
                                   Projection::Perspective);
  return made;
}

/// A pixel in two hundred may be beyond the bound: rays that graze a surface, whose hit rounding decides, or that run
/// along an edge of a region, near whose value they stay for the length of a voxel.
void expectBound(unsigned seed, double least = 0.0) {
  const Made made = madeBy(seed, least);
  View view{made.camera, size, 1.0, Quality::High};
  view.maxError = bound;
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(made.scene, view);
  const std::vector<glm::vec4> drawn = renderer.readLayers().final;
  const std::vector<glm::dvec4> truth = reference::picture(made.scene, view).final;
  ASSERT_EQ(drawn.size(), truth.size());
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const glm::dvec4 error = 255.0 * glm::abs(glm::dvec4(drawn[i]) - truth[i]);
    beyond += std::max({error.r, error.g, error.b, error.a}) > bound;
  }
  EXPECT_LE(beyond, drawn.size() / 200) << "seed " << seed;
}

TEST_F(RandomScenes, KeepTheirBound) {
  for (unsigned seed = 1; seed <= 12; ++seed) expectBound(seed);
}

TEST_F(RandomScenes, FarFromZeroKeepTheirBound) {
  for (const double least : {30000.0, -30000.0, 1e6}) expectBound(305, least);
}

TEST_F(RandomScenes, Exhaustive_AreManyAndKeepTheirBound) {
  for (unsigned seed = 13; seed <= 300; ++seed) expectBound(seed);
}

}  // namespace
}  // namespace fenestra::tests::randomScenesTest
