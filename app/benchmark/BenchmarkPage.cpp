#include "app/benchmark/BenchmarkPage.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "app/benchmark/Numbers.h"
#include "fenestra/resources.h"

namespace fenestra::bench {
namespace {

constexpr glm::ivec2 knownSize{700, 650};  ///< of the known machines' pictures

std::string settingName(const SettingTime& time) {
  if (!time.bound) return time.setting;
  std::string name = "error ≤ ";
  return name.append(time.setting).append("/255");
}

std::optional<double> timeOf(const KnownMachine& machine, const std::string& scene, const std::string& setting) {
  const auto times = machine.milliseconds.find(scene);
  if (times == machine.milliseconds.end()) return std::nullopt;
  const auto time = times->second.find(setting);
  return time == times->second.end() ? std::nullopt : std::optional(time->second);
}

std::string milliseconds(double value) { return fixed(value, value < 10.0 ? 1 : 0); }

void writeScene(std::ostream& page, const SceneTimes& scene, const std::vector<KnownMachine>& machines, bool hasErrors,
                bool isComparable) {
  const std::size_t compared = isComparable ? machines.size() : 0;
  page << "## " << scene.name << "\n\n| setting | ms | least to most | pictures a second |";
  if (hasErrors) page << " error of 99.99 % of the pixels | RMS |";
  for (std::size_t i = 0; i < compared; ++i) page << " machine " << i + 1 << ": ms |";
  page << "\n|---|---:|---:|---:|" << (hasErrors ? "---:|---:|" : "");
  for (std::size_t i = 0; i < compared; ++i) page << "---:|";
  page << "\n";
  for (const SettingTime& time : scene.settings) {
    page << "| " << settingName(time) << " | " << milliseconds(time.median) << " | " << milliseconds(time.least)
         << " to " << milliseconds(time.most) << " | " << number(1000.0 / time.median) << " |";
    if (hasErrors) page << " " << number(time.error.value_or(0.0)) << " | " << number(time.rms.value_or(0.0)) << " |";
    for (std::size_t i = 0; i < compared; ++i) {
      const std::optional<double> there = timeOf(machines[i], scene.id, time.setting);
      page << " " << (there ? milliseconds(*there) : "") << " |";
    }
    page << "\n";
  }
  page << "\n";
}

void writeComparison(std::ostream& page, const BenchmarkResult& result, const std::vector<KnownMachine>& machines) {
  page << "## Compared with other machines\n\n";
  if (result.size != knownSize) {
    page << "The figures of other machines are of pictures of 700×650 pixels: leave out `--size` to compare.\n\n";
    return;
  }
  for (std::size_t i = 0; i < machines.size(); ++i) {
    const KnownMachine& machine = machines[i];
    page << i + 1 << ". " << machine.name << ", measured on " << machine.date << " (" << machine.source << "): ";
    if (const std::optional<Comparison> found = compare(result, machine))
      page << "this machine takes " << number(1.0 / found->timesAsFast) << " times as long, in the geometric mean of "
           << found->settings << (found->settings == 1 ? " setting that was" : " settings that were")
           << " measured on both.\n";
    else
      page << "no setting was measured on both.\n";
  }
  page << "\n";
}

}  // namespace

std::vector<KnownMachine> parseMachines(std::string_view json) {
  std::vector<KnownMachine> machines;
  try {
    const nlohmann::json all = nlohmann::json::parse(json);
    for (const nlohmann::json& each : all.at("machines"))
      machines.push_back({each.at("name"), each.at("source"), each.at("date"), each.at("milliseconds")});
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("figures of machines: ") + error.what());
  }
  return machines;
}

std::vector<KnownMachine> knownMachines() { return parseMachines(resources::find("benchmark/machines.json")); }

std::optional<Comparison> compare(const BenchmarkResult& here, const KnownMachine& there) {
  Comparison comparison;
  double logarithms = 0.0;
  for (const SceneTimes& scene : here.scenes)
    for (const SettingTime& time : scene.settings)
      if (const std::optional<double> known = timeOf(there, scene.id, time.setting);
          known && *known > 0.0 && time.median > 0.0) {
        logarithms += std::log(*known / time.median);
        ++comparison.settings;
      }
  if (comparison.settings == 0 || here.size != knownSize) return std::nullopt;
  comparison.timesAsFast = std::exp(logarithms / comparison.settings);
  return comparison;
}

nlohmann::ordered_json benchmarkJson(const BenchmarkResult& result, const std::vector<KnownMachine>& machines) {
  using Json = nlohmann::ordered_json;
  Json scenes = Json::array();
  for (const SceneTimes& scene : result.scenes) {
    Json settings = Json::array();
    for (const SettingTime& time : scene.settings) {
      Json one = {{"setting", time.setting}, {"median_ms", time.median}, {"min_ms", time.least}, {"max_ms", time.most}};
      if (time.bound) one["max_error"] = *time.bound;
      if (time.error) one["error_99_99"] = *time.error;
      if (time.rms) one["rms"] = *time.rms;
      settings.push_back(std::move(one));
    }
    scenes.push_back({{"id", scene.id}, {"name", scene.name}, {"settings", std::move(settings)}});
  }
  Json compared = Json::array();
  for (const KnownMachine& machine : machines) {
    const std::optional<Comparison> found = compare(result, machine);
    compared.push_back({{"name", machine.name},
                        {"source", machine.source},
                        {"times_as_fast", found ? Json(found->timesAsFast) : Json(nullptr)},
                        {"settings", found ? found->settings : 0}});
  }
  return {{"processors", result.machine.processors},
          {"memory_gib", result.machine.memory},
          {"load", result.machine.load},
          {"gl", result.machine.renderer},
          {"software", result.machine.isSoftware},
          {"schedule", result.schedule},
          {"size", {result.size.x, result.size.y}},
          {"quick", result.isQuick},
          {"context_ms", result.context},
          {"phantom_ms", result.reading},
          {"first_picture_ms", result.first},
          {"placing_ms", result.placing},
          {"both_cameras_ms", result.both},
          {"scenes", std::move(scenes)},
          {"compared", std::move(compared)}};
}

std::string benchmarkPage(const BenchmarkResult& result, const std::vector<KnownMachine>& machines,
                          const std::string& version, const std::string& date) {
  const Machine& machine = result.machine;
  std::ostringstream page;
  page << "# How fast this machine draws\n\nFenestra " << version << ", " << date
       << (result.isQuick ? ", quick: one round, so single times may be off.\n\n" : ".\n\n");
  page << "| | |\n|---|---|\n| processors | " << machine.processors << " |\n";
  if (machine.memory > 0.0) page << "| main memory | " << fixed(machine.memory, 1) << " GiB |\n";
  page << "| OpenGL | " << machine.renderer << (machine.isSoftware ? ": the processors draw" : "") << " |\n"
       << "| schedule of the shaders | " << result.schedule << " |\n"
       << "| pictures | " << result.size.x << "×" << result.size.y << " pixels of the phantom torso |\n\n"
       << "## From the start\n\n| | ms |\n|---|---:|\n"
       << "| until there is an OpenGL context | " << milliseconds(result.context) << " |\n"
       << "| the phantom is made | " << milliseconds(result.reading) << " |\n"
       << "| first picture: voxels uploaded, programs compiled or found | " << milliseconds(result.first) << " |\n"
       << "| cameras placed: 192 views measured | " << milliseconds(result.placing) << " |\n"
       << "| both cameras, as one is turned, normal quality | " << milliseconds(result.both) << " |\n\n";
  constexpr double busy = 0.5;  // processors; less is what a desktop does by itself
  if (machine.load > busy)
    page << "Other programs kept " << number(machine.load)
         << " processors busy in the minute before: alone on the machine, times are shorter.\n\n";
  writeComparison(page, result, machines);
  for (const SceneTimes& scene : result.scenes)
    writeScene(page, scene, machines, !result.isQuick, result.size == knownSize);
  page << "Times are until the picture is in the graphics memory. "
       << (result.isQuick ? "Errors are measured without `--quick`.\n"
                          : "Errors are those of a pixel's worst channel, in 1/255, against the reference in double "
                            "precision, one pixel of each block of 12×12.\n");
  return page.str();
}

}  // namespace fenestra::bench
