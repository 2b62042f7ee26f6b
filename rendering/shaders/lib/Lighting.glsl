// Blinn-Phong with one distant light, both sides of a surface lit.

uniform vec3 lightDirection;   // world, towards the light
uniform vec4 lighting;         // ambient, diffuse, specular, shininess

// Shaded colour = colour · x + y.
vec2 lightOf(vec3 normal, vec3 rayDirection) {
  float diffuse = abs(dot(normal, lightDirection));
  float specular = pow(abs(dot(normal, normalize(lightDirection - rayDirection))), lighting.w);
  return vec2(lighting.x + lighting.y * diffuse, lighting.z * specular);
}
