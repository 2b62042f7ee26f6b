#include "viewer/views/RefinedPicture.h"

namespace fenestra::viewer {

RefinedPicture::RefinedPicture(const std::shared_ptr<GpuScene>& gpuScene)
    : pictures_{Picture{Renderer(gpuScene)}, Picture{Renderer(gpuScene)}} {}

void RefinedPicture::draw(const Scene& scene, const View& view, bool full) {
  drop();
  const std::size_t at = full ? full_.value_or(shown_) : full_ == shown_ ? other() : shown_;
  pictures_[at].renderer.render(scene, view);
  show({at, view, full});
}

void RefinedPicture::refine(const Scene& scene, const View& view, bool full) {
  refining_ = Refining{other(), view, full};
  pictures_[refining_->picture].renderer.begin(scene, view);
}

bool RefinedPicture::advance(double milliseconds) {
  if (!refining_) return true;
  if (!pictures_[refining_->picture].renderer.advance(milliseconds)) return false;
  show(*refining_);
  refining_.reset();
  return true;
}

void RefinedPicture::drop() {
  if (refining_) pictures_[refining_->picture].renderer.drop();
  refining_.reset();
}

void RefinedPicture::forget() {
  drop();
  for (Picture& picture : pictures_) picture.view = {};
  full_.reset();
}

void RefinedPicture::show(const Refining& done) {
  shown_ = done.picture;
  pictures_[shown_].view = done.view;
  if (done.full)
    full_ = shown_;
  else if (full_ == shown_)
    full_.reset();
}

bool RefinedPicture::showsFull(const View& view) const { return full_ == shown_ && shownView() == view; }

}  // namespace fenestra::viewer
