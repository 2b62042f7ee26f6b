#pragma once
// The levels of importance of labels: those in focus, and those that have another level than all else.

#include <cstdint>

#include <QComboBox>
#include <QTableWidget>
#include <QWidget>

namespace fenestra::viewer {

class Document;

class ImportanceList : public QWidget {
  Q_OBJECT
 public:
  explicit ImportanceList(Document& document, QWidget* parent = nullptr);

  /// A row a label: its name, and a box with its level.
  QTableWidget* table() const { return table_; }
  /// Gives one more label a level.
  QComboBox* more() const { return more_; }

 private:
  void show();
  /// A level that the label would have without a setting is not stored.
  void setLevel(std::uint16_t label, int level);

  Document& document_;
  QTableWidget* table_;
  QComboBox* more_;
};

}  // namespace fenestra::viewer
