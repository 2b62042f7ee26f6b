#include "io/archive/FrameAhead.h"

#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

namespace fenestra::io::archive {

FrameAhead::FrameAhead(const WebServer& server, FramePlace place, std::filesystem::path file,
                       std::function<void()> come)
    : file_(std::move(file)) {
  thread_ = std::thread([this, &server, place = std::move(place), come = std::move(come)] {
    try {
      if (fetchFrame(server, place, file_, [this](double, std::string_view) { return !stops_; })) come();
    } catch (const std::exception&) {
      // The object itself comes without, or tells why it does not.
    }
  });
}

FrameAhead::~FrameAhead() {
  stops_ = true;
  thread_.join();
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace fenestra::io::archive
