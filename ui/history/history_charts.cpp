#include "ui/history/history_charts.h"

#include "core/resonator/results/resonator_parameters.h"

#include <cmath>
#include <limits>

namespace vybeg::ui {

const std::vector<HistoryParameter>& historyParameters() {
    static const std::vector<HistoryParameter> all = [] {
        std::vector<HistoryParameter> parameters;
        parameters.reserve(resonator_parameters.size() + 2 * mode_parameters.size());
        for (const ResonatorParameter& each : resonator_parameters) {
            parameters.push_back({each.name, each.unit, each.period});
        }
        for (int mode = 0; mode < 2; ++mode) {
            for (const ModeParameter& each : mode_parameters) {
                parameters.push_back(
                    {"modes[" + std::to_string(mode) + "]." + each.name, each.unit, 0});
            }
        }
        return parameters;
    }();
    return all;
}

HistoryCharts historyCharts(const std::vector<HistoryPoint>& points,
                            const HistoryParameter& parameter, bool one_gyro,
                            std::size_t baseline) {
    HistoryCharts charts;
    charts.one_gyro = one_gyro;
    std::vector<double> finite;
    for (const HistoryPoint& point : points) {
        charts.values.push_back(point.value.value);
        charts.u.push_back(point.value.uncertainty());
    }
    if (one_gyro) {
        charts.values = beside_first(charts.values, parameter.period);
    }
    for (const double value : charts.values) {
        if (std::isfinite(value)) {
            finite.push_back(value);
        }
    }
    charts.control = control_charts(charts.values, charts.u, one_gyro ? baseline : 0);
    charts.moments = moments_of(finite);
    charts.histogram = histogram_of(finite, charts.moments);
    return charts;
}

Estimate passportValue(const Passport* passport, const HistoryParameter& parameter) {
    for (const ResonatorParameter& each : resonator_parameters) {
        if (passport != nullptr && parameter.name == each.name) {
            return passport->resonator.*each.member;
        }
    }
    const std::size_t modes = passport != nullptr ? passport->modes.size() : 0;
    for (std::size_t mode = 0; mode < modes; ++mode) {
        for (const ModeParameter& each : mode_parameters) {
            if (parameter.name == "modes[" + std::to_string(mode) + "]." + each.name) {
                return passport->modes[mode].*each.member;
            }
        }
    }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, {}};
}

}  // namespace vybeg::ui
