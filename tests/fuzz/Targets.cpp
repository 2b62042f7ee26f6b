#include "tests/fuzz/Targets.h"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "io/LabelReader.h"
#include "io/TransferFunctionFile.h"
#include "io/VolumeReader.h"
#include "io/session/LookFile.h"
#include "io/session/SessionFile.h"
#include "io/session/StrokeFile.h"

namespace fenestra::fuzz {
namespace fs = std::filesystem;
namespace {

void openAsVolume(const fs::path& file) { io::openVolume(file); }

void openTiff(const fs::path& file) { io::openVolume(file, {.spacing = glm::dvec3(0.1)}); }

void openAsLabels(const fs::path& file) {
  Grid target;
  target.dims = {7, 6, 5};
  io::openLabels(file, target);
}

void openSession(const fs::path& file) { io::readSession(file); }
void openLook(const fs::path& file) { io::readLook(file); }
void openStrokes(const fs::path& file) { io::readStrokes(file); }

void openTransferFunction(const fs::path& file) {
  Volume volume;
  volume.voxels = Voxels(ScalarType::UInt8, 1);
  volume.grid.dims = {1, 1, 1};
  volume.range = {-1000.0, 3000.0};
  io::loadContextFunction(file.string(), volume);
}

constexpr std::array all{
    Target{"dicom", "input.dcm", openAsVolume},       Target{"nifti", "input.nii", openAsVolume},
    Target{"nrrd", "input.nrrd", openAsVolume},       Target{"metaimage", "input.mha", openAsVolume},
    Target{"mgh", "input.mgh", openAsVolume},         Target{"tiff", "input.tif", openTiff},
    Target{"archive", "input.zip", openAsVolume},     Target{"labels", "input.labels", openAsLabels},
    Target{"session", "input.fenestra", openSession}, Target{"look", "input.json", openLook},
    Target{"strokes", "input.json", openStrokes},     Target{"transfer-function", "input.json", openTransferFunction}};

/// In memory where the machine has such a folder: a fuzzer writes thousands of files a second.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string name = (fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) / "fenestra-XXXXXX";
    if (!::mkdtemp(name.data())) throw std::runtime_error("no private folder");
    path_ = name;
    ::setenv("TMPDIR", name.c_str(), 1);  // for archives
  }
  ~PrivateFolder() {
    std::error_code unknown;
    fs::remove_all(path_, unknown);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

std::span<const Target> targets() { return all; }

const Target& targetNamed(std::string_view name) {
  const auto at = std::ranges::find(all, name, &Target::name);
  if (at == all.end()) throw std::out_of_range("no fuzz target " + std::string(name));
  return *at;
}

void run(const Target& target, std::span<const std::byte> bytes) {
  static const PrivateFolder folder;
  const fs::path path = folder.path() / target.file;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) throw std::runtime_error("cannot write " + path.string());
  std::fwrite(bytes.data(), 1, bytes.size(), file);
  std::fclose(file);
  try {
    target.open(path);
  } catch (const io::Error&) {
  }
}

}  // namespace fenestra::fuzz
