#include "tests/bench/Sections.h"

#include <iostream>
#include <limits>
#include <map>

#include "app/benchmark/Numbers.h"
#include "rendering/gpu/GpuScene.h"
#include "tests/bench/Peers.h"

namespace fenestra::bench {
namespace {

/// One program at one setting.
struct Row {
  std::string program, setting;
  Distribution milliseconds;
  ColourErrors errors;
};

const std::string unbounded = "Fenestra", bounded = "Fenestra, error bound";

std::vector<Row> measureAll(const Measurable& what, const std::vector<double>& bounds) {
  std::vector<Row> rows;
  Renderer renderer(std::make_shared<GpuScene>());
  std::vector<Setting> settings = unboundedSettings();
  for (const Setting& setting : boundSettings(bounds)) settings.push_back(setting);
  std::vector<Measured> measured = measure(renderer, what, settings, pathRounds);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const auto& [name, quality, maxError] = settings[i];
    const bool high = maxError == highQualityError;
    rows.push_back({maxError ? bounded : unbounded, maxError ? "≤ " + name + (high ? " (high)" : "") : name,
                    std::move(measured[i].milliseconds), std::move(measured[i].errors)});
  }
  return rows;
}

std::string stepName(double samplesPerVoxel) {
  return samplesPerVoxel < 1.0 ? number(1.0 / samplesPerVoxel) + " voxels"
                               : (samplesPerVoxel > 1.0 ? "1/" + number(samplesPerVoxel) : "1") + " voxel";
}

/// Curves of time over one measure of error.
Chart timeAgainstError(const std::string& name, const std::string& title, const std::string& errorTitle,
                       const std::vector<Row>& rows, double (*error)(const ColourErrors&)) {
  Chart chart{name, title, {errorTitle, true}, {"ms a frame: median, least to most", true}, {}};
  for (const Row& row : rows) {
    if (chart.series.empty() || chart.series.back().name != row.program) chart.series.push_back({row.program, {}});
    const Distribution& times = row.milliseconds;
    chart.series.back().points.push_back(
        {error(row.errors), times.median(), times.percentile(0.0), times.max(), row.setting});
  }
  return chart;
}

double nearlyMax(const ColourErrors& errors) { return errors.channel.percentile(99.99); }
double rootMeanSquare(const ColourErrors& errors) { return errors.squares.rms(); }

const std::vector<std::string> columns{"program", "setting", "least ms", "median ms",  "most ms",   "RMS",
                                       "99.99 %", "maximum", "ΔE RMS",   "ΔE 99.99 %", "ΔE maximum"};

void append(Table& table, const std::string& subject, const std::vector<Row>& rows) {
  for (const Row& row : rows)
    table.rows.push_back({subject, row.program, row.setting, fixed(row.milliseconds.percentile(0.0), 1),
                          fixed(row.milliseconds.median(), 1), fixed(row.milliseconds.max(), 1),
                          number(rootMeanSquare(row.errors)), number(nearlyMax(row.errors)),
                          number(row.errors.channel.max()), number(row.errors.deltaE.rms()),
                          number(row.errors.deltaE.percentile(99.99)), number(row.errors.deltaE.max())});
}

Table sweepTable(const std::string& name) {
  Table table{name, {"subject"}, {}, true};
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  return table;
}

Table comparisonTable(const std::string& name) {
  return {name,
          {"subject", "peer", "RMS", "99.99 %", "ms", "at its RMS", "RMS", "99.99 %", "ms", "speed", "at both", "RMS",
           "99.99 %", "ms", "speed"},
          {}};
}

/// The fastest of our rows whose errors are at most those given.
const Row* fastestBelow(const std::vector<Row>& rows, double rms, double nearly) {
  const Row* fastest = nullptr;
  for (const Row& row : rows)
    if ((row.program == unbounded || row.program == bounded) && rootMeanSquare(row.errors) <= rms &&
        nearlyMax(row.errors) <= nearly && (!fastest || row.milliseconds.median() < fastest->milliseconds.median()))
      fastest = &row;
  return fastest;
}

std::vector<std::string> comparison(const std::string& subject, const Row& peer, const std::vector<Row>& rows) {
  const double rms = rootMeanSquare(peer.errors), nearly = nearlyMax(peer.errors);
  std::vector<std::string> cells{subject, peer.program + ", " + peer.setting, number(rms), number(nearly),
                                 fixed(peer.milliseconds.median(), 1)};
  for (const double most : {std::numeric_limits<double>::infinity(), nearly}) {
    const Row* ours = fastestBelow(rows, rms, most);
    if (ours)
      cells.insert(cells.end(), {ours->setting, number(rootMeanSquare(ours->errors)), number(nearlyMax(ours->errors)),
                                 fixed(ours->milliseconds.median(), 1),
                                 fixed(peer.milliseconds.median() / ours->milliseconds.median(), 1) + " ×"});
    else
      cells.insert(cells.end(), {"none", "", "", "", ""});
  }
  return cells;
}

/// The peers' results for a subject with lighting, with errors against their own limits.
std::vector<Row> litPeers(const std::string& subject, const Peers& peers) {
  std::vector<Row> rows;
  for (const PeerRun& run : peers.runs)
    for (const PeerRun& limit : peers.runs)
      if (run.lit && limit.lit && run.subject == subject && limit.subject == subject && run.program == limit.program &&
          run.samplesPerVoxel < litLimit && limit.samplesPerVoxel == litLimit)
        rows.push_back({run.program, stepName(run.samplesPerVoxel), run.milliseconds, errorsOf(run, limit)});
  return rows;
}

}  // namespace

Section sweepSection(const Options& options, const TruthStore& truths) {
  Section section;
  section.title = "Time against error";
  section.text =
      "Each subject as a plain volume rendering without lighting, which every program can draw, with the same "
      "transfer function, views and steps, and as its own scene: cutaway, lighting and context layer. Errors in 1/255 "
      "of the worst channel, and as ΔE*ab (CIE 1976), against the converged reference in double precision, over the "
      "pixels that show anything. Times until the picture is in the graphics memory. Reading it as a speed: the first "
      "tables set each peer against the fastest setting of ours whose RMS is no greater, and against the fastest whose "
      "99.99th percentile is no greater, either. Draft and normal go from face to face of the cells, and interpolate "
      "between rays where the picture is smooth: draft takes three times as much for smooth."
      "\n\nThe peers have VTK's defaults but for jitter and the automatic choice of steps, which are off; opacities "
      "are those of 1 mm, in tables of 4096 entries. Their own limits show how far their pictures are the same: VTK's "
      "OpenGL mapper ends a ray at an opacity of 254/255, and its CPU mapper computes in 15 bits. With lighting the "
      "models differ, and with them what a picture converges to: each program's errors are those against its own "
      "limit, ours against the reference, a peer's against its picture at " +
      stepName(litLimit) +
      ". No pre-integrating CPU renderer of regular grids could be had from Debian: VTK's works on tetrahedra, whose "
      "interpolation is another field."
      "\n\nVolPack (shear-warp, Lacroute and Levoy 1994) draws in parallel projection alone, on one core, into 8 bits. "
      "It gives each voxel its colour and opacity first and interpolates these, so that its picture does not converge "
      "to the reference: outlines lie up to a voxel further out. Its opacities are those of the way from slice to "
      "slice along the view, set anew for each view "
      "outside the times. Of its two settings one is its defaults, which skip voxels of opacity below 0.05 and end a "
      "ray at 0.95; the other skips transparent voxels alone and ends at 254/255.";
  const Peers peers = readPeers(options.peers, options.views);
  for (const std::string& program : peers.programs) section.text += "\n\n" + program;
  for (const std::string& left : peers.left) section.text += "\n\n" + left;
  const Subjects subjects = reportSubjects(options.views);
  for (const std::string& missing : subjects.missing) section.text += "\n\n" + missing;

  Table against = comparisonTable("peers"), litAgainst = comparisonTable("lit-peers");
  Table plainTable = sweepTable("plain"), litTable = sweepTable("lit"), ownTable = sweepTable("scenes");
  Table limit{"limits", {"program", "step", "RMS", "99.9 %", "99.99 %", "maximum"}, {}};
  for (const Subject& subject : subjects.here) {
    std::cerr << "sweep: " << subject.name << '\n';
    const io::Study study = io::readStudy(subject.options);
    const Scene plainUnlit = plainScene(study.drawn.scene());
    const Measurable plain = prepare(subject.name, plainUnlit, options, truths);
    std::vector<Row> rows = measureAll(plain, {8.0, 4.0, 2.0, 1.0, 0.5, 0.25});
    const std::size_t ours = rows.size();
    std::map<std::string, Row> floors;
    for (const PeerRun& run : peers.runs) {
      if (run.subject != subject.id || run.lit) continue;
      Row row{run.program, run.setting.empty() ? stepName(run.samplesPerVoxel) : run.setting, run.milliseconds,
              errorsOf(run, plain)};
      if (!limitLadder.empty() && subject.id == subjects.here.front().id)
        limit.rows.push_back({row.program, row.setting, number(rootMeanSquare(row.errors)),
                              number(row.errors.channel.percentile(99.9)), number(nearlyMax(row.errors)),
                              number(row.errors.channel.max())});
      if (run.samplesPerVoxel > stepLadder.back()) continue;
      const auto [floor, isNew] = floors.try_emplace(run.program, row);
      if (!isNew && rootMeanSquare(row.errors) < rootMeanSquare(floor->second.errors)) floor->second = row;
      if (run.samplesPerVoxel == 2.0) against.rows.push_back(comparison(subject.name, row, rows));
      rows.push_back(std::move(row));
    }
    for (auto& [program, floor] : floors) {
      floor.program += " at its least error";
      against.rows.push_back(
          comparison(subject.name, floor, {rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(ours)}));
    }
    append(plainTable, subject.name, rows);
    section.charts.push_back(timeAgainstError(subject.id + "-plain", subject.name + ", plain, unlit",
                                              "99.99th percentile of the error, 1/255", rows, nearlyMax));
    section.charts.push_back(timeAgainstError(subject.id + "-plain-rms", subject.name + ", plain, unlit",
                                              "RMS error, 1/255", rows, rootMeanSquare));

    Scene plainLit = plainUnlit;
    plainLit.look.shading.enabled = true;
    std::vector<Row> litRows = measureAll(prepare(subject.name, plainLit, options, truths), {8.0, 2.0});
    for (Row& row : litPeers(subject.id, peers)) {
      litAgainst.rows.push_back(comparison(subject.name, row, litRows));
      litRows.push_back(std::move(row));
    }
    append(litTable, subject.name, litRows);

    const std::vector<Row> own = measureAll(prepare(subject.name, study.drawn.scene(), options, truths), {2.0, 0.5});
    append(ownTable, subject.name, own);
    section.charts.push_back(timeAgainstError(subject.id + "-scene", subject.name + ", with cutaway and lighting",
                                              "99.99th percentile of the error, 1/255", own, nearlyMax));
  }
  std::cerr << plainText(against) << plainText(litAgainst) << plainText(plainTable) << plainText(litTable)
            << plainText(ownTable) << plainText(limit);
  section.tables = {std::move(against),    std::move(litAgainst), std::move(limit),
                    std::move(plainTable), std::move(litTable),   std::move(ownTable)};
  return section;
}

}  // namespace fenestra::bench
