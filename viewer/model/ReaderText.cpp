#include "viewer/model/ReaderText.h"

#include <iterator>
#include <vector>

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

namespace fenestra::viewer {
namespace {

/// A text goes before those whose places would take it in.
constexpr const char* texts[] = {
    QT_TRANSLATE_NOOP("Reader", "the scanner's table is left out of 3-D pictures; slices show it"),
    QT_TRANSLATE_NOOP("Reader",
                      "the file names no modality; its values (%1 to %2) are taken for Hounsfield units of a CT"),
    QT_TRANSLATE_NOOP("Reader", "the file stores no orientation; its axes are taken as right, anterior, superior"),
    QT_TRANSLATE_NOOP("Reader", "the file does not say where the slice lies in the patient"),
    QT_TRANSLATE_NOOP("Reader",
                      "the file does not say where its slices lie in the patient; their Slice Location gives their "
                      "order and a distance of %1 mm, the place is a guess"),
    QT_TRANSLATE_NOOP("Reader",
                      "the file does not say where its slices lie in the patient; they are shown in their stored "
                      "order, at a distance that is a guess (%1 mm, %2)"),
    QT_TRANSLATE_NOOP("Reader", "no pixel spacing is given; 1 mm is assumed"),
    QT_TRANSLATE_NOOP("Reader", "the pixel spacing is the detector's; distances in the patient are smaller"),
    QT_TRANSLATE_NOOP("Reader", "its header has no ElementSpacing; 1 mm is assumed"),
    QT_TRANSLATE_NOOP("Reader", "its header has no spacings; 1 mm is assumed"),
    QT_TRANSLATE_NOOP("Reader", "the file holds %1 volumes (time points or layers); number %2 is shown"),
    QT_TRANSLATE_NOOP("Reader",
                      "all %1 frames lie at one position (time points or repeats, no deeper volume%2); each forms a "
                      "volume of its own: number %3 is shown"),
    QT_TRANSLATE_NOOP("Reader",
                      "%1 frames lie at each position (time points or repeats, no deeper volume%2); each forms a "
                      "volume of its own: number %3 is shown"),
    QT_TRANSLATE_NOOP("Reader", "; told apart by %1"),
    QT_TRANSLATE_NOOP("Reader",
                      "the slices are tilted by %1 degrees against the direction they are stacked in (%2 mm sideways "
                      "from slice to slice)"),
    QT_TRANSLATE_NOOP("Reader", "%1 missing: neighbours lie %2 mm apart, but up to %3 mm between the files named"),
    QT_TRANSLATE_NOOP("Reader", "the slices lie between %1 mm and %2 mm apart"),
    QT_TRANSLATE_NOOP("Reader",
                      "%1 shifted sideways by up to %2 mm from the line that the first and the last one lie on"),
    QT_TRANSLATE_NOOP("Reader",
                      "%1 with other directions or pixel spacing than the first; shown with those of the first, pixels "
                      "lie up to %2 mm from their places"),
    QT_TRANSLATE_NOOP("Reader", "the volume is sheared, so that every slice lies where it was scanned"),
    QT_TRANSLATE_NOOP("Reader", "all slices are shown %1 mm apart, up to %2 mm from where they were scanned"),
    QT_TRANSLATE_NOOP("Reader", "%1; %2 of the voxels lie outside of what was scanned and hold the least value, %3"),
    QT_TRANSLATE_NOOP("Reader", "%1; %2 in gaps wider than %3 mm is interpolated across the gap"),
    QT_TRANSLATE_NOOP("Reader", "%1; %2 in gaps wider than %3 mm are interpolated across the gap"),
    QT_TRANSLATE_NOOP("Reader", "%1 (evenly spread they would lie up to %2 mm from their places)"),
    QT_TRANSLATE_NOOP("Reader", "%1, with nothing displaced"),
    QT_TRANSLATE_NOOP("Reader", "%1, displaced by up to %2 mm"),
    QT_TRANSLATE_NOOP("Reader", "%1, sheared as they were scanned"),
    QT_TRANSLATE_NOOP("Reader", "linear interpolation places the slices on %1 planes %2 mm apart"),
    QT_TRANSLATE_NOOP("Reader", "cubic interpolation places the slices on %1 planes %2 mm apart"),
    QT_TRANSLATE_NOOP("Reader", "%1 left out: the same images (SOP instances) as in other files"),
    QT_TRANSLATE_NOOP("Reader", "%1 of the folder left out: not DICOM"),
    QT_TRANSLATE_NOOP("Reader", "%1 left out, unreadable (the first: %2)"),
    QT_TRANSLATE_NOOP("Reader", "%1 listed in the DICOMDIR missing"),
    QT_TRANSLATE_NOOP("Reader", "%1 left out, at positions that other slices have already"),
    QT_TRANSLATE_NOOP("Reader", "%1 of the series put into volumes of their own: %2"),
    QT_TRANSLATE_NOOP("Reader", "another size or pixel spacing"),
    QT_TRANSLATE_NOOP("Reader", "another orientation"),
    QT_TRANSLATE_NOOP("Reader", "another frame of reference, frame type or stack"),
    QT_TRANSLATE_NOOP(
        "Reader",
        "%1 slices have a Series UID each; they agree in study and kind and lie evenly, and are taken for one series"),
    QT_TRANSLATE_NOOP("Reader", "%1 left out: %2"),
    QT_TRANSLATE_NOOP("Reader", "the focus has no voxels in this volume"),
    QT_TRANSLATE_NOOP("Reader", "the volume %1 is not what it was when the session was saved"),
    QT_TRANSLATE_NOOP("Reader", "the label map %1 is not what it was when the session was saved"),
    QT_TRANSLATE_NOOP("Reader", "the volume was found at %1, no longer at %2"),
    QT_TRANSLATE_NOOP("Reader", "the label map was found at %1, no longer at %2"),
    QT_TRANSLATE_NOOP("Reader", "%1 (in %2 of %3 slices)"),
    QT_TRANSLATE_NOOP("Reader", "%1 file"),
    QT_TRANSLATE_NOOP("Reader", "%1 files"),
    QT_TRANSLATE_NOOP("Reader", "%1 slice"),
    QT_TRANSLATE_NOOP("Reader", "%1 slices"),
    QT_TRANSLATE_NOOP("Reader", "%1 plane"),
    QT_TRANSLATE_NOOP("Reader", "%1 planes"),
};

/// What has the form of a text, with a group for each place; a counted noun's place takes a number alone.
QRegularExpression formOf(const QString& text) {
  static const QRegularExpression place(QStringLiteral("\\\\?%\\d"));
  static const QRegularExpression counted(QStringLiteral("^%1 \\w+$"));
  QString form = QRegularExpression::escape(text);
  form.replace(place, counted.match(text).hasMatch() ? QStringLiteral("(\\d+)") : QStringLiteral("(.*)"));
  return QRegularExpression(QRegularExpression::anchoredPattern(form), QRegularExpression::DotMatchesEverythingOption);
}

const std::vector<QRegularExpression>& forms() {
  static const std::vector<QRegularExpression> all = [] {
    std::vector<QRegularExpression> made;
    for (const char* text : texts) made.push_back(formOf(QLatin1String(text)));
    return made;
  }();
  return all;
}

QString numberOf(QString text) {
  static const QRegularExpression decimal(QRegularExpression::anchoredPattern(QStringLiteral("-?\\d+\\.\\d+")));
  return decimal.match(text).hasMatch() ? text.replace(QLatin1Char('.'), QLocale().decimalPoint()) : text;
}

}  // namespace

std::span<const char* const> readerTexts() { return texts; }

QString readerText(const QString& text) {
  for (std::size_t i = 0; i < std::size(texts); ++i) {
    const QRegularExpressionMatch found = forms()[i].match(text);
    if (!found.hasMatch()) continue;
    const QString translated = QCoreApplication::translate("Reader", texts[i]);
    static const QRegularExpression place(QStringLiteral("%(\\d)"));
    QString filled;
    qsizetype at = 0;
    for (auto each = place.globalMatch(translated); each.hasNext();) {
      const QRegularExpressionMatch here = each.next();
      filled += translated.mid(at, here.capturedStart() - at) +
                numberOf(readerText(found.captured(here.captured(1).toInt())));
      at = here.capturedEnd();
    }
    return filled + translated.mid(at);
  }
  return text;
}

}  // namespace fenestra::viewer
