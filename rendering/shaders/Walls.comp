// Slices that stand in a picture as walls (rendering/scene/Walls.h has the formulas). Output: the picture with the walls, and the
// walls alone; both premultiplied RGBA without background.
#include <schedule>
#include <walls>
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D walled;
layout(rgba32f) uniform writeonly image2D wallLayer;
TEXELS_2D(rgba32f, picture);
TEXELS_2D(r32f, greys);  // of the slices, one below the other

const float ALONG_WALL = 1e-7;   // cosine below which a ray runs along a wall

struct LinePiece {
  vec4 ends;           // mm on the wall: from, to
  vec4 colourAndLine;  // the line's number in w
};
layout(std430, binding = 0) readonly buffer LineCells { uint firstPiece[]; };  // of each voxel of the slices, and the end
layout(std430, binding = 1) readonly buffer LinePieces { LinePiece pieces[]; };

// Width of a pixel in mm at the view depth of s.
float pixelWidth(ivec2 pixel, float s) {
  return 2.0 * (rays.halfSize.y + rays.spread.y * (depthAtPosition(pixel, s) / rays.depth)) / float(rays.pictureSize.y);
}

vec2 mmOf(vec4 metric, vec2 place) { return vec2(metric.x * place.x + metric.y * place.y, metric.z * place.y); }

float opacityAt(vec2 place, vec4 extent, vec4 metric, float pixelSide) {
  // mm between neighbouring lines of one u, and of one v.
  vec2 apart = vec2(metric.x * metric.z / length(metric.yz), metric.z);
  vec2 inwards = min(place + 0.5, extent.xy - 0.5 - place) * apart;
  return clamp(0.5 + min(inwards.x, inwards.y) / pixelSide, 0.0, 1.0);
}

float greyAt(vec2 place, vec4 extent) {
  vec2 last = extent.xy - 1.0, at = clamp(place, vec2(0.0), last);
  ivec2 low = ivec2(at), high = min(low + 1, ivec2(last)), row = ivec2(0, int(extent.z));
  vec2 w = at - vec2(low);
  float above = mix(texelOf(greys, low + row).r, texelOf(greys, ivec2(high.x, low.y) + row).r, w.x);
  float below = mix(texelOf(greys, ivec2(low.x, high.y) + row).r, texelOf(greys, high + row).r, w.x);
  return clamp(mix(above, below, w.y), 0.0, 1.0);
}

float distanceTo(vec4 ends, vec2 mm) {
  vec2 along = ends.zw - ends.xy, from = mm - ends.xy;
  float square = dot(along, along);
  float share = square > 0.0 ? clamp(dot(from, along) / square, 0.0, 1.0) : 0.0;
  return length(from - share * along);
}

// Share of a box as wide as `box` that a line as wide as `width` covers, at a distance of its middle.
float covered(float distance, float width, float box) {
  return clamp((min(distance + 0.5 * box, 0.5 * width) - max(distance - 0.5 * box, -0.5 * width)) / box, 0.0, 1.0);
}

vec3 withLines(vec3 colour, vec2 place, vec4 extent, vec4 metric, float pixelSide) {
  vec2 inside = clamp(place, vec2(-0.5), extent.xy - 0.5), mm = mmOf(metric, inside);
  ivec2 voxel = ivec2(clamp(floor(inside + 0.5), vec2(0.0), extent.xy - 1.0));
  uint cell = uint((int(extent.z) + voxel.y) * sizeOf(greys).x + voxel.x);
  float width = metric.w, box = min(pixelSide, width), line = -1.0, nearest = FAR;
  vec3 lineColour = vec3(0.0);
  uint end = firstPiece[cell + 1u];
  for (uint i = firstPiece[cell]; i < end; ++i) {
    LinePiece piece = pieces[i];
    if (piece.colourAndLine.w != line) {
      colour = mix(colour, lineColour, covered(nearest, width, box));
      line = piece.colourAndLine.w;
      lineColour = piece.colourAndLine.rgb;
      nearest = FAR;
    }
    nearest = min(nearest, distanceTo(piece.ends, mm));
  }
  return mix(colour, lineColour, covered(nearest, width, box));
}

void main() {
  ivec2 pixel = regionPixel();
  if (!hasRay(pixel)) return;
  Ray ray = wholePixelRay(pixel);
  vec2 span = spanOf(pixel);
  float first = span.x, nearest = span.y;
  float opacity = 0.0, pixelSide = 1.0;
  vec2 place = vec2(0.0);
  vec4 extent = vec4(1.0), metric = vec4(1.0);
  for (int i = 0; i < WALLS; ++i) {
    vec4 plane = walls.plane[i];
    float slope = dot(plane.xyz, ray.direction);
    bool along = abs(slope) < ALONG_WALL;
    float s = -(dot(plane.xyz, ray.base) + plane.w) / (along ? 1.0 : slope);
    vec3 position = cellPosition(ray, s);
    vec2 there = vec2(dot(walls.across[i].xyz, position) + walls.across[i].w, dot(walls.down[i].xyz, position) + walls.down[i].w);
    float side = pixelWidth(pixel, s), shown = opacityAt(there, walls.extent[i], walls.metric[i], side);
    if (!along && s >= first && s < nearest && shown > 0.0) {
      nearest = s;
      opacity = shown;
      pixelSide = side;
      place = there;
      extent = walls.extent[i];
      metric = walls.metric[i];
    }
  }
  vec4 wall = vec4(0.0), front = texelOf(picture, pixel);
  if (opacity > 0.0)
    wall = vec4(withLines(vec3(greyAt(place, extent)), place, extent, metric, pixelSide), 1.0) * opacity;
  imageStore(wallLayer, pixel, wall);
  imageStore(walled, pixel, withWall(front, wall));
}
