// What a ray shows of the volume, or of the grey face by which it enters what is kept of it.
#include <clip>
#include <integral>
#include <opening>

bool showsVolume(Cut cut, Ray ray) {
  return GREY_FACES ? startsHere(cut, ray) && !startsGrey(cut, ray) : startsHere(cut, ray);
}

vec4 seenOn(Walk walk) {
  if (!GREY_FACES) return colourOf(walk);
  bool grey = startsHere(walk.cut, walk.ray) && startsGrey(walk.cut, walk.ray);
  return grey ? greyOf(walk.ray) : colourOf(walk);
}
