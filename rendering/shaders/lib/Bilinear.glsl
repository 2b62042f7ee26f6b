// Bilinear between four corners, x fastest.
float bilinear(vec4 corners, vec2 at) {
  vec2 rows = mix(corners.xz, corners.yw, at.x);
  return mix(rows.x, rows.y, at.y);
}
