#pragma once
// The options of `slice`.

#include "app/options/Options.h"

namespace fenestra::cli {

struct SliceOptions;

/// `options` must outlive `command`.
void addSliceOptions(app::Command command, SliceOptions& options);

}  // namespace fenestra::cli
