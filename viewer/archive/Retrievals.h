#pragma once
// Studies and series on their way from archives into the cache. Several come at once; each can be paused and goes on
// with what is missing, because the cache keeps what came.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include <QObject>

#include "io/archive/Retrieve.h"
#include "viewer/archive/Archives.h"
#include "viewer/jobs/LoadJob.h"

namespace fenestra::viewer {

/// What to retrieve, and what the list calls it.
struct RetrievalOrder {
  QString server;             ///< an entry's id
  std::string study, series;  ///< UIDs; an empty series: all of the study
  QString title;              ///< may name the patient: for the screen alone
  bool opens = false;         ///< once whole
};

class Retrievals : public QObject {
  Q_OBJECT
 public:
  /// Stopping: cancelled, but its worker has not ended yet.
  enum class State : std::uint8_t { Waiting, Running, Stopping, Paused, Failed, Done };
  struct Item {
    int id = 0;
    RetrievalOrder order;
    State state = State::Waiting;
    double fraction = 0.0;
    QString message;               ///< why it failed, or what is being done
    std::filesystem::path folder;  ///< in the cache, once it is whole
    bool removes = false;          ///< leaves the list when its worker has ended
    std::unique_ptr<LoadJob> job;
  };
  static constexpr int mostAtOnce = 3;

  /// `archives` outlives this.
  explicit Retrievals(Archives& archives, QObject* parent = nullptr);
  ~Retrievals() override;

  const std::vector<std::unique_ptr<Item>>& items() const { return items_; }
  const Item* find(int id) const;
  /// Whether objects may be coming in.
  bool isBusy() const;

  /// Starts it as soon as there is room. What is in the list already goes on there. Of several that are to be opened,
  /// the one asked for last is. Returns its id; 0 when the user gives no login.
  int add(const RetrievalOrder& order);
  void pause(int id);
  /// After a pause or a failure.
  void resume(int id);
  /// Takes it out of the list; what came stays in the cache.
  void remove(int id);
  /// Leaves those that are whole or failed.
  void removeEnded();

 Q_SIGNALS:
  /// Items came or went.
  void listChanged();
  void changed(int id);
  /// An object of one that is to be opened is here, while others are not.
  void arrived(int id, const io::archive::ArrivedObject& object);
  /// One that was to be opened is whole.
  void ready(const std::filesystem::path& folder);

 private:
  Item* item(int id);
  bool mayStart(const Item& wanted) const;
  void startWaiting();
  void start(Item& item, const AnyServer& server);
  void ended(int id);
  void set(Item& item, State state);

  Archives& archives_;
  std::vector<std::unique_ptr<Item>> items_;
  int lastId_ = 0;
};

}  // namespace fenestra::viewer
