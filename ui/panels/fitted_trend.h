#pragma once

#include "core/analysis/analysis.h"
#include "core/track/trend.h"
#include "ui/panels/reading.h"
#include "ui/values/shown_analysis.h"
#include "ui/words/display_units.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <variant>
#include <vector>

namespace vybeg::ui {

// What the readings fit between the cursors; their order in the list of choices.
enum class TrendKind { line, parabola, cubic, beat };
inline constexpr int trend_kinds = 4;

// The trend of one variable between two times, in stored units; a line through a_A is one through
// its logarithm, an exponential.
struct FittedTrend {
    SlowVariable variable = SlowVariable::a_A;
    std::variant<Trend, PolynomialTrend, Beat> fit;

    double at(double time_s) const;
};

// Nothing where the windows between the times do not determine it.
std::optional<FittedTrend> fitTrend(const Analysis& analysis, SlowVariable variable, TrendKind kind,
                                    double from_s, double to_s);

// Of a beat its frequency, Hz; of the others the rate per second at the middle.
Reading trendReading(const Analysis& analysis, const FittedTrend& trend, const DisplayUnits& units);

TrendCurve curveOf(const Analysis& analysis, const FittedTrend& trend, double from_s, double to_s,
                   const DisplayUnits& units);

// What the trends of one kind say in words, a sentence each.
QStringList trendSentences(const Analysis& analysis, TrendKind kind,
                           const std::vector<FittedTrend>& trends, const DisplayUnits& units);

// The same in a few words, for a cell: "τ 30.051(1) s, drift −11.3(6) °/h".
QString trendSummary(TrendKind kind, const std::vector<FittedTrend>& trends,
                     const DisplayUnits& units);

}  // namespace vybeg::ui
