#include "tests/bench/TruthStore.h"

#include <fstream>
#include <span>
#include <sstream>
#include <system_error>

#include "io/base/AtomicFile.h"
#include "io/base/Error.h"
#include "rendering/settings/Settings.h"

namespace fenestra::bench {
namespace {

namespace fs = std::filesystem;

/// FNV-1a, 64 bits.
class Digest {
 public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) hash_ = (hash_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
  }
  /// Plain numbers and vectors of them, without padding.
  template <class... T>
  void add(const T&... values) {
    (add(std::as_bytes(std::span(&values, 1))), ...);
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

void addGrid(Digest& digest, const Grid& grid) { digest.add(grid.dims, grid.spacing, grid.origin, grid.direction); }

void addGeometry(Digest& digest, const Scene& scene, const Camera& camera, glm::ivec2 size) {
  digest.add(std::as_bytes(std::span(std::string_view(FENESTRA_REFERENCE_SOURCES))));
  const Volume& volume = *scene.volume;
  addGrid(digest, volume.grid);
  digest.add(volume.voxels.type(), volume.slope, volume.intercept);
  digest.add(std::span(volume.voxels.data(), volume.voxels.byteCount()));
  for (const TransferFunction::Node& node : scene.look.context.shifted().nodes)
    digest.add(node.value, node.properties.colour, node.properties.extinction);
  if (const auto* focus = std::get_if<LabelFocus>(&scene.look.focus); focus && scene.labels) {
    digest.add(std::as_bytes(std::span(focus->labels)));
    digest.add(std::span(scene.labels->voxels.data(), scene.labels->voxels.byteCount()));
    for (const Label& label : scene.labels->labels) digest.add(label.value, label.colour);
    if (scene.look.labelSmoothing != LabelSmoothing::Off) digest.add(scene.look.labelSmoothing);
  }
  if (const auto* focus = std::get_if<ValueFocus>(&scene.look.focus))
    digest.add(focus->values.low, focus->values.high, focus->minimumComponent);
  digest.add(camera.projection, camera.eye, camera.target, camera.up, camera.verticalFov, camera.orthographicHeight);
  digest.add(size);
}

void addAppearance(Digest& digest, const Scene& scene) {
  const auto add = [&]<class Part>(const Part& part) {
    forEachSetting<Part>([&](const auto& setting) { digest.add(part.*setting.member); });
  };
  add(scene.look.focusAppearance);
  add(scene.look.method);
  forEachMethod([&]<class M>() { add(scene.look.method.of<M>()); });
  add(scene.look.cutaway);
  add(scene.look.contextLayer);
  add(scene.look.shading);
}

/// `count` doubles of the file, or nothing when it is not there or of another length.
std::vector<double> read(const fs::path& path, std::size_t count) {
  std::error_code error;
  if (fs::file_size(path, error) != count * sizeof(double) || error) return {};
  std::vector<double> values(count);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(double)));
  return file ? values : std::vector<double>();
}

void write(const fs::path& path, std::span<const double> values) {
  io::writeAtomically(path, [&](const fs::path& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
    if (!file.flush()) throw io::Error(path, "cannot be written", "is the disk full?");
  });
}

fs::path fileOf(const fs::path& folder, const char* what, const Digest& digest) {
  std::ostringstream name;
  name << what << '-' << std::hex << digest.value() << ".f64";
  return folder / name.str();
}

}  // namespace

TruthStore::TruthStore(fs::path folder) : folder_(std::move(folder)) { fs::create_directories(folder_); }

reference::HitPoints TruthStore::hits(const Scene& scene, const Camera& camera, glm::ivec2 size) const {
  Digest digest;
  addGeometry(digest, scene, camera, size);
  const fs::path path = fileOf(folder_, "hits", digest);
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  std::vector<double> values = read(path, 3 * count);
  if (values.empty()) {
    const reference::HitPoints made = reference::hitPoints(scene, camera, size);
    for (const reference::Image* image : {&made.tContext, &made.tFocus, &made.tOut})
      values.insert(values.end(), image->begin(), image->end());
    write(path, values);
  }
  const auto part = [&](std::size_t i) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * count);
    return reference::Image(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  return {part(0), part(1), part(2)};
}

reference::Stages TruthStore::stages(const Scene& scene, const Camera& camera, glm::ivec2 size) const {
  reference::Stages stages;
  stages.hits = hits(scene, camera, size);
  const reference::Widths widths = reference::widthsInPixels(scene, camera, size, 1.0);
  stages.tFocusFilled = reference::fill(stages.hits.tFocus, size);
  stages.distance = reference::distanceMap(stages.hits.tFocus, size, widths.open + widths.border);
  stages.tStart = reference::rayStart(stages.hits, stages.tFocusFilled, stages.distance, widths.open);
  return stages;
}

std::vector<glm::dvec4> TruthStore::colours(const Scene& scene, const Camera& camera, glm::ivec2 size,
                                            const std::vector<glm::ivec2>& pixels) const {
  Digest digest;
  addGeometry(digest, scene, camera, size);
  addAppearance(digest, scene);
  digest.add(std::as_bytes(std::span(pixels)));
  const fs::path path = fileOf(folder_, "colours", digest);
  std::vector<glm::dvec4> colours(pixels.size());
  if (const std::vector<double> values = read(path, 4 * pixels.size()); !values.empty()) {
    for (std::size_t i = 0; i < pixels.size(); ++i)
      colours[i] = {values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]};
    return colours;
  }
  reference::PictureOptions options;
  options.pixels = pixels;
  const reference::Stages opening = hasCutaway(scene) ? stages(scene, camera, size) : reference::Stages();
  colours = reference::picture(scene, camera, size, opening, options).final;
  if (!colours.empty()) write(path, {&colours[0].x, 4 * colours.size()});
  return colours;
}

}  // namespace fenestra::bench
