#include "tests/fuzz/Targets.h"

#include <sys/socket.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <utility>

#include "io/LabelReader.h"
#include "io/LabelTable.h"
#include "io/TransferFunctionFile.h"
#include "io/VolumeReader.h"
#include "io/archive/Multipart.h"
#include "io/archive/StorageProvider.h"
#include "io/archive/Transaction.h"
#include "io/archive/WebAnswers.h"
#include "io/deidentify/Deidentify.h"
#include "io/dicom/ByteCodecs.h"
#include "io/dicom/CodecError.h"
#include "io/session/LookFile.h"
#include "io/session/SessionFile.h"
#include "io/session/StrokeFile.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"

namespace fenestra::fuzz {
namespace fs = std::filesystem;
namespace {

void openAsVolume(const fs::path& file) { io::openVolume(file); }

void openTiff(const fs::path& file) { io::openVolume(file, {.spacing = glm::dvec3(0.1)}); }

Grid smallGrid() {
  Grid grid;
  grid.dims = {7, 6, 5};
  return grid;
}

void openAsLabels(const fs::path& file) { io::openLabels(file, smallGrid()); }
void openLabelTable(const fs::path& file) { io::readLabelTable(file); }

/// The files of an input that packFolder() wrote, in a folder beside it; `ending` gives them their kind. A size that
/// reaches beyond the input is that of what remains.
fs::path unpacked(const fs::path& file, const std::string& ending) {
  constexpr std::size_t mostFiles = 24, sizeBytes = 4;
  const fs::path folder = file.parent_path() / "folder";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string bytes = tests::readFile(file);
  std::size_t at = 0;
  for (std::size_t number = 1; number <= mostFiles && at + sizeBytes < bytes.size(); ++number) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < sizeBytes; ++i)
      size |= std::size_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    at += sizeBytes;
    size = std::min(size, bytes.size() - at);
    tests::writeFile(folder / ("part" + std::to_string(number) + ending), bytes.substr(at, size));
    at += size;
  }
  return folder;
}

/// Every volume of the folder, as a user who looks at one after another.
void openDicomSeries(const fs::path& file) {
  const fs::path folder = unpacked(file, ".dcm");
  for (const io::SeriesInfo& series : io::listSeries(folder)) {
    try {
      io::openVolume(folder, {.series = series.id});
    } catch (const io::Error&) {
    }
  }
}
void openTiffFolder(const fs::path& file) { io::openVolume(unpacked(file, ".tif"), {.spacing = glm::dvec3(0.1)}); }
void openMasks(const fs::path& file) { io::openLabels(unpacked(file, ".nii"), smallGrid()); }

/// The first byte chooses the decoder and the bits of a pixel, the second one the number of pixels.
void decodeBytes(const fs::path& file) {
  const std::string input = tests::readFile(file);
  if (input.size() < 2) return;
  const auto first = static_cast<unsigned char>(input[0]), second = static_cast<unsigned char>(input[1]);
  constexpr std::array decoders{+[](std::span<const std::uint8_t> bytes, const io::PixelFormat& format,
                                    std::span<std::byte> words) { io::decodeRle(bytes, format, words); },
                                &io::decodeEncapsulated, &io::decodeElscint};
  io::PixelFormat format;
  format.bitsAllocated = 8 << (first / 3 % 3);
  std::vector<std::byte> words(static_cast<std::size_t>(format.bitsAllocated) / 8 * (second + 1u));
  const std::vector<std::uint8_t> bytes(input.begin() + 2, input.end());
  try {
    decoders[first % decoders.size()](bytes, format, words);
  } catch (const io::CodecError& error) {
    throw io::Error(file, error.what(), "");
  }
}

void deidentify(const fs::path& file) {
  const fs::path copies = file.parent_path() / "copies";
  fs::remove_all(copies);
  io::deidentify::deidentify({.inputs = {file}, .output = copies, .options = {.cleanDescriptors = true}});
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

/// What a server of DICOMweb answers to a search, to objects that were sent, and of an object with frames.
void readWebJson(const fs::path& file) {
  const std::string text = tests::readFile(file);
  io::archive::attributesInJson(text);
  io::archive::storeAnswerIn(text);
  io::archive::frameHeaderIn(text, 2);
}

/// The parts of a message that comes in pieces of `size` bytes, those that came whole alone.
std::vector<std::string> partsOf(std::string_view message, const std::string& boundary, std::size_t size) {
  std::vector<std::string> parts;
  std::string part;
  io::archive::Multipart reader(boundary, {[&] { part.clear(); }, [&](std::string_view bytes) { part += bytes; },
                                           [&] { parts.push_back(std::exchange(part, {})); }});
  while (!message.empty() && reader.push(message.substr(0, size)))
    message.remove_prefix(std::min(size, message.size()));
  return parts;
}

/// The first byte is the size of the pieces, the first line behind it the type, and the rest the message. Its parts are
/// the same in whatever pieces it comes.
void readWebMultipart(const fs::path& file) {
  const std::string input = tests::readFile(file);
  if (input.empty()) return;
  const std::size_t end = std::min(input.find('\n'), input.size() - 1);
  const std::string type = end > 0 ? input.substr(1, end - 1) : "", message = input.substr(end + 1);
  const std::string boundary = io::archive::boundaryIn(type).value_or("b");
  const std::size_t size = static_cast<unsigned char>(input[0]) + 1u;
  if (partsOf(message, boundary, size) != partsOf(message, boundary, input.size()))
    throw std::logic_error("a message has other parts when it comes in pieces");
}

/// A connected pair of sockets of the loopback interface, ours first: DCMTK wants one of the internet.
std::pair<int, int> connectedSockets() {
  int port = 0;
  const int listening = tests::listeningSocket(port), theirs = tests::connectTo(port),
            ours = accept(listening, nullptr, nullptr);
  close(listening);
  return {ours, theirs};
}

/// Serves a connection on which a peer sends the bytes of the file and no more.
void serve(io::archive::Reception& reception, const fs::path& file) {
  const std::string bytes = tests::readFile(file);
  const auto [ours, theirs] = connectedSockets();
  // Beside the reading, because a socket holds only so much.
  std::thread peer([&bytes, socket = theirs] {
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t sent = send(socket, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
      if (sent <= 0) break;
      at += static_cast<std::size_t>(sent);
    }
    shutdown(socket, SHUT_WR);
  });
  const std::atomic<bool> stops = false;
  reception.serve(ours, stops);
  peer.join();
  close(theirs);
}

io::archive::Server peersServer() {
  io::archive::Server server;
  server.title = "ARCHIVE";
  server.limits.objectBytes = 1u << 20;
  server.limits.freeDiskBytes = 0;
  server.limits.introduction = server.limits.silence = std::chrono::seconds(5);
  return server;
}

/// What a peer sends to the storage provider while the object of providerSeeds() is waited for. Its objects stay below
/// "received", so that each run starts with none.
void receiveAssociation(const fs::path& file) {
  namespace archive = io::archive;
  const fs::path folder = file.parent_path() / "received";
  fs::remove_all(folder);
  const archive::Server server = peersServer();
  const archive::Cache cache(folder);
  archive::Activity activity;
  archive::Intake intake(cache, server.limits, activity);
  const std::string ct = "1.2.840.10008.5.1.4.1.1.2";
  const archive::Wanted wanted{"1.2.3", "1.2.3.4", {{"1.2.3.4.5", ct}}};
  intake.expect(wanted, wanted);
  archive::Reception reception(server, archive::storageService({ct}, intake));
  serve(reception, file);
  if (intake.received() > 1) throw std::logic_error("an object came in more than once");
}

/// What a peer sends while the report of commitmentSeeds() is waited for. The file "verdict" holds what it said: why
/// the object is not kept, and a point; nothing where there was no report.
void receiveReport(const fs::path& file) {
  namespace archive = io::archive;
  const archive::Server server = peersServer();
  archive::Transaction transaction(server, {{"1.2.3.4.5", "1.2.840.10008.5.1.4.1.1.2"}}, "1.2.3.9");
  archive::Reception reception(server, archive::commitmentService(transaction));
  serve(reception, file);
  const auto verdicts = transaction.verdicts();
  if (verdicts.size() > 1 || (verdicts.size() == 1 && !verdicts.contains("1.2.3.4.5")))
    throw std::logic_error("a report told of an object that was not asked for");
  tests::writeFile(file.parent_path() / "verdict", verdicts.empty() ? "" : verdicts.begin()->second.text + ".");
}

constexpr std::array all{Target{"dicom", "input.dcm", openAsVolume},
                         Target{"dicom-series", "input.pack", openDicomSeries},
                         Target{"deidentify", "input.dcm", deidentify},
                         Target{"byte-codecs", "input.bytes", decodeBytes},
                         Target{"nifti", "input.nii", openAsVolume},
                         Target{"nrrd", "input.nrrd", openAsVolume},
                         Target{"metaimage", "input.mha", openAsVolume},
                         Target{"mgh", "input.mgh", openAsVolume},
                         Target{"tiff", "input.tif", openTiff},
                         Target{"tiff-folder", "input.pack", openTiffFolder},
                         Target{"archive", "input.zip", openAsVolume},
                         Target{"labels", "input.labels", openAsLabels},
                         Target{"label-table", "input.txt", openLabelTable},
                         Target{"masks", "input.pack", openMasks},
                         Target{"session", "input.fenestra", openSession},
                         Target{"look", "input.json", openLook},
                         Target{"strokes", "input.json", openStrokes},
                         Target{"transfer-function", "input.json", openTransferFunction},
                         Target{"web-json", "input.json", readWebJson},
                         Target{"web-multipart", "input.bytes", readWebMultipart},
                         Target{"provider", "input.association", receiveAssociation},
                         Target{"commitment", "input.association", receiveReport}};

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

std::string packFolder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  std::string packed;
  for (const fs::path& file : files) {
    const std::string bytes = tests::readFile(file);
    for (int shift = 0; shift < 32; shift += 8) packed += static_cast<char>(bytes.size() >> shift & 0xff);
    packed += bytes;
  }
  return packed;
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
