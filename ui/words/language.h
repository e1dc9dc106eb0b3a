#pragma once

#include <QLocale>
#include <QObject>
#include <QString>
#include <QTranslator>

#include <memory>

namespace vybeg::ui {

// The interface's language, switchable while the program runs: installs the translations of the
// program and of Qt's own texts, and sets the default locale. Every widget then receives
// QEvent::LanguageChange.
class Language : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    // "en" or "ru"; anything else counts as "en".
    void use(const QString& code);
    QString code() const { return code_; }

    // The language of the desktop where it is one of ours, else English.
    static QString ofTheSystem();

private:
    QString code_;
    std::unique_ptr<QTranslator> ours_;
    std::unique_ptr<QTranslator> qts_;
};

}  // namespace vybeg::ui
