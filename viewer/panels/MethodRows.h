#pragma once
// The rows of the methods' settings in the panel Cutaway: those of the chosen method show.

#include <memory>
#include <vector>

#include <QCoreApplication>
#include <QFormLayout>

#include "rendering/methods/Method.h"

namespace fenestra::viewer {

class Document;

/// Each setting of a method has a row, as its declaration says; MethodRows.cpp has what some methods lay out in another
/// way.
class MethodRows {
  Q_DECLARE_TR_FUNCTIONS(MethodRows)

 public:
  /// The rows of one method.
  class Group {
   public:
    virtual ~Group() = default;
    virtual void show(const Method& method) = 0;
    virtual void setEnabled(bool enabled) = 0;
  };

  /// Adds the rows of all methods to `form`, which outlives this.
  MethodRows(Document& document, QFormLayout& form);

  /// Shows the rows of the document's method and the values of all.
  void show() const;
  void setEnabled(bool enabled) const;

 private:
  Document& document_;
  std::vector<std::unique_ptr<Group>> groups_;
};

}  // namespace fenestra::viewer
