// The kernels of thick slices for the processors that the program may run on.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <type_traits>

#include "rendering/volume/SlabJob.h"

// Vectors are passed within this file alone, so that how they are passed does not matter.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

#define FENESTRA_SLAB_KERNEL any_processor
#include "rendering/volume/SlabKernel.h"
#undef FENESTRA_SLAB_KERNEL

// Debian's programs must run on every amd64 processor, and these instructions, which nearly all of them have, take a
// third of the time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define FENESTRA_SLAB_AVX2
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#define FENESTRA_SLAB_KERNEL with_avx2
#include "rendering/volume/SlabKernel.h"
#undef FENESTRA_SLAB_KERNEL
#pragma GCC pop_options
#endif

namespace fenestra {

template <class T>
SlabKernel slabKernel(bool ofMeans) {
#ifdef FENESTRA_SLAB_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return ofMeans ? &with_avx2::slabTile<T, true> : &with_avx2::slabTile<T, false>;
#endif
  return ofMeans ? &any_processor::slabTile<T, true> : &any_processor::slabTile<T, false>;
}

template SlabKernel slabKernel<std::uint8_t>(bool);
template SlabKernel slabKernel<std::int8_t>(bool);
template SlabKernel slabKernel<std::uint16_t>(bool);
template SlabKernel slabKernel<std::int16_t>(bool);
template SlabKernel slabKernel<std::uint32_t>(bool);
template SlabKernel slabKernel<std::int32_t>(bool);
template SlabKernel slabKernel<float>(bool);
template SlabKernel slabKernel<double>(bool);

}  // namespace fenestra

#pragma GCC diagnostic pop
