#include "io/dicom/DicomDecoder.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <mutex>
#include <optional>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dccodec.h>
#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>
#include <openjpeg.h>

#include "io/base/Error.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io {

void prepareDcmtk() {
  static std::once_flag once;
  std::call_once(once, [] {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    DJDecoderRegistration::registerCodecs();
    DJLSDecoderRegistration::registerCodecs();
  });
}

namespace {

bool isJpeg2000(E_TransferSyntax syntax) { return syntax == EXS_JPEG2000LosslessOnly || syntax == EXS_JPEG2000; }

/// A codestream in memory, as OpenJPEG reads it.
struct Codestream {
  std::vector<std::uint8_t> bytes;
  std::size_t at = 0;

  static OPJ_SIZE_T read(void* into, OPJ_SIZE_T size, void* self) {
    auto& stream = *static_cast<Codestream*>(self);
    const std::size_t count = std::min<std::size_t>(size, stream.bytes.size() - stream.at);
    if (count == 0) return static_cast<OPJ_SIZE_T>(-1);
    std::memcpy(into, stream.bytes.data() + stream.at, count);
    stream.at += count;
    return count;
  }
  static OPJ_OFF_T skip(OPJ_OFF_T count, void* self) {
    auto& stream = *static_cast<Codestream*>(self);
    if (count < 0) return -1;
    const auto moved = std::min<std::size_t>(static_cast<std::size_t>(count), stream.bytes.size() - stream.at);
    stream.at += moved;
    return static_cast<OPJ_OFF_T>(moved);
  }
  static OPJ_BOOL seek(OPJ_OFF_T to, void* self) {
    auto& stream = *static_cast<Codestream*>(self);
    if (to < 0 || static_cast<std::size_t>(to) > stream.bytes.size()) return OPJ_FALSE;
    stream.at = static_cast<std::size_t>(to);
    return OPJ_TRUE;
  }
};

/// Deletes with OpenJPEG's function for the kind; its handles are all void*.
template <auto destroy>
struct OpjDelete {
  template <class T>
  void operator()(T* handle) const {
    destroy(handle);
  }
};
using OpjCodec = std::unique_ptr<opj_codec_t, OpjDelete<opj_destroy_codec>>;
using OpjStream = std::unique_ptr<opj_stream_t, OpjDelete<opj_stream_destroy>>;
using OpjImage = std::unique_ptr<opj_image_t, OpjDelete<opj_image_destroy>>;

[[noreturn]] void throwDamaged(const DicomFile& file, int number, const std::string& how) {
  throw Error(file.path, "the pixels of frame " + std::to_string(number + 1) + " cannot be decoded (" + how + ")",
              "the file is truncated or damaged");
}

template <class Word>
void storeComponent(const opj_image_comp_t& component, std::span<std::byte> words) {
  const std::size_t count = words.size() / sizeof(Word);
  for (std::size_t i = 0; i < count; ++i) {
    const Word word = static_cast<Word>(component.data[i]);
    std::memcpy(words.data() + i * sizeof(Word), &word, sizeof(Word));
  }
}

void decodeJpeg2000(Codestream codestream, const DicomFile& file, int number, std::span<std::byte> words) {
  // A raw codestream starts with SOC and SIZ; some writers wrap it into a JP2 file, which the standard forbids.
  const bool raw = codestream.bytes.size() > 4 && codestream.bytes[0] == 0xff && codestream.bytes[1] == 0x4f;
  const OpjCodec codec(opj_create_decompress(raw ? OPJ_CODEC_J2K : OPJ_CODEC_JP2));
  const OpjStream stream(opj_stream_default_create(OPJ_TRUE));
  if (!codec || !stream) throw std::bad_alloc();
  opj_stream_set_user_data(stream.get(), &codestream, nullptr);
  opj_stream_set_user_data_length(stream.get(), codestream.bytes.size());
  opj_stream_set_read_function(stream.get(), &Codestream::read);
  opj_stream_set_skip_function(stream.get(), &Codestream::skip);
  opj_stream_set_seek_function(stream.get(), &Codestream::seek);

  opj_dparameters_t parameters;
  opj_set_default_decoder_parameters(&parameters);
  if (!opj_setup_decoder(codec.get(), &parameters)) throwDamaged(file, number, "JPEG 2000");
  opj_decoder_set_strict_mode(codec.get(), OPJ_TRUE);
  opj_image_t* header = nullptr;
  const bool understood = opj_read_header(stream.get(), codec.get(), &header);
  const OpjImage image(header);
  if (!understood || !image) throwDamaged(file, number, "JPEG 2000 header");
  // Compared before decoding: the codestream's own size decides what is allocated.
  const PixelFormat& format = file.format;
  if (image->numcomps != 1 || image->comps[0].w != static_cast<OPJ_UINT32>(format.columns) ||
      image->comps[0].h != static_cast<OPJ_UINT32>(format.rows) || image->comps[0].prec > 32)
    throwDamaged(file, number, "its JPEG 2000 size is not the header's");
  if (!opj_decode(codec.get(), stream.get(), image.get()) || !image->comps[0].data)
    throwDamaged(file, number, "JPEG 2000");
  switch (format.bitsAllocated) {
    case 8:
      return storeComponent<std::uint8_t>(image->comps[0], words);
    case 16:
      return storeComponent<std::uint16_t>(image->comps[0], words);
    default:
      return storeComponent<std::uint32_t>(image->comps[0], words);
  }
}

std::uint64_t littleEndian32(std::span<const std::uint8_t> bytes, std::size_t at) {
  return std::uint64_t{bytes[at]} | std::uint64_t{bytes[at + 1]} << 8 | std::uint64_t{bytes[at + 2]} << 16 |
         std::uint64_t{bytes[at + 3]} << 24;
}

/// RLE Lossless (PS3.5 Annex G): one PackBits segment for each byte of a word, the most significant first. DCMTK's
/// decoder is not used because it reads outside damaged segments.
void decodeRle(std::span<const std::uint8_t> bytes, const DicomFile& file, int number, std::span<std::byte> words) {
  constexpr std::size_t headerBytes = 64;
  const std::size_t wordBytes = static_cast<std::size_t>(file.format.bitsAllocated / 8),
                    count = words.size() / wordBytes;
  if (bytes.size() < headerBytes || littleEndian32(bytes, 0) != wordBytes) throwDamaged(file, number, "RLE header");
  for (std::size_t segment = 0; segment < wordBytes; ++segment) {
    std::size_t at = littleEndian32(bytes, 4 + 4 * segment);
    const std::size_t end = segment + 1 < wordBytes ? littleEndian32(bytes, 8 + 4 * segment) : bytes.size();
    if (at < headerBytes || at > end || end > bytes.size()) throwDamaged(file, number, "RLE header");
    const std::size_t place = std::endian::native == std::endian::little ? wordBytes - 1 - segment : segment;
    std::size_t filled = 0;
    while (filled < count && at < end) {
      const std::size_t control = bytes[at++];
      if (control == 128) continue;  // no operation
      const bool literal = control < 128;
      const std::size_t length = std::min(literal ? control + 1 : 257 - control, count - filled);
      if (at + (literal ? length : 1) > end) break;
      for (std::size_t i = 0; i < length; ++i)
        words[(filled + i) * wordBytes + place] = static_cast<std::byte>(bytes[literal ? at + i : at]);
      filled += length;
      at += literal ? length : 1;
    }
    if (filled < count) throwDamaged(file, number, "RLE segment");
  }
}

/// The bytes of one fragment; loaded on demand.
std::span<const std::uint8_t> fragmentBytes(DcmPixelSequence& sequence, unsigned long index) {
  DcmPixelItem* item = nullptr;
  Uint8* bytes = nullptr;
  if (sequence.getItem(item, index).bad() || !item || item->getUint8Array(bytes).bad() || !bytes) return {};
  return {bytes, item->getLength()};
}

/// The first fragment of every frame; fragment 0 is the Basic Offset Table. Most files have one fragment per frame. In
/// others the table gives the first fragments, or the start-of-image markers of JPEG (FF D8) and JPEG 2000 (FF 4F) show
/// them.
std::optional<std::vector<Uint32>> firstFragments(DcmPixelSequence& sequence, std::size_t frames) {
  const std::size_t fragments = sequence.card();
  std::vector<Uint32> first;
  if (fragments == frames + 1) {
    for (std::size_t frame = 0; frame < frames; ++frame) first.push_back(static_cast<Uint32>(frame + 1));
    return first;
  }
  if (fragments < frames + 1) return std::nullopt;
  if (frames == 1) return std::vector<Uint32>{1};

  const auto table = fragmentBytes(sequence, 0);
  if (table.size() == frames * 4) {
    std::vector<std::uint64_t> offsets;
    for (std::size_t i = 0; i < table.size(); i += 4) offsets.push_back(littleEndian32(table, i));
    std::uint64_t offset = 0;
    for (std::size_t fragment = 1; fragment < fragments && first.size() < frames; ++fragment) {
      if (offset == offsets[first.size()]) first.push_back(static_cast<Uint32>(fragment));
      DcmPixelItem* item = nullptr;
      if (sequence.getItem(item, fragment).bad() || !item) return std::nullopt;
      offset += 8 + item->getLength();  // 8: the item's tag and length
    }
  } else {
    for (std::size_t fragment = 1; fragment < fragments; ++fragment) {
      const auto bytes = fragmentBytes(sequence, fragment);
      if (bytes.size() >= 3 && bytes[0] == 0xff && (bytes[1] == 0xd8 || bytes[1] == 0x4f) && bytes[2] == 0xff)
        first.push_back(static_cast<Uint32>(fragment));
    }
  }
  if (first.size() != frames) return std::nullopt;
  return first;
}

}  // namespace

struct DicomDecoder::State {
  DcmFileFormat file;
  DcmFileCache cache;
  DcmPixelData* pixels = nullptr;
  E_TransferSyntax syntax = EXS_Unknown;
  DcmPixelSequence* fragments = nullptr;  ///< null for native pixels
  std::vector<Uint32> first;              ///< fragment of each frame
  std::size_t frames = 0;
};

DicomDecoder::DicomDecoder(const DicomFile& file) : file_(file), state_(std::make_unique<State>()) {
  prepareDcmtk();
  const auto damaged = [&](const std::string& how) {
    throw Error(file.path, "its pixels cannot be read (" + how + ")", "the file is truncated or damaged");
  };
  const OFCondition loaded = state_->file.loadFile(OFFilename(file.path.c_str()));
  if (loaded.bad()) damaged(loaded.text());
  DcmDataset& dataset = *state_->file.getDataset();
  DcmElement* element = nullptr;
  if (dataset.findAndGetElement(DCM_PixelData, element).bad()) damaged("there are none");
  state_->pixels = dynamic_cast<DcmPixelData*>(element);
  if (!state_->pixels) damaged("there are none");
  for (const DicomFrame& frame : file.frames)
    state_->frames = std::max(state_->frames, static_cast<std::size_t>(frame.number) + 1);

  const std::size_t frameBytes = file.format.frameBytes();
  if (frameBytes >= std::numeric_limits<Uint32>::max()) damaged("its frames are larger than 4 GB");
  const DcmRepresentationParameter* parameter = nullptr;
  E_TransferSyntax& syntax = state_->syntax;
  state_->pixels->getOriginalRepresentationKey(syntax, parameter);
  if (!DcmXfer(syntax).isEncapsulated()) {
    const std::size_t needed = frameBytes * state_->frames;
    if (element->getLength() < needed)
      damaged("there are " + std::to_string(element->getLength()) + " bytes of " + std::to_string(needed));
    return;
  }
  if (state_->pixels->getEncapsulatedRepresentation(syntax, parameter, state_->fragments).bad() || !state_->fragments)
    damaged("no compressed frames");
  const auto first = firstFragments(*state_->fragments, state_->frames);
  if (!first) damaged("its fragments do not divide into frames");
  state_->first = *first;
  if (!isJpeg2000(syntax) && syntax != EXS_RLELossless &&
      !DcmCodecList::canChangeCoding(syntax, EXS_LittleEndianExplicit))
    throw Error(file.path, std::string("its transfer syntax is not supported (") + DcmXfer(syntax).getXferName() + ")",
                "convert it to an uncompressed or lossless JPEG, JPEG-LS, JPEG 2000 or RLE file");
}

DicomDecoder::~DicomDecoder() = default;

std::span<const std::byte> DicomDecoder::decode(int number) {
  const auto frame = static_cast<std::size_t>(number);
  // Allocated only after the file has been checked, and not cleared: a damaged header may describe gigabytes.
  const std::size_t frameBytes = file_.format.frameBytes();
  // One more byte than an odd frame has: DCMTK wants room for whole 16-bit words.
  const std::size_t room = frameBytes + frameBytes % 2;
  if (!words_) words_ = std::make_unique_for_overwrite<std::byte[]>(room);
  const std::span<std::byte> words(words_.get(), frameBytes);
  if (isJpeg2000(state_->syntax) || state_->syntax == EXS_RLELossless) {
    std::vector<std::uint8_t> bytes;
    const Uint32 end =
        frame + 1 < state_->first.size() ? state_->first[frame + 1] : static_cast<Uint32>(state_->fragments->card());
    for (Uint32 index = state_->first[frame]; index < end; ++index) {
      const auto piece = fragmentBytes(*state_->fragments, index);
      bytes.insert(bytes.end(), piece.begin(), piece.end());
    }
    if (isJpeg2000(state_->syntax))
      decodeJpeg2000({std::move(bytes)}, file_, number, words);
    else
      decodeRle(bytes, file_, number, words);
    return words;
  }
  Uint32 fragment = state_->fragments ? state_->first[frame] : 0;
  OFString colourModel;
  const OFCondition decoded =
      state_->pixels->getUncompressedFrame(state_->file.getDataset(), static_cast<Uint32>(number), fragment,
                                           words.data(), static_cast<Uint32>(room), colourModel, &state_->cache);
  if (decoded.bad()) throwDamaged(file_, number, decoded.text());
  return words;
}

}  // namespace fenestra::io
