// fuzz-seeds FOLDER: writes each target's seeds to a folder of its name, for libFuzzer to start from.

#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/fuzz/Targets.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: fuzz-seeds FOLDER\n";
    return 2;
  }
  for (const fenestra::fuzz::Target& target : fenestra::fuzz::targets()) {
    const std::filesystem::path folder = std::filesystem::path(arguments[1]) / target.name;
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& seed : fenestra::fuzz::seedsOf(target))
      std::ofstream(folder / ("seed" + std::to_string(number++)), std::ios::binary) << seed;
  }
}
