#include <locale>
#include <sstream>

#include <vtkErrorCode.h>
#include <vtkObject.h>
#include <vtkPLYWriter.h>
#include <vtkSTLWriter.h>
#include <vtkWriter.h>

#include "io/base/AtomicFile.h"
#include "io/base/Text.h"
#include "io/surface/Mesh.h"
#include "io/surface/SurfacePart.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Whether the file was written; the failure is the caller's to report, not the error stream's.
bool writeQuietly(vtkWriter& writer) {
  const int said = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  const bool written = writer.Write() == 1 && writer.GetErrorCode() == vtkErrorCode::NoError;
  vtkObject::SetGlobalWarningDisplay(said);
  return written;
}

void writeStl(const Surface& surface, const std::string& note, const fs::path& file) {
  const vtkSmartPointer<vtkPolyData> mesh = meshOf(surface);
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(file.c_str());
  writer->SetFileTypeToBinary();
  writer->SetHeader(note.c_str());
  if (!writeQuietly(*writer)) failToWrite(file);
}

void writePly(const Surface& surface, const std::string& note, const fs::path& file) {
  const vtkSmartPointer<vtkPolyData> mesh = meshOf(surface);
  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileTypeToBinary();
  writer->AddComment(note);
  // It adds ".ply" to names without it.
  const fs::path named = fs::path(file) += ".ply";
  writer->SetFileName(named.c_str());
  const bool written = writeQuietly(*writer);
  std::error_code failure;
  if (written) fs::rename(named, file, failure);
  if (!written || failure) {
    fs::remove(named, failure);
    failToWrite(file);
  }
}

/// By hand: VTK's writer keeps six digits and leaves no room for the frame.
void writeObj(const Surface& surface, const std::string& note, const fs::path& file) {
  // Streams and not printf, whose decimal point is the locale's.
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(9);
  stream << "# " << note << '\n';
  for (const glm::dvec3& p : surface.points) stream << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const auto& [a, b, c] : surface.triangles) stream << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  const std::string text = std::move(stream).str();
  writeBytes(file, {{text.data(), text.size()}});
}

}  // namespace

void writeWithVtk(const Surface& surface, const fs::path& path, SurfaceFrame frame) {
  const std::string ending = lowered(path.extension().string());
  if (ending != ".stl" && ending != ".ply" && ending != ".obj")
    throw Error(path, "has an ending that names no surface format", "end it in .stl, .ply or .obj");
  Surface placed = surface;
  if (frame == SurfaceFrame::Ras)  // half a turn about z: triangles keep their side
    for (glm::dvec3& point : placed.points) point = {-point.x, -point.y, point.z};
  const std::string note = std::string("Fenestra output. SPACE=") + (frame == SurfaceFrame::Ras ? "RAS" : "LPS");
  writeAtomically(path, [&](const fs::path& temporary) {
    if (ending == ".obj") return writeObj(placed, note, temporary);
    if (ending == ".stl") return writeStl(placed, note, temporary);
    writePly(placed, note, temporary);
  });
}

}  // namespace fenestra::io
