#include "io/archive/WebArchive.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <memory>
#include <random>
#include <system_error>

#include "io/archive/Association.h"
#include "io/archive/Descent.h"
#include "io/archive/FrameAhead.h"
#include "io/archive/Http.h"
#include "io/archive/Intake.h"
#include "io/archive/Keys.h"
#include "io/archive/Multipart.h"
#include "io/archive/WebAnswers.h"
#include "io/archive/Wildcards.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::archive {
namespace {

namespace fs = std::filesystem;

constexpr const char* jsonType = "application/dicom+json";

std::vector<Attributes> attributesAt(Http& http, const WebServer& server, const std::string& path) {
  const Http::Answer answer = http.get(path, jsonType);
  if (answer.status / 100 != 2) refuseStatus(server, answer.status);
  std::optional<std::vector<Attributes>> found = attributesInJson(answer.body);
  if (!found) refuse(server, "the answer is not of DICOMweb", "check that the address is the root of DICOMweb");
  return std::move(*found);
}

/// QIDO-RS, page by page.
class WebSearch {
 public:
  WebSearch(const WebServer& server, Http& http) : server_(server), http_(http) {}

  Answers run(const Query& query) {
    answers_ = {};
    answers_.records = descend(query, [this](Level level, const Attributes& keys) { return ask(level, keys); });
    return std::move(answers_);
  }

 private:
  /// Where a level's records are. Patients have no level of their own: those of their studies are told apart by ID.
  std::string pathOf(Level level, Attributes& keys) const {
    const auto take = [&](const char* keyword) {
      const std::string uid = valueOf(keys, keyword);
      keys.erase(keyword);
      return http_.escaped(uid);
    };
    std::string path = "/studies";
    if (level >= Level::Series) path += "/" + take("StudyInstanceUID") + "/series";
    if (level >= Level::Image) path += "/" + take("SeriesInstanceUID") + "/instances";
    return path;
  }

  /// A value with its wildcards as they are, which RFC 3986 3.4 allows: some servers see none in their escaped form.
  std::string withWildcards(const std::string& value) const {
    std::string escaped = http_.escaped(value);
    for (const auto& [code, wildcard] : {std::pair{"%2A", "*"}, {"%3F", "?"}})
      for (std::size_t at = 0; (at = escaped.find(code, at)) != std::string::npos;) escaped.replace(at, 3, wildcard);
    return escaped;
  }

  /// Wildcards in place of what has to be escaped, which some servers do not undo.
  static std::string withoutEscapes(const std::string& value) {
    std::string relaxed;
    for (const char c : value) {
      const bool isPlain =
          std::isalnum(static_cast<unsigned char>(c)) || std::string_view("-._~*?").find(c) != std::string_view::npos;
      if (static_cast<unsigned char>(c) < 0x80)
        relaxed += isPlain ? c : '?';
      else if (!relaxed.ends_with('*'))
        relaxed += '*';
    }
    return relaxed;
  }

  std::vector<Attributes> ask(Level level, const Attributes& keys) {
    std::vector<Attributes> found = askAsItIs(level, keys);
    Attributes relaxed = keys, changed;
    for (auto& [keyword, value] : relaxed)
      if (withWildcards(value) != value) {
        changed[keyword] = value;
        value = withoutEscapes(value);
      }
    if (!found.empty() || changed.empty()) return found;
    found = askAsItIs(level, relaxed);
    std::erase_if(found, [&](const Attributes& record) {
      return std::any_of(changed.begin(), changed.end(),
                         [&](const auto& key) { return !matches(key.second, valueOf(record, key.first)); });
    });
    return found;
  }

  std::vector<Attributes> askAsItIs(Level level, Attributes keys) {
    std::string path = pathOf(level, keys) + "?";
    for (const auto& [keyword, value] : keys) path += keyword + "=" + withWildcards(value) + "&";
    for (const std::string& keyword : wantedAt(level))
      if (!keys.contains(keyword)) path += "includefield=" + keyword + "&";
    constexpr std::size_t page = 1000;
    std::vector<Attributes> found;
    for (;;) {
      std::vector<Attributes> next = attributesAt(
          http_, server_, path + "limit=" + std::to_string(page) + "&offset=" + std::to_string(found.size()));
      if (!found.empty() && !next.empty() && next.front() == found.front()) break;  // the server knows no pages
      const std::size_t count = next.size();
      std::move(next.begin(), next.end(), std::back_inserter(found));
      if (found.size() > server_.limits.answers) {
        found.resize(server_.limits.answers);
        answers_.complete = false;
      }
      if (count < page || !answers_.complete) break;
    }
    if (level == Level::Patient) keepPatients(found);
    return found;
  }

  static void keepPatients(std::vector<Attributes>& studies) {
    std::set<std::string> seen;
    std::erase_if(studies, [&](const Attributes& study) { return !seen.insert(valueOf(study, "PatientID")).second; });
    for (Attributes& study : studies)
      std::erase_if(study, [](const auto& each) { return levelOf(each.first, Level::Image) != Level::Patient; });
  }

  const WebServer& server_;
  Http& http_;
  Answers answers_;
};

/// WADO-RS: objects as parts of one message, each into a file of its own.
class WebTransfer {
 public:
  WebTransfer(const WebServer& server, const Cache& cache, Http& http, Task& task, const Arrival& arrived)
      : server_(server),
        cache_(cache),
        http_(http),
        task_(task),
        arrived_(arrived),
        choosesOrder_(static_cast<bool>(arrived)),
        intake_(cache, server.limits, task.activity(), arrived) {}

  /// Retrieves one object of a series that has `total`, before the others are known.
  void begin(const Wanted& one, std::size_t total) {
    const SeriesLock lock = lockOf(one);
    const Wanted missing = missingOf(one, cache_);
    if (missing.objects.empty()) return;
    total_ = total;
    intake_.expect(one, missing, total);
    readEach(one, missing, total);
    begun_ = {one.series, intake_.received()};
  }

  Retrieved run(const std::vector<Wanted>& all) {
    total_ = 0;
    for (const Wanted& each : all) total_ += each.objects.size();
    makeRoom(all, cache_, server_.limits);
    for (const Wanted& each : all) retrieve(each);
    retrieved_.refusals.objects = intake_.refused();
    return std::move(retrieved_);
  }

 private:
  SeriesLock lockOf(const Wanted& wanted) {
    return cache_.lock(wanted.study, wanted.series, [this] {
      task_.activity().note();  // a server that is not asked is not silent
      task_.checkCancelled();
    });
  }

  void retrieve(const Wanted& wanted) {
    const SeriesLock lock = lockOf(wanted);
    const Wanted missing = missingOf(wanted, cache_);
    const std::size_t count = missing.objects.size();
    before_ += wanted.objects.size() - count;
    if (count > 0) {
      intake_.expect(wanted, missing);
      if (count == wanted.objects.size() && !choosesOrder_)
        read(pathOf(wanted), count);
      else
        readEach(wanted, missing, wanted.objects.size());
      before_ += intake_.received();
      if (intake_.received() < count)
        refuse(server_,
               std::to_string(count - intake_.received()) + " of " + std::to_string(count) +
                   " objects of a series did not come",
               "try again: only these are asked for then");
    }
    cache_.complete(wanted.study, wanted.series);
    retrieved_.series.push_back({wanted.study, wanted.series, cache_.folderOf(wanted.study, wanted.series),
                                 wanted.objects.size(), count + (begun_.series == wanted.series ? begun_.count : 0)});
  }

  std::string pathOf(const Wanted& wanted) const {
    return "/studies/" + http_.escaped(wanted.study) + "/series/" + http_.escaped(wanted.series);
  }

  /// `total`: objects of the series.
  void readEach(const Wanted& wanted, const Wanted& missing, std::size_t total) {
    for (const std::string& object : middleFirst(wanted)) {
      if (!missing.objects.contains(object)) continue;
      lookAhead(wanted, object, total);
      read(pathOf(wanted) + "/instances/" + http_.escaped(object), 1);
      ahead_.reset();
    }
  }

  /// Tells of a frame of an object that takes its time, where nothing of its series is here yet.
  void lookAhead(const Wanted& wanted, const std::string& object, std::size_t total) {
    const auto at = wanted.frames.find(object);
    if (!arrived_ || at == wanted.frames.end() || !cache_.held(wanted.study, wanted.series).empty()) return;
    const Frames& frames = at->second;
    const int middle = frames.count / 2 + 1;
    const auto number = wanted.numbers.find(object);
    const fs::path file = intake_.newFile();
    ahead_.emplace(
        server_, FramePlace{wanted.study, wanted.series, object, middle}, frames.bytes, file,
        [this, arrival = ArrivedObject{wanted.series, file, number == wanted.numbers.end() ? 0 : number->second, total,
                                       middle, frames.count}] { arrived_(arrival); });
  }

  void read(const std::string& path, std::size_t objects) {
    std::optional<Multipart> parts;
    const auto sinkFor = [&](const Http::Answer& answer) -> Http::Sink {
      const std::optional<std::string> boundary = boundaryIn(answer.type);
      if (!boundary) return [](std::string_view) { return false; };
      parts.emplace(*boundary, handler());
      return [&](std::string_view bytes) { return parts->push(bytes); };
    };
    const std::uint64_t most = server_.limits.objectBytes * objects;
    std::error_code ignored;
    try {
      const Http::Answer answer =
          http_.get(path, R"(multipart/related; type="application/dicom"; transfer-syntax=*)", sinkFor, most);
      if (answer.status / 100 != 2) refuseStatus(server_, answer.status);
    } catch (...) {
      stream_.close();
      fs::remove(file_, ignored);
      throw;
    }
    stream_.close();
    if (parts && parts->isComplete()) return;
    fs::remove(file_, ignored);
    refuse(server_, "the connection broke while retrieving a series", "try again; what came is kept");
  }

  Multipart::Handler handler() {
    return {[this] {
              file_ = intake_.newFile();
              stream_.open(file_, std::ios::binary | std::ios::trunc);
              bytes_ = 0;
            },
            [this](std::string_view bytes) {
              bytes_ += bytes.size();
              if (ahead_) ahead_->count(bytes.size());
              if (bytes_ > server_.limits.objectBytes)
                refuse(server_, "the server sends more than an object may hold", "it may be no archive");
              stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
            },
            [this] {
              stream_.close();
              if (stream_.fail()) throw Error(cache_.root(), "cannot be written to", "make room, and try again");
              ahead_.reset();  // before the object is told, so that no frame is told after it
              intake_.take(file_);
              const double done = static_cast<double>(before_ + intake_.received()) / static_cast<double>(total_);
              task_.setFraction(std::min(done, 1.0));
            }};
  }

  const WebServer& server_;
  const Cache& cache_;
  Http& http_;
  Task& task_;
  const Arrival& arrived_;
  const bool choosesOrder_;  ///< somebody is told of each object, so the middle of each gap is asked for next
  Intake intake_;
  fs::path file_;
  std::ofstream stream_;
  std::uint64_t bytes_ = 0;  ///< of the file
  std::size_t total_ = 0, before_ = 0;
  struct {
    std::string series;
    std::size_t count = 0;
  } begun_;  ///< what begin() brought
  Retrieved retrieved_;
  std::optional<FrameAhead> ahead_;
};

/// The middle object, by its number, of the series that a retrieval is about, or of its study's largest, and how many
/// that series has; none where the server numbers them otherwise. Servers find one object long before they have listed
/// a series: Orthanc reads each file for the list.
std::optional<std::pair<Wanted, std::size_t>> middleOf(WebSearch& search, const Retrieval& retrieval,
                                                       const Limits& limits) {
  Query query{Level::Series, {{"StudyInstanceUID", retrieval.study}}};
  if (!retrieval.series.empty()) query.keys["SeriesInstanceUID"] = retrieval.series;
  std::string series;
  std::size_t most = 1;  // one alone is listed as soon
  for (const Attributes& each : search.run(query).records) {
    const std::string text = valueOf(each, "NumberOfSeriesRelatedInstances");
    std::size_t count = 0;
    std::from_chars(text.data(), text.data() + text.size(), count);
    if (count <= most || count > limits.answers) continue;
    most = count;
    series = valueOf(each, "SeriesInstanceUID");
  }
  if (series.empty()) return std::nullopt;
  const int middle = static_cast<int>(most / 2) + 1;
  query = {Level::Image,
           {{"StudyInstanceUID", retrieval.study},
            {"SeriesInstanceUID", series},
            {"InstanceNumber", std::to_string(middle)}}};
  for (Wanted& found : wantedIn(search.run(query).records, retrieval.study)) {
    // A server may match by no number, and several objects may have the same one.
    std::erase_if(found.objects, [&](const auto& object) {
      const auto number = found.numbers.find(object.first);
      return number == found.numbers.end() || number->second != middle;
    });
    if (found.series != series || found.objects.empty()) continue;
    found.objects.erase(std::next(found.objects.begin()), found.objects.end());
    return std::pair(std::move(found), most);
  }
  return std::nullopt;
}

/// The boundary between the parts of a message. It is random, so that no file can hold it on purpose and end its part.
std::string newBoundary() {
  std::random_device random;
  std::string boundary = "fenestra";
  for (int i = 0; i < 4; ++i) boundary += "-" + std::to_string(random());
  return boundary;
}

/// STOW-RS with one object, whose file is read while it is sent.
Sent store(const WebServer& server, Http& http, const fs::path& file) {
  const std::string boundary = newBoundary();
  const std::string head = "--" + boundary + "\r\nContent-Type: application/dicom\r\n\r\n",
                    tail = "\r\n--" + boundary + "--\r\n";
  std::ifstream stream(file, std::ios::binary);
  std::error_code failure;
  const std::uintmax_t bytes = fs::file_size(file, failure);
  if (!stream || failure) throw Error(file, "cannot be read", "check its permissions");
  std::string rest = head;
  bool isTail = false;
  const Http::Source source = [&](char* to, std::size_t size) {
    if (rest.empty() && !isTail) {
      stream.read(to, static_cast<std::streamsize>(size));
      if (stream.gcount() > 0) return static_cast<std::size_t>(stream.gcount());
      isTail = true;
      rest = tail;
    }
    const std::size_t count = std::min(size, rest.size());
    std::copy_n(rest.begin(), count, to);
    rest.erase(0, count);
    return count;
  };
  const Http::Answer answer =
      http.post("/studies", "multipart/related; type=\"application/dicom\"; boundary=" + boundary, source,
                head.size() + bytes + tail.size());
  Sent sent;
  sent.file = file;
  sent.status = static_cast<unsigned>(answer.status);
  if (answer.status == 401 || answer.status == 403 || answer.status == 404) refuseStatus(server, answer.status);
  const std::optional<StoreAnswer> said = storeAnswerIn(answer.body);
  sent.accepted = said ? said->accepted : answer.status == 200;
  if (said && said->accepted && said->reason != 0) sent.text = "the server keeps it with a change";
  if (!sent.accepted)
    sent.text = said && said->reason != 0 ? meaningOf(said->reason) : "HTTP " + std::to_string(answer.status);
  return sent;
}

}  // namespace

std::chrono::milliseconds echo(const WebServer& server, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Task task(server.limits, progress, "asking the server whether it answers");
  Http http(server, task);
  attributesAt(http, server, "/studies?limit=1");
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
}

Answers find(const WebServer& server, const Query& query, const Progress& progress) {
  prepareDcmtk();
  Task task(server.limits, progress, "searching the archive");
  Http http(server, task);
  return WebSearch(server, http).run(query);
}

Retrieved retrieve(const WebServer& server, const Retrieval& retrieval, const Cache& cache, const Progress& progress) {
  prepareDcmtk();
  Task task(server.limits, progress, "retrieving");
  Http http(server, task);
  WebSearch search(server, http);
  WebTransfer transfer(server, cache, http, task, retrieval.arrived);
  if (retrieval.arrived)
    if (const auto middle = middleOf(search, retrieval, server.limits)) transfer.begin(middle->first, middle->second);
  Query query{Level::Image, {{"StudyInstanceUID", retrieval.study}}};
  if (!retrieval.series.empty()) query.keys["SeriesInstanceUID"] = retrieval.series;
  const Answers answers = search.run(query);
  const std::vector<Wanted> all = wantedIn(answers.records, retrieval.study);
  if (all.empty()) refuse(server, "the server holds no such study or series", "search for it first, for its UID");
  if (!answers.complete)
    refuse(server, "the study has more than " + std::to_string(server.limits.answers) + " objects",
           "retrieve its series one by one");
  return transfer.run(all);
}

std::vector<Sent> send(const WebServer& server, const std::vector<fs::path>& files, const Progress& progress) {
  Task task(server.limits, progress, "sending to the archive");
  Http http(server, task);
  std::vector<Sent> sent;
  for (const fs::path& file : files) {
    task.setFraction(static_cast<double>(sent.size()) / static_cast<double>(files.size()));
    sent.push_back(store(server, http, file));
    sent.back().object = objectOf(file);
  }
  return sent;
}

std::vector<Attributes> metadata(const WebServer& server, const std::string& study, const std::string& series,
                                 const Progress& progress) {
  prepareDcmtk();
  Task task(server.limits, progress, "reading what the archive holds");
  Http http(server, task);
  return attributesAt(http, server,
                      "/studies/" + http.escaped(study) + "/series/" + http.escaped(series) + "/metadata");
}

}  // namespace fenestra::io::archive
