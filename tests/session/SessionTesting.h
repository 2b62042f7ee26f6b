#pragma once
// A session in which no member has its default, for tests that all of them come back.

#include "io/session/Session.h"

namespace fenestra::tests {

inline Camera someCamera(double seed) {
  Camera camera;
  camera.projection = seed > 1.5 ? Projection::Orthographic : Projection::Perspective;
  camera.eye = {seed * 0.1, -1.0 / 3.0, 1e-17};
  camera.target = {-0.0, seed, 123456.789012345678};
  camera.up = {0.6, 0.0, 0.8};
  camera.verticalFov = 31.7 + seed;
  camera.orthographicHeight = 99.1 * seed;
  return camera;
}

inline BrushStroke someStroke(BrushMode mode, std::size_t anchors = 3) {
  BrushStroke stroke;
  stroke.mode = mode;
  for (std::size_t i = 0; i < anchors; ++i) stroke.anchors.emplace_back(0.1 * static_cast<double>(i), -7.3, 1.0 / 7.0);
  stroke.radius = 6.28;
  stroke.softness = 0.125;
  stroke.depth = 0.3;
  stroke.amount = 0.9;
  stroke.toSurface = stroke.coversFocus = stroke.hidden = true;
  stroke.view = 1;
  return stroke;
}

inline Removal someRemoval(RemovalShape shape) {
  Removal removal;
  removal.shape = shape;
  removal.points = {{0.1, -7.3, 1.0 / 7.0}, {12.5, 0.0, -0.0}};
  removal.size = 3.3;
  removal.sides = {1.5, 2.25, 1.0 / 3.0};
  removal.direction = {0.6, 0.0, -0.8};
  removal.up = {0.0, -1.0, 0.1};
  removal.depth = 41.5;
  removal.extent = 77.7;
  removal.softness = 0.7;
  removal.bends = {{{1.0, 2.0, 1.0 / 3.0}, -4.5, 12.25}, {{0.0, 0.1, 0.2}, 1e-3, 5.0}};
  return removal;
}

/// Every member differs from its default. `folder` holds the data, by name.
inline io::Session fullSession(const std::filesystem::path& folder) {
  const io::Contents contents{"sha256:" + std::string(64, 'a'), 1234567890123, 245};
  io::Session session;
  session.volume.path = folder / "study";
  session.volume.contents = contents;
  session.volume.series = "sha256:" + std::string(64, '0');
  session.volume.time = 3;
  session.volume.raw =
      io::RawDescription{{3, 4, 5}, ScalarType::Int32, true, std::size_t{1} << 40, {0.1, 0.2, 0.30000000000000004}};
  session.volume.spacing = glm::dvec3(0.01, 0.02, 1.0 / 3.0);
  session.volume.regularise = io::Regularise::Cubic;
  session.volume.modality = Modality::CT;
  session.labels.path = folder / "labels.nii.gz";
  session.labels.contents = contents;
  session.labels.table = folder / "names.ctbl";
  session.look.focus = ValueFocus{{-1000.5, 3071.0}, 12.5};
  session.look.labels = {
      {2, LabelRole::Hidden, false, 1.0 / 3.0, glm::dvec3(0.1, 0.0, 1.0), {}, 3},
      {65535, LabelRole::Protected, true, 0.0, {}, TransferFunction{{{42.0, {{0.1, 0.9, 0.0}, 0.7}}}}, 0}};
  session.look.focusAppearance = {
      {0.1, 0.2, 0.3},
      1.0 / 3.0,
      TransferFunction{{{-7.5, {{0.3, 0.2, 0.1}, 0.0}}, {1.0 / 3.0, {{1.0, 0.0, 1.0}, 2.5}}}}};
  session.look.context.file = folder / "mine.json";
  session.look.context.function.nodes = {{-0.1, {{0.9, 0.8, 0.7}, 0.0}},
                                         {300.0, {{0.0, 1.0, 0.5}, 13.815510557964274}}};
  session.look.context.shift = -17.25;
  Method& method = session.look.method;
  method = methods::Importance{
      .mode = ImportanceMode::Average, .angle = 22.25, .opacity = 0.125, .sparseness = Sparseness::ScreenDoor};
  method.of<methods::Cone>() = {41.5};
  method.of<methods::ClearView>() = {LensFade::Depth, LensPlace::OverCrosshair, 33.5, 2.25, 12.5};
  method.of<methods::ContextPreserving>() = {4.25, 0.75};
  method.of<methods::FocalRegion>() = {FocalShape::Box, 12.25, 7.5};
  method.of<methods::Walls>() = {WallPlacement::Inside, false, false, false, false};
  method.of<methods::Explode>() = {0.125, ExplosionPlanes::Three, ExplosionAxes::View};
  method.of<methods::Selection>() = {0.625, 17.5, 0.875};
  method.of<methods::Peel>() = {0.375, PeelSide::Inferior, -22.5, 0.25, 12.5, 7.25};
  method.of<methods::Mip>() = {3.25};
  session.look.cutaway = {false, 31.0, 0.5, WidthUnit::Millimetre, {0.3, 0.2, 0.1}, 22.5, -135.0};
  session.look.contextLayer = {.strength = 0.25,
                               .curvatureWeight = 2.0,
                               .silhouetteWeight = 0.75,
                               .illuminationWeight = 0.5,
                               .valueWeight = 0.1,
                               .saturation = 0.45,
                               .share = 0.35,
                               .colour = {1.0, 0.0, 0.1}};
  session.look.shading = {false, 0.1, 0.2, 0.4, 7.0, 33.3, -12.5, 0.35, 0.85};
  session.look.background = {0.05, 0.06, 0.07};
  session.look.backdrop = Backdrop::Gradient;
  session.look.backgroundTop = {0.5, 0.6, 0.7};
  session.look.hideTable = false;
  session.look.reconstruction = Reconstruction::Smooth;
  session.look.labelSmoothing = LabelSmoothing::Strong;
  session.look.edges = Edges::Smooth;
  session.look.strokes = {someStroke(BrushMode::Open), someStroke(BrushMode::Fade, 1),
                          someStroke(BrushMode::Strengthen)};
  session.look.clipping = {true,
                           {{-31.5, 1.0 / 3.0, -1e3}, {77.0, 0.5, 12.25}},
                           {{{0.6, 0.0, -0.8}, -17.0}, {{0.0, 1.0, 0.0}, 0.1}},
                           {3, 65535},
                           WindowLevel{400.0, 40.5}};
  session.look.removals = {someRemoval(RemovalShape::Saw), someRemoval(RemovalShape::Box),
                           someRemoval(RemovalShape::Plane)};
  session.quality = Quality::High;
  session.maxError = 1.5;
  session.views = {
      io::SessionView{someCamera(1.0), {640, 481}, 1.25, false},
      io::SessionView{someCamera(2.0), {799, 600}, 2.0, false, OpeningView{someCamera(0.25), {321, 123}, 1.5}}};
  session.home = {someCamera(3.0), someCamera(0.5)};
  session.linked = false;
  session.followsPath = true;
  session.window = WindowLevel{401.5, -39.25};
  session.inverted = true;
  session.crosshair = glm::dvec3(-0.0, 1e-300, 33.3);
  session.overlays = {false, false, false, false, true};
  session.planes = {
      io::SessionPlane{{}, io::PlaneFollow::None, {12.5, SlabMode::Mean}},
      io::SessionPlane{PlaneAxes{{0.6, 0.8, 0.0}, {0.0, 0.0, -1.0}, {0.8, -0.6, 0.0}}, io::PlaneFollow::None, {}},
      io::SessionPlane{PlaneAxes{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, io::PlaneFollow::C2, {5.0, SlabMode::Minimum}}};
  session.measures = {
      {MeasureKind::Angle, {{1.5, -2.25, 1.0 / 3.0}, {0.0, 7.0, 1e-9}, {-3.0, 0.1, 12.0}}, {0, 1, 0}, {0, 0, -1}},
      {MeasureKind::Ellipse, {{10.0, 20.0, 30.0}, {11.0, 22.0, 30.0}}, {0.6, 0.8, 0}, {-0.8, 0.6, 0}},
      {MeasureKind::Arrow, {{1.0, 2.0, 3.0}, {4.0, 5.0, 3.0}}, {1, 0, 0}, {0, 1, 0}, "Läsion, \"?\""},
      {MeasureKind::Text, {{-1.0, 2.0, 3.0}}, {1, 0, 0}, {0, 1, 0}, "left"}};
  session.path = {{1.0 / 3.0, -4.0, 5.0}, {2.0, 0.1, 9.0}, {3.0, 0.0, 20.0}};
  session.keyImages.resize(2);
  session.keyImages[0].name = "Stenosis, \"proximal\" é";
  session.keyImages[0].picture = "iVBORw0KGgo=";
  session.keyImages[0].look = session.look;
  session.keyImages[0].views = {io::KeyView{session.views[0].camera, session.views[0].frozen},
                                io::KeyView{session.views[1].camera, session.views[1].frozen}};
  session.keyImages[0].window = {1.0 / 3.0, -7.0};
  session.keyImages[0].inverted = true;
  session.keyImages[0].crosshair = {1e-9, -2.0, 3.0};
  session.keyImages[0].planes = session.planes;
  session.keyImages[1].name = "2";
  session.maximised = "sagittal";
  session.layout = "AAECAw==";
  session.placement = {.samples = 588,
                       .refined = true,
                       .weights = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, -0.8},
                       .habits = placement::noHabits,
                       .inStream = true,
                       .streamHalfWidth = 22.5,
                       .shareWeight = 0.4,
                       .joint = false,
                       .follow = false,
                       .automatic = false,
                       .byPick = true,
                       .liveSync = {.weights = {0.25, 0.75, 1.25, 1.75}, .reach = 25.0}};
  session.autosaveOf = folder / "kept.fenestra";
  return session;
}

}  // namespace fenestra::tests
