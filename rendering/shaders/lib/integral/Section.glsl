// A path through a cell, and the parts that it falls into: sections in the focus or in the context, and of these what lies
// in one segment of a transfer function.
#include <colours>
#include <focus>
#include <translucent>
#include <shown>
#include "lib/Crossing.glsl"
#include "lib/FocusSides.glsl"
#include "lib/TransferSegments.glsl"
#include "lib/integral/Bodies.glsl"
#include "lib/integral/PathLight.glsl"
#include "lib/integral/Settings.glsl"

// What a ray finds between two faces of a cell. Vectors of four are Bernstein coefficients along it.
struct CellPath {
  ivec3 cell;
  vec3 a, b;          // both ends within the cell, 0 to 1
  float sFrom, sTo;   // mm along the ray
  vec4 entries;       // table entries of the values
  vec4 focusAlong;    // the focus's field, where some of the path may be in the focus
  vec4 stored;        // values; with FOCUS_BY_VALUE
  uint labels;        // of the context, as labelsIn() has them
};

float lowest(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float highest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// Fills in the values between both ends of a path.
void setValues(inout CellPath path, vec4 stored) {
  // Within limits whose squares and differences float32 holds.
  path.entries = clamp(stored * transfer.map.x + transfer.map.y, vec4(-1e12), vec4(1e12));
  if (FOCUS_BY_VALUE) path.stored = stored;
}

bool mayShow(CellPath path) {
  vec2 visible = transfer.visibleEntries;
  return highest(path.entries) > visible.x && lowest(path.entries) < visible.y;
}

// Fills in the focus's field.
void setFocus(inout CellPath path, FocusCell held, vec4 stored) {
  path.focusAlong = focusAlong(held, path.a, path.b, stored);
  // integrateSections() asks the field also where none of the cell is in the focus.
  vec4 outside = vec4(focusRange().x > -3e38 ? -3.4e38 : 3.4e38);
  if (HAS_FAINT) path.focusAlong = mix(outside, path.focusAlong, bvec4(mayHoldFocus(held)));
}

bool mayMeetFocus(CellPath path) {
  vec2 range = focusRange();
  return lowest(path.focusAlong) <= range.y && highest(path.focusAlong) >= range.x;
}

// A part of a path that is all in the focus, of one material or function, or all in the context, of one label.
struct Section {
  float uFrom, uTo;  // of the path
  float sFrom, sTo;  // mm along the ray
  vec4 entries;      // of the context's tables, or of the table of the focus's function
  bool inFocus;
  vec4 material;     // of the focus
  int function;      // of the focus; 0: one material. With FOCUS_BY_VALUE
  Label label;       // with HAS_BODIES
  CellNormals normals;
};

bool isByValue(Section section) { return !section.inFocus || (FOCUS_BY_VALUE && section.function > 0); }
int functionOf(Section section) { return FOCUS_BY_VALUE && section.inFocus ? section.function : 0; }

// Chooses the label and the function of a section.
void findFunction(inout Section section, CellPath path, vec3 at) {
  if (HAS_BODIES) {
    section.label = noLabel();
    if (section.inFocus) {
      section.label = focusLabel(at);
    } else if (HAS_FAINT) {
      int label = labelAt(at);
      section.label = label > 0 ? Label(label, opacityOf(label)) : noLabel();
    }
  }
  if (FOCUS_BY_VALUE) {
    vec4 table = focusTable(at);
    section.function = section.inFocus ? int(table.x) / 2 : 0;
    vec4 entries = clamp(path.stored * table.y + table.z, vec4(-1e12), vec4(1e12));
    if (section.inFocus && section.function > 0) section.entries = bernsteinBetween(entries, section.uFrom, section.uTo);
  }
}

// A part of a section in one segment of a transfer function.
struct Part {
  float from, to;  // of the section
  vec4 entries;
  Segment segment;
};

Part partBetween(Part part, float u, float v) {
  return Part(mix(part.from, part.to, u), mix(part.from, part.to, v), bernsteinBetween(part.entries, u, v), part.segment);
}
