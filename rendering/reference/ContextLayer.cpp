#include "rendering/reference/ContextLayer.h"

#include "rendering/reference/Field.h"
#include "rendering/reference/Light.h"
#include "rendering/scene/ContextLines.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

/// Real values per mm below which a gradient is nothing but rounding.
constexpr double leastGradient = 1e-6;

double finestSpacing(const Grid& grid) { return std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z}); }

/// Voxels per element of the smoothed volume along each axis.
glm::ivec3 thinning(const Grid& grid) {
  glm::ivec3 factor;
  for (int axis = 0; axis < 3; ++axis)
    factor[axis] = grid.spacing[axis] < 2.0 * finestSpacing(grid) && grid.dims[axis] >= 8 ? 2 : 1;
  return factor;
}

/// A voxel's weights in the reconstruction and in its first and second derivative by the index.
struct Tap {
  int voxel;
  glm::dvec3 weights;
};

/// Smoothing, thinning and spline in one along an axis of `count` voxels, at the continuous index `at`.
std::vector<Tap> tapsAlong(double at, int factor, int count) {
  struct Binomial {
    int offset;
    double weight;
  };
  static const std::vector<Binomial> thin{{-1, 0.125}, {0, 0.375}, {1, 0.375}, {2, 0.125}}, plain{{0, 1.0}};
  const std::vector<Binomial>& binomial = factor == 2 ? thin : plain;
  const int elements = (count + factor - 1) / factor;
  // Element i is centred on index factor·i + (factor - 1)/2.
  const double position = (at - 0.5 * (factor - 1)) / factor, base = std::floor(position);
  std::vector<Tap> taps;
  for (int k = -1; k <= 2; ++k) {
    // Cubic B-spline around the element: with d the distance to it, 2/3 - d² + |d|³/2 within 1, (2 - |d|)³/6 within 2.
    const double d = position - (base + k), a = std::abs(d), side = d < 0.0 ? -1.0 : 1.0, rest = 2.0 - a;
    const glm::dvec3 spline =
        a < 1.0 ? glm::dvec3(2.0 / 3.0 - a * a * (1.0 - 0.5 * a), side * a * (1.5 * a - 2.0), 3.0 * a - 2.0)
                : glm::dvec3(rest * rest * rest / 6.0, -0.5 * side * rest * rest, rest);
    const glm::dvec3 weights = spline / glm::dvec3(1.0, factor, factor * factor);
    const int element = std::clamp(static_cast<int>(base) + k, 0, elements - 1);
    for (const Binomial& b : binomial)
      taps.push_back({std::clamp(factor * element + b.offset, 0, count - 1), b.weight * weights});
  }
  return taps;
}

/// 0 where the spline takes elements from beyond the ends of an axis, 1 from one element further in. An axis of fewer
/// than eight elements is near its ends everywhere; there it is 1.
double shareWithin(double at, int factor, int count) {
  const int elements = (count + factor - 1) / factor;
  if (elements < 8) return 1.0;
  const double position = (at - 0.5 * (factor - 1)) / factor;
  return std::clamp(std::min(position - 1.0, elements - 2.0 - position), 0.0, 1.0);
}

/// By the index.
struct Derivatives {
  glm::dvec3 gradient{0.0};
  glm::dmat3 hessian{0.0};
};

template <class ValueAt>
Derivatives derivativesAt(const Grid& grid, glm::ivec3 factor, glm::dvec3 index, const ValueAt& valueAt) {
  const std::vector<Tap> tx = tapsAlong(index.x, factor.x, grid.dims.x), ty = tapsAlong(index.y, factor.y, grid.dims.y),
                         tz = tapsAlong(index.z, factor.z, grid.dims.z);
  Derivatives sum;
  for (const Tap& z : tz)
    for (const Tap& y : ty) {
      glm::dvec3 row(0.0);  // the value and its derivatives along x
      for (const Tap& x : tx) row += valueAt({x.voxel, y.voxel, z.voxel}) * x.weights;
      const glm::dvec3 &v = y.weights, &w = z.weights;
      sum.gradient += glm::dvec3(row[1] * v[0] * w[0], row[0] * v[1] * w[0], row[0] * v[0] * w[1]);
      const double xy = row[1] * v[1] * w[0], xz = row[1] * v[0] * w[1], yz = row[0] * v[1] * w[1];
      sum.hessian +=
          glm::dmat3(row[2] * v[0] * w[0], xy, xz, xy, row[0] * v[2] * w[0], yz, xz, yz, row[0] * v[0] * w[2]);
    }
  return sum;
}

/// Curvatures of the level set with gradient g and Hessian H: the eigenvalues, along the tangent plane, of -H/|g| with
/// the sign for which a ball of high values is convex.
glm::dvec2 principalCurvatures(glm::dvec3 gradient, const glm::dmat3& hessian) {
  const double length = glm::length(gradient);
  const glm::dvec3 n = gradient / length;
  const glm::dvec3 across = std::abs(n.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(n, across)), v = glm::cross(n, u);
  const auto along = [&](glm::dvec3 a, glm::dvec3 b) { return -glm::dot(a, hessian * b) / length; };
  const double uu = along(u, u), uv = along(u, v), vv = along(v, v);
  const double mean = 0.5 * (uu + vv), spread = std::hypot(0.5 * (uu - vv), uv);
  return {mean + spread, mean - spread};
}

/// Curvature as a number without a unit.
double bendOf(const ContextPoint& point, double scale) {
  return std::sqrt(0.5 * (point.k1 * point.k1 + point.k2 * point.k2)) * scale;
}

}  // namespace

double derivativeSpacing(const Grid& grid) {
  const glm::dvec3 spacing = grid.spacing * glm::dvec3(thinning(grid));
  return std::min({spacing.x, spacing.y, spacing.z});
}

std::vector<std::optional<ContextPoint>> contextLayer(const Scene& scene, const Camera& camera,
                                                      const std::vector<Ray>& rays, const Image& tContext,
                                                      const Image& tFocus) {
  const Grid& grid = scene.volume->grid;
  const glm::ivec3 factor = thinning(grid);
  const double margin = 0.5 * finestSpacing(grid);
  const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, grid);
  const Light light(camera, scene.look.shading);
  const Field field(scene);
  const glm::dmat3 indexFromWorld(grid.indexFromWorld()), worldFromGradient = glm::transpose(indexFromWorld);
  std::vector<std::optional<ContextPoint>> layer(rays.size());

  withValues(shownVolume(scene), [&](auto valueAt) {
    parallelFor(rays.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::optional<Span> span = clip(rays[i], grid, kept);
        if (!span || !(tContext[i] > span->tIn + margin) || !(tContext[i] < tFocus[i] - margin)) continue;
        const Ray local = indexRay(rays[i], grid);
        const glm::dvec3 index = local.origin + tContext[i] * local.direction;
        const Derivatives derivatives = derivativesAt(grid, factor, index, valueAt);
        const glm::dvec3 gradient = worldFromGradient * derivatives.gradient;
        if (!(glm::length(gradient) > leastGradient)) continue;
        const glm::dvec2 k = principalCurvatures(gradient, worldFromGradient * derivatives.hessian * indexFromWorld);
        const glm::dvec3 normal = glm::normalize(gradient);
        const double within =
            std::min({shareWithin(index.x, factor.x, grid.dims.x), shareWithin(index.y, factor.y, grid.dims.y),
                      shareWithin(index.z, factor.z, grid.dims.z)});
        layer[i] =
            ContextPoint{within * k.x, within * k.y, light.incident(std::abs(glm::dot(normal, light.direction))),
                         field.value(index, valueAt), within * (1.0 - std::abs(glm::dot(normal, rays[i].direction)))};
      }
    });
  });
  return layer;
}

double strengthOf(const ContextLayer& look, const ContextPoint& point, double scale) {
  return lines::strength(look.curvatureWeight, look.silhouetteWeight, bendOf(point, scale), point.silhouette);
}

double contextOpacity(const ContextLayer& look, const ContextPoint& point, double scale, double factor,
                      double leastLine) {
  const double opacity = look.curvatureWeight * smoothstep(0.10, 0.40, bendOf(point, scale)) +
                         look.silhouetteWeight * smoothstep(0.30, 0.85, point.silhouette);
  const double shown = smoothstep(leastLine, leastLine + lines::fade, strengthOf(look, point, scale));
  return std::min(look.strength * std::clamp(opacity, 0.0, 1.0) * shown * factor, 1.0);
}

glm::dvec3 contextColour(const ContextLayer& look, const TransferFunction& context, const ContextPoint& point) {
  const glm::dvec3 own = context.evaluate(point.value).colour;
  // Luminance after ITU-R BT.709.
  const glm::dvec3 grey(glm::dot(own, glm::dvec3(0.2126, 0.7152, 0.0722)));
  return glm::mix(look.colour, glm::mix(grey, own, look.saturation), look.valueWeight) *
         glm::mix(1.0, point.illumination, look.illuminationWeight);
}

std::vector<glm::dvec3> contextNormals(const Scene& scene, const std::vector<Ray>& rays, const Image& tContext,
                                       const Image& tFocus) {
  const Grid& grid = scene.volume->grid;
  const glm::ivec3 factor = thinning(grid);
  const double margin = 0.5 * finestSpacing(grid);
  const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, grid);
  const glm::dmat3 worldFromGradient = glm::transpose(glm::dmat3(grid.indexFromWorld()));
  std::vector<glm::dvec3> normals(rays.size(), glm::dvec3(0.0));
  withValues(shownVolume(scene), [&](auto valueAt) {
    parallelFor(rays.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::optional<Span> span = clip(rays[i], grid, kept);
        if (!span || !(tContext[i] > span->tIn + margin) || tContext[i] >= tFocus[i] - margin) continue;
        const Ray local = indexRay(rays[i], grid);
        const glm::dvec3 index = local.origin + tContext[i] * local.direction;
        const glm::dvec3 gradient = worldFromGradient * derivativesAt(grid, factor, index, valueAt).gradient;
        if (glm::length(gradient) > leastGradient) normals[i] = glm::normalize(gradient);
      }
    });
  });
  return normals;
}

}  // namespace fenestra::reference
