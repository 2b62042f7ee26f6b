// layers-check: does what a renderer wrote with --layers follow from the label map it was given?
//
//   layers-check IMAGE LABELS --labels 2,3 LAYERS_DIR [--w-open 24] [--w-border 2]
//
// Recomputes the hit points, the distance map, the promises of the fill and the ray starts in double precision and
// prints a JSON summary. Exit codes: 0 everything holds, 1 something does not, 2 the input cannot be used. It shares no
// code with the renderer, on purpose: files are read by ITK, rays come from camera.json's matrix alone, and the focus
// is sampled densely where the renderer's own reference solves for its surface.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <itkImage.h>
#include <itkImageFileReader.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <vnl/vnl_inverse.h>
#include <vnl/vnl_matrix_fixed.h>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Vector = std::array<double, 3>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Tolerances that the renderer promises.
constexpr double hitTolerance = 2e-3;       // voxels from the 0.5 level
constexpr double distanceTolerance = 1e-4;  // pixels
constexpr double startTolerance = 0.02;     // voxels along the ray
// Step of the samples of the focus along a ray, in voxels. A thinner piece of focus may be missed here.
constexpr double sampleStep = 0.01;

struct Unusable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// ---- input ----------------------------------------------------------------------------------------------------------

template <class Image>
typename Image::Pointer readImage(const fs::path& path) {
  const std::string name = path.string();
  auto reader = itk::ImageFileReader<Image>::New();
  const auto endsWith = [&](std::string_view ending) {
    return name.size() >= ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  };
  if (endsWith(".nii") || endsWith(".nii.gz"))
    reader->SetImageIO(itk::NiftiImageIO::New());
  else
    reader->SetImageIO(itk::MetaImageIO::New());
  reader->SetFileName(name);
  try {
    reader->Update();
  } catch (const itk::ExceptionObject& error) {
    throw Unusable(name + ": " + error.GetDescription());
  }
  return reader->GetOutput();
}

/// A layer, row by row from the top of the picture.
struct Layer {
  std::size_t width = 0, height = 0;
  std::vector<float> pixels;
};

Layer readLayer(const fs::path& folder, const std::string& name) {
  using Image = itk::Image<float, 2>;
  const Image::Pointer image = readImage<Image>(folder / (name + ".mha"));
  const Image::SizeType size = image->GetLargestPossibleRegion().GetSize();
  const float* first = image->GetBufferPointer();
  return {size[0], size[1], {first, first + size[0] * size[1]}};
}

/// The 0/1 indicator of the focus on the label map's lattice.
struct Focus {
  std::array<int, 3> dims{};
  std::vector<std::uint8_t> inside;        // per voxel
  std::vector<std::uint8_t> mayHoldFocus;  // per cell, which voxel (i,j,k) begins
  using Image = itk::Image<std::uint16_t, 3>;
  Image::Pointer image;  // for its geometry

  std::size_t offset(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(dims[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(dims[0]) +
           static_cast<std::size_t>(i);
  }
};

Focus readFocus(const fs::path& path, const std::set<int>& labels) {
  Focus focus;
  focus.image = readImage<Focus::Image>(path);
  const auto size = focus.image->GetLargestPossibleRegion().GetSize();
  for (std::size_t axis = 0; axis < 3; ++axis) focus.dims[axis] = static_cast<int>(size[axis]);
  const std::size_t count = size[0] * size[1] * size[2];
  focus.inside.resize(count);
  const std::uint16_t* voxels = focus.image->GetBufferPointer();
  for (std::size_t i = 0; i < count; ++i) focus.inside[i] = labels.count(voxels[i]) ? 1 : 0;
  focus.mayHoldFocus.resize(count);
  for (int k = 0; k < focus.dims[2]; ++k)
    for (int j = 0; j < focus.dims[1]; ++j)
      for (int i = 0; i < focus.dims[0]; ++i)
        for (int corner = 0; corner < 8; ++corner)
          focus.mayHoldFocus[focus.offset(i, j, k)] |= focus.inside[focus.offset(
              std::min(i + (corner & 1), focus.dims[0] - 1), std::min(j + (corner >> 1 & 1), focus.dims[1] - 1),
              std::min(k + (corner >> 2), focus.dims[2] - 1))];
  return focus;
}

void requireSameGrid(const fs::path& imagePath, const Focus& focus) {
  const auto image = readImage<itk::Image<float, 3>>(imagePath);
  // Headers hold a few digits only.
  constexpr double headerRounding = 1e-3;
  bool same = image->GetLargestPossibleRegion().GetSize() == focus.image->GetLargestPossibleRegion().GetSize();
  for (unsigned axis = 0; axis < 3; ++axis) {
    same = same && std::abs(image->GetSpacing()[axis] - focus.image->GetSpacing()[axis]) < headerRounding &&
           std::abs(image->GetOrigin()[axis] - focus.image->GetOrigin()[axis]) < headerRounding;
    for (unsigned row = 0; row < 3; ++row)
      same =
          same && std::abs(image->GetDirection()(row, axis) - focus.image->GetDirection()(row, axis)) < headerRounding;
  }
  if (!same) throw Unusable(imagePath.string() + ": its grid is not the label map's");
}

// ---- rays -----------------------------------------------------------------------------------------------------------

/// t in mm from `origin`; both in index space, so that the direction's length is voxels per mm.
struct Ray {
  Vector origin{}, direction{};
  double voxelsPerMm = 0.0;
};

class RayCamera {
 public:
  RayCamera(const fs::path& path, const Focus& focus) : focus_(focus) {
    std::ifstream file(path);
    if (!file) throw Unusable(path.string() + ": cannot be read");
    try {
      const Json json = Json::parse(file);
      width = json.at("size").at(0).get<std::size_t>();
      height = json.at("size").at(1).get<std::size_t>();
      const std::string projection = json.at("projection");
      if (projection != "perspective" && projection != "orthographic")
        throw Unusable(path.string() + ": unknown projection " + projection);
      perspective_ = projection == "perspective";
      for (std::size_t axis = 0; axis < 3; ++axis) eye_[axis] = json.at("eye_world").at(axis).get<double>();
      const Json& matrix = json.at("clipFromWorld");  // 4 rows, or 16 numbers by rows
      vnl_matrix_fixed<double, 4, 4> clipFromWorld;
      for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
          clipFromWorld(row, column) =
              matrix.size() == 16 ? matrix.at(row * 4 + column).get<double>() : matrix.at(row).at(column).get<double>();
      worldFromClip_ = vnl_inverse(clipFromWorld);
    } catch (const Json::exception& error) {
      throw Unusable(path.string() + ": " + error.what());
    }
  }

  Ray ray(std::size_t i, std::size_t j) const {
    const double x = 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(width) - 1.0;
    const double y = 1.0 - 2.0 * (static_cast<double>(j) + 0.5) / static_cast<double>(height);
    const Vector far = unproject(x, y, 1.0), origin = perspective_ ? eye_ : unproject(x, y, -1.0);
    double length = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) length += (far[axis] - origin[axis]) * (far[axis] - origin[axis]);
    length = std::sqrt(length);
    Focus::Image::PointType begin, oneMm;
    for (unsigned axis = 0; axis < 3; ++axis) {
      begin[axis] = origin[axis];
      oneMm[axis] = origin[axis] + (far[axis] - origin[axis]) / length;
    }
    const auto a = focus_.image->TransformPhysicalPointToContinuousIndex<double>(begin);
    const auto b = focus_.image->TransformPhysicalPointToContinuousIndex<double>(oneMm);
    Ray result;
    for (unsigned axis = 0; axis < 3; ++axis) {
      result.origin[axis] = a[axis];
      result.direction[axis] = b[axis] - a[axis];
      result.voxelsPerMm += result.direction[axis] * result.direction[axis];
    }
    result.voxelsPerMm = std::sqrt(result.voxelsPerMm);
    return result;
  }

  std::size_t width = 0, height = 0;

 private:
  Vector unproject(double x, double y, double z) const {
    const auto world = worldFromClip_ * vnl_vector_fixed<double, 4>(x, y, z, 1.0);
    return {world[0] / world[3], world[1] / world[3], world[2] / world[3]};
  }

  const Focus& focus_;
  bool perspective_ = true;
  Vector eye_{};
  vnl_matrix_fixed<double, 4, 4> worldFromClip_;
};

struct Span {
  double tIn = 0.0, tOut = infinity;
};

/// Inside the voxels' extents, t ≥ 0.
std::optional<Span> boxSpan(const Ray& ray, const std::array<int, 3>& dims) {
  Span span;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = -0.5 - ray.origin[axis], high = dims[axis] - 0.5 - ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0.0) {
      if (low > 0.0 || high < 0.0) return {};
    } else {
      span.tIn = std::max(span.tIn, std::min(low / d, high / d));
      span.tOut = std::min(span.tOut, std::max(low / d, high / d));
    }
  }
  if (span.tIn > span.tOut) return {};
  return span;
}

// ---- the focus along a ray ------------------------------------------------------------------------------------------

class FocusField {
 public:
  FocusField(const Focus& focus, const Ray& ray) : focus_(focus), ray_(ray) {}

  struct Sample {
    double value = 0.0;     ///< the interpolated indicator
    double gradient = 0.0;  ///< its length, per voxel
    /// How far inside the 0.5 level this is, in voxels, to first order; negative outside.
    double depth() const { return value == 0.5 ? 0.0 : (value - 0.5) / gradient; }
  };

  Sample at(double t) const {
    std::array<int, 3> cell{};
    std::array<double, 3> f{};
    locate(t, cell, f);
    Sample sample;
    Vector gradient{};
    for (int corner = 0; corner < 8; ++corner) {
      std::array<int, 3> voxel{};
      std::array<double, 3> weight{}, slope{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool upper = corner >> axis & 1;
        voxel[axis] = std::min(cell[axis] + (upper ? 1 : 0), focus_.dims[axis] - 1);
        weight[axis] = upper ? f[axis] : 1.0 - f[axis];
        slope[axis] = upper ? 1.0 : -1.0;
      }
      if (!focus_.inside[focus_.offset(voxel[0], voxel[1], voxel[2])]) continue;
      sample.value += weight[0] * weight[1] * weight[2];
      gradient[0] += slope[0] * weight[1] * weight[2];
      gradient[1] += weight[0] * slope[1] * weight[2];
      gradient[2] += weight[0] * weight[1] * slope[2];
    }
    sample.gradient = std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2]);
    return sample;
  }

  /// The next t worth sampling: a small step, or past a cell that holds nothing of the focus.
  double next(double t) const {
    const double step = sampleStep / ray_.voxelsPerMm;
    std::array<int, 3> cell{};
    std::array<double, 3> f{};
    locate(t, cell, f);
    if (focus_.mayHoldFocus[focus_.offset(cell[0], cell[1], cell[2])]) return t + step;
    double exit = infinity;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = ray_.direction[axis];
      if (d == 0.0) continue;
      // Border cells go on to the box's faces and beyond.
      if (d > 0.0 && cell[axis] < focus_.dims[axis] - 2)
        exit = std::min(exit, (cell[axis] + 1 - ray_.origin[axis]) / d);
      if (d < 0.0 && cell[axis] > 0) exit = std::min(exit, (cell[axis] - ray_.origin[axis]) / d);
    }
    return std::max(exit, t) + 0.1 * step;
  }

 private:
  void locate(double t, std::array<int, 3>& cell, std::array<double, 3>& f) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double last = focus_.dims[axis] - 1;
      const double position = std::clamp(ray_.origin[axis] + t * ray_.direction[axis], 0.0, last);
      cell[axis] = std::min(static_cast<int>(position), std::max(focus_.dims[axis] - 2, 0));
      f[axis] = position - cell[axis];
    }
  }

  const Focus& focus_;
  const Ray& ray_;
};

/// Where a ray first meets the focus, and where it is inside it by more than the tolerance.
struct Truth {
  std::optional<double> entry, deep;
};

Truth follow(const FocusField& field, Span span) {
  Truth truth;
  double before = span.tIn;
  for (double t = span.tIn;; t = std::min(field.next(t), span.tOut)) {
    const FocusField::Sample sample = field.at(t);
    if (sample.value >= 0.5 && !truth.entry) {
      double outside = before, inside = t;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (outside + inside);
        (field.at(middle).value >= 0.5 ? inside : outside) = middle;
      }
      truth.entry = inside;
    }
    if (sample.value > 0.5 && sample.depth() > hitTolerance) {
      truth.deep = t;
      return truth;
    }
    if (t >= span.tOut) return truth;
    before = t;
  }
}

// ---- checks ---------------------------------------------------------------------------------------------------------

class Errors {
 public:
  void add(double error) { values_.push_back(error); }
  void append(const Errors& other) { values_.insert(values_.end(), other.values_.begin(), other.values_.end()); }
  Json summary() {
    std::sort(values_.begin(), values_.end());
    const auto at = [&](double share) {
      return values_.empty() ? Json()
                             : Json(values_[static_cast<std::size_t>(share * static_cast<double>(values_.size() - 1))]);
    };
    return {{"count", values_.size()}, {"median", at(0.5)}, {"p99.9", at(0.999)}, {"max", at(1.0)}};
  }

 private:
  std::vector<double> values_;
};

/// Counted by name, so that the summary says what was wrong and how often; the first pixel of each helps to look.
class Violations {
 public:
  void add(const std::string& what, std::size_t i, std::size_t j) {
    auto& entry = found_[what];
    if (entry.is_null()) entry = {{"count", 0}, {"first_pixel", {i, j}}};
    entry["count"] = entry["count"].get<std::size_t>() + 1;
  }
  void append(const Violations& other) {
    for (const auto& [what, entry] : other.found_) {
      auto& mine = found_[what];
      if (mine.is_null())
        mine = entry;
      else
        mine["count"] = mine["count"].get<std::size_t>() + entry["count"].get<std::size_t>();
    }
  }
  bool empty() const { return found_.empty(); }
  Json summary() const { return found_.empty() ? Json::object() : Json(found_); }

 private:
  std::map<std::string, Json> found_;
};

struct Layers {
  Layer tContext, tFocus, tFocusFilled, tStart, distance;
};

struct Findings {
  Errors hit, hitAlongRay, distance, start;
  Violations violations;
  std::size_t focusPixels = 0, missedGrazes = 0;

  void append(const Findings& other) {
    hit.append(other.hit);
    hitAlongRay.append(other.hitAlongRay);
    distance.append(other.distance);
    start.append(other.start);
    violations.append(other.violations);
    focusPixels += other.focusPixels;
    missedGrazes += other.missedGrazes;
  }
};

struct Widths {
  double open = 24.0, border = 2.0;
};

class Checker {
 public:
  Checker(const Focus& focus, const RayCamera& camera, const Layers& layers, Widths widths)
      : focus_(focus), camera_(camera), layers_(layers), widths_(widths), width_(camera.width), height_(camera.height) {
    for (std::size_t i = 0; i < layers.tFocus.pixels.size(); ++i) {
      const double t = layers.tFocus.pixels[i];
      if (std::isnan(t)) continue;
      leastKnown_ = std::min(leastKnown_, t);
      greatestKnown_ = std::max(greatestKnown_, t);
    }
    nearestInColumn();
  }

  Findings run() {
    Findings all;
    std::mutex mutex;
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::thread> threads;
    for (std::size_t core = 0; core < cores; ++core)
      threads.emplace_back([&, core] {
        Findings mine;
        for (std::size_t j = core; j < height_; j += cores)
          for (std::size_t i = 0; i < width_; ++i) checkPixel(i, j, mine);
        const std::scoped_lock lock(mutex);
        all.append(mine);
      });
    for (std::thread& thread : threads) thread.join();
    return all;
  }

 private:
  void checkPixel(std::size_t i, std::size_t j, Findings& findings) const {
    const std::size_t pixel = j * width_ + i;
    const Ray ray = camera_.ray(i, j);
    const std::optional<Span> span = boxSpan(ray, focus_.dims);
    const auto report = [&](const char* what) { findings.violations.add(what, i, j); };
    checkHit(pixel, ray, span, findings, report);
    const double exact = exactDistance(i, j);
    checkDistance(pixel, exact, findings, report);
    checkFill(pixel, exact, report);
    checkStart(pixel, exact, ray, span, findings, report);
  }

  template <class Report>
  void checkHit(std::size_t pixel, const Ray& ray, const std::optional<Span>& span, Findings& findings,
                const Report& report) const {
    const double tFocus = layers_.tFocus.pixels[pixel], tContext = layers_.tContext.pixels[pixel];
    const bool hit = !std::isnan(tFocus);
    if (hit) ++findings.focusPixels;
    if (hit && !(tContext <= tFocus)) report("context behind the focus");
    if (!span) {
      if (hit || !std::isnan(tContext)) report("hit on a ray that misses the volume");
      return;
    }
    const double slack = hitTolerance / ray.voxelsPerMm;
    if (!std::isnan(tContext) && !(tContext >= span->tIn - slack && tContext <= span->tOut + slack))
      report("context outside the volume");
    const FocusField field(focus_, ray);
    const Truth truth = follow(field, *span);
    if (!hit) {
      if (truth.deep)
        report("missed hit");
      else if (truth.entry)
        ++findings.missedGrazes;
      return;
    }
    // Along the ray, or across the surface where the ray grazes it.
    const double along = truth.entry ? std::abs(tFocus - *truth.entry) * ray.voxelsPerMm : infinity;
    const double error = std::min(along, std::abs(field.at(tFocus).depth()));
    findings.hit.add(error);
    if (truth.entry) findings.hitAlongRay.add(along);
    if (!(error <= hitTolerance)) report("hit off the 0.5 level");
    if (truth.deep && tFocus > *truth.deep + slack) report("focus before the hit");
  }

  template <class Report>
  void checkDistance(std::size_t pixel, double exact, Findings& findings, const Report& report) const {
    const double written = layers_.distance.pixels[pixel];
    if (std::isinf(written) && written > 0.0) {
      if (exact <= widths_.open + widths_.border - distanceTolerance) report("distance left out within its range");
      return;
    }
    const double error = std::abs(written - exact);
    findings.distance.add(error);
    if (!(error <= distanceTolerance)) report("wrong distance");
  }

  template <class Report>
  void checkFill(std::size_t pixel, double exact, const Report& report) const {
    const float known = layers_.tFocus.pixels[pixel], filled = layers_.tFocusFilled.pixels[pixel];
    if (!std::isnan(known)) {
      if (std::memcmp(&known, &filled, sizeof known) != 0) report("fill changed a known pixel");
      return;
    }
    const bool needed = !std::isnan(layers_.tContext.pixels[pixel]) && exact <= widths_.open;
    if (std::isnan(filled)) {
      if (needed) report("hole in the fill");
      return;
    }
    // Means of means: between the least and the greatest known t, but for float32's rounding.
    const double rounding = 1e-6 * greatestKnown_;
    if (!(filled >= leastKnown_ - rounding && filled <= greatestKnown_ + rounding)) report("fill beyond known values");
  }

  template <class Report>
  void checkStart(std::size_t pixel, double exact, const Ray& ray, const std::optional<Span>& span, Findings& findings,
                  const Report& report) const {
    const double tStart = layers_.tStart.pixels[pixel], tContext = layers_.tContext.pixels[pixel];
    const double tFocus = layers_.tFocus.pixels[pixel], filled = layers_.tFocusFilled.pixels[pixel];
    if (std::isnan(tContext) != std::isnan(tStart)) report("ray start without a hit, or a hit without one");
    if (std::isnan(tContext) || std::isnan(tStart) || !span) return;
    double expected = tContext;
    if (!std::isnan(tFocus))
      expected = tFocus;
    else if (widths_.open > 0.0 && exact <= widths_.open)
      expected = filled + (tContext - filled) * exact / widths_.open;
    expected = std::max(tContext, std::min(expected, std::max(span->tOut, tContext)));
    const double error = std::abs(tStart - expected) * ray.voxelsPerMm;
    findings.start.add(error);
    if (!(error <= startTolerance)) report("ray start off the formula");
  }

  void nearestInColumn() {
    column_.assign(width_ * height_, infinity);
    for (std::size_t i = 0; i < width_; ++i)
      for (std::size_t j = 0; j < height_; ++j) {
        if (std::isnan(layers_.tFocus.pixels[j * width_ + i])) continue;
        for (std::size_t other = 0; other < height_; ++other) {
          double& nearest = column_[other * width_ + i];
          nearest = std::min(nearest, std::abs(static_cast<double>(other) - static_cast<double>(j)));
        }
      }
  }

  double exactDistance(std::size_t i, std::size_t j) const {
    double squared = infinity;
    for (std::size_t k = 0; k < width_; ++k) {
      const double across = static_cast<double>(k) - static_cast<double>(i), along = column_[j * width_ + k];
      squared = std::min(squared, across * across + along * along);
    }
    return std::sqrt(squared);
  }

  const Focus& focus_;
  const RayCamera& camera_;
  const Layers& layers_;
  Widths widths_;
  std::size_t width_, height_;
  double leastKnown_ = infinity, greatestKnown_ = -infinity;
  std::vector<double> column_;  ///< px to the nearest focus pixel of the same column
};

// ---- the program ----------------------------------------------------------------------------------------------------

struct Arguments {
  fs::path image, labelMap, layers;
  std::set<int> labels;
  Widths widths;
};

Arguments parse(const std::vector<std::string>& words) {
  const char* usage = "usage: layers-check IMAGE LABELS --labels 2,3 LAYERS_DIR [--w-open PX] [--w-border PX]";
  Arguments arguments;
  std::vector<std::string> paths;
  try {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto value = [&] { return words.at(++i); };
      if (words[i] == "--labels") {
        std::istringstream list(value());
        for (std::string label; std::getline(list, label, ',');) arguments.labels.insert(std::stoi(label));
      } else if (words[i] == "--w-open") {
        arguments.widths.open = std::stod(value());
      } else if (words[i] == "--w-border") {
        arguments.widths.border = std::stod(value());
      } else {
        paths.push_back(words[i]);
      }
    }
  } catch (const std::logic_error&) {  // a word is missing, or is no number
    throw Unusable(usage);
  }
  if (paths.size() != 3 || arguments.labels.empty()) throw Unusable(usage);
  arguments.image = paths[0];
  arguments.labelMap = paths[1];
  arguments.layers = paths[2];
  return arguments;
}

bool check(const Arguments& arguments) {
  const Focus focus = readFocus(arguments.labelMap, arguments.labels);
  requireSameGrid(arguments.image, focus);
  const RayCamera camera(arguments.layers / "camera.json", focus);
  const auto layer = [&](const char* name) {
    Layer read = readLayer(arguments.layers, name);
    if (read.width != camera.width || read.height != camera.height)
      throw Unusable(std::string(name) + ": its size is not camera.json's");
    return read;
  };
  const Layers layers{layer("t_context"), layer("t_focus"), layer("t_focus_filled"), layer("t_start"),
                      layer("distance")};
  Findings findings = Checker(focus, camera, layers, arguments.widths).run();
  const bool passed = findings.violations.empty();
  const Json summary{
      {"size", {camera.width, camera.height}},
      {"focus_pixels", findings.focusPixels},
      {"hit_error_voxels", findings.hit.summary()},
      {"hit_error_along_ray_voxels", findings.hitAlongRay.summary()},
      {"missed_grazes", findings.missedGrazes},
      {"distance_error_px", findings.distance.summary()},
      {"start_error_voxels", findings.start.summary()},
      {"violations", findings.violations.summary()},
      {"passed", passed},
  };
  std::cout << summary.dump(2) << "\n";
  return passed;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return check(parse({argv + 1, argv + argc})) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "layers-check: " << error.what() << "\n";
    return 2;
  }
}
