#include <algorithm>
#include <array>

#include <zlib.h>

#include "io/VolumeWriter.h"
#include "io/session/LookFile.h"
#include "io/session/SessionFile.h"
#include "io/session/StrokeFile.h"
#include "tests/fuzz/TableSeeds.h"
#include "tests/fuzz/Targets.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/io/NiftiBytes.h"
#include "tests/io/TiffFiles.h"
#include "tests/session/SessionTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::fuzz {
namespace fs = std::filesystem;
namespace {

using tests::bytesOf;
using tests::readFile;

std::vector<std::string> dicomSeeds(const fs::path& folder) {
  using tests::Syntax;
  std::vector<std::string> seeds;
  tests::DicomSpec spec;
  const auto add = [&] {
    tests::writeDicom(folder / "a", spec);
    seeds.push_back(readFile(folder / "a"));
  };
  for (const Syntax syntax : {Syntax::ExplicitLittle, Syntax::ImplicitLittle, Syntax::ExplicitBig, Syntax::Deflated,
                              Syntax::Rle, Syntax::JpegLossless, Syntax::JpegLs}) {
    spec.syntax = syntax;
    add();
  }
  spec.syntax = Syntax::Rle;
  spec.frames = {tests::FrameSpec{{0, 0, 0}}, tests::FrameSpec{{0, 0, 1}}};
  add();
  return seeds;
}

Volume smallVolume() {
  Volume volume;
  volume.grid.dims = {4, 3, 2};
  volume.voxels = Voxels(ScalarType::Int16, 24);
  for (std::size_t i = 0; i < 24; ++i) volume.voxels.as<std::int16_t>()[i] = static_cast<std::int16_t>(i * 40 - 300);
  return volume;
}

std::vector<std::string> volumeSeeds(const fs::path& folder, std::initializer_list<const char*> names) {
  std::vector<std::string> seeds;
  for (const char* name : names) {
    io::writeVolume(smallVolume(), folder / name);
    seeds.push_back(readFile(folder / name));
  }
  return seeds;
}

std::vector<std::string> nrrdSeeds(const fs::path& folder) {
  std::vector<std::string> seeds = volumeSeeds(folder, {"a.nrrd"});
  const std::string raw = bytesOf(std::vector<std::uint8_t>(24, 7));
  const std::string header =
      "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 4 3 2\nspace: left-posterior-superior\n"
      "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n";
  seeds.push_back(header + "encoding: gzip\n\n" + tests::gzipped(raw));
  seeds.push_back(
      "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 2 3 2 2\nkinds: vector domain domain domain\nspacings: nan 7,5 800 "
      "2500\n"
      "units: \"\" \"um\" \"microns\" \"\xB5m\"\nencoding: raw\n\n" +
      raw);
  seeds.push_back(header + "encoding: ascii\n\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24");
  return seeds;
}

/// With a label table among its extensions, as TotalSegmentator writes it.
std::string extendedNiftiSeed() {
  std::string header = tests::niftiHeader({.dims = {4, 3, 2}, .datatype = 2});
  std::string table =
      "<LabelTable><Label Key=\"1\" Red=\"1\" Green=\"0\" Blue=\"0\"><![CDATA[a]]></Label></LabelTable>";
  table.resize(104, ' ');
  header[348] = 1;
  const std::string offset = bytesOf(static_cast<float>(header.size() + 8 + table.size()));
  std::copy(offset.begin(), offset.end(), header.begin() + 108);
  return header + bytesOf(std::int32_t{112}) + bytesOf(std::int32_t{0}) + table + std::string(24, '\1');
}

std::vector<std::string> labelSeeds(const std::filesystem::path& folder) {
  tests::SegSpec segments;
  segments.frames = {{1, glm::dvec3(0, 0, 1), std::vector<int>(15, 1)},
                     {1, glm::dvec3(0, 0, 3), std::vector<int>(15, 1)}};
  tests::writeSeg(folder / "seg.dcm", segments);
  segments.type = "LABELMAP";
  segments.bits = 8;
  tests::writeSeg(folder / "map.dcm", segments);
  tests::RtSpec contours;
  contours.rois = {{1, "heart", "255\\0\\0", {{tests::rectangle(0, 0, 3, 3, 1), "CLOSED_PLANAR", {}, {}}}}};
  tests::writeRtStruct(folder / "plan.dcm", contours);

  const std::string raw = bytesOf(std::vector<std::uint8_t>(24, 1));
  return {
      "NRRD0004\ntype: uchar\ndimension: 3\nspace: LPS\nsizes: 4 3 2\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
      "encoding: raw\nSegment0_ID:=a\nSegment0_Name:=kidney\nSegment0_LabelValue:=1\nSegment0_Color:=1 0 0.5\n"
      "Segment0_Layer:=0\n\n" +
          raw,
      extendedNiftiSeed(), readFile(folder / "seg.dcm"), readFile(folder / "map.dcm"), readFile(folder / "plan.dcm")};
}

std::vector<std::string> tiffSeeds(const fs::path& folder) {
  std::vector<std::string> seeds;
  for (const char* mode : {"wl", "wb", "wl8"})
    for (const int compression : {1, 5, 8, 32773})
      for (const bool tiled : {false, true}) {
        tests::TiffSpec spec{.pages = 2, .compression = compression, .tiled = tiled, .mode = mode};
        spec.description = "ImageJ=1.53t\nimages=2\nslices=2\nunit=um\nspacing=3\n";
        spec.resolution = 0.5;
        tests::writeTiff(folder / "a.tif", spec);
        seeds.push_back(readFile(folder / "a.tif"));
      }
  return seeds;
}

std::string mghSeed() {
  std::string bytes;
  for (const std::int32_t value : {1, 4, 3, 2, 1, 0, 0}) bytes += bytesOf(value, true);
  bytes += bytesOf(std::int16_t{1}, true);
  for (const float value : {1.f, 1.f, 1.f, -1.f, 0.f, 0.f, 0.f, 0.f, -1.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f})
    bytes += bytesOf(value, true);
  bytes.resize(284 + 24);
  return bytes;
}

/// A zip with one stored file, field by field as APPNOTE.TXT lists them; its checksum is not set, which readers notice
/// last.
std::string zipSeed(const std::string& content) {
  const std::string name = "a.nrrd";
  const uLong checksum = ::crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
  const auto sizes = bytesOf(static_cast<std::uint32_t>(checksum)) +
                     bytesOf(static_cast<std::uint32_t>(content.size())) +
                     bytesOf(static_cast<std::uint32_t>(content.size())) +
                     bytesOf(static_cast<std::uint16_t>(name.size())) + bytesOf(std::uint16_t{0});
  const std::string common = bytesOf(std::uint16_t{20}) + std::string(8, '\0') + sizes;
  const std::string local = "PK\x03\x04" + common + name + content;
  const std::string central = "PK\x01\x02" + bytesOf(std::uint16_t{20}) + common + std::string(14, '\0') + name;
  return local + central + "PK\x05\x06" + std::string(4, '\0') + bytesOf(std::uint16_t{1}) + bytesOf(std::uint16_t{1}) +
         bytesOf(static_cast<std::uint32_t>(central.size())) + bytesOf(static_cast<std::uint32_t>(local.size())) +
         bytesOf(std::uint16_t{0});
}

/// The rows of the tables that open, but for those whose files' names part them: names are not packed.
std::vector<tests::Defect> goodRows() {
  std::vector<tests::Defect> rows = tests::allDefects();
  std::erase_if(rows, [](const tests::Defect& row) {
    return row.expected.outcome == tests::Outcome::Error || row.expected.says.find("whose names") != std::string::npos;
  });
  return rows;
}

/// Two pixels of 8 and of 16 bits in each encoding of ByteCodecs.h; the first two bytes as the target reads them.
std::vector<std::string> codecSeeds() {
  const auto rle = [](int segments, const std::string& runs) {
    std::string header = bytesOf(static_cast<std::uint32_t>(segments));
    for (int i = 0; i < segments; ++i) header += bytesOf(static_cast<std::uint32_t>(64 + 4 * i));
    header.resize(64);
    return header + runs;
  };
  return {std::string("\x00\x01", 2) + rle(1, std::string("\x01\x07\x09\x00", 4)),
          std::string("\x03\x01", 2) + rle(2, std::string("\x01\x00\x01\x00\xff\x05\x00\x00", 8)),
          std::string("\x01\x01\x07\x09", 4),
          std::string("\x04\x01\x07\x00\x09\x00", 6),
          std::string("\x05\x03\x5a\x10\x27\xa5\x02\xff", 8),
          std::string("\x05\x00\x5a\x10\x27", 5)};
}

/// Answers to a search, with a name in two writings, to objects that were sent (PS3.18 annex F, 10.5.3), and of an
/// object with two frames.
std::vector<std::string> webJsonSeeds() {
  return {R"([{"00100010": {"vr": "PN", "Value": [{"Alphabetic": "Yamada^Tarou", "Ideographic": "山田^太郎"}]},
               "00080061": {"vr": "CS", "Value": ["CT", "MR"]}, "00201208": {"vr": "IS", "Value": [12]}}])",
          R"({"00081199": {"vr": "SQ", "Value": [{"00081150": {"vr": "UI", "Value": ["1.2"]}}]}})",
          R"({"00081198": {"vr": "SQ", "Value": [{"00081197": {"vr": "US", "Value": [272]}}]}})", "[]",
          R"([{"00280004": {"vr": "CS", "Value": ["MONOCHROME2"]}, "00280008": {"vr": "IS", "Value": ["2"]},
               "00280010": {"vr": "US", "Value": [4]}, "00280011": {"vr": "US", "Value": [4]},
               "00280100": {"vr": "US", "Value": [16]}, "52009229": {"vr": "SQ", "Value": [{"00289110":
               {"vr": "SQ", "Value": [{"00280030": {"vr": "DS", "Value": [0.5, 0.5]}}]}}]}, "52009230": {"vr": "SQ",
               "Value": [{}, {"00289145": {"vr": "SQ", "Value": [{"00281052": {"vr": "DS", "Value": [-1024]}}]}}]}}])"};
}

/// Two parts, whole and in pieces of three bytes.
std::vector<std::string> webMultipartSeeds() {
  const std::string type = "multipart/related; type=\"application/dicom\"; boundary=\"b-1\"\n",
                    message =
                        "--b-1\r\nContent-Type: application/dicom\r\n\r\nDICM\r\n--b\r\n--b-1\r\n\r\n\r\n--b-1--\r\n";
  return {"\xff" + type + message, "\x02" + type + message};
}

std::string bigEndian(std::size_t value, int bytes) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 0xff);
  return text;
}
std::string littleEndian(std::size_t value, int bytes) {
  std::string text = bigEndian(value, bytes);
  std::ranges::reverse(text);
  return text;
}

/// An item of an association's request (PS3.8 9.3.2), and a PDU (9.3.1).
std::string associationItem(char type, const std::string& bytes) {
  return std::string{type, '\0'} + bigEndian(bytes.size(), 2) + bytes;
}
std::string pdu(char type, const std::string& bytes) {
  return std::string{type, '\0'} + bigEndian(bytes.size(), 4) + bytes;
}

/// `roles`: an item that says who provides the class (PS3.7 D.3.3.4); may be empty.
std::string associationRequest(const std::string& objectClass, const std::string& roles = {}) {
  const auto title = [](std::string text) { return text + std::string(16 - text.size(), ' '); };
  const std::string context =
      std::string("\x01\0\0\0", 4) + associationItem(0x30, objectClass) + associationItem(0x40, "1.2.840.10008.1.2");
  const std::string user =
      associationItem(0x51, bigEndian(16384, 4)) + associationItem(0x52, "1.2.276.0.7230010.3.0.3.6.7") + roles;
  return pdu(1, bigEndian(0x10000, 4) + title("FENESTRA") + title("ARCHIVE") + std::string(32, '\0') +
                    associationItem(0x10, "1.2.840.10008.3.1.1.1") + associationItem(0x20, context) +
                    associationItem(0x50, user));
}

/// A data element in implicit little endian (PS3.5 7.1.3), padded to an even length.
std::string implicitElement(int group, int element, std::string value) {
  if (value.size() % 2 == 1) value += '\0';
  return littleEndian(static_cast<std::size_t>(group), 2) + littleEndian(static_cast<std::size_t>(element), 2) +
         littleEndian(value.size(), 4) + value;
}

/// A message in fragments of at most `most` bytes; `kind` 1: a command, 0: data (PS3.8 E.2).
std::string sentAs(const std::string& bytes, char kind, std::size_t most) {
  std::string pdus;
  for (std::size_t at = 0; at < bytes.size(); at += most) {
    const std::string piece = bytes.substr(at, most);
    const char control = static_cast<char>(kind | (at + most >= bytes.size() ? 2 : 0));
    pdus += pdu(4, bigEndian(piece.size() + 2, 4) + std::string{'\1', control} + piece);
  }
  return pdus;
}

/// An association with a command and its data, and the release; and the same in fragments of ten bytes.
std::vector<std::string> conversation(const std::string& request, const std::string& fields, const std::string& data) {
  const std::string command = implicitElement(0, 0, littleEndian(fields.size(), 4)) + fields;
  const std::string release = pdu(5, std::string(4, '\0'));
  std::vector<std::string> seeds;
  for (const std::size_t most : {std::size_t{4096}, std::size_t{10}})
    seeds.push_back(request + sentAs(command, 1, most) + sentAs(data, 0, most) + release);
  return seeds;
}

const std::string ctImage = "1.2.840.10008.5.1.4.1.1.2", soughtObject = "1.2.3.4.5";

/// A storage of the object that the target `provider` waits for.
std::vector<std::string> providerSeeds() {
  const std::string fields = implicitElement(0, 0x0002, ctImage) + implicitElement(0, 0x0100, littleEndian(1, 2)) +
                             implicitElement(0, 0x0110, littleEndian(1, 2)) +
                             implicitElement(0, 0x0700, littleEndian(0, 2)) +
                             implicitElement(0, 0x0800, littleEndian(0, 2)) + implicitElement(0, 0x1000, soughtObject);
  const std::string data = implicitElement(8, 0x16, ctImage) + implicitElement(8, 0x18, soughtObject) +
                           implicitElement(0x20, 0x0d, "1.2.3") + implicitElement(0x20, 0x0e, "1.2.3.4") +
                           implicitElement(0x28, 0x10, littleEndian(2, 2)) + implicitElement(0x7fe0, 0x10, "pixels");
  return conversation(associationRequest(ctImage), fields, data);
}

/// Reports that the target `commitment` waits for: its object is kept, and it is not.
std::vector<std::string> commitmentSeeds() {
  const std::string service = "1.2.840.10008.1.20.1", instance = "1.2.840.10008.1.20.1.1";
  // The peer provides the service: no user's role, but the provider's.
  const std::string roles = associationItem(0x54, bigEndian(service.size(), 2) + service + std::string("\0\1", 2));
  std::vector<std::string> seeds;
  for (const bool isKept : {true, false}) {
    const std::string fields =
        implicitElement(0, 0x0002, service) + implicitElement(0, 0x0100, littleEndian(0x0100, 2)) +
        implicitElement(0, 0x0110, littleEndian(1, 2)) + implicitElement(0, 0x0800, littleEndian(0, 2)) +
        implicitElement(0, 0x1000, instance) + implicitElement(0, 0x1002, littleEndian(isKept ? 1 : 2, 2));
    const std::string item = implicitElement(8, 0x1150, ctImage) + implicitElement(8, 0x1155, soughtObject) +
                             (isKept ? "" : implicitElement(8, 0x1197, littleEndian(0x0112, 2)));
    const std::string items = std::string("\xfe\xff\x00\xe0", 4) + littleEndian(item.size(), 4) + item;
    const std::string data =
        implicitElement(8, 0x1195, "1.2.3.9") + implicitElement(8, isKept ? 0x1199 : 0x1198, items);
    for (std::string& seed : conversation(associationRequest(service, roles), fields, data))
      seeds.push_back(std::move(seed));
  }
  return seeds;
}

}  // namespace

std::vector<std::string> seedsOf(const Target& target) {
  const fs::path folder = fs::temp_directory_path() / "fenestra-seeds";
  fs::create_directories(folder);
  if (target.name == "dicom" || target.name == "deidentify") return dicomSeeds(folder);
  if (target.name == "byte-codecs") return codecSeeds();
  for (const char* name : {"dicom-series", "tiff-folder", "label-table", "masks"})
    if (target.name == name) return tableSeeds(target, goodRows());
  if (target.name == "nifti") return volumeSeeds(folder, {"a.nii", "a.nii.gz"});
  if (target.name == "nrrd") return nrrdSeeds(folder);
  if (target.name == "metaimage") return volumeSeeds(folder, {"a.mha"});
  if (target.name == "mgh") return {mghSeed(), tests::gzipped(mghSeed())};
  if (target.name == "tiff") return tiffSeeds(folder);
  if (target.name == "archive") return {zipSeed(nrrdSeeds(folder).front())};
  if (target.name == "labels") return labelSeeds(folder);
  if (target.name == "web-json") return webJsonSeeds();
  if (target.name == "web-multipart") return webMultipartSeeds();
  if (target.name == "provider") return providerSeeds();
  if (target.name == "commitment") return commitmentSeeds();
  if (target.name == "session") return {io::textOf(tests::fullSession(folder), folder / "a.fenestra")};
  if (target.name == "look") {
    io::writeLook(folder / "a.json", {"x",
                                      "HU",
                                      tests::fullSession(folder).look,
                                      R"({"a": [1]})",
                                      {{"liver", {{{-20.0, {}}, {150.0, {{0.9, 0.3, 0.2}, 0.75}}}}}, {"7", {}}}});
    return {readFile(folder / "a.json")};
  }
  if (target.name == "strokes") {
    io::writeStrokes(folder / "a.json", tests::fullSession(folder).look.strokes);
    return {readFile(folder / "a.json")};
  }
  return {R"({"name": "x", "domain": "value", "nodes": [
    {"value": -100, "colour": [1, 0, 0], "opacity": 0}, {"value": 300, "colour": [1, 1, 1], "opacity": 0.5}]})"};
}

}  // namespace fenestra::fuzz
