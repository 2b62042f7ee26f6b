// How work is laid out on Mesa's software rasteriser, llvmpipe, where neighbouring invocations are lanes of one vector
// unit. Nothing in a schedule changes the picture; lib/schedule/Plain.glsl is the other one.
//
// What was found in the code that llvmpipe (Mesa 22.3) compiles:
// - A loop ends when its last lane leaves it, and a lane's `break` skips no instructions. Loops therefore test their condition
//   at their end, and an expensive step stands outside an inner loop that ends when every lane needs the step.
// - A value that is loaded from memory in a loop and used behind it must be assigned inside an `if` in the loop's body.
//   Otherwise a lane that leaves the loop early loses the value: the lanes that stay overwrite it.
// - texelFetch computes a level of detail lane by lane, some 200 instructions; imageLoad does not.
// - A uniform that is read in a loop is loaded again in each iteration. A copy of a block's member, made at the start of
//   main(), is not.

const bool IN_STEP = true;

#define STORED_UNIFORMS stored
#define UNIFORM(Struct, name) Struct name = stored.name;

#define TEXELS_2D(format, name) layout(format) uniform readonly image2D name
#define TEXELS_3D(format, name) layout(format) uniform readonly image3D name
#define UNSIGNED_TEXELS_2D(format, name) layout(format) uniform readonly uimage2D name
#define UNSIGNED_TEXELS_3D(format, name) layout(format) uniform readonly uimage3D name
#define texelOf(name, at) imageLoad(name, at)
#define sizeOf(name) imageSize(name)
