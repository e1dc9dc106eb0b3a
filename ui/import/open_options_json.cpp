#include "ui/import/open_options_json.h"

#include <QJsonArray>

#include <algorithm>

namespace vybeg::ui {

namespace {

const QString raw_types[] = {QStringLiteral("i16"), QStringLiteral("i32"), QStringLiteral("f32"),
                             QStringLiteral("f64")};

void put(QJsonObject& json, const char* name, const std::optional<double>& value) {
    if (value) {
        json[QLatin1String(name)] = *value;
    }
}

std::optional<double> number(const QJsonObject& json, const char* name) {
    const QJsonValue value = json[QLatin1String(name)];
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

QJsonObject textToJson(const TextChoice& text) {
    QJsonObject json;
    if (text.delimiter) {
        json[QStringLiteral("delimiter")] = QString(QLatin1Char(*text.delimiter));
    }
    if (text.decimal_comma) {
        json[QStringLiteral("decimal_comma")] = *text.decimal_comma;
    }
    if (text.lines_to_skip) {
        put(json, "lines_to_skip", static_cast<double>(*text.lines_to_skip));
    }
    if (text.time_column) {
        put(json, "time_column", *text.time_column);
    }
    put(json, "time_unit_s", text.time_unit_s);
    return json;
}

TextChoice textFromJson(const QJsonObject& json) {
    TextChoice text;
    const QString delimiter = json[QStringLiteral("delimiter")].toString();
    if (delimiter.size() == 1) {
        text.delimiter = delimiter[0].toLatin1();
    }
    const QJsonValue comma = json[QStringLiteral("decimal_comma")];
    if (comma.isBool()) {
        text.decimal_comma = comma.toBool();
    }
    if (const auto lines = number(json, "lines_to_skip")) {
        text.lines_to_skip = static_cast<std::int64_t>(*lines);
    }
    if (const auto column = number(json, "time_column")) {
        text.time_column = static_cast<int>(*column);
    }
    text.time_unit_s = number(json, "time_unit_s");
    return text;
}

QJsonObject rawToJson(const RawLayout& raw) {
    return {{QStringLiteral("type"), raw_types[static_cast<int>(raw.type)]},
            {QStringLiteral("big_endian"), raw.big_endian},
            {QStringLiteral("channels"), raw.channels},
            {QStringLiteral("skip_bytes"), static_cast<double>(raw.skip_bytes)}};
}

RawLayout rawFromJson(const QJsonObject& json) {
    RawLayout raw;
    const auto* const type = std::ranges::find(raw_types, json[QStringLiteral("type")].toString());
    raw.type = type == std::end(raw_types) ? RawType::i16
                                           : static_cast<RawType>(type - std::begin(raw_types));
    raw.big_endian = json[QStringLiteral("big_endian")].toBool();
    raw.channels = json[QStringLiteral("channels")].toInt(2);
    raw.skip_bytes = static_cast<std::int64_t>(number(json, "skip_bytes").value_or(0));
    return raw;
}

// Earlier versions kept it with the layout or the choice.
double scaleFromJson(const QJsonObject& json) {
    double scale = number(json, "scale").value_or(1);
    for (const char* part : {"raw", "text"}) {
        scale *= number(json[QLatin1String(part)].toObject(), "scale").value_or(1);
    }
    return scale;
}

}  // namespace

QJsonObject optionsToJson(const OpenOptions& options) {
    QJsonObject json{{QStringLiteral("channel_c"), options.channel_c},
                     {QStringLiteral("channel_d"), options.channel_d}};
    put(json, "rate_hz", options.rate_hz);
    if (options.scale != 1) {
        put(json, "scale", options.scale);
    }
    if (options.raw) {
        json[QStringLiteral("raw")] = rawToJson(*options.raw);
    }
    if (options.text) {
        json[QStringLiteral("text")] = textToJson(*options.text);
    }
    if (!options.variables.empty()) {
        QJsonArray names;
        for (const std::string& name : options.variables) {
            names.append(QString::fromStdString(name));
        }
        json[QStringLiteral("variables")] = names;
    }
    if (!options.unit.empty()) {
        json[QStringLiteral("unit")] = QString::fromStdString(options.unit);
    }
    return json;
}

OpenOptions optionsFromJson(const QJsonObject& json) {
    OpenOptions options;
    options.rate_hz = number(json, "rate_hz");
    options.channel_c = json[QStringLiteral("channel_c")].toInt(1);
    options.channel_d = json[QStringLiteral("channel_d")].toInt(2);
    options.scale = scaleFromJson(json);
    if (json[QStringLiteral("raw")].isObject()) {
        options.raw = rawFromJson(json[QStringLiteral("raw")].toObject());
    }
    if (json[QStringLiteral("text")].isObject()) {
        options.text = textFromJson(json[QStringLiteral("text")].toObject());
    }
    for (const auto& name : json[QStringLiteral("variables")].toArray()) {
        options.variables.push_back(name.toString().toStdString());
    }
    options.unit = json[QStringLiteral("unit")].toString().toStdString();
    return options;
}

}  // namespace vybeg::ui
