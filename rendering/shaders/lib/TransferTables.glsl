// Transfer functions as tables.
#include <schedule>
#include "lib/Transfer.glsl"

// Rows of TABLE_SIZE entries, two a function, the context's first: emission and extinction; the integral of
// both from the first entry on (entries/mm).
TEXELS_2D(rgba32f, transferTables);

// A function's place in the tables.
struct Table {
  int row;           // its first
  vec4 first, last;  // materials beyond the ends
};

Table contextTable() { return Table(0, transfer.firstMaterial, transfer.lastMaterial); }

// The table of a function whose materials beyond the ends are those at the ends.
Table tableFrom(int row) {
  return Table(row, texelOf(transferTables, ivec2(0, row)), texelOf(transferTables, ivec2(TABLE_SIZE - 1, row)));
}

// The tables are read to the nearest entry.
vec4 materialAt(Table table, float entry) {
  return texelOf(transferTables, ivec2(int(clamp(entry, 0.0, LAST_ENTRY) + 0.5), table.row));
}
vec4 materialAt(float entry) { return materialAt(contextTable(), entry); }

// A table entry as a whole number, not clamped to the table, and the integrals at the nearest entry inside the table.
struct Bound {
  float entry;
  vec4 integral;
};

Bound boundAt(Table table, float entry) {
  Bound bound;
  bound.entry = floor(entry + 0.5);
  bound.integral = texelOf(transferTables, ivec2(int(clamp(bound.entry, 0.0, LAST_ENTRY)), table.row + 1));
  return bound;
}

// Over fewer entries than this the difference of two integrals (float32) keeps too few digits; the middle entry is used
// instead.
const float LEAST_SPAN = 8.0;

// The nearest of the entries phase + 2 n LEAST_SPAN. Those of the phases 0 and LEAST_SPAN are LEAST_SPAN apart at least.
float entryNear(float entry, float phase) {
  return 2.0 * LEAST_SPAN * floor(entry / (2.0 * LEAST_SPAN) + (0.5 - phase / (2.0 * LEAST_SPAN))) + phase;
}

// The nearest entry half way between two of those.
float entryBetween(float entry) { return LEAST_SPAN * floor(entry / LEAST_SPAN) + 0.5 * LEAST_SPAN; }

// Mean material where values run evenly from one bound to another, at least LEAST_SPAN away (pre-integrated
// classification: Engel, Kraus, Ertl 2001, without attenuation inside).
vec4 meanOverSpan(Table table, Bound a, Bound b) {
  float span = b.entry - a.entry;
  vec4 sum = b.integral - a.integral;
  float below = min(b.entry, 0.0) - min(a.entry, 0.0);
  float above = max(b.entry, LAST_ENTRY) - max(a.entry, LAST_ENTRY);
  sum += below * table.first;
  sum += above * table.last;
  return max(sum / span, vec4(0.0));
}

// Mean material for bounds at any distance. Lavapipe of Mesa 22.3 crashes on the branch in meanMaterial() in some programs, but
// not on this.
vec4 meanWithoutBranch(Table table, Bound a, Bound b) {
  vec4 near = materialAt(table, 0.5 * (a.entry + b.entry));
  return mix(meanOverSpan(table, a, b), near, bvec4(abs(b.entry - a.entry) < LEAST_SPAN));
}
vec4 meanMaterial(Table table, Bound a, Bound b) {
  if (abs(b.entry - a.entry) < LEAST_SPAN) return materialAt(table, 0.5 * (a.entry + b.entry));
  return meanOverSpan(table, a, b);
}
