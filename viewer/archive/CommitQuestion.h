#pragma once
// Asks a server to confirm that it keeps what it was sent, from another thread.

#include <vector>

#include <QString>

#include "viewer/archive/Conversation.h"
#include "viewer/archive/SentAnswers.h"

namespace fenestra::viewer {

/// Fills `commitments`, or returns why there are none, as a sentence. Throws io::Cancelled.
QString askToCommit(const Conversation& talk, const std::vector<io::archive::Sent>& sent,
                    SentAnswers::Commitments& commitments, const io::Progress& progress);

}  // namespace fenestra::viewer
