#include "ui/report/resonator_section.h"

#include "core/output/batch_csv.h"
#include "ui/report/budget_text.h"
#include "ui/report/options_text.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_html.h"
#include "ui/resonator/parameter_text.h"
#include "ui/resonator/resonator_text.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QStringList>

namespace vybeg::ui {

namespace {

// Columns of values that a page has room for.
constexpr qsizetype most_recordings = 2;
constexpr qsizetype most_sources = 5;
constexpr qsizetype most_errors = 4;

QString part(const QString& title, const QString& tables) {
    return tables.isEmpty() ? tables : smallHeading(title) + tables;
}

QString modelText(const Identification& found) {
    const QString model = found.fit.model == ResonatorModel::structured
                              ? ReportWords::tr("Model: calibrated pair of pick-offs")
                              : ReportWords::tr("Model: free");
    return QStringLiteral("%1; χ²/ν = %2").arg(model, shortNumberText(found.fit.chi2_per_dof, 3));
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
        quantityTables(sensitivityHeaders(), rows, most_errors, true));
}

// Whether the limits are kept.
QString verdictText(const ReportContent& content) {
    const Identification& found = content.outcome->identification;
    const LimitVerdict verdict = limit_verdict(&found, content.limits);
    if (!verdict.conformity) {
        return {};
    }
    QStringList failed;
    for (const std::string& parameter : verdict.failed) {
        failed << shownAs(parameter, "", content.units).title;
    }
    const QString names = failed.join(QStringLiteral(", "));
    switch (*verdict.conformity) {
        case Conformity::within: return ReportWords::tr("All limits are kept.");
        case Conformity::outside: return ReportWords::tr("Limits are not kept: %1.").arg(names);
        case Conformity::unknown: break;
    }
    return names.isEmpty()
               ? ReportWords::tr("No verdict: by the warnings, the numbers may be wrong.")
               : ReportWords::tr("No verdict; not shown to be kept: %1.").arg(names);
}

QString figures(const ReportContent& content) {
    const Identification& found = content.outcome->identification;
    return part(ReportWords::tr("Rim and drift function"),
                sideBySide(figureName(content, rim_figure), figureName(content, drift_figure)) +
                    quantityTables({}, driftRows(found, content.units), 1)) +
           part(ReportWords::tr("Balance of the channels, condition (30)"),
                figureHtml(figureName(content, balance_figure)));
}

}  // namespace

QString absenceText(const ReportContent& content) {
    return content.not_identified ? errorText(*content.not_identified)
                                  : ReportWords::tr("It has not been identified.");
}

QString resultSection(const ReportContent& content) {
    QStringList names;
    for (const ReportRecording& recording : content.recordings) {
        names << recording.name;
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
    text += paragraph(modelText(found) + QStringLiteral(". ") + tolerancesText(found));
    if (const QStringList absent = absentTitles(found, content.units); !absent.isEmpty()) {
        text += paragraph(ReportWords::tr("Not shown by the recordings: %1.")
                              .arg(absent.join(QStringLiteral(", "))));
    }
    return text;
}

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
    QString text = heading(title, true) + paragraph(modelText(found));
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
    const QStringList columns{ReportWords::tr("Value"), ReportWords::tr("Limits")};
    text +=
        part(parameters, quantityTables(content.limits.empty() ? QStringList() : columns,
                                        resonatorRows(found, content.units, content.limits), 2));
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

}  // namespace vybeg::ui
