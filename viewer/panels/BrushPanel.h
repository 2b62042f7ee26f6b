#pragma once
// How the brush paints, and what it has painted: strokes to hide, delete, save apart and load.

#include <array>

#include <QCheckBox>
#include <QListView>
#include <QPushButton>
#include <QToolButton>

#include "viewer/model/Brush.h"
#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

class Document;
class SliderSpin;
class StrokeModel;

class BrushPanel : public ScrollingPanel {
  Q_OBJECT
 public:
  BrushPanel(Document& document, Brush& brush, QWidget* parent = nullptr);

  QToolButton* paintButton() const { return paint_; }
  QToolButton* modeButton(BrushMode mode) const { return modes_[static_cast<std::size_t>(mode)]; }
  SliderSpin* radius() const { return radius_; }
  SliderSpin* depth() const { return depth_; }
  QCheckBox* coversFocus() const { return coversFocus_; }
  QCheckBox* thisViewOnly() const { return thisViewOnly_; }
  QListView* list() const { return list_; }
  QPushButton* deleteButton() const { return delete_; }
  QPushButton* clearButton() const { return clear_; }

  /// As one step, after those that are there already; what goes wrong is told by failed().
  void load(const QString& file);
  void save(const QString& file);

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  void showBrush();
  void enableButtons();
  void deleteSelected();

  Document& document_;
  Brush& brush_;
  QToolButton* paint_;
  std::array<QToolButton*, 4> modes_{};
  SliderSpin *radius_, *softness_, *depth_, *amount_;
  QCheckBox *coversFocus_, *thisViewOnly_;
  StrokeModel* strokes_;
  QListView* list_;
  QPushButton *delete_, *clear_, *load_, *save_;
};

}  // namespace fenestra::viewer
