#pragma once
// The report's subjects drawn by one of VTK's volume mappers, off screen: plain volume rendering, no cutaway.

#include <functional>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>
#include <vtkVolumeMapper.h>
#include <glm/glm.hpp>

namespace fenestra::peers {

struct Peer {
  std::string name;   ///< of its files
  std::string title;  ///< in the report
  /// The mapper that is measured, casting a ray at every pixel.
  std::function<vtkSmartPointer<vtkVolumeMapper>()> makeMapper;
  /// mm between a mapper's samples.
  std::function<void(vtkVolumeMapper& mapper, double step)> setStep;
  /// RGBA of the picture of `size` that a mapper has made, row by row from the bottom, where the mapper keeps it
  /// itself; otherwise empty, and what the window shows counts.
  std::function<std::vector<float>(vtkVolumeMapper& mapper, glm::ivec2 size)> readPicture;
};

/// The program: draws every subject (tests/bench/Subjects.h) along its camera path for each step of a ladder, and
/// writes the frames' times as NAME.json and the compared pixels' colours as layers, all to FOLDER/peers.
int run(int argc, char** argv, const Peer& peer);

}  // namespace fenestra::peers
