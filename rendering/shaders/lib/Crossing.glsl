// First point where a trilinear field along a ray leaves an open interval.
//
// Inside a cell the field along a segment is a cubic. Its Bernstein coefficients are values of the trilinear form at
// mixed end points (its blossom), so their hull bounds the field: no crossing can be missed.
#include "lib/None.glsl"

// Bernstein coefficients from a to b, both within a cell with these corners.
vec4 bernsteinAlong(float f[8], vec3 a, vec3 b) {
  vec4 low = vec4(f[0], f[2], f[4], f[6]), high = vec4(f[1], f[3], f[5], f[7]);
  vec4 xa = mix(low, high, a.x), xb = mix(low, high, b.x);
  vec2 xaya = mix(xa.xz, xa.yw, a.y), xayb = mix(xa.xz, xa.yw, b.y);
  vec2 xbya = mix(xb.xz, xb.yw, a.y), xbyb = mix(xb.xz, xb.yw, b.y);
  float b1 = mix(xbya.x, xbya.y, a.z) + mix(xayb.x, xayb.y, a.z) + mix(xaya.x, xaya.y, b.z);
  float b2 = mix(xbyb.x, xbyb.y, a.z) + mix(xbya.x, xbya.y, b.z) + mix(xayb.x, xayb.y, b.z);
  return vec4(mix(xaya.x, xaya.y, a.z), b1 / 3.0, b2 / 3.0, mix(xbyb.x, xbyb.y, b.z));
}

// Bernstein coefficients of vectors. Indices are constants: some drivers mishandle others.
vec3 bilinear(vec3 f0, vec3 f1, vec3 f2, vec3 f3, vec2 w) { return mix(mix(f0, f1, w.x), mix(f2, f3, w.x), w.y); }

void bernsteinAlong(vec3 f[8], vec3 a, vec3 b, out vec3 along[4]) {
  vec3 xa[4] = vec3[4](mix(f[0], f[1], a.x), mix(f[2], f[3], a.x), mix(f[4], f[5], a.x), mix(f[6], f[7], a.x));
  vec3 xb[4] = vec3[4](mix(f[0], f[1], b.x), mix(f[2], f[3], b.x), mix(f[4], f[5], b.x), mix(f[6], f[7], b.x));
  along[0] = bilinear(xa[0], xa[1], xa[2], xa[3], a.yz);
  along[1] = (bilinear(xb[0], xb[1], xb[2], xb[3], a.yz) + bilinear(xa[0], xa[1], xa[2], xa[3], vec2(b.y, a.z)) +
              bilinear(xa[0], xa[1], xa[2], xa[3], vec2(a.y, b.z))) / 3.0;
  along[2] = (bilinear(xb[0], xb[1], xb[2], xb[3], vec2(b.y, a.z)) +
              bilinear(xb[0], xb[1], xb[2], xb[3], vec2(a.y, b.z)) + bilinear(xa[0], xa[1], xa[2], xa[3], b.yz)) / 3.0;
  along[3] = bilinear(xb[0], xb[1], xb[2], xb[3], b.yz);
}

float bernstein(vec4 b, float u) {
  vec3 c = mix(b.xyz, b.yzw, u);
  vec2 d = mix(c.xy, c.yz, u);
  return mix(d.x, d.y, u);
}

vec3 bernstein(vec3 b[4], float u) {
  return mix(mix(mix(b[0], b[1], u), mix(b[1], b[2], u), u), mix(mix(b[1], b[2], u), mix(b[2], b[3], u), u), u);
}

// Whether the hull reaches out of (low, high). Without that there is no crossing; with it there nearly always is one.
bool leavesHull(vec4 b, float low, float high) {
  return any(lessThanEqual(b, vec4(low))) || any(greaterThanEqual(b, vec4(high)));
}

// The part from `from` to `to` of the cubic, by its blossom.
vec4 bernsteinBetween(vec4 b, float from, float to) {
  vec3 c = mix(b.xyz, b.yzw, from), d = mix(b.xyz, b.yzw, to);
  vec2 cc = mix(c.xy, c.yz, from), dd = mix(d.xy, d.yz, to);
  return vec4(mix(cc.x, cc.y, from), mix(cc.x, cc.y, to), mix(dd.x, dd.y, from), mix(dd.x, dd.y, to));
}

// The u between 0 and 1 where the cubic turns around, in order; 1 where it does not.
vec2 turningPoints(vec4 b) {
  // Roots of the derivative d0(1-u)² + 2 d1 u(1-u) + d2 u², by the formula that does not cancel.
  // Scaled to one, so that no value a float can hold overflows in the squares.
  vec3 d = b.yzw - b.xyz;
  d /= max(max(abs(d.x), max(abs(d.y), abs(d.z))), 1e-30);
  float qa = d.x - 2.0 * d.y + d.z, qb = d.y - d.x, qc = d.x;
  float discriminant = qb * qb - qa * qc;
  float r1 = 1.0, r2 = 1.0;
  if (discriminant > 0.0) {
    float q = -(qb + (qb >= 0.0 ? sqrt(discriminant) : -sqrt(discriminant)));
    if (qa != 0.0) r1 = q / qa;
    if (q != 0.0) r2 = qc / q;
    if (!(r1 > 0.0 && r1 < 1.0)) r1 = 1.0;
    if (!(r2 > 0.0 && r2 < 1.0)) r2 = 1.0;
  }
  return vec2(min(r1, r2), max(r1, r2));
}

// The first u' > u, at most 1, where the cubic rises above 0 or no longer does.
float nextSignChange(vec4 b, float u) {
  if (all(greaterThan(b, vec4(0.0))) || all(lessThanEqual(b, vec4(0.0)))) return 1.0;
  vec2 turns = turningPoints(b);
  float from = u, to = 1.0;
  bool before = bernstein(b, u) > 0.0, changes = false;
  for (int i = 0; i < 3; ++i) {
    float end = i < 2 ? turns[i] : 1.0;
    if (changes || end <= from) continue;
    changes = (bernstein(b, end) > 0.0) != before;
    if (changes) to = end;
    else from = end;
  }
  // Bisection in a monotone piece, down to rounding.
  for (int i = 0; i < 22 && changes; ++i) {
    float middle = 0.5 * (from + to);
    if ((bernstein(b, middle) > 0.0) != before) to = middle;
    else from = middle;
  }
  return to;
}

// Whether the cubic leaves (low, high), and the monotone piece of it from `piece.x`, inside, to `piece.y`, outside, in
// which it first does; both 0 when it starts outside.
bool leaves(vec4 b, float low, float high, out vec2 piece) {
  piece = vec2(0.0);
  if (b.x <= low || b.x >= high) return true;
  vec2 turns = turningPoints(b);
  vec3 values = vec3(bernstein(b, turns.x), bernstein(b, turns.y), b.w);
  bvec3 isOut = bvec3(uvec3(lessThanEqual(values, vec3(low))) | uvec3(greaterThanEqual(values, vec3(high))));
  piece = isOut.x ? vec2(0.0, turns.x) : isOut.y ? turns : vec2(turns.y, 1.0);
  return any(isOut);
}

// u in [0, 1] where the cubic first leaves (low, high); 2 when it never does.
float firstExit(vec4 b, float low, float high) {
  vec2 piece;
  if (!leaves(b, low, high, piece)) return 2.0;
  float end = bernstein(b, piece.y);
  bool down = end <= low;
  float level = down ? low : high;
  // Newton's method from the point where a straight line would cross, kept inside the bracket that remains. It ends when
  // a step is below float's resolution of most positions. At an extremum it converges slowly and halves its error.
  float u = mix(piece.x, piece.y, clamp((b.x - level) / (b.x - end), 0.0, 1.0));
  for (int i = 0; i < 22; ++i) {
    vec3 c = mix(b.xyz, b.yzw, u);
    vec2 d = mix(c.xy, c.yz, u);
    float value = mix(d.x, d.y, u);
    if (down ? value <= level : value >= level) piece.y = u;
    else piece.x = u;
    float next = u - (value - level) / (3.0 * (d.y - d.x));
    if (!(next >= piece.x && next <= piece.y)) next = 0.5 * (piece.x + piece.y);
    float moved = abs(next - u);
    u = next;
    if (moved < 1e-5) break;
  }
  return u;
}

// Where the parabola of these values at 0, 1/2 and 1 is `level` or more, from and to 0 … 1; empty where from ≥ to. There
// may be two such parts: then that nearer to 0.
vec2 partAbove(vec3 values, float level) {
  float start = values.x - level, rise = values.z - values.x, bend = 4.0 * values.y - 2.0 * (values.x + values.z);
  // start + slope u - bend u²
  float slope = rise + bend, discriminant = slope * slope + 4.0 * bend * start;
  if (discriminant < 0.0) return values.y >= level ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
  float q = -0.5 * (slope + (slope >= 0.0 ? sqrt(discriminant) : -sqrt(discriminant)));
  float inner = q != 0.0 ? start / q : 0.0, outer = bend != 0.0 ? -q / bend : inner;
  vec2 roots = vec2(min(inner, outer), max(inner, outer));
  if (bend > 0.0) return clamp(roots, 0.0, 1.0);
  bool outside = start < 0.0 || (start == 0.0 && slope < 0.0);
  float next = roots.x > 0.0 ? roots.x : roots.y > 0.0 ? roots.y : FAR;
  return clamp(outside ? vec2(roots.y > 0.0 ? roots.y : FAR, FAR) : vec2(0.0, next), 0.0, 1.0);
}
