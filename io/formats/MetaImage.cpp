// MetaImage (.mha, .mhd). Definition: itk.org/Wiki/MetaIO/Documentation.

#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "io/base/Text.h"
#include "io/formats/ImageFile.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t longestHeader = 1u << 20;

const std::map<std::string, ElementType> elementTypes = {
    {"MET_CHAR", ElementType::Int8},         {"MET_UCHAR", ElementType::UInt8},   {"MET_SHORT", ElementType::Int16},
    {"MET_USHORT", ElementType::UInt16},     {"MET_INT", ElementType::Int32},     {"MET_UINT", ElementType::UInt32},
    {"MET_LONG", ElementType::Int32},        {"MET_ULONG", ElementType::UInt32},  {"MET_LONG_LONG", ElementType::Int64},
    {"MET_ULONG_LONG", ElementType::UInt64}, {"MET_FLOAT", ElementType::Float32}, {"MET_DOUBLE", ElementType::Float64}};

struct Header {
  std::map<std::string, std::string> fields;
  std::vector<std::string> listed;  ///< data files after "ElementDataFile = LIST"
  std::uint64_t bytes = 0;          ///< up to and with the ElementDataFile line
};

/// Reads up to and with the ElementDataFile line, the header's last; empty when the text is no MetaImage header.
std::optional<Header> readLines(const fs::path& path) {
  const auto stream = openStream(path, 0, Packing::None);
  Header header;
  std::vector<char> buffer(16 * 1024);
  std::string line;
  bool listing = false;
  for (;;) {
    const std::size_t got = stream->read(reinterpret_cast<std::byte*>(buffer.data()), buffer.size());
    for (std::size_t at = 0; at < got || got == 0; ++at) {
      if (got != 0) {
        ++header.bytes;
        const char c = buffer[at];
        if (c != '\n') {
          line += c;
          if (header.bytes > longestHeader || c == '\0') return std::nullopt;
          continue;
        }
      }
      const std::string text = trimmed(line);
      line.clear();
      if (listing) {
        if (!text.empty()) header.listed.push_back(text);
      } else if (!text.empty()) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos) return std::nullopt;
        const std::string name = trimmed(text.substr(0, equals)), value = trimmed(text.substr(equals + 1));
        header.fields[name] = value;
        if (name == "ElementDataFile") {
          listing = !words(value).empty() && words(value)[0] == "LIST";
          if (!listing) return header;
        }
      }
      if (got == 0) return listing ? std::optional(header) : std::nullopt;
    }
  }
}

class Reader {
 public:
  Reader(const fs::path& path, Header header) : header_(std::move(header)) {
    image_.path = path;
    image_.format = "MetaImage";
  }

  ImageFile read() {
    const std::string type = field({"ElementType"});
    const auto known = elementTypes.find(type);
    if (known == elementTypes.end())
      throw Error(image_.path, "has voxels of type '" + type + "'", "only volumes of numbers can be opened");
    image_.type = known->second;
    const auto channels = numberIn<int>(field({"ElementNumberOfChannels"}, "1"));
    if (!channels || *channels != 1)
      throw Error(image_.path, "holds " + field({"ElementNumberOfChannels"}) + " values at each voxel",
                  "only scalar volumes can be opened; extract one component first");

    const auto rank = numberIn<int>(field({"NDims"}));
    const auto dims = numbersIn<std::int64_t>(field({"DimSize"}));
    // 10: META_MAX_DIMS, the most axes the format's own library takes.
    if (!rank || *rank < 2 || *rank > 10 || !dims || dims->size() != static_cast<std::size_t>(*rank)) refuse("DimSize");
    rank_ = *rank;
    setDims(image_, (*dims)[0], (*dims)[1], rank_ > 2 ? (*dims)[2] : 1);
    for (std::size_t axis = 3; axis < dims->size(); ++axis) {
      if ((*dims)[axis] < 1 || (*dims)[axis] > 1'000'000) refuse("DimSize");
      image_.volumes *= (*dims)[axis];
      if (image_.volumes > 1'000'000) refuse("DimSize");
    }
    image_.slope = number({"ElementToIntensityFunctionSlope"}, 1.0);
    if (image_.slope == 0.0) {
      image_.slope = 1.0;
      image_.warnings.push_back(
          {Warning::Kind::Other, "its ElementToIntensityFunctionSlope is 0; 1 is assumed", {image_.path}});
    }
    image_.intercept = number({"ElementToIntensityFunctionOffset"}, 0.0);
    const std::string modality = field({"Modality"});
    if (modality == "MET_MOD_CT") image_.modality = Modality::CT;
    if (modality == "MET_MOD_MR") image_.modality = Modality::MR;
    if (modality == "MET_MOD_NM") image_.modality = Modality::PT;
    if (modality == "MET_MOD_US") image_.modality = Modality::US;
    readGeometry();
    readEncoding();
    return std::move(image_);
  }

 private:
  /// The first of `names` that the header has.
  std::string field(std::initializer_list<const char*> names, const char* otherwise = "") const {
    for (const char* name : names)
      if (const auto at = header_.fields.find(name); at != header_.fields.end()) return at->second;
    return otherwise;
  }
  double number(std::initializer_list<const char*> names, double otherwise) {
    const std::string text = field(names);
    if (text.empty()) return otherwise;
    const auto values = headerNumbers(image_, *names.begin(), text);
    if (!values || values->size() != 1 || !std::isfinite(values->front())) refuse(*names.begin());
    return values->front();
  }
  /// As many numbers as there are axes (`each` of them for every axis); empty when the header has none of `names`.
  std::vector<double> numbers(std::initializer_list<const char*> names, int each = 1) {
    const std::string text = field(names);
    if (text.empty()) return {};
    const auto values = headerNumbers(image_, *names.begin(), text);
    if (!values || values->size() != static_cast<std::size_t>(rank_ * each)) refuse(*names.begin());
    return *values;
  }
  bool flag(std::initializer_list<const char*> names) const {
    const std::string text = lowered(field(names));
    return !text.empty() && (text[0] == 't' || text[0] == 'y' || text[0] == '1');
  }
  [[noreturn]] void refuse(const char* name) const {
    throw Error(image_.path, std::string("its header's ") + name + " is not understood", "the file is damaged");
  }

  void readGeometry() {
    std::vector<double> spacing = numbers({"ElementSpacing"});
    if (spacing.empty()) spacing = numbers({"ElementSize"});
    const std::vector<double> matrix = numbers({"TransformMatrix", "Rotation", "Orientation"}, rank_);
    const std::vector<double> offset = numbers({"Offset", "Position", "Origin"});
    const auto warn = [&](const char* text) {
      image_.warnings.push_back({Warning::Kind::NoGeometry, text, {image_.path}});
    };
    if (spacing.empty()) warn("its header has no ElementSpacing; 1 mm is assumed");
    // MetaIO writes it since 2019: "mm", "um", "cm", or "?".
    const double unit = millimetresOf(image_, field({"DistanceUnits"}));
    glm::dmat3 columns(1.0);
    glm::dvec3 origin(0.0);
    bool negative = false;
    const int axes = std::min(rank_, 3);
    for (int axis = 0; axis < axes; ++axis) {
      // The matrix is written axis by axis: its first three numbers are where the first index axis points.
      if (!matrix.empty())
        for (int row = 0; row < axes; ++row) columns[axis][row] = matrix[static_cast<std::size_t>(axis * rank_ + row)];
      const double length = glm::length(columns[axis]);
      if (!(length > 0.0)) refuse("TransformMatrix");
      columns[axis] /= length;
      const double step = spacing.empty() ? 1.0 : std::abs(spacing[static_cast<std::size_t>(axis)]);
      negative |= !spacing.empty() && spacing[static_cast<std::size_t>(axis)] < 0.0;
      columns[axis] *= step;
      if (!offset.empty()) origin[axis] = offset[static_cast<std::size_t>(axis)];
    }
    if (negative) warn("its ElementSpacing is negative; the sign is ignored");
    if (!setGeometry(image_.grid, columns * unit, origin * unit)) refuse("ElementSpacing or TransformMatrix");
  }

  void readEncoding() {
    VoxelSource& source = image_.source;
    image_.bigEndian = flag({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
    if (flag({"CompressedData"})) source.packing = Packing::Deflate;
    // Absent means text in the definition; every writer of the last twenty years says True, and so do readers.
    if (header_.fields.contains("BinaryData") && !flag({"BinaryData"})) source.text = VoxelText::Decimal;
    const auto skip = numberIn<std::int64_t>(field({"HeaderSize"}, "0"));
    if (!skip || *skip < -1) refuse("HeaderSize");
    source.skip = *skip;

    const std::string dataFile = field({"ElementDataFile"});
    const std::vector<std::string> parts = words(dataFile);
    if (parts.empty()) refuse("ElementDataFile");
    const auto add = [&](const std::string& name) { source.files.push_back(besideHeader(image_.path, name)); };
    if (lowered(parts[0]) == "local") {
      source.files = {image_.path};
      source.offset = header_.bytes;
      source.skip = 0;
    } else if (parts[0] == "LIST") {
      for (const std::string& name : header_.listed) add(name);
    } else if (parts[0].find('%') != std::string::npos) {
      const auto bound = [&](std::size_t at, long otherwise) {
        return at < parts.size() ? numberIn<long>(parts[at]) : std::optional<long>(otherwise);
      };
      const auto first = bound(1, 1), last = bound(2, image_.grid.dims.z), step = bound(3, 1);
      constexpr long most = 1'000'000;
      if (!first || !last || !step || *step < 1 || std::abs(*first) > most || std::abs(*last) > most)
        refuse("ElementDataFile");
      for (long n = *first; n <= *last; n += *step) add(numberedName(parts[0], n, image_.path));
    } else {
      add(dataFile);
    }
    if (source.files.empty()) refuse("ElementDataFile");
  }

  Header header_;
  ImageFile image_;
  int rank_ = 3;
};

/// False where readLines() would find no "NAME = VALUE" in the first line.
bool mayStartWithField(const FileStart& start) {
  const std::string text(reinterpret_cast<const char*>(start.stored().data()), start.stored().size());
  const std::string line = text.substr(0, text.find('\n'));
  if (line.find('\0') != std::string::npos) return false;
  return line.size() == text.size() || trimmed(line).empty() || line.find('=') != std::string::npos;
}

}  // namespace

bool looksLikeMetaImage(const FileStart& start) {
  if (!mayStartWithField(start)) return false;
  const auto header = readLines(start.path());
  return header && header->fields.contains("NDims") && header->fields.contains("DimSize");
}

ImageFile readMetaImageHeader(const fs::path& path) {
  auto header = readLines(path);
  if (!header) throw Error(path, "has no MetaImage header", "the file is damaged or no MetaImage file");
  return Reader(path, std::move(*header)).read();
}

}  // namespace fenestra::io
