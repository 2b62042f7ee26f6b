// VolPack (shear-warp factorisation, Lacroute and Levoy 1994), which renders run-length encoded volumes on one core, in
// parallel projection: plain volume rendering, unlit.

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <vector>

#include <volpack.h>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "io/study/ReadStudy.h"
#include "rendering/settings/TransferFunction.h"
#include "tests/peers/PeerRuns.h"

namespace fenestra::peers {
namespace {

using Json = nlohmann::ordered_json;

/// Parts that are left out of a picture.
struct Setting {
  const char* name;
  double leastVoxelOpacity;   ///< voxels at most as opaque are skipped
  double greatestRayOpacity;  ///< rays end there
};
constexpr std::array settings{Setting{"its defaults", 0.05, 0.95}, Setting{"all voxels", 0.0, 254.0 / 255.0}};

/// Values are looked up as one of these many levels over the volume's range.
constexpr int levelCount = 4096;

/// VolPack's voxel. It takes its colour from the level; all are of one material.
struct Voxel {
  std::uint16_t level;
  std::uint8_t material, unused;
};

/// One subject. Throws std::runtime_error with VolPack's own words.
class Stage {
 public:
  Stage(const Scene& scene, glm::ivec2 size) : scene_(scene), size_(size), context_(vpCreateContext()) {
    const Volume& volume = *scene.volume;
    const glm::ivec3 dims = volume.grid.dims;
    voxels_.resize(volume.grid.voxelCount());
    const double perValue = (levelCount - 1) / std::max(volume.range.high - volume.range.low, 1e-300);
    volume.voxels.visit([&]<class T>(std::span<const T> stored) {
      for (std::size_t i = 0; i < stored.size(); ++i) {
        const double value = volume.slope * static_cast<double>(stored[i]) + volume.intercept;
        voxels_[i] = {static_cast<std::uint16_t>(std::lround((value - volume.range.low) * perValue)), 0, 0};
      }
    });
    fillColours();
    check(vpSetVolumeSize(context_, dims.x, dims.y, dims.z));
    check(vpSetVoxelSize(context_, sizeof(Voxel), 2, 2, 1));
    check(vpSetVoxelField(context_, 0, sizeof(Voxel::level), offsetof(Voxel, level), levelCount - 1));
    check(vpSetVoxelField(context_, 1, sizeof(Voxel::material), offsetof(Voxel, material), 0));
    const int row = dims.x * static_cast<int>(sizeof(Voxel));
    check(vpSetRawVoxels(context_, voxels_.data(), static_cast<int>(voxels_.size() * sizeof(Voxel)), sizeof(Voxel), row,
                         row * dims.y));
    check(vpSetLookupShader(context_, 3, 1, 0, colours_.data(), bytesOf(colours_), 1, weights_.data(),
                            bytesOf(weights_)));
    picture_.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    check(vpSetImage(context_, picture_.data(), size.x, size.y, 4 * size.x, VP_RGBA));
  }
  ~Stage() { vpDestroyContext(context_); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Encodes the volume for pictures by `camera`.
  void prepare(const Camera& camera, const Setting& setting) {
    check(vpSetd(context_, VP_MIN_VOXEL_OPACITY, setting.leastVoxelOpacity));
    check(vpSetd(context_, VP_MAX_RAY_OPACITY, setting.greatestRayOpacity));
    const double way = betweenSlices(camera);
    const TransferFunction context = scene_.look.context.shifted();
    opacities_.resize(levelCount);
    for (int level = 0; level < levelCount; ++level)
      opacities_[static_cast<std::size_t>(level)] =
          static_cast<float>(1.0 - std::exp(-context.evaluate(valueOf(level)).extinction * way));
    check(vpSetClassifierTable(context_, 0, 0, opacities_.data(), bytesOf(opacities_)));
    check(vpClassifyVolume(context_));
  }

  /// Milliseconds until the picture is in memory.
  double draw(const Camera& camera) {
    const auto start = std::chrono::steady_clock::now();
    place(camera);
    check(vpRenderClassifiedVolume(context_));
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }

  /// RGBA of pixels of the last picture, (i, j) from the top.
  std::vector<float> read(const std::vector<glm::ivec2>& pixels) const {
    std::vector<float> colours;
    for (const glm::ivec2 pixel : pixels)
      for (std::size_t c = 0; c < 4; ++c) {
        // Rows from the bottom.
        const std::size_t at = static_cast<std::size_t>(size_.y - 1 - pixel.y) * static_cast<std::size_t>(size_.x) +
                               static_cast<std::size_t>(pixel.x);
        colours.push_back(static_cast<float>(picture_[4 * at + c]) / 255.0f);
      }
    return colours;
  }

 private:
  void check(vpResult result) const {
    if (result != VP_OK) throw std::runtime_error(std::string("VolPack: ") + vpGetErrorString(result));
  }

  template <class T>
  static int bytesOf(const std::vector<T>& table) {
    return static_cast<int>(table.size() * sizeof(T));
  }

  double valueOf(int level) const {
    const ValueRange range = scene_.volume->range;
    return std::lerp(range.low, range.high, level / (levelCount - 1.0));
  }

  void fillColours() {
    const TransferFunction context = scene_.look.context.shifted();
    for (int level = 0; level < levelCount; ++level) {
      const glm::dvec3 colour = 255.0 * context.evaluate(valueOf(level)).colour;
      for (int c = 0; c < 3; ++c) colours_.push_back(static_cast<float>(colour[c]));
    }
  }

  /// mm along a ray from one slice that VolPack composes to the next: these slices lie across the axis along which a
  /// ray passes most voxels.
  double betweenSlices(const Camera& camera) const {
    const Grid& grid = scene_.volume->grid;
    const glm::dvec3 perMm = glm::abs(glm::transpose(grid.direction) * camera.axes().forward) / grid.spacing;
    return 1.0 / std::max({perMm.x, perMm.y, perMm.z});
  }

  void place(const Camera& camera) {
    const Grid& grid = scene_.volume->grid;
    // VolPack's volume lies around the origin, its longest side is 1.
    const double longest = std::max({grid.dims.x, grid.dims.y, grid.dims.z});
    glm::dmat4 world(0.0);
    for (int k = 0; k < 3; ++k) world[k] = glm::dvec4(grid.direction[k] * grid.spacing[k] * longest, 0.0);
    world[3] = glm::dvec4(grid.centre(), 1.0);
    // VolPack's first slices are those of least z, where the camera looks along -z.
    const glm::dmat4 eye = glm::scale(glm::dmat4(1.0), {1.0, 1.0, -1.0}) * camera.viewFromWorld() * world;
    vpMatrix4 matrix;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) matrix[row][column] = eye[column][row];
    check(vpCurrentMatrix(context_, VP_VIEW));
    check(vpSetMatrix(context_, matrix));
    const double up = 0.5 * camera.orthographicHeight, right = up * size_.x / size_.y;
    const double reach = glm::distance(camera.eye, grid.centre()) + grid.boundingRadius();
    check(vpCurrentMatrix(context_, VP_PROJECT));
    check(vpIdentityMatrix(context_));
    check(vpWindow(context_, VP_PARALLEL, -right, right, -up, up, -reach, reach));
  }

  const Scene& scene_;
  glm::ivec2 size_;
  vpContext* context_;
  std::vector<Voxel> voxels_;
  std::vector<float> colours_, opacities_, weights_{1.0f};
  std::vector<unsigned char> picture_;
};

void measure(const Options& options) {
  if (!options.views.parallel) throw std::runtime_error("VolPack draws in parallel projection: add --parallel");
  const std::vector<glm::ivec2> pixels = bench::sampledPixels(options.views.size, options.views.pixelBlock);
  Json runs = Json::array();
  for (const bench::Subject& subject : bench::reportSubjects(options.views).here) {
    const Scene scene = bench::plainScene(io::readStudy(subject.options).drawn.scene());
    const std::vector<Camera> cameras = bench::cameraPath(scene, options.views.cameras, options.views.projection());
    Stage stage(scene, options.views.size);
    for (std::size_t s = 0; s < settings.size(); ++s) {
      Json run{{"subject", subject.id}, {"lit", false}, {"samplesPerVoxel", 1.0}, {"setting", settings[s].name}};
      for (std::size_t i = 0; i < cameras.size(); ++i) {
        stage.prepare(cameras[i], settings[s]);
        stage.draw(cameras[i]);  // fills its tables
        for (int round = 0; round < bench::pathRounds; ++round) run["frames_ms"].push_back(stage.draw(cameras[i]));
        if (i >= static_cast<std::size_t>(options.views.compared)) continue;
        const std::string file = "volpack-" + subject.id + "-" + std::to_string(i) + "-" + std::to_string(s) + ".mha";
        writePicture(options, file, stage.read(pixels));
        run["pictures"].push_back(file);
      }
      std::cerr << "volpack " << run.dump() << '\n';
      runs.push_back(std::move(run));
    }
  }
  writeRuns(options, {"volpack", "VolPack", VP_VERSION, "one core"}, runs);
}

}  // namespace
}  // namespace fenestra::peers

int main(int argc, char** argv) {
  return fenestra::peers::runProgram(argc, argv, "Draws the report's subjects with VolPack and times it.",
                                     fenestra::peers::measure);
}
