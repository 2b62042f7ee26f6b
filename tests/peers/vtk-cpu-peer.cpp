// VTK's ray caster on the CPU, in fixed-point arithmetic, on all cores.

#include <vtkFixedPointRayCastImage.h>
#include <vtkFixedPointVolumeRayCastMapper.h>

#include "tests/peers/VtkPeer.h"

namespace {

using Mapper = vtkFixedPointVolumeRayCastMapper;

vtkSmartPointer<vtkVolumeMapper> makeMapper() {
  const auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0f);
  return mapper;
}

void setStep(vtkVolumeMapper& mapper, double step) {
  Mapper& caster = *Mapper::SafeDownCast(&mapper);
  caster.SetSampleDistance(static_cast<float>(step));
  caster.SetInteractiveSampleDistance(static_cast<float>(step));
}

/// The picture as it was cast: the window shows it stretched by up to half a pixel, which would be counted as error.
std::vector<float> readPicture(vtkVolumeMapper& mapper, glm::ivec2 size) {
  vtkFixedPointRayCastImage& image = *Mapper::SafeDownCast(&mapper)->GetRayCastImage();
  glm::ivec2 origin, used, rows;
  image.GetImageOrigin(&origin.x);
  image.GetImageInUseSize(&used.x);
  image.GetImageMemorySize(&rows.x);
  std::vector<float> picture(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), 0.0f);
  for (int y = 0; y < used.y; ++y)
    for (int x = 0; x < used.x; ++x) {
      const glm::ivec2 at = origin + glm::ivec2(x, y);
      if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y) continue;
      const unsigned short* texel = image.GetImage() + 4 * (static_cast<std::ptrdiff_t>(y) * rows.x + x);
      // 15 bits a channel.
      for (int c = 0; c < 4; ++c)
        picture[4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x) +
                     static_cast<std::size_t>(at.x)) +
                static_cast<std::size_t>(c)] = static_cast<float>(texel[c]) / 32767.0f;
    }
  return picture;
}

}  // namespace

int main(int argc, char** argv) {
  return fenestra::peers::run(argc, argv, {"vtk-cpu", "VTK CPU mapper", makeMapper, setStep, readPicture});
}
