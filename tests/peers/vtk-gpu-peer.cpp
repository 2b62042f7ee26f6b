// VTK's OpenGL ray caster.

#include <vtkOpenGLGPUVolumeRayCastMapper.h>

#include "tests/peers/VtkPeer.h"

int main(int argc, char** argv) {
  return fenestra::peers::run(argc, argv, "vtk-gpu", [](double step) -> vtkSmartPointer<vtkVolumeMapper> {
    const auto mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetSampleDistance(static_cast<float>(step));
    mapper->SetImageSampleDistance(1.0f);
    mapper->UseJitteringOff();
    return mapper;
  });
}
