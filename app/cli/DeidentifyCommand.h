#pragma once
// The options of `deidentify`, apart from the other commands.

#include <string>
#include <vector>

#include "app/options/Options.h"
#include "io/deidentify/Deidentify.h"

namespace fenestra::cli {

struct DeidentifyOptions {
  std::vector<std::string> inputs;
  io::deidentify::Request request;  ///< without its inputs
  bool preview = false;             ///< nothing is written
};

void addDeidentifyOptions(app::Command command, DeidentifyOptions& options);
/// Prints what was changed as JSON, or would be.
void deidentify(const DeidentifyOptions& options);

}  // namespace fenestra::cli
