// Principal curvatures of the level set through a point, from first and second derivatives of a C² reconstruction: the
// cubic B-spline over the derivative volume (Kindlmann, Whitaker, Tasdizen, Möller, Vis 2003, section 3).
#include <derivative>
#include <schedule>
#include "lib/Grid.glsl"
#include "lib/Uniforms.glsl"

uniform float contextMargin;  // mm: hits nearer than this to the box's entry or to the focus are no surface of their own

// Cubic B-spline weights of the four neighbours at offset f in [0, 1), and their first and second derivatives.
void derivativeWeights(float f, out vec4 w, out vec4 dw, out vec4 ddw) {
  float g = 1.0 - f;
  w = vec4(g * g * g, 4.0 - 3.0 * f * f * (2.0 - f), 4.0 - 3.0 * g * g * (2.0 - g), f * f * f) / 6.0;
  dw = vec4(-g * g, f * (3.0 * f - 4.0), g * (4.0 - 3.0 * g), f * f) * 0.5;
  ddw = vec4(g, 3.0 * f - 2.0, 3.0 * g - 2.0, f);
}

const int SHORT = 8;  // an axis of fewer texels is near its ends everywhere

struct LevelSet {
  vec3 gradient;   // world, stored units per mm
  float k1, k2;    // 1/mm, k1 ≥ k2; positive where the surface bends away from lower values
  float noise;     // 1: the gradient is nothing but rounding
  float within;    // 0 where the spline takes values from beyond the volume's faces, along an axis of SHORT texels or
                   // more, and 1 from one texel further in
};

LevelSet levelSetAt(vec3 position) {
  vec3 index = (voxelPosition(position) - 0.5) / derivative.factor - 0.5;
  vec3 base = floor(index);
  vec4 wx, dx, ddx, wy, dy, ddy, wz, dz, ddz;
  derivativeWeights(index.x - base.x, wx, dx, ddx);
  derivativeWeights(index.y - base.y, wy, dy, ddy);
  derivativeWeights(index.z - base.z, wz, dz, ddz);
  ivec3 last = sizeOf(derivativeVolume) - 1;
  vec3 g = vec3(0.0), diagonal = vec3(0.0), mixed = vec3(0.0);  // mixed: xy, xz, yz
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 4; ++y) {
      ivec3 row = ivec3(base) + ivec3(-1, y - 1, z - 1);
      vec4 v;
      for (int x = 0; x < 4; ++x)
        v[x] = texelOf(derivativeVolume, clamp(row + ivec3(x, 0, 0), ivec3(0), last)).r;
      vec3 along = vec3(dot(v, wx), dot(v, dx), dot(v, ddx));
      g += vec3(along.y * wy[y] * wz[z], along.x * dy[y] * wz[z], along.x * wy[y] * dz[z]);
      diagonal += vec3(along.z * wy[y] * wz[z], along.x * ddy[y] * wz[z], along.x * wy[y] * ddz[z]);
      mixed += vec3(along.y * dy[y] * wz[z], along.y * wy[y] * dz[z], along.x * dy[y] * dz[z]);
    }
  mat3 hessian = mat3(diagonal.x, mixed.x, mixed.y, mixed.x, diagonal.y, mixed.z, mixed.y, mixed.z, diagonal.z);
  hessian = derivative.worldFromDerivative * hessian * transpose(derivative.worldFromDerivative) * derivative.scale;
  LevelSet result;
  result.gradient = derivative.worldFromDerivative * g * derivative.scale;
  float size = length(result.gradient);
  vec3 inside = mix(min(index - 1.0, vec3(last) - 1.0 - index), vec3(1.0), lessThan(last + 1, ivec3(SHORT)));
  result.within = clamp(min(inside.x, min(inside.y, inside.z)), 0.0, 1.0);
  result.k1 = result.k2 = 0.0;
  result.noise = size > 1e-6 ? 0.0 : 1.0;
  if (result.noise > 0.0) return result;
  vec3 n = result.gradient / size;
  // Shape operator -P H P / |g| on the tangent plane, P = I - n nᵀ; its trace and norm give both curvatures.
  mat3 p = mat3(1.0) - outerProduct(n, n);
  mat3 shape = -(p * hessian * p) / size;
  float trace = shape[0][0] + shape[1][1] + shape[2][2];
  float norm2 = dot(shape[0], shape[0]) + dot(shape[1], shape[1]) + dot(shape[2], shape[2]);
  float spread = sqrt(max(2.0 * norm2 - trace * trace, 0.0));
  result.k1 = 0.5 * (trace + spread);
  result.k2 = 0.5 * (trace - spread);
  return result;
}
