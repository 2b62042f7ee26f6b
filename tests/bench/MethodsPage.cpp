#include "tests/bench/MethodsPage.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/benchmark/Numbers.h"

namespace fenestra::bench {
namespace {

/// A column in which one method can be better than another.
struct Measure {
  std::string title;
  std::function<double(const MethodFigures&)> value;
  std::function<std::string(double)> format;
  bool moreIsBetter;

  std::string text(double figure) const { return std::isnan(figure) ? "–" : format(figure); }
};

std::string share(double value) { return fixed(value, 3); }

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"focus seen", [](const MethodFigures& m) { return m.seen; }, share, true},
      {"least", [](const MethodFigures& m) { return m.leastSeen; }, share, true},
      {"volume kept", [](const MethodFigures& m) { return m.volume; }, share, true},
      {"surface kept", [](const MethodFigures& m) { return m.surface; }, share, true},
      {"wrong order", [](const MethodFigures& m) { return m.wrongOrder; }, share, false},
      {"turning", [](const MethodFigures& m) { return m.turning; }, number, false},
      {"cost", [](const MethodFigures& m) { return m.cost; }, [](double value) { return fixed(value, 1); }, false},
      {"error", [](const MethodFigures& m) { return m.error; }, number, false}};
  return all;
}

/// The entry of a column's best methods in the table.
std::string bestText(const Measure& measure, const std::vector<MethodFigures>& methods) {
  const auto isWorse = [&](const MethodFigures& a, const MethodFigures& b) {
    const double first = measure.value(a), second = measure.value(b);
    if (std::isnan(first) || std::isnan(second)) return std::isnan(first) && !std::isnan(second);
    return measure.moreIsBetter ? first < second : first > second;
  };
  return measure.text(measure.value(*std::max_element(methods.begin(), methods.end(), isWorse)));
}

std::string pairsText(const MethodFigures& figures) {
  if (std::isnan(figures.wrongOrder)) return "–";
  return std::to_string(figures.wrongPairs) + " of " + std::to_string(figures.pairs);
}

std::vector<std::string> rowOf(const MethodFigures& figures, const std::vector<std::string>& best) {
  std::vector<std::string> row{figures.name};
  for (std::size_t i = 0; i < measures().size(); ++i) {
    const Measure& measure = measures()[i];
    const std::string text = measure.text(measure.value(figures));
    row.push_back(!best.empty() && text == best[i] ? "**" + text + "**" : text);
    if (measure.title == "wrong order") row.push_back(pairsText(figures));
    if (measure.title == "turning") row.push_back(fixed(figures.milliseconds, 1));
  }
  return row;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

/// Where the first method is best, and where others are better.
std::string verdictOf(const SceneFigures& scene) {
  std::vector<std::string> best, worse;
  for (const Measure& measure : measures()) {
    const std::string own = measure.text(measure.value(scene.methods.front()));
    const std::string top = bestText(measure, scene.methods);
    if (own == top) {
      best.push_back(measure.title);
      continue;
    }
    std::vector<std::string> names;
    for (const MethodFigures& method : scene.methods)
      if (measure.text(measure.value(method)) == top) names.push_back(method.name);
    worse.push_back(measure.title + " (" + own + "; " + joined(names) + ": " + top + ")");
  }
  std::string text = scene.methods.front().name + ": ";
  text += best.empty() ? "best in no column" : "best, alone or with others, in " + joined(best);
  return text + (worse.empty() ? "." : "; not best in " + joined(worse) + ".");
}

}  // namespace

Section sectionOf(const SceneFigures& scene) {
  Section section;
  section.title = scene.name;
  section.text = verdictOf(scene);
  Table table{scene.id, {"method"}, {}};
  std::vector<std::string> best;
  for (const Measure& measure : measures()) {
    table.columns.push_back(measure.title);
    if (measure.title == "wrong order") table.columns.push_back("wrong pairs");
    if (measure.title == "turning") table.columns.push_back("ms");
    best.push_back(bestText(measure, scene.methods));
  }
  for (const MethodFigures& method : scene.methods) table.rows.push_back(rowOf(method, best));
  table.rows.push_back(rowOf(scene.plain, {}));
  section.tables.push_back(std::move(table));
  return section;
}

Section summaryOf(const std::vector<SceneFigures>& scenes) {
  Section section;
  section.title = "Best methods";
  section.text = "In how many of the " + std::to_string(scenes.size()) +
                 " scenes a method is the best of its column, alone or with others.";
  Table table{"best", {"method"}, {}};
  for (const Measure& measure : measures()) table.columns.push_back(measure.title);
  for (std::size_t k = 0; k < scenes.front().methods.size(); ++k) {
    std::vector<std::string> row{scenes.front().methods[k].name};
    for (const Measure& measure : measures())
      row.push_back(std::to_string(std::count_if(scenes.begin(), scenes.end(), [&](const SceneFigures& scene) {
        return measure.text(measure.value(scene.methods[k])) == bestText(measure, scene.methods);
      })));
    table.rows.push_back(std::move(row));
  }
  section.tables.push_back(std::move(table));
  return section;
}

std::string methodsText() {
  return "Every method at its defaults, the same focus, context and cameras; nothing was tuned for these scenes. 48 "
         "views: twelve to a turn, at elevations of -45°, -15°, 15° and 45°, normal quality. Widths in pixels are "
         "those of pictures 700 pixels wide. Bold: the best of the column, by the digits shown. The last row of each "
         "table is the picture in which nothing is opened, for comparison.\n\n"
         "*Focus seen*: how much of the focus's light reaches the eye, weighted by what it is seen through, of what "
         "would "
         "if there were no context; mean of the views, and the *least*, that of the worst view. It is the difference "
         "of two pictures, with the focus once bright and once black, summed over the pixels. Edges and borders over "
         "the focus count as hiding it.\n\n"
         "*Volume kept* and *surface kept*: a method leaves at a point of a ray the share `k` of the context's "
         "extinction `κ`. `k` is 1 behind the ray's start; before it, it is the method's share `w` of what it opens, "
         "0 where nothing of that stays; where the context fades, `k = m`, of a ghost before the ray's start alone; "
         "and 1 where nothing is opened. (`w` and `m` "
         "are those of resources/reference/method.md; context is what has an opacity above 1/255 over 1 mm.) The "
         "volume kept is `∫ k κ dV / ∫ κ dV` over all of the context in the picture, also over what other context "
         "hides. The surface kept is the mean of `∫ k κ dt / ∫ κ dt` over a skin, one voxel deep, behind the first "
         "hit of each ray that meets context first, weighted by the area across the ray, `ω t²` with the pixel's solid "
         "angle `ω`; a surface that turns away from the eye thus counts by what of it faces the eye. Means of the "
         "views. Rays through every fourth pixel along both sides are sampled twice per voxel by the CPU; `w` and the "
         "starts are those of the pictures, `m` is computed once more. Edges of the removed context, which are drawn "
         "over the focus, and the border count as nothing kept. Walls behind the picture are no context. An exploded "
         "view "
         "and a peeled layer remove nothing but move it, so that neither this nor the order of depth can be told along "
         "the "
         "picture's rays: –.\n\n"
         "*Wrong order*: along each ray, every method here draws what is nearer over what is farther, so none is wrong "
         "within a pixel. But a picture also says what lies in front by its outlines: an outline belongs to the nearer "
         "of the two things that it parts. Where something that lies behind is drawn with its outline next to an "
         "untouched surface that lies before it, it seems to float before that surface. So for a pixel `p` that shows "
         "the focus, beside a pixel `q` whose ray misses the focus and meets context, let `h` be half way from the "
         "first hit of `q` to the focus at `p`, and `a(h)` the opacity that the context nearer than `h` has in a "
         "pixel. "
         "What is wrong is `e = max(0, a_q(h) - a_p(h))`: the opacity of what lies clearly before the focus, and is "
         "seen beside it but not over it. The number is the mean of `e` over the outlines, weighted by how much of the "
         "focus `p` shows, and over the views. A film over both counts as right, and so does the wall of an opening "
         "that begins at the focus and rises to the surface over two pixels or more; for a plain picture it is 0 but "
         "for noise. *Wrong pairs*: of the pairs of a structure in focus and the structure that `q` shows most of, in "
         "all views, those with a mean `e` above one half; without labels, focus and context are the only pair. "
         "Limits: "
         "outlines of the focus alone are looked at, not those between structures in focus nor between those of the "
         "context; lines drawn over the focus, shading and motion also tell depth, and are not counted; up to some 200 "
         "places of the outlines of each view are sampled.\n\n"
         "*Turning*: the largest mean change of a pixel between views 1° apart, in 1/255. *ms*: one frame after the "
         "camera moved, the median of the views. *Cost*: the same in times of the picture in which nothing is opened, "
         "by the processors' time where they draw, so that other programs count little. *Error*: at least 99.9 % of "
         "the pixels of the first view are within so many 1/255 of the method's own reference, with 95 % confidence. "
         "All is drawn at normal quality, which has no bound; a picture with a bound keeps to it with any method.";
}

}  // namespace fenestra::bench
