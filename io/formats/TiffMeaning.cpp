#include "io/formats/TiffMeaning.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "io/base/Text.h"
#include "io/base/Units.h"

namespace fenestra::io {
namespace {

/// The lines "name=value" of ImageJ's description; empty for any other.
std::map<std::string, std::string> imageJFields(const std::string& description) {
  std::map<std::string, std::string> fields;
  if (!description.starts_with("ImageJ=")) return fields;
  for (const std::string& line : split(description, '\n'))
    if (const std::size_t equals = line.find('='); equals != std::string::npos)
      fields[line.substr(0, equals)] = trimmed(line.substr(equals + 1));
  return fields;
}

/// An attribute of OME-XML's first Pixels element; empty where there is none.
std::string omeAttribute(const std::string& description, std::string_view name) {
  const std::size_t pixels = description.find("<Pixels ");
  if (description.find("<OME") == std::string::npos || pixels == std::string::npos) return {};
  const std::string tag = description.substr(pixels, description.find('>', pixels) - pixels);
  const std::size_t at = tag.find(std::string(" ").append(name).append("=\""));
  if (at == std::string::npos) return {};
  const std::size_t begin = at + name.size() + 3;
  return tag.substr(begin, tag.find('"', begin) - begin);
}

double positive(const std::string& text) {
  const auto number = numberIn<double>(text);
  return number && std::isfinite(*number) && *number > 0.0 ? *number : 0.0;
}

std::int64_t count(const std::string& text) {
  const auto number = numberIn<std::int64_t>(text);
  return number && *number >= 1 && *number <= 1'000'000 ? *number : 1;
}

/// `length` in the unit, mm; 0 where either is not known.
double inMillimetres(double length, const std::string& unit, TiffSpacing& spacing) {
  if (length == 0.0 || isNoUnit(unit) || lowered(unit).starts_with("pixel")) return 0.0;
  if (const auto each = millimetresIn(unit)) return length * *each;
  spacing.unknownUnit = unit;
  return 0.0;
}

void readOme(const std::string& description, TiffSpacing& spacing) {
  int axis = 0;
  for (const char* name : {"PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ"}) {
    std::string unit = omeAttribute(description, std::string(name) + "Unit");
    if (unit.empty()) unit = "um";  // as OME's schema has it
    spacing.millimetres[axis++] = inMillimetres(positive(omeAttribute(description, name)), unit, spacing);
  }
  spacing.source = "OME's description";
}

void readImageJ(const TiffPage& page, std::map<std::string, std::string>& fields, TiffSpacing& spacing) {
  const std::string unit = fields["unit"];
  if (page.xResolution > 0.0 && page.yResolution > 0.0) {
    spacing.millimetres.x = inMillimetres(1.0 / page.xResolution, unit, spacing);
    spacing.millimetres.y = inMillimetres(1.0 / page.yResolution, unit, spacing);
  }
  spacing.millimetres.z = inMillimetres(std::abs(numberIn<double>(fields["spacing"]).value_or(0.0)), unit, spacing);
  spacing.source = "ImageJ's description";
}

/// Resolutions of screens, printers and scanners of paper, which programs write into any file.
bool isOfPrints(double pixelsPerInch) {
  for (const double print :
       {72.0, 75.0, 90.0, 96.0, 100.0, 120.0, 144.0, 150.0, 200.0, 240.0, 300.0, 360.0, 400.0, 600.0, 1200.0})
    if (std::abs(pixelsPerInch - print) < 0.01 * print) return true;
  return false;
}

void readResolution(const TiffPage& page, TiffSpacing& spacing) {
  const double unit = page.resolutionUnit == 2 ? 25.4 : page.resolutionUnit == 3 ? 10.0 : 0.0;
  if (unit == 0.0 || !(page.xResolution > 0.0) || !(page.yResolution > 0.0)) return;
  const glm::dvec2 size(unit / page.xResolution, unit / page.yResolution);
  if (isOfPrints(25.4 / size.x) || page.xResolution == 1.0) {
    spacing.printResolution = plainNumber(25.4 / size.x) + " pixels an inch";
    return;
  }
  spacing.millimetres = glm::dvec3(size, 0.0);
  spacing.source = "its resolution";
}

}  // namespace

std::int64_t TiffOrder::pageOf(std::int64_t slice, std::int64_t channel, std::int64_t time) const {
  std::int64_t page = 0, step = 1;
  for (const char axis : order) {
    page += step * (axis == 'Z' ? slice : axis == 'C' ? channel : time);
    step *= axis == 'Z' ? slices : axis == 'C' ? channels : times;
  }
  return page;
}

std::optional<TiffOrder> tiffOrder(const std::string& description) {
  TiffOrder order;
  if (auto fields = imageJFields(description); !fields.empty()) {
    order.images = count(fields["images"]);
    order.channels = count(fields["channels"]);
    order.times = count(fields["frames"]);
    order.slices = fields.contains("slices") ? count(fields["slices"]) : order.images;
    return order;
  }
  const std::string axes = omeAttribute(description, "DimensionOrder");
  if (!axes.starts_with("XY") || axes.size() != 5) return std::nullopt;
  std::string sorted = axes.substr(2);
  std::sort(sorted.begin(), sorted.end());
  if (sorted != "CTZ") return std::nullopt;
  order.order = axes.substr(2);
  order.slices = count(omeAttribute(description, "SizeZ"));
  order.channels = count(omeAttribute(description, "SizeC"));
  order.times = count(omeAttribute(description, "SizeT"));
  return order;
}

TiffSpacing tiffSpacing(const TiffPage& page, const std::string& description) {
  TiffSpacing spacing;
  if (auto fields = imageJFields(description); !fields.empty())
    readImageJ(page, fields, spacing);
  else if (!omeAttribute(description, "PhysicalSizeX").empty())
    readOme(description, spacing);
  if (spacing.millimetres.x == 0.0 || spacing.millimetres.y == 0.0) {
    spacing.millimetres = glm::dvec3(0.0);
    readResolution(page, spacing);
  }
  return spacing;
}

}  // namespace fenestra::io
