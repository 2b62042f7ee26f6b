// What lies behind a picture.

uniform vec3 background;

// A premultiplied colour over it, opaque.
vec4 overBackground(vec4 front) { return vec4(front.rgb + (1.0 - front.a) * background, 1.0); }
