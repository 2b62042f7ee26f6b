// Transfer functions segment by segment, without the tables' rounding: from one node to the next, colour and extinction
// change evenly with the value. A step lies between two segments.
#include <schedule>
#include "lib/None.glsl"
#include "lib/Transfer.glsl"

// A segment begins and ends a hair below the nodes: more than rounding moves an entry. So a step's own value, which a
// whole region may have, is in the segment above it.
struct Segment {
  float low, high;        // entries
  float anchor;           // an entry
  vec4 material;          // there: colour, extinction (1/mm)
  vec4 slope;             // of the material, an entry
};

// Three texels a segment, one below the other, SEGMENTS_PER_ROW side by side: low, high, anchor and the hair; material; slope.
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

// By how much the volume's segments begin and end below their nodes, in entries.
float hair() { return texelOf(transferSegments, ivec2(0)).w; }

// A segment of one material throughout.
Segment constantSegment(vec4 material) { return Segment(-FAR, FAR, 0.0, material, vec4(0.0)); }

// The segment that holds an entry. `function`: 0 is the volume's, then come those of the focus.
int segmentOf(int function, float entry) {
  int index = int(segmentOfEntry[function * TABLE_SIZE + int(clamp(entry, 0.0, LAST_ENTRY) + 0.5)]);
  // Nodes may lie within half an entry. The first and the last segment have no end.
  while (entry >= endsOf(index).y) ++index;
  while (entry < endsOf(index).x) --index;
  return index;
}
int segmentOf(float entry) { return segmentOf(0, entry); }
