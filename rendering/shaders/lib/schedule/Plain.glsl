// How work is laid out on a graphics card: one ray an invocation, texels read by texelFetch, uniforms read where they
// are used. Nothing in a schedule changes the picture; lib/schedule/Llvmpipe.glsl is the other one.

// Whether rays that run side by side share their instructions, so that a loop costs each of them what it costs the
// slowest one.
const bool IN_STEP = false;

// The name of the uniform block, if it has one, and a copy of one of its structs, which only the other schedule makes.
#define STORED_UNIFORMS
#define UNIFORM(Struct, name)

// Textures of one level, read texel by texel. `format` is a name that only the other schedule needs.
#define TEXELS_2D(format, name) uniform sampler2D name
#define TEXELS_3D(format, name) uniform sampler3D name
#define UNSIGNED_TEXELS_2D(format, name) uniform usampler2D name
#define UNSIGNED_TEXELS_3D(format, name) uniform usampler3D name
#define texelOf(name, at) texelFetch(name, at, 0)
#define sizeOf(name) textureSize(name, 0)
