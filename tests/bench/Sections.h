#pragma once
// The report's sections. Each measures, says on standard error how far it is, and returns what it found.

#include "rendering/egl/EglContext.h"
#include "tests/bench/Prepare.h"
#include "tests/bench/Report.h"

namespace fenestra::bench {

/// The error bound on ten scenes: the bound against the measured errors.
Section boundsSection(const Options& options, const TruthStore& truths);

/// Every setting's and peer's time against its error.
Section sweepSection(const Options& options, const TruthStore& truths);
/// The error bound with each kind of look, on the ten scenes and on random pictures.
Section looksSection(const Options& options, const TruthStore& truths);
/// Error and time under random transfer functions.
Section randomSection(const Options& options, const TruthStore& truths);
/// Error and time under steep functions, unlit, of coarse volumes in larger pictures.
Section steepSection(const Options& options, const TruthStore& truths);
/// Each stage's error in its own unit.
Section stageSection(const Options& options, const TruthStore& truths);
/// The time of each pass; these three need no reference pictures.
Section passSection(const Options& options, const TruthStore& truths);
/// The time of a slider's move.
Section updateSection(const Options& options, const TruthStore& truths);
/// Memory and passes of each kind of scene.
Section memorySection(const Options& options, const TruthStore& truths);

}  // namespace fenestra::bench
