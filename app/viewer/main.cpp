// fenestra: the window. Exit codes as for fenestra-cli: 0 done, 1 the input or the machine is at fault, 2 wrong usage.

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <QApplication>
#include <QIcon>

#include "app/SceneOptions.h"
#include "app/ScheduleChoice.h"
#include "app/options/Completion.h"
#include "app/viewer/TerminationSignals.h"
#include "io/ImageWriter.h"
#include "io/PhantomFile.h"
#include "io/base/SessionName.h"
#include "io/study/Interpret.h"
#include "io/study/ReadStudy.h"
#include "viewer/MainWindow.h"
#include "viewer/files/Sessions.h"
#include "viewer/guide/Tour.h"
#include "viewer/model/Languages.h"
#include "viewer/model/Preferences.h"
#include "viewer/model/SessionController.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {
namespace {

constexpr int done = 0, failed = 1, misused = 2;

/// Writes one line to stderr; line breaks in the text become spaces.
void tell(std::string what) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  std::cerr << "fenestra: " << what << '\n';
}

int fail(const std::string& what) {
  tell(what);
  return failed;
}

/// Qt aborts where it finds no display: this says so in one line instead. Qt's debug messages and warnings are dropped.
void handleQtMessage(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtFatalMsg) {
    tell("no display to open a window on; start it on a desktop, or use fenestra-cli");
    std::_Exit(failed);
  }
  if (type == QtCriticalMsg) tell(message.toStdString());
}

StudyLoader::SampleReader phantomReader(const std::string& name) {
  return [name](const Look& look, const io::Progress& progress) {
    io::StudyRequest request;
    request.phantom = name;
    request.look = look;
    return io::readStudy(request, progress);
  };
}

/// The whole window as a PNG, in device pixels.
void saveScreenshot(MainWindow& window, const std::filesystem::path& path, MainWindow::Patient patient) {
  const QImage picture = window.picture(patient).convertToFormat(QImage::Format_RGB888);
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()) * 3);
  for (int row = 0; row < picture.height(); ++row) {
    const std::uint8_t* line = picture.constScanLine(row);
    pixels.insert(pixels.end(), line, line + picture.width() * 3);
  }
  io::writePng(path, {picture.width(), picture.height()}, 3, pixels);
}

/// What the command line asks for.
struct Request {
  io::StudyRequest study;
  std::filesystem::path screenshot;                           ///< empty: stay open
  MainWindow::Patient patient = MainWindow::Patient::Hidden;  ///< in the screenshot
  std::optional<Effort> atRest;                               ///< unset: as remembered
  std::optional<Schedule> schedule;                           ///< unset: the faster one
  std::optional<std::string> language;                        ///< unset: as remembered
  bool welcomes = false;                                      ///< nothing was asked for: opens nothing
  /// A session or a preset sets all of them, too.
  bool setsBackground = false, setsUnit = false;

  /// The study as asked for, where nothing was said with the user's own defaults.
  io::StudyRequest studyWith(const Preferences& preferences) const {
    io::StudyRequest asked = study;
    const Look own = preferences.startingLook(study.look);
    if (!setsBackground) asked.look.background = own.background;
    if (!setsUnit) asked.look.cutaway.unit = own.cutaway.unit;
    return asked;
  }
};

/// "en, de, es, fr, zh_CN"
std::string languageCodes() {
  std::string codes;
  for (const Language& each : languages)
    if (*each.code) codes += (codes.empty() ? "" : ", ") + std::string(each.code);
  return codes;
}

/// Reads the command line into `request`. Returns an exit code when the program should end at once.
std::optional<int> parse(int argc, char** argv, Request& request) {
  app::Program program(
      "Fenestra: looks into medical volumes with an adaptive cutaway.\nNot for diagnostic use.\n"
      "Without arguments it offers phantoms, a guided tour and the data opened last.",
      "fenestra", FENESTRA_VERSION);
  app::addCompletionOption(program);
  const app::Command options = program.options();
  io::StudyRequest& study = request.study;
  app::addSceneOptions(options, study);
  app::addScheduleOption(options, request.schedule);
  std::vector<std::string> morePaths;
  options.addValue("MORE", morePaths, "further slices of PATH's folder, or a label map").as("PATH ...");
  options.add("--screenshot", "OUT.png", "save the whole window once everything is drawn, and exit",
              [&](const std::string& path) {
                request.screenshot = path;
                return true;
              });
  options.add("--language", "CODE",
              "language of the window: " + languageCodes() + "; the desktop's unless given or set",
              [&](const std::string& code) {
                request.language = code;
                return std::any_of(languages.begin() + 1, languages.end(),
                                   [&](const Language& each) { return each.code == code; });
              });
  bool withPatient = false;
  options.addFlag("--with-patient", withPatient, "let the screenshot show the patient's name, number, sex and dates");
  try {
    const app::Program::Parsed parsed = program.parse(argc, argv);
    if (parsed.exitCode) return parsed.exitCode;
    if (!parsed.mistake.empty()) {
      tell(parsed.mistake + "; see --help");
      return misused;
    }
    if (!morePaths.empty()) {
      std::vector<std::filesystem::path> paths{study.path};
      paths.insert(paths.end(), morePaths.begin(), morePaths.end());
      const io::DataRequest chosen = io::interpret(paths);
      study.path = chosen.path;
      if (!chosen.labels.empty()) study.labels = chosen.labels;
    }
  } catch (const io::Error& error) {
    tell(error.what());
    return io::isSession(study.path) ? failed : misused;
  }
  if (withPatient) request.patient = MainWindow::Patient::Shown;
  const bool hasLook = io::isSession(study.path) || study.preset;
  request.setsBackground = hasLook || options.isGiven("--background");
  request.setsUnit = hasLook || options.isGiven("--width-unit");
  request.welcomes = argc <= 1;
  if (study.empty()) study.phantom = "torso";
  if (options.isGiven("--quality") || options.isGiven("--max-error"))
    request.atRest = Effort{.quality = study.quality, .maxError = study.maxError};
  return std::nullopt;
}

void setUp(QApplication& application, const Request& request) {
  // QApplication takes the desktop's locale for the C library, too, with which libraries would write numbers into files
  // with a decimal comma.
  std::setlocale(LC_NUMERIC, "C");
  application.setApplicationName(QStringLiteral("Fenestra"));
  application.setOrganizationName(QStringLiteral("Fenestra"));
  application.setApplicationVersion(QStringLiteral(FENESTRA_VERSION));
  application.setDesktopFileName(QStringLiteral(FENESTRA_APP_ID));
  // A screenshot has the defaults of a new user.
  const Preferences preferences(request.screenshot.empty() ? Preferences::Mode::Stored : Preferences::Mode::Transient);
  speak(request.language.value_or(preferences.language()));
  applyStyle(application);
}

/// Opens what `request` names.
void openAsked(MainWindow& window, const Request& request) {
  window.sessions().open([study = request.studyWith(window.workspace().preferences)] { return study; });
}

/// Offers to restore work after a crash. What `request` names is then offered beside the work, and else opened, unless
/// it `isOpening` already.
void openInWindow(MainWindow& window, const Request& request, bool isOpening) {
  const bool restores = window.sessions().startRecovery(Sessions::recoveryFolder());
  if (request.welcomes || isOpening) return;
  if (restores)
    window.offer(QString::fromStdString(request.study.source()),
                 [study = request.studyWith(window.workspace().preferences)] { return study; });
  else
    openAsked(window, request);
}

/// Opens what `request` names, saves the window once it is drawn, and ends the program.
void openForScreenshot(MainWindow& window, const Request& request) {
  QObject::connect(&window, &MainWindow::failed,
                   [](const QString& message) { QCoreApplication::exit(fail(message.toStdString())); });
  QObject::connect(&window, &MainWindow::opened, [&window, path = request.screenshot, patient = request.patient] {
    window.whenDrawn([&window, path, patient] {
      try {
        saveScreenshot(window, path, patient);
        QCoreApplication::exit(done);
      } catch (const std::exception& error) {
        QCoreApplication::exit(fail(error.what()));
      }
    });
  });
  // With the defaults of a new user: preferences are not read where nothing is remembered.
  // Errors keep the words of the command line, which they go to.
  window.open([study = request.studyWith(window.workspace().preferences)](const io::Progress& progress) {
    try {
      return io::readStudy(study, progress);
    } catch (const io::Error& error) {
      throw std::runtime_error(error.what());
    }
  });
}

int main(int argc, char** argv) {
  Request request;
  if (const std::optional<int> code = parse(argc, argv, request)) return *code;

  qInstallMessageHandler(handleQtMessage);
  requestOpenGl();
  QApplication application(argc, argv);
  setUp(application, request);
  const bool stays = request.screenshot.empty();
  const GlSupport gl = probeOpenGl();
  if (!gl.available && !stays) tell(gl.problem.toStdString());
  // Where there is work to restore, the user is asked first.
  const bool opensAtOnce =
      stays && !request.welcomes && SessionController::abandonedIn(Sessions::recoveryFolder()).empty();
  MainWindow window(
      {.gl = gl,
       .atRest = request.atRest,
       .expected = io::expectedFocus(request.study),
       .chooseSchedule = [asked = request.schedule, software = gl.software](
                             const std::shared_ptr<GpuScene>& gpu, const Scene& scene,
                             const View& view) { app::chooseScheduleQuickly(asked, software, gpu, scene, view); },
       .remember = stays,
       .openFirst = opensAtOnce ? [&](MainWindow& opening) { openAsked(opening, request); }
                                : std::function<void(MainWindow&)>()});
  std::vector<std::string> phantoms = io::phantomNames();
  std::partition(phantoms.begin(), phantoms.end(), [](const std::string& name) { return name == Tour::phantom; });
  for (const std::string& name : phantoms)
    window.addSample(QString::fromStdString(io::loadPhantom(name).name), phantomReader(name));
  if (request.study.size) window.resize(request.study.size->x, request.study.size->y);
  window.show();
  const TerminationSignals signals([&window] { window.leave(); });
  if (stays)
    openInWindow(window, request, opensAtOnce);
  else
    openForScreenshot(window, request);
  return QApplication::exec();
}

}  // namespace
}  // namespace fenestra::viewer

int main(int argc, char** argv) {
  try {
    return fenestra::viewer::main(argc, argv);
  } catch (const std::exception& error) {
    return fenestra::viewer::fail(std::string("cannot start: ") + error.what());
  }
}
