#include "io/deidentify/FaceRemoval.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "io/base/PlausibleGrid.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomDecoder.h"
#include "io/dicom/DicomHeader.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/DicomVoxels.h"
#include "io/dicom/LabelObject.h"
#include "io/dicom/StackFrames.h"
#include "rendering/volume/Volume.h"

namespace fenestra::io::deidentify {
namespace fs = std::filesystem;
namespace {

/// What a header leaves open of where pixels lie.
constexpr unsigned anyGuess = assumed::spacing | assumed::garbledSpacing | assumed::volumePlace;

bool isScan(const DicomFile& file) { return file.modality == "CT" || file.modality == "MR"; }

void requireGood(const OFCondition& condition) {
  if (condition.bad()) throw std::bad_alloc();
}

/// The stored word of a real value, as near as the format can store it.
template <class Word>
Word wordOf(double real, const DicomFrame& frame, const PixelFormat& format) {
  const double stored = std::round((real - frame.intercept) / frame.slope);
  const double bounded =
      std::clamp(stored, static_cast<double>(format.least()), static_cast<double>(format.greatest()));
  return static_cast<Word>(static_cast<std::int64_t>(bounded) << (format.highBit + 1 - format.bitsStored));
}

/// Blanks what lies in the region, of the frames stored as `number`.
template <class Word>
void blank(std::span<std::byte> words, const DicomFile& file, int number, const segmentation::FaceRegion& region,
           double background) {
  for (const DicomFrame& frame : file.frames) {
    if (frame.number != number) continue;
    const Word word = wordOf<Word>(background, frame, file.format);
    for (int y = 0; y < frame.size.y; ++y)
      for (int x = 0; x < frame.size.x; ++x) {
        // Spacing holds the step between columns first, which is along a row.
        const glm::dvec3 p =
            frame.position + frame.axes[0] * (frame.spacing.x * x) + frame.axes[1] * (frame.spacing.y * y);
        if (!region.contains(p)) continue;
        const std::size_t at =
            static_cast<std::size_t>(frame.tile.y + y) * static_cast<std::size_t>(file.format.columns) +
            static_cast<std::size_t>(frame.tile.x + x);
        std::memcpy(words.data() + at * sizeof(Word), &word, sizeof word);
      }
  }
}

/// Image Type and Frame Type, wherever they stand: pixels that were changed are derived (PS3.3 C.7.6.1.1.2).
void sayDerived(DcmItem& item) {
  for (const DcmTagKey& key : {DCM_ImageType, DCM_FrameType}) {
    OFString type;
    if (item.findAndGetOFStringArray(key, type).bad()) continue;
    const std::string values(type.c_str(), type.size());
    const std::size_t end = values.find('\\');
    const std::string rest = end == std::string::npos ? "\\PRIMARY" : values.substr(end);
    requireGood(item.putAndInsertString(key, ("DERIVED" + rest).c_str()));
  }
  for (DcmObject* next = nullptr; (next = item.nextInContainer(next));)
    if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(next))
      for (DcmObject* inner = nullptr; (inner = sequence->nextInContainer(inner));)
        if (auto* nested = dynamic_cast<DcmItem*>(inner)) sayDerived(*nested);
}

void putPixels(DcmDataset& object, const std::vector<std::byte>& pixels, int bits) {
  object.findAndDeleteElement(DCM_PixelData);
  const auto* bytes = reinterpret_cast<const Uint8*>(pixels.data());
  if (bits == 8) {
    requireGood(object.putAndInsertUint8Array(DCM_PixelData, bytes, static_cast<unsigned long>(pixels.size())));
  } else {
    std::vector<Uint16> words(pixels.size() / 2);
    std::memcpy(words.data(), pixels.data(), 2 * words.size());
    requireGood(object.putAndInsertUint16Array(DCM_PixelData, words.data(), static_cast<unsigned long>(words.size())));
  }
}

}  // namespace

FaceRemoval::FaceRemoval(const std::vector<fs::path>& files, const Progress& progress) {
  std::map<std::string, std::vector<DicomFile>> series;
  for (const fs::path& path : files) {
    if (progress && !progress(0.0, "looking for faces")) throw Cancelled();
    try {
      DicomFile file = readDicomHeader(path);
      if (file.refusal.empty() && isScan(file)) series[file.series].push_back(std::move(file));
    } catch (const Error&) {  // is told when the object is read
    }
  }
  for (const auto& [uid, each] : series) found_[uid] = findIn(each, progress);
}

FaceRemoval::Found FaceRemoval::findIn(const std::vector<DicomFile>& files, const Progress& progress) {
  std::vector<DicomFrame> frames;
  for (std::size_t i = 0; i < files.size(); ++i)
    for (DicomFrame frame : files[i].frames) {
      frame.file = i;
      if (frame.hasGeometry) frames.push_back(std::move(frame));
    }
  const auto none = [](std::string reason) { return Found{{false, {}, std::move(reason)}}; };
  if (frames.empty()) return none("its slices do not say where they lie in the patient");
  const std::vector<DicomStack> stacks = stackFrames(frames, files);
  const DicomStack& stack = stacks.front();
  if (stack.frames.size() < 2) return none("it is a single slice");
  if (implausibility(stack.grid)) return none("its slices lie where none can");
  const Mapping mapping = mappingOf(stack, files);
  DecodedStack decoded;
  try {
    decoded = decodeStack(stack, files, mapping, {.progress = progress, .from = 0.0, .to = 1.0});
  } catch (const Error& error) {
    return none(error.cause());
  }
  if (!decoded.failed.empty()) return none("some of its slices cannot be decoded");
  Volume volume;
  volume.grid = stack.grid;
  volume.voxels = std::move(decoded.voxels);
  volume.slope = mapping.slope;
  volume.intercept = mapping.intercept;
  const DicomFile& first = files[stack.frames.front().file];
  volume.modality = first.modality == "CT" ? Modality::CT : Modality::MR;
  volume.unit = first.unit;
  volume.computeRange();
  return {segmentation::findFace(volume), volume.isInHounsfieldUnits() ? airValue : volume.range.low};
}

void FaceRemoval::sayRemoved(DcmDataset& object) {
  sayDerived(object);
  requireGood(object.putAndInsertString(DCM_DerivationDescription, "Face removed in front of a plane"));
  requireGood(object.putAndInsertString(DcmTag(0x0028, 0x0302, EVR_CS), "NO"));  // Recognizable Visual Features
  // They may be those of the face.
  object.findAndDeleteElement(DCM_SmallestImagePixelValue);
  object.findAndDeleteElement(DCM_LargestImagePixelValue);
  DcmItem* code = nullptr;
  requireGood(object.findOrCreateSequenceItem(DCM_DeidentificationMethodCodeSequence, code, -2));
  requireGood(code->putAndInsertString(DCM_CodeValue, "113101"));
  requireGood(code->putAndInsertString(DCM_CodingSchemeDesignator, "DCM"));
  requireGood(code->putAndInsertString(DCM_CodeMeaning, "Clean Recognizable Visual Features Option"));
}

bool FaceRemoval::concerns(DcmItem& object) {
  return object.tagExists(DCM_Rows) && !isLabelClass(textOf(object, DCM_SOPClassUID));
}

std::string FaceRemoval::removeFrom(DcmDataset& object, const fs::path& path) const {
  const DicomFile file = readDicomHeader(path);
  if (!file.refusal.empty() || !isScan(file)) return "a face can be taken out of images of CT and MR alone";
  const auto found = found_.find(file.series);
  if (found == found_.end() || !found->second.search.isFound)
    return "no face is found in the series: " +
           (found == found_.end() ? std::string("it cannot be read") : found->second.search.reason);
  const bool isPlaced =
      !file.frames.empty() && std::all_of(file.frames.begin(), file.frames.end(), [](const DicomFrame& each) {
        return each.hasGeometry && !(each.assumed & anyGuess);
      });
  const bool isPlain = file.format.sample == Sample::Integer && !file.lut &&
                       (file.format.bitsAllocated == 8 || file.format.bitsAllocated == 16);
  if (!isPlaced) return "it does not say where it lies in the patient, so that no face can be taken out of it";
  if (!isPlain) return "a face can be taken out of pixels of 8 or 16 bits alone";
  int frames = 0;
  for (const DicomFrame& frame : file.frames) frames = std::max(frames, frame.number + 1);
  const std::size_t frameBytes = file.format.frameBytes();
  std::vector<std::byte> pixels(static_cast<std::size_t>(frames) * frameBytes);
  DicomDecoder decoder(file);
  for (int number = 0; number < frames; ++number) {
    const std::span<const std::byte> words = decoder.decode(number);
    const std::span<std::byte> to(pixels.data() + static_cast<std::size_t>(number) * frameBytes, frameBytes);
    std::copy(words.begin(), words.end(), to.begin());
    const Found& face = found->second;
    if (file.format.bitsAllocated == 8)
      blank<std::uint8_t>(to, file, number, face.search.region, face.background);
    else
      blank<std::uint16_t>(to, file, number, face.search.region, face.background);
  }
  putPixels(object, pixels, file.format.bitsAllocated);
  return {};
}

}  // namespace fenestra::io::deidentify
