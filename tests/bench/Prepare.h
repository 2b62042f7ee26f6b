#pragma once
// The report's subjects, made ready to be measured (app/benchmark/Measurable.h).

#include <filesystem>
#include <string>

#include "app/benchmark/Measurable.h"
#include "app/benchmark/Timed.h"
#include "tests/bench/Subjects.h"
#include "tests/bench/TruthStore.h"

namespace fenestra::bench {

struct Options {
  Views views;
  std::filesystem::path peers;  ///< folder of what the peers measured
};

Measurable prepare(const std::string& name, const Scene& scene, const Options& options, const TruthStore& truths);

}  // namespace fenestra::bench
