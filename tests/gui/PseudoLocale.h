#pragma once
// A language for tests: every text that can be translated is marked and a third longer.

#include <QRegularExpression>
#include <QTranslator>

namespace fenestra::viewer {

inline constexpr QChar opens(0x27e6), closes(0x27e7);  // ⟦ ⟧

class PseudoLocale : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* source, const char*, int n) const override {
    // A translator leaves keys alone.
    static const QRegularExpression key(QStringLiteral("^((Ctrl|Shift|Alt)\\+)*(.|F\\d+|Esc|Space)$"));
    QString text = QString::fromUtf8(source);
    if (text.trimmed().isEmpty() || key.match(text).hasMatch()) return {};
    const auto added = (text.size() * 3 + 9) / 10;
    if (n >= 0) text.replace(QStringLiteral("%n"), QString::number(n));
    return opens + text + QString(added, QLatin1Char('~')) + closes;
  }
};

}  // namespace fenestra::viewer
