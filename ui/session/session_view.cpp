#include "ui/session/session_view.h"

#include "ui/values/json_fields.h"

#include <QJsonArray>

#include <algorithm>

namespace vybeg::ui {

namespace {

// A view's ranges, variables and cursors.
const QString time_key = QStringLiteral("time_s");
const QString values_key = QStringLiteral("values");
const QString variables_key = QStringLiteral("variables");
const QString cursors_key = QStringLiteral("cursors_s");

template <class Archive, Described<SessionView> Owner>
void describe(Archive&& archive, Owner& view) {
    // As TrendKind.
    constexpr std::array<const char*, trend_kinds> trends{"line", "beat"};
    archive("page", view.page);
    archive.word("trend", view.trend, trends);
    archive("units", view.units);
}

QJsonArray rangeToJson(const AxisRange& range) {
    return {range.lower, range.upper};
}

std::optional<AxisRange> rangeFromJson(const QJsonValue& value) {
    const QJsonArray ends = value.toArray();
    const AxisRange range{ends.at(0).toDouble(), ends.at(1).toDouble()};
    return range.lower < range.upper ? std::optional(range) : std::nullopt;
}

QString columnOf(SlowVariable variable) {
    return QLatin1String(info(variable).column);
}

}  // namespace

void restoreView(const SessionView& view, TrackView& tracks) {
    if (!view.variables.empty()) {
        tracks.setShownVariables(view.variables);
    }
    tracks.setZoom(view.zoom);
    tracks.setCursor(Cursor::a, view.cursors_s[0]);
    tracks.setCursor(Cursor::b, view.cursors_s[1]);
}

QJsonObject viewToJson(const SessionView& view) {
    QJsonObject values;
    for (const auto& [variable, range] : view.zoom.fixed) {
        values[columnOf(variable)] = rangeToJson(range);
    }
    QJsonArray cursors;
    for (const auto& cursor : view.cursors_s) {
        cursors.append(cursor ? QJsonValue(*cursor) : QJsonValue());
    }
    QJsonObject json{{time_key, rangeToJson(view.zoom.time)},
                     {values_key, values},
                     {variables_key, listToJson(view.variables, columnOf)},
                     {cursors_key, cursors}};
    describe(JsonWriter(json), view);
    return json;
}

SessionView viewFromJson(const QJsonObject& json) {
    SessionView view;
    describe(JsonReader(json), view);
    if (const auto time = rangeFromJson(json[time_key])) {
        view.zoom.time = *time;
    }
    const QJsonObject values = json[values_key].toObject();
    for (const SlowVariable variable : all_slow_variables) {
        if (const auto range = rangeFromJson(values[columnOf(variable)])) {
            view.zoom.fixed.emplace(variable, *range);
        }
    }
    for (const auto& column : json[variables_key].toArray()) {
        const auto found = std::ranges::find(all_slow_variables, column.toString(), columnOf);
        if (found != all_slow_variables.end()) {
            view.variables.push_back(*found);
        }
    }
    const QJsonArray cursors = json[cursors_key].toArray();
    for (int which = 0; which < 2; ++which) {
        if (cursors.at(which).isDouble()) {
            view.cursors_s[static_cast<std::size_t>(which)] = cursors.at(which).toDouble();
        }
    }
    return view;
}

}  // namespace vybeg::ui
