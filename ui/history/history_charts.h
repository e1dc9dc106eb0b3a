#pragma once

#include "core/analysis/passport.h"
#include "core/database/results_database.h"
#include "core/database/stored_result.h"
#include "core/numerics/control_chart.h"
#include "core/numerics/statistics.h"

#include <functional>
#include <string>
#include <vector>

namespace vybeg::ui {

// What a database tells of one parameter.
struct StoredHistory {
    std::vector<StoredGyro> gyros;
    std::vector<HistoryPoint> points;  // of one gyro or of all, by date; those without one last
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

// The value of a parameter in a passport; NaN: there is none.
Estimate passportValue(const Passport* passport, const HistoryParameter& parameter);

}  // namespace vybeg::ui
