#pragma once
// The picture of a 3-D view: drawn at once while something moves, and refined in slices of time while nothing does.
// The picture shown stays until a better one is done.

#include <array>
#include <memory>
#include <optional>

#include "rendering/Renderer.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra::viewer {

/// Needs a current context in every call, and when it is destroyed. Errors of the renderer pass through.
class RefinedPicture {
 public:
  explicit RefinedPicture(const std::shared_ptr<GpuScene>& gpuScene);

  /// Draws at once and shows the picture. Drops a picture that is being refined. The last picture at full quality is
  /// kept while others are shown, so that the next one at full quality can reuse parts of it.
  void draw(const Scene& scene, const View& view, bool full);
  /// Starts a picture beside the one shown, to be shown when it is done.
  void refine(const Scene& scene, const View& view, bool full);
  /// Goes on with it for about so many milliseconds; true when it is done.
  bool advance(double milliseconds);
  bool isRefining() const { return refining_.has_value(); }
  void drop();
  /// No picture is shown until the next one is done. Needs no context.
  void forget();

  /// The picture shown is at full quality and of this view, so that after a change only the change is drawn.
  bool showsFull(const View& view) const;
  bool isShown() const { return shownView().size.x > 0; }
  Renderer& shown() { return pictures_[shown_].renderer; }
  const Renderer& shown() const { return pictures_[shown_].renderer; }
  const View& shownView() const { return pictures_[shown_].view; }  ///< size 0 before the first picture

 private:
  struct Picture {
    Renderer renderer;
    View view{};
  };
  struct Refining {
    std::size_t picture;
    View view;
    bool full;
  };
  std::size_t other() const { return 1 - shown_; }
  void show(const Refining& done);

  std::array<Picture, 2> pictures_;
  std::size_t shown_ = 0;
  std::optional<std::size_t> full_;  ///< the last one at full quality
  std::optional<Refining> refining_;
};

}  // namespace fenestra::viewer
