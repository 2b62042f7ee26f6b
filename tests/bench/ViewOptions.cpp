#include <limits>

#include <CLI/CLI.hpp>

#include "app/options/Numbers.h"
#include "app/options/Options.h"
#include "tests/bench/Subjects.h"

namespace fenestra::bench {

void addViewOptions(CLI::App& program, Views& views) {
  app::Command(program).add("--size", "WxH", "picture in pixels, default 700x650", [&views](const std::string& text) {
    const auto size = app::parseSize(text, std::numeric_limits<int>::max());
    if (size) views.size = *size;
    return size.has_value();
  });
  program.add_option("--cameras", views.cameras, "views along the path, default 3")->check(CLI::Range(1, 100));
  program.add_option("--compared", views.compared, "of them with the reference, default 2")->check(CLI::Range(1, 100));
  program.add_option("--block", views.pixelBlock, "compare one pixel of each block of this side, default 8")
      ->check(CLI::Range(1, 64));
  program.add_option("--voxels", views.phantomVoxels, "along a phantom's longest side, default 256")
      ->check(CLI::Range(8, 1024));
  program.add_flag("--parallel", views.parallel, "views in parallel projection, as shear-warp needs");
  program.add_option("--only", views.only, "subjects whose id starts with this");
}

}  // namespace fenestra::bench
