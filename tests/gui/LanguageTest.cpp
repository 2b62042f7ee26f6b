// The translated texts: each file is what lupdate makes of the sources, whole, and keeps what a program puts in.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include "io/TransferFunctionFile.h"
#include "io/study/ReadStudy.h"
#include "rendering/scene/Lighting.h"
#include "rendering/settings/Settings.h"
#include "tests/gui/Patience.h"
#include "viewer/model/Languages.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/Preferences.h"
#include "viewer/model/ReaderText.h"
#include "viewer/model/Translation.h"
#include "viewer/model/WayOutText.h"

namespace fenestra::viewer::languageTest {
namespace {

struct Message {
  QString context, source;
  QStringList translations;  ///< one, or all plural forms
  bool isPlural = false, isFinished = true;
};

std::vector<Message> messagesOf(const QString& file) {
  QFile opened(file);
  EXPECT_TRUE(opened.open(QIODevice::ReadOnly)) << file.toStdString();
  QXmlStreamReader xml(&opened);
  std::vector<Message> messages;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("message"))
      messages.push_back({context, {}, {}, xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes")});
    if (messages.empty()) continue;
    Message& message = messages.back();
    if (xml.name() == QLatin1String("source")) message.source = xml.readElementText();
    if (xml.name() == QLatin1String("translation")) {
      message.isFinished = !xml.attributes().hasAttribute(QLatin1String("type"));
      if (!message.isPlural) message.translations << xml.readElementText();
    }
    if (xml.name() == QLatin1String("numerusform")) message.translations << xml.readElementText();
  }
  EXPECT_FALSE(xml.hasError()) << file.toStdString() << ": " << xml.errorString().toStdString();
  return messages;
}

QString fileOf(const Language& language) {
  return QStringLiteral(FENESTRA_SOURCE_DIR "/resources/translations/fenestra_%1.ts").arg(QLatin1String(language.code));
}

std::span<const Language> translatedLanguages() { return std::span(languages).subspan(2); }

/// %1, %2, %n of a text, each as often as it stands there. %L1 is %1, written as the language writes numbers.
std::multiset<QString> placesIn(const QString& text) {
  static const QRegularExpression place(QStringLiteral("%L?(\\d+|n)"));
  std::multiset<QString> places;
  for (auto found = place.globalMatch(text); found.hasNext();) places.insert(found.next().captured(1));
  return places;
}

bool hasMnemonic(const QString& text) { return text.contains(QRegularExpression(QStringLiteral("&[^&\\s]"))); }

/// What is wrong with a translation; empty: nothing.
QString flawOf(const Message& message, const QString& text) {
  const QString& source = message.source;
  const auto edges = [](const QString& all) {
    const QString inner = all.trimmed();
    return std::pair(all.indexOf(inner), all.size() - all.indexOf(inner) - inner.size());
  };
  static const QRegularExpression tag(QStringLiteral("</?\\w+>"));
  if (text.trimmed().isEmpty() != source.trimmed().isEmpty()) return QStringLiteral("empty");
  // One "%n" may be left out of the form for one thing alone.
  if (placesIn(text) != placesIn(source)) return QStringLiteral("other places to fill in");
  if (edges(text) != edges(source)) return QStringLiteral("other spaces at its ends");
  if (text.trimmed().endsWith(QChar(0x2026)) != source.trimmed().endsWith(QChar(0x2026)))
    return QStringLiteral("an ellipsis more or less");
  // In a long menu the letters of a language may all be taken: then an entry goes without.
  if (hasMnemonic(text) && !hasMnemonic(source)) return QStringLiteral("a mnemonic more");
  if (text.count(tag) != source.count(tag)) return QStringLiteral("other tags");
  if (text.count(QLatin1Char('\n')) != source.count(QLatin1Char('\n'))) return QStringLiteral("other lines");
  if (source.contains(QLatin1String(";;")) && text.section(QLatin1Char('('), 1) == QString())
    return QStringLiteral("no patterns of files");
  return {};
}

TEST(Languages, TranslationsKeepWhatTheProgramPutsIn) {
  for (const Language& language : translatedLanguages()) {
    SCOPED_TRACE(language.name);
    const std::vector<Message> messages = messagesOf(fileOf(language));
    EXPECT_GT(messages.size(), 1000u);
    for (const Message& message : messages) {
      if (!message.isFinished) continue;  // shows in English
      const qsizetype forms = message.isPlural && QLatin1String(language.code) != QLatin1String("zh_CN") ? 2 : 1;
      EXPECT_EQ(message.translations.size(), forms) << message.source.toStdString();
      for (const QString& text : message.translations)
        EXPECT_EQ(flawOf(message, text).toStdString(), "")
            << message.context.toStdString() << ": \"" << message.source.toStdString() << "\" is \""
            << text.toStdString() << '"';
    }
  }
}

TEST(Languages, TheTestOfTranslationsNoticesFlaws) {
  const auto flaw = [](const char* source, const char* text) {
    return !flawOf({{}, QString::fromUtf8(source), {}}, QString::fromUtf8(text)).isEmpty();
  };
  EXPECT_FALSE(flaw("&Open %1…", "%L1 &öffnen…"));
  EXPECT_TRUE(flaw("Open %1", "Öffnen"));
  EXPECT_TRUE(flaw("Open %1", "%2 öffnen"));
  EXPECT_TRUE(flaw("Open…", "Öffnen"));
  EXPECT_TRUE(flaw("Open", "&Öffnen"));
  EXPECT_TRUE(flaw(" mm", "mm"));
  EXPECT_TRUE(flaw("Open", ""));
  EXPECT_TRUE(flaw("<b>Open</b>", "Öffnen"));
}

/// What packaging/translations makes of the sources now.
class UpToDate : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    QProcess script;
    script.setProcessChannelMode(QProcess::MergedChannels);
    script.start(QStringLiteral(FENESTRA_SOURCE_DIR "/packaging/translations"),
                 {QStringLiteral("--into"), folder().path()});
    ASSERT_TRUE(script.waitForFinished(patience));
    output() = QString::fromUtf8(script.readAll());
    ASSERT_EQ(script.exitCode(), 0) << output().toStdString();
  }
  static QTemporaryDir& folder() {
    static QTemporaryDir made;
    return made;
  }
  static QString& output() {
    static QString kept;
    return kept;
  }
  static std::vector<Message> messages(const Language& language) {
    return messagesOf(folder().filePath(QStringLiteral("fenestra_%1.ts").arg(QLatin1String(language.code))));
  }
};

/// Whoever adds a text need not know four languages: a text without translation shows in English. More than a
/// twentieth of them would be a window in two languages.
TEST_F(UpToDate, NearlyAllTextsAreTranslated) {
  for (const Language& language : translatedLanguages()) {
    const std::vector<Message> all = messages(language);
    const auto open = std::count_if(all.begin(), all.end(), [](const Message& message) { return !message.isFinished; });
    EXPECT_LE(20 * open, static_cast<std::ptrdiff_t>(all.size())) << language.name;
  }
  std::cout << output().toStdString();
}

/// All texts of tables that are translated when they show, without those that tr() holds.
std::set<std::string> tableTexts() {
  std::set<std::string> texts;
  const auto add = [&](const std::string& text) {
    if (QString::fromStdString(text).contains(QRegularExpression(QStringLiteral("\\p{L}{2}")))) texts.insert(text);
  };
  const auto addWords = [&](const auto& words) {
    for (const auto& word : words) {
      add(std::string(word.name));
      add(std::string(word.description));
    }
  };
  const auto addSettings = [&]<class Owner>(const Owner&) {
    forEachSetting<Owner>([&](const auto& setting) {
      add(setting.name);
      add(setting.description);
      add(setting.unit);
    });
  };
  addSettings(Cutaway{});
  addSettings(ContextLayer{});
  addSettings(Shading{});
  addSettings(FocusAppearance{});
  addSettings(ValueFocus{});
  addSettings(ContextFunction{});
  addSettings(Look{});
  addSettings(BrushStroke{});
  addSettings(Method{});
  forEachMethod([&]<class M>() { addSettings(M{}); });
  addWords(wordsOf(MethodKind{}));
  addWords(wordsOf(WidthUnit{}));
  addWords(wordsOf(RemovalShape{}));
  addWords(wordsOf(BrushMode{}));
  addWords(wordsOf(LabelRole{}));
  addWords(wordsOf(Reconstruction{}));
  addWords(wordsOf(Backdrop{}));
  addWords(wordsOf(LabelSmoothing{}));
  addWords(wordsOf(Edges{}));
  for (const LightPreset& preset : lightPresets()) {
    add(std::string(preset.name));
    add(std::string(preset.description));
  }
  for (const OpeningLook& look : openingLooks()) add(std::string(look.name));
  for (const io::TransferFunctionPreset& preset : io::transferFunctionPresets()) add(std::string(preset.name));
  for (const PreferenceEntry& entry : preferenceTable()) {
    add(entry.name);
    add(entry.description);
    add(entry.unit);
  }
  return texts;
}

TEST_F(UpToDate, TextsOfTablesAreFound) {
  std::set<std::string> found;
  for (const Message& message : messages(translatedLanguages().front()))
    if (message.context == QLatin1String("Settings")) found.insert(message.source.toStdString());
  const std::set<std::string> texts = tableTexts();
  EXPECT_GT(texts.size(), 200u);
  for (const std::string& text : texts)
    EXPECT_TRUE(found.contains(text)) << "packaging/translations does not find \"" << text << '"';
}

/// Whether a source has a literal of the text, which may be written in several pieces.
bool isWrittenIn(const QString& source, const QString& text) {
  static const QRegularExpression seam(QStringLiteral("\"\\s*\\+?\\s*(std::string\\()?\""));
  return QString(source).remove(seam).contains(text);
}

TEST(ReaderTexts, AreWhatReadersSay) {
  QStringList sources;
  for (const char* folder : {"io", "rendering"}) {
    QDirIterator files(QStringLiteral(FENESTRA_SOURCE_DIR "/") + QLatin1String(folder), {QStringLiteral("*.cpp")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      ASSERT_TRUE(file.open(QIODevice::ReadOnly));
      sources << QString::fromUtf8(file.readAll());
    }
  }
  int looked = 0;
  for (const char* each : readerTexts()) {
    const QString text = QLatin1String(each);
    if (text.contains(QLatin1Char('%')))
      continue;  // its pieces stand apart; WhatReadersSayIsTranslatedWithWhatStandsInIt has the longest
    ++looked;
    EXPECT_TRUE(std::any_of(sources.begin(), sources.end(), [&](const QString& source) {
      return isWrittenIn(source, text);
    })) << each;
  }
  EXPECT_GT(looked, 10);
}

class Spoken : public testing::TestWithParam<Language> {
 protected:
  void SetUp() override { speak(GetParam().code); }
  void TearDown() override { speak("en"); }
};

TEST_P(Spoken, TextsAreTranslatedWhereTheWindowAsksForThem) {
  EXPECT_NE(translated(settingOf(&Cutaway::borderColour).name), QStringLiteral("Border colour"));
  EXPECT_NE(QCoreApplication::translate("fenestra::viewer::Actions", "&File"), QStringLiteral("&File"));
  EXPECT_NE(windowWords(io::WayOut::OmitData), QStringLiteral("open it without files"));
}

TEST_P(Spoken, WhatReadersSayIsTranslatedWithWhatStandsInIt) {
  const bool isChinese = GetParam().code == std::string("zh_CN");
  const auto says = [](const char* text, const QStringList& kept, const QStringList& gone) {
    const QString said = readerText(QLatin1String(text));
    for (const QString& each : kept) EXPECT_TRUE(said.contains(each)) << said.toStdString();
    for (const QString& each : gone) EXPECT_FALSE(said.contains(each)) << said.toStdString();
  };
  says(io::tableWarning().text.c_str(), {}, {QStringLiteral("scanner's"), QStringLiteral("slices")});
  says("2 slices missing: neighbours lie 1.25 mm apart, but up to 3.75 mm between the files named",
       {isChinese ? QStringLiteral("1.25 mm") : QStringLiteral("1,25 mm"), QStringLiteral("2 ")},
       {QStringLiteral("slices"), QStringLiteral("%")});
  says("12 files left out, unreadable (the first: a %1 b.dcm: is cut off)",
       {QStringLiteral("12 "), QStringLiteral("a %1 b.dcm: is cut off")},
       {QStringLiteral("files"), QStringLiteral("left")});
  says(
      "linear interpolation places the slices on 24 planes 2.5 mm apart, sheared as they were scanned, displaced by up "
      "to 0.5 mm (evenly spread they would lie up to 4 mm from their places); 1 plane in gaps wider than 3 mm is "
      "interpolated across the gap; 3.1 % of the voxels lie outside of what was scanned and hold the least value, "
      "-1024 HU",
      {QStringLiteral("24 "), QStringLiteral("-1024 HU")},
      {QStringLiteral("linear interpolation"), QStringLiteral("scanned"), QStringLiteral("displaced"),
       QStringLiteral("evenly"), QStringLiteral("across"), QStringLiteral("outside")});
  EXPECT_EQ(readerText(QStringLiteral("a text that no reader has")), QStringLiteral("a text that no reader has"));
}

TEST_P(Spoken, PluralsFollowTheNumber) {
  const auto views = [](int count) {
    return QCoreApplication::translate("fenestra::viewer::PlacementForm", "%n views", nullptr, count);
  };
  EXPECT_TRUE(views(1).startsWith(QLatin1String("1 "))) << views(1).toStdString();
  EXPECT_TRUE(views(192).startsWith(QLatin1String("192 "))) << views(192).toStdString();
  const bool isChinese = GetParam().code == std::string("zh_CN");
  EXPECT_EQ(views(1).mid(2) == views(192).mid(4), isChinese);
}

TEST_P(Spoken, NumbersHaveThePointOfTheLanguage) {
  const QChar point = GetParam().code == std::string("zh_CN") ? QLatin1Char('.') : QLatin1Char(',');
  EXPECT_EQ(numberText(1234.5, 1), QStringLiteral("1234") + point + QLatin1Char('5'));
  EXPECT_EQ(volumeText(12.34), QStringLiteral("12") + point + QStringLiteral("3 ml"));
  // A point among digits that would stand between thousands is no number.
  bool isNumber = true;
  if (point == QLatin1Char(',')) {
    QLocale().toDouble(QStringLiteral("1.234"), &isNumber);
    EXPECT_FALSE(isNumber);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Spoken, testing::ValuesIn(translatedLanguages().begin(), translatedLanguages().end()),
                         [](const auto& info) { return std::string(info.param.code); });

TEST(Languages, TheDesktopsFirstKnownLanguageCounts) {
  EXPECT_EQ(languageOf({QStringLiteral("de-AT"), QStringLiteral("en")}), "de");
  EXPECT_EQ(languageOf({QStringLiteral("pt-BR"), QStringLiteral("es-MX"), QStringLiteral("en")}), "es");
  EXPECT_EQ(languageOf({QStringLiteral("en-GB"), QStringLiteral("de")}), "en");
  EXPECT_EQ(languageOf({QStringLiteral("zh-Hans-CN")}), "zh_CN");
  EXPECT_EQ(languageOf({QStringLiteral("pl")}), "en");
  EXPECT_EQ(languageOf({}), "en");
}

TEST(Languages, NumbersAreThoseOfTheUsersCountry) {
  EXPECT_EQ(numbersOf("es", QLocale(QStringLiteral("es_MX"))).toString(0.5), "0.5");
  EXPECT_EQ(numbersOf("es", QLocale(QStringLiteral("de_DE"))).toString(0.5), "0,5");
  EXPECT_EQ(numbersOf("en", QLocale(QStringLiteral("de_DE"))).toString(1234.5), "1234.5");
}

}  // namespace
}  // namespace fenestra::viewer::languageTest
