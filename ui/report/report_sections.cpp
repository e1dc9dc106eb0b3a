#include "core/output/batch_csv.h"
#include "core/resonator/results/resonator_parameters.h"
#include "ui/drift/drift_text.h"
#include "ui/report/report_parts.h"
#include "ui/resonator/parameter_text.h"
#include "ui/resonator/resonator_text.h"
#include "ui/resonator/run_text.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/settings_text.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

QStringList budgetHeaders(const Identification& found) {
    QStringList headers{ReportWords::tr("Statistical")};
    for (const ErrorSource source : sources_of(uncertainty_budget(found.fit))) {
        headers << toleranceName(source, found.settings);
    }
    headers << ReportWords::tr("Combined u") << ReportWords::tr("Expanded U = 2u");
    return headers;
}

std::vector<QuantityRow> budgetRows(const Identification& found, const DisplayUnits& units) {
    constexpr int digits = 2;
    const std::vector<ParameterBudget> budget = uncertainty_budget(found.fit);
    const std::vector<ErrorSource> sources = sources_of(budget);
    std::vector<QuantityRow> rows;
    for (const ParameterBudget& each : budget) {
        const Shown shown = shownAs(each.parameter.name, each.parameter.unit, units);
        QuantityRow row = rowOf(shown);
        const auto add = [&](double part) {
            const double value = std::abs(shown.factor) * part;
            row.cells.push_back({shortNumberText(value, digits), {exactText(value)}, {}});
        };
        add(each.statistical);
        for (const ErrorSource source : sources) {
            add(each.shares[source]);
        }
        add(each.combined);
        add(each.expanded);
        rows.push_back(std::move(row));
    }
    return rows;
}

QString absenceText(const ReportContent& content) {
    return content.not_identified ? errorText(*content.not_identified)
                                  : ReportWords::tr("It has not been identified.");
}

namespace {

// Columns of values that a page has room for: all logs together and two of them.
constexpr qsizetype most_logs = 3;

QString filesOf(const DriftOutcome& outcome) {
    HtmlTable table{{}, {}, {30, 70}, true};
    for (std::size_t k = 0; k < outcome.drift.logs.size(); ++k) {
        table.rows.push_back(
            {QStringLiteral("<b>%1</b>").arg(logName(outcome.drift, k).toHtmlEscaped()),
             QStringLiteral("SHA-256: ") +
                 monospaced(QString::fromStdString(outcome.drift.logs[k].sha256))});
    }
    return html(table);
}

// The drift of the whole-angle logs: logs, settings, the drift against the angle, its harmonics,
// and what they say of the resonator. Empty without logs.
QString wholeAngleSection(const ReportContent& content, bool new_page) {
    if (!content.drift) {
        return {};
    }
    const DriftOutcome& outcome = *content.drift;
    QString section =
        heading(ReportWords::tr("Drift of the whole angle"), new_page) + filesOf(outcome);
    if (const QString settings = optionsText(outcome.settings); !settings.isEmpty()) {
        section += QStringLiteral("<p>%1</p>").arg(monospaced(settings));
    }
    if (!content.summary) {
        section += figureHtml(figureName(content, whole_angle_figure));
    }
    section += smallHeading(ReportWords::tr("Drift of the angle")) +
               quantityTables(logHeaders(outcome.drift), logRows(outcome.drift, content.units),
                              most_logs, true);
    for (const QString& sentence : agreementTexts(outcome.drift)) {
        section += paragraph(sentence);
    }
    return section + smallHeading(ReportWords::tr("Resonator, from drift and efforts")) +
           quantityTables({}, heldRows(outcome.drift.resonator, content.units), 1) +
           paragraph(channelsText(pick_offs(outcome.settings.tolerance)));
}

// Columns of values that a page has room for.
constexpr qsizetype most_recordings = 2;
constexpr qsizetype most_sources = 5;
constexpr qsizetype most_changed = 5;

QString part(const QString& title, const QString& tables) {
    return tables.isEmpty() ? tables : smallHeading(title) + tables;
}

// The sources of u.
QString tolerancesText(const Identification& found) {
    const QStringList tolerances = toleranceTexts(found.settings);
    return ReportWords::tr("Tolerances (standard deviations): %1. %2")
        .arg(tolerances.isEmpty() ? ReportWords::tr("none") : tolerances.join(QStringLiteral("; ")),
             clockText(found.settings));
}

QString budget(const Identification& found, const DisplayUnits& units) {
    const auto rows = budgetRows(found, units);
    if (rows.empty()) {
        return {};
    }
    const QString sources = ReportWords::tr(
        "After the GUM (JCGM 100:2008): standard uncertainties in the unit of each parameter; u² "
        "is the sum of the squares; U has the coverage factor 2.");
    return part(ReportWords::tr("Uncertainty budget"),
                paragraph(sources + QLatin1Char(' ') + tolerancesText(found)) +
                    quantityTables(budgetHeaders(found), rows, most_sources, true));
}

QString sensitivities(const Identification& found, const DisplayUnits& units) {
    const auto rows = sensitivityRows(found, units);
    return part(
        rows.empty() ? QString() : ReportWords::tr("Errors that no residual shows would add"),
        quantityTables(sensitivityHeaders(found, units), rows, most_changed, true));
}

// Whether the limits are kept.
QString verdictText(const ReportContent& content) {
    const Identification& found = content.outcome->identification;
    const LimitVerdict verdict = limit_verdict(&found, content.limits);
    if (!verdict.conformity) {
        return {};
    }
    QStringList outside;
    QStringList unknown;
    for (const ResonatorParameter& parameter : resonator_parameters) {
        if (std::ranges::count(verdict.failed, parameter.name) > 0) {
            const bool broken =
                conformity(found.fit.resonator.*parameter.member,
                           *limit_of(content.limits, parameter.name)) == Conformity::outside;
            (broken ? outside : unknown)
                << shownAs(parameter.name, parameter.unit, content.units).title;
        }
    }
    const auto named = [](const QStringList& titles) { return titles.join(QStringLiteral(", ")); };
    switch (*verdict.conformity) {
        case Conformity::within: return ReportWords::tr("All limits are kept.");
        case Conformity::outside: {
            const QString text = ReportWords::tr("Limits are not kept: %1.").arg(named(outside));
            return unknown.isEmpty()
                       ? text
                       : text + QLatin1Char(' ') +
                             ReportWords::tr("Not shown to be kept: %1.").arg(named(unknown));
        }
        case Conformity::unknown: break;
    }
    return verdict.failed.empty()
               ? ReportWords::tr("No verdict: by the warnings, the numbers may be wrong.")
               : ReportWords::tr("No verdict; not shown to be kept: %1.")
                     .arg(named(outside + unknown));
}

QString figures(const ReportContent& content) {
    const Identification& found = content.outcome->identification;
    return part(ReportWords::tr("Rim and drift function"),
                sideBySide(figureName(content, rim_figure), figureName(content, drift_figure)) +
                    quantityTables({}, driftRows(found, content.units), 1)) +
           part(ReportWords::tr("Balance of the channels, condition (30)"),
                figureHtml(figureName(content, balance_figure)));
}

// The result for the page to be signed: values with their expanded uncertainties, limits and
// verdict.
QString resultSection(const ReportContent& content) {
    QStringList names;
    for (const ReportRecording& recording : content.recordings) {
        names << recording.name();
    }
    QString text = heading(ReportWords::tr("Result"));
    if (!names.isEmpty()) {
        text += paragraph(ReportWords::tr("Recordings: %1.").arg(names.join(QStringLiteral(", "))));
    }
    if (!content.outcome) {
        return text + paragraph(absenceText(content));
    }
    const Identification& found = content.outcome->identification;
    QStringList columns{ReportWords::tr("Value ± U (k = 2)")};
    if (!content.limits.empty()) {
        columns << ReportWords::tr("Limits");
    }
    text +=
        quantityTables(columns, resultRows(found, content.units, content.limits), columns.size());
    if (const QString verdict = verdictText(content); !verdict.isEmpty()) {
        text += QStringLiteral("<p><b>%1</b></p>").arg(richText(verdict));
    }
    text += paragraph(fitText(found.fit) + QStringLiteral(". ") + tolerancesText(found));
    if (const QStringList absent = absentTitles(found, content.units); !absent.isEmpty()) {
        text += paragraph(ReportWords::tr("Not shown by the recordings: %1.")
                              .arg(absent.join(QStringLiteral(", "))));
    }
    return text;
}

// The pages of the resonator: parameters with their uncertainties, rim, drift, budget, modes, and
// the data of each recording; or why there are none.
QString resonatorSection(const ReportContent& content) {
    const QString title = ReportWords::tr("Resonator");
    if (!content.outcome) {
        return heading(title) + paragraph(absenceText(content));
    }
    const Identification& found = content.outcome->identification;
    QStringList names;
    for (const RecordingRef& recording : content.outcome->set.recordings) {
        names << QString::fromStdString(recording.name());
    }
    QString text = heading(title, true) + paragraph(fitText(found.fit));
    if (content.out_of_date) {
        text += paragraph(
            ReportWords::tr("Identified with other settings or recordings than the present ones."));
    }
    if (!content.absent.isEmpty()) {
        text += paragraph(ReportWords::tr("Without these recordings of the list: %1.")
                              .arg(content.absent.join(QStringLiteral(", "))));
    }
    if (const QString settings = optionsText(found.settings); !settings.isEmpty()) {
        text += smallHeading(ReportWords::tr("Settings of the identification")) +
                QStringLiteral("<p>%1</p>").arg(monospaced(settings));
    }
    const bool structured = found.fit.model == ResonatorModel::structured;
    const QString parameters =
        ReportWords::tr("Parameters, ± standard deviation (u: with the tolerances)");
    QStringList columns = resonatorHeaders();
    auto rows = resonatorRows(found, content.units, content.limits);
    dropEmptyColumns(columns, rows);
    text += part(parameters, quantityTables(columns, rows, columns.size()));
    text += part(ReportWords::tr("Modes"), quantityTables({}, modeRows(found.fit), 1));
    text += budget(found, content.units) + sensitivities(found, content.units);
    if (structured) {
        text += figures(content);
    }
    text += part(ReportWords::tr("Waves of the recordings, without a model"),
                 quantityTables(names, waveRows(found, content.units), most_recordings, true));
    text += part(ReportWords::tr("Recordings in the fit"),
                 quantityTables(names, runRows(found, content.units), most_recordings, true));
    return text;
}

// Events of an analysis that are listed; of the rest the number.
constexpr std::size_t most_events = 60;

const QString none = QStringLiteral("—");

QString seconds(double value, int decimals) {
    return numberLabel(value, decimals);
}

// A rate in Hz with its own digits.
QString rateText(double rate_hz) {
    return richText(shortNumberText(rate_hz, 12));
}

QString bold(const QString& text) {
    return QStringLiteral("<b>%1</b>").arg(text.toHtmlEscaped());
}

QString checkText(const ReportRecording& recording) {
    if (!recording.check) {
        return ReportWords::tr("not finished yet");
    }
    return recording.check->empty()
               ? ReportWords::tr("no findings")
               : findingTexts(findings_of(*recording.check)).join(QStringLiteral(" "));
}

QString recordingsSection(const ReportContent& content) {
    if (content.recordings.empty()) {
        return {};
    }
    HtmlTable table{{ReportWords::tr("File"), ReportWords::tr("Format"), ReportWords::tr("Start"),
                     withUnit(ReportWords::tr("Rate"), unitText("Hz")),
                     withUnit(ReportWords::tr("Length"), unitText("s"))},
                    {},
                    {26, 29, 18, 14, 13}};
    for (const ReportRecording& each : content.recordings) {
        const QString start = QString::fromStdString(each.file.start);
        table.rows.push_back(
            {bold(each.name()),
             each.format.isEmpty() ? ReportWords::tr("Log") : each.format.toHtmlEscaped(),
             start.isEmpty() ? none : dateText(start).toHtmlEscaped(), rateText(each.file.rate_hz),
             seconds(each.file.seconds, 3)});
        const QString hash = each.file.sha256.empty()
                                 ? ReportWords::tr("not computed yet").toHtmlEscaped()
                                 : monospaced(QString::fromStdString(each.file.sha256));
        table.rows.push_back({QStringLiteral("SHA-256: ") + hash});
        if (!each.format.isEmpty()) {
            table.rows.push_back({ReportWords::tr("Check: %1").arg(richText(checkText(each)))});
        }
        if (const QStringList conditions = conditionsText(each.file); !conditions.isEmpty()) {
            table.rows.push_back({ReportWords::tr("Conditions: %1")
                                      .arg(conditions.join(QStringLiteral("; ")).toHtmlEscaped())});
        }
    }
    return heading(ReportWords::tr("Recordings"), true) + html(table);
}

QString settingsSection(const ReportContent& content) {
    if (!hasAnalyses(content)) {
        return {};
    }
    HtmlTable table{{ReportWords::tr("Recording"), ReportWords::tr("Algorithm"),
                     ReportWords::tr("Window, step (samples)"), ReportWords::tr("Windows"),
                     withUnit(ReportWords::tr("Mean frequency"), unitText("Hz")),
                     withUnit(ReportWords::tr("Instant of the mean"), unitText("s")),
                     ReportWords::tr("Noise σ")},
                    {},
                    {16, 18, 13, 9, 21, 13, 10}};
    for (const ReportRecording& recording : content.recordings) {
        for (const AnalysisEntry& each : recording.analyses) {
            const Analysis& analysis = *each.shown.analysis;
            table.rows.push_back(
                {recording.name().toHtmlEscaped(),
                 algorithmText(analysis.settings.algorithm).toHtmlEscaped(),
                 richText(QStringLiteral("%1, %2").arg(countLabel(analysis.plan.length),
                                                       countLabel(analysis.plan.hop))),
                 richText(countLabel(analysis.plan.count)),
                 valueText(each.summary.mean_f_hz, each.summary.sd_mean_f_hz),
                 seconds(each.summary.mean_at_s, 3), threeDigits(each.summary.noise)});
            if (const QString options = optionsText(analysis.settings); !options.isEmpty()) {
                table.rows.push_back({monospaced(options)});
            }
        }
    }
    return heading(ReportWords::tr("Analyses and their settings")) + html(table);
}

// A name that leaves the heading of a page of figures on one line: with a second one the figure
// does not fit below it. The recordings' table has it whole.
QString inOneLine(const QString& name) {
    constexpr qsizetype most = 34;
    return name.size() <= most ? name
                               : name.left(most / 2) + QChar(0x2026) + name.right(most / 2 - 1);
}

QString plotsSection(const ReportContent& content) {
    QString text;
    for (std::size_t k = 0; k < content.recordings.size(); ++k) {
        if (!content.recordings[k].analyses.empty()) {
            text += heading(ReportWords::tr("Slow variables: %1")
                                .arg(inOneLine(content.recordings[k].name())),
                            true) +
                    figureHtml(plotsName(content, k));
        }
    }
    return text;
}

QString eventsTable(const QString& title, const std::vector<Event>& events) {
    if (events.empty()) {
        return {};
    }
    HtmlTable table{{ReportWords::tr("Time, s"), ReportWords::tr("Event")}, {}, {14, 86}};
    for (std::size_t k = 0; k < std::min(events.size(), most_events); ++k) {
        table.rows.push_back({seconds(events[k].time_s, 4), richText(eventText(events[k]))});
    }
    if (events.size() > most_events) {
        table.rows.push_back({ReportWords::tr("Further events: %1")
                                  .arg(static_cast<qint64>(events.size() - most_events))});
    }
    return smallHeading(title) + html(table);
}

QString eventsSection(const ReportContent& content) {
    if (!hasAnalyses(content)) {
        return {};
    }
    QString tables;
    for (const ReportRecording& recording : content.recordings) {
        for (const AnalysisEntry& each : recording.analyses) {
            tables += eventsTable(QStringLiteral("%1, %2").arg(recording.name(), each.shown.name),
                                  each.events);
        }
    }
    return heading(ReportWords::tr("Events")) +
           (tables.isEmpty() ? paragraph(ReportWords::tr("No axis crossings, no gaps.")) : tables);
}

// The findings of the analyses beside those of the recording check, which are with the recordings.
std::vector<NamedWarnings> warningsOfAnalyses(const ReportContent& content) {
    std::vector<NamedWarnings> all;
    for (const ReportRecording& recording : content.recordings) {
        for (const AnalysisEntry& each : recording.analyses) {
            std::vector<Diagnostic> found = each.shown.analysis->diagnostics;
            std::erase_if(found, [&recording](const Diagnostic& diagnostic) {
                return recording.check &&
                       std::ranges::find(*recording.check, diagnostic) != recording.check->end();
            });
            all.emplace_back(recording.file.name(), std::move(found));
        }
    }
    return all;
}

QString warningsPart(const QString& title, const std::vector<Finding>& findings) {
    return findings.empty() ? QString() : smallHeading(title) + items(findingTexts(findings));
}

// Each kind once, the worst first; of the recordings, of the analyses, of the result.
QString warningsSection(const ReportContent& content) {
    const QString text =
        (content.outcome ? warningsPart(ReportWords::tr("Of the resonator"),
                                        findings_of(content.outcome->identification.fit.warnings))
                         : QString()) +
        (content.drift ? warningsPart(ReportWords::tr("Of the drift of the whole angle"),
                                      findings_of(content.drift->drift.warnings))
                       : QString()) +
        warningsPart(ReportWords::tr("Of the analyses"), findings_of(warningsOfAnalyses(content))) +
        (content.outcome ? warningsPart(ReportWords::tr("Of the recordings in the fit"),
                                        recordingFindings(*content.outcome))
                         : QString());
    return heading(ReportWords::tr("Warnings")) +
           (text.isEmpty() ? paragraph(ReportWords::tr("None.")) : text);
}

// The worst, for the first page; their section has all.
QString worstWarnings(const ReportContent& content) {
    std::vector<NamedWarnings> all;
    if (content.outcome) {
        all.emplace_back("", content.outcome->identification.fit.warnings);
    }
    if (content.drift) {
        all.emplace_back("", content.drift->drift.warnings);
    }
    for (NamedWarnings& each : warningsOfAnalyses(content)) {
        all.push_back(std::move(each));
    }
    for (const ReportRecording& recording : content.recordings) {
        if (recording.check) {
            all.emplace_back(recording.file.name(), *recording.check);
        }
    }
    std::vector<Finding> findings = findings_of(all);
    findings.resize(count_warnings(findings));
    return smallHeading(ReportWords::tr("Warnings")) +
           (findings.empty() ? paragraph(ReportWords::tr("None."))
                             : items(worstOf(findingTexts(findings))));
}

// Lines for those who answer for the report.
QString signatures(const ReportTitle& title) {
    HtmlTable table{
        {QString(), ReportWords::tr("Name"), ReportWords::tr("Date"), ReportWords::tr("Signature")},
        {},
        {16, 34, 18, 32}};
    const auto add = [&table](const QString& what, const QString& name) {
        // Two lines high, to write in.
        table.rows.push_back({what + QStringLiteral("<br>&nbsp;"), name, {}, {}});
    };
    add(bold(ReportWords::tr("Measured")), title.engineer.toHtmlEscaped());
    add(bold(ReportWords::tr("Checked")), {});
    add(bold(ReportWords::tr("Approved")), {});
    return smallHeading(ReportWords::tr("Signatures")) + html(table);
}

}  // namespace

QString titleBlock(const ReportTitle& title, const QString& made) {
    // Lines to write on by hand where a text is empty.
    const QString line = QStringLiteral("____________________________");
    const auto told = [&line](const QString& text) {
        return text.isEmpty() ? line : text.toHtmlEscaped();
    };
    HtmlTable table{{}, {}, {32, 68}};
    for (const TitleField& field : title_fields) {
        table.rows.push_back({bold(ReportWords::tr(field.name)), told(title.*field.text)});
    }
    if (!made.isEmpty()) {
        table.rows.push_back({bold(ReportWords::tr("Report made")), made.toHtmlEscaped()});
    }
    return html(table);
}

QString reportSections(const ReportContent& content) {
    if (ofLogsAlone(content)) {
        return wholeAngleSection(content, false) + warningsSection(content) +
               signatures(content.title);
    }
    // The page to be signed.
    const QString first =
        resultSection(content) + worstWarnings(content) + signatures(content.title);
    return content.summary ? first
                           : first + recordingsSection(content) + settingsSection(content) +
                                 plotsSection(content) + resonatorSection(content) +
                                 wholeAngleSection(content, true) + eventsSection(content) +
                                 warningsSection(content);
}

}  // namespace vybeg::ui
