#pragma once
// The report's subjects drawn by one of VTK's volume mappers, off screen: plain volume rendering, no cutaway.

#include <functional>

#include <vtkSmartPointer.h>
#include <vtkVolumeMapper.h>

namespace fenestra::peers {

/// Makes the mapper that is measured, casting rays with `step` mm between samples at every pixel.
using MakeMapper = std::function<vtkSmartPointer<vtkVolumeMapper>(double step)>;

/// The program: draws every subject (tests/bench/Subjects.h) along its camera path for each step of a ladder, and
/// writes the frames' times as NAME.json and the compared pixels' colours as layers, all to FOLDER/peers.
int run(int argc, char** argv, const std::string& name, const MakeMapper& makeMapper);

}  // namespace fenestra::peers
