#include "io/base/Reading.h"

namespace fenestra::io {

void throwNoTime(const std::filesystem::path& path, int time, int times) {
  throw Error(path, "has no time point " + std::to_string(time),
              times > 1 ? "its time points are numbered from 1 to " + std::to_string(times)
                        : "it holds one volume; leave out --time");
}

}  // namespace fenestra::io
