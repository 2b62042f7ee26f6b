#include "rendering/gpu/RayFrame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "rendering/gpu/RefinedVolume.h"

namespace fenestra {

ClipUniforms Clip::uniforms(const Grid& grid) const {
  ClipUniforms uniforms;
  uniforms.planes.fill({0.0f, 0.0f, 0.0f, 1.0f});
  uniforms.normals.fill(glm::vec4(0.0f));
  const glm::dmat3 worldFromIndex(grid.worldFromIndex());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const glm::dvec3 inCells = glm::transpose(worldFromIndex) * kept[i].normal;
    const double atOrigin = kept[i].distance(grid.origin) - glm::dot(inCells, glm::dvec3(1.0));
    uniforms.planes[i] = glm::vec4(glm::dvec4(inCells, atOrigin));
    uniforms.normals[i] = glm::vec4(glm::dvec4(kept[i].normal, 0.0));
  }
  if (grey) uniforms.grey = glm::vec2(*grey);
  return uniforms;
}

RayFrame::RayFrame(const Camera& camera, glm::ivec2 size, const Grid& grid, Clip clip, int refinement)
    : size_(size), camera_(camera), grid_(grid), clip_(std::move(clip)), refinement_(refinement), axes_(camera.axes()) {
  const double depth = depthOf(grid.centre());
  const double aspect = static_cast<double>(size.x) / size.y;
  if (perspective()) {
    // Never nearer than the volume's own size, or the directions of the rays would lose digits.
    distance_ = std::max(depth, std::max(grid.boundingRadius(), 1e-9));
    const double halfHeight = distance_ * std::tan(glm::radians(camera.verticalFov) * 0.5);
    halfSize_ = {halfHeight * aspect, halfHeight};
  } else {
    distance_ = depth;
    halfSize_ = glm::dvec2(aspect, 1.0) * (camera.orthographicHeight * 0.5);
  }
}

void RayFrame::setUniforms(gl::ShaderProgram& program) const {
  const Grid grid = refinement_ > 1 ? refined(grid_, refinement_) : grid_;
  const glm::dmat4 indexFromWorld = grid.indexFromWorld();
  const glm::dmat3 worldFromView(axes_.right, axes_.up, axes_.forward);
  const glm::dvec3 anchor = glm::dvec3(indexFromWorld * glm::dvec4(camera_.eye + axes_.forward * distance_, 1.0)) + 1.0;
  program.set(RayUniforms{Std140Mat3(glm::mat3(glm::dmat3(indexFromWorld) * worldFromView)),
                          Std140Mat3(glm::mat3(worldFromView)), glm::vec3(anchor), static_cast<float>(distance_),
                          glm::vec2(halfSize_), perspective() ? glm::vec2(halfSize_) : glm::vec2(0.0f),
                          perspective() ? static_cast<float>(distance_) : 1.0f, size_});
  program.set(VolumeUniforms{grid.dims});
  if (isClipped()) program.set(clip_.uniforms(grid));
  if (scatter_) scatter_->bind(program);
}

glm::dmat4 RayFrame::worldFromCells() const {
  const Grid grid = refinement_ > 1 ? refined(grid_, refinement_) : grid_;
  return glm::translate(grid.worldFromIndex(), glm::dvec3(-1.0));
}

void Scatter::bind(gl::ShaderProgram& program) const {
  list->bind(binding);
  program.set("firstEdge", first);
  program.set("edgeCount", count);
}

RayFrame RayFrame::scattered(const Scatter& scatter) const {
  RayFrame frame = *this;
  frame.scatter_ = scatter;
  return frame;
}

OpeningCameraUniforms RayFrame::seenFrom(const RayFrame& other) const {
  const glm::dmat3 viewFromWorld = glm::transpose(glm::dmat3(axes_.right, axes_.up, axes_.forward));
  const auto anchor = [](const RayFrame& frame) { return frame.camera_.eye + frame.axes_.forward * frame.distance_; };
  constexpr double nearest = 1e-3;  // of the way from the eye to the anchor plane
  return {Std140Mat3(glm::mat3(viewFromWorld)),
          glm::vec3(viewFromWorld * (anchor(other) - anchor(*this))),
          perspective() ? static_cast<float>(1.0 / distance_) : 0.0f,
          glm::vec2(halfSize_),
          size_,
          static_cast<float>(distance_ * (perspective() ? nearest - 1.0 : -1.0))};
}

glm::dvec3 RayFrame::worldPosition(glm::dvec2 pixel, double s) const {
  const glm::dvec2 ndc(2.0 * pixel.x / size_.x - 1.0, 1.0 - 2.0 * pixel.y / size_.y);
  const glm::dvec2 offset = ndc * halfSize_;
  if (!perspective())
    return camera_.eye + axes_.right * offset.x + axes_.up * offset.y + axes_.forward * (distance_ + s);
  const glm::dvec3 direction = glm::normalize(axes_.right * offset.x + axes_.up * offset.y + axes_.forward * distance_);
  return camera_.eye + direction * (distance_ + s);
}

glm::dvec3 RayFrame::worldPositionAtDepth(glm::dvec2 pixel, double depth) const {
  const glm::dvec2 ndc(2.0 * pixel.x / size_.x - 1.0, 1.0 - 2.0 * pixel.y / size_.y);
  const glm::dvec2 offset = ndc * halfSize_ * (perspective() ? depth / distance_ : 1.0);
  return camera_.eye + axes_.right * offset.x + axes_.up * offset.y + axes_.forward * depth;
}

glm::dvec2 RayFrame::pixelOf(glm::dvec3 world) const {
  const glm::dvec3 from = world - camera_.eye;
  const glm::dvec2 halfSize = halfSize_ * (perspective() ? depthOf(world) / distance_ : 1.0);
  const glm::dvec2 ndc = glm::dvec2(glm::dot(from, axes_.right), glm::dot(from, axes_.up)) / halfSize;
  return glm::dvec2(0.5 * (1.0 + ndc.x), 0.5 * (1.0 - ndc.y)) * glm::dvec2(size_);
}

double RayFrame::pixelSize(double depth) const {
  return 2.0 * halfSize_.y * (perspective() ? depth / distance_ : 1.0) / size_.y;
}

double RayFrame::depthOf(glm::dvec3 world) const { return glm::dot(world - camera_.eye, axes_.forward); }

gl::Region RayFrame::around(const IndexBox& box, double reach) const {
  const glm::dvec3 low = glm::dvec3(box.low) - 1.0, high = glm::dvec3(box.high) + 1.0;
  const glm::dmat4 worldFromIndex = grid_.worldFromIndex();
  const glm::dvec2 size(size_);
  glm::dvec2 first(size), last(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 world(worldFromIndex * glm::dvec4(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                                       corner & 4 ? high.z : low.z, 1.0));
    if (!(depthOf(world) > 0.0)) return {glm::ivec2(0), size_};  // it reaches behind the eye
    const glm::dvec2 pixel = pixelOf(world);
    first = glm::min(first, pixel - reach);
    last = glm::max(last, pixel + reach);
  }
  const glm::ivec2 origin(glm::clamp(glm::floor(first), glm::dvec2(0.0), size));
  return {origin, glm::max(glm::ivec2(glm::clamp(glm::ceil(last), glm::dvec2(0.0), size)) - origin, 0)};
}

}  // namespace fenestra
