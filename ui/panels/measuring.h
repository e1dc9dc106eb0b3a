#pragma once

#include "core/analysis/analysis.h"
#include "core/resonator/runs/mode_beat.h"
#include "core/track/trend.h"
#include "ui/document/document.h"
#include "ui/values/shown_analysis.h"
#include "ui/words/display_units.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

namespace vybeg::ui {

// A number in displayed units; NaN: none.
struct Reading {
    double value = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();
};

// Row of the window with the nearest centre. Precondition: the track is not empty.
std::size_t nearestRow(const Track& track, double time_s);

// What the readings fit between the cursors; their order in the list of choices.
enum class TrendKind { line, beat };
inline constexpr int trend_kinds = 2;

// The trend of one variable between two times, in stored units; a line through a_A is one through
// its logarithm, an exponential. A beat that is no damped sinusoid is that of two modes.
struct FittedTrend {
    SlowVariable variable = SlowVariable::a_A;
    std::variant<Trend, Beat, ModeBeat> fit;

    double at(double time_s) const;
};

TrendCurve curveOf(const Analysis& analysis, const FittedTrend& trend, double from_s, double to_s,
                   const DisplayUnits& units);

// What the trends of one kind say in a few words, for a cell: "τ 30.051(1) s, drift −11.3(6) °/h".
QString trendSummary(TrendKind kind, const std::vector<FittedTrend>& trends,
                     const DisplayUnits& units);

// Where the window reads the slow variables: at the mouse, at the cursors, between them.
enum class ReadAt { mouse, a, b, difference, rate };

// The instants that the window measures at, s, and the trend between the cursors.
struct Measuring {
    std::optional<double> mouse_s;
    std::optional<double> a_s;
    std::optional<double> b_s;
    TrendKind kind = TrendKind::line;

    bool both() const { return a_s && b_s; }
    friend bool operator==(const Measuring&, const Measuring&) = default;
};

// Whether a time lies where the analysis has windows.
bool isInside(const Analysis& analysis, const std::optional<double>& time_s);

// The trends between the cursors, kept while analysis, cursors and kind stay the same.
class MeasuredTrends {
public:
    // Of the visible analyses; of long ones, and beats, of the chosen one alone.
    void fit(const Document& document, const Measuring& measuring, AnalysisId chosen);
    // Of the main variables that have one; none without both cursors inside the analysis.
    const std::vector<FittedTrend>& of(AnalysisId id) const;

private:
    struct Entry {
        AnalysisId id = AnalysisId::none;
        std::shared_ptr<const Analysis> analysis;
        std::vector<FittedTrend> trends;
    };

    Measuring measured_;
    std::vector<Entry> entries_;
};

// Empty where the analysis has nothing there.
Reading readingOf(const Analysis& analysis, SlowVariable variable, ReadAt at,
                  const Measuring& measuring, const std::vector<FittedTrend>& trends,
                  const DisplayUnits& units);

// Why the window at a time has no value or a doubtful one; empty without reason.
QString reasonAt(const Analysis& analysis, double time_s);

// What the trend says in words, with the beat of the resonators identified from the analysis's
// recording.
QStringList measuredSentences(const Document& document, const AnalysisEntry& entry,
                              const Measuring& measuring, const std::vector<FittedTrend>& trends,
                              const DisplayUnits& units);

// Tables for a spreadsheet: tab-separated, numbers in displayed units with all digits and the
// decimal sign of the interface's language, standard deviations in columns of their own. Of all
// visible analyses at the mouse (or their first window); of one analysis at the cursors, empty
// without both inside it.
QString mouseTable(const Document& document, const Measuring& measuring, const DisplayUnits& units);
QString cursorTable(const ShownAnalysis& shown, const Measuring& measuring,
                    const std::vector<FittedTrend>& trends, const DisplayUnits& units);

}  // namespace vybeg::ui
