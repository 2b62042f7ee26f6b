#include "tests/peers/VtkPeer.h"

#include <array>
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
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPixelBufferObject.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtkVersion.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <nlohmann/json.hpp>

#include "tests/peers/PeerRuns.h"

namespace fenestra::peers {
namespace {

using Json = nlohmann::ordered_json;

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
/// gets points close enough for the two to agree; it sizes its tables by them.
vtkSmartPointer<vtkVolumeProperty> makeProperty(const Scene& scene, bool lit) {
  const Volume& volume = *scene.volume;
  vtkNew<vtkColorTransferFunction> colour;
  vtkNew<vtkPiecewiseFunction> opacity;
  const TransferFunction context = scene.look.context.shifted();
  constexpr int points = 4096;
  for (int i = 0; i < points; ++i) {
    const double value = std::lerp(volume.range.low, volume.range.high, i / (points - 1.0));
    const double stored = (value - volume.intercept) / volume.slope;
    const OpticalProperties optics = context.evaluate(value);
    colour->AddRGBPoint(stored, optics.colour.r, optics.colour.g, optics.colour.b);
    opacity->AddPoint(stored, opacityFromExtinction(optics.extinction));
  }
  const auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colour);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.0);  // opacities are those of 1 mm
  property->SetInterpolationTypeToLinear();
  property->SetShade(lit);
  property->SetAmbient(scene.look.shading.ambient);
  property->SetDiffuse(scene.look.shading.diffuse);
  property->SetSpecular(scene.look.shading.specular);
  property->SetSpecularPower(scene.look.shading.shininess);
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

/// One subject in a window of its own, whose picture is kept in single precision: eight bits would add an error of
/// their own.
class Stage {
 public:
  Stage(const Scene& scene, glm::ivec2 size, bool lit, const Peer& peer)
      : scene_(scene), size_(size), peer_(peer), mapper_(peer.makeMapper()) {
    mapper_->SetInputData(makeImage(*scene.volume));
    volume_->SetMapper(mapper_);
    volume_->SetProperty(makeProperty(scene, lit));
    volume_->SetUserMatrix(makePlace(scene.volume->grid));
    renderer_->AddVolume(volume_);
    renderer_->SetBackground(0.0, 0.0, 0.0);
    window_->OffScreenRenderingOn();
    window_->SetMultiSamples(0);
    window_->SetSize(size.x, size.y);
    window_->AddRenderer(renderer_);
    // The window draws into a framebuffer of its own before it shows anything: that one gets a colour image of floats.
    window_->Render();
    picture_->SetContext(window_);
    picture_->Allocate2D(static_cast<unsigned>(size.x), static_cast<unsigned>(size.y), 4, VTK_FLOAT);
    window_->GetState()->PushFramebufferBindings();
    window_->GetRenderFramebuffer()->Bind();
    window_->GetRenderFramebuffer()->AddColorAttachment(0, picture_);
    window_->GetState()->PopFramebufferBindings();
  }
  ~Stage() { picture_->ReleaseGraphicsResources(window_); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Sets the step length of all pictures that follow.
  void setStep(double samplesPerVoxel) {
    peer_.setStep(*mapper_, bench::stepLength(scene_.volume->grid, samplesPerVoxel));
  }

  /// Milliseconds until the picture is in the graphics memory.
  double draw(const Camera& camera) {
    placeCamera(*renderer_->GetActiveCamera(), camera);
    renderer_->ResetCameraClippingRange();
    const auto start = std::chrono::steady_clock::now();
    window_->Render();
    window_->WaitForCompletion();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }

  /// RGBA of pixels of the last picture, (i, j) from the top.
  std::vector<float> read(const std::vector<glm::ivec2>& pixels) {
    const std::vector<float> values = readAll();
    std::vector<float> colours;
    for (const glm::ivec2 pixel : pixels) {
      const std::size_t at = static_cast<std::size_t>(size_.y - 1 - pixel.y) * static_cast<std::size_t>(size_.x) +
                             static_cast<std::size_t>(pixel.x);
      colours.insert(colours.end(), values.begin() + static_cast<std::ptrdiff_t>(at * 4),
                     values.begin() + static_cast<std::ptrdiff_t>(at * 4 + 4));
    }
    return colours;
  }

  std::string description() {
    window_->MakeCurrent();
    const std::string capabilities = window_->ReportCapabilities();
    const std::string key = "OpenGL renderer string:  ";
    const std::size_t at = capabilities.find(key);
    if (at == std::string::npos) return "unknown";
    return capabilities.substr(at + key.size(), capabilities.find('\n', at) - at - key.size());
  }

 private:
  /// RGBA, row by row from the bottom.
  std::vector<float> readAll() {
    if (peer_.readPicture) return peer_.readPicture(*mapper_, size_);
    const auto buffer = vtkSmartPointer<vtkPixelBufferObject>::Take(picture_->Download());
    std::vector<float> values(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * 4);
    std::array<unsigned, 2> dims{static_cast<unsigned>(size_.x), static_cast<unsigned>(size_.y)};
    std::array<vtkIdType, 2> strides{0, 0};
    buffer->Download2D(VTK_FLOAT, values.data(), dims.data(), 4, strides.data());
    return values;
  }

  const Scene& scene_;
  glm::ivec2 size_;
  const Peer& peer_;
  vtkSmartPointer<vtkVolumeMapper> mapper_;
  vtkNew<vtkVolume> volume_;
  vtkNew<vtkRenderer> renderer_;
  vtkSmartPointer<vtkOpenGLRenderWindow> window_{
      vtkOpenGLRenderWindow::SafeDownCast(vtkSmartPointer<vtkRenderWindow>::New())};
  vtkNew<vtkTextureObject> picture_;
};

void measure(const Options& options, const Peer& peer) {
  const std::string& name = peer.name;
  const std::vector<glm::ivec2> pixels = bench::sampledPixels(options.views.size, options.views.pixelBlock);
  Json runs = Json::array();
  std::string gl;
  bool first = true;
  const bench::Subjects subjects = bench::reportSubjects(options.views);
  for (const bench::Subject& subject : subjects.here) {
    const Scene scene = bench::plainScene(io::readStudy(subject.options).drawn.scene());
    const std::vector<Camera> cameras = bench::cameraPath(scene, options.views.cameras, options.views.projection());
    for (const bool lit : {false, true}) {
      Stage stage(scene, options.views.size, lit, peer);
      std::vector<double> ladder = lit ? bench::litLadder : bench::stepLadder;
      if (lit)
        ladder.push_back(bench::litLimit);
      else if (first)
        ladder.insert(ladder.end(), bench::limitLadder.begin(), bench::limitLadder.end());
      stage.setStep(ladder.front());
      stage.draw(cameras.back());  // uploads and compiles
      for (const double samples : ladder) {
        Json run{{"subject", subject.id}, {"lit", lit}, {"samplesPerVoxel", samples}};
        stage.setStep(samples);
        const bool limit = samples > bench::stepLadder.back();
        // With lighting the others' errors are those against the limit, in each view that is compared.
        const std::size_t count = !limit ? cameras.size()
                                  : lit  ? std::min<std::size_t>(cameras.size(), options.views.compared)
                                         : 1;
        for (int round = 0; round < (limit ? 1 : bench::pathRounds); ++round)
          for (std::size_t i = 0; i < count; ++i) {
            run["frames_ms"].push_back(stage.draw(cameras[i]));
            if (round > 0 || i >= static_cast<std::size_t>(options.views.compared)) continue;
            const std::string file = name + "-" + subject.id + (lit ? "-lit-" : "-") + std::to_string(i) + "-" +
                                     std::to_string(static_cast<int>(samples * 10.0)) + ".mha";
            writePicture(options, file, stage.read(pixels));
            run["pictures"].push_back(file);
          }
        std::cerr << name << ' ' << run.dump() << '\n';
        runs.push_back(std::move(run));
      }
      gl = stage.description();
    }
    first = false;
  }
  writeRuns(options, {name, peer.title, vtkVersion::GetVTKVersion(), gl}, runs);
}

}  // namespace

int run(int argc, char** argv, const Peer& peer) {
  return runProgram(argc, argv, "Draws the report's subjects with VTK and times it.",
                    [&](const Options& options) { measure(options, peer); });
}

}  // namespace fenestra::peers
