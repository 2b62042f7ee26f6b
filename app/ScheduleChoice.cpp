#include "app/ScheduleChoice.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "io/base/AtomicFile.h"
#include "io/base/Error.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra::app {
namespace {

namespace fs = std::filesystem;

/// Empty where there is neither a cache folder nor a home.
fs::path answersFile() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value ? value : "");
  };
  fs::path cache = folder("XDG_CACHE_HOME");
  if (!cache.is_absolute() && !folder("HOME").empty()) cache = folder("HOME") / ".cache";
  return cache.is_absolute() ? cache / "fenestra" / "schedules.json" : fs::path();
}

nlohmann::json readAnswers(const fs::path& file) {
  std::ifstream stream(file);
  nlohmann::json answers = nlohmann::json::parse(stream, nullptr, false);
  return answers.is_object() ? answers : nlohmann::json::object();
}

std::optional<Schedule> keptAnswer(const nlohmann::json& answers, const std::string& key) {
  const auto at = answers.find(key);
  if (at == answers.end() || !at->is_object()) return std::nullopt;
  const auto chosen = at->find("schedule");
  return chosen != at->end() && chosen->is_string() ? scheduleNamed(chosen->get<std::string>()) : std::nullopt;
}

void keepAnswer(const fs::path& file, const std::string& key, const ScheduleTimes& times) {
  // Another program may have written meanwhile.
  nlohmann::json answers = readAnswers(file);
  answers[key] = {{"schedule", nameOf(times.faster())}, {"plain_ms", times.plain}, {"llvmpipe_ms", times.llvmpipe}};
  try {
    fs::create_directories(file.parent_path());
    io::writeText(file, answers.dump(2) + "\n");
  } catch (const fs::filesystem_error&) {
  } catch (const io::Error&) {
  }
}

}  // namespace

void addScheduleOption(Command command, std::optional<Schedule>& schedule) {
  command.add(
      "--schedule", "plain|llvmpipe",
      "how shaders lay out their work; the same picture, faster or slower. Default: what is faster on this machine",
      [&schedule](const std::string& text) {
        schedule = scheduleNamed(text);
        return schedule.has_value();
      });
}

std::optional<Schedule> knownSchedule(std::optional<Schedule> asked, const Volume& volume) {
  return asked ? asked : keptAnswer(readAnswers(answersFile()), scheduleKey(volume));
}

void chooseSchedule(std::optional<Schedule> asked, const std::shared_ptr<GpuScene>& gpuScene, const Scene& scene,
                    const View& view) {
  if (const auto known = knownSchedule(asked, *scene.volume)) return gpuScene->setSchedule(*known);
  const ScheduleTimes times = tryBothSchedules(gpuScene, scene, view);
  if (const fs::path file = answersFile(); !file.empty()) keepAnswer(file, scheduleKey(*scene.volume), times);
}

void chooseScheduleQuickly(std::optional<Schedule> asked, bool software, const std::shared_ptr<GpuScene>& gpuScene,
                           const Scene& scene, const View& view) {
  if (!software) return chooseSchedule(asked, gpuScene, scene, view);
  if (const auto known = knownSchedule(asked, *scene.volume)) gpuScene->setSchedule(*known);
}

}  // namespace fenestra::app
