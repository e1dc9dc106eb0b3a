#pragma once

#include "core/analysis/passport.h"
#include "core/database/results_database.h"
#include "core/numerics/control_chart.h"
#include "core/numerics/statistics.h"
#include "core/resonator/results/resonator_parameters.h"
#include "ui/plots/xy_plot.h"
#include "ui/resonator/parameter_text.h"
#include "ui/words/display_units.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vybeg::ui {

// The results of a database for one parameter.
struct StoredHistory {
    std::vector<StoredGyro> gyros;
    std::vector<HistoryPoint> points;  // of one gyro or of all, by date; those without one last
    QDateTime written;                 // when its file was, at the latest
};

// A parameter that has a history, with the period of an axis (resonator_parameters.h).
struct HistoryParameter {
    std::string name;
    const char* unit = "";
    double period = 0;
    std::function<const Estimate*(const Passport&)> in;  // null: a passport has none
};

// Those of the resonator, then those of its two modes.
const std::vector<HistoryParameter>& historyParameters();

// The history as numbers, a place for each point, in the units of the database.
struct HistoryCharts {
    std::vector<double> values;  // NaN: the result has none
    std::vector<double> u;       // sd, where there is no u
    bool one_gyro = false;
    // Of one gyro; otherwise without centre and limits, as different resonators share none.
    ControlCharts control;
    Moments moments;
    Histogram histogram;
};

// `baseline`: results that set the limits.
HistoryCharts historyCharts(const std::vector<HistoryPoint>& points,
                            const HistoryParameter& parameter, bool one_gyro, std::size_t baseline);

// Texts of the page History in the language of the window.
struct HistoryWords {
    Q_DECLARE_TR_FUNCTIONS(History)
};

enum class HistoryAxis { date, frequency, order };

// A history, and how it is shown.
struct HistoryView {
    const StoredHistory& history;
    const HistoryCharts& charts;
    std::size_t baseline = 0;  // results that set the limits
    HistoryParameter parameter;
    HistoryAxis axis = HistoryAxis::date;
    DisplayUnits units;
    std::optional<std::size_t> chosen;    // point
    const Estimate* passport = nullptr;   // of the parameter; null: none
    std::optional<ParameterLimit> limit;  // of the session's dossier
};

// The axis against which results are shown: their order where none has a date, so that the first
// one is seen.
HistoryAxis shownAxis(const StoredHistory& history, HistoryAxis chosen);

// A plot whose first series has the points of these places in the history.
struct HistoryPlot {
    XYPlot plot;
    std::vector<std::size_t> points;
};

// The parameter as it is shown: "Decay time τ" or "Mode 1: f", with its unit.
Shown shownIn(const HistoryView& view);

// Values with their uncertainties u, limits of the chart, limits of the dossier and passport
// against the chosen axis. The others are sequences: against the order where the axis is the
// frequency.
HistoryPlot valuesPlot(const HistoryView& view);
HistoryPlot rangesPlot(const HistoryView& view);
HistoryPlot averagePlot(const HistoryView& view);
XYPlot distributionPlot(const HistoryView& view);
// The range of the values in which their distribution is seen whole.
AxisRange wholeRange(const HistoryView& view, const XYPlot& values);
// The distribution turned onto the axis of the values, to be drawn beside them.
XYPlot besideValues(XYPlot distribution, const XYPlot& values);

// "HRG-17, 2026-03-31, set A".
QString nameOf(const HistoryPoint& point);

// "HRG-17, 2026-03-31, set A: τ = 21.3(1) s; f = 5300.1 Hz; 22.5 °C; outside the limits, above".
QString pointText(const HistoryView& view, std::size_t point);

// What the charts say: which results lie outside, and which data are missing for an answer.
QString verdictText(const HistoryView& view);

}  // namespace vybeg::ui
