// The kernels of thick slices for the processors that the program may run on.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "rendering/volume/SlabJob.h"

#define FENESTRA_SLAB_KERNEL any_processor
#include "rendering/volume/SlabKernel.h"
#undef FENESTRA_SLAB_KERNEL

// Debian's programs must run on every amd64 processor. Nearly all have these instructions, which halve the time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#define FENESTRA_SLAB_AVX2
#define FENESTRA_SLAB_KERNEL with_avx2
#include "rendering/volume/SlabKernel.h"
#undef FENESTRA_SLAB_KERNEL
#pragma GCC pop_options
#endif

namespace fenestra {

std::vector<SlabKernel> slabKernels(bool ofMeans, bool ofInt16) {
  std::vector<SlabKernel> kernels;
#ifdef FENESTRA_SLAB_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    if (ofInt16)
      kernels.push_back(ofMeans ? &with_avx2::slabKernel<std::int16_t, true>
                                : &with_avx2::slabKernel<std::int16_t, false>);
    else
      kernels.push_back(ofMeans ? &with_avx2::slabKernel<double, true> : &with_avx2::slabKernel<double, false>);
  }
#endif
  if (ofInt16)
    kernels.push_back(ofMeans ? &any_processor::slabKernel<std::int16_t, true>
                              : &any_processor::slabKernel<std::int16_t, false>);
  else
    kernels.push_back(ofMeans ? &any_processor::slabKernel<double, true> : &any_processor::slabKernel<double, false>);
  return kernels;
}

}  // namespace fenestra
