// The lighting model (rendering/scene/Lighting.h): light at points of the volume, and on the face that the opening cut.

uniform sampler3D gradientTexture;  // gated normals, zero at 511/1023
uniform vec3 gradientOrigin;        // cell frame position of its first texel's outer corner; beyond it all is flat
uniform float certainLength;        // of a gated normal, from which on it is lit in full
uniform float meanIncidence;        // |n·l| where there is no normal

#if FOCUS_KIND == 1
uniform sampler3D focusSmooth;      // smoothed indicator around the focus
uniform vec3 focusSmoothOrigin;     // cell frame position of its first texel's outer corner
uniform mat3 worldFromIndexGradient;

vec3 focusNormal(vec3 position) {
  vec3 size = vec3(textureSize(focusSmooth, 0));
  vec3 at = (position - focusSmoothOrigin) / size, e = 1.0 / size;
  vec3 g = vec3(texture(focusSmooth, at + vec3(e.x, 0, 0)).r - texture(focusSmooth, at - vec3(e.x, 0, 0)).r,
                texture(focusSmooth, at + vec3(0, e.y, 0)).r - texture(focusSmooth, at - vec3(0, e.y, 0)).r,
                texture(focusSmooth, at + vec3(0, 0, e.z)).r - texture(focusSmooth, at - vec3(0, 0, e.z)).r);
  return worldFromIndexGradient * g;
}
#endif

vec2 lightAt(vec3 at, vec3 rayDirection, bool focus) {
  vec3 normal = texture(gradientTexture, (at - gradientOrigin) / vec3(textureSize(gradientTexture, 0))).xyz
                * (1023.0 / 511.0) - 1.0;
  float certainty = smoothstep(0.0, certainLength, length(normal));
#if FOCUS_KIND == 1
  if (focus) {
    vec3 smoothed = focusNormal(at);
    if (dot(smoothed, smoothed) > 1e-6) {
      normal = smoothed;
      certainty = 1.0;
    }
  }
#endif
  vec2 flatLight = vec2(lighting.x + meanIncidence * lighting.y, 0.0);
  float size = dot(normal, normal);
  return size > 1e-6 ? mix(flatLight, lightOf(normal * inversesqrt(size), rayDirection), certainty) : flatLight;
}

#if HAS_RAY_START
uniform float wallDepth;  // mm behind a cut face over which its own light gives way to the volume's
uniform float wallShare;  // of a cut face's light that is the face's own at its surface

// Normal of the cut face at a pixel, from its neighbours' ray starts; zero where the ray does not start on a cut face.
vec3 wallNormal(ivec2 pixel, float start) {
  vec2 hit = texelFetch(hitPoints, pixel, 0).xy;
  if (!isNone(hit.y) || start <= hit.x + 0.5 * wallDepth) return vec3(0.0);
  vec3 tangent[2];
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = ivec2(1 - axis, axis);
    ivec2 a = max(pixel - step, ivec2(0)), b = min(pixel + step, pictureSize - 1);
    float sa = texelFetch(rayStart, a, 0).r, sb = texelFetch(rayStart, b, 0).r;
    if (isNone(sa) || isNone(sb)) return vec3(0.0);
    tangent[axis] = worldPosition(pixelRay(b), sb) - worldPosition(pixelRay(a), sa);
  }
  vec3 n = cross(tangent[0], tangent[1]);
  float size = length(n);
  return size > 0.0 ? n / size : vec3(0.0);
}
#endif
