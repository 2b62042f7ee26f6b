// Writes archive.md: how fast a series comes from servers on the loopback interface, beside DCMTK's own programs and a
// plain copy, when its first slice is there, and how much memory that takes.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <thread>

#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "io/archive/WebArchive.h"
#include "tests/archive/Servers.h"
#include "tests/io/DicomWriter.h"

namespace fenestra {
namespace {

namespace fs = std::filesystem;
namespace archive = io::archive;
using Clock = std::chrono::steady_clock;

const std::string studyUid = "1.2", seriesUid = "1.2.3.77.1";  // the first is what the tests' writer gives
constexpr int slices = 500;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// 500 CT slices of 512×512 pixels of 16 bits, 250 MiB in all.
void makeSeries(const fs::path& folder) {
  fs::create_directories(folder);
  tests::DicomSpec spec;
  spec.columns = spec.rows = 512;
  spec.slope = "1";
  spec.intercept = "-1024";
  for (std::uint32_t i = 0; i < 512 * 512; ++i) spec.words.push_back(i * 2654435761u >> 20);
  for (int slice = 0; slice < slices; ++slice) {
    spec.instance = seriesUid + "." + std::to_string(slice + 1);
    spec.series = seriesUid;
    spec.position = {0.0, 0.0, 1.0 * slice};
    spec.instanceNumber = slice + 1;
    spec.patientId = "T-1";
    tests::writeDicom(folder / (std::to_string(slice) + ".dcm"), spec);
  }
}

/// What one way of retrieving took.
struct Trial {
  double seconds = 0.0, first = 0.0, mebibytes = 0.0;  ///< first: 0 where nothing tells
};

/// Runs it in a process of its own, whose peak of memory is told.
Trial apart(const std::function<double()>& act) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  const auto start = Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    const double first = act();
    const ssize_t written = write(ends[1], &first, sizeof first);
    _exit(written == sizeof first ? 0 : 1);
  }
  Trial trial;
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  trial.seconds = secondsSince(start);
  if (status != 0 || read(ends[0], &trial.first, sizeof trial.first) != sizeof trial.first) {
    std::cerr << "a way failed\n";
    std::exit(1);
  }
  close(ends[0]);
  close(ends[1]);
  trial.mebibytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return trial;
}

/// As apart(), of a program; its peak is that of the largest process.
Trial ofProgram(const std::string& command) {
  return apart([&] {
    if (std::system((command + " >/dev/null 2>&1").c_str()) != 0) _exit(1);
    return 0.0;
  });
}

struct Bench {
  fs::path folder;
  std::map<std::string, std::vector<Trial>> trials;
  std::vector<std::string> order;

  void take(const std::string& name, const std::function<Trial()>& trial) {
    fs::remove_all(folder / "got");
    fs::create_directories(folder / "got");
    if (!trials.contains(name)) order.push_back(name);
    trials[name].push_back(trial());
    std::fprintf(stderr, "%-40s %.3f s, first %.3f s, %.0f MiB\n", name.c_str(), trials[name].back().seconds,
                 trials[name].back().first, trials[name].back().mebibytes);
  }

  template <class Server>
  Trial ours(const Server& server, archive::Way way, bool tellsFirst) const {
    return apart([&] {
      const auto start = Clock::now();
      double first = 0.0;
      archive::Arrival arrived = [&](const archive::ArrivedObject&) {
        if (first == 0.0) first = secondsSince(start);
      };
      const archive::Cache cache(folder / "got");
      const archive::Retrieved got =
          archive::retrieve(server, {studyUid, seriesUid, way, tellsFirst ? arrived : archive::Arrival{}}, cache);
      if (got.series.at(0).received != slices) _exit(1);
      return first;
    });
  }

  void round(const std::string& name, const tests::RunningServer& running) {
    const archive::Server& server = running.server;
    const std::string keys = " -k QueryRetrieveLevel=SERIES -k StudyInstanceUID=" + studyUid +
                             " -k SeriesInstanceUID=" + seriesUid,
                      peer = " 127.0.0.1 " + std::to_string(server.port),
                      titles = " -aet FENESTRA -aec " + server.title + " -S", got = " -od " + (folder / "got").string();
    take(name + ": getscu, bit preserving", [&] { return ofProgram("getscu -B" + titles + keys + got + peer); });
    take(name + ": C-GET", [&] { return ours(server, archive::Way::Get, false); });
    take(name + ": C-GET, first slice told", [&] { return ours(server, archive::Way::Get, true); });
    take(name + ": movescu, bit preserving", [&] {
      return ofProgram("movescu -B -aem FENESTRA +P " + std::to_string(server.ownPort) + titles + keys + got + peer);
    });
    take(name + ": C-MOVE", [&] { return ours(server, archive::Way::Move, false); });
    take(name + ": C-MOVE, first slice told", [&] { return ours(server, archive::Way::Move, true); });
    if (running.web.empty()) return;
    archive::WebServer web = archive::parseWebServer(running.web).value();
    web.user = "reader";
    web.secret = archive::Secret("secret word");
    take(name + ": WADO-RS", [&] { return ours(web, archive::Way::Get, false); });
    take(name + ": WADO-RS, first slice told", [&] { return ours(web, archive::Way::Get, true); });
  }

  static double medianOf(const std::vector<Trial>& all, double Trial::*member) {
    std::vector<double> values;
    for (const Trial& each : all) values.push_back(each.*member);
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }

  void write() const {
    std::printf("| Way | s | MiB/s | first slice, s | peak memory, MiB |\n|---|---|---|---|---|\n");
    for (const std::string& name : order) {
      const std::vector<Trial>& all = trials.at(name);
      const double seconds = medianOf(all, &Trial::seconds), first = medianOf(all, &Trial::first);
      char told[32] = "";
      if (first > 0.0) std::snprintf(told, sizeof told, "%.2f", first);
      std::printf("| %s | %.2f | %.0f | %s | %.0f |\n", name.c_str(), seconds, 250.0 / seconds, told,
                  medianOf(all, &Trial::mebibytes));
    }
  }
};

int run(const fs::path& folder, int rounds) {
  makeSeries(folder / "made");
  const auto orthanc = tests::startOrthanc(folder / "orthanc"), dcmtk = tests::startDcmqrscp(folder / "dcmqrscp");
  if (!orthanc || !dcmtk) {
    std::cerr << "archive-bench: needs the packages orthanc, orthanc-dicomweb and dcmtk\n";
    return 1;
  }
  for (const auto* each : {&orthanc, &dcmtk}) archive::send((*each)->server, archive::filesToSend({folder / "made"}));
  Bench bench{folder, {}, {}};
  for (int i = 0; i < rounds; ++i) {
    bench.take("plain copy",
               [&] { return ofProgram("cp -r " + (folder / "made").string() + " " + (folder / "got").string()); });
    bench.round("Orthanc", *orthanc);
    bench.round("dcmqrscp", *dcmtk);
  }
  bench.write();
  return 0;
}

}  // namespace
}  // namespace fenestra

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: archive-bench FOLDER [ROUNDS]; the folder is for 2 GB of files, and new\n";
    return 2;
  }
  // Servers run in folders of their own.
  return fenestra::run(std::filesystem::absolute(argv[1]), argc > 2 ? std::atoi(argv[2]) : 5);
}
