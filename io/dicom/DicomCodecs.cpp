#include "io/dicom/DicomCodecs.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <mutex>
#include <new>
#include <optional>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dccodec.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/appender.h>
#include <dcmtk/oflog/oflog.h>
#include <dcmtk/oflog/spi/logevent.h>
#include <openjpeg.h>

#include "io/dicom/ByteCodecs.h"
#include "io/dicom/CodecError.h"
#include "io/dicom/Dcmtk.h"
#include "io/dicom/TransferSyntax.h"

namespace fenestra::io {
namespace {

/// What a decoder on this thread warned of first; null while none is running.
thread_local std::string* warning = nullptr;

void note(const std::string& text) {
  if (warning && warning->empty()) *warning = text.substr(0, text.find_last_not_of(" \r\n") + 1);
}

/// Takes the messages that DCMTK's JPEG decoders log.
class WarningAppender : public dcmtk::log4cplus::Appender {
 public:
  ~WarningAppender() override { destructorImpl(); }
  void close() override { closed = true; }

 protected:
  void append(const dcmtk::log4cplus::spi::InternalLoggingEvent& event) override {
    note({event.getMessage().data(), event.getMessage().size()});
  }
};

/// Notes the warnings of its lifetime.
class WarningNote {
 public:
  WarningNote() { warning = &text_; }
  ~WarningNote() { warning = nullptr; }
  WarningNote(const WarningNote&) = delete;
  WarningNote& operator=(const WarningNote&) = delete;
  void check() const {
    if (!text_.empty()) throw CodecError(text_);
  }

 private:
  std::string text_;
};

}  // namespace

void prepareDcmtk() {
  static std::once_flag once;
  std::call_once(once, [] {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    // Standard elements that a server stored with the VR "unknown" are read as the data dictionary says.
    dcmEnableUnknownVRConversion.set(OFTrue);
    OFLogger jpeg = OFLog::getLogger("dcmtk.dcmjpeg");
    jpeg.setLogLevel(OFLogger::WARN_LOG_LEVEL);
    jpeg.setAdditivity(false);
    jpeg.addAppender(dcmtk::log4cplus::SharedAppenderPtr(new WarningAppender));
    DJDecoderRegistration::registerCodecs();
    DJLSDecoderRegistration::registerCodecs();
  });
}

namespace {

template <class Word>
void storeWord(std::int64_t value, std::span<std::byte> words, std::size_t index) {
  const Word word = static_cast<Word>(value);
  std::memcpy(words.data() + index * sizeof(Word), &word, sizeof(Word));
}

/// words[i] = value(i) for all of them.
template <class Value>
void storeWords(const PixelFormat& format, std::span<std::byte> words, const Value& value) {
  const std::size_t count = words.size() * 8 / static_cast<std::size_t>(format.bitsAllocated);
  for (std::size_t i = 0; i < count; ++i) switch (format.bitsAllocated) {
      case 8:
        storeWord<std::uint8_t>(value(i), words, i);
        break;
      case 16:
        storeWord<std::uint16_t>(value(i), words, i);
        break;
      default:
        storeWord<std::uint32_t>(value(i), words, i);
    }
}

/// What a codestream says about itself.
struct FrameHeader {
  std::int64_t rows = 0, columns = 0;
  int components = 0, precision = 0;  ///< bits a sample
};

/// Compared before decoding: the codestream's own size decides what is allocated and filled.
void compare(const FrameHeader& header, const PixelFormat& format) {
  const auto size = [](std::int64_t columns, std::int64_t rows) {
    return std::to_string(columns) + " x " + std::to_string(rows);
  };
  if (header.rows != format.rows || header.columns != format.columns)
    throw CodecError("it is " + size(header.columns, header.rows) + " where the header says " +
                     size(format.columns, format.rows));
  if (header.components != 1)
    throw CodecError("it has " + std::to_string(header.components) + " samples a pixel where the header says 1");
  if (header.precision < 2 || header.precision > format.bitsAllocated)
    throw CodecError("it has " + std::to_string(header.precision) + " bits a sample where the header allocates " +
                     std::to_string(format.bitsAllocated));
}

/// The frame header of a JPEG or JPEG-LS codestream (ITU-T T.81 B.2.2, T.87 C.2.2).
std::optional<FrameHeader> jpegHeader(std::span<const std::uint8_t> bytes) {
  const auto number = [&](std::size_t at) { return bytes[at] << 8 | bytes[at + 1]; };
  if (bytes.size() < 4 || bytes[0] != 0xff || bytes[1] != 0xd8) return std::nullopt;
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    if (bytes[at] != 0xff) return std::nullopt;
    const int marker = bytes[at + 1];
    if (marker == 0xff) {  // fill
      ++at;
      continue;
    }
    // Start of frame: C0 to CF without Huffman tables (C4), extensions (C8) and arithmetic conditioning (CC); F7 is
    // JPEG-LS's.
    const bool frame =
        (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) || marker == 0xf7;
    if (frame) {
      if (at + 10 > bytes.size()) return std::nullopt;
      return FrameHeader{number(at + 5), number(at + 7), bytes[at + 9], bytes[at + 4]};
    }
    at += 2 + static_cast<std::size_t>(number(at + 2));
  }
  return std::nullopt;
}

bool isEnded(const std::vector<std::uint8_t>& bytes) {
  std::size_t end = bytes.size();
  while (end > 2 && bytes[end - 1] == 0) --end;
  return end >= 2 && bytes[end - 2] == 0xff && bytes[end - 1] == 0xd9;
}

/// Ends a codestream whose writer left out the end-of-image marker (JPEG) or the end-of-codestream marker (JPEG 2000),
/// which are FF D9. Decoders wait for it; what is missing before it, they notice themselves.
void endImage(std::vector<std::uint8_t>& bytes) {
  if (isEnded(bytes)) return;
  bytes.push_back(0xff);
  bytes.push_back(0xd9);
}

/// JPEG and JPEG-LS. The header given to DCMTK is the codestream's, so that depths below the header's decode too.
void decodeJpeg(std::vector<std::uint8_t> bytes, int transferSyntax, const PixelFormat& format,
                std::span<std::byte> words) {
  const auto header = jpegHeader(bytes);
  if (!header) throw CodecError("it has no frame header");
  compare(*header, format);
  if (header->precision > 16) throw CodecError("it has more than 16 bits a sample");
  endImage(bytes);
  if (bytes.size() % 2 != 0) bytes.push_back(0);

  const bool wide = header->precision > 8;
  DcmDataset dataset;
  const auto put = [&](const DcmTagKey& tag, int value) {
    dataset.putAndInsertUint16(tag, static_cast<Uint16>(value));
  };
  put(DCM_SamplesPerPixel, 1);
  dataset.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
  put(DCM_Rows, format.rows);
  put(DCM_Columns, format.columns);
  put(DCM_BitsAllocated, wide ? 16 : 8);
  put(DCM_BitsStored, header->precision);
  put(DCM_HighBit, header->precision - 1);
  put(DCM_PixelRepresentation, 0);
  DcmPixelSequence sequence(DCM_PixelSequenceTag);
  sequence.insert(new DcmPixelItem(DCM_PixelItemTag));  // an empty offset table
  auto* item = new DcmPixelItem(DCM_PixelItemTag);
  sequence.insert(item);
  if (item->putUint8Array(bytes.data(), static_cast<Uint32>(bytes.size())).bad()) throw std::bad_alloc();

  const std::size_t count = static_cast<std::size_t>(format.rows) * static_cast<std::size_t>(format.columns);
  // One more byte than an odd frame has: DCMTK wants room for whole 16-bit words.
  std::vector<std::byte> samples(count * (wide ? 2 : 1) + 1);
  Uint32 fragment = 1;
  OFString colourModel;
  const WarningNote warnings;
  const OFCondition decoded =
      DcmCodecList::decodeFrame(DcmXfer(static_cast<E_TransferSyntax>(transferSyntax)), nullptr, &sequence, &dataset, 0,
                                fragment, samples.data(), static_cast<Uint32>(samples.size()), colourModel);
  if (decoded.bad()) throw CodecError(decoded.text());
  warnings.check();
  storeWords(format, words, [&](std::size_t i) -> std::int64_t {
    if (!wide) return std::to_integer<std::int64_t>(samples[i]);
    std::uint16_t sample = 0;
    std::memcpy(&sample, samples.data() + 2 * i, 2);
    return sample;
  });
}

/// The NUL that pads a fragment is no byte of the codestream, whose own last byte may be 0, too. Where the writer left
/// out the marker that tells them apart, the decoder does, which takes neither a byte more nor one less.
void decodeJpegLs(std::vector<std::uint8_t> bytes, int transferSyntax, const PixelFormat& format,
                  std::span<std::byte> words) {
  if (bytes.size() > 2 && bytes.back() == 0 && !isEnded(bytes)) {
    try {
      decodeJpeg({bytes.begin(), bytes.end() - 1}, transferSyntax, format, words);
      return;
    } catch (const CodecError&) {
    }
  }
  decodeJpeg(std::move(bytes), transferSyntax, format, words);
}

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

void decodeJpeg2000(Codestream codestream, const PixelFormat& format, std::span<std::byte> words) {
  // A raw codestream starts with SOC and SIZ; some writers wrap it into a JP2 file, which the standard forbids.
  const bool raw = codestream.bytes.size() > 4 && codestream.bytes[0] == 0xff && codestream.bytes[1] == 0x4f;
  if (raw) endImage(codestream.bytes);
  const OpjCodec codec(opj_create_decompress(raw ? OPJ_CODEC_J2K : OPJ_CODEC_JP2));
  const OpjStream stream(opj_stream_default_create(OPJ_TRUE));
  if (!codec || !stream) throw std::bad_alloc();
  opj_stream_set_user_data(stream.get(), &codestream, nullptr);
  opj_stream_set_user_data_length(stream.get(), codestream.bytes.size());
  opj_stream_set_read_function(stream.get(), &Codestream::read);
  opj_stream_set_skip_function(stream.get(), &Codestream::skip);
  opj_stream_set_seek_function(stream.get(), &Codestream::seek);
  const auto noteMessage = [](const char* text, void*) { note(text); };
  opj_set_warning_handler(codec.get(), noteMessage, nullptr);
  opj_set_error_handler(codec.get(), noteMessage, nullptr);
  const WarningNote warnings;

  opj_dparameters_t parameters;
  opj_set_default_decoder_parameters(&parameters);
  if (!opj_setup_decoder(codec.get(), &parameters)) throw CodecError("OpenJPEG cannot be set up");
  opj_decoder_set_strict_mode(codec.get(), OPJ_TRUE);
  opj_image_t* header = nullptr;
  const bool understood = opj_read_header(stream.get(), codec.get(), &header);
  const OpjImage image(header);
  if (!understood || !image) {
    warnings.check();
    throw CodecError("its header is damaged");
  }
  const opj_image_comp_t* component = image->comps;
  const bool has = image->numcomps > 0;
  compare({has ? component->h : 0, has ? component->w : 0, static_cast<int>(image->numcomps),
           has ? static_cast<int>(component->prec) : 0},
          format);
  const bool decoded = opj_decode(codec.get(), stream.get(), image.get());
  warnings.check();
  if (!decoded || !component->data) throw CodecError("its data are damaged");
  storeWords(format, words, [&](std::size_t i) -> std::int64_t { return component->data[i]; });
}

}  // namespace

DecodedFrame decodeFrame(std::vector<std::uint8_t> codestream, const DicomFile& file, std::span<std::byte> words) {
  const PixelFormat& format = file.format;
  switch (compressionOf(file)) {
    case Compression::Rle:
      return {decodeRle(codestream, format, words)};
    case Compression::Jpeg2000:
      decodeJpeg2000({std::move(codestream)}, format, words);
      return {};
    case Compression::Jpeg:
      decodeJpeg(std::move(codestream), file.transferSyntax, format, words);
      return {};
    case Compression::JpegLs:
      decodeJpegLs(std::move(codestream), file.transferSyntax, format, words);
      return {};
    case Compression::Encapsulated:
      decodeEncapsulated(codestream, format, words);
      return {};
    case Compression::Elscint:
      decodeElscint(codestream, format, words);
      return {};
    case Compression::Unknown:
      break;
  }
  throw CodecError("its transfer syntax is not supported");
}

}  // namespace fenestra::io
