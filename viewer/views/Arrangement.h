#pragma once
// The ready ways to lay the views out: which are shown, in two groups that lie beside or above each other.

#include <array>
#include <span>
#include <string_view>

#include <QtGlobal>

namespace fenestra::viewer {

struct Arrangement {
  const char* id;    ///< in preferences and sessions
  const char* name;  ///< in the menu, to be translated in the context "ViewArea"
  Qt::Orientation groupsLie;
  /// The views of each group by their names in a session, null where there are fewer. Within a group they lie across
  /// the direction in which the groups lie.
  std::array<std::array<const char*, 3>, 2> groups;
  std::array<int, 2> shares;  ///< of the area, in percent

  bool shows(std::string_view view) const;
};

/// The first is that of a first start. One view alone is none of these: see ViewArea::toggleMaximised().
std::span<const Arrangement> arrangements();
/// Null where no arrangement has that id.
const Arrangement* findArrangement(std::string_view id);

}  // namespace fenestra::viewer
