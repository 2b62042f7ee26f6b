#pragma once
// Memory that values of the document point to, for the limit of the history.

#include <cstddef>
#include <vector>

#include "rendering/settings/Focus.h"

namespace fenestra {
struct Look;
struct Measure;
}  // namespace fenestra

namespace fenestra::viewer {

/// Bytes beside those of sizeof().
std::size_t heldBy(const Look& look);
std::size_t heldBy(const Focus& focus);
std::size_t heldBy(const std::vector<Measure>& measures);

}  // namespace fenestra::viewer
