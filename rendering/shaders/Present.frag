// The picture over its background, opaque.
in vec2 at;
out vec4 colour;
uniform sampler2D picture;
uniform vec3 background;
void main() {
  vec4 front = texture(picture, at);
  colour = vec4(front.rgb + (1.0 - front.a) * background, 1.0);
}
