#include "io/dicom/Identifiers.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "io/base/ByteStream.h"

namespace fenestra::io {
namespace {

bool haveSamePlaces(const DicomFile& a, const DicomFile& b) {
  return std::equal(a.frames.begin(), a.frames.end(), b.frames.begin(), b.frames.end(),
                    [](const DicomFrame& x, const DicomFrame& y) {
                      return x.hasGeometry == y.hasGeometry && x.position == y.position && x.axes == y.axes &&
                             x.location == y.location;
                    });
}

/// Whether the pixel elements hold the same bytes. Images that are compressed in different ways are not decoded for
/// that: one UID and one place are taken for one image.
bool haveSamePixels(const DicomFile& a, const DicomFile& b) {
  const PixelPlace &x = a.pixels, &y = b.pixels;
  if (a.syntaxUid != b.syntaxUid || x.encapsulated || y.encapsulated || x.deflated || y.deflated) return true;
  if (x.length != y.length) return false;
  const auto first = openStream(a.path, x.offset, Packing::None), second = openStream(b.path, y.offset, Packing::None);
  std::vector<std::byte> left(std::size_t{1} << 16), right(left.size());
  for (std::uint64_t at = 0; at < x.length;) {
    const std::size_t count = static_cast<std::size_t>(std::min<std::uint64_t>(left.size(), x.length - at));
    if (first->read(left.data(), count) != count || second->read(right.data(), count) != count) return true;
    if (!std::equal(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(count), right.begin())) return false;
    at += count;
  }
  return true;
}

void dropCopies(std::vector<DicomFile>& files, Identifiers& identifiers) {
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> kept;  // by series and instance
  std::vector<DicomFile> all = std::move(files);
  files.clear();
  for (DicomFile& file : all) {
    if (!file.instance.empty()) {
      std::vector<std::size_t>& others = kept[{file.series, file.instance}];
      const bool copy = std::any_of(others.begin(), others.end(), [&](std::size_t other) {
        return haveSamePlaces(files[other], file) && haveSamePixels(files[other], file);
      });
      if (copy) {
        identifiers.copies.push_back(file.path);
        continue;
      }
      others.push_back(files.size());
    }
    files.push_back(std::move(file));
  }
  for (const auto& [names, members] : kept)
    if (members.size() > 1)
      for (const std::size_t file : members) identifiers.shared[names.first].push_back(files[file].path);
}

/// What single slices of one series have in common.
auto kindOf(const DicomFile& file) {
  const DicomFrame& frame = file.frames.front();
  const auto rounded = [](const glm::dvec3& axis) {
    // A thousandth of a radian, as for slices of one stack.
    return std::tuple(std::lround(axis.x * 1e3), std::lround(axis.y * 1e3), std::lround(axis.z * 1e3));
  };
  return std::tuple(file.studyUid, frame.frameOfReference, file.sopClass, file.modality, file.description,
                    rounded(frame.axes[0]), rounded(frame.axes[1]), frame.size.x, frame.size.y, frame.spacing.x,
                    frame.spacing.y);
}

/// Whether slices lie one step apart, each at a place of its own. A twentieth of the step is rounding.
bool lieEvenly(const std::vector<DicomFile>& files, const std::vector<std::size_t>& slices) {
  const DicomFrame& first = files[slices.front()].frames.front();
  const glm::dvec3 normal = glm::cross(first.axes[0], first.axes[1]);
  std::vector<double> heights;
  for (const std::size_t slice : slices) heights.push_back(glm::dot(files[slice].frames.front().position, normal));
  std::sort(heights.begin(), heights.end());
  const double step = (heights.back() - heights.front()) / static_cast<double>(heights.size() - 1);
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (!(step > 0.0) || std::abs(heights[i] - heights[i - 1] - step) > 0.05 * step) return false;
  return true;
}

void joinSeries(std::vector<DicomFile>& files, Identifiers& identifiers) {
  std::map<std::string, std::size_t> sizes;
  for (const DicomFile& file : files) ++sizes[file.series];
  std::map<decltype(kindOf(files.front())), std::vector<std::size_t>> alike;
  for (std::size_t i = 0; i < files.size(); ++i)
    if (sizes[files[i].series] == 1 && files[i].frames.size() == 1 && files[i].frames.front().hasGeometry)
      alike[kindOf(files[i])].push_back(i);
  constexpr std::size_t fewest = 3;  // two slices have one distance, which is even whatever they are
  for (const auto& [kind, slices] : alike) {
    if (slices.size() < fewest || !lieEvenly(files, slices)) continue;
    const std::string uid = files[slices.front()].series;
    for (const std::size_t slice : slices) files[slice].series = uid;
    identifiers.joined[uid] = slices.size();
  }
}

}  // namespace

Identifiers mendIdentifiers(std::vector<DicomFile>& files) {
  Identifiers identifiers;
  dropCopies(files, identifiers);
  joinSeries(files, identifiers);
  return identifiers;
}

std::vector<Warning> warningsOf(const Identifiers& identifiers, const std::string& series) {
  std::vector<Warning> warnings;
  if (const std::size_t count = identifiers.copies.size())
    warnings.push_back({Warning::Kind::DuplicateSlices,
                        std::to_string(count) + (count == 1 ? " file" : " files") +
                            " left out: the same images (SOP instances) as in other files",
                        identifiers.copies});
  if (const auto shared = identifiers.shared.find(series); shared != identifiers.shared.end())
    warnings.push_back({Warning::Kind::Other,
                        std::to_string(shared->second.size()) +
                            " files share a SOP Instance UID though their places or pixels differ; they are taken for "
                            "images of their own",
                        shared->second});
  if (const auto joined = identifiers.joined.find(series); joined != identifiers.joined.end())
    warnings.push_back({Warning::Kind::Other,
                        std::to_string(joined->second) +
                            " slices have a Series UID each; they agree in study and kind and lie evenly, and are "
                            "taken for one series",
                        {}});
  return warnings;
}

}  // namespace fenestra::io
