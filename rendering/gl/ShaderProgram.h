#pragma once
// Programs from the embedded shader sources, with #include and compile-time switches.

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/gl/Buffer.h"

namespace fenestra::gl {

/// A shader that does not compile or link: a programmer's error or a driver's; what() is the log with file names.
class ShaderError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "#define NAME VALUE" lines put before the source.
struct Define {
  std::string name;
  int value = 1;
};

/// Part of a picture in pixels from its top left.
struct Region {
  glm::ivec2 origin{0}, size{0};
  bool operator==(const Region&) const = default;
};

class ShaderProgram {
 public:
  ShaderProgram() = default;
  /// `path` below rendering/shaders, e.g. "HitPoints.comp". `#include "lib/Ray.glsl"` is resolved against the same
  /// root, each file once. Throws ShaderError.
  static ShaderProgram compute(std::string_view path, const std::vector<Define>& defines = {});
  static ShaderProgram graphics(std::string_view vertexPath, std::string_view fragmentPath);
  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;

  explicit operator bool() const { return name_ != 0; }

  /// Sets a uniform; one that the compiler optimised away is ignored.
  void set(const char* uniform, int value);
  void set(const char* uniform, float value);
  void set(const char* uniform, glm::ivec2 value);
  void set(const char* uniform, glm::ivec3 value);
  void set(const char* uniform, glm::vec2 value);
  void set(const char* uniform, glm::vec3 value);
  void set(const char* uniform, glm::vec4 value);
  void set(const char* uniform, const glm::mat3& value);

  /// Runs a compute program over at least size.x × size.y invocations in groups of groupSize, then makes its writes
  /// visible to everything after.
  void dispatch(glm::ivec2 size, glm::ivec2 groupSize = {8, 8}) const;
  /// The same over each region of a picture in groups of 8×8; the shader takes its pixels from lib/Region.glsl.
  void dispatch(std::span<const Region> regions);
  /// As many groups as a shader has written into the buffer's first three words.
  void dispatchIndirect(const Buffer& groups) const;
  /// Draws one triangle that covers the viewport.
  void drawFullScreen() const;

 private:
  int location(const char* uniform);

  std::uint32_t name_ = 0;
  std::unordered_map<std::string, int> locations_;
};

/// A compute program's variants by their switches, each compiled when first asked for.
class ShaderVariants {
 public:
  explicit ShaderVariants(std::string path) : path_(std::move(path)) {}
  ShaderProgram& get(const std::vector<Define>& defines = {});

 private:
  std::string path_;
  std::unordered_map<std::string, ShaderProgram> programs_;
};

}  // namespace fenestra::gl
