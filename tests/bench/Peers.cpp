#include "tests/bench/Peers.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "io/ImageWriter.h"
#include "io/base/Error.h"

namespace fenestra::bench {
namespace {
namespace fs = std::filesystem;
}

Peers readPeers(const fs::path& folder, const Views& views) {
  Peers peers;
  std::vector<fs::path> files;
  std::error_code none;  // no folder is no peers
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& path : files) {
    try {
      const auto json = nlohmann::json::parse(std::ifstream(path));
      const Views theirs{{json.at("size").at(0), json.at("size").at(1)},
                         json.at("cameras"),
                         json.at("compared"),
                         json.at("pixelBlock"),
                         json.at("phantomVoxels"),
                         json.at("parallel"),
                         views.only};
      if (theirs != views) {
        peers.left.push_back(path.stem().string() + ": left out, was measured with other views");
        continue;
      }
      const std::string program = json.at("program");
      const std::string described = program + ": version " + json.at("version").get<std::string>() + ", on " +
                                    json.at("machine").get<std::string>();
      if (std::find(peers.programs.begin(), peers.programs.end(), described) == peers.programs.end())
        peers.programs.push_back(described);
      for (const auto& entry : json.at("runs")) {
        PeerRun run{
            program, entry.at("subject"), entry.at("lit"), entry.at("samplesPerVoxel"), entry.value("setting", ""), {},
            {}};
        for (const double frame : entry.at("frames_ms")) run.milliseconds.add(frame);
        for (const std::string picture : entry.value("pictures", nlohmann::json::array()))
          run.pictures.push_back(folder / picture);
        peers.runs.push_back(std::move(run));
      }
    } catch (const nlohmann::json::exception& error) {
      throw io::Error(path, error.what(), "measure this peer again");
    }
  }
  return peers;
}

namespace {

/// RGBA of the compared pixels.
std::vector<float> valuesOf(const fs::path& path, std::size_t pixels) {
  io::Picture picture = io::readPicture(path);
  if (picture.values.size() != 4 * pixels)
    throw io::Error(path, "has another number of pixels", "measure this peer again");
  return std::move(picture.values);
}

/// Peers draw on black and keep no opacity.
glm::dvec4 colourOf(const std::vector<float>& values, std::size_t pixel, double opacity) {
  return {values[4 * pixel], values[4 * pixel + 1], values[4 * pixel + 2], opacity};
}

}  // namespace

ColourErrors errorsOf(const PeerRun& run, const Measurable& what) {
  ColourErrors errors;
  for (std::size_t i = 0; i < run.pictures.size(); ++i) {
    const std::vector<float> values = valuesOf(run.pictures[i], what.pixels.size());
    for (std::size_t k = 0; k < what.pixels.size(); ++k) {
      const glm::dvec4 truth = what.truths.at(i)[k];
      errors.add(colourOf(values, k, truth.a), truth, glm::dvec3(0.0));
    }
  }
  return errors;
}

ColourErrors errorsOf(const PeerRun& run, const PeerRun& limit) {
  ColourErrors errors;
  for (std::size_t i = 0; i < run.pictures.size(); ++i) {
    const std::vector<float> truth = io::readPicture(limit.pictures.at(i)).values;
    const std::vector<float> values = valuesOf(run.pictures[i], truth.size() / 4);
    for (std::size_t k = 0; k < truth.size() / 4; ++k)
      errors.add(colourOf(values, k, 0.0), colourOf(truth, k, 0.0), glm::dvec3(0.0));
  }
  return errors;
}

}  // namespace fenestra::bench
