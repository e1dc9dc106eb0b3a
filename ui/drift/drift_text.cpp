#include "ui/drift/drift_text.h"

#include "ui/resonator/parameter_text.h"
#include "ui/words/error_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vybeg::ui {

namespace {

constexpr double half_turn = std::numbers::pi;
constexpr int curve_steps = 360;

struct DriftWords {
    Q_DECLARE_TR_FUNCTIONS(Drift)
};

XYSeries meansOf(const WholeAngleDrift& drift, double angle, double rate) {
    XYSeries means{
        .name = DriftWords::tr("means over %1°")
                    .arg(shortNumberText(180.0 / static_cast<double>(drift.bins.size()), 6)),
        .ink = Ink::channel_c,
        .points = true};
    for (const LogBin& bin : drift.bins) {
        if (std::isfinite(bin.rate)) {
            means.x.push_back(angle * bin.theta);
            means.y.push_back(rate * bin.rate);
            means.sd.push_back(rate * bin.sd);
        }
    }
    return means;
}

XYSeries harmonicsOf(const WholeAngleDrift& drift, double angle, double rate) {
    XYSeries curve{.name = DriftWords::tr("harmonics 2 and 4"), .ink = Ink::text};
    for (int k = 0; k <= curve_steps; ++k) {
        const double theta = half_turn * k / curve_steps;
        curve.x.push_back(angle * theta);
        curve.y.push_back(rate * drift.rate(theta));
        curve.sd.push_back(rate * drift.sd_rate(theta));
    }
    return curve;
}

// Of points with their deviations, with room at both ends.
std::optional<AxisRange> rangeOf(const XYSeries& points) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t k = 0; k < points.y.size(); ++k) {
        low = std::min(low, points.y[k] - points.sd[k]);
        high = std::max(high, points.y[k] + points.sd[k]);
    }
    if (!std::isfinite(low) || !std::isfinite(high) || !(high > low)) {
        return std::nullopt;
    }
    const double spare = 0.06 * (high - low);
    return AxisRange{low - spare, high + spare};
}

bool hasAll(const WholeAngleDrift& drift) {
    return std::ranges::all_of(drift.harmonics.begin() + 1, drift.harmonics.end(),
                               [](const Estimate& each) { return each.given(); });
}

// A number of a log, with no more decimals than it has use for.
QuantityCell plainCell(double value) {
    constexpr double large = 100;
    return {numberLabel(value, std::abs(value) < large ? 1 : 0),
            {exactText(value), QString(), QString()},
            {}};
}

QuantityCell rowsCell(const LogDrift& log) {
    const QString rows = countLabel(static_cast<std::int64_t>(log.rows));
    return sentenceCell(log.missing == 0
                            ? rows
                            : DriftWords::tr("%1, %2 without")
                                  .arg(rows, countLabel(static_cast<std::int64_t>(log.missing))));
}

}  // namespace

XYPlot wholeAnglePlot(const WholeAngleDrift& drift, const DisplayUnits& units) {
    const double angle = angleFactor(units);
    const double rate = angleRateFactor(units);
    XYPlot plot;
    plot.x_name = QStringLiteral("θ_A");
    plot.x_unit = angleUnit(units);
    plot.x_in_degrees = units.angle == AngleUnit::degrees;
    plot.x_range = AxisRange{-0.01 * angle * half_turn, 1.01 * angle * half_turn};
    plot.y_name = DriftWords::tr("dθ_A/dt less the turn");
    plot.y_unit = angleRateUnit(units);
    plot.y_takes_prefix = units.angle == AngleUnit::radians;
    plot.series.push_back(meansOf(drift, angle, rate));
    plot.y_range = rangeOf(plot.series[whole_angle_means]);
    if (hasAll(drift)) {
        plot.series.push_back(harmonicsOf(drift, angle, rate));
    }
    return plot;
}

QString logName(const WholeAngleDrift& drift, std::size_t log) {
    const QString name = QString::fromStdString(drift.logs[log].name);
    return drift.left_out == log ? DriftWords::tr("%1 (left out)").arg(name) : name;
}

QStringList logHeaders(const WholeAngleDrift& drift) {
    QStringList headers;
    if (drift.logs.size() > 1) {
        headers << DriftWords::tr("All logs").replace(QLatin1Char(' '), QChar(QChar::Nbsp));
        for (std::size_t k = 0; k < drift.logs.size(); ++k) {
            headers << logName(drift, k);
        }
    }
    return headers;
}

std::vector<QuantityRow> logRows(const WholeAngleDrift& drift, const DisplayUnits& units) {
    const std::array<QString, log_terms> names{
        DriftWords::tr("Turn dθ_A/dt"), QStringLiteral("cos 2θ_A"), QStringLiteral("sin 2θ_A"),
        QStringLiteral("cos 4θ_A"), QStringLiteral("sin 4θ_A")};
    const double factor = angleRateFactor(units);
    const bool several = drift.logs.size() > 1;
    std::vector<QuantityRow> rows;
    for (std::size_t term = 0; term < names.size(); ++term) {
        const QString tip =
            term == 0 ? DriftWords::tr(
                            "Mean rate over the angle: input rate and bias. Each log has its own")
                      : QString();
        QuantityRow row{withUnit(names.at(term), angleRateUnit(units)),
                        tip,
                        {cellOf(drift.harmonics.at(term), factor)}};
        if (term == 0 && !drift.harmonics.front().given()) {
            row.cells.front().text = QStringLiteral("—");  // as the tip and the agreement say
        }
        const auto at = static_cast<Eigen::Index>(term);
        for (std::size_t k = 0; several && k < drift.logs.size(); ++k) {
            const LogDrift& log = drift.logs[k];
            row.cells.push_back(valueCell(factor * log.coefficients[at],
                                          factor * std::sqrt(log.covariance(at, at))));
        }
        rows.push_back(std::move(row));
    }
    const auto add = [&](const QString& name, const QString& tip, const auto& cell) {
        QuantityRow row{name, tip, {}};
        if (several) {
            row.cells.push_back(sentenceCell({}));
        }
        for (const LogDrift& log : drift.logs) {
            row.cells.push_back(cell(log));
        }
        rows.push_back(std::move(row));
    };
    add(withUnit(DriftWords::tr("Length"), unitText("s")), {},
        [](const LogDrift& log) { return plainCell(log.seconds); });
    add(withUnit(DriftWords::tr("Turn of the wave"), angleUnit(units)),
        DriftWords::tr("From the least to the greatest angle"),
        [angle = angleFactor(units)](const LogDrift& log) { return plainCell(angle * log.turn); });
    add(DriftWords::tr("Rows with an angle"), {}, rowsCell);
    return rows;
}

std::vector<QuantityRow> heldRows(const HeldResonator& resonator, const DisplayUnits& units) {
    const std::array<QString, held_parameters.size()> tips{
        DriftWords::tr("Four times the fourth harmonic of the drift"),
        DriftWords::tr("Axis of larger damping, from the drift"),
        DriftWords::tr("2ρ/g, ρ the fourth harmonic of the amplitude effort over its mean"),
        DriftWords::tr("From the quadrature effort against the amplitude effort"),
        DriftWords::tr("Axis of the mode with the higher frequency, from the quadrature effort")};
    std::vector<QuantityRow> rows;
    for (std::size_t k = 0; k < tips.size(); ++k) {
        const ParameterOf<HeldResonator>& parameter = held_parameters.at(k);
        Shown shown = shownAs(parameter.name, parameter.unit, units);
        shown.tip = tips.at(k);
        rows.push_back(rowOf(shown, {cellOf(resonator.*parameter.member, shown.factor)}));
    }
    return rows;
}

QStringList agreementTexts(const WholeAngleDrift& drift) {
    QStringList texts;
    for (const LogAgreement& each : drift.agreement) {
        if (each.freedom > 0) {
            const QString form =
                each.harmonic == 0
                    ? (each.agrees ? DriftWords::tr("Turn: the logs agree, χ² %1 of %2.")
                                   : DriftWords::tr(
                                         "Turn: the logs differ, χ² %1 of %2, which is no fault."))
                    : (each.agrees ? DriftWords::tr("Harmonic %3: the logs agree, χ² %1 of %2.")
                                   : DriftWords::tr("Harmonic %3: the logs differ, χ² %1 of %2."));
            const QString sentence =
                form.arg(shortNumberText(each.chi2, 3), shortNumberText(each.freedom, 3));
            texts << (each.harmonic == 0 ? sentence : sentence.arg(each.harmonic));
        }
    }
    if (texts.isEmpty()) {
        texts << DriftWords::tr(
            "Of one log it is not known whether another one would agree with it.");
    }
    return texts;
}

QString channelsText(const ChannelTolerance& channels) {
    return DriftWords::tr(
               "± is the statistical standard deviation. u, where it differs, holds the tolerances "
               "of the channels too: κ ± %1, ε ± %2°.")
        .arg(shortNumberText(channels[kappa_error], 3),
             shortNumberText(channels[skew_error] / tolerated_errors[skew_error].factor, 3));
}

}  // namespace vybeg::ui
