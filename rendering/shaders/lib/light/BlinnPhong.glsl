// Blinn-Phong with one distant light, both sides of a surface lit (rendering/scene/Lighting.h).
#include <schedule>
#include "lib/Uniforms.glsl"

// Shaded colour = colour · x + y.
vec2 lightOf(vec3 normal, vec3 rayDirection) {
  float diffuse = abs(dot(normal, lighting.direction));
  float specular = pow(abs(dot(normal, normalize(lighting.direction - rayDirection))), lighting.shininess);
  return vec2(lighting.ambient + lighting.diffuse * diffuse, lighting.specular * specular);
}
