// Blinn-Phong with one distant light, both sides of a surface lit (rendering/scene/Lighting.h).
#include <schedule>

struct LightSettings {
  vec3 direction;        // world, towards the light
  float ambient;
  float diffuse;
  float specular;
  float shininess;
  float meanIncidence;   // |n·l| of a surface of average orientation
  ivec3 gradientOrigin;  // index of the gradient texture's first voxel
  float certainLength;   // of a gated normal, from which on it is lit in full
  ivec3 lastNode;        // of ambient occlusion: index along each axis (lib/light/Occlusion.glsl)
  vec3 nodesPerVoxel;
};
UNIFORM_BLOCK(LightBlock, storedLight, LightSettings, lighting);

// Shaded colour = colour · x + y.
vec2 lightOf(vec3 normal, vec3 rayDirection) {
  float diffuse = abs(dot(normal, lighting.direction));
  float specular = pow(abs(dot(normal, normalize(lighting.direction - rayDirection))), lighting.shininess);
  return vec2(lighting.ambient + lighting.diffuse * diffuse, lighting.specular * specular);
}
