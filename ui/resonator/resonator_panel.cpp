#include "ui/resonator/resonator_panel.h"

#include "ui/plots/xy_plot_view.h"
#include "ui/resonator/difference_text.h"
#include "ui/resonator/resonator_text.h"
#include "ui/resonator/set_panel.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/quantity_table.h"
#include "ui/widgets/section.h"
#include "ui/widgets/wheel_guard.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

QLabel* sentence(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setContentsMargins(6, 2, 6, 2);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    return label;
}

QString paragraphs(const QStringList& texts, const QString& form) {
    QString html;
    for (const QString& text : texts) {
        html += QStringLiteral("<p style=\"margin:2px 0\">%1</p>").arg(form.arg(richText(text)));
    }
    return html;
}

// Names of the recordings, with a mark at those with a finding below the table.
QStringList markedNames(const ResonatorOutcome& outcome) {
    QStringList names;
    for (std::size_t k = 0; k < outcome.inputs.size(); ++k) {
        const bool warned = !outcome.identification.runs[k].diagnostics.empty();
        names << (warned ? QStringLiteral("⚠ ") : QString()) +
                     QString::fromStdString(outcome.inputs[k].name);
    }
    return names;
}

double changedFrom(const std::vector<Difference>& differences) {
    const auto compared = std::ranges::count_if(differences, [](const Difference& each) {
        return each.verdict != Verdict::not_comparable;
    });
    return changed_from(static_cast<std::size_t>(compared));
}

}  // namespace

ResonatorPanel::ResonatorPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      theme_(lightTheme()),
      set_(new SetPanel(document, this)),
      state_(sentence(this)) {
    state_->setObjectName(QStringLiteral("state"));
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    const auto table = [content](const char* name) {
        auto* made = new QuantityTable(content);
        made->setObjectName(QLatin1String(name));
        return made;
    };
    const auto plot = [this, content](const char* name) {
        auto* made = new XYPlotView(content);
        made->setObjectName(QLatin1String(name));
        connect(made, &XYPlotView::exportWanted, this,
                [this, made] { emit exportWanted(made->content()); });
        return made;
    };
    findings_ = sentence(content);
    findings_->setObjectName(QStringLiteral("findings"));
    waves_section_ = addSection(*column, {waves_ = table("waves"), findings_});
    warnings_ = sentence(content);
    warnings_->setObjectName(QStringLiteral("warnings"));
    column->addWidget(warnings_);
    statistical_ = sentence(content);
    resonator_section_ = addSection(*column, {resonator_ = table("resonator"), statistical_});
    sensitivities_section_ = addSection(*column, {sensitivities_ = table("sensitivities")});
    modes_section_ = addSection(*column, {modes_ = table("modes")});
    runs_section_ = addSection(*column, {runs_ = table("runs")});
    drift_section_ =
        addSection(*column, {drift_plot_ = plot("drift"), drift_ = table("harmonics")});
    balance_section_ = addSection(*column, {balance_plot_ = plot("balance")});
    passport_ = sentence(content);
    incomparable_ = sentence(content);
    close_passport_ = new QPushButton(content);
    auto* limit = new QWidget(content);
    limit_label_ = new QLabel(limit);
    limit_ = new NumberField(limit);
    limit_->setLimits(0, 1e6);
    limit_->setUnit(QStringLiteral("ppm"));
    limit_label_->setBuddy(limit_);
    auto* limit_line = new QHBoxLayout(limit);
    limit_line->setContentsMargins(6, 0, 6, 0);
    limit_line->addWidget(limit_label_);
    limit_line->addWidget(limit_, 1);
    track_choice_ = new QComboBox(content);
    track_choice_->addItems({QString(), QString(), QString()});  // in the order of TrackVariable
    comparison_section_ =
        addSection(*column, {passport_, limit, differences_ = table("differences"), incomparable_,
                             track_choice_, tracks_ = plot("tracks"), close_passport_});
    column->addStretch(1);

    auto* scroll = new QScrollArea(this);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(set_);
    layout->addWidget(state_);
    layout->addWidget(scroll, 1);

    connect(close_passport_, &QPushButton::clicked, &document_.sets(), &SetStore::closePassport);
    connect(limit_, &NumberField::valueEdited, this,
            [this](auto ppm) { document_.sets().setFrequencyLimit(*ppm); });
    connect(track_choice_, &QComboBox::activated, this, &ResonatorPanel::rebuild);
    connect(&document_.sets(), &SetStore::changed, this, &ResonatorPanel::refresh);
    connect(&document_, &Document::recordingChanged, this, &ResonatorPanel::refresh);
    connect(&document_.sets(), &SetStore::passportChanged, this, &ResonatorPanel::rebuild);
    guardFromWheel(*this);
    retranslate();
}

Section* ResonatorPanel::addSection(QVBoxLayout& layout, std::initializer_list<QWidget*> parts) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(2);
    for (QWidget* part : parts) {
        column->addWidget(part);
    }
    auto* section = new Section(content);
    layout.addWidget(section);
    return section;
}

void ResonatorPanel::setUnits(const DisplayUnits& units) {
    units_ = units;
    rebuild();
}

void ResonatorPanel::setTheme(const Theme& theme) {
    theme_ = theme;
    for (XYPlotView* plot : {drift_plot_, balance_plot_, tracks_}) {
        plot->setTheme(theme);
    }
    rebuild();
}

void ResonatorPanel::showComparison() {
    comparison_section_->setOpen(true);
}

// Changes of the settings, many per second during a drag, affect only the state of the result.
void ResonatorPanel::refresh() {
    const RunSet* set = document_.sets().current();
    const auto outcome = set ? document_.sets().outcome(*set) : nullptr;
    if (outcome != shown_) {
        rebuild();
    } else {
        showState(set, outcome.get());
    }
}

void ResonatorPanel::rebuild() {
    const RunSet* set = document_.sets().current();
    shown_ = set ? document_.sets().outcome(*set) : nullptr;
    showState(set, shown_.get());
    for (Section* section : {waves_section_, resonator_section_, sensitivities_section_,
                             modes_section_, runs_section_, drift_section_, balance_section_}) {
        section->setVisible(shown_ != nullptr);
    }
    warnings_->hide();
    if (shown_) {
        showResult(*shown_);
    }
    showDifferences(shown_.get());
}

void ResonatorPanel::showState(const RunSet* set, const ResonatorOutcome* outcome) {
    if (!outcome) {
        state_->setText(document_.sets().canIdentify()
                            ? tr("Nothing identified yet.")
                            : tr("Open recordings of a free decay to identify the resonator."));
        return;
    }
    const ResonatorFit& fit = outcome->identification.fit;
    const QString model =
        fit.model == ResonatorModel::structured ? tr("Structured model") : tr("Free model");
    QString text = tr("%1, %n recording(s); χ² per degree of freedom %2", nullptr,
                      static_cast<int>(outcome->inputs.size()))
                       .arg(model, shortNumberText(fit.chi2_per_dof, 3));
    if (document_.sets().outOfDate(*set, *outcome)) {
        text = QStringLiteral("<b style=\"color:%1\">⚠ %2</b> %3")
                   .arg(readable(theme_.warning, theme_).name(), tr("Out of date."),
                        tr("The set or its settings have changed since: identify again.")) +
               QStringLiteral("<br>") + text;
    }
    state_->setText(text);
}

void ResonatorPanel::showResult(const ResonatorOutcome& outcome) {
    const Identification& found = outcome.identification;
    const QStringList warnings = warningTexts(outcome);
    warnings_->setText(paragraphs(warnings, QStringLiteral("⚠ %1")));
    warnings_->setVisible(!warnings.isEmpty());
    const QStringList findings = findingTexts(outcome);
    findings_->setText(paragraphs(findings, QStringLiteral("⚠ %1")));
    findings_->setVisible(!findings.isEmpty());
    waves_->setContent(markedNames(outcome), waveRows(found, units_));
    const auto rows = resonatorRows(found, units_);
    resonator_->setContent({}, rows);
    resonator_section_->setVisible(!rows.empty());
    const auto sensitivities = sensitivityRows(found, units_);
    sensitivities_->setContent(sensitivityHeaders(), sensitivities);
    sensitivities_section_->setVisible(!sensitivities.empty());
    modes_section_->setTitle(modesTitle(found.fit));
    modes_->setContent({}, modeRows(found.fit));
    runs_->setContent(markedNames(outcome), runRows(found, units_));
    drift_plot_->setContent(driftPlot(outcome, units_));
    drift_section_->setVisible(found.fit.model == ResonatorModel::structured);
    drift_->setContent({}, driftRows(found, units_));
    balance_plot_->setContent(balancePlot(outcome));
    balance_section_->setVisible(!found.balance.empty());
}

QString ResonatorPanel::modesTitle(const ResonatorFit& fit) {
    if (fit.modes.empty()) {
        return tr("Modes");
    }
    return fit.mode_order == ModeOrder::decay ? tr("Modes, by decay") : tr("Modes, by frequency");
}

void ResonatorPanel::showDifferences(const ResonatorOutcome* outcome) {
    const OpenPassport* passport = document_.sets().passport();
    comparison_section_->setVisible(passport != nullptr);
    if (!passport) {
        return;
    }
    const QString name = passport->name.toHtmlEscaped();
    const std::vector<Difference> differences = document_.sets().differences();
    passport_->setText(outcome
                           ? tr("Compared with %1. Changed: by %2 uncertainties u of the "
                                "difference or more; by chance in one comparison of 370.")
                                 .arg(name, QLocale().toString(changedFrom(differences), 'f', 1))
                           : tr("%1 is open: identify the set to compare.").arg(name));
    limit_->setValue(document_.sets().frequencyLimit());
    const QStringList reasons = incomparableTexts(differences);
    for (QWidget* part : std::initializer_list<QWidget*>{differences_, track_choice_, tracks_}) {
        part->setVisible(outcome != nullptr);
    }
    incomparable_->setVisible(!reasons.isEmpty());
    if (outcome) {
        differences_->setContent(differenceHeaders(), differenceRows(differences, units_, theme_));
        incomparable_->setText(paragraphs(reasons, tr("Not comparable: %1")));
        tracks_->setContent(trackPlot(*outcome, passport->passport,
                                      static_cast<TrackVariable>(track_choice_->currentIndex()),
                                      units_));
    }
}

void ResonatorPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void ResonatorPanel::retranslate() {
    const auto name = [](Section* section, QWidget* widget, const QString& title) {
        section->setTitle(title);
        widget->setAccessibleName(title);
    };
    name(waves_section_, waves_, tr("What the waves did"));
    name(resonator_section_, resonator_, tr("Resonator"));
    name(sensitivities_section_, sensitivities_, tr("Sensitivity to the channels"));
    name(modes_section_, modes_, tr("Modes"));
    name(runs_section_, runs_, tr("Runs of the set"));
    name(drift_section_, drift_plot_, tr("Drift function"));
    name(balance_section_, balance_plot_, tr("Channel balance, condition (30)"));
    name(comparison_section_, differences_, tr("Comparison with the passport"));
    statistical_->setText(
        tr("± is the statistical standard deviation; u, where it differs, holds the tolerances of "
           "the channels (Calibration) too. Errors of the channels without a tolerance count as "
           "none: the next table shows what they would change."));
    limit_label_->setText(tr("Frequencies change from"));
    limit_->setAccessibleName(tr("Frequencies change from"));
    limit_->setToolTip(
        richTip(tr("Frequencies follow the temperature: smaller changes, in parts per million, are "
                   "none of the gyro")));
    drift_->setAccessibleName(tr("Harmonics of the drift function"));
    drift_plot_->setToolTip(
        richTip(tr("Drift of the wave angle against the angle: measured points with their standard "
                   "deviations, and the harmonics fitted to them; dashed: by the fitted resonator. "
                   "Without what the quadrature adds")));
    balance_plot_->setToolTip(
        richTip(tr("Zero within its band while the channels are balanced as the fit has them")));
    tracks_->setAccessibleName(tr("Tracks of the runs and of the passport"));
    tracks_->setToolTip(richTip(tr("Lines: these recordings; dashed: the passport")));
    track_choice_->setAccessibleName(tr("What to overlay"));
    const QString variables[] = {tr("Amplitude of the working wave"),
                                 tr("Amplitude of the quadrature wave"), tr("Wave angle")};
    for (int index = 0; index < track_choice_->count(); ++index) {
        track_choice_->setItemText(index, variables[index]);
    }
    close_passport_->setText(tr("Close the passport"));
    rebuild();
}

}  // namespace vybeg::ui
