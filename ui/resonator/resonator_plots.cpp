#include "ui/resonator/resonator_plots.h"

#include "ui/resonator/parameter_text.h"
#include "ui/words/error_text.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace vybeg::ui {

namespace {

QString shortName(const std::string& file) {
    return QFileInfo(QString::fromStdString(file)).completeBaseName();
}

int styleAt(const RunStyles& styles, std::size_t run) {
    return run < styles.size() ? styles[run] : static_cast<int>(run);
}

std::vector<double> times(double factor, const std::vector<double>& values) {
    std::vector<double> scaled(values);
    std::ranges::transform(scaled, scaled.begin(), [factor](double v) { return factor * v; });
    return scaled;
}

// The rim, in degrees and radii of the rim.

constexpr double degree = std::numbers::pi / 180;
constexpr double quarter = 90;
constexpr double axis_length = 0.92;

RoundSeries rim() {
    RoundSeries circle{.ink = Ink::muted, .width = 1};
    for (int angle = 0; angle <= 360; angle += 3) {
        circle.x.push_back(angle);
        circle.y.push_back(1);
    }
    return circle;
}

RoundSeries electrodes(const QString& name, Ink ink, double first) {
    RoundSeries points{.name = name, .ink = ink, .points = true};
    const double nearest = std::fmod(std::fmod(first, quarter) + quarter, quarter);
    for (int k = 0; k < 4; ++k) {
        points.x.push_back(nearest + k * quarter);
        points.y.push_back(1);
    }
    return points;
}

// Four spokes, as wide as plus and minus one standard deviation.
RoundSeries axes(const QString& name, Ink ink, const Estimate& angle) {
    RoundSeries spokes{.name = name, .ink = ink};
    constexpr double widest = 40;
    const double width = std::min(angle.uncertainty() / degree, widest);
    const double first = std::fmod(angle.value / degree + 4 * quarter, quarter);
    const auto add = [&spokes](double at, double radius) {
        spokes.x.push_back(std::clamp(at, 0., 4 * quarter));
        spokes.y.push_back(radius);
    };
    for (int k = 0; k < 4; ++k) {
        const double spoke = first + k * quarter;
        add(spoke, 0);
        for (const double part : {-1., -0.5, 0., 0.5, 1.}) {
            add(spoke + part * width, axis_length);
        }
        add(spoke, 0);
    }
    return spokes;
}

// The deflected rim of a wave, out of scale.
RoundSeries wave(const QString& name, int style, double two_theta_A) {
    const CurveStyle look = curveStyle(style);
    RoundSeries curve{.name = name, .color = look.color, .shade = look.shade};
    for (int angle = 0; angle <= 360; angle += 2) {
        curve.x.push_back(angle);
        curve.y.push_back(0.72 + 0.16 * std::cos(2 * angle * degree - two_theta_A));
    }
    return curve;
}

// The fitted harmonics, and for comparison the curve of the fitted resonator, over the period of 90
// degrees.
std::array<XYSeries, 2> driftCurves(const Identification& found, double angle, double rate) {
    constexpr int steps = 180;
    const Eigen::Matrix2cd m = SlowDynamics(found.fit.motion.shared).matrix();
    XYSeries fitted{.name = ResonatorWords::tr("fitted"), .ink = Ink::text};
    XYSeries resonator = dashedLine(ResonatorWords::tr("resonator"), Ink::text);
    for (int k = 0; k <= steps; ++k) {
        const double theta = (static_cast<double>(k) / steps - 0.5) * std::numbers::pi / 2;
        fitted.x.push_back(angle * theta);
        fitted.y.push_back(rate * found.drift.rate(theta));
        fitted.sd.push_back(rate * found.drift.u_rate(theta));
        resonator.y.push_back(rate * drift_of_dynamics(m, theta));
    }
    resonator.x = fitted.x;
    return {std::move(fitted), std::move(resonator)};
}

XYSeries trackOf(const RunTrack& track, SlowVariable variable, double angle) {
    if (variable == SlowVariable::two_theta_A) {
        return {.x = track.time_s,
                .y = times(angle, track.two_theta_A),
                .sd = times(angle, track.sd_two_theta_A)};
    }
    return {.x = track.time_s,
            .y = variable == SlowVariable::a_A ? track.a_A : track.a_B,
            .sd = track.sd_a};
}

}  // namespace

std::optional<int> styleOf(const Document& document, RecordingId recording) {
    const auto& analyses = document.analyses();
    const auto of = std::ranges::find(analyses, recording, &AnalysisEntry::recording_id);
    for (int color = 0; of != analyses.end() && color < curve_colors; ++color) {
        if (curveStyle(color).color == of->shown.color) {
            return color + curve_colors * of->shown.shade;
        }
    }
    return std::nullopt;
}

RunStyles runStyles(const Document& document, const SetResult& outcome) {
    RunStyles styles;
    for (const RecordingRef& recording : outcome.set.recordings) {
        styles.push_back(styleOf(document, static_cast<RecordingId>(recording.id))
                             .value_or(static_cast<int>(styles.size())));
    }
    return styles;
}

XYPlot driftPlot(const SetResult& outcome, const DisplayUnits& units, const RunStyles& styles) {
    const DriftFunction& drift = outcome.identification.drift;
    const double angle = angleFactor(units);
    const double rate = angleRateFactor(units);
    const double edge = angle * std::numbers::pi / 4;
    XYPlot plot{.x_name = QStringLiteral("θ_A"),
                .x_unit = angleUnit(units),
                .x_in_degrees = units.angle == AngleUnit::degrees,
                .x_range = AxisRange{-1.04 * edge, 1.04 * edge},
                .y_name = QStringLiteral("dθ_A/dt"),
                .y_unit = angleRateUnit(units),
                .y_takes_prefix = units.angle == AngleUnit::radians,
                .empty = reasonText(no_drift_function(outcome.identification))};
    if (drift.order > 0) {
        std::ranges::move(driftCurves(outcome.identification, angle, rate),
                          std::back_inserter(plot.series));
    }
    for (std::size_t run = 0; run < outcome.set.recordings.size(); ++run) {
        XYSeries points{.name = shortName(outcome.set.recordings[run].name()),
                        .style = styleAt(styles, run),
                        .points = true};
        for (const DriftPoint& point : drift.points) {
            if (point.run == run) {
                points.x.push_back(angle * point.theta);
                points.y.push_back(rate * point.rate);
                points.sd.push_back(rate * point.sd_rate);
            }
        }
        if (!points.x.empty()) {
            plot.series.push_back(std::move(points));
        }
    }
    return plot;
}

XYPlot balancePlot(const SetResult& outcome, BalanceAxis axis, const DisplayUnits& units,
                   const RunStyles& styles) {
    const std::vector<ChannelBalance>& balance = outcome.identification.balance;
    const bool over_time = axis == BalanceAxis::time;
    XYPlot plot;
    plot.x_name = over_time ? QStringLiteral("t") : QStringLiteral("θ_A");
    plot.x_unit = over_time ? ResonatorWords::tr("s") : angleUnit(units);
    plot.x_in_degrees = !over_time && units.angle == AngleUnit::degrees;
    plot.y_name = displaySymbol(SlowVariable::orthogonality, {});
    plot.empty = reasonText({ReasonCode::free_model, {}});
    for (std::size_t run = 0; run < balance.size(); ++run) {
        if (!balance[run].time_s.empty()) {
            plot.series.push_back({.name = shortName(outcome.set.recordings[run].name()),
                                   .style = styleAt(styles, run),
                                   .points = !over_time,
                                   .x = over_time
                                            ? balance[run].time_s
                                            : times(angleFactor(units), balance[run].theta_rad),
                                   .y = balance[run].orthogonality,
                                   .sd = balance[run].sd});
        }
    }
    return plot;
}

RoundPlot rimPlot(const SetResult& outcome, const RunStyles& styles) {
    RoundPlot plot;
    plot.reach = 1.1;
    plot.scale = false;
    const ResonatorFit& fit = outcome.identification.fit;
    plot.empty = reasonText({ReasonCode::free_model, {}});
    if (fit.model == ResonatorModel::free) {
        return plot;
    }
    plot.series.push_back(rim());
    // Angles count from the angle zero, here of the first recording.
    const double c = -outcome.identification.settings.signal_of(0).calibration.angle_zero_deg;
    plot.series.push_back(electrodes(QStringLiteral("C"), Ink::channel_c, c));
    plot.series.push_back(electrodes(QStringLiteral("D"), Ink::channel_d, c + quarter / 2));
    if (fit.resonator.theta_w_rad.given()) {
        plot.series.push_back(axes(QStringLiteral("θ_w"), Ink::text, fit.resonator.theta_w_rad));
    }
    if (fit.resonator.theta_tau_rad.given()) {
        plot.series.push_back(axes(QStringLiteral("θ_τ"), Ink::muted, fit.resonator.theta_tau_rad));
        plot.series.back().dashed = true;
    }
    for (std::size_t run = 0; run < fit.runs.size(); ++run) {
        if (fit.runs[run].two_theta_A_rad.given()) {
            plot.series.push_back(wave(shortName(outcome.set.recordings[run].name()),
                                       styleAt(styles, run), fit.runs[run].two_theta_A_rad.value));
        }
    }
    return plot;
}

XYPlot trackPlot(const SetResult& outcome, const Passport& passport, SlowVariable variable,
                 const DisplayUnits& units, const RunStyles& styles) {
    XYPlot plot;
    plot.x_name = QStringLiteral("t");
    plot.x_unit = ResonatorWords::tr("s");
    const bool is_angle = variable == SlowVariable::two_theta_A;
    plot.y_name = displaySymbol(variable, {});
    plot.y_unit = is_angle ? angleUnit(units) : QString();
    plot.y_takes_prefix = is_angle && units.angle == AngleUnit::radians;
    const double angle = angleFactor(units);
    for (std::size_t run = 0; run < passport.tracks.size(); ++run) {
        XYSeries then = trackOf(passport.tracks[run], variable, angle);
        if (run == 0) {  // one entry for the shade of all of them
            then.name = ResonatorWords::tr("passport");
        }
        then.style = styleAt(styles, run);
        then.shades = 2;
        plot.series.push_back(std::move(then));
    }
    for (std::size_t run = 0; run < outcome.set.recordings.size(); ++run) {
        XYSeries now = trackOf(outcome.identification.runs[run].track, variable, angle);
        now.name = shortName(outcome.set.recordings[run].name());
        now.style = styleAt(styles, run);
        plot.series.push_back(std::move(now));
    }
    return plot;
}

}  // namespace vybeg::ui
