#pragma once
// Storage and uniform buffers: move-only, made from data or cleared for shaders to fill.

#include <cstddef>
#include <cstdint>
#include <span>

namespace fenestra::gl {

class Buffer {
 public:
  Buffer() = default;
  /// A buffer that holds `bytes`, at least one 4-byte word long so that it can always be bound.
  explicit Buffer(std::span<const std::byte> bytes);
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;

  explicit operator bool() const { return name_ != 0; }
  std::size_t bytes() const { return bytes_; }
  /// A cleared buffer for shaders to write.
  static Buffer zeroed(std::size_t bytes);
  /// Copies the first bytes back; waits for what is written.
  void read(std::span<std::byte> bytes) const;
  /// Replaces the first bytes, after what shaders have done with them.
  void write(std::span<const std::byte> bytes);
  /// As the shader storage block at `binding`.
  void bind(unsigned binding) const;

  /// For gl's own classes.
  std::uint32_t name() const { return name_; }

 private:
  std::uint32_t name_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace fenestra::gl
