#pragma once
// How rows of the tables of defects make their DICOM files: written whole, then edited element by element.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/io/DicomBytes.h"
#include "tests/io/DicomWriter.h"

namespace fenestra::tests {

inline constexpr std::uint32_t modality = 0x00080060, units = 0x00541001;
inline constexpr std::uint32_t sliceThickness = 0x00180050, imagerSpacing = 0x00181164;
inline constexpr std::uint32_t position = 0x00200032, orientation = 0x00200037;
inline constexpr std::uint32_t samples = 0x00280002, photometric = 0x00280004, frameCount = 0x00280008,
                               rows = 0x00280010, columns = 0x00280011, pixelSpacing = 0x00280030;
inline constexpr std::uint32_t bitsAllocated = 0x00280100, bitsStored = 0x00280101, highBit = 0x00280102,
                               representation = 0x00280103, smallest = 0x00280106, largest = 0x00280107;
inline constexpr std::uint32_t intercept = 0x00281052, slope = 0x00281053, modalityLut = 0x00283000,
                               doseScaling = 0x3004000e;
inline constexpr std::uint32_t realWorldValues = 0x00409096;
inline constexpr std::uint32_t floatPixels = 0x7fe00008, doublePixels = 0x7fe00009, pixels = 0x7fe00010;

using Make = std::function<std::filesystem::path(const std::filesystem::path&)>;
using Edit = std::function<void(DicomBytes&)>;

/// Sets an element, or changes it where it is.
Edit set(std::uint32_t tag, const std::string& vr, const std::string& value);
Edit set(std::uint32_t tag, int value);
Edit drop(std::uint32_t tag);
Edit unknown(std::uint32_t tag);
Edit change(std::uint32_t tag, const std::function<void(std::string&)>& how);

std::filesystem::path writeEdited(const std::filesystem::path& path, const DicomSpec& spec,
                                  const std::vector<Edit>& edits);
Make file(const std::vector<Edit>& edits, const DicomSpec& spec = pictureSpec());
/// The bytes of a written file changed as a whole.
Make bytes(const std::function<std::string(std::string)>& how, const DicomSpec& spec = pictureSpec());
/// A folder of `count` slices 2 mm apart, each changed as `how` says, by edits of its own and by those of all.
Make series(int count, const std::function<void(int slice, DicomSpec&)>& how, const std::vector<Edit>& edits = {},
            const std::function<std::vector<Edit>(int slice)>& own = {});
void asItIs(int slice, DicomSpec& spec);

/// Encapsulated pixels: an empty offset table, fragments, the end.
std::string fragments(const std::vector<std::string>& parts, bool ended = true);
/// The one fragment of a compressed frame changed, with lengths that are right.
Edit fragment(const std::function<std::string(std::string)>& how, bool ended = true);
/// The one fragment without its last end of image or codestream (FFD9).
Edit withoutEnd();

/// An element with explicit VR and a short length; an item of a sequence.
std::string element(std::uint32_t tag, const std::string& vr, const std::string& value);
std::string item(const std::string& content);
/// A sequence of one item.
std::string sequence(std::uint32_t tag, const std::string& content);
/// A value of tags (AT).
std::string tagValue(std::uint32_t tag);

}  // namespace fenestra::tests
