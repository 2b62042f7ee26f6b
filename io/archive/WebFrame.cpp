#include "io/archive/WebFrame.h"

#include <array>
#include <cstddef>
#include <optional>
#include <system_error>
#include <vector>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcfilefo.h>
#include <dcmtk/dcmdata/dcuid.h>

#include "io/archive/Http.h"
#include "io/archive/Multipart.h"
#include "io/archive/Task.h"
#include "io/archive/WebAnswers.h"
#include "io/base/Text.h"
#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io::archive {
namespace {

namespace fs = std::filesystem;

/// Whether a message's type is that of samples in explicit or implicit little endian. Servers put the transfer syntax
/// into the type's quotes, beside it, or leave it out.
bool isOfSamples(const std::string& contentType) {
  std::string type = lowered(contentType);
  std::erase_if(type, [](char c) { return c == '"' || c == ' '; });
  bool isSamples = true;
  for (const std::string& part : split(type, ';')) {
    if (part.starts_with("type=")) isSamples = isSamples && part == "type=application/octet-stream";
    if (part.starts_with("transfer-syntax="))
      isSamples = isSamples && (part == "transfer-syntax=1.2.840.10008.1.2.1" ||  // explicit
                                part == "transfer-syntax=1.2.840.10008.1.2");     // implicit
  }
  return isSamples;
}

/// The one part of the message at `path`, of `size` bytes, or one more of an odd size (PS3.5 8.1.1). Empty otherwise.
std::string samplesAt(Http& http, const std::string& path, std::uint64_t size) {
  constexpr std::uint64_t most = 64u << 10;  // of what stands around the part
  const std::uint64_t padded = size + size % 2;
  std::optional<Multipart> parts;
  std::string samples;
  int count = 0;
  const auto sinkFor = [&](const Http::Answer& answer) -> Http::Sink {
    const std::optional<std::string> boundary = boundaryIn(answer.type);
    if (!boundary || !isOfSamples(answer.type)) return [](std::string_view) { return false; };
    parts.emplace(*boundary,
                  Multipart::Handler{[&] { ++count; }, [&](std::string_view bytes) { samples += bytes; }, [] {}});
    return [&](std::string_view bytes) { return parts->push(bytes) && count <= 1 && samples.size() <= padded; };
  };
  const Http::Answer answer =
      http.get(path, R"(multipart/related; type="application/octet-stream"; transfer-syntax=1.2.840.10008.1.2.1)",
               sinkFor, padded + most);
  const bool isWhole = answer.status / 100 == 2 && parts && parts->isComplete() && count == 1;
  if (!isWhole || (samples.size() != size && samples.size() != padded)) return {};
  samples.resize(padded, '\0');
  return samples;
}

void writeFrame(const FrameHeader& header, const std::string& samples, const fs::path& path) {
  DcmFileFormat file;
  DcmDataset& data = *file.getDataset();
  bool isGood = true;
  const auto put = [&](const DcmTagKey& tag, const std::string& value) {
    isGood = isGood && data.putAndInsertString(tag, value.c_str()).good();
  };
  const auto count = [&](const DcmTagKey& tag, int value) {
    isGood = isGood && data.putAndInsertUint16(tag, static_cast<Uint16>(value)).good();
  };
  put(DCM_SOPClassUID, UID_SecondaryCaptureImageStorage);
  for (const DcmTagKey& tag : {DCM_SOPInstanceUID, DCM_SeriesInstanceUID, DCM_StudyInstanceUID}) {
    std::array<char, 100> uid;
    put(tag, dcmGenerateUniqueIdentifier(uid.data()));
  }
  put(DCM_Modality, header.modality);
  put(DCM_PhotometricInterpretation, header.photometric);
  count(DCM_SamplesPerPixel, 1);
  count(DCM_Rows, header.rows);
  count(DCM_Columns, header.columns);
  count(DCM_BitsAllocated, header.bitsAllocated);
  count(DCM_BitsStored, header.bitsStored);
  count(DCM_HighBit, header.highBit);
  count(DCM_PixelRepresentation, header.isSigned ? 1 : 0);
  for (const FrameHeader::Value& each : header.meaning) {
    std::string text;
    for (const double number : each.numbers) text += (text.empty() ? "" : "\\") + decimalText(number);
    put({static_cast<Uint16>(each.tag >> 16), static_cast<Uint16>(each.tag & 0xffff)}, text);
  }
  // DCMTK keeps words in the order of this machine, and writes them in that of the file.
  std::vector<Uint16> words(samples.size() / 2);
  for (std::size_t i = 0; i < words.size(); ++i)
    words[i] = static_cast<Uint16>(static_cast<unsigned char>(samples[2 * i]) |
                                   static_cast<unsigned char>(samples[2 * i + 1]) << 8);
  isGood = isGood && data.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size()).good() &&
           file.saveFile(path.c_str(), EXS_LittleEndianExplicit).good();
  if (!isGood) throw Error(path, "cannot be written", "make room, and try again");
}

}  // namespace

bool fetchFrame(const WebServer& server, const FramePlace& place, const fs::path& file, const Progress& progress) {
  prepareDcmtk();
  Task task(server.limits, progress, "fetching a frame");
  Http http(server, task);
  const std::string object = "/studies/" + http.escaped(place.study) + "/series/" + http.escaped(place.series) +
                             "/instances/" + http.escaped(place.object);
  const Http::Answer said = http.get(object + "/metadata", "application/dicom+json");
  if (said.status == 401 || said.status == 403) refuseStatus(server, said.status);
  if (said.status / 100 != 2) return false;
  const std::optional<FrameHeader> header = frameHeaderIn(said.body, place.number);
  if (!header || header->bytes() > mostFrameBytes) return false;
  const std::string samples = samplesAt(http, object + "/frames/" + std::to_string(place.number), header->bytes());
  if (samples.empty()) return false;
  try {
    writeFrame(*header, samples, file);
  } catch (const Error&) {
    std::error_code ignored;
    fs::remove(file, ignored);
    throw;
  }
  return true;
}

}  // namespace fenestra::io::archive
