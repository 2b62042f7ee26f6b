#include "viewer/results/ResultsWriter.h"

#include <algorithm>

#include <QCoreApplication>
#include <QDir>
#include <QTemporaryDir>

#include "io/results/FocusSegment.h"
#include "viewer/model/Paths.h"
#include "viewer/model/WayOutText.h"

namespace fenestra::viewer {
namespace {

namespace fs = std::filesystem;

struct ResultsWords {
  Q_DECLARE_TR_FUNCTIONS(Results)
};

/// Objects on their way: where each lies, and what it is called.
struct Staged {
  fs::path folder;
  std::vector<fs::path> files = {};
  QStringList names = {};

  fs::path add(const char* file, const QString& name) {
    files.push_back(folder / file);
    names << name;
    return files.back();
  }
};

/// NAME.dcm, or NAME-2.dcm and so on.
fs::path freeName(const fs::path& folder, const fs::path& name) {
  fs::path free = folder / name;
  std::error_code unknown;
  for (int number = 2; fs::exists(fs::symlink_status(free, unknown)); ++number)
    free = folder / (name.stem().string() + "-" + std::to_string(number) + name.extension().string());
  return free;
}

io::report::Capture captureOf(const ResultsOrder& order) {
  io::report::Capture capture;
  const QImage rgb = order.picture.convertToFormat(QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(rgb.width()) * 3;
  capture.size = {rgb.width(), rgb.height()};
  for (int y = 0; y < rgb.height(); ++y)
    capture.pixels.insert(capture.pixels.end(), rgb.constScanLine(y), rgb.constScanLine(y) + row);
  capture.description = order.description.toStdString();
  for (const QString& sentence : order.fidelity) capture.alters.push_back(sentence.toStdString());
  capture.comments = order.fidelity.join(QLatin1Char('\n')).toStdString();
  capture.namesPatient = order.pictureNamesPatient;
  return capture;
}

void writeFocus(const ResultsOrder& order, Staged& staged, const io::Progress& progress) {
  const fs::path file = staged.add("focus.dcm", ResultsWords::tr("Focus"));
  if (!order.focusLabels.empty())
    return io::writeSegments(order.source, *order.source.labels, order.focusLabels, order.description.toStdString(),
                             file, progress);
  const auto segment = io::focusSegment(order.scene, order.focusName.toStdString());
  io::writeSegments(order.source, *segment, {}, order.description.toStdString(), file, progress);
}

void writeAll(const ResultsOrder& order, Staged& staged, const io::Progress& progress) {
  const std::string description = order.description.toStdString();
  const auto step = [&](double fraction) {
    if (progress && !progress(fraction, {})) throw io::Cancelled();
  };
  step(0.0);
  bool hasSegments = false;
  if (order.measures) {
    io::MeasuresOutput output;
    output.report = staged.add("measures.dcm", ResultsWords::tr("Measures"));
    // The labels that have voxels are all that either holds, so one segmentation serves both.
    output.segments = staged.folder / (order.labels ? "segmentation.dcm" : "measures-segments.dcm");
    output.description = description;
    const io::MeasuresWritten written = io::writeMeasures(order.source, output, io::partOf(progress, 0.0, 0.4));
    hasSegments = written.labels > 0;
    if (hasSegments)
      staged.add(output.segments.filename().c_str(),
                 order.labels ? ResultsWords::tr("Labels") : ResultsWords::tr("Segments of the measures"));
  }
  step(0.4);
  if (order.labels && !hasSegments)
    io::writeSegments(order.source, *order.source.labels, {}, description,
                      staged.add("segmentation.dcm", ResultsWords::tr("Labels")), io::partOf(progress, 0.4, 0.7));
  if (order.focus) writeFocus(order, staged, io::partOf(progress, 0.7, 0.9));
  step(0.9);
  if (!order.picture.isNull())
    io::report::writeCapture(captureOf(order), order.source.isDicom() ? order.source.files : std::vector<fs::path>(),
                             staged.add("picture.dcm", ResultsWords::tr("Picture")));
  if (!order.keySlices.empty())
    io::writeKeySlices(order.source, order.keySlices, {order.keyText.toStdString(), description},
                       staged.add("key-images.dcm", ResultsWords::tr("Key images")));
  step(1.0);
}

/// Gives the files their names; on failure none keeps its own.
std::vector<fs::path> moved(const Staged& staged, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::path& each : staged.files) {
    const fs::path to = freeName(folder, each.filename());
    std::error_code problem;
    fs::rename(each, to, problem);
    if (problem) {
      std::error_code ignored;
      for (const fs::path& file : files) fs::remove(file, ignored);
      throw io::Error(to, "cannot be written: " + problem.message(), "choose another folder");
    }
    files.push_back(to);
  }
  return files;
}

}  // namespace

ResultsOutcome writeResults(const ResultsOrder& order, const io::Progress& progress) {
  // In the folder that the files go to, so that they are renamed on one disk; for their owner alone until then.
  const QTemporaryDir temporary(order.folder ? toQString(*order.folder / ".fenestra-XXXXXX")
                                             : QDir::tempPath() + QStringLiteral("/fenestra-results-XXXXXX"));
  if (!temporary.isValid())
    throw io::Error(order.folder.value_or(toPath(QDir::tempPath())),
                    "cannot hold the results: " + temporary.errorString().toStdString(),
                    "choose a folder that you may write to, with space for them");
  Staged staged{toPath(temporary.path())};
  try {
    writeAll(order, staged, io::partOf(progress, 0.0, order.send ? 0.5 : 1.0));
  } catch (const io::Error& error) {
    if (!order.folder || error.file().parent_path() != staged.folder) throw;
    // By the name that it would have got.
    const fs::path file = *order.folder / error.file().filename();
    if (error.way() != io::WayOut::None) throw io::Error(file, error.cause(), error.way());
    throw io::Error(file, error.cause(), error.hint());
  }
  ResultsOutcome outcome;
  outcome.names = staged.names;
  if (order.send) try {
      outcome.sent = order.send(staged.files, io::partOf(progress, 0.5, 0.9));
      if (order.commit)
        outcome.commitProblem = order.commit(outcome.sent, outcome.commitments, io::partOf(progress, 0.9, 1.0));
    } catch (const io::Cancelled&) {
      throw;
    } catch (const std::exception& error) {
      outcome.sendingProblem = windowText(error);
    }
  if (progress && !progress(1.0, {})) throw io::Cancelled();
  if (order.folder) outcome.written = moved(staged, *order.folder);
  return outcome;
}

}  // namespace fenestra::viewer
