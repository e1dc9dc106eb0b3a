#include "ui/session/session_view_json.h"

#include "ui/values/json_fields.h"

#include <QJsonArray>

#include <algorithm>
#include <array>

namespace vybeg::ui {

namespace {

const QString page_key = QStringLiteral("page");
const QString trend_key = QStringLiteral("trend");

// As TrendKind.
constexpr std::array<QLatin1String, trend_kinds> trend_words{
    QLatin1String("line"), QLatin1String("parabola"), QLatin1String("cubic"),
    QLatin1String("beat")};

TrendKind trendFromJson(const QJsonValue& value) {
    const auto found = std::ranges::find(trend_words, value.toString());
    return found == trend_words.end() ? TrendKind::line
                                      : static_cast<TrendKind>(found - trend_words.begin());
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

std::optional<SlowVariable> variableOf(const QString& column) {
    const auto found = std::ranges::find(all_slow_variables, column, columnOf);
    return found == all_slow_variables.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

QJsonObject viewToJson(const SessionView& view) {
    QJsonObject values;
    for (const auto& [variable, range] : view.zoom.fixed) {
        values[columnOf(variable)] = rangeToJson(range);
    }
    QJsonArray variables;
    for (const SlowVariable variable : view.variables) {
        variables.append(columnOf(variable));
    }
    QJsonArray cursors;
    for (const auto& cursor : view.cursors_s) {
        cursors.append(cursor ? QJsonValue(*cursor) : QJsonValue());
    }
    QJsonObject units;
    describe(JsonWriter(units), view.units);
    return {{QStringLiteral("time_s"), rangeToJson(view.zoom.time)},
            {QStringLiteral("values"), values},
            {QStringLiteral("variables"), variables},
            {QStringLiteral("cursors_s"), cursors},
            {page_key, view.page},
            {trend_key, trend_words.at(static_cast<std::size_t>(view.trend))},
            {QStringLiteral("units"), units}};
}

SessionView viewFromJson(const QJsonObject& json) {
    SessionView view;
    if (const auto time = rangeFromJson(json[QStringLiteral("time_s")])) {
        view.zoom.time = *time;
    }
    const QJsonObject values = json[QStringLiteral("values")].toObject();
    for (const SlowVariable variable : all_slow_variables) {
        if (const auto range = rangeFromJson(values[columnOf(variable)])) {
            view.zoom.fixed.emplace(variable, *range);
        }
    }
    for (const auto& value : json[QStringLiteral("variables")].toArray()) {
        if (const auto variable = variableOf(value.toString())) {
            view.variables.push_back(*variable);
        }
    }
    const QJsonArray cursors = json[QStringLiteral("cursors_s")].toArray();
    for (int which = 0; which < 2; ++which) {
        if (cursors.at(which).isDouble()) {
            view.cursors_s[static_cast<std::size_t>(which)] = cursors.at(which).toDouble();
        }
    }
    view.page = json[page_key].toString();
    view.trend = trendFromJson(json[trend_key]);
    const QJsonObject units = json[QStringLiteral("units")].toObject();
    describe(JsonReader(units), view.units);
    return view;
}

}  // namespace vybeg::ui
