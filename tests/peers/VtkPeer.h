#pragma once
// A scene's volume drawn by one of VTK's mappers: plain volume rendering, no cutaway, off screen.

#include <functional>

#include <vtkSmartPointer.h>
#include <vtkVolumeMapper.h>

namespace fenestra::peers {

/// Makes the mapper that is measured, casting rays with `step` mm between samples at every pixel.
using MakeMapper = std::function<vtkSmartPointer<vtkVolumeMapper>(double step)>;

/// The program: takes fenestra-cli's scene options with -o OUT.png, --step and --frames, and prints the times of a
/// frame, read back, as JSON.
int run(int argc, char** argv, const MakeMapper& makeMapper);

}  // namespace fenestra::peers
