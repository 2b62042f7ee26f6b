#include "io/base/OtherContent.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace fenestra::io {
namespace {

using namespace std::string_view_literals;

constexpr const char* picture =
    "pictures do not say where they lie: save the stack as one TIFF file, as ImageJ does, or get the DICOM files";
constexpr const char* document = "open the scan that it belongs to";
constexpr const char* archive = "unpack it, then open what was in it";
constexpr const char* convertible = "convert it to NIfTI, NRRD or MetaImage with the program that wrote it";

struct Signature {
  std::string_view bytes;
  std::size_t at;
  OtherContent content;
  std::string_view start = {};  ///< of the file, besides
};
constexpr std::array signatures{
    Signature{"\x89PNG\r\n\x1a\n"sv, 0, {"a PNG picture", "PNG pictures", picture}},
    Signature{"\xff\xd8\xff"sv, 0, {"a JPEG picture", "JPEG pictures", picture}},
    Signature{"GIF8"sv, 0, {"a GIF picture", "GIF pictures", picture}},
    Signature{"\0\0\0\x0cjP  \r\n\x87\n"sv, 0, {"a JPEG 2000 picture", "JPEG 2000 pictures", picture}},
    Signature{"\0\0\0\0"sv, 6, {"a BMP picture", "BMP pictures", picture}, "BM"sv},  // reserved, behind the size
    Signature{"ftyp"sv, 4, {"a film", "films", picture}},
    Signature{"%PDF-"sv, 0, {"a PDF document", "PDF documents", document}},
    Signature{"Rar!\x1a\x07"sv, 0, {"a RAR archive", "RAR archives", archive}},
    Signature{"7z\xbc\xaf\x27\x1c"sv, 0, {"a 7z archive", "7z archives", archive}},
    Signature{"\x89HDF\r\n\x1a\n"sv,
              0,
              {"an HDF5 file (MINC, MATLAB or others)", "HDF5 files (MINC, MATLAB or others)", convertible}},
    Signature{"# vtk DataFile"sv, 0, {"a VTK file", "VTK files", convertible}},
    Signature{"<VTKFile"sv, 0, {"a VTK file", "VTK files", convertible}},
};

}  // namespace

const OtherContent* otherContentOf(std::span<const std::byte> start) {
  const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
  const auto holds = [&](std::string_view bytes, std::size_t at) {
    return text.size() >= at && text.substr(at).starts_with(bytes);
  };
  const auto known = std::ranges::find_if(signatures, [&](const Signature& signature) {
    return holds(signature.bytes, signature.at) && holds(signature.start, 0);
  });
  return known == signatures.end() ? nullptr : &known->content;
}

}  // namespace fenestra::io
