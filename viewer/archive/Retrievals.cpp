#include "viewer/archive/Retrievals.h"

#include <algorithm>

#include "io/archive/Cache.h"
#include "io/base/Error.h"
#include "viewer/archive/Conversation.h"

namespace fenestra::viewer {
namespace {

bool hasWorker(const Retrievals::Item& item) {
  return item.state == Retrievals::State::Running || item.state == Retrievals::State::Stopping;
}

/// Both would write the same objects.
bool overlap(const RetrievalOrder& a, const RetrievalOrder& b) {
  return a.study == b.study && (a.series == b.series || a.series.empty() || b.series.empty());
}

/// The folder to open: that of the series, or of the study with all of its series.
std::filesystem::path folderToOpen(const io::archive::Retrieved& got, const RetrievalOrder& order) {
  if (got.series.empty()) return {};
  const std::filesystem::path& folder = got.series.front().folder;
  return order.series.empty() ? folder.parent_path() : folder;
}

}  // namespace

Retrievals::Retrievals(Archives& archives, QObject* parent) : QObject(parent), archives_(archives) {}

Retrievals::~Retrievals() {
  // All at once, rather than one after the other while each is destroyed.
  for (const auto& each : items_)
    if (each->job) {
      each->job->disconnect(this);
      each->job->cancel();
    }
}

Retrievals::Item* Retrievals::item(int id) {
  const auto at = std::find_if(items_.begin(), items_.end(), [id](const auto& each) { return each->id == id; });
  return at == items_.end() ? nullptr : at->get();
}

const Retrievals::Item* Retrievals::find(int id) const { return const_cast<Retrievals*>(this)->item(id); }

bool Retrievals::isBusy() const {
  return std::any_of(items_.begin(), items_.end(), [](const auto& each) { return hasWorker(*each); });
}

int Retrievals::add(const RetrievalOrder& order) {
  const ServerEntry* server = archives_.find(order.server);
  if (!server || !archives_.reach(*server)) return 0;
  if (order.opens)
    for (const auto& each : items_) each->order.opens = false;
  const auto same = std::find_if(items_.begin(), items_.end(), [&](const auto& each) {
    return !each->removes && each->order.server == order.server && each->order.study == order.study &&
           each->order.series == order.series;
  });
  int id = 0;
  if (same != items_.end()) {
    Item& there = **same;
    id = there.id;
    there.order.opens = there.order.opens || order.opens;
    // What is whole is asked for again: the server may have got more, and the cache may have lost some.
    if (!hasWorker(there)) set(there, State::Waiting);
  } else {
    id = ++lastId_;
    items_.push_back(std::make_unique<Item>());
    items_.back()->id = id;
    items_.back()->order = order;
    Q_EMIT listChanged();
  }
  startWaiting();
  return id;
}

bool Retrievals::mayStart(const Item& wanted) const {
  const ServerEntry* server = archives_.find(wanted.order.server);
  int running = 0;
  for (const auto& each : items_) {
    if (!hasWorker(*each)) continue;
    const ServerEntry* other = archives_.find(each->order.server);
    // The port that objects come to is one's own.
    const bool samePort = server && other && server->moves && other->moves && server->ownPort == other->ownPort;
    if (++running >= mostAtOnce || samePort || overlap(each->order, wanted.order)) return false;
  }
  return true;
}

void Retrievals::startWaiting() {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    Item& each = *items_[i];
    if (each.state != State::Waiting || !mayStart(each)) continue;
    const ServerEntry* entry = archives_.find(each.order.server);
    const std::optional<AnyServer> server = entry ? archives_.reach(*entry, Archives::Asking::Never) : std::nullopt;
    if (server) {
      start(each, *server);
      continue;
    }
    each.message = entry ? tr("The server needs a login.") : tr("Its server is no longer in the list.");
    set(each, State::Failed);
  }
}

void Retrievals::start(Item& item, const AnyServer& server) {
  const int id = item.id;
  item.job = std::make_unique<LoadJob>(archiveThreads());
  item.message.clear();
  connect(item.job.get(), &LoadJob::progressed, this, [this, id](double fraction, const QString& doing) {
    Item* running = this->item(id);
    running->fraction = fraction;
    running->message = doing;
    Q_EMIT changed(id);
  });
  connect(item.job.get(), &LoadJob::failed, this, [this, id](const QString& message) {
    this->item(id)->state = State::Failed;
    this->item(id)->message = message;
  });
  // From the event loop: the job must not be destroyed in its own signal.
  connect(
      item.job.get(), &LoadJob::ended, this, [this, id] { ended(id); }, Qt::QueuedConnection);
  set(item, State::Running);
  const bool moves = archives_.find(item.order.server)->moves;
  io::archive::Retrieval retrieval{item.order.study, item.order.series,
                                   moves ? io::archive::Way::Move : io::archive::Way::Get};
  if (item.order.opens)
    retrieval.arrived = [this, id](const io::archive::ArrivedObject& object) {
      QMetaObject::invokeMethod(this, [this, id, object] { Q_EMIT arrived(id, object); });
    };
  item.job->start(
      [this, id, retrieval, order = item.order, root = archives_.cacheFolder(),
       talk = Conversation(archives_, item.order.server, server)](const io::Progress& progress) -> LoadJob::Show {
        if (root.empty())
          throw io::Error("archive", "there is neither a home nor a cache folder", "choose one in the settings");
        const io::archive::Cache cache(root);
        const io::archive::Retrieved got =
            talk.run([&](const auto& each) { return io::archive::retrieve(each, retrieval, cache, progress); });
        return [this, id, folder = folderToOpen(got, order)] {
          Item& whole = *this->item(id);
          whole.folder = folder;
          whole.fraction = 1.0;
          whole.message.clear();
          whole.state = State::Done;
        };
      });
}

void Retrievals::ended(int id) {
  Item* item = this->item(id);
  if (!item || item->job->isRunning()) return;
  item->job.reset();
  if (item->removes) {
    std::erase_if(items_, [id](const auto& each) { return each->id == id; });
    Q_EMIT listChanged();
  } else {
    if (hasWorker(*item)) item->state = State::Paused;
    Q_EMIT changed(id);
    if (item->state == State::Done && std::exchange(item->order.opens, false)) Q_EMIT ready(item->folder);
  }
  startWaiting();
}

void Retrievals::set(Item& item, State state) {
  item.state = state;
  Q_EMIT changed(item.id);
}

void Retrievals::pause(int id) {
  Item* item = this->item(id);
  if (!item) return;
  if (item->state == State::Waiting) return set(*item, State::Paused);
  if (item->state != State::Running) return;
  item->job->cancel();
  set(*item, State::Stopping);
}

void Retrievals::resume(int id) {
  Item* item = this->item(id);
  if (!item || (item->state != State::Paused && item->state != State::Failed)) return;
  const ServerEntry* server = archives_.find(item->order.server);
  if (server && !archives_.reach(*server)) return;
  item = this->item(id);  // while the login was asked for, it may have left the list
  if (!item || hasWorker(*item)) return;
  set(*item, State::Waiting);
  startWaiting();
}

void Retrievals::remove(int id) {
  Item* item = this->item(id);
  if (!item) return;
  if (hasWorker(*item)) {
    item->removes = true;
    item->order.opens = false;
    item->job->cancel();
    set(*item, State::Stopping);
  } else {
    std::erase_if(items_, [id](const auto& each) { return each->id == id; });
  }
  Q_EMIT listChanged();
}

void Retrievals::removeEnded() {
  std::erase_if(items_, [](const auto& each) { return each->state == State::Done || each->state == State::Failed; });
  Q_EMIT listChanged();
}

}  // namespace fenestra::viewer
