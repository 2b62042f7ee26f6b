#include "tests/bench/RandomLooks.h"

#include <algorithm>
#include <cmath>

namespace fenestra::bench {
namespace {

void sortByValue(TransferFunction& transfer) {
  std::sort(transfer.nodes.begin(), transfer.nodes.end(),
            [](const auto& a, const auto& b) { return a.value < b.value; });
}

}  // namespace

TransferFunction randomTransfer(ValueRange range, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  TransferFunction transfer;
  const int nodes = std::uniform_int_distribution(2, 7)(random);
  for (int i = 0; i < nodes; ++i) {
    TransferFunction::Node node;
    node.value = range.low + share(random) * (range.high - range.low);
    node.properties.colour = {share(random), share(random), share(random)};
    const double opacity = share(random) < 0.4 ? 0.0 : std::pow(10.0, -2.5 + 2.45 * share(random));
    node.properties.extinction = extinctionFromOpacity(opacity);
    transfer.nodes.push_back(node);
  }
  sortByValue(transfer);
  return transfer;
}

TransferFunction steepTransfer(ValueRange range, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  TransferFunction transfer;
  for (int i = 0; i < 7; ++i) {
    TransferFunction::Node node;
    node.value = range.low + share(random) * (range.high - range.low);
    node.properties.colour = {share(random), share(random), share(random)};
    node.properties.extinction = extinctionFromOpacity(0.35 * share(random));
    transfer.nodes.push_back(node);
  }
  sortByValue(transfer);
  return transfer;
}

Camera randomCamera(const Grid& grid, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double azimuth = 360.0 * share(random), elevation = glm::degrees(std::asin(1.9 * share(random) - 0.95));
  return Camera::fromAngles(azimuth, elevation, grid,
                            share(random) < 0.5 ? Projection::Perspective : Projection::Orthographic);
}

}  // namespace fenestra::bench
