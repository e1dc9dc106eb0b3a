#include "ui/panels/measuring.h"

#include "core/numerics/phase.h"
#include "ui/values/curve_data.h"
#include "ui/words/error_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr int curve_points = 200;
constexpr int points_per_beat = 20;
// theta_A in degrees an hour, of 2theta_A in rad/s.
constexpr double degrees_an_hour = 0.5 * 180 / std::numbers::pi * 3600;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Measuring)
};

TrendOf kindOf(SlowVariable variable) {
    return variable == SlowVariable::a_A ? TrendOf::logarithm : TrendOf::value;
}

// A change by one stored unit per second of a value, as displayed, with its sign.
Reading changeOf(const DisplayScale& scale, double value, double change, double sd) {
    return {std::copysign(scale.sd(value, std::abs(change)), change), scale.sd(value, sd)};
}

DisplayScale scaleOf(const Analysis& analysis, const FittedTrend& trend,
                     const DisplayUnits& units) {
    return displayScale(trend.variable, units, analysis.f0_hz());
}

const FittedTrend* find(const std::vector<FittedTrend>& trends, SlowVariable variable) {
    const auto found = std::ranges::find(trends, variable, &FittedTrend::variable);
    return found == trends.end() ? nullptr : &*found;
}

// Variables whose windows scatter about their trend by more than their noise.
QStringList leaving(const std::vector<FittedTrend>& trends, const DisplayUnits& units) {
    QStringList names;
    for (const FittedTrend& trend : trends) {
        const auto* line = std::get_if<Trend>(&trend.fit);
        if (line && line->enlargement > 1) {
            names << displaySymbol(trend.variable, units);
        }
    }
    return names;
}

QStringList lineSentences(const std::vector<FittedTrend>& trends, const DisplayUnits& units) {
    QStringList sentences;
    if (const FittedTrend* amplitude = find(trends, SlowVariable::a_A)) {
        const auto decay = decay_time(std::get<Trend>(amplitude->fit));
        sentences
            << (decay
                    ? Words::tr("Decay time of a_A: %1 s").arg(valueText(decay->tau_s, decay->sd_s))
                    : Words::tr("The decay of a_A lies within its noise here."));
    }
    if (const FittedTrend* angle = find(trends, SlowVariable::two_theta_A)) {
        const auto& line = std::get<Trend>(angle->fit);
        sentences << Words::tr("Drift of θ_A: %1 °/h")
                         .arg(valueText(line.slope_per_s * degrees_an_hour,
                                        line.sd_slope_per_s * degrees_an_hour));
    }
    if (const FittedTrend* frequency = find(trends, SlowVariable::f)) {
        const auto& line = std::get<Trend>(frequency->fit);
        sentences << Words::tr("Drift of f: %1 Hz/s")
                         .arg(valueText(line.slope_per_s, line.sd_slope_per_s))
                  << Words::tr("%n window(s) without common samples", nullptr,
                               static_cast<int>(line.windows));
    }
    if (const QStringList names = leaving(trends, units); !names.isEmpty()) {
        sentences << Words::tr("Bent: %1; sd enlarged.").arg(names.join(QStringLiteral(", ")));
    }
    return sentences;
}

// Variables whose beat is that of two modes.
QStringList ofModes(const std::vector<FittedTrend>& trends, const DisplayUnits& units) {
    QStringList names;
    for (const FittedTrend& trend : trends) {
        if (std::holds_alternative<ModeBeat>(trend.fit)) {
            names << displaySymbol(trend.variable, units);
        }
    }
    return names;
}

QStringList beatSentences(const ShownAnalysis& shown, const std::vector<FittedTrend>& trends,
                          const DisplayUnits& units) {
    QStringList sentences;
    const ModeBeat* modes = nullptr;
    for (const FittedTrend& trend : trends) {
        const auto* beat = std::get_if<Beat>(&trend.fit);
        if (!beat) {
            modes = &std::get<ModeBeat>(trend.fit);
            continue;
        }
        const Reading amplitude = changeOf(scaleOf(*shown.analysis, trend, units), beat->value,
                                           beat->amplitude, beat->sd_amplitude);
        sentences << Words::tr("%1: amplitude %2 %3, damping %4 1/s")
                         .arg(displaySymbol(trend.variable, units),
                              valueText(amplitude.value, amplitude.sd),
                              displayUnit(trend.variable, units, shown.unit),
                              valueText(beat->damping_per_s, beat->sd_damping_per_s));
    }
    if (modes) {
        sentences << Words::tr(
                         "%1: no damped sinusoid, but the sum of two modes, which beat at "
                         "%2 Hz")
                         .arg(ofModes(trends, units).join(QStringLiteral(", ")),
                              valueText(modes->frequency_hz, modes->sd_frequency_hz));
    }
    return sentences;
}

// Nothing where the windows between the times do not determine it.
std::optional<FittedTrend> fitTrend(const Analysis& analysis, SlowVariable variable, TrendKind kind,
                                    double from_s, double to_s) {
    const Track& track = analysis.track;
    const auto [from, to] = std::minmax(from_s, to_s);
    const std::size_t apart = windows_apart(analysis.plan.length, analysis.plan.hop);
    const auto fitted = [variable](const auto& fit) {
        return fit ? std::optional(FittedTrend{variable, *fit}) : std::nullopt;
    };
    return kind == TrendKind::beat
               ? fitted(find_beat(track, variable, from, to, apart))
               : fitted(line_trend(track, variable, from, to, apart, kindOf(variable)));
}

// Of a beat its frequency, Hz; of a line the rate per second at the middle.
Reading trendReading(const Analysis& analysis, const FittedTrend& trend,
                     const DisplayUnits& units) {
    if (const auto* beat = std::get_if<Beat>(&trend.fit)) {
        return {beat->frequency_hz, beat->sd_frequency_hz};
    }
    if (const auto* modes = std::get_if<ModeBeat>(&trend.fit)) {
        return {modes->frequency_hz, modes->sd_frequency_hz};
    }
    const DisplayScale scale = scaleOf(analysis, trend, units);
    const auto& line = std::get<Trend>(trend.fit);
    const double middle = trend.at(line.centre_s);
    // Of an exponential: its logarithm's rate times its value.
    const double stored = kindOf(trend.variable) == TrendOf::logarithm ? middle : 1;
    return changeOf(scale, middle, line.slope_per_s * stored, line.sd_slope_per_s * stored);
}

// What the trends of one kind say in words, a sentence each.
QStringList trendSentences(const ShownAnalysis& shown, TrendKind kind,
                           const std::vector<FittedTrend>& trends, const DisplayUnits& units) {
    if (trends.empty()) {
        return {
            kind == TrendKind::beat
                ? Words::tr("Between the cursors neither a damped sinusoid of 1¼ to 100 periods "
                            "nor the sum of two modes follows the windows within their noise. A "
                            "beat that you see has another form or fewer periods: see the page "
                            "Resonator.")
                : Words::tr("Too few windows between the cursors.")};
    }
    return kind == TrendKind::beat ? beatSentences(shown, trends, units)
                                   : lineSentences(trends, units);
}

// The value of a window.
Reading readingAt(const Analysis& analysis, SlowVariable variable, std::size_t row,
                  const DisplayUnits& units) {
    const DisplayScale scale = displayScale(variable, units, analysis.f0_hz());
    const double stored = analysis.track.values(variable)[row];
    Reading reading;
    reading.value = scale.value(stored);
    if (info(variable).has_sd) {
        reading.sd = scale.sd(stored, analysis.track.sds(variable)[row]);
    }
    return reading;
}

// The difference between two windows, without deviation where they share samples. Wrapped angles
// differ by half a turn at most.
Reading differenceOf(const Analysis& analysis, SlowVariable variable, std::size_t from,
                     std::size_t to, const DisplayUnits& units) {
    const Reading a = readingAt(analysis, variable, from, units);
    const Reading b = readingAt(analysis, variable, to, units);
    Reading difference;
    difference.value = b.value - a.value;
    const DisplayScale scale = displayScale(variable, units, analysis.f0_hz());
    if (const double turn = isWrapped(variable) ? 2 * std::numbers::pi : scale.period; turn > 0) {
        difference.value = std::remainder(difference.value, turn * scale.factor);
    }
    if (std::max(from, to) - std::min(from, to) >=
        windows_apart(analysis.plan.length, analysis.plan.hop)) {
        difference.sd = std::hypot(a.sd, b.sd);
    }
    return difference;
}

// Trends of more windows than that are fitted to the chosen analysis alone.
constexpr std::size_t quick_rows = 100'000;

std::vector<FittedTrend> trendsBetween(const Analysis& analysis, const Measuring& measuring) {
    std::vector<FittedTrend> trends;
    if (!isInside(analysis, measuring.a_s) || !isInside(analysis, measuring.b_s)) {
        return trends;
    }
    const auto [from, to] = std::minmax(*measuring.a_s, *measuring.b_s);
    std::vector<SlowVariable> bent;  // as no damped sinusoid is
    for (const SlowVariable variable : main_slow_variables) {
        if (auto trend = fitTrend(analysis, variable, measuring.kind, from, to)) {
            trends.push_back(std::move(*trend));
        } else if (measuring.kind == TrendKind::beat) {
            const auto line = fitTrend(analysis, variable, TrendKind::line, from, to);
            if (line && std::get<Trend>(line->fit).enlargement > 1) {
                bent.push_back(variable);
            }
        }
    }
    if (bent.empty()) {
        return trends;
    }
    const auto modes = find_mode_beat(analysis.track, analysis.f0_hz(),
                                      analysis.settings.calibration.two_theta_zero(), from, to,
                                      windows_apart(analysis.plan.length, analysis.plan.hop));
    for (const SlowVariable variable : bent) {
        if (modes) {
            trends.push_back({variable, *modes});
        }
    }
    return trends;
}

// For a spreadsheet: the head, then of each variable its symbol, its unit and what `read` reads.
template <class Read>
QString tableOf(const QStringList& head, const auto& variables, const DisplayUnits& units,
                const QString& of_file, Read read) {
    QStringList lines{head.join(QLatin1Char('\t'))};
    for (const SlowVariable variable : variables) {
        QStringList cells{
            withUnit(displaySymbol(variable, units), displayUnit(variable, units, of_file))};
        for (const Reading& reading : read(variable)) {
            cells << exactText(reading.value) << exactText(reading.sd);
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

}  // namespace

double FittedTrend::at(double time_s) const {
    if (const auto* modes = std::get_if<ModeBeat>(&fit)) {
        return modes->at(variable, time_s);
    }
    if (const auto* beat = std::get_if<Beat>(&fit)) {
        return beat->at(time_s);
    }
    const double value = std::get<Trend>(fit).at(time_s);
    return kindOf(variable) == TrendOf::logarithm ? std::exp(value) : value;
}

TrendCurve curveOf(const Analysis& analysis, const FittedTrend& trend, double from_s, double to_s,
                   const DisplayUnits& units) {
    const DisplayScale scale = scaleOf(analysis, trend, units);
    const double span = std::abs(to_s - from_s);
    const auto* beat = std::get_if<Beat>(&trend.fit);
    const auto* modes = std::get_if<ModeBeat>(&trend.fit);
    const double beats = (beat ? beat->frequency_hz : modes ? modes->frequency_hz : 0) * span;
    const int points = std::max(curve_points, static_cast<int>(points_per_beat * beats));
    TrendCurve curve;
    curve.variable = trend.variable;
    double last = std::numeric_limits<double>::quiet_NaN();
    for (int k = 0; k <= points; ++k) {
        const double time_s = std::min(from_s, to_s) + span * k / points;
        double value = trend.at(time_s);
        if (modes && trend.variable == SlowVariable::two_theta_A) {  // known modulo half a turn
            const Track& track = analysis.track;
            const double near = track.values(trend.variable)[nearestRow(track, time_s)];
            last = std::isfinite(near) ? near : last;
            value = std::isfinite(last) ? nearest_branch(value, last, std::numbers::pi) : value;
        }
        curve.time_s.push_back(time_s);
        curve.value.push_back(scale.value(value));
    }
    return curve;
}

QString trendSummary(TrendKind kind, const std::vector<FittedTrend>& trends,
                     const DisplayUnits& units) {
    if (trends.empty()) {
        return kind == TrendKind::beat ? Words::tr("nothing fits") : Words::tr("too few windows");
    }
    QStringList words;
    if (kind == TrendKind::line) {
        const FittedTrend* amplitude = find(trends, SlowVariable::a_A);
        const auto decay = amplitude ? decay_time(std::get<Trend>(amplitude->fit)) : std::nullopt;
        if (decay) {
            words << Words::tr("τ(%1) %2 s")
                         .arg(displaySymbol(SlowVariable::a_A, units),
                              conciseText(decay->tau_s, decay->sd_s));
        }
        if (const FittedTrend* angle = find(trends, SlowVariable::two_theta_A)) {
            const auto& line = std::get<Trend>(angle->fit);
            words << Words::tr("drift %1 °/h")
                         .arg(conciseText(line.slope_per_s * degrees_an_hour,
                                          line.sd_slope_per_s * degrees_an_hour));
        }
    }
    if (const QStringList names = leaving(trends, units); !names.isEmpty()) {
        words << Words::tr("sd enlarged: %1").arg(names.join(QLatin1Char(' ')));
    }
    if (const QStringList names = ofModes(trends, units); !names.isEmpty()) {
        words << Words::tr("two modes: %1").arg(names.join(QLatin1Char(' ')));
    }
    return words.join(QStringLiteral(", "));
}

std::size_t nearestRow(const Track& track, double time_s) {
    const auto times = track.time_s();
    const auto after = std::ranges::lower_bound(times, time_s);
    auto row = static_cast<std::size_t>(after - times.begin());
    if (row == times.size() || (row > 0 && time_s - times[row - 1] < times[row] - time_s)) {
        --row;
    }
    return row;
}

bool isInside(const Analysis& analysis, const std::optional<double>& time_s) {
    return time_s && analysis.track.rows() > 0 && covers(analysis, *time_s);
}

void MeasuredTrends::fit(const Document& document, const Measuring& measuring, AnalysisId chosen) {
    Measuring wanted = measuring;
    wanted.mouse_s.reset();
    const std::vector<Entry> before =
        wanted == measured_ ? std::exchange(entries_, {}) : std::vector<Entry>();
    measured_ = wanted;
    entries_.clear();
    for (const AnalysisEntry& entry : document.analyses()) {
        const ShownAnalysis& shown = entry.shown;
        const bool quick =
            wanted.kind != TrendKind::beat && shown.analysis->track.rows() <= quick_rows;
        if (!wanted.both() || !shown.visible || !(shown.id == chosen || quick)) {
            continue;
        }
        const auto known = std::ranges::find_if(before, [&shown](const Entry& each) {
            return each.id == shown.id && each.analysis == shown.analysis;
        });
        entries_.push_back(known != before.end() ? *known
                                                 : Entry{shown.id, shown.analysis,
                                                         trendsBetween(*shown.analysis, wanted)});
    }
}

const std::vector<FittedTrend>& MeasuredTrends::of(AnalysisId id) const {
    static const std::vector<FittedTrend> none;
    const auto found = std::ranges::find(entries_, id, &Entry::id);
    return found == entries_.end() ? none : found->trends;
}

Reading readingOf(const Analysis& analysis, SlowVariable variable, ReadAt at,
                  const Measuring& measuring, const std::vector<FittedTrend>& trends,
                  const DisplayUnits& units) {
    const auto window = [&](const std::optional<double>& time_s) {
        return isInside(analysis, time_s)
                   ? readingAt(analysis, variable, nearestRow(analysis.track, *time_s), units)
                   : Reading();
    };
    switch (at) {
        case ReadAt::mouse: return window(measuring.mouse_s);
        case ReadAt::a: return window(measuring.a_s);
        case ReadAt::b: return window(measuring.b_s);
        case ReadAt::difference:
            return isInside(analysis, measuring.a_s) && isInside(analysis, measuring.b_s)
                       ? differenceOf(analysis, variable,
                                      nearestRow(analysis.track, *measuring.a_s),
                                      nearestRow(analysis.track, *measuring.b_s), units)
                       : Reading();
        case ReadAt::rate: break;
    }
    const FittedTrend* trend = find(trends, variable);
    return trend ? trendReading(analysis, *trend, units) : Reading();
}

QString reasonAt(const Analysis& analysis, double time_s) {
    return isInside(analysis, time_s)
               ? flagsText(analysis.track.flags()[nearestRow(analysis.track, time_s)])
               : Words::tr("no windows there");
}

// A large swing is no sinusoid, yet the modes beat with the split that their resonator has.
QStringList measuredSentences(const Document& document, const AnalysisEntry& entry,
                              const Measuring& measuring, const std::vector<FittedTrend>& trends,
                              const DisplayUnits& units) {
    QStringList sentences = trendSentences(entry.shown, measuring.kind, trends, units);
    if (measuring.kind != TrendKind::beat) {
        return sentences;
    }
    for (const RecordingSet& set : document.sets().all()) {
        const auto outcome = document.sets().outcome(set);
        if (!outcome || std::ranges::count(outcome->set.recordings, number(entry.recording_id),
                                           &RecordingRef::id) == 0) {
            continue;
        }
        const Estimate& split = outcome->identification.fit.resonator.split_hz;
        if (split.given()) {
            sentences << Words::tr("The resonator of this recording beats at its split, %1 Hz")
                             .arg(valueText(split.value, split.uncertainty()));
        }
    }
    return sentences;
}

QString mouseTable(const Document& document, const Measuring& measuring,
                   const DisplayUnits& units) {
    std::vector<const ShownAnalysis*> shown;
    for (const AnalysisEntry& entry : document.analyses()) {
        if (entry.shown.visible && entry.shown.analysis->track.rows() > 0) {
            shown.push_back(&entry.shown);
        }
    }
    if (shown.empty()) {
        return {};
    }
    Measuring here = measuring;
    here.mouse_s = measuring.mouse_s.value_or(shown.front()->analysis->track.time_s().front());
    QStringList head{Words::tr("t = %1 s").arg(exactText(*here.mouse_s))};
    QStringList file_units;
    for (const ShownAnalysis* each : shown) {
        head << each->name << Words::tr("sd");
        file_units << each->unit;
    }
    return tableOf(
        head, shown_slow_variables, units, commonUnit(file_units), [&](SlowVariable variable) {
            std::vector<Reading> readings;
            readings.reserve(shown.size());
            for (const ShownAnalysis* each : shown) {
                readings.push_back(
                    readingOf(*each->analysis, variable, ReadAt::mouse, here, {}, units));
            }
            return readings;
        });
}

QString cursorTable(const ShownAnalysis& shown, const Measuring& measuring,
                    const std::vector<FittedTrend>& trends, const DisplayUnits& units) {
    const Analysis& analysis = *shown.analysis;
    if (!isInside(analysis, measuring.a_s) || !isInside(analysis, measuring.b_s)) {
        return {};
    }
    const QString sd = Words::tr("sd");
    const QString rate =
        measuring.kind == TrendKind::beat ? Words::tr("Beat, Hz") : Words::tr("Rate, per s");
    const QStringList head{shown.name, Words::tr("A = %1 s").arg(exactText(*measuring.a_s)),
                           sd,         Words::tr("B = %1 s").arg(exactText(*measuring.b_s)),
                           sd,         Words::tr("B − A"),
                           sd,         rate,
                           sd};
    return tableOf(head, main_slow_variables, units, shown.unit, [&](SlowVariable variable) {
        const auto at = [&](ReadAt place) {
            return readingOf(analysis, variable, place, measuring, trends, units);
        };
        return std::array{at(ReadAt::a), at(ReadAt::b), at(ReadAt::difference), at(ReadAt::rate)};
    });
}

}  // namespace vybeg::ui
