// fuzz-seeds FOLDER: writes each target's seeds, and the files of the tables of defects, to a folder of its name, for
// libFuzzer to start from.

#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/fuzz/TableSeeds.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: fuzz-seeds FOLDER\n";
    return 2;
  }
  for (const fenestra::fuzz::Target& target : fenestra::fuzz::targets()) {
    const std::filesystem::path folder = std::filesystem::path(arguments[1]) / target.name;
    std::filesystem::create_directories(folder);
    int number = 0;
    const auto write = [&](const std::vector<std::string>& seeds) {
      for (const std::string& seed : seeds)
        std::ofstream(folder / ("seed" + std::to_string(number++)), std::ios::binary) << seed;
    };
    write(fenestra::fuzz::seedsOf(target));
    write(fenestra::fuzz::tableSeeds(target, fenestra::tests::allDefects()));
  }
}
