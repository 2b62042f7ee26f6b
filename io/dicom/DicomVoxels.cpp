#include "io/dicom/DicomVoxels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>

#include "io/base/Memory.h"
#include "io/base/VoxelSink.h"
#include "io/dicom/DicomDecoder.h"
#include "io/dicom/SharedProgress.h"
#include "io/dicom/StoredIntegers.h"
#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

template <class Word>
struct StoredFloats {
  using Value = double;
  explicit StoredFloats(const PixelFormat&) {}
  Value operator()(Word word) const { return static_cast<double>(word); }
};

/// Copies one slice out of a stored frame, mapped.
template <class Word, class Stored, class Voxel>
void storeSlice(std::span<const std::byte> words, const DicomFrame& frame, const DicomFile& file, bool apply,
                Voxel* to) {
  const Stored stored(file.format);
  const std::size_t width = static_cast<std::size_t>(frame.size.x);
  std::vector<Word> row(width);
  for (int y = 0; y < frame.size.y; ++y, to += width) {
    const std::size_t at = static_cast<std::size_t>(frame.tile.y + y) * static_cast<std::size_t>(file.format.columns) +
                           static_cast<std::size_t>(frame.tile.x);
    std::memcpy(row.data(), words.data() + at * sizeof(Word), width * sizeof(Word));
    if (!apply) {
      for (std::size_t x = 0; x < width; ++x) to[x] = static_cast<Voxel>(stored(row[x]));
    } else if (std::is_integral_v<typename Stored::Value> && file.lut) {
      const auto last = static_cast<std::int64_t>(file.lut->values.size()) - 1;
      for (std::size_t x = 0; x < width; ++x) {
        const auto entry = static_cast<std::int64_t>(stored(row[x])) - file.lut->first;
        to[x] =
            static_cast<Voxel>(file.lut->values[static_cast<std::size_t>(std::clamp<std::int64_t>(entry, 0, last))]);
      }
    } else {
      for (std::size_t x = 0; x < width; ++x)
        to[x] = static_cast<Voxel>(frame.slope * static_cast<double>(stored(row[x])) + frame.intercept);
    }
  }
}

void storeSlice(std::span<const std::byte> words, const DicomFrame& frame, const DicomFile& file, bool apply,
                Voxels& voxels, std::size_t offset) {
  std::as_const(voxels).visit([&](auto scalars) {
    using Voxel = std::remove_const_t<typename decltype(scalars)::element_type>;
    Voxel* to = voxels.as<Voxel>().data() + offset;
    if (file.format.sample == Sample::Float32)
      return storeSlice<float, StoredFloats<float>>(words, frame, file, apply, to);
    if (file.format.sample == Sample::Float64)
      return storeSlice<double, StoredFloats<double>>(words, frame, file, apply, to);
    switch (file.format.bitsAllocated) {
      case 8:
        return storeSlice<std::uint8_t, StoredIntegers<std::uint8_t>>(words, frame, file, apply, to);
      case 16:
        return storeSlice<std::uint16_t, StoredIntegers<std::uint16_t>>(words, frame, file, apply, to);
      default:
        return storeSlice<std::uint32_t, StoredIntegers<std::uint32_t>>(words, frame, file, apply, to);
    }
  });
}

/// The type of integer samples mapped with the slices' own slopes, intercepts and tables.
ScalarType mappedType(const DicomStack& stack, const std::vector<DicomFile>& files) {
  bool whole = true;
  double low = 0.0, high = 0.0;  // of the real values that the formats allow
  for (const DicomFrame& frame : stack.frames) {
    const DicomFile& file = files[frame.file];
    if (file.lut) {
      high = std::max(high, 65535.0);
      continue;
    }
    whole = whole && frame.slope == std::round(frame.slope) && frame.intercept == std::round(frame.intercept);
    for (const std::int64_t stored : {file.format.least(), file.format.greatest()}) {
      low = std::min(low, frame.slope * static_cast<double>(stored) + frame.intercept);
      high = std::max(high, frame.slope * static_cast<double>(stored) + frame.intercept);
    }
  }
  // 2^31: beyond it whole numbers fit no integer voxel type.
  return whole && low >= -2147483648.0 && high <= 2147483647.0
             ? narrowestInteger(static_cast<std::int64_t>(low), static_cast<std::uint64_t>(high))
             : ScalarType::Float32;
}

}  // namespace

Mapping mappingOf(const DicomStack& stack, const std::vector<DicomFile>& files) {
  const DicomFrame& first = stack.frames.front();
  bool uniform = true, floats = false, doubles = false;
  std::int64_t least = 0, greatest = 0;  // of the stored values
  for (const DicomFrame& frame : stack.frames) {
    const DicomFile& file = files[frame.file];
    uniform = uniform && frame.slope == first.slope && frame.intercept == first.intercept && !file.lut;
    floats = floats || file.format.sample == Sample::Float32;
    doubles = doubles || file.format.sample == Sample::Float64;
    if (file.format.sample != Sample::Integer) continue;
    least = std::min(least, file.format.least());
    greatest = std::max(greatest, file.format.greatest());
  }
  Mapping mapping;
  mapping.applied = !uniform;
  if (doubles || (floats && greatest > (1 << 24)))  // 2^24: up to here a float holds every integer
    mapping.type = ScalarType::Float64;
  else if (floats)
    mapping.type = ScalarType::Float32;
  else
    mapping.type = uniform ? narrowestInteger(least, static_cast<std::uint64_t>(greatest)) : mappedType(stack, files);
  if (uniform) {
    mapping.slope = first.slope;
    mapping.intercept = first.intercept;
  }
  return mapping;
}

DecodedStack decodeStack(const DicomStack& stack, const std::vector<DicomFile>& files, const Mapping& mapping,
                         const ProgressPart& part) {
  const std::size_t sliceVoxels =
      static_cast<std::size_t>(stack.grid.dims.x) * static_cast<std::size_t>(stack.grid.dims.y);
  const fs::path& path = files[stack.frames.front().file].path;
  const std::uint64_t bytes = saturatingProduct(stack.grid.voxelCount(), sizeOf(mapping.type));
  checkMemory(path, bytes);

  // Slices in the order they are stored, so that each thread opens a file once.
  std::vector<std::size_t> order(stack.frames.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(stack.frames[a].file, stack.frames[a].number) <
           std::pair(stack.frames[b].file, stack.frames[b].number);
  });
  DecodedStack decoded;
  // The headers of compressed files may describe far more than the files hold: a first frame must decode before room
  // is made for all.
  constexpr std::uint64_t worthATry = 64'000'000;
  const DicomFrame& first = stack.frames[order.front()];
  if (files[first.file].pixels.encapsulated && bytes > worthATry) try {
      DicomDecoder(files[first.file]).decode(first.number);
    } catch (const Error& error) {
      decoded.failed.emplace(first.file, error.cause());
      return decoded;
    }
  decoded.voxels = Voxels(mapping.type, stack.grid.voxelCount());

  SharedProgress progress(part, order.size(), "reading slices");
  std::mutex mutex;
  parallelFor(order.size(), 1, [&](std::size_t from, std::size_t to) {
    std::optional<DicomDecoder> decoder;
    std::span<const std::byte> words;
    const DicomFrame* last = nullptr;
    for (std::size_t i = from; i < to; ++i) {
      progress.step();
      const DicomFrame& frame = stack.frames[order[i]];
      const DicomFile& file = files[frame.file];
      try {
        if (!last || last->file != frame.file) decoder.emplace(file);
        if (!last || last->file != frame.file || last->number != frame.number) {
          words = decoder->decode(frame.number);
          if (decoder->samplesOutside() > 0 || decoder->bytesBehind() > 0) {
            const std::scoped_lock lock(mutex);
            if (decoder->samplesOutside() > 0) decoded.samplesOutside[frame.file] += decoder->samplesOutside();
            if (decoder->bytesBehind() > 0) decoded.bytesBehind[frame.file] += decoder->bytesBehind();
          }
        }
        storeSlice(words, frame, file, mapping.applied, decoded.voxels, order[i] * sliceVoxels);
        last = &frame;
      } catch (const Error& error) {
        const std::scoped_lock lock(mutex);
        decoded.failed.emplace(frame.file, error.cause());
        last = nullptr;
      }
    }
  });
  return decoded;
}

}  // namespace fenestra::io
