#pragma once
// Which files a program takes for a scene where its source says `#include <name>`, and which constants it is compiled
// with. Each function names what it chooses; the alternatives stand in rendering/shaders/lib/NAME.

#include <cstdint>
#include <optional>

#include "rendering/gl/ShaderSource.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra {

/// <grid>.
gl::Variant gridVariant(const GpuScene& scene);
/// <grid> and <volume>, with <voxels>: texels alone, which of a spline are samples.
gl::Variant sampledVariant(const GpuScene& scene);
/// <grid> and <volume>, with <voxels>: of a spline, the spline itself.
gl::Variant volumeVariant(const GpuScene& scene);
/// Where rays meet a volume that is a spline: the spline itself, or what lies between its samples (RefinedVolume.h),
/// trilinear, which takes two thirds of the time.
enum class HitSurface : std::uint8_t { Exact, Samples };
/// As volumeVariant(), for lib/FirstHit.glsl: also <look>.
gl::Variant searchVariant(const GpuScene& scene, HitSurface surface = HitSurface::Exact);
/// <derivative>.
gl::Choice derivativeChoice(const GpuScene& scene);

/// <translucent>: labels of the context, or none of them.
gl::Choice translucentChoice(const FaintIndex& faint);
gl::Choice opaqueChoice();

/// <focus>: the scene's focus, some labels in its place, or none.
gl::Choice focusChoice(const GpuScene& scene);
gl::Choice focusChoice(const KeptLabels& labels);
gl::Choice noFocusChoice();

/// How rays are integrated, and what they show.
struct IntegralKind {
  /// What `<focus>` holds: the scene's focus; labels that pictures keep, as parts of the context; or nothing.
  enum class Held : std::uint8_t { OfScene, KeptLabels, None };
  enum class Shown : std::uint8_t { All, ContextAlone, FocusAlone };

  bool lit = false;
  bool bounded = false;                    ///< within a bound on the error; else from face to face of the cells
  const gl::Texture* occlusion = nullptr;  ///< what OcclusionPass has written; null: no ambient occlusion, no shadows
  Held held = Held::OfScene;
  const FaintIndex* faint = nullptr;  ///< of kept labels; null: the scene's
  bool hasLevels = false;             ///< labels of other levels of importance than the focus's are opened to

  // Within a bound alone.
  Shown shown = Shown::All;
  std::optional<MethodStages::Fading> fading{};
  bool roughSteps = false;  ///< see lib/integral/FadingPart.glsl

  // From face to face alone.
  bool wholeCells = false;   ///< all corners of each cell are read: lib/segment/Cells.glsl
  bool bentNormals = false;  ///< see lib/integral/FocusParts.glsl
};
/// All that <integral> includes but <opening>, <clip> and <places>; with <integral>.
gl::Variant integralVariant(const GpuScene& scene, const IntegralKind& kind);

/// For lib/Transfer.glsl.
gl::Define tableDefine();

}  // namespace fenestra
