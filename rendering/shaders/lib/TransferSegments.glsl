// Transfer functions segment by segment, without the tables' rounding: from one node to the next, colour and extinction
// change evenly with the value. A step lies between two segments.
#include <schedule>
#include "lib/None.glsl"
#include "lib/Transfer.glsl"

struct Segment {
  float low, high;        // entries
  float anchor;           // an entry
  vec4 material;          // there: colour, extinction (1/mm)
  vec4 slope;             // of the material, an entry
};

// Three texels a segment, one below the other, SEGMENTS_PER_ROW side by side: low, high, anchor and what roundingOf() gives; material; slope.
TEXELS_2D(rgba32f, transferSegments);
layout(std430, binding = 3) readonly buffer SegmentOfEntry { uint segmentOfEntry[]; };  // of each entry of the tables

ivec2 firstTexelOf(int index) { return ivec2(index % SEGMENTS_PER_ROW, 3 * (index / SEGMENTS_PER_ROW)); }

// Where a segment begins and ends.
vec2 endsOf(int index) { return texelOf(transferSegments, firstTexelOf(index)).xy; }

Segment segmentAt(int index) {
  ivec2 first = firstTexelOf(index);
  vec4 ends = texelOf(transferSegments, first);
  return Segment(ends.x, ends.y, ends.z, texelOf(transferSegments, first + ivec2(0, 1)),
                 texelOf(transferSegments, first + ivec2(0, 2)));
}

// More than rounding moves an entry of the segment's function, in entries.
float roundingOf(int index) { return texelOf(transferSegments, firstTexelOf(index)).w; }

// A segment of one material throughout.
Segment constantSegment(vec4 material) { return Segment(-FAR, FAR, 0.0, material, vec4(0.0)); }

// The segment that holds an entry, or the one beside it where a node lies within half an entry. `function`: 0 is the volume's,
// then come those of the focus.
int segmentNear(int function, float entry) {
  return int(segmentOfEntry[function * TABLE_SIZE + int(clamp(entry, 0.0, LAST_ENTRY) + 0.5)]);
}

// The segment that holds an entry; above a step at its value. The first and the last segment have no end.
int segmentFrom(int index, float entry) {
  while (entry >= endsOf(index).y) ++index;
  while (entry < endsOf(index).x) --index;
  return index;
}

// Whether a path has one value, but for rounding.
bool isEven(vec4 entries, float rounding) {
  vec4 off = abs(entries - entries.x);
  return max(off.y, max(off.z, off.w)) <= rounding;
}

// The segment in which a path begins. One that has the very value of a step throughout lies above it, as all of a mask may;
// for others rounding moves the place where they cross it.
int segmentOf(int function, vec4 entries) {
  int near = segmentNear(function, entries.x);
  float rounding = roundingOf(near);
  return segmentFrom(near, entries.x + (isEven(entries, rounding) ? rounding : 0.0));
}
