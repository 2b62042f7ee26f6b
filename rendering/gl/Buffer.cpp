#include "rendering/gl/Buffer.h"

#include <utility>
#include <vector>

#include <epoxy/gl.h>

namespace fenestra::gl {

Buffer::Buffer(std::span<const std::byte> bytes) : bytes_(bytes.size()) {
  constexpr std::uint32_t word = 0;
  glCreateBuffers(1, &name_);
  if (bytes.size() >= sizeof word)
    glNamedBufferStorage(name_, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_DYNAMIC_STORAGE_BIT);
  else
    glNamedBufferStorage(name_, sizeof word, &word, 0);
}

Buffer Buffer::zeroed(std::size_t bytes) {
  const std::vector<std::byte> zeros(bytes);
  return Buffer(zeros);
}

void Buffer::read(std::span<std::byte> bytes) const {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(name_, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

Buffer::~Buffer() {
  if (name_) glDeleteBuffers(1, &name_);
}

Buffer::Buffer(Buffer&& other) noexcept
    : name_(std::exchange(other.name_, 0)), bytes_(std::exchange(other.bytes_, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

void Buffer::write(std::span<const std::byte> bytes) {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glNamedBufferSubData(name_, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void Buffer::bind(unsigned binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name_); }

}  // namespace fenestra::gl
