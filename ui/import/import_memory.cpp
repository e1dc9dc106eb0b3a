#include "ui/import/import_memory.h"

#include "ui/values/json_fields.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSettings>
#include <QStringList>

namespace vybeg::ui {

namespace {

constexpr qsizetype most_kinds = 50;
const QString imports_key = QStringLiteral("imports");
const QString kind_key = QStringLiteral("kind");
const QString options_key = QStringLiteral("options");

QJsonArray imports() {
    return QJsonDocument::fromJson(QSettings().value(imports_key).toByteArray()).array();
}

}  // namespace

QJsonObject optionsToJson(const OpenOptions& options) {
    QJsonObject json;
    describe(JsonWriter(json), options);
    return json;
}

OpenOptions optionsFromJson(const QJsonObject& json) {
    OpenOptions options;
    describe(JsonReader(json), options);
    // Earlier versions kept the scale with the layout or the choice.
    for (const char* part : {"raw", "text"}) {
        options.scale *= json[QLatin1String(part)].toObject()[QStringLiteral("scale")].toDouble(1);
    }
    return options;
}

QString importKind(const QString& path, const RecordingPreview& preview, bool raw) {
    const QString ending = QFileInfo(path).suffix().toLower();
    if (raw) {
        return QStringLiteral("raw;%1").arg(ending);
    }
    if (!preview.guessed) {
        return QStringLiteral("file;%1").arg(ending);
    }
    QStringList words{QStringLiteral("text"), ending, QString::number(preview.guessed->columns)};
    for (const Channel& heading : preview.guessed->headings) {
        words << QString::fromStdString(heading.name);
    }
    return words.join(QLatin1Char(';'));
}

std::optional<OpenOptions> rememberedImport(const QString& kind) {
    for (const QJsonValue& each : imports()) {
        if (each[kind_key].toString() == kind) {
            return optionsFromJson(each[options_key].toObject());
        }
    }
    return {};
}

void rememberImport(const QString& kind, const OpenOptions& options) {
    QJsonArray kept{QJsonObject{{kind_key, kind}, {options_key, optionsToJson(options)}}};
    for (const QJsonValue& each : imports()) {
        if (each[kind_key].toString() != kind && kept.size() < most_kinds) {
            kept.append(each);
        }
    }
    QSettings().setValue(imports_key, QJsonDocument(kept).toJson(QJsonDocument::Compact));
}

}  // namespace vybeg::ui
