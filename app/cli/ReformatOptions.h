#pragma once
// The options of `reformat`.

#include "app/options/Options.h"

namespace fenestra::cli {

struct ReformatOptions;

/// `options` must outlive `command`.
void addReformatOptions(app::Command command, ReformatOptions& options);

}  // namespace fenestra::cli
