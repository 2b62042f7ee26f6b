// VTK's OpenGL ray caster.

#include <vtkOpenGLGPUVolumeRayCastMapper.h>

#include "tests/peers/VtkPeer.h"

namespace {

using Mapper = vtkOpenGLGPUVolumeRayCastMapper;

vtkSmartPointer<vtkVolumeMapper> makeMapper() {
  const auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0f);
  mapper->UseJitteringOff();
  return mapper;
}

void setStep(vtkVolumeMapper& mapper, double step) {
  Mapper::SafeDownCast(&mapper)->SetSampleDistance(static_cast<float>(step));
}

}  // namespace

int main(int argc, char** argv) {
  return fenestra::peers::run(argc, argv, {"vtk-gpu", "VTK OpenGL mapper", makeMapper, setStep, {}});
}
