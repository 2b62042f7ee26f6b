#include "io/deidentify/Deidentify.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcostrmf.h>
#include <dcmtk/dcmdata/dcwcache.h>

#include "io/base/AtomicFile.h"
#include "io/deidentify/Cleaner.h"
#include "io/deidentify/FaceRemoval.h"
#include "io/deidentify/Findings.h"
#include "io/deidentify/Inputs.h"
#include "io/deidentify/OutputFolder.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io::deidentify {
namespace fs = std::filesystem;
namespace {

/// Writes the object into a file. Returns what DCMTK says and how many bytes it passed on; of deflated ones none are
/// counted. Its saveFile() does not tell when a full disk drops the last bytes, as the file is closed.
std::pair<OFCondition, std::optional<std::uintmax_t>> writeStream(DcmFileFormat& object, E_TransferSyntax syntax,
                                                                  const fs::path& file) {
  DcmOutputFileStream stream{OFFilename(file.c_str())};
  if (!stream.good()) return {stream.status(), {}};
  DcmWriteCache cache;
  object.transferInit();
  const OFCondition written =
      object.write(stream, syntax, EET_UndefinedLength, &cache, EGL_withoutGL, EPD_noChange, 0, 0, 0, EWM_fileformat);
  object.transferEnd();
  if (written.bad() || DcmXfer(syntax).getStreamCompression() != ESC_none) return {written, {}};
  return {written, static_cast<std::uintmax_t>(stream.tell())};
}

/// Writes the dataset with a new preamble and meta header. Throws Error.
void writeObject(std::unique_ptr<DcmDataset> dataset, E_TransferSyntax syntax, const fs::path& file,
                 const fs::path& named) {
  DcmFileFormat object(dataset.release(), OFFalse);
  std::error_code failure;
  fs::create_directories(file.parent_path(), failure);
  errno = 0;
  const auto [saved, bytes] = writeStream(object, syntax, file);
  if (saved.good() && (!bytes || fs::file_size(file, failure) == *bytes)) return;
  const std::string cause = errno == 0 ? saved.text() : std::generic_category().message(errno);
  throw Error(named, "cannot be written: " + cause, "choose a place with space that can be written to");
}

class Run {
 public:
  explicit Run(const Request& request) : request_(request) { outcome_.changes = Changes(request.values); }

  Outcome operator()(const Progress& progress);

 private:
  void treat(const fs::path& file, const fs::path& named);
  bool removeFace(DcmDataset& dataset, const fs::path& file, const fs::path& named);
  fs::path placeOf(const std::string& series, const std::string& instance);
  void writeMap() const;

  const Request& request_;
  Outcome outcome_;
  NewUids uids_;
  Findings findings_;
  std::optional<OutputFolder> output_;
  std::optional<FaceRemoval> faces_;
  std::map<fs::path, std::size_t> used_;  ///< places in the output, and how many objects have asked for each
};

Outcome Run::operator()(const Progress& progress) {
  prepareDcmtk();
  const Inputs inputs(request_.inputs, partOf(progress, 0.0, 0.1));
  if (inputs.objects().empty())
    throw Error(request_.inputs.front(), "holds no DICOM objects", "name DICOM files, or folders that hold some");
  if (request_.options.removeFace && request_.options.retainUids)
    throw Error(request_.inputs.front(),
                "cannot keep its UIDs where faces are taken out: other pixels are other objects",
                "retain no UIDs, and keep a map of them instead");
  if (!request_.map.empty() && liesIn(request_.map, request_.output))
    throw Error(request_.map, "would be given away with the copies", "name a file outside of their folder");
  if (!request_.output.empty()) output_.emplace(request_.output, request_.inputs);
  const double start = request_.options.removeFace ? 0.5 : 0.1;
  if (request_.options.removeFace) faces_.emplace(inputs.objects(), partOf(progress, 0.1, start));
  std::size_t done = 0;
  for (const fs::path& file : inputs.objects()) {
    const double fraction = static_cast<double>(done++) / static_cast<double>(inputs.objects().size());
    if (progress && !progress(start + (1.0 - start) * fraction, "de-identifying")) throw Cancelled();
    treat(file, inputs.named(file));
  }
  findings_.leaveOut("not DICOM", inputs.others());
  findings_.leaveOut("listed in the DICOMDIR, but missing", inputs.missing());
  if (outcome_.objects == 0)
    throw Error(request_.inputs.front(),
                "holds no DICOM object that can be de-identified (" + findings_.firstReason() + ")",
                "name other files");
  if (!request_.map.empty()) writeMap();
  if (output_) output_->finish();
  outcome_.leftOut = findings_.leftOut();
  outcome_.warnings = findings_.warnings();
  return std::move(outcome_);
}

void Run::treat(const fs::path& file, const fs::path& named) {
  DcmFileFormat loaded;
  try {
    loadObject(file, loaded);
  } catch (const Error& error) {
    return findings_.leaveOut(error.cause(), {named});
  }
  const std::string refusal = refusalOf(loaded);
  if (!refusal.empty()) return findings_.leaveOut(refusal, {named});
  const E_TransferSyntax coding = loaded.getDataset()->getOriginalXfer();
  std::unique_ptr<DcmDataset> dataset(loaded.getAndRemoveDataset());
  const bool losesFace = faces_ && FaceRemoval::concerns(*dataset);
  if (losesFace && !removeFace(*dataset, file, named)) return;
  findings_.notice(*dataset, named, request_.options.removeFace);
  Cleaner(request_.options, uids_, outcome_.changes).clean(*dataset);
  if (losesFace) FaceRemoval::sayRemoved(*dataset);
  const std::string series = textOf(*dataset, DCM_SeriesInstanceUID), instance = textOf(*dataset, DCM_SOPInstanceUID);
  if (output_)
    writeObject(std::move(dataset), losesFace ? EXS_LittleEndianExplicit : coding, placeOf(series, instance),
                request_.output);
  ++outcome_.objects;
  outcome_.faces += losesFace ? 1 : 0;
  ++outcome_.series[series];
}

/// False: the object is left out.
bool Run::removeFace(DcmDataset& dataset, const fs::path& file, const fs::path& named) {
  std::string reason;
  try {
    reason = faces_->removeFrom(dataset, file);
  } catch (const Error& error) {
    reason = error.cause();
  }
  if (!reason.empty()) findings_.leaveOut(reason, {named});
  return reason.empty();
}

/// UIDs that are kept come from the file: they name a path only where they are made of digits and points.
fs::path Run::placeOf(const std::string& series, const std::string& instance) {
  const auto plain = [](const std::string& uid) {
    const bool isPlain = !uid.empty() && uid.size() <= 64 &&
                         uid.find_first_not_of("0123456789.") == std::string::npos && uid.front() != '.';
    return isPlain ? uid : std::string("no-uid");
  };
  const fs::path folder = output_->place() / plain(series);
  const std::size_t others = used_[folder / plain(instance)]++;
  std::string name = plain(instance);
  if (others > 0) name.append("-").append(std::to_string(others + 1));
  return folder / name.append(".dcm");
}

void Run::writeMap() const {
  std::string text = "old\tnew\n";
  for (const auto& [old, replaced] : uids_.all()) text += old + '\t' + replaced + '\n';
  writeAtomically(request_.map, [&](const fs::path& temporary) {
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (descriptor < 0) failToWrite(temporary);
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    const bool closed = ::close(descriptor) == 0;
    if (!closed || written != static_cast<ssize_t>(text.size())) failToWrite(temporary);
  });
}

}  // namespace

Outcome deidentify(const Request& request, const Progress& progress) { return Run(request)(progress); }

}  // namespace fenestra::io::deidentify
