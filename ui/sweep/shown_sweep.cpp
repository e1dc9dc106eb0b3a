#include "ui/sweep/shown_sweep.h"

#include "ui/plots/axis_ticks.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace vybeg::ui {

namespace {

struct SweepWords {
    Q_DECLARE_TR_FUNCTIONS(Sweep)
};

// Factor from stored to displayed values, and the unit; decibels do not apply to deviations.
double sweepFactor(const WindowSweep& sweep, const SweepView& view, std::size_t variable) {
    const DisplayScale scale = displayScale(main_slow_variables[variable], view.units, sweep.f0_hz);
    return scale.decibels ? 1 : scale.factor;
}

QString sweepUnit(const SweepView& view, std::size_t variable) {
    DisplayUnits units = view.units;
    if (units.amplitude == AmplitudeUnit::decibels) {
        units.amplitude = AmplitudeUnit::recording;
    }
    return displayUnit(main_slow_variables[variable], units, view.channel_unit);
}

using ValueOf = std::function<double(const SweepLength&)>;

// Only values above zero have a place on a logarithmic axis.
XYSeries seriesOf(const WindowSweep& sweep, XYSeries series, double factor, const ValueOf& value) {
    for (const SweepLength& each : sweep.lengths) {
        const double y = factor * value(each);
        series.x.push_back(static_cast<double>(each.length));
        series.y.push_back(y > 0 ? y : SweepValue::none);
    }
    return series;
}

void extend(Extent& extent, const XYSeries& series) {
    std::ranges::for_each(series.y, [&extent](double y) { extent.add(y); });
}

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
    return {.x_name = QStringLiteral("n"),
            .x_unit = SweepWords::tr("samples"),
            .x_logarithmic = true,
            .y_logarithmic = true};
}

QString shortText(double value) {
    return std::isfinite(value) ? shortNumberText(value, 3) : QStringLiteral("—");
}

QString symbolOf(std::size_t variable, const SweepView& view) {
    return displaySymbol(main_slow_variables[variable], view.units);
}

// A displayed value with its unit.
QString withUnitOf(double stored, std::size_t variable, const WindowSweep& sweep,
                   const SweepView& view) {
    const QString text = shortText(stored * sweepFactor(sweep, view, variable));
    const QString unit = sweepUnit(view, variable);
    return unit.isEmpty() ? text : text + QStringLiteral("\u00a0") + unit;
}

// Why a longer window is not better.
QString reasonOf(const WindowSweep& sweep, const SweepView& view) {
    const WindowAdvice& advice = *sweep.advice;
    const auto symbol = symbolOf(advice.variable, view);
    const auto next = [&]() -> const SweepLength& { return sweep.lengths[advice.best + 1]; };
    const auto valueText = [&](double stored) {
        return withUnitOf(stored, advice.variable, sweep, view);
    };
    switch (advice.limit) {
        case WindowAdvice::Limit::motion:
            return SweepWords::tr(
                       "Longer windows blur %1: at n = %2 its bend inside the window shifts the "
                       "mean by %3, with a scatter of %4.")
                .arg(symbol, countLabel(next().length),
                     valueText(next().values[advice.variable].motion),
                     valueText(next().values[advice.variable].scatter));
        case WindowAdvice::Limit::scatter:
            return SweepWords::tr(
                       "Longer windows are not better: at n = %2 the expected error of %1 is %3, "
                       "here %4.")
                .arg(symbol, countLabel(next().length),
                     valueText(next().values[advice.variable].error()),
                     valueText(sweep.lengths[advice.best].values[advice.variable].error()));
        case WindowAdvice::Limit::flat:
            return SweepWords::tr("Longer windows of the list are better by less than a quarter.");
        case WindowAdvice::Limit::no_values:
            return SweepWords::tr(
                "In the longer windows of the list some variables have no value.");
        case WindowAdvice::Limit::list_end: return SweepWords::tr("It is the longest tried.");
        case WindowAdvice::Limit::list_begin:
            return SweepWords::tr(
                       "It is the shortest of the list, and %1 moves even inside it by more than "
                       "its scatter.")
                .arg(symbol);
    }
    return {};
}

// Whether an analysis warns of windows of the recommended length, and which length it would not.
QString motionText(const WindowSweep& sweep) {
    const WindowAdvice& advice = *sweep.advice;
    const SweepLength& best = sweep.lengths[advice.best];
    if (best.moving == 0) {
        return {};
    }
    const QString inside =
        QStringLiteral(" ") + SweepWords::tr(
                                  "The wave moves inside %1 of its %2 windows, of which an "
                                  "analysis warns; its errors are the least all the same.")
                                  .arg(countLabel(best.moving), countLabel(best.windows));
    return advice.quiet ? inside + QStringLiteral(" ") +
                              SweepWords::tr(
                                  "Without the warning n = %1 is the best, with an "
                                  "error %2 times as large.")
                                  .arg(countLabel(sweep.lengths[*advice.quiet].length),
                                       shortText(advice.quiet_loss))
                        : inside;
}

// Neighbouring windows scatter by more than white noise, leakage and motion explain.
QString coloredNoise(const WindowSweep& sweep, const SweepView& view) {
    constexpr double significant = 5;  // standard deviations
    constexpr double notable = 1.25;
    const SweepLength& best = sweep.lengths[sweep.advice->best];
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        const SweepValue& value = best.values[v];
        const double explained = std::hypot(value.bound, value.leaking, value.unmodelled);
        if (value.scatter > notable * explained &&
            value.scatter - explained > significant * value.sd_scatter) {
            return QStringLiteral(" ") +
                   SweepWords::tr(
                       "Neighbouring values of %1 scatter %2 times as much as the white noise "
                       "explains.")
                       .arg(symbolOf(v, view), shortText(value.scatter / explained));
        }
    }
    return {};
}

struct Column {
    const char* name;
    double SweepValue::*member;
};

constexpr std::array<Column, 4> columns{
    Column{QT_TRANSLATE_NOOP("Sweep", "stated sd"), &SweepValue::stated},
    Column{QT_TRANSLATE_NOOP("Sweep", "Cramér-Rao bound"), &SweepValue::bound},
    Column{QT_TRANSLATE_NOOP("Sweep", "shift by motion"), &SweepValue::motion},
    Column{QT_TRANSLATE_NOOP("Sweep", "own leakage"), &SweepValue::leaking}};

// Those in which some length has more than nothing to show.
std::vector<Column> shownColumns(const WindowSweep& sweep, const SweepView& view) {
    std::vector<Column> shown;
    std::ranges::copy_if(columns, std::back_inserter(shown), [&](const Column& column) {
        return std::ranges::any_of(sweep.lengths, [&](const SweepLength& each) {
            return each.values[view.variable].*column.member != 0;
        });
    });
    return shown;
}

// A column of the table. Its head has the power of ten, of numbers that begin with zeros: one of
// all deviations, and one of the residuals.
struct TableColumn {
    QString name;
    QString unit;
    ValueOf value;  // displayed
    int power;
};

std::vector<TableColumn> tableColumns(const WindowSweep& sweep, const SweepView& view) {
    const QString unit = sweepUnit(view, view.variable);
    const double factor = sweepFactor(sweep, view, view.variable);
    const auto of = [&](double SweepValue::*member) {
        return [=, v = view.variable](const SweepLength& each) {
            return factor * each.values[v].*member;
        };
    };
    const auto powerOf = [&sweep](const ValueOf& value) {
        Extent extent;
        std::ranges::for_each(sweep.lengths,
                              [&](const SweepLength& each) { extent.add(std::abs(value(each))); });
        return 0 < extent.high && extent.high < 0.1
                   ? 3 * static_cast<int>(std::floor(std::log10(extent.high) / 3))
                   : 0;
    };
    const int power = powerOf(of(&SweepValue::scatter));
    std::vector<TableColumn> table{
        {SweepWords::tr("scatter"), unit, of(&SweepValue::scatter), power}};
    for (const Column& column : shownColumns(sweep, view)) {
        table.push_back({SweepWords::tr(column.name), unit, of(column.member), power});
    }
    const int of_residual = powerOf(&SweepLength::rms);
    table.push_back({SweepWords::tr("rms"), view.channel_unit, &SweepLength::rms, of_residual});
    table.push_back({SweepWords::tr("noise"), view.channel_unit, &SweepLength::noise, of_residual});
    return table;
}

// E.g. "n = 60, 1.80 ms, 9.54 periods".
QString lengthText(const WindowSweep& sweep, std::size_t length) {
    const auto n = static_cast<double>(sweep.lengths[length].length);
    return SweepWords::tr("n = %1, %2 ms, %3 periods")
        .arg(countLabel(sweep.lengths[length].length), shortText(1e3 * n / sweep.rate_hz),
             shortText(n * sweep.f0_hz / sweep.rate_hz));
}

}  // namespace

XYPlot scatterPlot(const WindowSweep* sweep, const SweepView& view) {
    XYPlot plot = emptyPlot();
    plot.y_name = SweepWords::tr("Standard deviation of %1")
                      .arg(displaySymbol(main_slow_variables[view.variable], view.units));
    plot.y_unit = sweepUnit(view, view.variable);
    if (sweep == nullptr || sweep->lengths.empty()) {
        return plot;
    }
    const double factor = sweepFactor(*sweep, view, view.variable);
    const auto add = [&](const XYSeries& look, double SweepValue::*member) {
        plot.series.push_back(seriesOf(*sweep, look, factor, [&](const SweepLength& each) {
            return each.values[view.variable].*member;
        }));
    };
    add({.name = SweepWords::tr("scatter"), .ink = Ink::text, .points = true},
        &SweepValue::scatter);
    for (const SweepLength& each : sweep->lengths) {
        plot.series.back().sd.push_back(factor * each.values[view.variable].sd_scatter);
    }
    add({.name = SweepWords::tr("stated sd"), .ink = Ink::channel_c}, &SweepValue::stated);
    add({.name = SweepWords::tr("bound"), .ink = Ink::muted, .dashed = true}, &SweepValue::bound);
    add({.name = SweepWords::tr("motion"), .style = 2, .ink = Ink::channel_d, .points = true},
        &SweepValue::motion);
    Extent extent;
    for (const std::size_t k : {0, 1, 2}) {
        extend(extent, plot.series[k]);
    }
    const double floor = extent.low / 4;
    for (std::size_t k = 0; k < closed_form_algorithms.size(); ++k) {
        plot.series.push_back(seriesOf(*sweep,
                                       {.name = SweepWords::tr("leakage %1").arg(k + 1),
                                        .style = static_cast<int>(k) + 2,
                                        .thin = true},
                                       factor, [&](const SweepLength& each) {
                                           return each.values[view.variable].leakage[k];
                                       }));
        extend(extent, plot.series.back());
    }
    extend(extent, plot.series[3]);
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
    const auto add = [&](const XYSeries& look, const ValueOf& value) {
        plot.series.push_back(seriesOf(*sweep, look, 1, value));
    };
    add({.name = SweepWords::tr("noise"), .ink = Ink::text, .points = true}, &SweepLength::noise);
    add({.name = SweepWords::tr("rms"), .ink = Ink::channel_c}, &SweepLength::rms);
    add({.name = SweepWords::tr("white"), .ink = Ink::muted, .dashed = true},
        [sweep](const SweepLength&) { return sweep->white_noise; });
    Extent extent;
    for (const XYSeries& each : plot.series) {
        extend(extent, each);
    }
    plot.y_range =
        extent.high > 0 ? AxisRange{extent.low / 1.5, 1.5 * extent.high} : AxisRange{0.1, 10};
    addMarks(*sweep, view, plot);
    return plot;
}

QString adviceText(const WindowSweep& sweep, const SweepView& view) {
    if (!sweep.advice) {
        return SweepWords::tr(
            "No window is recommended: a comparison needs two lengths with 14 undisturbed windows "
            "or more, and white noise between the lines of the spectrum.");
    }
    const WindowAdvice& advice = *sweep.advice;
    QString text = QStringLiteral("%1. ").arg(
        SweepWords::tr("Recommended: %1").arg(lengthText(sweep, advice.best)));
    text += reasonOf(sweep, view);
    constexpr double one_sided = 2;
    text += QStringLiteral(" ");
    if (advice.loss > one_sided) {
        text += SweepWords::tr(
                    "No window suits all variables: here the expected error of %1 is %2 times its "
                    "least in the list.")
                    .arg(symbolOf(advice.loser, view), shortText(advice.loss));
    } else if (advice.shortest < advice.longest) {
        text += SweepWords::tr(
                    "From n = %1 to %2 no expected error exceeds %3 times its least in the list.")
                    .arg(countLabel(sweep.lengths[advice.shortest].length),
                         countLabel(sweep.lengths[advice.longest].length),
                         shortText(loss_span * advice.loss));
    }
    return text + motionText(sweep) + coloredNoise(sweep, view);
}

QString refusedText(const WindowSweep& sweep) {
    QStringList sentences;
    for (const WindowSweep::Refused& each : sweep.refused) {
        sentences
            << QStringLiteral("n = %1: %2").arg(countLabel(each.length), errorText(each.error));
    }
    return sentences.join(QLatin1Char(' '));
}

QString pointText(const WindowSweep& sweep, std::size_t length, const SweepView& view) {
    const SweepLength& at = sweep.lengths[length];
    const SweepValue& value = at.values[view.variable];
    const double factor = sweepFactor(sweep, view, view.variable);
    return SweepWords::tr(
               "%1: scatter of %2 %3 %4 (stated %5, bound %6, shift by motion %7); noise %8")
        .arg(lengthText(sweep, length), symbolOf(view.variable, view),
             valueText(factor * value.scatter, factor * value.sd_scatter),
             sweepUnit(view, view.variable), shortText(factor * value.stated),
             shortText(factor * value.bound), shortText(factor * value.motion),
             shortText(at.noise));
}

QStringList sweepHeaders(const WindowSweep& sweep, const SweepView& view) {
    QStringList headers{SweepWords::tr("windows")};
    for (const TableColumn& column : tableColumns(sweep, view)) {
        QString unit = scaledUnit(column.unit, false, column.power);
        headers << withUnit(column.name, unit.replace(QLatin1Char(' '), QChar::Nbsp));
    }
    return headers;
}

std::vector<QuantityRow> sweepRows(const WindowSweep& sweep, const SweepView& view) {
    const std::vector<TableColumn> columns_shown = tableColumns(sweep, view);
    const double factor = sweepFactor(sweep, view, view.variable);
    std::vector<QuantityRow> rows;
    for (std::size_t k = 0; k < sweep.lengths.size(); ++k) {
        const SweepLength& each = sweep.lengths[k];
        QuantityRow row{countLabel(each.length), lengthText(sweep, k), {}};
        row.cells.push_back({countLabel(each.used), {QString::number(each.used)}, {}});
        for (const TableColumn& column : columns_shown) {
            const double scale = std::pow(10, -column.power);
            const double value = scale * column.value(each);
            row.cells.push_back(
                row.cells.size() == 1
                    ? measuredCell(value, scale * factor * each.values[view.variable].sd_scatter)
                    : QuantityCell{threeDigits(value), {cellNumber(value)}, {}});
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

QString sweepTable(const WindowSweep& sweep, const SweepView& view) {
    QStringList head{QStringLiteral("n"), SweepWords::tr("windows"), SweepWords::tr("rms"),
                     SweepWords::tr("noise")};
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        const QString unit = sweepUnit(view, v);
        const QString symbol = indexPlain(symbolOf(v, view));
        const auto add = [&](const QString& what) {
            head << withUnit(symbol + QStringLiteral(": ") + what, unit);
        };
        add(SweepWords::tr("scatter"));
        add(SweepWords::tr("sd of the scatter"));
        for (const Column& column : columns) {
            add(SweepWords::tr(column.name));
        }
        for (std::size_t k = 0; k < closed_form_algorithms.size(); ++k) {
            add(SweepWords::tr("leakage, algorithm %1").arg(k + 1));
        }
    }
    QStringList lines{head.join(QLatin1Char('\t'))};
    for (const SweepLength& each : sweep.lengths) {
        QStringList cells{QString::number(each.length), QString::number(each.used),
                          cellNumber(each.rms), cellNumber(each.noise)};
        for (std::size_t v = 0; v < sweep_variable_count; ++v) {
            const double factor = sweepFactor(sweep, view, v);
            const SweepValue& value = each.values[v];
            cells << cellNumber(factor * value.scatter) << cellNumber(factor * value.sd_scatter);
            for (const Column& column : columns) {
                cells << cellNumber(factor * value.*column.member);
            }
            for (const double leakage : value.leakage) {
                cells << cellNumber(factor * leakage);
            }
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

}  // namespace vybeg::ui
