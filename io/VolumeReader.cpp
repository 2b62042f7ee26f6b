#include "io/VolumeReader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/Probe.h"
#include "io/base/Memory.h"
#include "io/base/Text.h"
#include "io/dicom/Dicom.h"
#include "io/formats/ImageFile.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

OpenedVolume openImage(ImageFile image, const OpenOptions& options) {
  OpenedVolume opened;
  opened.format = image.format;
  opened.series = describe(image);
  if (image.layers() > 1)
    image.warnings.push_back(
        {Warning::Kind::TimePoints,
         "the file holds " + std::to_string(image.layers()) + " volumes (time points or layers); the first is shown",
         {image.path}});
  opened.warnings = std::move(image.warnings);
  auto volume = std::make_shared<Volume>();
  volume->grid = image.grid;
  volume->slope = image.slope;
  volume->intercept = image.intercept;
  volume->modality = image.modality;
  if (image.modality == Modality::CT) volume->unit = "HU";
  volume->voxels = std::move(readVoxels(image, 1, options.progress, opened.warnings).front());
  volume->computeRange();
  opened.volume = std::move(volume);
  return opened;
}

}  // namespace

RawDescription parseRawDescription(std::string_view text) {
  const auto refuse = [&](const std::string& cause) -> RawDescription {
    throw Error(std::string(text), cause,
                "describe raw voxels as WxHxD:TYPE[:le|be][:skip=BYTES], e.g. 256x256x128:uint16:be");
  };
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() < 2) return refuse("is no description of raw voxels");

  RawDescription description;
  std::string dims = parts[0];
  if (std::count(dims.begin(), dims.end(), 'x') != 2) return refuse("gives no three sizes");
  std::replace(dims.begin(), dims.end(), 'x', ' ');
  const auto sizes = numbersIn<int>(dims);
  if (!sizes || sizes->size() != 3 || *std::min_element(sizes->begin(), sizes->end()) < 1)
    return refuse("gives no three sizes");
  description.dims = {(*sizes)[0], (*sizes)[1], (*sizes)[2]};

  constexpr std::array types = {ScalarType::UInt8,  ScalarType::Int8,  ScalarType::UInt16,  ScalarType::Int16,
                                ScalarType::UInt32, ScalarType::Int32, ScalarType::Float32, ScalarType::Float64};
  const auto type = std::find_if(types.begin(), types.end(), [&](ScalarType t) { return parts[1] == nameOf(t); });
  if (type == types.end())
    return refuse("names no scalar type (uint8, int8, uint16, int16, uint32, int32, float32, float64)");
  description.type = *type;

  for (std::size_t i = 2; i < parts.size(); ++i) {
    if (parts[i] == "le" || parts[i] == "be") {
      description.bigEndian = parts[i] == "be";
    } else if (const auto skip = numberIn<std::size_t>(parts[i].starts_with("skip=") ? parts[i].substr(5) : "")) {
      description.skip = *skip;
    } else {
      return refuse("has a part '" + parts[i] + "' that is not understood");
    }
  }
  return description;
}

SeriesInfo describe(const ImageFile& image) {
  SeriesInfo info;
  info.id = image.path.filename().string();
  if (image.modality == Modality::CT) info.modality = "CT";
  if (image.modality == Modality::MR) info.modality = "MR";
  info.dims = image.grid.dims;
  info.files = image.source.files;
  return info;
}

ImageFile readImageHeader(const fs::path& path, Format format) {
  switch (format) {
    case Format::Nifti:
      return readNiftiHeader(path);
    case Format::Nrrd:
      return readNrrdHeader(path);
    case Format::Mgh:
      return readMghHeader(path);
    case Format::Analyze:
      return readAnalyzeHeader(path);
    default:
      return readMetaImageHeader(path);
  }
}

void checkExists(const fs::path& path) {
  std::error_code failure;
  if (!fs::exists(path, failure)) throw Error(path, "does not exist", "check the path");
  if (fs::is_directory(path, failure)) return;
  if (!fs::is_regular_file(path, failure))
    throw Error(path, "is neither a file nor a folder", "name a volume file or a DICOM folder");
  if (fs::file_size(path, failure) == 0) throw Error(path, "is empty", "get the file again from its source");
}

Format formatOf(const fs::path& path) {
  if (fs::is_directory(path)) return Format::Dicom;
  if (looksLikeNifti(path)) return Format::Nifti;
  if (looksLikeNrrd(path)) return Format::Nrrd;
  if (looksLikeMetaImage(path)) return Format::MetaImage;
  if (looksLikeDicom(path)) return Format::Dicom;
  // Last, because neither has a signature.
  if (looksLikeMgh(path)) return Format::Mgh;
  if (looksLikeAnalyze(path)) return Format::Analyze;
  const std::string_view ending = lowered(path.extension().string()) == ".dcm" ? ".dcm" : volumeEnding(path);
  if (!ending.empty())
    throw Error(path, "is named " + std::string(ending) + " but its content is something else",
                "the file is damaged or misnamed");
  throw Error(path, "holds no volume in a known format",
              "DICOM, NIfTI, NRRD, MetaImage, MGH and Analyze are recognised by content; raw voxels need a description "
                  "(--raw)");
}

std::string_view volumeEnding(const fs::path& path) {
  const std::string name = lowered(path.filename().string());
  const auto at = std::find_if(volumeEndings.begin(), volumeEndings.end(),
                               [&](std::string_view ending) { return name.ends_with(ending); });
  return at == volumeEndings.end() ? std::string_view() : *at;
}

std::vector<SeriesInfo> listSeries(const fs::path& path, const OpenOptions& options) {
  checkExists(path);
  return withinMemory(path, [&]() -> std::vector<SeriesInfo> {
    if (options.raw) return {describe(describeRaw(path, *options.raw))};
    const Format format = formatOf(path);
    if (format == Format::Dicom) return listDicomSeries(path, options);
    return {describe(readImageHeader(path, format))};
  });
}

OpenedVolume openVolume(const fs::path& path, const OpenOptions& options) {
  checkExists(path);
  return withinMemory(path, [&] {
    if (options.raw) return openImage(describeRaw(path, *options.raw), options);
    const Format format = formatOf(path);
    if (format == Format::Dicom) return openDicom(path, options);
    return openImage(readImageHeader(path, format), options);
  });
}

}  // namespace fenestra::io
