#include "viewer/archive/CommitQuestion.h"

#include <type_traits>

#include "viewer/model/WayOutText.h"

namespace fenestra::viewer {

QString askToCommit(const Conversation& talk, const std::vector<io::archive::Sent>& sent,
                    SentAnswers::Commitments& commitments, const io::Progress& progress) {
  try {
    talk.run([&](const auto& server) {
      if constexpr (std::is_same_v<std::decay_t<decltype(server)>, io::archive::Server>)
        commitments = io::archive::commit(server, sent, progress);
    });
  } catch (const io::Error& error) {
    return windowText(error);
  }
  return {};
}

}  // namespace fenestra::viewer
