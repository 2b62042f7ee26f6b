#pragma once
// Programs from the embedded shader sources.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/gl/Buffer.h"
#include "rendering/gl/ShaderSource.h"
#include "rendering/gl/Texture.h"

namespace fenestra::gl {

/// Part of a picture in pixels from its top left.
struct Region {
  glm::ivec2 origin{0}, size{0};
  bool operator==(const Region&) const = default;
};

/// What a linked program takes up of the limits that OpenGL sets.
struct ProgramResources {
  int images = 0, samplers = 0, storageBlocks = 0, uniformBlocks = 0;
  glm::ivec3 groupSize{0};  ///< invocations of a compute program's work group; 0 for graphics
};

/// Sets uniforms, blocks and textures by the names that they have in the source. A name that stands nowhere in the
/// source, or has another type, is a programmer's error and asserted; one that a variant does not use is ignored.
class ShaderProgram {
 public:
  ShaderProgram() = default;
  /// `path` below rendering/shaders, e.g. "HitPoints.comp". `#include "lib/Ray.glsl"` is resolved against the same
  /// root, `#include <name>` by the variant's choices; each file is included once. Throws ShaderError.
  static ShaderProgram compute(std::string_view path, const Variant& variant = {});
  static ShaderProgram graphics(std::string_view vertexPath, std::string_view fragmentPath);
  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;

  explicit operator bool() const { return name_ != 0; }

  void set(std::string_view uniform, int value);
  void set(std::string_view uniform, float value);
  void set(std::string_view uniform, glm::ivec2 value);
  void set(std::string_view uniform, glm::ivec3 value);
  void set(std::string_view uniform, glm::vec2 value);
  void set(std::string_view uniform, glm::vec3 value);
  /// A struct of the uniform block, with its std140 layout, and the name that it has there as `Struct::name`.
  template <class Struct>
  void set(const Struct& uniforms) {
    setStruct(Struct::name, std::as_bytes(std::span(&uniforms, 1)));
  }
  /// A texture, at a unit of the program's own, as the source declares it: as a sampler, or as an image with `access`.
  /// It must live until the program has run.
  void bind(std::string_view uniform, const Texture& texture, Access access = Access::Read);

  /// Runs a compute program over at least size.x × size.y invocations in groups of groupSize, then makes its writes
  /// visible to everything after.
  void dispatch(glm::ivec2 size, glm::ivec2 groupSize);
  /// Runs over each region of a picture in groups of 8×8; the shader takes its pixels from lib/Region.glsl.
  void dispatch(std::span<const Region> regions);
  /// Runs as many groups as a shader has written into the buffer's first three words.
  void dispatchIndirect(const Buffer& groups);
  /// Draws one triangle that covers the viewport.
  void drawFullScreen();

  ProgramResources resources() const;
  /// Offset in bytes of each member of a struct of the uniform block, from the struct's start; empty when the program
  /// has no block.
  std::vector<std::pair<std::string, int>> structLayout(std::string_view name) const;

  /// How many programs have run for the first time so far on this thread. Drivers compile when a program first runs, so
  /// a time that was taken while the number grew is no measure of the next run.
  static std::size_t firstRuns();

  /// Called for each program linked from now on, with its path and the complete source of its last stage; for tests. An
  /// empty listener ends the calls.
  using Listener = std::function<void(const ShaderProgram&, std::string_view path, const std::string& source)>;
  static void listen(Listener listener);

 private:
  struct Uniform {
    int location = -1;
    unsigned type = 0;  ///< OpenGL's name
  };
  struct TextureUnit {
    std::string name;
    bool isImage = false;  ///< images and samplers are numbered each from 0
    unsigned unit = 0;
    std::uint32_t texture = 0;
    Format format{};
    Access access = Access::Read;
  };
  struct Block {
    std::map<std::string, std::size_t, std::less<>> offsets;  ///< of its structs, in bytes
    std::vector<std::byte> bytes;
    Buffer buffer;
    bool isUploaded = false;  ///< `buffer` holds `bytes`
  };

  void inspect();
  /// Null: the variant does not use it.
  const Uniform* find(std::string_view uniform, std::initializer_list<unsigned> types) const;
  void setStruct(std::string_view name, std::span<const std::byte> bytes);
  void bindBlock();
  void use();
  void assertDeclared(std::string_view name) const;

  std::uint32_t name_ = 0;
  bool isCompute_ = false, hasRun_ = false;
  std::map<std::string, Uniform, std::less<>> uniforms_;  ///< active, outside of blocks; no textures
  std::vector<TextureUnit> textures_;
  Block block_;
  Names names_;  ///< in the sources of all stages, to be asserted; empty without assertions
};

/// Compute programs by path and variant, for all whose contexts share objects: each is compiled once. Whoever runs a
/// program sets all its uniforms and textures first.
using ComputePrograms = std::unordered_map<std::string, ShaderProgram>;
using SharedPrograms = std::shared_ptr<ComputePrograms>;

/// A compute program's variants, each compiled when first asked for.
class ShaderVariants {
 public:
  explicit ShaderVariants(std::string path, SharedPrograms programs = std::make_shared<ComputePrograms>())
      : path_(std::move(path)), programs_(std::move(programs)) {}
  ShaderProgram& get(const Variant& variant = {});

 private:
  std::string path_;
  SharedPrograms programs_;
};

}  // namespace fenestra::gl
