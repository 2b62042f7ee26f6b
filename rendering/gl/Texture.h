#pragma once
// Textures: move-only owners of immutable-storage OpenGL textures.

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

#include <glm/glm.hpp>

namespace fenestra::gl {

/// The graphics memory, or a limit of the driver, does not allow a texture of this size; what() names the size.
class AllocationError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Format : std::uint8_t { R8, R16, R32F, RG32F, RGB10A2, BGRA8, RGBA32F, R8UI, R16UI, R32UI, RGBA32UI };
/// Bytes of one texel, and what upload() and read() exchange per texel: the format's own components, tightly packed
/// (RGB10A2: red in the lowest bits of 32; BGRA8: bytes of blue, green, red, alpha, as Qt's images have them).
std::size_t bytesPerTexel(Format format);

/// OpenGL's name of it, for gl's own classes.
unsigned internalFormat(Format format);

enum class Filter : std::uint8_t { Nearest, Linear };  ///< clamped to the edge in either case

/// A size with sides that are no powers of two, the least that is as large as `size`. llvmpipe compiles a program anew
/// for textures of which another side is a power of two; those whose size nobody sees have one kind of sides this way.
glm::ivec2 withoutPowersOfTwo(glm::ivec2 size);

/// Access of a compute shader to an image unit.
enum class Access : std::uint8_t { Read, Write, ReadWrite };

class Texture {
 public:
  Texture() = default;  ///< owns nothing; binds as texture 0
  /// Throw AllocationError.
  static Texture make2D(Format format, glm::ivec2 size, Filter filter = Filter::Nearest);
  static Texture make3D(Format format, glm::ivec3 size, Filter filter = Filter::Nearest);
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;

  explicit operator bool() const { return name_ != 0; }
  glm::ivec3 size() const { return size_; }  ///< z is 1 for 2-D
  Format format() const { return format_; }
  std::size_t bytes() const;

  /// Replaces the texels from `offset` on, `extent` of them, x fastest. `texels` holds the format's components packed.
  void upload(glm::ivec3 offset, glm::ivec3 extent, std::span<const std::byte> texels);
  /// The whole texture, tightly packed.
  template <class T>
  void upload(std::span<const T> texels) {
    upload(glm::ivec3(0), size_, std::as_bytes(texels));
  }
  void read(std::span<std::byte> texels) const;
  template <class T>
  void readInto(std::span<T> texels) const {
    read(std::as_writable_bytes(texels));
  }
  /// Fills it with zeros.
  void clear();
  /// Fills so many texels of a 2-D one, from `offset` on, with zeros.
  void clear(glm::ivec2 offset, glm::ivec2 extent);
  /// Takes the texels of another one of the same size and format.
  void copy(const Texture& from);
  /// One texel, as floats (missing components 0).
  glm::vec4 readTexel(glm::ivec2 pixel) const;

  /// For gl's own classes.
  std::uint32_t name() const { return name_; }

 private:
  std::uint32_t name_ = 0;
  Format format_ = Format::R8;
  glm::ivec3 size_{0};
};

}  // namespace fenestra::gl
