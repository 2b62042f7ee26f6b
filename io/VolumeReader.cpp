#include "io/VolumeReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "io/Probe.h"
#include "io/base/Archive.h"
#include "io/base/Memory.h"
#include "io/base/OtherContent.h"
#include "io/base/PlausibleGrid.h"
#include "io/base/Text.h"
#include "io/base/Words.h"
#include "io/dicom/Dicom.h"
#include "io/dicom/DicomStart.h"
#include "io/formats/ImageFile.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// More volumes of one file than a list of series can show; --time reaches the others.
constexpr std::int64_t mostListed = 1000;

/// How many volumes a header describes; it may say anything.
int timesOf(const ImageFile& image) {
  return static_cast<int>(std::min<std::int64_t>(image.layers(), std::numeric_limits<int>::max()));
}

/// One of a file's volumes as a series, counted from 0.
SeriesInfo seriesAt(const ImageFile& image, std::int64_t layer) {
  SeriesInfo info = describe(image);
  if (image.layers() < 2) return info;
  info.time = static_cast<int>(layer) + 1;
  info.times = timesOf(image);
  if (layer > 0) info.id.append("#").append(std::to_string(info.time));
  return info;
}

/// The volume and its time points, each as a series.
std::vector<SeriesInfo> seriesIn(const ImageFile& image) {
  std::vector<SeriesInfo> series;
  for (std::int64_t layer = 0; layer < std::min(image.layers(), mostListed); ++layer)
    series.push_back(seriesAt(image, layer));
  return series;
}

/// The volume that the options ask for, counted from 0.
std::int64_t chosenLayer(const ImageFile& image, const OpenOptions& options) {
  if (options.time) {
    if (*options.time < 1 || *options.time > image.layers()) throwNoTime(image.path, *options.time, timesOf(image));
    return *options.time - 1;
  }
  if (options.series.empty()) return 0;
  for (std::int64_t layer = 0; layer < std::min(image.layers(), mostListed); ++layer)
    if (seriesAt(image, layer).id == options.series) return layer;
  throw Error(image.path, "has no series " + options.series, WayOut::ChooseSeries);
}

/// Takes a volume whose file names no modality for a CT where its values are those of one, and says so.
void recogniseCt(const fs::path& path, Volume& volume, OpenedVolume& opened) {
  if (volume.modality != Modality::Unknown || !looksLikeCt(volume)) return;
  volume.modality = Modality::CT;
  volume.unit = "HU";
  opened.series.modality = "CT";
  opened.warnings.push_back({Warning::Kind::Recognised,
                             "the file names no modality; its values (" + plainNumber(volume.range.low) + " to " +
                                 plainNumber(volume.range.high) + ") are taken for Hounsfield units of a CT",
                             {path},
                             WayOut::SayModality});
}

OpenedVolume openImage(ImageFile image, const OpenOptions& options) {
  if (!image.missingSpacing.empty()) throw SpacingMissing(image.path, image.missingSpacing);
  checkGeometry(image);
  OpenedVolume opened;
  opened.format = image.format;
  const std::int64_t layer = chosenLayer(image, options);
  if (image.layers() > 1)
    image.warnings.push_back({Warning::Kind::TimePoints,
                              "the file holds " + std::to_string(image.layers()) +
                                  " volumes (time points or layers); number " + std::to_string(layer + 1) + " is shown",
                              {image.path},
                              WayOut::ChooseTime});
  opened.warnings = std::move(image.warnings);
  auto volume = std::make_shared<Volume>();
  volume->grid = image.grid;
  volume->slope = image.slope;
  volume->intercept = image.intercept;
  const bool told = options.modality.has_value();
  if (told) image.modality = *options.modality;
  volume->modality = image.modality;
  if (image.modality == Modality::CT) volume->unit = "HU";
  volume->voxels = std::move(readVoxels(image, {layer, 1}, options.progress, opened.warnings).front());
  volume->computeRange();
  opened.series = seriesAt(image, layer);
  if (!told) recogniseCt(image.path, *volume, opened);
  if (told || volume->modality != image.modality) opened.modality = volume->modality;
  opened.volume = std::move(volume);
  for (SeriesInfo& series : seriesIn(image))
    if (series.id != opened.series.id) opened.otherSeries.push_back(std::move(series));
  return opened;
}

/// Both take any format but Archive.
void refuseSpacing(const fs::path& path, Format format, const OpenOptions& options) {
  if (options.spacing && format != Format::Tiff)
    throw Error(path, "says itself how large its voxels are", WayOut::OmitVoxelSize);
}
std::vector<SeriesInfo> listFormat(const fs::path& path, Format format, const OpenOptions& options) {
  refuseSpacing(path, format, options);
  if (format == Format::Dicom) return listDicomSeries(path, options);
  return seriesIn(readImageHeader(path, format, options.allowOutside));
}
OpenedVolume openFormat(const fs::path& path, Format format, const OpenOptions& options) {
  refuseSpacing(path, format, options);
  if (format == Format::Dicom) return openDicom(path, options);
  return openImage(readImageHeader(path, format, options.allowOutside, options.spacing), options);
}

/// What to open of an unpacked archive: its only file, the header of its only volume in two files, or the whole folder.
fs::path contentOf(const UnpackedArchive& archive) {
  std::vector<fs::path> files, headers;
  for (const auto& entry : fs::recursive_directory_iterator(archive.folder())) {
    if (!entry.is_regular_file()) continue;
    files.push_back(entry.path());
    const std::string_view ending = volumeEnding(entry.path());
    if (!ending.empty() && ending != ".img") headers.push_back(entry.path());
  }
  if (files.size() == 1) return files.front();
  return headers.size() == 1 ? headers.front() : archive.folder();
}

/// read(archive, content, its format, options) for what an archive holds; errors name the archive. Archives in archives
/// are refused.
template <class Read>
auto readArchive(const fs::path& path, const OpenOptions& options, const Read& read) {
  OpenOptions inside = options;
  // Unpacking and reading take about as long as each other.
  const UnpackedArchive archive(path, partOf(options.progress, 0.0, 0.5));
  inside.progress = partOf(options.progress, 0.5, 1.0);
  try {
    const fs::path content = contentOf(archive);
    const Format format = formatOf(content);
    if (format == Format::Archive)
      throw Error(content, "is an archive in an archive", "unpack it and open what it holds");
    return withinMemory(content, [&] { return read(archive, content, format, inside); });
  } catch (const SpacingMissing& missing) {
    throw SpacingMissing(path, missing.cause());
  } catch (const Error& error) {
    throw Error(archive.named(error.file()), error.cause(), error.hint());
  }
}

/// Whether a folder's TIFF files are its images: a DICOM study may hold pictures, too.
bool isTiffFolder(const fs::path& folder) {
  if (!hasTiffFiles(folder)) return false;
  constexpr int most = 2000;  // files to look into
  int seen = 0;
  std::error_code failure;
  for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failure);
       !failure && entry != fs::recursive_directory_iterator() && seen < most; entry.increment(failure)) {
    std::error_code unknown;
    if (!entry->is_regular_file(unknown) || entry->file_size(unknown) == 0) continue;
    ++seen;
    if (looksLikeDicom(FileStart(entry->path()))) return false;
  }
  return true;
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
  if (image.modality != Modality::CT && image.modality != Modality::Unknown)
    info.modality = wordOf(image.modality).word;
  info.dims = image.grid.dims;
  info.files = image.source.files;
  return info;
}

ImageFile readImageHeader(const fs::path& path, Format format, bool allowOutside,
                          const std::optional<glm::dvec3>& spacing) {
  const auto inside = [&](ImageFile image) {
    if (!allowOutside) refuseOutside(image);
    return image;
  };
  switch (format) {
    case Format::Nifti:
      return readNiftiHeader(path);
    case Format::Nrrd:
      return inside(readNrrdHeader(path));
    case Format::Mgh:
      return readMghHeader(path);
    case Format::Analyze:
      return readAnalyzeHeader(path);
    case Format::MetaImage:
      return inside(readMetaImageHeader(path));
    case Format::Tiff:
      return readTiffHeader(path, spacing);
    case Format::Dicom:
    case Format::Archive:
      break;
  }
  throw std::invalid_argument("readImageHeader: not the format of an image file");
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
  if (fs::is_directory(path)) return isTiffFolder(path) ? Format::Tiff : Format::Dicom;
  const FileStart start(path);
  if (looksLikeNifti(start)) return Format::Nifti;
  if (looksLikeNrrd(start)) return Format::Nrrd;
  if (looksLikeMetaImage(start)) return Format::MetaImage;
  // Before archives: it may be packed by gzip.
  if (looksLikeMgh(start)) return Format::Mgh;
  if (looksLikeArchive(start)) return Format::Archive;
  if (looksLikeDicom(start)) return Format::Dicom;
  // Behind DICOM, whose preamble may be a TIFF header (PS3.10 7.1).
  if (looksLikeTiff(start)) return Format::Tiff;
  // Last, because it has no signature.
  if (looksLikeAnalyze(start)) return Format::Analyze;
  const std::string_view ending = lowered(path.extension().string()) == ".dcm" ? ".dcm" : volumeEnding(path);
  if (!ending.empty())
    throw Error(path, "is named " + std::string(ending) + " but its content is something else",
                "the file is damaged or misnamed");
  if (const OtherContent* other = otherContentOf(start.stored()))
    throw Error(path, std::string("is ") + other->one + ", not a volume", other->way);
  throw Error(path, "holds no volume in a known format", WayOut::DescribeRaw);
}

std::vector<SeriesInfo> listSeries(const fs::path& path, const OpenOptions& options) {
  checkExists(path);
  return withinMemory(path, [&] {
    if (options.raw) return seriesIn(describeRaw(path, *options.raw));
    const Format format = formatOf(path);
    if (format != Format::Archive) return listFormat(path, format, options);
    return readArchive(path, options,
                       [&](const UnpackedArchive&, const fs::path& content, Format held, const OpenOptions& inside) {
                         std::vector<SeriesInfo> all = listFormat(content, held, inside);
                         for (SeriesInfo& series : all) series.files = {path};
                         return all;
                       });
  });
}

std::optional<ListedSlices> listSlices(const fs::path& path, const OpenOptions& options) {
  checkExists(path);
  if (options.raw || formatOf(path) != Format::Dicom) return std::nullopt;
  return withinMemory(path, [&] {
    refuseSpacing(path, Format::Dicom, options);
    return listDicomSlices(path, options);
  });
}

OpenedVolume openVolume(const fs::path& path, const OpenOptions& options) {
  checkExists(path);
  return withinMemory(path, [&] {
    if (options.raw) return openImage(describeRaw(path, *options.raw), options);
    const Format format = formatOf(path);
    if (format != Format::Archive) return openFormat(path, format, options);
    return readArchive(
        path, options,
        [&](const UnpackedArchive& archive, const fs::path& content, Format held, const OpenOptions& inside) {
          OpenedVolume opened = openFormat(content, held, inside);
          renameFiles(opened, [&](const fs::path& file) { return archive.named(file); });
          // What sessions look for and hash.
          opened.series.files = {path};
          opened.slices.clear();
          for (SeriesInfo& series : opened.otherSeries) series.files = {path};
          return opened;
        });
  });
}

}  // namespace fenestra::io
