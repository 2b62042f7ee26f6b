#pragma once
// The path of the straightened picture: drawn by clicks on the slices, and a place on it that goes with the crosshair.

#include <optional>
#include <vector>

#include <QObject>

#include "rendering/reformat/PathCurve.h"

namespace fenestra::viewer {

class ActiveTool;
class Document;
class MeasureMode;
class SliceCursor;

class PathMode : public QObject {
  Q_OBJECT
 public:
  /// All outlive this. Drawing a path ends drawing measures and strokes, and is ended by them.
  PathMode(Document& document, SliceCursor& cursor, MeasureMode& measures, ActiveTool& tool);

  /// Clicks on the slices draw a path.
  bool isDrawing() const { return drawing_; }
  /// Starts drawing, or ends it; a path that was begun is dropped.
  void toggle();
  /// The points so far; the mouse's place follows the last one while it is on a slice.
  const std::vector<glm::dvec3>& draft() const { return draft_; }
  const std::optional<glm::dvec3>& hovered() const { return hovered_; }
  void hover(std::optional<glm::dvec3> world);
  /// Adds a point, unless it lies on the last one.
  void addPoint(glm::dvec3 world);
  /// Takes the last point away; false where there is none.
  bool removeLast();
  /// Makes the draft the document's path, as one step, and ends drawing. One point or none is no path: drawing goes on.
  bool finish();
  /// Ends drawing without a path; false when nothing was drawn.
  bool stop();

  /// Moves a point of the document's path from where it was in `before`; points nearer than `reach` along the path go
  /// along in part, so that a line of many points stays smooth. A step of the history, or of a gesture.
  void movePoint(const std::vector<glm::dvec3>& before, std::size_t point, glm::dvec3 by);
  static constexpr double reach = 6.0;  ///< mm; less than between points that are clicked, as a rule

  /// The document's path; its length is 0 without one.
  const reformat::PathCurve& curve() const { return curve_; }
  bool hasPath() const { return curve_.length() > 0.0; }
  /// Its places, about a millimetre from each to the next.
  const std::vector<glm::dvec3>& line() const { return line_; }
  /// The chosen place, mm from the beginning: the one nearest to the crosshair, or where setPlace() has moved that.
  double place() const { return place_; }
  /// Moves the crosshair to a place of the path, held to it.
  void setPlace(double mm);

 Q_SIGNALS:
  void changed();  ///< drawing, the draft, or the path
  void moved();    ///< the place alone
  void walked();   ///< after moved(), where setPlace() has moved it

 private:
  void readPath();
  void followCursor();

  Document& document_;
  SliceCursor& cursor_;
  MeasureMode& measures_;
  ActiveTool& tool_;
  bool drawing_ = false;
  bool placing_ = false;  ///< setPlace() moves the crosshair
  std::vector<glm::dvec3> draft_;
  std::optional<glm::dvec3> hovered_;
  reformat::PathCurve curve_{std::span<const glm::dvec3>()};
  std::vector<glm::dvec3> line_;
  double place_ = 0.0;
};

/// Places of a curve, about `step` mm from each to the next, both ends among them; empty where it has no length.
std::vector<glm::dvec3> lineOf(const reformat::PathCurve& curve, double step);
/// The place of a curve nearest to a point, mm from its beginning; `line` is lineOf() it.
double nearestPlace(const reformat::PathCurve& curve, const std::vector<glm::dvec3>& line, glm::dvec3 point);

}  // namespace fenestra::viewer
