#pragma once
// The best viewpoints as a row of small pictures; a click on one asks to look from there.

#include <array>
#include <vector>

#include <QTimer>
#include <QToolButton>
#include <QWidget>

namespace fenestra::viewer {

class Document;
class PlacementController;
class ViewLink;

class BestViews : public QWidget {
  Q_OBJECT
 public:
  static constexpr std::size_t count = 4;

  BestViews(Document& document, ViewLink& cameras, PlacementController& placement, QWidget* parent = nullptr);

  QToolButton* button(std::size_t rank) const { return buttons_.at(rank); }
  /// Pictures are still to be drawn.
  bool isDrawing() const { return drawing_.isActive(); }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// Asks for the best viewpoints, which may have changed.
  void list();
  /// Draws the pictures anew, after a moment.
  void redraw();
  /// Draws one picture, so that the window answers in between.
  void drawNext();

  ViewLink& cameras_;
  PlacementController& placement_;
  std::array<QToolButton*, count> buttons_{};
  std::vector<std::size_t> best_;  ///< the candidates that the buttons show
  std::size_t drawn_ = 0;          ///< number of best_ with a picture
  QTimer drawing_;
};

}  // namespace fenestra::viewer
