#include "ui/words/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>

namespace vybeg::ui {

QString Language::ofTheSystem() {
    return QLocale::system().language() == QLocale::Russian ? QStringLiteral("ru")
                                                            : QStringLiteral("en");
}

void Language::use(const QString& code) {
    code_ = code == QLatin1String("ru") ? code : QStringLiteral("en");
    QLocale locale = code_ == QLatin1String("ru")
                         ? QLocale(QLocale::Russian, QLocale::Russia)
                         : QLocale(QLocale::English, QLocale::UnitedStates);
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    // Installing and removing a translator notifies every widget: the locale must be in place
    // before.
    QLocale::setDefault(locale);
    ours_.reset();
    qts_.reset();
    qts_ = std::make_unique<QTranslator>();
    if (qts_->load(QStringLiteral("qtbase_") + code_,
                   QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(qts_.get());
    }
    ours_ = std::make_unique<QTranslator>();
    if (ours_->load(QStringLiteral(":/i18n/vybeg_") + code_)) {
        QCoreApplication::installTranslator(ours_.get());
    }
}

}  // namespace vybeg::ui

#include "moc_language.cpp"
