#include "rendering/gl/Texture.h"

#include <bit>
#include <cassert>
#include <string>
#include <utility>

#include <epoxy/gl.h>

#include "rendering/gl/Context.h"

namespace fenestra::gl {
namespace {

struct Traits {
  GLenum internal, external, type;
  std::size_t bytes;
};

Traits traits(Format format) {
  switch (format) {
    case Format::R8:
      return {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1};
    case Format::R16:
      return {GL_R16, GL_RED, GL_UNSIGNED_SHORT, 2};
    case Format::R32F:
      return {GL_R32F, GL_RED, GL_FLOAT, 4};
    case Format::RG32F:
      return {GL_RG32F, GL_RG, GL_FLOAT, 8};
    case Format::RGB10A2:
      return {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 4};
    case Format::BGRA8:
      return {GL_RGBA8, GL_BGRA, GL_UNSIGNED_BYTE, 4};
    case Format::RGBA32F:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
    case Format::R8UI:
      return {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1};
    case Format::R16UI:
      return {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 2};
    case Format::R32UI:
      return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4};
    case Format::RGBA32UI:
      break;
  }
  return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16};
}

void setSampling(GLuint name, Filter filter) {
  const GLint mode = filter == Filter::Linear ? GL_LINEAR : GL_NEAREST;
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, mode);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, mode);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(name, axis, GL_CLAMP_TO_EDGE);
}

/// Makes the storage of a texture by `store`. Errors that earlier calls left behind do not count as its failure.
template <class Store>
void allocate(glm::ivec3 size, std::size_t texelBytes, const Store& store) {
  noteErrors();
  store();
  if (glGetError() == GL_NO_ERROR) return;
  throw AllocationError("no graphics memory for an image of " + std::to_string(size.x) + "×" + std::to_string(size.y) +
                        "×" + std::to_string(size.z) + " texels of " + std::to_string(texelBytes) +
                        " bytes; make the picture or the volume smaller");
}

/// Tight rows for as long as it lives, then the defaults that every caller may count on.
struct TightRows {
  TightRows() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
  }
  ~TightRows() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
  }
};

}  // namespace

unsigned internalFormat(Format format) { return traits(format).internal; }

glm::ivec2 withoutPowersOfTwo(glm::ivec2 size) {
  for (int* side : {&size.x, &size.y})
    while (std::has_single_bit(static_cast<unsigned>(*side))) ++*side;
  return size;
}

std::size_t bytesPerTexel(Format format) { return traits(format).bytes; }

Texture Texture::make2D(Format format, glm::ivec2 size, Filter filter) {
  Texture texture;
  texture.format_ = format;
  texture.size_ = glm::ivec3(size, 1);
  glCreateTextures(GL_TEXTURE_2D, 1, &texture.name_);
  allocate(texture.size_, traits(format).bytes,
           [&] { glTextureStorage2D(texture.name_, 1, traits(format).internal, size.x, size.y); });
  setSampling(texture.name_, filter);
  return texture;
}

Texture Texture::make3D(Format format, glm::ivec3 size, Filter filter) {
  Texture texture;
  texture.format_ = format;
  texture.size_ = size;
  glCreateTextures(GL_TEXTURE_3D, 1, &texture.name_);
  allocate(texture.size_, traits(format).bytes,
           [&] { glTextureStorage3D(texture.name_, 1, traits(format).internal, size.x, size.y, size.z); });
  setSampling(texture.name_, filter);
  return texture;
}

Texture::~Texture() {
  if (name_) glDeleteTextures(1, &name_);
}

Texture::Texture(Texture&& other) noexcept
    : name_(std::exchange(other.name_, 0)), format_(other.format_), size_(std::exchange(other.size_, glm::ivec3(0))) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(format_, other.format_);
  std::swap(size_, other.size_);
  return *this;
}

std::size_t Texture::bytes() const {
  return bytesPerTexel(format_) * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
         static_cast<std::size_t>(size_.z);
}

void Texture::upload(glm::ivec3 offset, glm::ivec3 extent, std::span<const std::byte> texels) {
  const Traits t = traits(format_);
  assert(texels.size() >= t.bytes * static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y) *
                              static_cast<std::size_t>(extent.z));
  const TightRows tight;
  GLint target = 0;
  glGetTextureParameteriv(name_, GL_TEXTURE_TARGET, &target);
  if (target == GL_TEXTURE_3D)
    glTextureSubImage3D(name_, 0, offset.x, offset.y, offset.z, extent.x, extent.y, extent.z, t.external, t.type,
                        texels.data());
  else
    glTextureSubImage2D(name_, 0, offset.x, offset.y, extent.x, extent.y, t.external, t.type, texels.data());
}

void Texture::read(std::span<std::byte> texels) const {
  const Traits t = traits(format_);
  const TightRows tight;
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glGetTextureImage(name_, 0, t.external, t.type, static_cast<GLsizei>(texels.size()), texels.data());
}

glm::vec4 Texture::readTexel(glm::ivec2 pixel) const {
  glm::vec4 texel(0.0f);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glGetTextureSubImage(name_, 0, pixel.x, pixel.y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, sizeof texel, &texel);
  return texel;
}

void Texture::clear() { glClearTexImage(name_, 0, traits(format_).external, traits(format_).type, nullptr); }

void Texture::clear(glm::ivec2 offset, glm::ivec2 extent) {
  const Traits t = traits(format_);
  glClearTexSubImage(name_, 0, offset.x, offset.y, 0, extent.x, extent.y, 1, t.external, t.type, nullptr);
}

void Texture::copy(const Texture& from) {
  GLint target = 0;
  glGetTextureParameteriv(name_, GL_TEXTURE_TARGET, &target);
  const auto kind = static_cast<GLenum>(target);
  glCopyImageSubData(from.name_, kind, 0, 0, 0, 0, name_, kind, 0, 0, 0, 0, size_.x, size_.y, size_.z);
}

}  // namespace fenestra::gl
