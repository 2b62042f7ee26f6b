#include "tests/bench/Sections.h"

#include <iostream>

#include "app/benchmark/Numbers.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra::bench {

constexpr int rounds = 5;

Section boundsSection(const Options& options, const TruthStore& truths) {
  Section section;
  section.title = "The error bound, asked for and measured";
  section.text =
      "Errors in 1/255 of the worst channel against the reference, one view of each scene, over the whole chain of "
      "passes; time of that frame, the median of " +
      std::to_string(rounds) + ".";
  Table table{"bounds", {"scene", "bound", "99.9 %", "99.99 %", "maximum", "RMS", "within", "ms"}, {}};
  Options oneView = options;
  oneView.views.cameras = 1;
  const Subjects subjects = boundSubjects(options.views);
  for (const std::string& missing : subjects.missing) section.text += "\n\n" + missing;
  for (const Subject& subject : subjects.here) {
    const io::Study study = io::readStudy(subject.options);
    const Measurable what = prepare(subject.name, study.drawn.scene(), oneView, truths);
    Renderer renderer(std::make_shared<GpuScene>());
    const std::vector<Setting> settings = boundSettings({4.0, 2.0, 1.0, 0.5});
    const std::vector<Measured> measured = measure(renderer, what, settings, rounds);
    const std::size_t first = table.rows.size();
    for (std::size_t i = 0; i < settings.size(); ++i) {
      const Distribution& errors = measured[i].errors.channel;
      const double nearly = errors.percentile(99.99);
      table.rows.push_back({what.name, settings[i].name, number(errors.percentile(99.9)), number(nearly),
                            number(errors.max()), number(measured[i].errors.squares.rms()),
                            nearly <= *settings[i].maxError ? "yes" : "no",
                            fixed(measured[i].milliseconds.median(), 1)});
    }
    std::cerr << plainText(
        {"", table.columns, {table.rows.begin() + static_cast<std::ptrdiff_t>(first), table.rows.end()}});
  }
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace fenestra::bench
