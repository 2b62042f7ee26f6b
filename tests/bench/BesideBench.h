#pragma once
// The memory of two studies side by side, against that of one.

#include <functional>

#include <nlohmann/json.hpp>

#include "io/study/Study.h"
#include "viewer/MainWindow.h"

namespace fenestra::viewer {

/// Resident memory in MB with no study, with one on the left, and with another reading of it on the right, each at
/// rest. Both windows are there from the beginning, so that nothing but a study is added, and views keep their sizes.
/// `share` is what both take, as a share of twice what one does.
nlohmann::ordered_json besideMemory(MainWindow& window, const std::function<io::Study(const io::Progress&)>& read,
                                    const std::function<void(MainWindow&)>& settle);

}  // namespace fenestra::viewer
