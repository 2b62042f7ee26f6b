// A pass may run over parts of the picture: gl::ShaderProgram::dispatch says which by their first pixel.

uniform ivec2 pixelOrigin;

ivec2 regionPixel() { return pixelOrigin + ivec2(gl_GlobalInvocationID.xy); }
