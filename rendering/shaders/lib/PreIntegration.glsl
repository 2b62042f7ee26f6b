// What segments of a ray show of the context, with the attenuation inside them, where values change evenly along each of
// them. rendering/gpu/PreIntegration.h states the formula and the layout of its texels.
#include <schedule>
#include "lib/Transfer.glsl"

TEXELS_2D(rgba32f, preIntegration);

const int LEVELS = PRE_INTEGRATION_LEVELS, ROWS = (TABLE_SIZE + PRE_INTEGRATION_SPACING - 2) / PRE_INTEGRATION_SPACING + 1;
const int DROPPED_BITS = 23 - PRE_INTEGRATION_MANTISSA;

// Where values change by an entry every so many mm: the column for them, and the mm an entry that the column is made for.
struct Level {
  int column;
  float perEntry;
};

Level levelOf(float perEntry) {
  Level level;
  level.column = clamp((floatBitsToInt(perEntry) >> DROPPED_BITS) - transfer.firstLevel, 0, LEVELS - 1);
  level.perEntry = intBitsToFloat(((level.column + transfer.firstLevel) << DROPPED_BITS) + (1 << (DROPPED_BITS - 1)));
  return level;
}

// G and K at an entry, a multiple of PRE_INTEGRATION_SPACING or beyond the table, looking along rising or falling values.
vec4 seenFrom(float entry, bool rises, Level level) {
  int row = int(clamp(entry, 0.0, LAST_ENTRY) * (1.0 / float(PRE_INTEGRATION_SPACING)) + 0.5);
  return texelOf(preIntegration, ivec2(level.column, rises ? row : row + ROWS));
}

// Premultiplied colour and opacity, and the optical depth.
struct Segment {
  vec4 piece;
  float depth;
};

// 1 - exp(-x), by its series where the difference would cancel.
float opacityOf(float x) { return x < 1e-2 ? x * (1.0 - x * (0.5 - x * (1.0 / 6.0))) : 1.0 - exp(-x); }

// From entry a to entry b, where an entry takes so many mm. `front`, `back`: seenFrom() them. What was found for the level
// is scaled by the ratio of the opacities, which leaves an error of second order in the depth.
//
// Beyond the table's end in front of the table the medium is even: it lies over what the table shows.
Segment segmentOver(float a, vec4 front, float b, vec4 back, float perEntry, Level level) {
  bool rises = b > a;
  float below = abs(min(b, 0.0) - min(a, 0.0)), above = abs(max(b, LAST_ENTRY) - max(a, LAST_ENTRY));
  vec4 end = rises ? transfer.firstMaterial : transfer.lastMaterial;
  float before = (rises ? below : above) * end.a;
  float sum = abs(back.a - front.a) + below * transfer.firstMaterial.a + above * transfer.lastMaterial.a;
  float depth = perEntry * sum, opacity = opacityOf(depth);
  float levelDepth = level.perEntry * sum, levelOpacity = opacityOf(levelDepth);
  vec3 seen = front.rgb + opacityOf(level.perEntry * before) * (end.rgb / max(end.a, 1e-30) - front.rgb);
  // Nothing is left of equal values where nothing absorbs.
  vec3 colour = seen - back.rgb + levelOpacity * back.rgb;
  float ratio = levelOpacity > 0.0 ? opacity / levelOpacity : 1.0;
  return Segment(vec4(colour * ratio, opacity), depth);
}
