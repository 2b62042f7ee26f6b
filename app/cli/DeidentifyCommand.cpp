#include "app/cli/DeidentifyCommand.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/cli/Report.h"
#include "io/base/SessionName.h"
#include "io/session/SessionFile.h"

namespace fenestra::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using io::deidentify::Action;

/// A session holds no patient's data, but the paths of some.
void refuseSession(const fs::path& path) {
  if (!io::isSession(path)) return;
  const fs::path data = io::readSession(path).volume.path;
  throw io::Error(path, "is a session, which holds no images",
                  data.empty() ? "name DICOM files" : "name the data that it shows: " + data.string());
}

/// (GGGG,EEEE)
std::string textOfTag(std::uint32_t tag) {
  char text[16];
  std::snprintf(text, sizeof text, "(%04x,%04x)", static_cast<unsigned>(tag >> 16),
                static_cast<unsigned>(tag & 0xffff));
  return text;
}

Json changesOf(const io::deidentify::Changes& changes) {
  Json list = Json::array();
  for (const auto& [key, change] : changes.all()) {
    Json entry{{"tag", textOfTag(key.first)},
               {"attribute", change.keyword},
               {"action", io::deidentify::wordOf(key.second)},
               {"count", change.count}};
    if (changes.keepsValues()) entry["values"] = change.values;
    list.push_back(std::move(entry));
  }
  return list;
}

Json optionsOf(const io::deidentify::Options& options) {
  Json list = Json::array();
  if (options.retainDates) list.push_back("retain-dates");
  if (options.retainUids) list.push_back("retain-uids");
  if (options.cleanDescriptors) list.push_back("clean-descriptors");
  if (options.cleanGraphics) list.push_back("clean-graphics");
  if (options.removeFace) list.push_back("remove-face");
  return list;
}

}  // namespace

void addDeidentifyOptions(app::Command command, DeidentifyOptions& options) {
  io::deidentify::Request& request = options.request;
  command.addValue("PATH", options.inputs, "DICOM files, folders, a DICOMDIR or archives").required().as("");
  const app::Option output =
      command.addValue("-o,--output", request.output, "a new or empty folder for the copies").as("FOLDER");
  const app::Option preview = command.addFlag("--preview", options.preview,
                                              "writes nothing; says what would be removed and replaced, by attribute");
  const app::Option map = command
                              .addValue("--map", request.map,
                                        "file for the old and new UIDs and patients' numbers, readable by you alone; "
                                        "otherwise nobody can tell which was which")
                              .as("FILE");
  command.addFlag("--values", request.values, "says also what was there, which names the patient").needs(preview);
  preview.excludes(output).excludes(map);
  command.group("What to keep (PS3.15 annex E)");
  command.addFlag("--retain-dates", request.options.retainDates, "dates and times as they are");
  const app::Option uids = command.addFlag("--retain-uids", request.options.retainUids, "UIDs as they are");
  command.addFlag("--clean-descriptors", request.options.cleanDescriptors,
                  "of descriptions, the words that say nothing about a person");
  command.addFlag("--clean-graphics", request.options.cleanGraphics,
                  "the shapes of annotations; overlays and curves go, as without it");
  command.group("What else to take out");
  command
      .addFlag(
          "--remove-face", request.options.removeFace,
          "of heads in CT and MR, all in front of a plane from the brow to the chin; look at the copies: images of "
          "which no face can be taken are left out")
      .excludes(uids);
  command.atLast([output, preview] {
    if (!output.isGiven() && !preview.isGiven()) throw app::MissingOption{"--output or --preview"};
  });
}

void deidentify(const DeidentifyOptions& options) {
  io::deidentify::Request request = options.request;
  request.inputs.assign(options.inputs.begin(), options.inputs.end());
  for (const fs::path& path : request.inputs) refuseSession(path);
  const io::deidentify::Outcome outcome = io::deidentify::deidentify(request, progressOnTerminal());
  printWarnings(outcome.warnings);
  Json series = Json::array();
  for (const auto& [uid, objects] : outcome.series)
    series.push_back({{"series", options.preview ? Json(nullptr) : Json(uid)}, {"objects", objects}});
  Json warnings = Json::array();
  for (const io::Warning& warning : outcome.warnings) warnings.push_back(io::commandLineText(warning));
  printJson({{"source", options.inputs.front()},
             {"folder", options.preview ? Json(nullptr) : Json(request.output.string())},
             {"options", optionsOf(request.options)},
             {"objects", outcome.objects},
             {"left_out", outcome.leftOut},
             {"faces_removed", outcome.faces},
             {"series", std::move(series)},
             {"changes", changesOf(outcome.changes)},
             {"warnings", std::move(warnings)}});
}

}  // namespace fenestra::cli
