#pragma once
// Loops over rows for the widest registers that a processor has.

// Debian's programs must run on every amd64 processor. Nearly all have AVX2, which takes half the time or less, and
// fuses no multiplication with an addition: both versions round alike. ThreadSanitizer does not run yet when one is
// chosen.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define FENESTRA_WIDE_ROWS __attribute__((target_clones("avx2", "default")))
#else
#define FENESTRA_WIDE_ROWS
#endif
