#pragma once

#include <stdexcept>

namespace fenestra {

/// A scene that this machine cannot draw; what() says why and what would help.
class RenderError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fenestra
