#include "ui/words/number_label.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>
#include <cmath>

namespace vybeg::ui {

QString groupedDigits(const QString& number) {
    constexpr qsizetype group = 3;
    constexpr qsizetype undivided = 4;
    QString text;
    bool fraction = false;
    for (qsizetype begin = 0, end = 0; begin < number.size(); begin = end) {
        while (end < number.size() && number[end].isDigit()) {
            ++end;
        }
        const qsizetype digits = end - begin;
        for (qsizetype k = 0; k < digits; ++k) {
            if (k > 0 && digits > undivided && (fraction ? k : digits - k) % group == 0) {
                text += QChar(0x202f);
            }
            text += number[begin + k];
        }
        if (end < number.size()) {
            fraction = number[end] == '.' || number[end] == ',';
            text += number[end++];
        }
    }
    return text;
}

QString numberLabel(double value, int decimals) {
    // What rounds to zero is zero, not minus zero.
    const double shown = std::abs(value) < 0.5 * std::pow(10., -decimals) ? 0 : value;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return groupedDigits(locale.toString(shown, 'f', decimals)).replace('-', QChar(0x2212));
}

QString countLabel(std::int64_t count) {
    return numberLabel(static_cast<double>(count), 0);
}

QString powerOfTen(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = QStringLiteral("10");
    for (const QChar c : QString::number(exponent)) {
        text += c == '-' ? QChar(0x207b) : digits[c.digitValue()];
    }
    return text;
}

QString siPrefix(int exponent) {
    static constexpr std::array<const char*, 10> prefixes{
        QT_TRANSLATE_NOOP("SiPrefix", "f"), QT_TRANSLATE_NOOP("SiPrefix", "p"),
        QT_TRANSLATE_NOOP("SiPrefix", "n"), QT_TRANSLATE_NOOP("SiPrefix", "µ"),
        QT_TRANSLATE_NOOP("SiPrefix", "m"), "",
        QT_TRANSLATE_NOOP("SiPrefix", "k"), QT_TRANSLATE_NOOP("SiPrefix", "M"),
        QT_TRANSLATE_NOOP("SiPrefix", "G"), QT_TRANSLATE_NOOP("SiPrefix", "T")};
    const int place = exponent / 3 + 5;
    const char* prefix = prefixes[static_cast<std::size_t>(place)];
    return *prefix ? QCoreApplication::translate("SiPrefix", prefix) : QString();
}

}  // namespace vybeg::ui
