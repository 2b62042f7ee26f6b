#include "tests/checker/LayerFiles.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <span>
#include <sstream>

#include <sys/wait.h>

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

template <class T>
void writeMeta(const fs::path& path, const std::string& header, const char* type, std::span<const T> scalars) {
  std::ofstream file(path, std::ios::binary);
  file << "ObjectType = Image\n"
       << header << "BinaryData = True\nBinaryDataByteOrderMSB = False\nElementType = " << type
       << "\nElementDataFile = LOCAL\n";
  file.write(reinterpret_cast<const char*>(scalars.data()), static_cast<std::streamsize>(scalars.size_bytes()));
}

std::string headerOf(const Grid& grid) {
  std::ostringstream text;
  text << std::setprecision(17) << "NDims = 3\nDimSize = " << grid.dims.x << " " << grid.dims.y << " " << grid.dims.z
       << "\nElementSpacing = " << grid.spacing.x << " " << grid.spacing.y << " " << grid.spacing.z
       << "\nOffset = " << grid.origin.x << " " << grid.origin.y << " " << grid.origin.z << "\nTransformMatrix =";
  for (int axis = 0; axis < 3; ++axis)
    for (int component = 0; component < 3; ++component) text << " " << grid.direction[axis][component];
  text << "\n";
  return text.str();
}

}  // namespace

void writeScene(const Scene& scene, const fs::path& folder) {
  const Volume& volume = *scene.volume;
  std::vector<float> values;
  volume.voxels.visit([&](auto scalars) {
    for (const auto scalar : scalars)
      values.push_back(static_cast<float>(volume.slope * static_cast<double>(scalar) + volume.intercept));
  });
  writeMeta<float>(folder / "IMAGE.mha", headerOf(volume.grid), "MET_FLOAT", values);
  writeMeta(folder / "LABELS.mha", headerOf(scene.labels->grid), "MET_USHORT",
            scene.labels->voxels.as<std::uint16_t>());
}

void writeLayers(const reference::Stages& stages, const Camera& camera, glm::ivec2 size, const Grid& grid,
                 const fs::path& folder) {
  const std::string header = "NDims = 2\nDimSize = " + std::to_string(size.x) + " " + std::to_string(size.y) + "\n";
  const auto write = [&](const char* name, const reference::Image& image) {
    const std::vector<float> pixels(image.begin(), image.end());
    writeMeta<float>(folder / (std::string(name) + ".mha"), header, "MET_FLOAT", pixels);
  };
  write("t_context", stages.hits.tContext);
  write("t_focus", stages.hits.tFocus);
  write("t_focus_filled", stages.tFocusFilled);
  write("t_start", stages.tStart);
  write("distance", stages.distance);

  const glm::dmat4 clip = camera.clipFromWorld(static_cast<double>(size.x) / size.y, grid);
  std::ofstream json(folder / "camera.json");
  json << std::setprecision(17) << "{\"size\": [" << size.x << ", " << size.y << "], \"projection\": \""
       << (camera.projection == Projection::Perspective ? "perspective" : "orthographic") << "\", \"eye_world\": ["
       << camera.eye.x << ", " << camera.eye.y << ", " << camera.eye.z << "], \"clipFromWorld\": [";
  for (int row = 0; row < 4; ++row) {
    json << (row > 0 ? ", [" : "[");
    for (int column = 0; column < 4; ++column) json << (column > 0 ? ", " : "") << clip[column][row];
    json << "]";
  }
  json << "]}\n";
}

Outcome runCommand(const std::string& command) {
  Outcome outcome;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return outcome;
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    outcome.output.append(buffer.data(), count);
  const int status = pclose(pipe);
  outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

std::string quoted(const fs::path& path) {
  std::ostringstream text;
  text << '\'' << path.string() << '\'';
  return text.str();
}

}  // namespace fenestra::tests
