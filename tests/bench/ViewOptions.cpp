#include <CLI/CLI.hpp>

#include "app/OptionHelpers.h"
#include "tests/bench/Subjects.h"

namespace fenestra::bench {

void addViewOptions(CLI::App& program, Views& views) {
  app::addParsed(program, "--size", "WxH", "picture in pixels, default 700x650", [&views](const std::string& text) {
    const auto size = app::parseNumbers<int, 2>(text, 'x');
    if (!size || (*size)[0] < 1 || (*size)[1] < 1) return false;
    views.size = {(*size)[0], (*size)[1]};
    return true;
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
