#include "ui/resonator/numbers_view.h"

#include "ui/resonator/resonator_text.h"
#include "ui/resonator/warning_list.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

// Names of the recordings, with a mark at those with a finding below the table.
QStringList markedNames(const ResonatorOutcome& outcome) {
    QStringList names;
    for (std::size_t k = 0; k < outcome.set.recordings.size(); ++k) {
        const bool warned =
            count_warnings(findings_of(outcome.identification.runs[k].diagnostics)) > 0;
        names << (warned ? QStringLiteral("⚠ ") : QString()) +
                     QString::fromStdString(outcome.set.recordings[k].name());
    }
    return names;
}

}  // namespace

NumbersView::NumbersView(QWidget* parent)
    : OutcomeView(parent),
      findings_(withName(new WarningList(this), "findings")),
      warnings_(withName(new WarningList(this), "warnings")),
      statistical_(sentence(this, "statistical")),
      waves_(withName(new QuantityTable(this), "waves")),
      resonator_(withName(new QuantityTable(this), "resonator")),
      sensitivities_(withName(new QuantityTable(this), "sensitivities")),
      modes_(withName(new QuantityTable(this), "modes")),
      runs_(withName(new QuantityTable(this), "runs")) {
    statistical_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(statistical_, &QLabel::linkActivated, this,
            [this] { emit gainRatioChosen(shown_->identification.fit.resonator.kappa); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(warnings_);
    resonator_section_ = addSection(*column, {resonator_, statistical_});
    waves_section_ = addSection(*column, {waves_, findings_});
    sensitivities_section_ = addSection(*column, {sensitivities_});
    modes_section_ = addSection(*column, {modes_});
    runs_section_ = addSection(*column, {runs_});
    keepTranslated(*this, [this] { retranslate(); });
}

void NumbersView::setLimits(const std::vector<ParameterLimit>& limits) {
    limits_ = limits;
    rebuild();
}

void NumbersView::rebuild() {
    setVisible(shown_ != nullptr);
    if (!shown_) {
        return;
    }
    const ResonatorOutcome& outcome = *shown_;
    const Identification& found = outcome.identification;
    const std::vector<Finding> findings = recordingFindings(outcome);
    const bool has_findings = !findings.empty();
    warnings_->setFindings(findings_of(found.fit.warnings));
    findings_->setFindings(findings);
    waves_->setContent(markedNames(outcome), waveRows(found, units_));
    // The result of a session holds no motion of the waves.
    const bool has_motion = std::ranges::any_of(found.runs, [](const IdentifiedRun& run) {
        return !run.wave.f_hz.given() || std::isfinite(run.wave.f_hz.value);
    });
    waves_->setVisible(has_motion);
    waves_section_->setVisible(has_motion || has_findings);
    const auto rows = resonatorRows(found, units_, limits_, theme_);
    const QStringList headers{tr("Value"), tr("Limits")};
    resonator_->setContent(limits_.empty() ? QStringList() : headers, rows);
    resonator_section_->setVisible(!rows.empty());
    const QString offer = gainRatioOffer(found);
    statistical_->setText(offer.isEmpty()
                              ? uncertaintyText(found)
                              : offer + QStringLiteral("<br>") + uncertaintyText(found));
    const auto sensitivities = sensitivityRows(found, units_);
    sensitivities_->setContent(sensitivityHeaders(), sensitivities);
    sensitivities_section_->setVisible(!sensitivities.empty());
    modes_section_->setTitle(modesTitle(found.fit));
    modes_->setContent({}, modeRows(found.fit));
    runs_->setContent(markedNames(outcome), runRows(found, units_));
}

QString NumbersView::modesTitle(const ResonatorFit& fit) {
    if (fit.modes.empty()) {
        return tr("Modes");
    }
    return fit.mode_order == ModeOrder::decay ? tr("Modes, by decay") : tr("Modes, by frequency");
}

void NumbersView::retranslate() {
    const auto name = [](Section* section, QWidget* widget, const QString& title) {
        section->setTitle(title);
        widget->setAccessibleName(title);
    };
    name(waves_section_, waves_, tr("Motion of the waves"));
    name(resonator_section_, resonator_, tr("Resonator"));
    name(sensitivities_section_, sensitivities_,
         tr("Sensitivity: by how much a value would be wrong"));
    name(modes_section_, modes_, tr("Modes"));
    name(runs_section_, runs_, tr("Recordings of the set"));
    rebuild();
}

}  // namespace vybeg::ui
