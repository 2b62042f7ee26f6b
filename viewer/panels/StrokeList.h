#pragma once
// The strokes that the brush has painted: shown, hidden, deleted, saved to a file of their own and loaded from one.

#include <QListView>
#include <QPushButton>
#include <QWidget>

namespace fenestra::viewer {

class Document;
class StrokeModel;

class StrokeList : public QWidget {
  Q_OBJECT
 public:
  explicit StrokeList(Document& document, QWidget* parent = nullptr);

  QListView* list() const { return list_; }
  QPushButton* deleteButton() const { return delete_; }
  QPushButton* clearButton() const { return clear_; }

  /// Adds a file's strokes to the document's, as one step. Emits failed() where the file cannot be read.
  void load(const QString& file);
  /// Emits failed() where the file cannot be written.
  void save(const QString& file);

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  void connectButtons();
  void enableButtons();
  void deleteSelected();

  Document& document_;
  StrokeModel* strokes_;
  QListView* list_;
  QPushButton *delete_, *clear_, *load_, *save_;
};

}  // namespace fenestra::viewer
