// What lies behind a picture.

uniform vec3 background, backgroundRise;  // at the bottom; from there to the top

// A premultiplied colour over it, opaque. `below`: from the picture's top, 0, to its bottom, 1.
vec4 overBackground(vec4 front, float below) {
  return vec4(front.rgb + (1.0 - front.a) * (background + (1.0 - below) * backgroundRise), 1.0);
}
