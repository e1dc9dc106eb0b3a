#include "ui/sweep/sweep_plots.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vybeg::ui {

namespace {

using ValueOf = std::function<double(const SweepLength&)>;

// What is not above zero has no place on a logarithmic axis.
XYSeries seriesOf(const WindowSweep& sweep, const QString& name, double factor,
                  const ValueOf& value) {
    XYSeries series;
    series.name = name;
    for (const SweepLength& each : sweep.lengths) {
        const double y = factor * value(each);
        series.x.push_back(static_cast<double>(each.length));
        series.y.push_back(y > 0 ? y : SweepValue::none);
    }
    return series;
}

XYSeries withInk(XYSeries series, Ink ink, bool dashed = false) {
    series.ink = ink;
    series.dashed = dashed;
    return series;
}

XYSeries asPoints(XYSeries series, int style) {
    series.points = true;
    series.style = style;
    return series;
}

struct Extent {
    double low = 1e300;
    double high = 0;

    void take(const XYSeries& series) {
        for (const double y : series.y) {
            if (std::isfinite(y)) {
                low = std::min(low, y);
                high = std::max(high, y);
            }
        }
    }
};

// A vertical line at the recommended length, and a mark on the chosen point.
void addMarks(const WindowSweep& sweep, const SweepView& view, XYPlot& plot) {
    if (sweep.advice) {
        const auto n = static_cast<double>(sweep.lengths[sweep.advice->best].length);
        plot.series.push_back(dashedLine(SweepWords::tr("recommended"), Ink::accent, {n, n},
                                         {plot.y_range->lower, plot.y_range->upper}));
    }
    if (view.chosen) {
        plot.series.push_back(markOn(plot.series.front(), *view.chosen, Ink::warning));
    }
}

XYPlot emptyPlot() {
    XYPlot plot;
    plot.x_name = QStringLiteral("n");
    plot.x_unit = SweepWords::tr("samples");
    plot.x_logarithmic = true;
    plot.y_logarithmic = true;
    return plot;
}

}  // namespace

double sweepFactor(const WindowSweep& sweep, const SweepView& view, std::size_t variable) {
    const DisplayScale scale = displayScale(main_slow_variables[variable], view.units, sweep.f0_hz);
    return scale.decibels ? 1 : scale.factor;
}

QString sweepUnit(const SweepView& view, std::size_t variable) {
    DisplayUnits units = view.units;
    if (units.amplitude == AmplitudeUnit::decibels) {
        units.amplitude = AmplitudeUnit::recording;
    }
    const QString unit = displayUnit(main_slow_variables[variable], units);
    const bool amplitude = info(main_slow_variables[variable]).quantity == Quantity::amplitude;
    return amplitude && unit.isEmpty() ? view.channel_unit : unit;
}

XYPlot scatterPlot(const WindowSweep* sweep, const SweepView& view) {
    XYPlot plot = emptyPlot();
    plot.y_name = SweepWords::tr("Standard deviation of %1")
                      .arg(displaySymbol(main_slow_variables[view.variable], view.units));
    plot.y_unit = sweepUnit(view, view.variable);
    if (sweep == nullptr || sweep->lengths.empty()) {
        return plot;
    }
    const double factor = sweepFactor(*sweep, view, view.variable);
    const auto series = [&](const QString& name, double SweepValue::*member) {
        return seriesOf(*sweep, name, factor, [&](const SweepLength& each) {
            return each.values[view.variable].*member;
        });
    };
    XYSeries scatter = asPoints(series(SweepWords::tr("scatter"), &SweepValue::scatter), 0);
    scatter.ink = Ink::text;
    for (const SweepLength& each : sweep->lengths) {
        scatter.sd.push_back(factor * each.values[view.variable].sd_scatter);
    }
    plot.series.push_back(std::move(scatter));
    plot.series.push_back(
        withInk(series(SweepWords::tr("stated sd"), &SweepValue::stated), Ink::channel_c));
    plot.series.push_back(
        withInk(series(SweepWords::tr("bound"), &SweepValue::bound), Ink::muted, true));
    XYSeries motion = asPoints(series(SweepWords::tr("motion"), &SweepValue::motion), 2);
    motion.ink = Ink::channel_d;
    plot.series.push_back(std::move(motion));
    Extent extent;
    for (const std::size_t k : {0, 1, 2}) {
        extent.take(plot.series[k]);
    }
    const double floor = extent.low / 4;
    for (std::size_t k = 0; k < closed_form_algorithms.size(); ++k) {
        XYSeries leakage = seriesOf(
            *sweep, SweepWords::tr("leakage %1").arg(k + 1), factor,
            [&](const SweepLength& each) { return each.values[view.variable].leakage[k]; });
        leakage.style = static_cast<int>(k) + 2;
        leakage.thin = true;
        extent.take(leakage);
        plot.series.push_back(std::move(leakage));
    }
    extent.take(plot.series[3]);
    // Whole half-periods have a leakage of almost nothing, which needs no room.
    plot.y_range = extent.high > 0 ? AxisRange{floor, 2 * extent.high} : AxisRange{0.1, 10};
    for (XYSeries& each : plot.series) {  // a curve that lies below the plot needs no name
        if (std::ranges::none_of(each.y, [&](double y) { return y >= floor; })) {
            each.name.clear();
        }
    }
    addMarks(*sweep, view, plot);
    return plot;
}

XYPlot residualPlot(const WindowSweep* sweep, const SweepView& view) {
    XYPlot plot = emptyPlot();
    plot.y_name = SweepWords::tr("Residual");
    plot.y_unit = view.channel_unit;
    if (sweep == nullptr || sweep->lengths.empty()) {
        return plot;
    }
    XYSeries noise = asPoints(seriesOf(*sweep, SweepWords::tr("noise"), 1,
                                       [](const SweepLength& each) { return each.noise; }),
                              0);
    noise.ink = Ink::text;
    plot.series.push_back(std::move(noise));
    plot.series.push_back(withInk(seriesOf(*sweep, SweepWords::tr("rms"), 1,
                                           [](const SweepLength& each) { return each.rms; }),
                                  Ink::channel_c));
    plot.series.push_back(
        withInk(seriesOf(*sweep, SweepWords::tr("white"), 1,
                         [sweep](const SweepLength&) { return sweep->white_noise; }),
                Ink::muted, true));
    Extent extent;
    for (const XYSeries& each : plot.series) {
        extent.take(each);
    }
    plot.y_range =
        extent.high > 0 ? AxisRange{extent.low / 1.5, 1.5 * extent.high} : AxisRange{0.1, 10};
    addMarks(*sweep, view, plot);
    return plot;
}

}  // namespace vybeg::ui
