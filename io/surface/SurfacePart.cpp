#include "io/surface/SurfacePart.h"

extern "C" __attribute__((visibility("default"))) fenestra::io::SurfaceFunctions fenestraSurfaceFunctions();

fenestra::io::SurfaceFunctions fenestraSurfaceFunctions() {
  return {&fenestra::io::extractWithVtk, &fenestra::io::writeWithVtk};
}
