#include "ui/report/report_sections.h"

#include "ui/report/budget_text.h"
#include "ui/report/drift_section.h"
#include "ui/report/options_text.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_html.h"
#include "ui/report/resonator_section.h"
#include "ui/resonator/resonator_text.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/settings_text.h"
#include "ui/words/unit_text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

// Events of an analysis that are listed; of the rest the number.
constexpr std::size_t most_events = 60;

const QString none = QStringLiteral("—");

QString seconds(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

// A rate in Hz with its own digits.
QString rateText(double rate_hz) {
    return QLocale().toString(rate_hz, 'g', 12);
}

// The findings as sentences, beyond `most` their number.
QStringList sentences(const std::vector<Finding>& findings, std::size_t most) {
    QStringList texts;
    for (std::size_t k = 0; k < std::min(findings.size(), most); ++k) {
        texts << findingText(findings[k]);
    }
    if (findings.size() > most) {
        texts << moreText(findings.size() - most);
    }
    return texts;
}

QStringList sentences(const std::vector<Finding>& findings) {
    return sentences(findings, findings.size());
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
               : sentences(findings_of(*recording.check)).join(QStringLiteral(" "));
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
        table.rows.push_back({bold(each.name), each.format.toHtmlEscaped(),
                              each.start.isEmpty() ? none : each.start.toHtmlEscaped(),
                              rateText(each.rate_hz), seconds(each.seconds, 3)});
        const QString hash = each.sha256.isEmpty()
                                 ? ReportWords::tr("not computed yet").toHtmlEscaped()
                                 : monospaced(each.sha256);
        table.rows.push_back({QStringLiteral("SHA-256: ") + hash});
        if (!each.is_log) {
            table.rows.push_back({ReportWords::tr("Check: %1").arg(richText(checkText(each)))});
        }
        if (!each.conditions.isEmpty()) {
            table.rows.push_back(
                {ReportWords::tr("Conditions: %1")
                     .arg(each.conditions.join(QStringLiteral("; ")).toHtmlEscaped())});
        }
    }
    return heading(ReportWords::tr("Recordings"), true) + html(table);
}

QString settingsSection(const ReportContent& content) {
    if (content.analyses.empty()) {
        return {};
    }
    HtmlTable table{{ReportWords::tr("Recording"), ReportWords::tr("Algorithm"),
                     ReportWords::tr("Window, hop (samples)"), ReportWords::tr("Windows"),
                     withUnit(ReportWords::tr("Mean frequency"), unitText("Hz")),
                     withUnit(ReportWords::tr("Instant of the mean"), unitText("s")),
                     ReportWords::tr("Noise σ")},
                    {},
                    {16, 18, 13, 9, 21, 13, 10}};
    for (const ReportAnalysis& each : content.analyses) {
        const Analysis& analysis = *each.shown.analysis;
        const QLocale locale;
        table.rows.push_back({content.recordings[each.recording].name.toHtmlEscaped(),
                              algorithmText(analysis.settings.algorithm).toHtmlEscaped(),
                              QStringLiteral("%1, %2").arg(
                                  locale.toString(static_cast<qint64>(analysis.plan.length)),
                                  locale.toString(static_cast<qint64>(analysis.plan.hop))),
                              locale.toString(static_cast<qint64>(analysis.plan.count)),
                              valueText(each.means.mean_f_hz, each.means.sd_mean_f_hz),
                              shortNumberText(each.means.mean_at_s, 4),
                              noiseText(each.means.noise)});
        if (const QString options = optionsText(analysis.settings); !options.isEmpty()) {
            table.rows.push_back({monospaced(options)});
        }
    }
    return heading(ReportWords::tr("Analyses and their settings")) + html(table);
}

QString plotsSection(const ReportContent& content) {
    QString text;
    for (std::size_t k = 0; k < content.recordings.size(); ++k) {
        const auto is_of = [k](const ReportAnalysis& analysis) { return analysis.recording == k; };
        if (std::ranges::any_of(content.analyses, is_of)) {
            text += heading(ReportWords::tr("Slow variables: %1").arg(content.recordings[k].name),
                            true) +
                    figureHtml(plotsName(content, k));
        }
    }
    return text;
}

QString eventsSection(const ReportContent& content) {
    if (content.analyses.empty()) {
        return {};
    }
    QString text = heading(ReportWords::tr("Events"));
    bool any = false;
    for (const ReportAnalysis& each : content.analyses) {
        if (each.events.empty()) {
            continue;
        }
        any = true;
        HtmlTable table{{ReportWords::tr("Time, s"), ReportWords::tr("Event")}, {}, {14, 86}};
        for (std::size_t k = 0; k < std::min(each.events.size(), most_events); ++k) {
            table.rows.push_back(
                {seconds(each.events[k].time_s, 4), richText(eventText(each.events[k]))});
        }
        if (each.events.size() > most_events) {
            table.rows.push_back({ReportWords::tr("Further events: %1")
                                      .arg(static_cast<qint64>(each.events.size() - most_events))});
        }
        text += smallHeading(QStringLiteral("%1, %2").arg(content.recordings[each.recording].name,
                                                          each.shown.name)) +
                html(table);
    }
    return any ? text : text + paragraph(ReportWords::tr("No axis crossings, no gaps."));
}

// What the analyses found beside the recording check, which stands with the recordings.
std::vector<NamedWarnings> warningsOfAnalyses(const ReportContent& content) {
    std::vector<NamedWarnings> all;
    for (const ReportAnalysis& each : content.analyses) {
        const ReportRecording& recording = content.recordings[each.recording];
        std::vector<Diagnostic> found = each.shown.analysis->diagnostics;
        std::erase_if(found, [&recording](const Diagnostic& diagnostic) {
            return recording.check &&
                   std::ranges::find(*recording.check, diagnostic) != recording.check->end();
        });
        all.emplace_back(recording.name.toStdString(), std::move(found));
    }
    return all;
}

QString warningsPart(const QString& title, const std::vector<Finding>& findings) {
    return findings.empty() ? QString() : smallHeading(title) + items(sentences(findings));
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
            all.emplace_back(recording.name.toStdString(), *recording.check);
        }
    }
    std::vector<Finding> findings = findings_of(all);
    findings.resize(count_warnings(findings));
    return smallHeading(ReportWords::tr("Warnings")) +
           (findings.empty() ? paragraph(ReportWords::tr("None."))
                             : items(sentences(findings, most_shown)));
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

// The page to be signed.
QString firstPage(const ReportContent& content) {
    return resultSection(content) + worstWarnings(content) + signatures(content.title);
}

}  // namespace

QString titleBlock(const ReportTitle& title, const QString& made) {
    // Lines to write on by hand where nothing is told.
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
    const QString first = firstPage(content);
    return content.summary ? first
                           : first + recordingsSection(content) + settingsSection(content) +
                                 plotsSection(content) + resonatorSection(content) +
                                 wholeAngleSection(content, true) + eventsSection(content) +
                                 warningsSection(content);
}

}  // namespace vybeg::ui
