#include "app/cli/ReadBesideContext.h"

#include <exception>
#include <future>

#include "app/cli/Report.h"

namespace fenestra::cli {

io::Study readBesideContext(const io::StudyRequest& request, std::optional<egl::EglContext>& context) {
  auto reading = std::async(std::launch::async, [&] { return io::readStudy(request, progressOnTerminal()); });
  std::exception_ptr failure;
  try {
    context.emplace();
  } catch (...) {
    failure = std::current_exception();
  }
  io::Study study = reading.get();
  if (failure) std::rethrow_exception(failure);
  return study;
}

}  // namespace fenestra::cli
