#pragma once
// The context that the renderer runs in: what it offers, its errors and times, and the state that must be restored.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace fenestra::gl {

/// Measures the GPU time between construction and elapsedMilliseconds(), which waits for it.
class TimerQuery {
 public:
  TimerQuery();
  ~TimerQuery();
  TimerQuery(const TimerQuery&) = delete;
  TimerQuery& operator=(const TimerQuery&) = delete;
  double elapsedMilliseconds();

 private:
  std::array<std::uint32_t, 2> names_{};
};

/// Waits until everything that was asked of the GPU is done.
void finish();
/// Name of the first OpenGL error since the last call, and clears them all; empty when there is none. Tests end with
/// it.
std::string takeError();
/// Keeps pending errors for takeError(), so that errors of later calls can be told from them.
void noteErrors();
/// "RENDERER, VERSION" of the current context.
std::string description();
/// Whether the current context draws with the CPU.
bool isSoftwareRasteriser();
/// Why the current context cannot run the renderer (too old, no compute shaders); empty when it can.
std::string unsupportedReason();
/// Longest side of a 3-D texture here, in texels.
int maxTextureSize3D();
/// Bytes of graphics memory that are free for textures, as the driver says (NVX_gpu_memory_info, ATI_meminfo); half of
/// the main memory where the CPU draws; empty where nothing says so.
std::optional<std::size_t> freeTextureMemory();

}  // namespace fenestra::gl
