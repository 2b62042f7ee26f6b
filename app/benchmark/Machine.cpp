#include "app/benchmark/Machine.h"

#include <unistd.h>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "rendering/gl/Context.h"

namespace fenestra::bench {

std::string processors() {
  std::ifstream file("/proc/cpuinfo");
  std::string line, name;
  while (name.empty() && std::getline(file, line))
    if (line.starts_with("model name")) name = line.substr(line.find(':') + 1);
  return std::to_string(std::thread::hardware_concurrency()) + " ×" + (name.empty() ? " processor" : name);
}

Machine thisMachine() {
  Machine machine{processors(), 0.0, gl::description(), gl::isSoftwareRasteriser(), 0.0};
  const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
  constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
  if (pages > 0 && size > 0) machine.memory = static_cast<double>(pages) * static_cast<double>(size) / gibibyte;
  double load = 0.0;
  if (::getloadavg(&load, 1) == 1) machine.load = load;
  return machine;
}

}  // namespace fenestra::bench
