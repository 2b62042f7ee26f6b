#pragma once
// The report's sections. Each measures, says on standard error how far it is, and returns what it found.

#include "rendering/egl/EglContext.h"
#include "tests/bench/Measure.h"
#include "tests/bench/Report.h"

namespace fenestra::bench {

/// The error bound on ten scenes: what is asked for against what is measured.
Section boundsSection(const Options& options, const TruthStore& truths);

}  // namespace fenestra::bench
