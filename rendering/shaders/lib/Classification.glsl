// The transfer function of the context, and the material of the focus. Emission is colour · extinction (1/mm).

// Rows of TABLE_SIZE entries: emission and extinction; the integral of both from the first entry on (entries/mm); the
// integral of emission times that of extinction up to there.
layout(rgba32f) uniform readonly image2D transferTables;
uniform vec2 transferMap;            // entry = stored value · x + y
uniform vec4 firstMaterial, lastMaterial;  // beyond the table's ends
uniform vec2 visibleEntries;         // nothing shows up to the first or from the second on
const float LAST_ENTRY = float(TABLE_SIZE - 1);

// The tables are read to the nearest entry.
vec4 materialAt(float entry) {
  return imageLoad(transferTables, ivec2(int(clamp(entry, 0.0, LAST_ENTRY) + 0.5), 0));
}

// An entry, whole and not clamped, and the tables' integral up to there inside them.
struct Bound {
  float entry;
  vec4 integral;
};

Bound boundAt(float entry) {
  Bound bound;
  bound.entry = floor(entry + 0.5);
  bound.integral = imageLoad(transferTables, ivec2(int(clamp(bound.entry, 0.0, LAST_ENTRY)), 1));
  return bound;
}

// Below this many entries between two of the table's integrals (float32), their difference keeps too few digits, and
// one entry stands for all.
const float LEAST_SPAN = 8.0;

// The one of the entries phase + 2 n LEAST_SPAN that is nearest: those of two phases are LEAST_SPAN apart.
Bound boundNear(float entry, float phase) {
  Bound bound;
  bound.entry = 2.0 * LEAST_SPAN * floor(entry / (2.0 * LEAST_SPAN) + (0.5 - phase / (2.0 * LEAST_SPAN))) + phase;
  bound.integral = imageLoad(transferTables, ivec2(int(clamp(bound.entry, 0.0, LAST_ENTRY)), 1));
  return bound;
}

// Mean material where values run evenly from one bound to the other (pre-integrated classification: Engel, Kraus, Ertl
// 2001, without attenuation inside).
vec4 meanMaterial(Bound a, Bound b) {
  float span = b.entry - a.entry;
  if (abs(span) < LEAST_SPAN) return materialAt(0.5 * (a.entry + b.entry));
  vec4 sum = b.integral - a.integral;
  float below = min(b.entry, 0.0) - min(a.entry, 0.0);
  float above = max(b.entry, LAST_ENTRY) - max(a.entry, LAST_ENTRY);
  sum += below * firstMaterial;
  sum += above * lastMaterial;
  return max(sum / span, vec4(0.0));
}

#if FOCUS_KIND != 0
uniform vec4 focusProperties;  // colour, extinction (1/mm)
#if FOCUS_KIND == 1 && FOCUS_PALETTE
uniform usampler3D focusPaletteIndex;
uniform ivec3 focusOrigin;      // index of the palette texture's first voxel
uniform sampler2D focusPalette; // colours, one row
#endif

vec4 focusMaterial(vec3 at) {
  vec3 colour = focusProperties.rgb;
#if FOCUS_KIND == 1 && FOCUS_PALETTE
  uint entry = texelFetch(focusPaletteIndex, ivec3(floor(at - 0.5)) - focusOrigin, 0).r;
  colour = texelFetch(focusPalette, ivec2(entry, 0), 0).rgb;
#endif
  return vec4(colour, 1.0) * focusProperties.a;
}

#endif

// Premultiplied colour and opacity of a piece of ray over which values run evenly from one bound to another, at least
// LEAST_SPAN away: meanMaterial() and pieceOf() in one.
vec4 pieceOver(Bound a, Bound b, float lengthOfPiece) {
  vec4 sum = b.integral - a.integral;
  sum += (min(b.entry, 0.0) - min(a.entry, 0.0)) * firstMaterial;
  sum += (max(b.entry, LAST_ENTRY) - max(a.entry, LAST_ENTRY)) * lastMaterial;
  float perEntry = lengthOfPiece / (b.entry - a.entry), depth = sum.a * perEntry;
  return sum * (depth < 1e-2 ? perEntry * (1.0 - depth * (0.5 - depth * (1.0 / 6.0))) : (1.0 - exp(-depth)) / sum.a);
}

// (1 - exp(-x)) / x, by its series where the difference would cancel.
float relativeOpacity(float x) { return x < 1e-2 ? 1.0 - x * (0.5 - x * (1.0 / 6.0)) : (1.0 - exp(-x)) / x; }

// Premultiplied colour and opacity of a piece of ray of one material. Shaded colour = colour · light.x + light.y.
vec4 pieceOf(vec4 material, float lengthOfPiece, vec2 light) {
  return vec4(material.rgb * light.x + material.a * light.y, material.a)
         * (lengthOfPiece * relativeOpacity(material.a * lengthOfPiece));
}

// Where in a piece of one material what is seen of it comes from on average, 0 to 1 from its front: ∫ x exp(-depth·x) dx
// over ∫ exp(-depth·x) dx. Light that changes evenly along a piece is there what it is on average.
float centreOfEmission(float depth) {
  float passed = exp(-depth);  // as relativeOpacity() has it: one exponential for both
  return depth < 0.1 ? 0.5 - depth / 12.0 : 1.0 / depth - passed / (1.0 - passed);
}
