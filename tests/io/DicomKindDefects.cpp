// What writers of DICOM files do differently, by kind: padding, numbers, identifiers, encodings, files from before
// DICOM. What parts images is tested in DicomPartsTest.cpp, where places come from in DicomPlacesTest.cpp.

#include <cstring>

#include "tests/io/Defects.h"
#include "tests/io/DicomMakes.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t recognition = 0x00080010, imageType = 0x00080008, instanceUid = 0x00080018,
                        seriesUid = 0x0020000e, seriesNumber = 0x00200011, echoTime = 0x00180081,
                        tamarType = 0x07a11011, tamarPixels = 0x07a1100a;

/// A value of text padded to an even length by NUL, where blanks belong.
std::string padded(std::string value) {
  value += '\0';
  if (value.size() % 2 != 0) value += '\0';
  return value;
}

std::vector<Defect> paddingDefects() {
  return {
      {"photometric interpretation padded with NUL", file({set(photometric, "CS", padded("MONOCHROME1"))}), opens},
      {"colours padded with NUL", file({set(photometric, "CS", padded("RGB")), set(samples, 3)}),
       error("holds colours (RGB), not values")},
      {"numbers padded with NUL",
       file({set(pixelSpacing, "DS", padded("0.5\\0.5")), set(position, "DS", padded("1.5\\2\\3")),
             set(orientation, "DS", padded("1\\0\\0\\0\\1\\0"))}),
       opens},
      {"counts padded with NUL", file({set(frameCount, "IS", padded("1"))}), opens},
      {"photometric interpretation behind a blank", file({set(photometric, "CS", " MONOCHROME2")}), opens},
      {"photometric interpretation in lower case", file({set(photometric, "CS", "monochrome2")}), opens},
      {"transfer syntax padded with a blank", bytes([](std::string all) {
         const std::string uid("1.2.840.10008.1.2.1\0", 20);
         return all.replace(all.find(uid), uid.size(), "1.2.840.10008.1.2.1 ");
       }),
       opens},
      {"identifiers padded with NUL and blanks",
       file({set(instanceUid, "UI", std::string("1.2.3.4.5\0 ", 11)), set(modality, "CS", padded("CT"))}), opens},
  };
}

std::vector<Defect> numberDefects() {
  const Expected comma = warning("numbers are written with a comma, which DICOM forbids");
  return {
      {"decimal commas in the position", file({set(position, "DS", "-30,25\\-40,75\\103")}), comma},
      {"decimal commas in the pixel spacing", file({set(pixelSpacing, "DS", "0,5\\0,5")}), comma},
      {"decimal commas in the rescale", file({set(slope, "DS", "1,5"), set(intercept, "DS", "-1024,0")}), comma},
      {"two commas in a number", file({set(position, "DS", "1,234,5\\0\\0")}),
       warning("does not say where the slice lies")},
      {"a comma and a point in a number", file({set(position, "DS", "1,234.5\\0\\0")}),
       warning("does not say where the slice lies")},
      {"a unit behind a number", file({set(pixelSpacing, "DS", "0.5 mm\\0.5 mm")}),
       warning("the pixel spacing is not two positive numbers")},
      {"position of unlimited text",
       file({set(position, "UT", "1.5\\2\\3"), set(orientation, "UT", "1\\0\\0\\0\\1\\0"),
             set(pixelSpacing, "UT", "0.5\\0.5")}),
       opens},
      {"numbers of long strings", file({set(position, "LO", "1.5\\2\\3"), set(pixelSpacing, "SH", "0.5\\0.5")}), opens},
      {"numbers with signs and exponents",
       file({set(pixelSpacing, "DS", "+5E-1\\5e-01"), set(position, "DS", "+1.5\\+2\\-.5")}), opens},
      {"numbers between blanks", file({set(pixelSpacing, "DS", " 0.5 \\ 0.5 "), set(position, "DS", " 1.5\\ 2 \\3 ")}),
       opens},
      {"numbers of more than sixteen letters",
       file({set(pixelSpacing, "DS", "0.5000000000000000000001\\0.5000000000000000000001")}), opens},
      {"a backslash behind the last number", file({set(pixelSpacing, "DS", "0.5\\0.5\\")}), opens},
      {"counts with a decimal point", file({set(frameCount, "IS", "1.0")}), opens},
      {"dicom of 0 frames", file({set(frameCount, "IS", "0")}), warning("the header counts 0 frames; one is read")},
  };
}

std::vector<Defect> identifierDefects() {
  const auto ofSeries = [](int slice) {
    return std::vector{set(seriesUid, "UI", "1.2.9." + std::to_string(slice + 1))};
  };
  return {
      {"one instance uid for all slices", series(6, [](int, DicomSpec& spec) { spec.instance = "1.2.3"; }),
       warning("6 files share a SOP Instance UID though their places or pixels differ")},
      {"one instance uid for two pictures of one place",
       series(2,
              [](int slice, DicomSpec& spec) {
                spec.instance = "1.2.3";
                spec.position = glm::dvec3(0);
                spec.words.assign(1200, static_cast<std::uint32_t>(slice));
              }),
       warning("2 files share a SOP Instance UID")},
      {"a series uid for each slice", series(6, asItIs, {}, ofSeries), warning("6 slices have a Series UID each")},
      {"slices without instance uids", series(6, asItIs, {drop(instanceUid)}), opens},
      {"slices with empty instance uids", series(6, asItIs, {set(instanceUid, "UI", "")}), opens},
      {"slices without a series uid", series(6, asItIs, {drop(seriesUid)}), opens},
      {"series uids padded with NUL and with blanks",
       series(6, asItIs, {},
              [](int slice) {
                return std::vector{set(seriesUid, "UI", slice % 2 == 0 ? "1.2.9 " : std::string("1.2.9\0", 6))};
              }),
       opens},
      {"one instance number for all slices", series(6, [](int, DicomSpec& spec) { spec.instanceNumber = 7; }), opens},
      {"one series uid for two series of the same places",
       series(
           8, [](int slice, DicomSpec& spec) { spec.position = glm::dvec3(0, 0, 2 * (slice % 4)); }, {},
           [](int slice) { return std::vector{set(seriesNumber, "IS", slice < 4 ? "3" : "4")}; }),
       warning("told apart by series number")},
      {"one series uid for slices of two thicknesses",
       series(
           6, [](int slice, DicomSpec& spec) { spec.position = glm::dvec3(0, 0, slice < 4 ? slice : 3 * (slice - 4)); },
           {}, [](int slice) { return std::vector{set(sliceThickness, "DS", slice < 4 ? "1" : "3")}; }),
       warning("told apart by slice thickness")},
      {"series of single slices far apart",
       series(
           6, [](int slice, DicomSpec& spec) { spec.position = glm::dvec3(0, 0, slice * slice * 7); }, {}, ofSeries),
       opens},
      {"series of single slices that are described otherwise",
       series(
           6, [](int slice, DicomSpec& spec) { spec.description = "scout " + std::to_string(slice); }, {}, ofSeries),
       opens},
  };
}

/// The meta header's transfer syntax replaced by one of the same length, or a shorter one padded.
std::string renamedSyntax(std::string all, const std::string& from, std::string to) {
  to.resize(from.size(), '\0');
  return all.replace(all.find(from), from.size(), to);
}

/// The pixels in one fragment, without compression.
Make encapsulated(bool whole) {
  return [=](const fs::path& folder) {
    writeDicom(folder / "a.dcm", pictureSpec(Syntax::JpegLossless));
    DicomBytes image(readFile(folder / "a.dcm"));
    std::string raw;
    for (const std::uint32_t word : pictureSpec().words) raw += shortValue(static_cast<int>(word));
    if (!whole) raw.resize(raw.size() - 20);
    image.value(pixels) = fragments({raw});
    writeFile(folder / "a.dcm", renamedSyntax(image.bytes(), "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.1.98"));
    return folder / "a.dcm";
  };
}

/// The picture in the element of Elscint, as differences of words; `type` names its compression.
Make elscint(const std::string& type, bool cut = false) {
  return file({drop(pixels), set(0x07a10010, "LO", "ELSCINT1"), set(tamarType, "CS", type), [=](DicomBytes& image) {
                 std::string packed;
                 for (const std::uint32_t word : pictureSpec().words)
                   packed += std::string("\x5a") + static_cast<char>(word & 0xff) + static_cast<char>(word >> 8);
                 // A5 stands for itself as a run of one.
                 std::string runs;
                 for (const char c : packed) runs += c == '\xa5' ? std::string("\xa5\x00\xa5", 3) : std::string(1, c);
                 image.set(tamarPixels, "OB", cut ? runs.substr(0, 900) : runs);
               }});
}

/// A real JPEG 2000 file under another transfer syntax.
Make jpeg2000As(const std::string& uid, const std::vector<Edit>& edits = {}) {
  return [=](const fs::path& folder) {
    const char* name = "dicom/pixel-formats/MR_small_jp2klossless.dcm";
    const fs::path from = findTestData(name);
    if (from.empty()) throw MissingTestData(name);
    DicomBytes image(readFile(from));
    for (const Edit& edit : edits) edit(image);
    std::string all = image.bytes();
    const std::string old = "1.2.840.10008.1.2.4.90";
    if (!uid.empty()) {
      // One letter longer: both are padded to 24 bytes with room to spare in the element that follows.
      const std::size_t at = all.find(old);
      all.replace(at, old.size(), uid + '\0');
      all[at - 2] = static_cast<char>(uid.size() + 1);
      all[140] = static_cast<char>(static_cast<unsigned char>(all[140]) + uid.size() + 1 - old.size());
    }
    writeFile(folder / "a.dcm", all);
    return folder / "a.dcm";
  };
}

std::string followed(const std::string& stream) { return stream + std::string(40, '\0'); }

/// A codestream as a file of JPEG 2000 holds it (ISO 15444-1, annex I); the picture is one of 64 x 64.
std::string boxed(const std::string& stream) {
  const auto box = [](const std::string& type, const std::string& content) {
    return bytesOf(static_cast<std::uint32_t>(content.size() + 8), true) + type + content;
  };
  const std::string size = bytesOf(std::uint32_t{64}, true) + bytesOf(std::uint32_t{64}, true);
  const std::string header =
      box("ihdr", size + std::string("\0\1\x8f\7\0\0", 6)) + box("colr", std::string("\1\0\0\0\0\0\x11", 7));
  return box("jP  ", "\r\n\x87\n") + box("ftyp", std::string("jp2 \0\0\0\0jp2 ", 12)) + box("jp2h", header) +
         box("jp2c", stream);
}

std::vector<Defect> encodingDefects() {
  const auto renamed = [](const char* uid) {
    return bytes([=](const std::string& all) { return renamedSyntax(all, "1.2.840.10008.1.2.4.70", uid); },
                 pictureSpec(Syntax::JpegLossless));
  };
  return {
      {"jpeg 2000 without an end of codestream", jpeg2000As("", {withoutEnd()}), opens},
      {"jpeg 2000 called high throughput, lossless", jpeg2000As("1.2.840.10008.1.2.4.201"), opens},
      {"jpeg 2000 called high throughput, rpcl", jpeg2000As("1.2.840.10008.1.2.4.202"), opens},
      {"jpeg 2000 called high throughput", jpeg2000As("1.2.840.10008.1.2.4.203"), opens},
      {"jpeg 2000 in the boxes of a file", jpeg2000As("", {fragment(boxed)}), opens},
      {"jpeg 2000 with bytes behind its end", jpeg2000As("", {fragment(followed)}), opens},
      {"jpeg with bytes behind its end", file({fragment(followed)}, pictureSpec(Syntax::JpegLossless)), opens},
      {"jpeg-ls with bytes behind its end", file({fragment(followed)}, pictureSpec(Syntax::JpegLs)), opens},
      {"jpeg-ls without an end of image", file({withoutEnd()}, pictureSpec(Syntax::JpegLs)), opens},
      {"bytes behind the dataset", bytes([](const std::string& all) { return all + std::string(512, '\0'); }), opens},
      {"padding behind the dataset", file({set(0xfffcfffc, "OB", std::string(126, '\0'))}), opens},
      {"a film", jpeg2000As("1.2.840.10008.1.2.4.102"), error("its transfer syntax is not supported (MPEG-4")},
      {"jpeg xl", jpeg2000As("1.2.840.10008.1.2.4.110"),
       error("its transfer syntax is not supported (JPEG XL Lossless)")},
      {"a transfer syntax of nobody's", renamed("1.2.840.10008.1.2.9.70"),
       error("its transfer syntax is not supported (1.2.840.10008.1.2.9.70)")},
      {"encapsulated uncompressed", encapsulated(true), opens},
      {"encapsulated uncompressed cut", encapsulated(false), error("it has 2380 bytes where its picture needs 2400")},
      {"pixels of elscint", elscint("PMSCT_RLE1"), opens},
      {"pixels of elscint cut", elscint("PMSCT_RLE1", true), error("its pixels end too early")},
      {"pixels of elscint in another compression", elscint("LOSSLESS_RICE"),
       error("its pixels stand in a private element of Elscint (07a1,100a), compressed as LOSSLESS_RICE")},
  };
}

/// A file of implicit elements without a meta header, as programs wrote before DICOM.
Make acrNema(const std::string& version) {
  return [=](const fs::path& folder) {
    std::string all;
    const auto add = [&](std::uint32_t tag, std::string value) {
      if (value.size() % 2 != 0) value += ' ';
      all += tagValue(tag) + bytesOf(static_cast<std::uint32_t>(value.size())) + value;
    };
    add(0x00080000, bytesOf(std::uint32_t{8 + static_cast<std::uint32_t>(version.size())}));
    add(recognition, version);
    add(modality, "MR");
    add(0x00200030, "1\\2\\3");
    add(0x00200035, "1\\0\\0\\0\\1\\0");
    add(rows, shortValue(30));
    add(columns, shortValue(40));
    add(pixelSpacing, "0.5\\0.5");
    add(bitsAllocated, shortValue(16));
    add(bitsStored, shortValue(12));
    add(highBit, shortValue(11));
    add(representation, shortValue(0));
    std::string raw;
    for (const std::uint32_t word : pictureSpec().words) raw += shortValue(static_cast<int>(word));
    add(pixels, raw);
    writeFile(folder / "a.acr", all);
    return folder / "a.acr";
  };
}

std::vector<Defect> oldDefects() {
  const Expected old = warning("the file is from before DICOM (ACR-NEMA)");
  return {{"acr-nema 1.0", acrNema("ACR-NEMA 1.0"), old}, {"acr-nema 2.0", acrNema("ACR-NEMA 2.0"), old}};
}

/// Two values at the same four places.
Make twoAt(std::uint32_t tag, const char* vr, const char* first, const char* second) {
  return series(
      8,
      [](int slice, DicomSpec& spec) {
        spec.modality = "MR";
        spec.position = glm::dvec3(0, 0, slice % 4);
        spec.instanceNumber = slice % 4 + 1;
      },
      {}, [=](int slice) { return std::vector{set(tag, vr, slice < 4 ? first : second)}; });
}

std::vector<Defect> partDefects() {
  return {
      {"two echoes of equal instance numbers", twoAt(echoTime, "DS", "2.46", "4.92"),
       warning(
           "4 slices of the series put into volumes of their own: echo time 4.92 ms; this volume: echo time 2.46 ms")},
      {"magnitude and phase in one series",
       twoAt(imageType, "CS", "ORIGINAL\\PRIMARY\\M\\ND", "ORIGINAL\\PRIMARY\\P\\ND"),
       warning("image component phase; this volume: image component magnitude")},
  };
}

}  // namespace

std::vector<Defect> dicomKindDefects() {
  std::vector<Defect> all;
  for (const auto& part :
       {paddingDefects(), numberDefects(), identifierDefects(), encodingDefects(), oldDefects(), partDefects()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace fenestra::tests
