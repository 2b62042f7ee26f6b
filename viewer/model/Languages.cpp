#include "viewer/model/Languages.h"

#include <span>

#include <QCoreApplication>
#include <QTranslator>

/// Registers the texts, which live in a static library. Q_INIT_RESOURCE works outside namespaces only.
static void registerTranslations() { Q_INIT_RESOURCE(translations); }

namespace fenestra::viewer {
namespace {

const QString spoken = QStringLiteral("language");

/// Installs the texts of a resource; false: there are none.
bool installTexts(const QString& name) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  translator->setObjectName(spoken);
  if (translator->load(QStringLiteral(":/translations/") + name) && QCoreApplication::installTranslator(translator))
    return true;
  delete translator;
  return false;
}

}  // namespace

std::string languageOf(const QStringList& desktop) {
  for (const QString& wanted : desktop) {
    const QLocale::Language language = QLocale(wanted).language();
    for (const Language& each : std::span(languages).subspan(1))
      if (QLocale(QLatin1String(each.code)).language() == language) return each.code;
  }
  return "en";
}

QLocale numbersOf(const std::string& code, const QLocale& desktop) {
  if (code == "en") return QLocale::c();
  QLocale locale(QString::fromStdString(code));
  if (desktop.language() == locale.language()) locale = desktop;
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  return locale;
}

void speak(const std::string& code) {
  registerTranslations();
  // A translator that is destroyed leaves the application.
  qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>(spoken, Qt::FindDirectChildrenOnly));
  const std::string chosen = code.empty() ? languageOf(QLocale::system().uiLanguages()) : code;
  // The system's own locale mixes languages where its variables differ; its name alone says the habits of one country.
  QLocale::setDefault(numbersOf(chosen, QLocale(QLocale::system().name())));
  if (chosen == "en") return;
  installTexts(QStringLiteral("qtbase_%1.qm").arg(QString::fromStdString(chosen)));
  installTexts(QStringLiteral("fenestra_%1.qm").arg(QString::fromStdString(chosen)));
}

}  // namespace fenestra::viewer
