#include "ui/report/drift_section.h"

#include "ui/drift/drift_text.h"
#include "ui/report/budget_text.h"
#include "ui/report/options_text.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_html.h"

namespace vybeg::ui {

namespace {

// Columns of values that a page has room for: all logs together and two of them.
constexpr qsizetype most_logs = 3;

QString filesOf(const DriftOutcome& outcome) {
    HtmlTable table{{}, {}, {30, 70}, true};
    for (std::size_t k = 0; k < outcome.logs.size(); ++k) {
        table.rows.push_back(
            {QStringLiteral("<b>%1</b>").arg(logName(outcome.drift, k).toHtmlEscaped()),
             QStringLiteral("SHA-256: ") +
                 monospaced(QString::fromStdString(outcome.logs[k].sha256))});
    }
    return html(table);
}

}  // namespace

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

}  // namespace vybeg::ui
