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

// Three texels a segment, one below the other, SEGMENTS_PER_ROW side by side: low, high and anchor; material; slope.
TEXELS_2D(rgba32f, transferSegments);
layout(std430, binding = 3) readonly buffer SegmentOfEntry { uint segmentOfEntry[]; };  // of each entry of the tables

Segment segmentAt(int index) {
  ivec2 first = ivec2(index % SEGMENTS_PER_ROW, 3 * (index / SEGMENTS_PER_ROW));
  vec4 ends = texelOf(transferSegments, first);
  return Segment(ends.x, ends.y, ends.z, texelOf(transferSegments, first + ivec2(0, 1)),
                 texelOf(transferSegments, first + ivec2(0, 2)));
}

// A segment of one material throughout.
Segment constantSegment(vec4 material) { return Segment(-FAR, FAR, 0.0, material, vec4(0.0)); }

// The segment that holds an entry, or one beside it where a node lies within half an entry. `function`: 0 is the volume's, then
// come those of the focus.
int segmentNear(int function, float entry) {
  return int(segmentOfEntry[function * TABLE_SIZE + int(clamp(entry, 0.0, LAST_ENTRY) + 0.5)]);
}
int segmentNear(float entry) { return segmentNear(0, entry); }
