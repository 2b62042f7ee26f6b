// The picture over its background, pixel by pixel or reduced.
#include "lib/Background.glsl"

in vec2 at;
out vec4 colour;
uniform sampler2D picture;

void main() { colour = overBackground(texture(picture, at), at.y); }
