#include "app/cli/Report.h"

#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "rendering/gpu/GpuScene.h"

namespace fenestra::cli {

io::Progress progressOnTerminal() {
  if (!isatty(STDERR_FILENO)) return {};
  return [shown = -1](double fraction, std::string_view doing) mutable {
    const int percent = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 100.0);
    if (percent != shown) {
      shown = percent;
      std::fprintf(stderr, "\r\033[K%3d %% %.*s%s", percent, static_cast<int>(doing.size()), doing.data(),
                   percent == 100 ? "\r\033[K" : "");
      std::fflush(stderr);
    }
    return true;
  };
}

void printWarnings(const std::vector<io::Warning>& warnings) {
  for (const io::Warning& warning : warnings) {
    if (warning.kind == io::Warning::Kind::Recognised) continue;  // `info` and the window tell it
    std::string line = "fenestra-cli: warning: " + io::commandLineText(warning);
    if (!warning.files.empty()) line += " (" + warning.files.front().filename().string();
    if (warning.files.size() > 1) line += " and " + std::to_string(warning.files.size() - 1) + " more";
    if (!warning.files.empty()) line += ")";
    std::cerr << oneLine(line) << '\n';
  }
}

void printReduction(const GpuScene& gpu) {
  if (const std::string notice = gpu.reductionNotice(); !notice.empty())
    printWarnings({{io::Warning::Kind::Other, notice, {}}});
}

void printJson(const nlohmann::ordered_json& json) {
  std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n' << std::flush;
}

nlohmann::ordered_json listOf(glm::dvec3 v) { return {v.x, v.y, v.z}; }

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

}  // namespace fenestra::cli
