#include "io/dicom/DicomRemarks.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

struct Remark {
  unsigned bit;
  Warning::Kind kind;
  const char* text;
};
constexpr Remark remarks[] = {
    {assumed::spacing, Warning::Kind::NoGeometry, "no pixel spacing is given; 1 mm is assumed"},
    {assumed::garbledSpacing, Warning::Kind::NoGeometry,
     "the pixel spacing is not two positive numbers; 1 mm is assumed"},
    {assumed::detectorSpacing, Warning::Kind::NoGeometry,
     "the pixel spacing is the detector's; distances in the patient are smaller"},
    {assumed::slope, Warning::Kind::Other, "the rescale slope is 0 or no usable number; 1 is assumed"},
    {assumed::intercept, Warning::Kind::Other, "the rescale intercept is no usable number; 0 is assumed"},
    {assumed::doseScaling, Warning::Kind::Other,
     "the dose grid scaling is missing, 0 or no usable number; values are shown as stored, not as doses"},
    {assumed::lut, Warning::Kind::Other, "the Modality LUT cannot be read; values are shown as stored"},
    {assumed::representation, Warning::Kind::Other,
     "the header does not say whether pixels are signed; they are taken as unsigned"},
    {assumed::photometric, Warning::Kind::Other,
     "the header does not say whether high values are bright; MONOCHROME2 is assumed, where they are"},
    {assumed::decimalCommas, Warning::Kind::Other,
     "numbers are written with a comma, which DICOM forbids; it is read as the decimal point"},
    {assumed::followingFrames, Warning::Kind::NoGeometry,
     "the file gives the place of its first frame alone; the others are taken to follow it along the normal, at its "
     "Spacing Between Slices"},
    {assumed::volumePlace, Warning::Kind::NoGeometry,
     "the slices are placed in the frame of the ultrasound volume; where that lies in the patient is not said"},
    {assumed::noFrames, Warning::Kind::Other, "the header counts 0 frames; one is read"},
    {assumed::acrNema, Warning::Kind::Other,
     "the file is from before DICOM (ACR-NEMA); its position and orientation are taken for DICOM's"},
    {assumed::realWorldValues, Warning::Kind::Other,
     "the header maps values to a physical quantity (Real World Value Mapping); they are shown as stored"}};

class Remarks {
 public:
  Remarks(const DicomStack& stack, const std::vector<DicomFile>& files) : stack_(stack), files_(files) {}

  std::vector<Warning> all() {
    for (const Remark& remark : remarks) addAssumption(remark);
    addMixture("modality", [](const DicomFile& file) { return file.modality; });
    addMixture("photometric interpretation",
               [](const DicomFile& file) { return std::string(file.monochrome1 ? "MONOCHROME1" : "MONOCHROME2"); });
    addMixture("unit", [](const DicomFile& file) { return file.unit; });
    const DicomFile& first = fileOf(stack_.frames.front());
    if (first.mosaicUnsplit)
      warnings_.push_back({Warning::Kind::Other,
                           "the slices of a volume lie side by side in one picture (mosaic); it is shown as one slice",
                           {first.path}});
    return std::move(warnings_);
  }

 private:
  const DicomFile& fileOf(const DicomFrame& frame) const { return files_[frame.file]; }

  void addAssumption(const Remark& remark) {
    std::set<fs::path> paths;
    std::size_t count = 0;
    for (const DicomFrame& frame : stack_.frames)
      if ((frame.assumed & remark.bit) != 0) {
        ++count;
        paths.insert(fileOf(frame).path);
      }
    if (count == 0) return;
    std::string text = remark.text;
    if (count < stack_.frames.size())
      text += " (in " + std::to_string(count) + " of " + std::to_string(stack_.frames.size()) + " slices)";
    warnings_.push_back({remark.kind, std::move(text), {paths.begin(), paths.end()}});
  }

  /// Files whose attribute is not that of the first slice, which the volume takes.
  template <class Attribute>
  void addMixture(const char* name, const Attribute& attribute) {
    const auto shown = [](const std::string& value) { return value.empty() ? std::string("none") : value; };
    const std::string taken = attribute(fileOf(stack_.frames.front()));
    std::map<std::string, std::size_t> counts;
    std::set<fs::path> others;
    for (const DicomFrame& frame : stack_.frames) {
      ++counts[attribute(fileOf(frame))];
      if (attribute(fileOf(frame)) != taken) others.insert(fileOf(frame).path);
    }
    if (counts.size() < 2) return;
    std::string found;
    for (const auto& [value, count] : counts)
      found += (found.empty() ? "" : ", ") + shown(value) + " in " + std::to_string(count);
    warnings_.push_back({Warning::Kind::Other,
                         std::string("the slices differ in ") + name + " (" + found + "); all are shown as " +
                             shown(taken) + ", with their values as stored",
                         {others.begin(), others.end()}});
  }

  const DicomStack& stack_;
  const std::vector<DicomFile>& files_;
  std::vector<Warning> warnings_;
};

}  // namespace

std::vector<Warning> remarksOn(const DicomStack& stack, const std::vector<DicomFile>& files) {
  return Remarks(stack, files).all();
}

}  // namespace fenestra::io
