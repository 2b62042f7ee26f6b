// All that the opening removes, of which a share stays. A part of the alternatives of `<faint>`.
uniform sampler2D faintLayer;

vec4 faintAt(ivec2 pixel, float share) { return texelFetch(faintLayer, pixel, 0) * share; }
