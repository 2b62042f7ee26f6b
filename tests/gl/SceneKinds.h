#pragma once
// Small scenes that between them use every variant of every shader.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "rendering/Renderer.h"
#include "rendering/gl/Context.h"
#include "rendering/methods/Method.h"
#include "rendering/scene/FaintLabels.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests {

struct SceneKind {
  std::string name;
  Scene scene;
  View view;
};

template <class T>
Scene bodyWithOrgans(const Grid& grid) {
  Scene scene;
  const glm::dvec3 middle = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  scene.volume = volumeOf<T>(grid, [&](glm::ivec3 i) {
    const double r = glm::length((glm::dvec3(i) - middle) / middle);
    return std::clamp(120.0 * (1.1 - r) + 6.0 * std::sin(0.9 * i.x) * std::cos(0.7 * i.y + 0.5 * i.z), 0.0, 200.0);
  });
  const auto labels = labelsOf(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) - middle;
    return glm::length(p - glm::dvec3(3, 0, 0)) < 3.5 ? 1 : glm::length(p + glm::dvec3(4, 1, 0)) < 3.0 ? 2 : 0;
  });
  labels->labels = {{1, "one", {1.0, 0.4, 0.2}}, {2, "two", {0.2, 0.5, 1.0}}};
  scene.labels = labels;
  scene.look.context.function = {{{20.0, {glm::dvec3(0.8, 0.5, 0.4), 0.0}},
                                  {60.0, {glm::dvec3(0.9, 0.7, 0.6), 0.3}},
                                  {120.0, {glm::dvec3(1.0, 0.95, 0.9), 1.5}}}};
  scene.look.cutaway.openWidth = 6.0;
  return scene;
}

/// The focus of values, or of two labels the first, by value.
inline Scene byValue(Scene scene) {
  const TransferFunction function{
      {{60.0, {{1.0, 0.2, 0.1}, 0.0}}, {100.0, {{0.9, 0.9, 0.2}, 0.4}}, {100.0, {{0.1, 0.4, 1.0}, 1.5}}}};
  put(scene.look.labels, {.label = 1, .function = function});
  scene.look.focusAppearance.function = function;
  return scene;
}

/// Every kind of focus, with and without light, opening, edges and strokes, in every sampling.
template <class T>
void addSceneKinds(const std::string& type, std::vector<SceneKind>& kinds) {
  const Scene base = bodyWithOrgans<T>(gridOf({26, 24, 22}));
  const std::vector<std::pair<std::string, Focus>> focuses{{"no focus", std::monostate{}},
                                                           {"one label", LabelFocus{{1}}},
                                                           {"labels of two colours", LabelFocus{{1, 2}}},
                                                           {"values", ValueFocus{{95.0, 1000.0}, 0.0}}};
  const auto sampled = [&](Quality quality, std::optional<double> maxError) {
    View view{Camera::fromAngles(30.0, 20.0, base.volume->grid), {61, 53}, 1.0, quality};
    view.maxError = maxError;
    return view;
  };
  const std::vector<std::pair<std::string, View>> views{{"draft", sampled(Quality::Draft, {})},
                                                        {"normal", sampled(Quality::Normal, {})},
                                                        {"bound 8", sampled(Quality::Normal, 8.0)},
                                                        {"bound 0.5", sampled(Quality::Normal, 0.5)}};
  for (const auto& [focusName, focus] : focuses)
    for (const bool lit : {false, true})
      for (const bool open : {false, true})
        for (const auto& [viewName, view] : views) {
          Scene scene = base;
          scene.look.focus = focus;
          scene.look.shading.enabled = lit;
          scene.look.cutaway.enabled = open;
          kinds.push_back(
              {type + ", " + focusName + (lit ? ", lit" : ", unlit") + (open ? ", open, " : ", closed, ") + viewName,
               scene, view});
        }
}

inline Scene brushed(Scene scene) {
  BrushStroke stroke;
  stroke.mode = BrushMode::Restore;
  stroke.radius = 4.0;
  stroke.depth = 6.0;
  const Grid& grid = scene.volume->grid;
  stroke.anchors = {grid.centre() - glm::dvec3(0.0, 6.0, 0.0), grid.centre() + glm::dvec3(3.0, -6.0, 1.0)};
  scene.look.strokes = {stroke};
  return scene;
}

/// A body whose second organ is never cut away, unless it is in focus.
inline Scene withProtected(Scene scene) {
  put(scene.look.labels, {.label = 2, .role = LabelRole::Protected});
  return scene;
}

/// A body whose first organ is faint in the context, unless it is in focus; where it is, the second one is.
inline Scene withFaint(Scene scene) {
  put(scene.look.labels, {.label = 1, .opacity = 0.3});
  LabelSetting second = settingFor(scene.look.labels, 2);
  second.opacity = 0.6;
  put(scene.look.labels, second);
  return scene;
}

/// A body with ambient occlusion and shadows.
inline Scene occluded(Scene scene) {
  scene.look.shading.occlusion = 0.8;
  scene.look.shading.shadow = 0.7;
  return scene;
}

/// A body whose context changes several times within a cell, so that normal quality chooses a bound.
inline Scene steep(Scene scene) {
  scene.look.context.function.nodes.clear();
  for (int i = 0; i < 16; ++i)
    scene.look.context.function.nodes.push_back({20.0 + 7.0 * i, {{i % 2, 0.5, i % 3 / 2.0}, i % 2 ? 0.6 : 0.0}});
  return scene;
}

/// Every way of another method than the adaptive cutaway to open a body, by name.
inline std::vector<std::pair<std::string, Method>> otherMethods() {
  const auto average = [](Sparseness sparseness) {
    return methods::Importance{.mode = ImportanceMode::Average, .opacity = 0.3, .sparseness = sparseness};
  };
  // The bodies are small: lenses of several radii, whose lines run through the picture in different places.
  const auto lens = [](LensFade fade, double radius) {
    return methods::ClearView{.fade = fade, .radius = radius, .bends = 0.7, .rim = 8.0};
  };
  std::vector<std::pair<std::string, Method>> list{
      {"cone", methods::Cone{}},
      {"maximum importance", methods::Importance{}},
      {"average importance", average(Sparseness::Opacity)},
      {"ClearView", lens(LensFade::Distance, 45.0)},
      {"context-preserving", methods::ContextPreserving{}},
      {"focal sphere", methods::FocalRegion{.size = 7.0, .fallOff = 12.0}},
      {"walls around", methods::Walls{}},
      {"walls inside", methods::Walls{.placement = WallPlacement::Inside}},
      {"exploded", methods::Explode{.degree = 0.6, .planes = ExplosionPlanes::Three}},
      {"ghosted selection", methods::Selection{.strength = 0.9, .edge = 8.0, .outline = 0.6}},
      {"average importance, grey", average(Sparseness::Colour)},
      {"average importance, screen door", average(Sparseness::ScreenDoor)},
      {"ClearView, bends alone", lens(LensFade::Curvature, 25.0)},
      {"ClearView, with depth", lens(LensFade::Depth, 35.0)},
      {"focal box", methods::FocalRegion{.shape = FocalShape::Box, .size = 6.0, .fallOff = 9.0}},
      {"focal distance", methods::FocalRegion{.shape = FocalShape::Distance, .size = 3.0, .fallOff = 9.0}},
      {"exploded along the view", methods::Explode{.degree = 0.4, .axes = ExplosionAxes::View}},
      {"sculpting, with nothing carved", methods::Sculpt{}},
      {"peeled", methods::Peel{.amount = 0.7, .radius = 4.0, .margin = 2.0}}};
  // Others are here by being in the list of methods, but for those that open nothing without a user's hand.
  forEachMethod([&]<class M>() {
    const bool listed =
        std::any_of(list.begin(), list.end(), [](const auto& each) { return each.second.template is<M>(); });
    if (!listed && kindOf<M> != MethodKind{} && !carves(kindOf<M>)) list.push_back({M::word, M{}});
  });
  return list;
}

/// A body whose second organ is less important than the first one, in focus or not.
inline Scene levelled(Scene scene, ImportanceMode mode) {
  LabelSetting second = settingFor(scene.look.labels, 2);
  second.importance = 1;
  put(scene.look.labels, second);
  scene.look.method = methods::Importance{.mode = mode, .opacity = 0.3};
  return scene;
}

/// A body cut by a box and two planes, with faces in grey or as the transfer function shows them.
inline Scene clipped(Scene scene, bool grey) {
  const Grid& grid = scene.volume->grid;
  const CropFrame frame(grid);
  Clipping& clipping = scene.look.clipping;
  clipping.cropped = true;
  clipping.box = {frame.low + glm::dvec3(3.0, 2.0, 4.5), frame.high - glm::dvec3(4.0, 1.5, 3.0)};
  for (const glm::dvec3 normal : {glm::dvec3(0.3, 1.0, 0.2), glm::dvec3(-1.0, 0.2, 0.6)})
    clipping.planes.push_back(
        {glm::normalize(normal), glm::dot(glm::normalize(normal), grid.centre() - glm::dvec3(0.0, 3.0, 0.0))});
  if (grey) clipping.grey = WindowLevel{160.0, 80.0};
  return scene;
}

/// All kinds for one voxel type; every seventh for the others, whose shaders differ in how they read a voxel alone.
inline std::vector<SceneKind> allSceneKinds() {
  std::vector<SceneKind> kinds, others;
  addSceneKinds<std::int16_t>("int16", kinds);
  addSceneKinds<std::uint8_t>("uint8", others);
  addSceneKinds<float>("float", others);
  for (std::size_t i = 0; i < others.size(); i += 7) kinds.push_back(others[i]);
  // Unlit, in normal quality, with each kind of focus, opened and not in turns.
  for (const std::size_t i : {1u, 21u, 33u, 53u})
    kinds.push_back({kinds[i].name + ", steep", steep(kinds[i].scene), kinds[i].view});
  const std::size_t plain = kinds.size();
  for (std::size_t i = 0; i < plain; i += 5) {
    SceneKind spline = kinds[i];
    spline.name += ", spline";
    spline.scene.look.reconstruction = Reconstruction::Cubic;
    kinds.push_back(spline);
  }
  for (std::size_t i = 0, all = kinds.size(); i < all; i += 5) {
    if (!std::holds_alternative<LabelFocus>(kinds[i].scene.look.focus)) continue;
    SceneKind smoothed = kinds[i];
    smoothed.name += ", smoothed labels";
    smoothed.scene.look.labelSmoothing = LabelSmoothing::Strong;
    kinds.push_back(smoothed);
  }
  for (std::size_t i = 0; i < plain; i += 13) {
    if (!hasCutaway(kinds[i].scene)) continue;
    SceneKind withStroke = kinds[i];
    withStroke.name += ", brushed";
    withStroke.scene = brushed(withStroke.scene);
    kinds.push_back(withStroke);
    SceneKind guarded = withStroke;
    guarded.name += ", protected label";
    guarded.scene = withProtected(guarded.scene);
    kinds.push_back(guarded);
    SceneKind bare = withStroke;
    bare.name += ", no edges";
    bare.scene.look.contextLayer.strength = 0.0;
    kinds.push_back(bare);
    SceneKind thinned = withStroke;
    thinned.name += ", thinned edges";
    thinned.scene.look.contextLayer.share = 0.1;
    kinds.push_back(thinned);
    SceneKind parallel = kinds[i];
    parallel.name += ", orthographic";
    parallel.view.camera = Camera::fromAngles(-70.0, 35.0, parallel.scene.volume->grid, Projection::Orthographic);
    kinds.push_back(parallel);
  }
  for (std::size_t i = 0; i < plain; i += 9) {
    if (!hasCutaway(kinds[i].scene)) continue;
    SceneKind frozen = kinds[i];
    frozen.name += ", frozen";
    frozen.view.frozen = OpeningView{Camera::fromAngles(-10.0, 5.0, frozen.scene.volume->grid), {47, 58}, 1.0};
    kinds.push_back(frozen);
    SceneKind edited = frozen;
    edited.name += ", brushed, protected label";
    edited.scene = withProtected(brushed(edited.scene));
    kinds.push_back(edited);
    SceneKind bare = frozen;
    bare.name += ", no edges";
    bare.scene.look.contextLayer.strength = 0.0;
    kinds.push_back(bare);
  }
  // Both kinds of capped faces with what else makes a program another one.
  for (std::size_t i = 0, plainOrNot = kinds.size(); i < plainOrNot; i += 3) {
    kinds.push_back({kinds[i].name + ", clipped", clipped(kinds[i].scene, i % 2 == 0), kinds[i].view});
    if (i % 4 == 0) kinds.back().scene.look.clipping.exempt = {2};
  }
  // Each kind of focus, with light and without, opened and not, as a lattice and within a bound.
  for (std::size_t i = 0; i < plain; ++i)
    if (hasFocusFunction(byValue(kinds[i].scene)) && i % 4 % 3 == 0 && kinds[i].name.starts_with("int16"))
      kinds.push_back({kinds[i].name + ", by value", byValue(kinds[i].scene), kinds[i].view});
  for (std::size_t i = 0; i < plain; i += 5) {
    if (!hasCutaway(kinds[i].scene)) continue;
    SceneKind guarded = kinds[i];
    guarded.name += ", protected label";
    guarded.scene = withProtected(guarded.scene);
    kinds.push_back(guarded);
  }
  // Faint labels in the context with whatever else makes a program another one.
  for (std::size_t i = 0, all = kinds.size(); i < all; ++i)
    if (i % 9 == 0 && kinds[i].name.starts_with("int16") && !faintLabels(kinds[i].scene).any())
      if (Scene faint = withFaint(kinds[i].scene); faintLabels(faint).any())
        kinds.push_back({kinds[i].name + ", faint labels", std::move(faint), kinds[i].view});
  // Ambient occlusion and shadows with whatever else makes a program another one.
  for (std::size_t i = 0, all = kinds.size(); i < all; ++i)
    if (i % 7 == 0 && kinds[i].scene.look.shading.enabled)
      kinds.push_back({kinds[i].name + ", occlusion", occluded(kinds[i].scene), kinds[i].view});
  // Other methods, in turns, with whatever else makes a program another one.
  const auto methods = otherMethods();
  for (std::size_t i = 0, all = kinds.size(), next = 0; i < all; i += 7) {
    if (!hasCutaway(kinds[i].scene)) continue;
    const auto& [name, method] = methods[next++ % methods.size()];
    SceneKind other = kinds[i];
    other.name += ", " + name;
    other.scene.look.method = method;
    kinds.push_back(std::move(other));
  }
  // Levels of importance, in both modes in turns, with whatever else makes a program another one.
  for (std::size_t i = 0, all = kinds.size(), next = 0; i < all; i += 11) {
    if (!hasCutaway(kinds[i].scene) || !std::holds_alternative<LabelFocus>(kinds[i].scene.look.focus)) continue;
    const ImportanceMode mode = next++ % 2 ? ImportanceMode::Average : ImportanceMode::Maximum;
    kinds.push_back({kinds[i].name + ", levels, " + wordOf(mode).word, levelled(kinds[i].scene, mode), kinds[i].view});
  }
  // Walls need no focus, where they stand around the volume.
  for (std::size_t i = 0, all = kinds.size(); i < all; i += 11) {
    if (!kinds[i].scene.look.cutaway.enabled || hasCutaway(kinds[i].scene)) continue;
    kinds.push_back({kinds[i].name + ", walls around", kinds[i].scene, kinds[i].view});
    kinds.back().scene.look.method = methods::Walls{};
    kinds.back().view.slices = {.crosshair = glm::dvec3(5.0, 9.0, 14.0), .window = WindowLevel{90.0, 80.0}};
  }
  // A context that fades or is exploded needs no focus.
  for (std::size_t i = 0, all = kinds.size(); i < all; i += 5) {
    const Look& look = kinds[i].scene.look;
    if (!look.cutaway.enabled || !std::holds_alternative<std::monostate>(look.focus)) continue;
    const MethodKind kind =
        std::array{kindOf<methods::ContextPreserving>, kindOf<methods::FocalRegion>, kindOf<methods::Explode>}[i % 3];
    kinds.push_back({kinds[i].name + ", " + wordOf(kind).word, kinds[i].scene, kinds[i].view});
    kinds.back().scene.look.method = Method(kind);
    kinds.back().scene.look.method.of<methods::FocalRegion>().size = 8.0;
  }
  // Smooth edges with whatever else makes a program another one; drafts have none.
  for (std::size_t i = 0, all = kinds.size(); i < all; ++i)
    if (i % 6 == 0 && (kinds[i].view.quality != Quality::Draft || kinds[i].view.maxError)) {
      kinds.push_back({kinds[i].name + ", smooth edges", kinds[i].scene, kinds[i].view});
      kinds.back().scene.look.edges = Edges::Smooth;
    }
  return kinds;
}

}  // namespace fenestra::tests
