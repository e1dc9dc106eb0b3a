#include "ui/resonator/outcome_views.h"

#include "ui/charts/round_plot.h"
#include "ui/resonator/parameter_text.h"
#include "ui/resonator/resonator_text.h"
#include "ui/resonator/run_text.h"
#include "ui/resonator/warning_list.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/short_names.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {

namespace {

const QString fold = QStringLiteral("fold");

// The recordings as rows, in their colours, with a mark at those with a finding below the table.
std::vector<QuantityRow> recordingRows(const SetResult& outcome, const RunStyles& styles,
                                       const Theme& theme) {
    QStringList files;
    for (const RecordingRef& recording : outcome.set.recordings) {
        files << QString::fromStdString(recording.name());
    }
    const QStringList names = recordingNames(files);
    std::vector<QuantityRow> rows;
    for (std::size_t k = 0; k < outcome.set.recordings.size(); ++k) {
        const bool warned =
            count_warnings(findings_of(outcome.identification.runs[k].diagnostics)) > 0;
        const auto place = static_cast<qsizetype>(k);
        rows.push_back({(warned ? QStringLiteral("⚠ ") : QString()) + names[place],
                        files[place],
                        {},
                        inkColor(Ink::style, styles[k], theme)});
    }
    return rows;
}

}  // namespace

OutcomeView::OutcomeView(Document& document, QWidget* parent)
    : MeasuredPage(parent), document_(document) {
    // An analysis gives its recording a colour.
    connect(&document_, &Document::analysesChanged, this, [this] {
        if (shown_ && runStyles(document_, *shown_) != styles_) {
            setOutcome(shown_);
        }
    });
}

void OutcomeView::setOutcome(std::shared_ptr<const SetResult> outcome) {
    shown_ = std::move(outcome);
    styles_ = shown_ ? runStyles(document_, *shown_) : RunStyles();
    showAgain();
}

NumbersView::NumbersView(Document& document, QWidget* parent)
    : OutcomeView(document, parent),
      warnings_(withName(new WarningList(this), "warnings")),
      resonator_(withName(new QuantityTable(this), "resonator")),
      reason_(sentence(this, "reason")),
      statistical_(sentence(this, "statistical")),
      tabs_(withName(new QTabWidget(this), "outcomeTabs")),
      findings_(withName(new WarningList(this), "findings")),
      waves_(withName(new QuantityTable(this), "waves")),
      runs_{withName(new QuantityTable(this), "runs"),
            withName(new QuantityTable(this), "directions")},
      modes_(withName(new QuantityTable(this), "modes")),
      sensitivities_(withName(new QuantityTable(this), "sensitivities")) {
    statistical_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(statistical_, &QLabel::linkActivated, this, [this](const QString& link) {
        if (link == fold) {
            told_ = !told_;
            showStatistical();
        } else {
            emit calibrationChosen(link, foundCalibration(shown_->identification));
        }
    });
    resonator_->setMouseTracking(true);
    connect(resonator_, &QTableWidget::itemEntered, this, &NumbersView::say);
    connect(resonator_, &QTableWidget::currentItemChanged, this, &NumbersView::say);
    // Two lines, so that nothing moves below it.
    reason_->setMinimumHeight(2 * fontMetrics().lineSpacing() + 2 * around_sentence.top());
    tabs_->setDocumentMode(true);
    tabs_->setUsesScrollButtons(false);
    auto* recordings = new QWidget(this);
    fill(new QVBoxLayout(recordings), {}, 2, {waves_, findings_, runs_[0], runs_[1]});
    recordings_tab_ = addTab(recordings);
    modes_tab_ = addTab(modes_);
    sensitivities_tab_ = addTab(sensitivities_);
    fill(new QVBoxLayout(this), {}, 2, {warnings_, resonator_, reason_, statistical_, {tabs_, 1}});
    connect(&document_.passport(), &PassportStore::changed, this, &NumbersView::showAgain);
    connect(&document_.dossier(), &DossierModel::changed, this, &NumbersView::showAgain);
    retranslate();
}

int NumbersView::addTab(QWidget* content) {
    return tabs_->addTab(scrolled(fill(new QVBoxLayout, {content, LayoutPart(1)})), QString());
}

void NumbersView::showAgain() {
    for (const int tab : {recordings_tab_, modes_tab_, sensitivities_tab_}) {
        tabs_->setTabVisible(tab, shown_ != nullptr);
    }
    for (QWidget* part :
         std::initializer_list<QWidget*>{warnings_, resonator_, reason_, statistical_}) {
        part->setVisible(shown_ != nullptr);
    }
    if (!shown_) {
        return;
    }
    const SetResult& outcome = *shown_;
    const Identification& found = outcome.identification;
    const std::vector<Finding> findings = recordingFindings(outcome);
    warnings_->setFindings(findings_of(found.fit.warnings));
    findings_->setFindings(findings);
    const auto recordings = recordingRows(outcome, styles_, theme());
    waves_->setColumns(waveRows(found, units(), RunForm::column), recordings);
    // The result of a session holds no motion of the waves.
    const bool has_motion = std::ranges::any_of(found.runs, [](const IdentifiedRun& run) {
        return !run.wave.f_hz.given() || std::isfinite(run.wave.f_hz.value);
    });
    waves_->setVisible(has_motion);
    showParameters();
    showStatistical();
    const auto sensitivities = sensitivityRows(found, units());
    QStringList changed;
    for (const QString& header : sensitivityHeaders(found, units())) {
        changed << indexPlain(header);
    }
    sensitivities_->setContent(changed, sensitivities);
    tabs_->setTabVisible(sensitivities_tab_, !sensitivities.empty());
    tabs_->setTabText(modes_tab_, modesTitle(found.fit));
    modes_->setContent({}, modeRows(found.fit));
    // The wave at its start, then the rest.
    constexpr std::ptrdiff_t of_start = 5;
    const auto columns = runRows(found, units(), RunForm::column);
    runs_[0]->setColumns({columns.begin(), columns.begin() + of_start}, recordings);
    runs_[1]->setColumns({columns.begin() + of_start, columns.end()}, recordings);
}

// Of the free model its modes.
void NumbersView::showParameters() {
    const Identification& found = shown_->identification;
    auto rows = resonatorRows(found, units(), document_.dossier().dossier().limits,
                              document_.passport().differences(found.fit), theme());
    const bool structured = !rows.empty();
    int absent = -1;  // the first
    for (std::size_t k = rows.size(); k-- > 0;) {
        const ResonatorParameter& parameter = resonator_parameters[k];
        const Estimate& estimate = found.fit.resonator.*parameter.member;
        if (QuantityCell& value = rows[k].cells.front(); !estimate.given()) {
            value.tip = std::exchange(value.text, absenceWord(parameter, estimate.reason, units()));
            absent = static_cast<int>(k);
        }
    }
    QStringList headers = resonatorHeaders();
    dropEmptyColumns(headers, rows);
    resonator_->setContent(headers, structured ? rows : modeRows(found.fit));
    tabs_->setTabVisible(modes_tab_, structured);
    reason_->setVisible(absent >= 0);
    say(resonator_->item(absent, 1));
}

// The reason in the row of an item, if it has one.
void NumbersView::say(const QTableWidgetItem* item) {
    const QTableWidgetItem* value = item ? resonator_->item(item->row(), 1) : nullptr;
    if (const QString tip = value ? value->data(Qt::AccessibleTextRole).toString() : QString();
        !tip.isEmpty()) {
        const QString name = resonator_->item(item->row(), 0)->text();
        reason_->setText(richText(
            QStringLiteral("* %1: %2")
                .arg(name.section(QLatin1Char(','), 0, 0).section(QLatin1Char(' '), -1), tip)));
    }
}

void NumbersView::showStatistical() {
    const Identification& found = shown_->identification;
    const QString whole = uncertaintyText(found);
    const QString link =
        QStringLiteral(" <a href=\"%1\">%2</a>").arg(fold, told_ ? tr("Less") : tr("Tolerances"));
    const QString words = (told_ ? whole : uncertaintyWords(found)) + link;
    const QString offer = calibrationOffers(foundCalibration(found));
    statistical_->setText(offer.isEmpty() ? words : offer + QStringLiteral("<br>") + words);
    statistical_->setToolTip(richTip(whole));
}

QString NumbersView::modesTitle(const ResonatorFit& fit) {
    if (fit.modes.empty()) {
        return tr("Modes");
    }
    return fit.mode_order == ModeOrder::decay ? tr("Modes, by decay") : tr("Modes, by frequency");
}

void NumbersView::retranslate() {
    const auto name = [this](int tab, QWidget* widget, const QString& title, const QString& tip) {
        tabs_->setTabText(tab, title);
        tabs_->setTabToolTip(tab, tip);
        setWords(*widget, title, tip);
    };
    setWords(*resonator_, tr("Resonator"), tr("Ctrl+C copies the table"));
    setWords(*waves_, tr("Motion of the waves"),
             tr("What the wave of each recording did, free of the model"));
    for (QuantityTable* table : runs_) {
        name(recordings_tab_, table, tr("Recordings"),
             tr("What the wave of each recording did, and what the fit found of it"));
    }
    name(modes_tab_, modes_, tr("Modes"), tr("Frequencies and decay times of both modes"));
    name(sensitivities_tab_, sensitivities_, tr("Sensitivity"),
         tr("By how much errors of a usual size would falsify a value"));
    showAgain();
}

FiguresView::FiguresView(Document& document, QWidget* parent)
    : OutcomeView(document, parent),
      hint_(sentence(this, "hint")),
      plots_(new QWidget(this)),
      rim_name_(sentence(plots_, "")),
      rim_(withPart(withName(new RoundView(true, plots_), "rim"))),
      drift_name_(sentence(plots_, "")),
      drift_plot_(withPart(withName(new XYPlotView(plots_), "drift"))),
      drift_(sentence(plots_, "harmonics")),
      copy_drift_(new QAction(drift_)),
      balance_(new QWidget(this)),
      balance_name_(sentence(balance_, "")),
      balance_axis_(new QComboBox(balance_)),
      balance_plot_(withPart(withName(new XYPlotView(balance_), "balance"))) {
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setMinimumHeight(120);
    rim_->setMinimumSize(240, 250);
    constexpr int least_drift_height = 170;
    drift_plot_->setMinimumHeight(least_drift_height);
    drift_plot_->setMaximumHeight(QWIDGETSIZE_MAX);
    fill(new QVBoxLayout(plots_), {}, 2,
         {rim_name_, {rim_, 3}, drift_name_, drift_, {drift_plot_, 2}});
    drift_->addAction(copy_drift_);
    drift_->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(copy_drift_, &QAction::triggered, this, [this] {
        QGuiApplication::clipboard()->setText(
            tableText({}, driftRows(shown_->identification, units())));
    });
    balance_axis_->addItems({QString(), QString()});  // in the order of BalanceAxis
    balance_name_->setBuddy(balance_axis_);
    auto* head = fill(new QHBoxLayout, {{balance_name_, 1}, balance_axis_});
    fill(new QVBoxLayout(balance_), {}, 2, {head, balance_plot_});
    fill(new QVBoxLayout(this), {}, 2, {hint_, {plots_, 1}});
    connect(balance_axis_, &QComboBox::activated, this, &FiguresView::showBalance);
    retranslate();
}

FigureSource FiguresView::figures() const {
    if (plots_->isHidden()) {
        return {};
    }
    return sourceOf({{rim_->accessibleName(), rim_->figure()},
                     {drift_plot_->accessibleName(), drift_plot_->figure()},
                     {balance_plot_->accessibleName(), balance_plot_->figure()}},
                    QStringLiteral("resonator"), QString());
}

void FiguresView::showAgain() {
    const bool structured =
        shown_ && shown_->identification.fit.model == ResonatorModel::structured;
    plots_->setVisible(structured);
    balance_->setVisible(structured);
    hint_->setVisible(!structured);
    hint_->setText(shown_ ? reasonText({ReasonCode::free_model, {}})
                          : tr("Rim, drift and balance of the channels appear here when the "
                               "resonator is identified."));
    if (structured) {
        rim_->setContent(rimPlot(*shown_, styles_));
        drift_plot_->setContent(driftPlot(*shown_, units(), styles_));
        const auto harmonics = driftRows(shown_->identification, units());
        drift_->setVisible(shown_->identification.drift.order > 0);
        drift_->setText(richText(driftSentence(harmonics, units())));
        QStringList whole;
        for (const QuantityRow& row : harmonics) {
            whole << richText(row.name + QStringLiteral(": ") + row.cells.front().text);
        }
        drift_->setToolTip(paragraphs(whole, QStringLiteral("%1")));
        showBalance();
    }
}

void FiguresView::showBalance() {
    if (shown_) {
        const auto axis = static_cast<BalanceAxis>(balance_axis_->currentIndex());
        balance_plot_->setContent(balancePlot(*shown_, axis, units(), styles_));
    }
}

void FiguresView::retranslate() {
    const auto head = [](QLabel* label, QWidget* widget, const QString& title) {
        label->setText(QStringLiteral("<b>%1</b>").arg(title));
        widget->setAccessibleName(title);
    };
    head(rim_name_, rim_, tr("Rim"));
    head(drift_name_, drift_plot_, tr("Drift function"));
    head(balance_name_, balance_plot_, tr("Channel balance, condition (30)"));
    rim_->setToolTip(
        richTip(tr("The rim from the side of the electrodes, clockwise from C: electrodes, the "
                   "axes of the faster mode (θ_w) and of larger damping (θ_τ) as wide as their "
                   "standard deviations, and the wave of each recording at its start, out of "
                   "scale")));
    balance_axis_->setAccessibleName(tr("What the balance is drawn against"));
    setTexts(*balance_axis_, {tr("over time"), tr("over the wave angle")});
    drift_->setAccessibleName(tr("Harmonics of the drift function"));
    copy_drift_->setText(tr("Copy harmonics"));
    drift_plot_->setToolTip(richTip(
        tr("Drift of the wave angle against the angle: measured points with their standard "
           "deviations, and the harmonics fitted to them with their combined uncertainty u as "
           "a band; dashed: by the fitted resonator. Without what the quadrature adds")));
    balance_plot_->setToolTip(
        richTip(tr("Zero within its band while the channels are balanced as the fit has them")));
    showAgain();
}

ComparisonView::ComparisonView(Document& document, QWidget* parent)
    : OutcomeView(document, parent),
      passport_(sentence(this, "passport")),
      other_gyro_(sentence(this, "otherGyro")),
      differences_(withName(new QuantityTable(this), "differences")),
      incomparable_(sentence(this, "incomparable")),
      track_choice_(new QComboBox(this)),
      tracks_(withPart(withName(new XYPlotView(this), "tracks"))),
      close_(new QPushButton(this)) {
    auto* limit = new QWidget(this);
    limit_label_ = new QLabel(limit);
    limit_ = new NumberField(limit);
    limit_->setLimits(0, 1e6);
    limit_->setUnit(QStringLiteral("ppm"));
    limit_label_->setBuddy(limit_);
    fill(new QHBoxLayout(limit), {6, 0, 6, 0}, {limit_label_, {limit_, 1}});
    track_choice_->addItems({QString(), QString(), QString()});  // in the order of SlowVariable
    fill(new QVBoxLayout(this), {}, 2,
         {passport_, other_gyro_, limit, differences_, incomparable_, track_choice_, tracks_,
          close_});
    connect(close_, &QPushButton::clicked, &document_.passport(), &PassportStore::close);
    connect(limit_, &NumberField::valueEdited, this,
            [this](auto ppm) { document_.passport().setFrequencyLimit(*ppm); });
    connect(track_choice_, &QComboBox::activated, this, &ComparisonView::showAgain);
    connect(&document_.passport(), &PassportStore::changed, this, &ComparisonView::showAgain);
    connect(&document_.dossier(), &DossierModel::changed, this, &ComparisonView::showAgain);
    retranslate();
}

void ComparisonView::showAgain() {
    const PassportInput& input = document_.passport().input();
    const Passport* passport = input.passport.get();
    setVisible(passport != nullptr);
    if (!passport) {
        return;
    }
    const QString name = QFileInfo(pathText(input.file)).fileName().toHtmlEscaped();
    const std::vector<Difference> differences =
        shown_ ? document_.passport().differences(shown_->identification.fit)
               : std::vector<Difference>();
    const auto other = document_.sets().otherGyro(*passport, document_.dossier().dossier().gyro);
    other_gyro_->setText(other ? QStringLiteral("⚠ ") + diagnosticText(*other) : QString());
    other_gyro_->setVisible(other.has_value());
    passport_->setText(
        shown_
            ? tr("Compared with %1. Changed: by %2 uncertainties u of the "
                 "difference or more; by chance in one comparison of 370.")
                  .arg(name, QLocale().toString(changed_from(count_compared(differences)), 'f', 1))
            : tr("%1 is open: identify the set to compare.").arg(name));
    limit_->setValue(input.f_limit_ppm);
    const QStringList reasons = incomparableTexts(differences);
    for (QWidget* part : std::initializer_list<QWidget*>{differences_, track_choice_, tracks_}) {
        part->setVisible(shown_ != nullptr);
    }
    incomparable_->setVisible(!reasons.isEmpty());
    if (shown_) {
        differences_->setContent(differenceHeaders(),
                                 differenceRows(differences, units(), theme()));
        incomparable_->setText(paragraphs(reasons, tr("Not comparable: %1")));
        tracks_->setContent(trackPlot(*shown_, *passport,
                                      static_cast<SlowVariable>(track_choice_->currentIndex()),
                                      units(), styles_));
    }
}

void ComparisonView::retranslate() {
    differences_->setAccessibleName(tr("Comparison with the passport"));
    limit_label_->setText(tr("Frequencies change from"));
    setWords(
        *limit_, tr("Frequencies change from"),
        richTip(tr("Frequencies follow the temperature: smaller changes, in parts per million, are "
                   "none of the gyro")));
    setWords(
        *tracks_, tr("Tracks of the recordings and of the passport"),
        richTip(tr("In the colours of the recordings; further from the background: the passport")));
    track_choice_->setAccessibleName(tr("What to overlay"));
    setTexts(*track_choice_, {tr("Amplitude of the working wave"),
                              tr("Amplitude of the quadrature wave"), tr("Wave angle")});
    close_->setText(tr("Close the passport"));
    showAgain();
}

}  // namespace vybeg::ui

#include "moc_outcome_views.cpp"
