#include "ui/words/format_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace vybeg::ui {

namespace {

// libsndfile's words, for lupdate; readers of core/ mark theirs where they set them.
[[maybe_unused]] constexpr const char* words_of_libsndfile[] = {
    QT_TRANSLATE_NOOP("Format", "Signed 8 bit PCM"),
    QT_TRANSLATE_NOOP("Format", "Unsigned 8 bit PCM"),
    QT_TRANSLATE_NOOP("Format", "Signed 16 bit PCM"),
    QT_TRANSLATE_NOOP("Format", "Signed 24 bit PCM"),
    QT_TRANSLATE_NOOP("Format", "Signed 32 bit PCM")};

QString partText(const FormatPart& part) {
    const auto count = static_cast<int>(part.count);
    switch (part.kind) {
        case FormatPart::Kind::name: return QString::fromStdString(part.text);
        case FormatPart::Kind::words:
            return QCoreApplication::translate("Format", part.text.c_str());
        case FormatPart::Kind::channels:
            return QCoreApplication::translate("Format", "%n channel(s)", nullptr, count);
        case FormatPart::Kind::columns:
            return QCoreApplication::translate("Format", "%n column(s)", nullptr, count);
    }
    return {};
}

}  // namespace

QString formatText(const RecordingFormat& format) {
    QStringList parts;
    for (const FormatPart& part : format) {
        parts << partText(part);
    }
    return parts.join(QStringLiteral(", "));
}

}  // namespace vybeg::ui
