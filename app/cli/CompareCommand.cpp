#include "app/cli/Commands.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/cli/Report.h"
#include "io/ImageWriter.h"

namespace fenestra::cli {

bool compare(const CompareOptions& options) {
  const io::Picture a = io::readPicture(options.a), b = io::readPicture(options.b);
  const auto sizeOf = [](const io::Picture& picture) {
    return std::to_string(picture.size.x) + "x" + std::to_string(picture.size.y) + "x" +
           std::to_string(picture.channels);
  };
  if (a.size != b.size || a.channels != b.channels)
    throw io::Error(options.b, "is " + sizeOf(b) + " where " + options.a.string() + " is " + sizeOf(a),
                    "compare pictures of the same size and channels");

  std::size_t nanMismatches = 0, infinityMismatches = 0;
  std::vector<double> errors;
  errors.reserve(a.values.size());
  double squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double x = a.values[i], y = b.values[i];
    if (std::isnan(x) || std::isnan(y)) {
      nanMismatches += std::isnan(x) != std::isnan(y);
    } else if (std::isinf(x) || std::isinf(y)) {
      infinityMismatches += x != y;
    } else {
      const double error = std::abs(x - y);
      errors.push_back(error);
      sum += error;
      squares += error * error;
    }
  }
  std::sort(errors.begin(), errors.end());
  const auto percentile = [&](double percent) {
    if (errors.empty()) return 0.0;
    return errors[static_cast<std::size_t>(std::ceil(percent / 100.0 * static_cast<double>(errors.size() - 1)))];
  };
  const auto count = static_cast<double>(std::max<std::size_t>(errors.size(), 1));
  printJson(nlohmann::ordered_json{
      {"size", {a.size.x, a.size.y}},
      {"channels", a.channels},
      {"compared", errors.size()},
      {"max", errors.empty() ? 0.0 : errors.back()},
      {"rms", std::sqrt(squares / count)},
      {"mean", sum / count},
      {"percentiles",
       {{"50", percentile(50)}, {"90", percentile(90)}, {"99", percentile(99)}, {"99.9", percentile(99.9)}}},
      {"nan_mismatches", nanMismatches},
      {"infinity_mismatches", infinityMismatches},
  });
  return nanMismatches == 0 && infinityMismatches == 0;
}

}  // namespace fenestra::cli
