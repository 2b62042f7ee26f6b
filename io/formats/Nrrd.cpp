// NRRD, attached and detached. Definition: teem.sourceforge.net/nrrd/format.html.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "io/base/Text.h"
#include "io/formats/ImageFile.h"
#include "io/formats/NrrdHeader.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

const std::map<std::string, ElementType> elementTypes = {{"signed char", ElementType::Int8},
                                                         {"int8", ElementType::Int8},
                                                         {"int8_t", ElementType::Int8},
                                                         {"uchar", ElementType::UInt8},
                                                         {"unsigned char", ElementType::UInt8},
                                                         {"uint8", ElementType::UInt8},
                                                         {"uint8_t", ElementType::UInt8},
                                                         {"short", ElementType::Int16},
                                                         {"short int", ElementType::Int16},
                                                         {"signed short", ElementType::Int16},
                                                         {"signed short int", ElementType::Int16},
                                                         {"int16", ElementType::Int16},
                                                         {"int16_t", ElementType::Int16},
                                                         {"ushort", ElementType::UInt16},
                                                         {"unsigned short", ElementType::UInt16},
                                                         {"unsigned short int", ElementType::UInt16},
                                                         {"uint16", ElementType::UInt16},
                                                         {"uint16_t", ElementType::UInt16},
                                                         {"int", ElementType::Int32},
                                                         {"signed int", ElementType::Int32},
                                                         {"int32", ElementType::Int32},
                                                         {"int32_t", ElementType::Int32},
                                                         {"uint", ElementType::UInt32},
                                                         {"unsigned int", ElementType::UInt32},
                                                         {"uint32", ElementType::UInt32},
                                                         {"uint32_t", ElementType::UInt32},
                                                         {"longlong", ElementType::Int64},
                                                         {"long long", ElementType::Int64},
                                                         {"long long int", ElementType::Int64},
                                                         {"signed long long", ElementType::Int64},
                                                         {"signed long long int", ElementType::Int64},
                                                         {"int64", ElementType::Int64},
                                                         {"int64_t", ElementType::Int64},
                                                         {"ulonglong", ElementType::UInt64},
                                                         {"unsigned long long", ElementType::UInt64},
                                                         {"unsigned long long int", ElementType::UInt64},
                                                         {"uint64", ElementType::UInt64},
                                                         {"uint64_t", ElementType::UInt64},
                                                         {"float", ElementType::Float32},
                                                         {"double", ElementType::Float64}};

struct Space {
  glm::dvec3 lpsFrom;  ///< sign of each world axis
  bool anatomical;
};

/// Spaces with time are those without: time is an axis of its own.
Space spaceNamed(std::string name, const fs::path& path) {
  for (const std::string_view time : {"-time", "t"})
    if (name.ends_with(time) && (time != "t" || name.size() == 4)) name.resize(name.size() - time.size());
  if (name == "left-posterior-superior" || name == "lps") return {{1, 1, 1}, true};
  if (name == "right-anterior-superior" || name == "ras") return {{-1, -1, 1}, true};
  if (name == "left-anterior-superior" || name == "las") return {{1, -1, 1}, true};
  if (name.empty() || name == "scanner-xyz" || name == "3d-right-handed") return {{1, 1, 1}, false};
  // One axis must turn round, or the patient would be mirrored; which one, the space does not say.
  if (name == "3d-left-handed") return {{1, 1, -1}, false};
  throw Error(path, "its space '" + name + "' is not supported", "save it in a space such as left-posterior-superior");
}

/// Whether the components at each voxel are pictures of their own; colours, complex numbers and tensors are not.
bool isSeparate(const std::string& kind) {
  for (const char* known : {"list", "time", "???", "none", "stub", "scalar", "point"})
    if (kind == known) return true;
  return kind.ends_with("vector") || kind.ends_with("normal") || kind.ends_with("gradient");
}

class Reader {
 public:
  explicit Reader(const fs::path& path) : header_(readNrrdLines(path)) {
    image_.path = path;
    image_.format = "NRRD";
  }

  ImageFile read() {
    const std::string type = lowered(required("type"));
    const auto known = elementTypes.find(type);
    if (known == elementTypes.end())
      throw Error(image_.path, "has voxels of type '" + type + "'", "only volumes of numbers can be opened");
    image_.type = known->second;
    image_.fields = header_.pairs;
    readAxes();
    readGeometry();
    readEncoding();
    return std::move(image_);
  }

 private:
  std::string field(const char* name) const {
    const auto at = header_.fields.find(name);
    return at == header_.fields.end() ? std::string() : at->second;
  }
  std::string required(const char* name) const {
    const std::string value = field(name);
    if (value.empty()) throw Error(image_.path, std::string("its header has no ") + name, "the file is damaged");
    return value;
  }
  [[noreturn]] void refuseField(const char* name) const {
    throw Error(image_.path, std::string("its header's '") + name + "' is not understood", "the file is damaged");
  }

  /// Three spatial axes; axes before them are layers at each voxel, axes behind them volumes.
  void readAxes() {
    const auto sizes = numbersIn<std::int64_t>(required("sizes"));
    const auto dimension = numberIn<std::size_t>(required("dimension"));
    // 16: NRRD_DIM_MAX, the most axes the format's own library takes.
    if (!sizes || !dimension || sizes->size() != *dimension || sizes->empty() || sizes->size() > 16)
      refuseField("sizes");
    const auto directions = vectorsIn(field("spacedirections"));
    if (!directions || (!directions->empty() && directions->size() != sizes->size())) refuseField("space directions");
    const std::vector<std::string> kinds = words(field("kinds"));

    std::vector<std::size_t> spatial;
    const auto isSpatial = [&](std::size_t axis) {
      if (!directions->empty()) return (*directions)[axis] && !(*directions)[axis]->isTime();
      // ITK calls every axis of a series a domain.
      if (kinds.size() == sizes->size())
        return spatial.size() < 3 && (lowered(kinds[axis]) == "domain" || lowered(kinds[axis]) == "space");
      return sizes->size() <= 3 || axis < 3;
    };
    for (std::size_t axis = 0; axis < sizes->size(); ++axis) {
      const std::int64_t size = (*sizes)[axis];
      if (isSpatial(axis)) {
        if (!spatial.empty() && spatial.back() + 1 != axis) refuseField("kinds");
        spatial.push_back(axis);
        continue;
      }
      if (size < 1 || size > 1'000'000) refuseField("sizes");
      std::string kind = kinds.size() == sizes->size() ? lowered(kinds[axis]) : "list";
      if (kind == "domain" || kind == "space") kind = "time";  // a fourth axis
      if (size != 1 && !isSeparate(kind))
        throw Error(image_.path, "holds " + std::to_string(size) + " values at each voxel (" + kind + ")",
                    "only scalar volumes can be opened; extract one component first");
      (spatial.empty() ? image_.interleaved : image_.volumes) *= size;
      if (image_.layers() > 1'000'000) refuseField("sizes");
    }
    if (spatial.size() != 2 && spatial.size() != 3)
      throw Error(image_.path, "has " + std::to_string(spatial.size()) + " spatial axes", "a volume has three");
    setDims(image_, (*sizes)[spatial[0]], (*sizes)[spatial[1]], spatial.size() == 3 ? (*sizes)[spatial[2]] : 1);
    spatial_ = spatial;
  }

  /// Throws Error when the vectors of a field have another number of coordinates than the space: decimal commas make
  /// four numbers of three.
  void checkDimension(const char* name, const std::vector<std::optional<SpaceVector>>& vectors) const {
    const std::string space = lowered(field("space"));
    const std::size_t dimension = space.empty() ? numberIn<std::size_t>(field("spacedimension")).value_or(0)
                                  : space.ends_with("-time") || space.size() == 4 ? 4
                                                                                  : 3;
    for (const auto& vector : vectors)
      if (vector && dimension != 0 && vector->dimension != dimension)
        throw Error(image_.path,
                    std::string("its header's '") + name + "' is not understood: it has vectors of " +
                        std::to_string(vector->dimension) + " numbers in a space of " + std::to_string(dimension),
                    "write its numbers with decimal points, or get the file again");
  }

  /// Millimetres in the units that the header names: of the world's axes ("space units"), or else of the file's own
  /// axes ("units"), which files without directions have.
  void readUnits(bool hasDirections) {
    const std::vector<std::string> ofWorld = quotedWords(field("spaceunits")), ofAxes = quotedWords(field("units"));
    if (!ofWorld.empty() && (hasDirections || ofAxes.empty())) {
      for (std::size_t i = 0; i < 3; ++i)
        worldUnit_[static_cast<int>(i)] = millimetresOf(image_, ofWorld[std::min(i, ofWorld.size() - 1)]);
      return;
    }
    for (std::size_t i = 0; i < spatial_.size(); ++i)
      if (spatial_[i] < ofAxes.size()) axisUnit_[static_cast<int>(i)] = millimetresOf(image_, ofAxes[spatial_[i]]);
    // A position has no axis; it is in their common unit.
    if (spatial_.size() == 2) axisUnit_.z = axisUnit_.y;
    if (axisUnit_ == glm::dvec3(axisUnit_.x)) originUnit_ = axisUnit_.x;
  }

  void readGeometry() {
    const Space space = spaceNamed(lowered(field("space")), image_.path);
    const auto directions = *vectorsIn(field("spacedirections"));
    checkDimension("space directions", directions);
    readUnits(!directions.empty());
    glm::dmat3 columns(1.0);
    if (!directions.empty()) {
      for (std::size_t i = 0; i < spatial_.size(); ++i) columns[static_cast<int>(i)] = directions[spatial_[i]]->place;
      if (spatial_.size() == 2) columns[2] = glm::cross(glm::normalize(columns[0]), glm::normalize(columns[1]));
    } else {
      readSpacings(columns);
    }
    glm::dvec3 origin(0.0);
    if (const auto given = vectorsIn(field("spaceorigin")); given && given->size() == 1 && given->front()) {
      checkDimension("space origin", *given);
      origin = given->front()->place * originUnit_;
    } else if (!field("spaceorigin").empty()) {
      refuseField("space origin");
    }
    const glm::dvec3 lpsFrom = space.lpsFrom * worldUnit_;
    for (int column = 0; column < 3; ++column) columns[column] *= axisUnit_[column] * lpsFrom;
    if (!setGeometry(image_.grid, columns, origin * lpsFrom)) refuseField("space directions");
    if (directions.empty() || !space.anatomical)
      image_.warnings.push_back(
          {Warning::Kind::NoGeometry,
           std::string("the file does not say how its axes lie in the patient; they are taken as left, posterior, ") +
               (space.lpsFrom.z < 0 ? "inferior (its space is left-handed)" : "superior"),
           {image_.path}});
  }

  /// Per-axis spacings, of a file without directions.
  void readSpacings(glm::dmat3& columns) {
    const std::vector<std::string> spacings = words(field("spacings"));
    const auto numbers = headerNumbers(image_, "spacings", field("spacings"));
    bool garbled = false, negative = false;
    for (std::size_t i = 0; i < spatial_.size(); ++i) {
      const std::size_t axis = spatial_[i];
      std::optional<double> given;
      if (axis < spacings.size()) given = numbers ? (*numbers)[axis] : numberIn<double>(spacings[axis]);
      const bool usable = given && std::isfinite(*given) && *given != 0.0;
      garbled |= !usable;
      negative |= usable && *given < 0.0;
      if (usable) columns[static_cast<int>(i)] *= std::abs(*given);
    }
    const auto warn = [&](const char* text) {
      image_.warnings.push_back({Warning::Kind::NoGeometry, text, {image_.path}});
    };
    if (spacings.empty())
      warn("its header has no spacings; 1 mm is assumed");
    else if (garbled)
      warn("its spacings are not positive numbers; 1 mm is assumed for the others");
    if (negative) warn("its spacings are negative; the sign is ignored");
  }

  void readEncoding() {
    const std::string encoding = lowered(required("encoding"));
    VoxelSource& source = image_.source;
    if (encoding == "gzip" || encoding == "gz") {
      source.packing = Packing::Deflate;
    } else if (encoding == "bzip2" || encoding == "bz2") {
      source.packing = Packing::Bzip2;
    } else if (encoding == "ascii" || encoding == "text" || encoding == "txt") {
      source.text = VoxelText::Decimal;
    } else if (encoding == "hex") {
      source.text = VoxelText::Hexadecimal;
    } else if (encoding != "raw") {
      throw Error(image_.path, "its encoding '" + encoding + "' is not supported",
                  "save it as raw, gzip, bzip2, hex or ascii");
    }
    const std::string endian = lowered(field("endian"));
    if (sizeOf(image_.type) > 1 && source.text != VoxelText::Decimal && endian != "little" && endian != "big")
      refuseField("endian");
    image_.bigEndian = endian == "big";

    const std::string lines = header_.fields.contains("lineskip") ? field("lineskip") : "0";
    const std::string bytes = header_.fields.contains("byteskip") ? field("byteskip") : "0";
    const auto lineSkip = numberIn<std::uint64_t>(lines);
    const auto byteSkip = numberIn<std::int64_t>(bytes);
    if (!lineSkip) refuseField("line skip");
    if (!byteSkip || *byteSkip < -1 || (*byteSkip == -1 && source.text != VoxelText::None)) refuseField("byte skip");
    source.lines = *lineSkip;
    source.skip = *byteSkip;
    readDataFiles();
  }

  void readDataFiles() {
    VoxelSource& source = image_.source;
    const std::string dataFile = field("datafile");
    if (dataFile.empty()) {
      source.files = {image_.path};
      source.offset = header_.bytes;
      return;
    }
    const auto add = [&](const std::string& name) { source.files.push_back(besideHeader(image_.path, name)); };
    const std::vector<std::string> parts = words(dataFile);
    if (parts[0] == "LIST") {
      for (const std::string& name : header_.listed) add(name);
    } else if (parts.size() >= 4 && parts[0].find('%') != std::string::npos) {
      const auto first = numberIn<long>(parts[1]), last = numberIn<long>(parts[2]), step = numberIn<long>(parts[3]);
      constexpr long most = 1'000'000;
      if (!first || !last || !step || *step == 0 || std::abs(*first) > most || std::abs(*last) > most ||
          std::abs(*step) > most)
        refuseField("data file");
      for (long number = *first; *step > 0 ? number <= *last : number >= *last; number += *step)
        add(numberedName(parts[0], number, image_.path));
    } else {
      add(dataFile);
    }
    if (source.files.empty()) refuseField("data file");
  }

  NrrdHeader header_;
  ImageFile image_;
  std::vector<std::size_t> spatial_;
  glm::dvec3 worldUnit_{1.0}, axisUnit_{1.0};  ///< mm
  double originUnit_ = 1.0;                    ///< mm
};

}  // namespace

bool looksLikeNrrd(const FileStart& start) {
  constexpr std::string_view magic = "NRRD000";
  const std::span<const std::byte> bytes = start.stored();
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

ImageFile readNrrdHeader(const fs::path& path) { return Reader(path).read(); }

}  // namespace fenestra::io
