#include "io/base/Reading.h"

#include <cmath>

namespace fenestra::io {

Progress partOf(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double fraction, std::string_view doing) { return progress(std::lerp(begin, end, fraction), doing); };
}

std::string commandLineText(const Warning& warning) {
  return warning.way == WayOut::None ? warning.text : warning.text + "; " + commandLineWords(warning.way);
}

void throwNoTime(const std::filesystem::path& path, int time, int times) {
  const std::string cause = "has no time point " + std::to_string(time);
  if (times <= 1) throw Error(path, cause, WayOut::OnlyTime);
  throw Error(path, cause, "its time points are numbered from 1 to " + std::to_string(times));
}

}  // namespace fenestra::io
