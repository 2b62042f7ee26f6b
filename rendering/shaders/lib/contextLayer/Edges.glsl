// The edges of what was removed show as lines: ContextLayer.comp's curvature and silhouette (the interface is described in
// None.glsl). With APART, another camera cuts the opening: only what lies before rayStart was removed.
#include <edits>
#include <faint>
#include <schedule>
#include "lib/ContextLines.glsl"
#include "lib/None.glsl"
#include "lib/TransferTables.glsl"
#include "lib/Uniforms.glsl"

uniform sampler2D rayStart;

vec4 withContextLayer(vec4 result, ivec2 pixel, vec2 hit, float share) {
  vec4 context = texelOf(contextLayer, pixel);
  bool isRemoved = !isNone(hit.y);
  if (APART == 1) isRemoved = isRemoved && texelFetch(rayStart, pixel, 0).r > hit.x;
  if (isRemoved && !isNone(context.x)) {
    float bend = bendOf(context.xy);
    float rim = texelOf(silhouette, pixel).r;
    // Edges come out as lines: both terms rise steeply.
    float opacity = contextLook.curvatureWeight * smoothstep(0.10, 0.40, bend);
    opacity = contextLook.strength * clamp(opacity + contextLook.silhouetteWeight * smoothstep(0.30, 0.85, rim), 0.0, 1.0);
    opacity *= smoothstep(contextLook.leastLine, contextLook.leastLine + LINE_FADE, lineStrength(bend, rim));
    if (EDITED) opacity = min(opacity * editAt(pixel).y, 1.0);
    if (HAS_LENS) opacity *= 1.0 - share;
    // A surface lies where opacity begins: what is opaque next to its value gives the colour.
    float entry = floor(clamp(entryOf(context.w) + 0.5, 0.0, LAST_ENTRY));
    vec4 own = materialAt(entry - 1.0) + materialAt(entry) + materialAt(entry + 1.0);
    vec3 colour = contextLook.colour;
    if (own.a > 0.0) {
      vec3 hue = own.rgb / own.a;
      // Luminance after ITU-R BT.709.
      hue += (1.0 - contextLook.saturation) * (dot(hue, vec3(0.2126, 0.7152, 0.0722)) - hue);
      colour = mix(contextLook.colour, hue, contextLook.valueWeight);
    }
    colour *= mix(1.0, context.z, contextLook.illuminationWeight);
    result = vec4(colour, 1.0) * opacity + result * (1.0 - opacity);
  }
  return result;
}
