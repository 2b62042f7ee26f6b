#include "io/base/Reading.h"

#include <cmath>

namespace fenestra::io {

Progress partOf(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double fraction, std::string_view doing) { return progress(std::lerp(begin, end, fraction), doing); };
}

void throwNoTime(const std::filesystem::path& path, int time, int times) {
  throw Error(path, "has no time point " + std::to_string(time),
              times > 1 ? "its time points are numbered from 1 to " + std::to_string(times)
                        : "it holds one volume; leave out --time");
}

}  // namespace fenestra::io
