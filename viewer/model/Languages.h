#pragma once
// The languages of the window: which there are, which one the desktop asks for, and how one is put to use.

#include <array>
#include <string>

#include <QLocale>
#include <QStringList>

namespace fenestra::viewer {

struct Language {
  const char* code;  ///< of the file of its texts, as "zh_CN"; empty: the desktop's
  const char* name;  ///< in the language itself
};

/// The desktop's first, then English, whose texts are those of the sources, then those that are translated. Settings
/// remember a place in this list: new ones come at its end.
inline constexpr std::array languages{Language{"", QT_TRANSLATE_NOOP("Settings", "As the desktop")},
                                      Language{"en", "English"},
                                      Language{"de", "Deutsch"},
                                      Language{"es", "Español"},
                                      Language{"fr", "Français"},
                                      Language{"zh_CN", "中文"}};

/// The first of the desktop's languages ("de-AT", "fr", as QLocale::uiLanguages() has them) that the window has, else
/// "en". All Chinese is "zh_CN": there is one file of it.
std::string languageOf(const QStringList& desktop);

/// How `code` writes numbers: without groups of digits, because a point between thousands would read as another number
/// to those who are used to a decimal point. English keeps the C locale; a language of the desktop its country's
/// habits.
QLocale numbersOf(const std::string& code, const QLocale& desktop);

/// Makes `code`, or the desktop's language where it is empty, the language of all texts and numbers of the application
/// from here on. Texts that were set before stay as they are, so it is called before there are widgets. Qt's own texts
/// come along where Qt's translations were there when this was built.
void speak(const std::string& code);

}  // namespace fenestra::viewer
