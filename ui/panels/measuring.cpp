#include "ui/panels/measuring.h"

#include "ui/values/curve_data.h"
#include "ui/words/error_text.h"
#include "ui/words/unit_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace vybeg::ui {

namespace {

struct MeasuringWords {
    Q_DECLARE_TR_FUNCTIONS(Measuring)
};

// Trends of more windows than that are fitted to the chosen analysis alone.
constexpr std::size_t quick_rows = 100'000;

std::vector<FittedTrend> trendsBetween(const Analysis& analysis, const Measuring& measuring) {
    std::vector<FittedTrend> trends;
    if (isInside(analysis, measuring.a_s) && isInside(analysis, measuring.b_s)) {
        for (const SlowVariable variable : main_slow_variables) {
            if (auto trend =
                    fitTrend(analysis, variable, measuring.kind, *measuring.a_s, *measuring.b_s)) {
                trends.push_back(std::move(*trend));
            }
        }
    }
    return trends;
}

// Symbol and unit: "ω_cp/2π, Hz".
QString nameWithUnit(SlowVariable variable, const DisplayUnits& units) {
    return withUnit(displaySymbol(variable, units), displayUnit(variable, units));
}

}  // namespace

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
    const auto found = std::ranges::find(trends, variable, &FittedTrend::variable);
    return found == trends.end() ? Reading() : trendReading(analysis, *found, units);
}

QString reasonAt(const Analysis& analysis, double time_s) {
    return isInside(analysis, time_s)
               ? flagsText(analysis.track.flags()[nearestRow(analysis.track, time_s)])
               : MeasuringWords::tr("no windows there");
}

// A large swing is no sinusoid, yet the modes beat with the split that their resonator has.
QStringList measuredSentences(const Document& document, const AnalysisEntry& entry,
                              const Measuring& measuring, const std::vector<FittedTrend>& trends,
                              const DisplayUnits& units) {
    QStringList sentences = trendSentences(*entry.shown.analysis, measuring.kind, trends, units);
    if (measuring.kind != TrendKind::beat) {
        return sentences;
    }
    for (const RecordingSet& set : document.sets().all()) {
        const auto outcome = document.sets().outcome(set);
        if (!outcome || std::ranges::find(outcome->recordings, entry.recording_id) ==
                            outcome->recordings.end()) {
            continue;
        }
        const Estimate& split = outcome->identification.fit.resonator.split_hz;
        if (split.given()) {
            sentences << MeasuringWords::tr(
                             "The resonator of this recording beats at its split, %1 Hz")
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
    QStringList head{MeasuringWords::tr("t = %1 s").arg(exactText(*here.mouse_s))};
    for (const ShownAnalysis* each : shown) {
        head << each->name << MeasuringWords::tr("sd");
    }
    QStringList lines{head.join(QLatin1Char('\t'))};
    for (const SlowVariable variable : shown_slow_variables) {
        QStringList cells{nameWithUnit(variable, units)};
        for (const ShownAnalysis* each : shown) {
            const Reading reading =
                readingOf(*each->analysis, variable, ReadAt::mouse, here, {}, units);
            cells << exactText(reading.value) << exactText(reading.sd);
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QString cursorTable(const ShownAnalysis& shown, const Measuring& measuring,
                    const std::vector<FittedTrend>& trends, const DisplayUnits& units) {
    const Analysis& analysis = *shown.analysis;
    if (!isInside(analysis, measuring.a_s) || !isInside(analysis, measuring.b_s)) {
        return {};
    }
    const QString sd = MeasuringWords::tr("sd");
    const QString rate = measuring.kind == TrendKind::beat ? MeasuringWords::tr("Beat, Hz")
                                                           : MeasuringWords::tr("Rate, per s");
    QStringList lines{QStringList{shown.name,
                                  MeasuringWords::tr("A = %1 s").arg(exactText(*measuring.a_s)), sd,
                                  MeasuringWords::tr("B = %1 s").arg(exactText(*measuring.b_s)), sd,
                                  MeasuringWords::tr("B − A"), sd, rate, sd}
                          .join(QLatin1Char('\t'))};
    for (const SlowVariable variable : main_slow_variables) {
        QStringList cells{nameWithUnit(variable, units)};
        for (const ReadAt at : {ReadAt::a, ReadAt::b, ReadAt::difference, ReadAt::rate}) {
            const Reading reading = readingOf(analysis, variable, at, measuring, trends, units);
            cells << exactText(reading.value) << exactText(reading.sd);
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

}  // namespace vybeg::ui
