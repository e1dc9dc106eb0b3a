#include "ui/history/history_charts.h"

#include "core/resonator/results/resonator_parameters.h"

#include <cmath>

namespace vybeg::ui {

const std::vector<HistoryParameter>& historyParameters() {
    static const std::vector<HistoryParameter> all = [] {
        std::vector<HistoryParameter> parameters;
        parameters.reserve(resonator_parameters.size() + 2 * mode_parameters.size());
        for (const ResonatorParameter& each : resonator_parameters) {
            parameters.push_back({each.name, each.unit, each.period,
                                  [member = each.member](const Passport& passport) {
                                      return &(passport.resonator.*member);
                                  }});
        }
        for (std::size_t mode = 0; mode < 2; ++mode) {
            for (const ModeParameter& each : mode_parameters) {
                parameters.push_back({"modes[" + std::to_string(mode) + "]." + each.name, each.unit,
                                      0, [mode, member = each.member](const Passport& passport) {
                                          return mode < passport.modes.size()
                                                     ? &(passport.modes[mode].*member)
                                                     : nullptr;
                                      }});
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
    const Estimate* found = passport != nullptr ? parameter.in(*passport) : nullptr;
    return found != nullptr ? *found : Estimate{};
}

}  // namespace vybeg::ui
