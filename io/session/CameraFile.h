#pragma once
// A camera as a JSON file: what `render --layers` writes beside the layers, and what `--camera FILE.json` opens.
//
// size [W, H] in pixels, projection "perspective" | "orthographic", eye_world, target, up (mm, LPS), vertical_fov
// (degrees), orthographic_height (mm), and clipFromWorld, the 4×4 matrix to OpenGL's clip space, by rows. The matrix
// follows from the rest and the volume's place; it is written for others and not read. Numbers are written with as many
// digits as bring back the same double.

#include <filesystem>

#include "io/base/Error.h"
#include "rendering/settings/Camera.h"

namespace fenestra::io {

struct CameraFile {
  Camera camera;
  glm::ivec2 size{0};
};

/// Throws Error.
CameraFile readCamera(const std::filesystem::path& path);
/// `grid` is the volume's: near and far enclose it. Throws Error.
void writeCamera(const std::filesystem::path& path, const CameraFile& file, const Grid& grid);

}  // namespace fenestra::io
