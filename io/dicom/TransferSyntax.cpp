#include "io/dicom/TransferSyntax.h"

#include <algorithm>
#include <array>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dccodec.h>

#include "io/dicom/Dcmtk.h"

namespace fenestra::io {
namespace {

/// Transfer syntaxes that DCMTK 3.6.7 does not know (PS3.6 table A-1).
struct Syntax {
  const char *uid, *name;
  Compression compression;
  bool lossless;
};
constexpr std::array<Syntax, 8> youngSyntaxes = {
    {{"1.2.840.10008.1.2.1.98", "Encapsulated Uncompressed Explicit VR Little Endian", Compression::Encapsulated, true},
     {"1.2.840.10008.1.2.4.201", "High-Throughput JPEG 2000 (Lossless Only)", Compression::Jpeg2000, true},
     {"1.2.840.10008.1.2.4.202", "High-Throughput JPEG 2000 with RPCL (Lossless Only)", Compression::Jpeg2000, true},
     {"1.2.840.10008.1.2.4.203", "High-Throughput JPEG 2000", Compression::Jpeg2000, false},
     {"1.2.840.10008.1.2.4.204", "JPIP HTJ2K Referenced", Compression::Unknown, false},
     {"1.2.840.10008.1.2.4.110", "JPEG XL Lossless", Compression::Unknown, true},
     {"1.2.840.10008.1.2.4.111", "JPEG XL JPEG Recompression", Compression::Unknown, false},
     {"1.2.840.10008.1.2.4.112", "JPEG XL", Compression::Unknown, false}}};

const Syntax* youngSyntax(const DicomFile& file) {
  const auto at = std::find_if(youngSyntaxes.begin(), youngSyntaxes.end(),
                               [&](const Syntax& syntax) { return file.syntaxUid == syntax.uid; });
  return at == youngSyntaxes.end() ? nullptr : &*at;
}

/// Whether DCMTK knows the file's transfer syntax; what it does not know, it reads as another.
bool isKnown(const DicomFile& file) {
  return file.syntaxUid.empty() || DcmXfer(file.syntaxUid.c_str()).getXfer() != EXS_Unknown;
}

}  // namespace

Compression compressionOf(const DicomFile& file) {
  if (file.pixels.isPrivate) return Compression::Elscint;
  if (const Syntax* syntax = youngSyntax(file)) return syntax->compression;
  if (!isKnown(file)) return Compression::Unknown;
  const auto syntax = static_cast<E_TransferSyntax>(file.transferSyntax);
  switch (syntax) {
    case EXS_RLELossless:
      return Compression::Rle;
    case EXS_JPEG2000LosslessOnly:
    case EXS_JPEG2000:
      return Compression::Jpeg2000;
    case EXS_JPEGLSLossless:
    case EXS_JPEGLSLossy:
      return Compression::JpegLs;
    default:
      break;
  }
  prepareDcmtk();
  return DcmCodecList::canChangeCoding(syntax, EXS_LittleEndianExplicit) ? Compression::Jpeg : Compression::Unknown;
}

std::string syntaxName(const DicomFile& file) {
  if (const Syntax* syntax = youngSyntax(file)) return syntax->name;
  if (!isKnown(file)) return file.syntaxUid;
  return DcmXfer(static_cast<E_TransferSyntax>(file.transferSyntax)).getXferName();
}

bool isLossless(const DicomFile& file) {
  if (file.pixels.isPrivate) return true;
  if (const Syntax* syntax = youngSyntax(file)) return syntax->lossless;
  const auto syntax = static_cast<E_TransferSyntax>(file.transferSyntax);
  return syntax == EXS_RLELossless || syntax == EXS_JPEG2000LosslessOnly || syntax == EXS_JPEGLSLossless ||
         syntax == EXS_JPEGProcess14 || syntax == EXS_JPEGProcess14SV1;
}

}  // namespace fenestra::io
