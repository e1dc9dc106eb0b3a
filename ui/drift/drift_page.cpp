#include "ui/drift/drift_page.h"

#include "ui/drift/drift_panel.h"
#include "ui/drift/drift_text.h"
#include "ui/plots/xy_plot_view.h"
#include "ui/resonator/warning_list.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace vybeg::ui {

namespace {

constexpr int panel_width = 216;
constexpr int least_plot_height = 260;
constexpr int hint_width = 460;

}  // namespace

DriftPage::DriftPage(Document& document, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      panel_(new DriftPanel(document, this)),
      export_(withName(new QPushButton(this), "driftExport")),
      state_(sentence(this, "driftState")),
      hint_(withName(new QLabel(this), "driftHint")) {
    setObjectName(QStringLiteral("driftPage"));
    hint_->setWordWrap(true);
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setMaximumWidth(hint_width);
    auto* row = fill(new QHBoxLayout, {6, 0, 6, 0}, {export_});
    auto* left = fill(new QVBoxLayout, {}, 0, {panel_, row, state_, LayoutPart(1)});
    auto* side = new QWidget(this);
    side->setLayout(left);
    side->setFixedWidth(panel_width);
    content_ = buildContent();
    fill(new QHBoxLayout(this), {}, 4, {side, {hint_, 1, Qt::AlignCenter}, {content_, 1}});
    connect(panel_, &DriftPanel::openWanted, this, &DriftPage::openWanted);
    connect(export_, &QPushButton::clicked, this, &DriftPage::exportResultWanted);
    connect(&document_.drift(), &DriftStore::changed, this, &DriftPage::refresh);
    guardFromWheel(*this);
    retranslate();
}

QWidget* DriftPage::buildContent() {
    auto* content = new QWidget(this);
    plot_ = addPlot("driftPlot", least_plot_height);
    warnings_ = withName(new WarningList(content), "driftWarnings");
    harmonics_ = withName(new QuantityTable(this), "driftHarmonics");
    agreement_ = sentence(content, "driftAgreement");
    resonator_ = withName(new QuantityTable(this), "driftResonator");
    statistical_ = sentence(content, "driftStatistical");
    auto* numbers = new QVBoxLayout;
    numbers->setSpacing(2);
    numbers->addWidget(warnings_);
    harmonics_section_ = addSection(*numbers, {harmonics_, agreement_});
    resonator_section_ = addSection(*numbers, {resonator_, statistical_});
    numbers->addStretch(1);
    fill(new QHBoxLayout(content), {}, 4, {{plot_, 3}, {scrolled(numbers), 2}});
    return content;
}

void DriftPage::setUnits(const DisplayUnits& units) {
    units_ = units;
    showFound();
}

FigureSource DriftPage::figures() const {
    return shown_ ? figuresOf({plot_}, QStringLiteral("drift"), QString()) : FigureSource();
}

void DriftPage::refresh() {
    if (!document_.drift().computing()) {
        shown_ = document_.drift().outcome();
    }
    showFound();
}

// Empty where the drift says all.
QString DriftPage::stateText() const {
    const DriftStore& drift = document_.drift();
    if (drift.computing()) {
        return tr("The drift is being computed…");
    }
    return shown_ || !drift.failure()
               ? QString()
               : tr("There is no drift: %1").arg(errorText(*drift.failure()));
}

void DriftPage::showFound() {
    const QString state = stateText();
    state_->setVisible(shown_ && !state.isEmpty());
    state_->setText(richText(state));
    hint_->setVisible(!shown_);
    hint_->setText(!state.isEmpty()
                       ? state
                       : tr("Open whole-angle logs: a controller holds the amplitude while the "
                            "wave turns by 180 degrees or more, and its angle is written down over "
                            "the time. Here appear the drift against the angle with its harmonics, "
                            "and, where the log has the efforts, the resonator's damping and "
                            "split."));
    content_->setVisible(shown_ != nullptr);
    export_->setEnabled(document_.drift().outcome() != nullptr);
    if (shown_) {
        const WholeAngleDrift& drift = shown_->drift;
        plot_->setContent(wholeAnglePlot(drift, units_));
        warnings_->setFindings(findings_of(drift.warnings));
        harmonics_->setContent(logHeaders(drift), logRows(drift, units_));
        agreement_->setText(paragraphs(agreementTexts(drift), QStringLiteral("%1")));
        resonator_->setContent({}, heldRows(drift.resonator, units_));
        statistical_->setText(richText(channelsText(pick_offs(shown_->settings.tolerance))));
    }
    emit figuresChanged();
}

void DriftPage::retranslate() {
    const auto name = [](Section* section, QWidget* widget, const QString& title) {
        section->setTitle(title);
        widget->setAccessibleName(title);
    };
    name(harmonics_section_, harmonics_, tr("Drift of the angle"));
    name(resonator_section_, resonator_, tr("Resonator, from drift and efforts"));
    harmonics_->setToolTip(
        tr("The turn and the harmonics of the drift; of several logs each by itself, too. Ctrl+C "
           "copies the table"));
    resonator_->setToolTip(tr("Ctrl+C copies the table"));
    plot_->setAccessibleName(tr("Drift against the angle"));
    plot_->setToolTip(richTip(
        tr("Drift of the wave angle less the turn of each log: means over ranges of the angle with "
           "their standard deviations, and the fitted harmonics with theirs as a band")));
    export_->setText(tr("Export result…"));
    export_->setToolTip(tr("The drift by angle as a table (CSV), or the whole result (JSON)"));
    showFound();
}

}  // namespace vybeg::ui
