// VTK's ray caster on the CPU, in fixed-point arithmetic, on all cores.

#include <vtkFixedPointVolumeRayCastMapper.h>

#include "tests/peers/VtkPeer.h"

int main(int argc, char** argv) {
  return fenestra::peers::run(argc, argv, "vtk-cpu", [](double step) -> vtkSmartPointer<vtkVolumeMapper> {
    const auto mapper = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetSampleDistance(static_cast<float>(step));
    mapper->SetInteractiveSampleDistance(static_cast<float>(step));
    mapper->SetImageSampleDistance(1.0f);
    return mapper;
  });
}
