// The volume rendering integral by the midpoint rule, at samples a fixed step apart: quick, with an error that is only
// as small as the step.

uniform float stepLength;  // mm
uniform sampler3D volumeTexture;

#if FOCUS_KIND == 1
bool inFocus(uint slot, ivec3 cell, vec3 position, float stored) {
  return focusIndicator(focusCorners(slot, cell), position - vec3(cell)) >= 0.5;
}
#elif FOCUS_KIND == 2
bool inFocus(uint slot, ivec3 cell, vec3 position, float stored) {
  return stored >= focusLow && stored <= focusHigh && focusCellKept(slot, cell);
}
#endif

// Loops here are left at their ends: where rays that run side by side share their instructions, a loop left earlier
// runs to its end all the same, for nobody.
vec4 integrate(Ray ray, float start, Cut cut) {
  vec4 result = vec4(0.0);
  vec3 perCell = 1.0 / vec3(volumeDims);
  int count = int(ceil((ray.sOut - start) / stepLength - 0.5)), k = 0;
  if (count <= 0) return result;
  do {
    // To the next brick that shows something, and the sample behind its last one.
    ivec3 brick;
    int empty, kEnd;
    do {
      brick = clamp(ivec3(cellPosition(ray, start + (float(k) + 0.5) * stepLength)), ivec3(0), volumeDims) >> BRICK_SHIFT;
      empty = int(imageLoad(occupiedSkip, brick).r);
      int reach = max(empty, 1);
      int axis;
      float leave = blockExit(ray, (brick - (reach - 1)) * BRICK_SIDE, (brick + reach) * BRICK_SIDE, axis);
      // Samples keep their places whatever is skipped, so that skipping never changes the picture.
      kEnd = clamp(int(ceil((leave - start) / stepLength - 0.5)), k + 1, count);
      if (empty > 0) k = kEnd;
    } while (empty > 0 && k < count);
    if (k == count) break;
#if FOCUS_KIND != 0
    uint slot = imageLoad(focusBricks, brick).r;
#endif
    do {
      float s = start + (float(k) + 0.5) * stepLength;
      vec3 at = cellPosition(ray, s);
      float stored = texture(volumeTexture, (at - 0.5) * perCell).r * texelScale;
      vec4 material;
      bool focus = false;
#if FOCUS_KIND != 0
      // A sample on the brick's face is kept from reading the neighbour's cells under this brick's slot.
      focus = slot != 0u && inFocus(slot, clamp(ivec3(at), brick * BRICK_SIDE, (brick + 1) * BRICK_SIDE - 1), at, stored);
      if (focus)
        material = focusMaterial(at);
      else
#endif
        material = materialAt(stored * transferMap.x + transferMap.y);
      if (material.a > 0.0) {
        vec2 light = vec2(1.0, 0.0);
#if SHADING
        light = behindCut(lightAt(at, ray.world, focus), cut, s);
#endif
        result += (1.0 - result.a) * pieceOf(material, stepLength, light);
      }
      ++k;
    } while (k < kEnd && 1.0 - result.a >= leastTransmittance);
  } while (k < count && 1.0 - result.a >= leastTransmittance);
  return result;
}

void integrate(Ray rays[RAYS], float starts[RAYS], Cut cuts[RAYS], bool visible[RAYS], out vec4 results[RAYS]) {
  results[0] = vec4(0.0);
  if (visible[0]) results[0] = integrate(rays[0], starts[0], cuts[0]);
}
