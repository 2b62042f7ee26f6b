#pragma once
// A few views that together show a surface, and a way past them.

#include <vector>

#include <glm/glm.hpp>

#include "rendering/viewpoints/ViewChannel.h"

namespace fenestra::placement {

/// At most this many representative views are taken: the tour past them is searched exhaustively.
inline constexpr std::size_t mostRepresentativeViews = 8;

struct RepresentativeViews {
  std::vector<std::size_t> views;  ///< in the order in which they are taken
  std::vector<double> shares;      ///< of all elements, that the views up to each one see together
};

/// The N best views (Vázquez, Feixas, Sbert, Heidrich: Automatic view selection using viewpoint entropy and its
/// application to image-based modelling. Computer Graphics Forum 22(4), 2003): again and again the view that adds most,
/// which is the part of its entropy that elements add which no view taken before sees, −Σ_{z new} p(z|v) log₂ p(z|v).
/// The first one is the view of greatest entropy. Ends when the views see `enough` (0…1) of the elements that any view
/// sees, or when there are `most`. Ties go to the lowest index.
RepresentativeViews representativeViews(const ViewChannel& channel, double enough = 0.95,
                                        std::size_t most = mostRepresentativeViews);

/// A closed tour of directions on the unit sphere.
struct Tour {
  std::vector<std::size_t> order;  ///< indices of the directions; begins with 0
  double length = 0.0;             ///< radians, along great circles and back to the first one
};
/// The shortest tour among all orders, for at most `mostRepresentativeViews` directions; among equally short ones the
/// first in lexicographic order.
Tour shortestTour(const std::vector<glm::dvec3>& directions);

}  // namespace fenestra::placement
