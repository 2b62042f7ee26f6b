#include "tests/peers/VtkPeer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/SceneOptions.h"
#include "io/ImageWriter.h"

namespace fenestra::peers {
namespace {

struct Options {
  app::SceneOptions scene;
  std::filesystem::path output;
  double step = 0.0;  ///< mm; 0: half the least voxel spacing, Quality::Normal's
  int frames = 5;
};

int vtkTypeOf(ScalarType type) {
  switch (type) {
    case ScalarType::UInt8:
      return VTK_UNSIGNED_CHAR;
    case ScalarType::Int8:
      return VTK_SIGNED_CHAR;
    case ScalarType::UInt16:
      return VTK_UNSIGNED_SHORT;
    case ScalarType::Int16:
      return VTK_SHORT;
    case ScalarType::UInt32:
      return VTK_UNSIGNED_INT;
    case ScalarType::Int32:
      return VTK_INT;
    case ScalarType::Float32:
      return VTK_FLOAT;
    case ScalarType::Float64:
      break;
  }
  return VTK_DOUBLE;
}

/// The voxels themselves, not a copy; the grid's place in the world is the prop's matrix.
vtkSmartPointer<vtkImageData> makeImage(const Volume& volume) {
  const auto scalars =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkTypeOf(volume.voxels.type())));
  // VTK only reads them, but its interface does not say so; 1: they stay ours to free.
  scalars->SetVoidArray(const_cast<std::byte*>(volume.voxels.data()), static_cast<vtkIdType>(volume.voxels.count()), 1);
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(volume.grid.dims.x, volume.grid.dims.y, volume.grid.dims.z);
  image->SetSpacing(volume.grid.spacing.x, volume.grid.spacing.y, volume.grid.spacing.z);
  image->GetPointData()->SetScalars(scalars);
  return image;
}

vtkSmartPointer<vtkMatrix4x4> makePlace(const Grid& grid) {
  const auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, grid.direction[column][row]);
    matrix->SetElement(row, 3, grid.origin[row]);
  }
  return matrix;
}

/// The transfer function over stored values. VTK interpolates opacity where the scene interpolates extinction, so it
/// gets points close enough for the two to agree.
vtkSmartPointer<vtkVolumeProperty> makeProperty(const Scene& scene) {
  const Volume& volume = *scene.volume;
  vtkNew<vtkColorTransferFunction> colour;
  vtkNew<vtkPiecewiseFunction> opacity;
  constexpr int points = 2048;
  for (int i = 0; i < points; ++i) {
    const double value = std::lerp(volume.range.low, volume.range.high, i / (points - 1.0));
    const double stored = (value - volume.intercept) / volume.slope;
    const OpticalProperties optics = scene.context.evaluate(value);
    colour->AddRGBPoint(stored, optics.colour.r, optics.colour.g, optics.colour.b);
    opacity->AddPoint(stored, opacityFromExtinction(optics.extinction));
  }
  const auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colour);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.0);  // opacities are those of 1 mm
  property->SetInterpolationTypeToLinear();
  property->SetShade(scene.shading.enabled);
  property->SetAmbient(scene.shading.ambient);
  property->SetDiffuse(scene.shading.diffuse);
  property->SetSpecular(scene.shading.specular);
  property->SetSpecularPower(scene.shading.shininess);
  return property;
}

void placeCamera(vtkCamera& target, const Camera& camera) {
  target.SetPosition(camera.eye.x, camera.eye.y, camera.eye.z);
  target.SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  const glm::dvec3 up = camera.axes().up;
  target.SetViewUp(up.x, up.y, up.z);
  target.SetViewAngle(camera.verticalFov);
  target.SetParallelProjection(camera.projection == Projection::Orthographic);
  target.SetParallelScale(0.5 * camera.orthographicHeight);
}

/// RGB by rows from the top.
std::vector<std::uint8_t> readPicture(vtkRenderWindow& window, glm::ivec2 size) {
  vtkNew<vtkUnsignedCharArray> pixels;
  window.GetPixelData(0, 0, size.x - 1, size.y - 1, 0, pixels);
  const std::size_t row = static_cast<std::size_t>(size.x) * 3;
  std::vector<std::uint8_t> picture(row * static_cast<std::size_t>(size.y));
  for (std::size_t j = 0; j < static_cast<std::size_t>(size.y); ++j)
    std::copy_n(pixels->GetPointer(0) + static_cast<std::ptrdiff_t>(j * row), row,
                picture.end() - static_cast<std::ptrdiff_t>((j + 1) * row));
  return picture;
}

void measure(const Options& options, const MakeMapper& makeMapper) {
  const app::LoadedScene loaded = app::loadScene(options.scene);
  const Scene& scene = loaded.scene;
  const glm::dvec3 spacing = scene.volume->grid.spacing;
  const double step = options.step > 0.0 ? options.step : 0.5 * std::min({spacing.x, spacing.y, spacing.z});

  const vtkSmartPointer<vtkVolumeMapper> mapper = makeMapper(step);
  mapper->SetInputData(makeImage(*scene.volume));
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(makeProperty(scene));
  volume->SetUserMatrix(makePlace(scene.volume->grid));
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(scene.background.r, scene.background.g, scene.background.b);
  placeCamera(*renderer->GetActiveCamera(), loaded.view.camera);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(loaded.view.size.x, loaded.view.size.y);
  window->AddRenderer(renderer);

  std::vector<std::uint8_t> picture;
  std::vector<double> frames;
  for (int frame = 0; frame <= options.frames; ++frame) {
    const auto start = std::chrono::steady_clock::now();
    window->Render();
    picture = readPicture(*window, loaded.view.size);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    // The first one uploads the volume and compiles shaders.
    if (frame > 0) frames.push_back(elapsed.count());
  }
  io::writePng(options.output, loaded.view.size, 3, picture);

  const char* renderedBy = "unknown";
  if (auto* openGl = vtkOpenGLRenderWindow::SafeDownCast(window)) {
    openGl->MakeCurrent();
    renderedBy = openGl->ReportCapabilities();
  }
  std::string capabilities = renderedBy;
  const std::string key = "OpenGL renderer string:  ";
  const std::size_t at = capabilities.find(key);
  if (at != std::string::npos)
    capabilities = capabilities.substr(at + key.size(), capabilities.find('\n', at) - at - key.size());
  std::sort(frames.begin(), frames.end());
  const nlohmann::ordered_json result{
      {"mapper", mapper->GetClassName()},       {"gl", capabilities},       {"step", step}, {"frames", frames.size()},
      {"median_ms", frames[frames.size() / 2]}, {"min_ms", frames.front()},
  };
  std::cout << result.dump(2) << '\n';
}

}  // namespace

int run(int argc, char** argv, const MakeMapper& makeMapper) {
  Options options;
  CLI::App program{"Draws a scene's volume with VTK and times it."};
  app::addSceneOptions(program, options.scene);
  program.add_option("-o,--output", options.output, "PNG to write")->required();
  program.add_option("--step", options.step, "mm between samples; half the least voxel spacing otherwise")
      ->check(CLI::PositiveNumber);
  program.add_option("--frames", options.frames, "frames to time, after one to warm up")->check(CLI::Range(1, 1000));
  CLI11_PARSE(program, argc, argv);
  try {
    measure(options, makeMapper);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << program.get_name() << ": " << error.what() << '\n';
    return 1;
  }
}

}  // namespace fenestra::peers
