#include <cstring>
#include <functional>
#include <numeric>

#include "tests/io/Defects.h"
#include "tests/io/DicomMakes.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

DicomSpec narrow(Syntax syntax, int allocated, int stored) {
  DicomSpec spec = pictureSpec(syntax);
  spec.bitsAllocated = allocated;
  spec.bitsStored = stored;
  spec.highBit = stored - 1;
  // Smooth: DCMTK's JPEG-LS encoder overruns its buffer where packing does not make the picture smaller.
  for (std::size_t i = 0; i < spec.words.size(); ++i) spec.words[i] = static_cast<std::uint32_t>(i / 10);
  return spec;
}
DicomSpec dose() {
  DicomSpec spec = pictureSpec();
  spec.sopClass = "1.2.840.10008.5.1.4.1.1.481.2";
  spec.modality = "RTDOSE";
  spec.numberOfFrames = 2;
  spec.words.insert(spec.words.end(), spec.words.begin(), spec.words.end());
  spec.doseScaling = "0.001";
  spec.frameOffsets = "0\\2.5";
  return spec;
}
DicomSpec rescaled(const char* slopeText, const char* interceptText) {
  DicomSpec spec = pictureSpec();
  spec.slope = slopeText;
  spec.intercept = interceptText;
  return spec;
}

/// A series, and then `how` done to its folder.
Make seriesAnd(const std::function<void(const fs::path& folder)>& how) {
  return [=](const fs::path& folder) {
    series(4, asItIs)(folder);
    how(folder);
    return folder;
  };
}
/// A file of the collection of real data.
Make real(const char* name, const std::vector<Edit>& edits) {
  return [=](const fs::path& folder) {
    const fs::path from = findTestData(name);
    if (from.empty()) throw MissingTestData(name);
    DicomBytes image(readFile(from));
    for (const Edit& edit : edits) edit(image);
    writeFile(folder / "a.dcm", image.bytes());
    return folder / "a.dcm";
  };
}
constexpr const char* jpeg2000 = "dicom/pixel-formats/MR_small_jp2klossless.dcm";

/// Changes the bytes behind a marker FF xx of the codestream; `at` counts from the marker.
Edit marker(int code, std::size_t at, const std::string& replacement) {
  return change(pixels, [=](std::string& value) {
    const std::string wanted{'\xff', static_cast<char>(code)};
    const std::size_t found = value.find(wanted, 16);
    if (found == std::string::npos) throw std::runtime_error("no such marker");
    value.replace(found + at, replacement.size(), replacement);
  });
}
std::string big(int value) { return {static_cast<char>(value >> 8), static_cast<char>(value & 0xff)}; }

Edit unended = fragment([](std::string part) { return part; }, false);
Edit half = fragment([](const std::string& part) { return part.substr(0, part.size() / 4 * 2); });

template <class T>
Edit floats(std::uint32_t tag, const char* vr, int bits) {
  return [=](DicomBytes& image) {
    std::vector<T> values(1200);
    std::iota(values.begin(), values.end(), T{-600.5});
    for (const std::uint32_t integer : {pixels, bitsStored, highBit, representation}) image.drop(integer);
    image.set(bitsAllocated, "US", shortValue(bits));
    image.set(tag, vr, bytesOf(values));
  };
}

/// The dataset in deflated form. A deflate stream is a zlib stream without two bytes of header and four of checksum.
std::string deflated(const std::string& written, const std::string& dataset) {
  const std::string packed = zlibbed(dataset);
  return written.substr(0, 144 + static_cast<unsigned char>(written[140])) + packed.substr(2, packed.size() - 6);
}
/// A private element of 400 MB of zeros before the pixels.
std::string bomb(const std::string& written) {
  constexpr std::uint32_t size = 400'000'000;
  const std::string start = element(0x00080060, "CS", "CT") + std::string("\x09\x00\x10\x10OB\0\0", 8) + bytesOf(size);
  return deflated(written, start + std::string(size, '\0'));
}

/// Three time points of two slices.
Make times = series(6, [](int slice, DicomSpec& spec) {
  spec.position = glm::dvec3(0, 0, 2 * (slice % 2));
  spec.acquisitionNumber = slice / 2 + 1;
});

std::vector<Defect> geometryDefects() {
  const Expected implausible = error("its geometry is not plausible");
  const Expected garbled = warning("the pixel spacing is not two positive numbers; 1 mm is assumed");
  const Expected nowhere = warning("does not say where the slice lies");
  return {
      {"dicom without pixel spacing", file({drop(pixelSpacing)}), warning("no pixel spacing is given; 1 mm")},
      {"dicom with empty pixel spacing", file({set(pixelSpacing, "DS", "")}), warning("no pixel spacing is given")},
      {"dicom with zero pixel spacing", file({set(pixelSpacing, "DS", "0\\0")}), garbled},
      {"dicom with negative pixel spacing", file({set(pixelSpacing, "DS", "-1\\1")}), garbled},
      {"dicom with NaN as pixel spacing", file({set(pixelSpacing, "DS", "nan\\nan")}), garbled},
      {"dicom with text as pixel spacing", file({set(pixelSpacing, "DS", "wide\\wide")}), garbled},
      {"dicom with half a pixel spacing", file({set(pixelSpacing, "DS", "0.8")}), garbled},
      {"dicom with a spacing of 1e308 mm", file({set(pixelSpacing, "DS", "1e308\\1e308")}), implausible},
      {"dicom with a spacing of a millionth of a nanometre", file({set(pixelSpacing, "DS", "1e-12\\1e-12")}),
       implausible},
      {"dicom with a spacing of 2 m", file({set(pixelSpacing, "DS", "2000\\2000")}), implausible},
      {"dicom with only the detector's spacing", file({drop(pixelSpacing), set(imagerSpacing, "DS", "0.2\\0.2")}),
       warning("the pixel spacing is the detector's")},
      {"dicom at 1e300 mm", file({set(position, "DS", "1e300\\0\\0")}), implausible},
      {"dicom series of huge steps", series(3, [](int slice, DicomSpec& spec) { spec.position->z = 1e300 * slice; }),
       implausible},
      {"dicom series of slices 2 m apart",
       series(3, [](int slice, DicomSpec& spec) { spec.position->z = 2000.0 * slice; }), implausible},
      {"dicom slice of 1000 km", file({set(sliceThickness, "DS", "1e9")}), implausible},
      {"dicom without position", file({drop(position)}), nowhere},
      {"dicom with text as position", file({set(position, "DS", "here\\or\\there")}), nowhere},
      {"dicom with half a position", file({set(position, "DS", "1\\2")}), nowhere},
      {"dicom without orientation", file({drop(orientation)}), nowhere},
      {"dicom with zero orientation", file({set(orientation, "DS", "0\\0\\0\\0\\0\\0")}), nowhere},
      {"dicom with one direction twice", file({set(orientation, "DS", "1\\0\\0\\1\\0\\0")}), nowhere},
      {"dicom with NaN as orientation", file({set(orientation, "DS", "nan\\0\\0\\0\\1\\0")}), nowhere},
      {"dicom series with a frame of reference a slice",
       series(5, [](int slice, DicomSpec& spec) { spec.frameOfReference = "1.2.9." + std::to_string(slice); }),
       warning("names 5 frames of reference, most for a single slice")},
      {"dicom series of two frames of reference",
       series(6, [](int slice, DicomSpec& spec) { spec.frameOfReference = slice < 4 ? "1.2.9" : "1.2.8"; }),
       warning("another frame of reference")},
      {"dicom series of two sizes",
       series(4,
              [](int slice, DicomSpec& spec) {
                if (slice > 0) return;
                spec.rows = 10;
                spec.words.resize(400);
              }),
       warning("another size or pixel spacing")},
      {"dicom series of two orientations",
       series(4,
              [](int slice, DicomSpec& spec) {
                if (slice == 0) spec.column = {0, 0, 1};
              }),
       warning("another orientation")},
      {"dicom series with two slices at one place",
       series(4, [](int slice, DicomSpec& spec) { spec.position->z = slice < 2 ? 0 : slice; }),
       warning("at positions that other slices have already")},
      {"dicom series far from another",
       series(5,
              [](int slice, DicomSpec& spec) {
                if (slice == 4) spec.position->z = 500;
              }),
       warning("further from the others than ten times")},
      {"dicom beside a series that is not plausible", seriesAnd([](const fs::path& folder) {
         DicomSpec spec = pictureSpec();
         spec.series = "9.9";
         spec.pixelSpacing = "1e30\\1e30";
         writeDicom(folder / "other.dcm", spec);
       }),
       warning("a series cannot be opened: its voxels measure 1e+30 mm")},
  };
}

std::vector<Defect> valueDefects() {
  const Expected badSlope = warning("the rescale slope is 0 or no usable number; 1 is assumed");
  const Expected badIntercept = warning("the rescale intercept is no usable number; 0 is assumed");
  const Expected badDose = warning("the dose grid scaling is missing, 0 or no usable number");
  return {
      {"dicom with slope 0", file({}, rescaled("0", "0")), badSlope},
      {"dicom with slope NaN", file({}, rescaled("nan", "0")), badSlope},
      {"dicom with text as slope", file({set(slope, "DS", "steep")}, rescaled("1", "0")), badSlope},
      {"dicom with empty slope", file({set(slope, "DS", "")}, rescaled("1", "0")), badSlope},
      {"dicom with slope 1e300", file({}, rescaled("1e300", "0")), badSlope},
      {"dicom with infinite intercept", file({set(intercept, "DS", "inf")}, rescaled("1", "0")), badIntercept},
      {"dicom with text as intercept", file({set(intercept, "DS", "below")}, rescaled("1", "0")), badIntercept},
      {"dicom with a bad slope in some slices",
       series(4,
              [](int slice, DicomSpec& spec) {
                spec.slope = slice == 2 ? "0" : "1";
                spec.intercept = "0";
              }),
       warning("1 is assumed (in 1 of 4 slices)")},
      {"dicom with a modality table without entries",
       file({set(modalityLut, "SQ", item(element(0x00283002, "US", shortValue(4) + shortValue(0) + shortValue(16))))}),
       warning("the Modality LUT cannot be read")},
      {"dose without scaling", file({drop(doseScaling)}, dose()), badDose},
      {"dose with scaling 0", file({set(doseScaling, "DS", "0")}, dose()), badDose},
      {"dose with text as scaling", file({set(doseScaling, "DS", "much")}, dose()), badDose},
      {"dicom series of two modalities",
       series(4, [](int slice, DicomSpec& spec) { spec.modality = slice == 0 ? "CT" : "MR"; }),
       warning("the slices differ in modality (CT in 1, MR in 3); all are shown as CT")},
      {"dicom series of two photometric interpretations",
       series(4, [](int slice, DicomSpec& spec) { spec.photometric = slice == 0 ? "MONOCHROME1" : "MONOCHROME2"; }),
       warning("the slices differ in photometric interpretation (MONOCHROME1 in 1, MONOCHROME2 in 3)")},
      {"dicom series of two units",
       [](const fs::path& folder) {
         DicomSpec spec = pictureSpec();
         spec.modality = "PT";
         writeEdited(folder / "a", spec, {set(units, "CS", "BQML")});
         spec.instance = "1.2.7";
         spec.position = glm::dvec3(0, 0, 2);
         writeEdited(folder / "b", spec, {set(units, "CS", "CNTS")});
         return folder;
       },
       warning("the slices differ in unit (BQML in 1, CNTS in 1)")},
      {"dicom without pixel representation", file({drop(representation)}),
       warning("does not say whether pixels are signed")},
      {"dicom with pixel representation 7", file({set(representation, 7)}),
       warning("does not say whether pixels are signed")},
      {"dicom without photometric interpretation", file({drop(photometric)}), warning("MONOCHROME2 is assumed")},
      {"dicom with 0 samples a pixel", file({set(samples, 0)}),
       error("says 0 samples a pixel, where a MONOCHROME2 picture has 1")},
      {"dicom with 3 samples a grey pixel", file({set(samples, 3)}),
       error("says 3 samples a pixel, where a MONOCHROME2 picture has 1")},
      {"dicom of colours", file({set(photometric, "CS", "RGB"), set(samples, 3)}), error("holds colours (RGB)")},
      {"dicom of palette colours", file({set(photometric, "CS", "PALETTE COLOR")}),
       error("holds colours (PALETTE COLOR)")},
      {"dicom of 0 bits stored", file({set(bitsStored, 0)}), error("has pixels of 0 bits in 16")},
      {"dicom of more bits than allocated", file({set(bitsStored, 17)}), error("has pixels of 17 bits in 16")},
      {"dicom with a high bit outside", file({set(highBit, 20)}), error("not supported")},
      {"dicom of 12 bits allocated", file({set(bitsAllocated, 12)}), error("has pixels of 12 bits in 12")},
      {"dicom of 64 bits allocated", file({set(bitsAllocated, 64)}), error("bits in 64")},
      {"dicom of 0 rows", file({set(rows, 0)}), error("holds no image")},
      {"dicom without columns", file({drop(columns)}), error("holds no image")},
  };
}

std::vector<Defect> fileStructureDefects() {
  const Expected cut = error("its DICOM header");
  return {
      {"dicom of twice the rows", file({set(rows, 60)}), error("where its header describes 1 frame of 40 x 60")},
      {"dicom of 1000 frames", file({set(frameCount, "IS", "1000")}), error("where its header describes 1000 frames")},
      {"dicom of -3 frames", file({set(frameCount, "IS", "-3")}), error("where its header describes -3 frames")},
      {"dicom of many frames", file({set(frameCount, "IS", "many")}), error("gives no number of frames")},
      {"dicom without pixels", file({drop(pixels)}), error("its pixels cannot be read (there are none)")},
      {"dicom of too few pixels", file({change(pixels, [](std::string& value) { value.resize(2000); })}),
       error("holds 2000 bytes of pixels")},
      {"dicom cut in its pixels", bytes([](const std::string& all) { return all.substr(0, all.size() - 500); }),
       error("bytes of pixels where its header describes")},
      {"dicom cut in its header", bytes([](const std::string& all) { return all.substr(0, 500); }),
       error("its DICOM header cannot be read")},
      {"dicom of its meta header alone", bytes([](const std::string& all) { return DicomBytes(all).preamble; }), cut},
      {"dicom of its preamble alone", bytes([](const std::string& all) { return all.substr(0, 132); }),
       error("its DICOM header cannot be read")},
      {"dicom of another transfer syntax than it says", bytes([](std::string all) {
         const std::string uid = "1.2.840.10008.1.2.1";
         all.replace(all.find(uid), uid.size(), std::string("1.2.840.10008.1.2\0\0", 19));
         return all;
       }),
       error("")},
      {"dicom of an unknown transfer syntax",
       bytes(
           [](std::string all) {
             const std::string uid = "1.2.840.10008.1.2.4.70";
             all.replace(all.find(uid), uid.size(), "1.2.840.10008.1.2.4.99");
             return all;
           },
           pictureSpec(Syntax::JpegLossless)),
       error("transfer syntax is not supported")},
      {"dicom of 100000 nested sequences", bytes([](const std::string& all) {
         std::string nested;
         for (int level = 0; level < 100000; ++level)
           nested += std::string("\x08\x00\x40\x11SQ\x00\x00\xff\xff\xff\xff\xfe\xff\x00\xe0\xff\xff\xff\xff", 20);
         return DicomBytes(all).preamble + nested;
       }),
       error("nests deeper than 256 levels")},
      {"dicom without preamble", bytes([](const std::string& all) { return all.substr(132); }), opens},
      {"dicom without preamble and meta header",
       bytes([](const std::string& all) { return all.substr(DicomBytes(all).preamble.size()); }), opens},
      {"packed dicom cut",
       bytes([](const std::string& all) { return all.substr(0, all.size() - 200); }, pictureSpec(Syntax::Deflated)),
       error("ends too early")},
      {"packed dicom of noise",
       bytes([](const std::string& all) { return all.substr(0, 340) + std::string(2000, '\x5a'); },
             pictureSpec(Syntax::Deflated)),
       error("its compressed data are damaged")},
      {"packed dicom of 400 MB", bytes(bomb, pictureSpec(Syntax::Deflated)),
       error("packed DICOM header unpacks to more")},
      {"float pixels", file({floats<float>(floatPixels, "OF", 32)}), opens},
      {"double pixels", file({floats<double>(doublePixels, "OD", 64)}), opens},
      {"float pixels of 16 bits", file({floats<float>(floatPixels, "OF", 16)}), error("bits in 16")},
      {"float pixels cut",
       file({floats<float>(floatPixels, "OF", 32), change(floatPixels, [](std::string& value) { value.resize(100); })}),
       error("where its header describes 1 frame of 40 x 30")},
      {"float pixels with a mapping",
       file({floats<float>(floatPixels, "OF", 32),
             set(realWorldValues, "SQ", item(element(0x00409225, "FD", bytesOf(2.0))))}),
       warning("Real World Value Mapping")},
  };
}

std::vector<Defect> unknownVrDefects() {
  const auto all = [](DicomBytes& image) {
    for (const std::uint32_t tag : {modality, position, orientation, samples, photometric, rows, columns, pixelSpacing,
                                    bitsAllocated, bitsStored, highBit, representation, intercept, slope, pixels})
      image.makeUnknown(tag);
  };
  return {
      {"modality of unknown VR", file({unknown(modality)}), opens},
      {"spacing of unknown VR", file({unknown(pixelSpacing)}), opens},
      {"place of unknown VR", file({unknown(position), unknown(orientation)}), opens},
      {"rescale of unknown VR", file({unknown(slope), unknown(intercept)}, rescaled("2", "-1000")), opens},
      {"sizes of unknown VR", file({unknown(rows), unknown(columns), unknown(bitsStored)}), opens},
      {"colour model of unknown VR", file({unknown(photometric), unknown(samples)}), opens},
      {"pixels of unknown VR", file({unknown(pixels)}), opens},
      {"dose scaling of unknown VR", file({unknown(doseScaling)}, dose()), opens},
      {"frame count of unknown VR", file({unknown(frameCount)}, dose()), opens},
      {"everything of unknown VR", file({all}, rescaled("2", "-1000")), opens},
  };
}

std::vector<Defect> compressionDefects() {
  const DicomSpec jpeg = pictureSpec(Syntax::JpegLossless), jpegLs = pictureSpec(Syntax::JpegLs),
                  rle = pictureSpec(Syntax::Rle);
  const Expected damaged = error("cannot be decoded"), otherSize = error("where the header says 40 x 30");
  const Expected ruledOut = warning("pixels hold values that the header rules out");
  // The frame header: marker, length, precision, rows, columns, components.
  constexpr int sof = 0xc3, sofLs = 0xf7;
  return {
      {"rle without an end of sequence", file({unended}, rle), opens},
      {"jpeg without an end of sequence", file({unended}, jpeg), opens},
      {"jpeg-ls without an end of sequence", file({unended}, jpegLs), opens},
      {"jpeg without an end of image", file({withoutEnd()}, jpeg), opens},
      {"a fragment of 3 GB",
       file({change(pixels,
                    [](std::string& value) {
                      // Behind the offset table of one frame.
                      value.replace(16, 4, bytesOf(std::uint32_t{0xd0000000}));
                    })},
            jpeg),
       error("a fragment of 3489660928 bytes, of which the file holds")},
      {"no fragments", file({change(pixels, [](std::string& value) { value = fragments({}); })}, jpeg),
       error("its compressed pixels cannot be read (there are none)")},
      {"noise in place of fragments",
       file({change(pixels, [](std::string& value) { value = std::string(64, '\x11'); })}, jpeg),
       error("no fragment where one belongs")},
      {"more frames than fragments", file({set(frameCount, "IS", "3")}, jpeg), error("do not divide into 3 frames")},
      {"an empty fragment", file({fragment([](const std::string&) { return std::string(); })}, jpeg), damaged},
      {"jpeg of half the rows", file({marker(sof, 5, big(15))}, jpeg), otherSize},
      {"jpeg of twice the columns", file({marker(sof, 7, big(80))}, jpeg), otherSize},
      {"jpeg of 255 bits", file({marker(sof, 4, "\xff")}, jpeg), error("has 255 bits a sample")},
      {"jpeg of 1 bit", file({marker(sof, 4, "\x01")}, jpeg), error("has 1 bits a sample")},
      {"jpeg of three samples", file({marker(sof, 9, "\x03")}, jpeg), error("has 3 samples a pixel")},
      {"jpeg without a frame header",
       file({fragment([](const std::string&) { return std::string("\xff\xd8\xff\xd9"); })}, jpeg),
       error("it has no frame header")},
      {"jpeg cut", file({half}, jpeg), damaged},
      {"jpeg of 16 bits in 8", file({set(bitsAllocated, 8), set(bitsStored, 8), set(highBit, 7)}, jpeg),
       error("has 16 bits a sample where the header allocates 8")},
      {"jpeg of more bits than stored", file({set(bitsStored, 8), set(highBit, 7)}, jpeg), ruledOut},
      {"jpeg outside the greatest value",
       file({set(smallest, "US", shortValue(0)), set(largest, "US", shortValue(900))}, jpeg), ruledOut},
      {"jpeg-ls of half the rows", file({marker(sofLs, 5, big(15))}, jpegLs), otherSize},
      {"jpeg-ls of 255 bits", file({marker(sofLs, 4, "\xff")}, jpegLs), error("has 255 bits a sample")},
      {"jpeg-ls cut", file({half}, jpegLs), damaged},
      {"jpeg-ls of 7 bits", file({}, narrow(Syntax::JpegLs, 8, 7)), opens},
      {"jpeg-ls of 7 bits in 16", file({set(bitsAllocated, 16)}, narrow(Syntax::JpegLs, 8, 7)), opens},
      {"jpeg of 8 bits in 16", file({set(bitsAllocated, 16)}, narrow(Syntax::JpegLossless, 8, 8)), opens},
      {"rle of three segments",
       file({fragment([](std::string part) {
              part[0] = 3;
              return part;
            })},
            rle),
       error("it has 3 segments where pixels of 16 bits have 2")},
      {"rle segments outside",
       file({fragment([](std::string part) {
              part.replace(8, 4, "\xff\xff\xff\x7f");
              return part;
            })},
            rle),
       error("its RLE header is damaged")},
      {"rle cut", file({half}, rle), damaged},
      {"rle of more than its picture",
       file({fragment([](std::string part) {
              // Between the segments: the second one starts later.
              std::uint32_t second = 0;
              std::memcpy(&second, part.data() + 8, 4);
              part.insert(second, std::string(40, '\x05'));
              part.replace(8, 4, bytesOf(second + 40));
              return part;
            })},
            rle),
       error("an RLE segment is longer than its picture")},
      {"rle with bytes behind its last run",
       file({fragment([](const std::string& part) { return part + std::string(40, '\x05'); })}, rle),
       warning("40 bytes behind the last run of RLE pixels left out")},
      {"rle header cut", file({fragment([](const std::string& part) { return part.substr(0, 30); })}, rle),
       error("its RLE header is cut off")},
      // SIZ: marker, length, capabilities, columns, rows, origin, tile, tile origin, components, depth.
      {"jpeg 2000 of half the rows", real(jpeg2000, {marker(0x51, 10, std::string("\0\0\0\x20", 4))}),
       error("where the header says 64 x 64")},
      {"jpeg 2000 of 25 bits", real(jpeg2000, {marker(0x51, 40, "\x18")}), damaged},
      {"jpeg 2000 of no components", real(jpeg2000, {marker(0x51, 38, std::string(2, '\0'))}), damaged},
      {"jpeg 2000 cut", real(jpeg2000, {half}), damaged},
      {"jpeg 2000 of noise", real(jpeg2000, {fragment([](const std::string& part) {
                                    return part.substr(0, 4) + std::string(part.size() - 4, '\x77');
                                  })}),
       damaged},
      {"jpeg 2000 outside the greatest value", real(jpeg2000, {set(largest, "SS", shortValue(1000))}), ruledOut},
  };
}

std::vector<Defect> folderDefects() {
  return {
      {"an empty folder", [](const fs::path& folder) { return folder; }, error("is an empty folder")},
      {"a folder of letters",
       [](const fs::path& folder) {
         writeFile(folder / "letter.txt", "Dear colleague");
         return folder;
       },
       error("holds no DICOM images")},
      {"a folder of pictures",
       [](const fs::path& folder) {
         for (const char* name : {"s1.png", "s2.png", "s3.png"}) writeFile(folder / name, "\x89PNG\r\n\x1a\n...");
         writeFile(folder / "letter.pdf", "%PDF-1.4");
         return folder;
       },
       error("holds no DICOM images, but 3 PNG pictures; pictures do not say where they lie")},
      {"a folder of a document",
       [](const fs::path& folder) {
         writeFile(folder / "letter.pdf", "%PDF-1.4");
         return folder;
       },
       error("holds no DICOM images, but a PDF document")},
      {"a folder of volume files",
       [](const fs::path& folder) {
         writeFile(folder / "ct.nii.gz", "a volume");
         writeFile(folder / "letter.txt", "Dear colleague");
         writeFile(folder / "mr.NRRD", "another");
         return folder;
       },
       error("ct.nii.gz (or the other one)")},
      {"a damaged file among others", seriesAnd([](const fs::path& folder) {
         const std::string all = readFile(folder / "3.dcm");
         writeFile(folder / "3.dcm", all.substr(0, all.size() - 100));
       }),
       warning("1 file left out, unreadable")},
      {"damaged compression among others", seriesAnd([](const fs::path& folder) {
         DicomSpec spec = pictureSpec(Syntax::JpegLossless);
         spec.instance = "1.2.3.50";
         spec.position = glm::dvec3(0, 0, 8);
         writeEdited(folder / "5.dcm", spec, {half});
       }),
       warning("1 file left out, unreadable (the first: the pixels of frame 1")},
      {"a letter among slices",
       seriesAnd([](const fs::path& folder) { writeFile(folder / "letter.txt", "Dear colleague"); }),
       warning("1 file of the folder left out: not DICOM")},
      {"a slice twice", seriesAnd([](const fs::path& folder) { fs::copy_file(folder / "1.dcm", folder / "copy"); }),
       warning("the same images (SOP instances)")},
      {"all files damaged",
       [](const fs::path& folder) {
         series(3, asItIs)(folder);
         for (const char* name : {"0.dcm", "1.dcm", "2.dcm"})
           writeFile(folder / name, readFile(folder / name).substr(0, 900));
         return folder;
       },
       error("none of its 3 DICOM files can be read")},
      {"a segmentation", file({set(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.4")}),
       error("is a DICOM segmentation")},
      {"time points", times, warning("number 1 is shown; --time N chooses another")},
      {"the second time point", times, warning("number 2 is shown"), "", 2},
      {"a time point beyond the last", times, error("has no time point 4; its time points are numbered from 1 to 3"),
       "", 4},
      {"a time point of one slice", file({}), error("has no time point 2; it holds one volume"), "", 2},
  };
}

}  // namespace

std::vector<Defect> dicomDefects() {
  std::vector<Defect> all;
  for (const auto& part : {geometryDefects(), valueDefects(), fileStructureDefects(), unknownVrDefects(),
                           compressionDefects(), folderDefects()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace fenestra::tests
