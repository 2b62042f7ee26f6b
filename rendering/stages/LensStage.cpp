#include "rendering/stages/LensStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {

LensStage::LensStage(StageList& list, const PictureStarts& starts) : KeyedStage(list, Pass::Lens), starts_(starts) {
  owns(surface_, pass_);
}

void LensStage::begin(const Frame& frame, Steps& steps) {
  const Grid& grid = gpu().grid();
  const Output hits = starts_.hits();
  const LensKey key{
      .hits = hits.version,
      .derivative = gpu().versions().derivative,
      .middle = placeOf(*frame.method.lens, frame.view().slices, gpu().focus().centre(grid).value_or(grid.centre()))};
  update(frame.own, steps, key, {}, [&](Regions regions) {
    pass_.run(steps, gpu(), frame.own.rays, hits.image, key.middle, regions,
              sized(surface_, gl::Format::RGBA32F, frame.view().size));
  });
}

}  // namespace fenestra
