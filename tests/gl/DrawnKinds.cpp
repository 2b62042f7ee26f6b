#include "tests/gl/DrawnKinds.h"

#include <set>
#include <sstream>

#include <epoxy/gl.h>

#include "rendering/gpu/Uniforms.h"
#include "rendering/placement/Placer.h"
#include "tests/gl/SameLayers.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests {

const std::vector<std::string> blockNames{
    RayUniforms::name,       VolumeUniforms::name,       TransferUniforms::name,      FocusUniforms::name,
    LightUniforms::name,     IntegralUniforms::name,     OpeningCameraUniforms::name, DerivativeUniforms::name,
    CutawayUniforms::name,   ContextLayerUniforms::name, CandidateUniforms::name,     ClipUniforms::name,
    OccludersUniforms::name, OcclusionUniforms::name,    ConeUniforms::name,          WallUniforms::name};

namespace {

constexpr std::array bothSchedules{Schedule::Plain, Schedule::Llvmpipe};
using Picture = std::vector<std::uint8_t>;

void place(Scene scene, Schedule schedule) {
  GpuScene gpu;
  gpu.setSchedule(schedule);
  placement::Placer placer;
  placement::Options options;
  options.weights.endFace = 0.0;
  placer.measure(gpu, scene, {.count = 12}, options);
  options.weights.endFace = -1.0;
  placer.measure(gpu, scene, {.count = 12}, options);
}

/// What is wrong with a picture that is drawn a tile at a time; empty where it has the bits and the counts of
/// `inOneRun`.
std::string tileFault(const std::shared_ptr<GpuScene>& gpu, const SceneKind& kind, Renderer& inOneRun) {
  Renderer inTiles(gpu);
  inTiles.begin(kind.scene, kind.view);
  int slices = 1;
  for (; !inTiles.advance(0.0); ++slices)
    if (!inTiles.isDrawing()) return "it says that it is not drawing";
  if (inTiles.isDrawing()) return "it says that it is still drawing";
  if (slices <= 7) return "few tiles of some 50 groups of 8×8 pixels";
  for (std::size_t pass = 0; pass < passCount; ++pass) {
    const PassStats &tiled = inTiles.stats()[pass], &whole = inOneRun.stats()[pass];
    if (tiled.runs != whole.runs || tiled.pixels != whole.pixels)
      return "counts of " + std::string(nameOf(static_cast<Pass>(pass)));
  }
  return differingLayers(inTiles.readLayers(), inOneRun.readLayers());
}

/// How the pictures of two schedules differ; empty where they are alike.
std::string scheduleFault(const Picture& plain, const Picture& inStep) {
  if (plain.size() != inStep.size()) return "sizes";
  // Both run the same operations on the same numbers. A compiler may contract them differently, which moves a value
  // that lies on the edge between two of 256 steps to the other one.
  std::size_t differing = 0;
  int most = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const int difference = std::abs(int(plain[i]) - int(inStep[i]));
    differing += difference > 0;
    most = std::max(most, difference);
  }
  if (most <= 1 && differing <= plain.size() / 200) return {};
  return std::to_string(differing) + " values differ, by up to " + std::to_string(most) + " of 255";
}

/// Links programs and runs none, for its lifetime: epoxy calls OpenGL through function pointers.
class IdleDriver {
 public:
  IdleDriver()
      : direct_(std::exchange(epoxy_glDispatchCompute, [](GLuint, GLuint, GLuint) {})),
        indirect_(std::exchange(epoxy_glDispatchComputeIndirect, [](GLintptr) {})) {}
  ~IdleDriver() {
    epoxy_glDispatchCompute = direct_;
    epoxy_glDispatchComputeIndirect = indirect_;
  }
  IdleDriver(const IdleDriver&) = delete;
  IdleDriver& operator=(const IdleDriver&) = delete;

 private:
  PFNGLDISPATCHCOMPUTEPROC direct_;
  PFNGLDISPATCHCOMPUTEINDIRECTPROC indirect_;
};

/// Puts a compute shader that does nothing in the place of each, for its lifetime: what is told of a program then is
/// its source alone.
class SourcesAlone {
 public:
  SourcesAlone() { real = std::exchange(epoxy_glShaderSource, &replace); }
  ~SourcesAlone() { epoxy_glShaderSource = std::exchange(real, nullptr); }
  SourcesAlone(const SourcesAlone&) = delete;
  SourcesAlone& operator=(const SourcesAlone&) = delete;

  static bool areTold() { return real; }

 private:
  static void replace(GLuint shader, GLsizei, const GLchar* const*, const GLint*) {
    const GLchar* nothing = "#version 450 core\nlayout(local_size_x = 8, local_size_y = 8) in;\nvoid main() {}\n";
    real(shader, 1, &nothing, nullptr);
  }
  inline static PFNGLSHADERSOURCEPROC real = nullptr;
};

/// A kind's properties, which its name lists.
std::set<std::string> propertiesOf(const SceneKind& kind) {
  std::set<std::string> properties;
  std::istringstream name(kind.name);
  for (std::string property; std::getline(name >> std::ws, property, ',');) properties.insert(property);
  return properties;
}

/// Marks the kind that has most of the properties that no marked one has, until each property is there.
std::vector<bool> coveringProperties(const std::vector<SceneKind>& kinds) {
  std::vector<std::set<std::string>> left;  // properties that no chosen kind has
  for (const SceneKind& kind : kinds) left.push_back(propertiesOf(kind));
  std::vector<bool> chosen(kinds.size());
  while (true) {
    const auto best = std::ranges::max_element(left, {}, &std::set<std::string>::size);
    if (best->empty()) return chosen;
    chosen[static_cast<std::size_t>(best - left.begin())] = true;
    const std::set<std::string> covered = *best;
    for (std::set<std::string>& properties : left)
      std::erase_if(properties, [&](const std::string& property) { return covered.contains(property); });
  }
}

/// The pictures of the kinds that `isDrawn`, and their faults. Tells the sources of the programs of all kinds; links
/// those of the kinds drawn.
std::vector<Picture> draw(const std::vector<SceneKind>& kinds, const std::vector<bool>& isDrawn, Schedule schedule,
                          std::vector<std::string>& tileFaults) {
  std::vector<Picture> pictures;
  // One for all scenes: a program is linked once.
  const auto gpu = std::make_shared<GpuScene>();
  gpu->setSchedule(schedule);
  for (std::size_t at = 0; at < kinds.size(); ++at) {
    if (!isDrawn[at]) continue;
    Renderer renderer(gpu);
    renderer.render(kinds[at].scene, kinds[at].view);
    pictures.push_back(renderer.readPicture());
    if (const std::string fault = tileFault(gpu, kinds[at], renderer); !fault.empty())
      tileFaults.push_back(kinds[at].name + ", " + std::string(nameOf(schedule)) + ": " + fault);
  }
  // Last, because textures that the scenes share are left without content.
  const IdleDriver driver;
  const SourcesAlone sources;
  for (std::size_t at = 0; at < kinds.size(); ++at)
    if (!isDrawn[at]) Renderer(gpu).render(kinds[at].scene, kinds[at].view);
  return pictures;
}

}  // namespace

DrawnKinds drawKinds(Chosen chosen) {
  DrawnKinds all;
  gl::ShaderProgram::listen([&](const gl::ShaderProgram& program, std::string_view path, const std::string& source) {
    if (SourcesAlone::areTold() && all.programs.contains(source)) return;
    Linked& linked = all.programs[source];
    linked.path = path;
    linked.resources = program.resources();
    for (const std::string& block : blockNames) linked.blocks[block] = program.structLayout(block);
  });
  const std::vector<SceneKind> kinds = allSceneKinds();
  const std::vector<bool> isDrawn =
      chosen == Chosen::All ? std::vector<bool>(kinds.size(), true) : coveringProperties(kinds);
  std::array<std::vector<Picture>, bothSchedules.size()> pictures;
  for (std::size_t i = 0; i < bothSchedules.size(); ++i) {
    for (const Focus& focus : {Focus(LabelFocus{{1}}), Focus(ValueFocus{{95.0, 1000.0}, 0.0})}) {
      Scene scene = bodyWithOrgans<std::int16_t>(gridOf({26, 24, 22}));
      scene.look.focus = focus;
      place(scene, bothSchedules[i]);
    }
    pictures[i] = draw(kinds, isDrawn, bothSchedules[i], all.tileFaults);
  }
  for (const SceneKind& kind : kinds) {
    if (!isDrawn[all.kinds++]) continue;
    if (const std::string fault = scheduleFault(pictures[0][all.drawn], pictures[1][all.drawn]); !fault.empty())
      all.scheduleFaults.push_back(kind.name + ": " + fault);
    ++all.drawn;
  }
  gl::ShaderProgram::listen({});
  return all;
}

}  // namespace fenestra::tests
