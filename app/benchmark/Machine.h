#pragma once
// The machine that a benchmark runs on.

#include <string>

namespace fenestra::bench {

struct Machine {
  std::string processors;   ///< "2 × AMD EPYC", as the kernel names them; "2 × processor" where it does not
  double memory = 0.0;      ///< GiB of main memory; 0 where the system does not say
  std::string renderer;     ///< GL_RENDERER and GL_VERSION
  bool isSoftware = false;  ///< the processors draw
  double load = 0.0;        ///< how many processors other programs kept busy before, a mean over a minute
};

/// "2 × NAME".
std::string processors();
/// Needs a current context.
Machine thisMachine();

}  // namespace fenestra::bench
