#pragma once
// What a stage publishes to later ones: an image, and which state of it this is.

#include <cstdint>
#include <initializer_list>

#include "rendering/gl/Texture.h"

namespace fenestra {

/// Tells two states of an image apart. No two runs of the stages of a chain have the same version, so that a key that
/// holds one also tells which stage made the image.
struct Version {
  std::uint64_t number = 0;  ///< 0: there is no image
  bool operator==(const Version&) const = default;
};

struct Output {
  const gl::Texture& image;  ///< lives as long as its stage; empty while the stage is not used
  Version version;

  explicit operator bool() const { return static_cast<bool>(image); }
  const gl::Texture* orNull() const { return image ? &image : nullptr; }
};

/// The first that has an image; the last where none has.
inline Output firstOf(std::initializer_list<Output> outputs) {
  for (const Output& output : outputs)
    if (output) return output;
  return *(outputs.end() - 1);
}

}  // namespace fenestra
