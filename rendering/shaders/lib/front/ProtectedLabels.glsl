// Labels that are never cut away lie in front of the focus layer (the interface is described in None.glsl).

// A sampler under either schedule: with it, the images would be more than the eight that OpenGL guarantees.
uniform sampler2D protectedLayer;

vec4 withFront(vec4 result, ivec2 pixel) {
  vec4 front = texelFetch(protectedLayer, pixel, 0);
  return front + (1.0 - front.a) * result;
}
