// Gated normals as textures hold them: zero at 511/1023.

vec3 gatedNormal(vec3 texel) { return texel * (1023.0 / 511.0) - 1.0; }
