// What a straight path through a cell meets of what decides how much a context fades. Bernstein coefficients.
struct Slopes {
  vec3 along[4];  // gradients: world, 1 for the steepest
  vec4 outside;   // outsideAlong() of `<fading>`
};
