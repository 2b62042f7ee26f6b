// How work is laid out on Mesa's software rasteriser, llvmpipe, where neighbouring invocations are lanes of one vector
// unit. Nothing in a schedule changes the picture; lib/schedule/Plain.glsl is the other one.
//
// What was found in the code that llvmpipe (Mesa 22.3) compiles:
// - A loop ends for all lanes when it ends for the last one, and the rest of its body runs once more after a `break`.
//   Loops therefore test their condition at their end, and a dear step waits in a loop of its own until every lane
//   needs it.
// - A value that a lane computes in such a loop, and that depends on memory, must go through an `if` in the loop's body
//   or be carried from one turn to the next; otherwise the lanes that stay longer overwrite it.
// - texelFetch computes a level of detail lane by lane, some 200 instructions; imageLoad does not.
// - A uniform that is named in a loop is loaded again in each turn. A copy at the start of main() is not, where it is a
//   copy of a block's member.

const bool IN_STEP = true;

#define UNIFORM_BLOCK(Block, stored, Struct, name)             \
  layout(std140) uniform Block { Struct name; } stored;        \
  Struct name = stored.name

#define TEXELS_2D(format, name) layout(format) uniform readonly image2D name
#define TEXELS_3D(format, name) layout(format) uniform readonly image3D name
#define UNSIGNED_TEXELS_2D(format, name) layout(format) uniform readonly uimage2D name
#define UNSIGNED_TEXELS_3D(format, name) layout(format) uniform readonly uimage3D name
#define texelOf(name, at) imageLoad(name, at)
#define sizeOf(name) imageSize(name)
