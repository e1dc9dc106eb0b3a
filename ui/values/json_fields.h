#pragma once

#include "core/base/result.h"
#include "core/base/setting_rows.h"
#include "core/recording/samples/open_options.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace vybeg::ui {

// Archives of describe(): the fields of a struct in a JSON object. A field that is missing there,
// or of another kind, keeps its value.
class JsonWriter {
public:
    explicit JsonWriter(QJsonObject& json) : json_(json) {}

    template <class T>
    void operator()(const char* name, const T& value) {
        if (const QJsonValue json = of(value); !json.isUndefined()) {
            json_[QLatin1String(name)] = json;
        }
    }
    template <class T>
    void operator()(const char* name, const T& value, const T& usual) {
        if (value != usual) {
            (*this)(name, value);
        }
    }
    // An enumerator by its name.
    template <class T, std::size_t count>
    void word(const char* name, T value, const std::array<const char*, count>& words) {
        json_[QLatin1String(name)] = QLatin1String(words.at(static_cast<std::size_t>(value)));
    }
    // By its number, up to `last`.
    template <class T>
    void number(const char* name, T value, T /*last*/) {
        json_[QLatin1String(name)] = static_cast<int>(value);
    }

private:
    static QJsonValue of(bool value) { return value; }
    static QJsonValue of(int value) { return value; }
    static QJsonValue of(std::int64_t value) { return static_cast<qint64>(value); }
    static QJsonValue of(double value) { return value; }
    static QJsonValue of(char value) { return QString(QLatin1Char(value)); }
    static QJsonValue of(const QString& value) { return value; }
    static QJsonValue of(const std::string& value) { return QString::fromStdString(value); }
    static QJsonValue of(const std::vector<std::string>& values) {
        QJsonArray array;
        for (const std::string& value : values) {
            array.append(of(value));
        }
        return array;
    }
    template <class T>
    static QJsonValue of(const std::optional<T>& value) {
        return value ? of(*value) : QJsonValue(QJsonValue::Undefined);
    }
    template <class T>
    requires std::is_class_v<T>
    static QJsonValue of(const T& value) {
        QJsonObject json;
        describe(JsonWriter(json), value);
        return json;
    }

    QJsonObject& json_;
};

class JsonReader {
public:
    explicit JsonReader(const QJsonObject& json) : json_(json) {}

    template <class T>
    void operator()(const char* name, T& value) {
        take(json_[QLatin1String(name)], value);
    }
    template <class T>
    void operator()(const char* name, T& value, const T& /*usual*/) {
        (*this)(name, value);
    }
    template <class T, std::size_t count>
    void word(const char* name, T& value, const std::array<const char*, count>& words) {
        const std::string word = json_[QLatin1String(name)].toString().toStdString();
        const auto found = std::ranges::find(words, std::string_view(word));
        value = found == words.end() ? value : static_cast<T>(found - words.begin());
    }
    template <class T>
    void number(const char* name, T& value, T last) {
        if (const QJsonValue json = json_[QLatin1String(name)]; json.isDouble()) {
            value = static_cast<T>(std::clamp(json.toInt(), 0, static_cast<int>(last)));
        }
    }

private:
    static void take(const QJsonValue& json, bool& value) { value = json.toBool(value); }
    static void take(const QJsonValue& json, int& value) { value = json.toInt(value); }
    static void take(const QJsonValue& json, std::int64_t& value) { value = json.toInteger(value); }
    static void take(const QJsonValue& json, double& value) { value = json.toDouble(value); }
    static void take(const QJsonValue& json, char& value) {
        if (const QString text = json.toString(); text.size() == 1) {
            value = text[0].toLatin1();
        }
    }
    static void take(const QJsonValue& json, QString& value) { value = json.toString(value); }
    static void take(const QJsonValue& json, std::string& value) {
        value = json.toString(QString::fromStdString(value)).toStdString();
    }
    static void take(const QJsonValue& json, std::vector<std::string>& values) {
        for (const auto& each : json.toArray()) {
            values.push_back(each.toString().toStdString());
        }
    }
    template <class T>
    static void take(const QJsonValue& json, std::optional<T>& value) {
        T read{};
        if (hasKind(json, read)) {
            take(json, read);
            value = std::move(read);
        }
    }
    template <class T>
    requires std::is_class_v<T>
    static void take(const QJsonValue& json, T& value) {
        const QJsonObject object = json.toObject();
        describe(JsonReader(object), value);
    }

    template <class T>
    static bool hasKind(const QJsonValue& json, const T& /*of*/) {
        if constexpr (std::is_same_v<T, bool>) {
            return json.isBool();
        } else if constexpr (std::is_same_v<T, char>) {
            return json.toString().size() == 1;
        } else if constexpr (std::is_arithmetic_v<T>) {
            return json.isDouble();
        } else {
            return json.isObject();
        }
    }

    const QJsonObject& json_;
};

// The settings that have a part in the result and differ from their defaults, by their names on the
// command line.
template <class S>
QJsonObject settingsToJson(const std::vector<SettingRow<S>>& rows, const S& settings) {
    const S defaults{};
    QJsonObject json;
    for (const SettingRow<S>& row : rows) {
        const std::string text = row.text(settings);
        if (row.has_part && text != row.text(defaults)) {
            json[QString::fromStdString(row.name)] = QString::fromStdString(text);
        }
    }
    return json;
}

// The reverse; missing settings keep their defaults. Errors: setting_invalid.
template <class S>
Result<S> settingsFromJson(const std::vector<SettingRow<S>>& rows, const QJsonObject& json) {
    S settings{};
    for (const SettingRow<S>& row : rows) {
        const QJsonValue value = json[QString::fromStdString(row.name)];
        if (row.has_part && value.isString()) {
            TRY(row.read(value.toString().toStdString(), settings));
        }
    }
    return settings;
}

// Options of opening; unset ones are omitted.
inline QJsonObject optionsToJson(const OpenOptions& options) {
    QJsonObject json;
    describe(JsonWriter(json), options);
    return json;
}

// The reverse; missing values and values of another type remain unset.
inline OpenOptions optionsFromJson(const QJsonObject& json) {
    OpenOptions options;
    describe(JsonReader(json), options);
    // Earlier versions kept the scale with the layout or the choice.
    for (const char* part : {"raw", "text"}) {
        options.scale *= json[QLatin1String(part)].toObject()[QStringLiteral("scale")].toDouble(1);
    }
    return options;
}

inline QJsonObject without(QJsonObject json, const QStringList& keys) {
    for (const QString& key : keys) {
        json.remove(key);
    }
    return json;
}

// A list, each of its values by a function; the reverse ends with the first error of one.
template <class Each, class ToJson, class... Args>
QJsonArray listToJson(const std::vector<Each>& all, const ToJson& to_json, const Args&... args) {
    QJsonArray list;
    for (const Each& each : all) {
        list.append(to_json(each, args...));
    }
    return list;
}

template <class Each, class FromJson, class... Args>
Status readList(const QJsonValue& list, std::vector<Each>& all, const FromJson& from_json,
                const Args&... args) {
    for (const auto& value : list.toArray()) {
        auto each = TRY(from_json(value.toObject(), args...));
        all.push_back(std::move(each));
    }
    return {};
}

}  // namespace vybeg::ui
