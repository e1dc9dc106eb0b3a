#include "ui/residuals/residuals_page.h"

#include "core/residuals/find_residuals.h"
#include "ui/document/document.h"
#include "ui/panels/measuring.h"
#include "ui/plots/track_view.h"
#include "ui/residuals/shown_residuals.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace vybeg::ui {

namespace {

constexpr int pause_ms = 120;
constexpr int job_key = 1;
constexpr int least_spectrum_height = 172;
constexpr int least_plot_height = 166;

constexpr QMargins beside{6, 0, 6, 0};  // of a sentence

}  // namespace

ResidualsPage::ResidualsPage(Document& document, TrackView& tracks, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      tracks_(tracks),
      range_(withName(new QComboBox(this), "residualRange")),
      time_(new NumberField(this)),
      lines_(withName(new QComboBox(this), "residualLines")),
      filter_(withName(new QPushButton(this), "residualFilter")),
      state_(sentence(this, "residualState", beside)) {
    setObjectName(QStringLiteral("residuals"));
    range_->addItems({QString(), QString(), QString()});
    range_->setCurrentIndex(static_cast<int>(Range::whole));
    time_->hide();
    time_->setLimits(0, 1e9);
    lines_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* head = fill(new QHBoxLayout, {6, 4, 6, 0},
                      {labelFor(range_, [] { return tr("Residual of"); }), range_, time_,
                       LayoutPart(1), lines_, filter_});
    fill(new QVBoxLayout(this), {}, 4, {head, state_, {scrolled(buildContent()), 1}});

    pause_.setSingleShot(true);
    pause_.setInterval(pause_ms);
    connect(&pause_, &QTimer::timeout, this, &ResidualsPage::compute);
    whenChanged(*this, {QEvent::Show}, [this] { refresh(); });
    whenChanged(*this, {QEvent::Hide}, [this] { stop(); });
    connect(range_, &QComboBox::currentIndexChanged, this, &ResidualsPage::refresh);
    connect(time_, &NumberField::valueEdited, this,
            [this](std::optional<double> time_s) { setCursor(time_s.value_or(cursor_s_)); });
    connect(&document_, &Document::analysesChanged, this, &ResidualsPage::refresh);
    connect(&document_, &Document::recordingChanged, this, &ResidualsPage::refresh);
    connect(&tracks_, &TrackView::timeRangeChanged, this, &ResidualsPage::refresh);
    connect(&tracks_, &TrackView::trackerMoved, this,
            [this](double time_s) { setCursor(tracks_.cursor(Cursor::a).value_or(time_s)); });
    connect(&tracks_, &TrackView::cursorsChanged, this,
            [this] { setCursor(tracks_.cursor(Cursor::a).value_or(cursor_s_)); });
    retranslate();
}

QWidget* ResidualsPage::buildContent() {
    auto* content = new QWidget(this);
    spectrum_ = addPlot("spectrum", least_spectrum_height);
    histogram_ = addPlot("histogram", least_plot_height);
    correlation_ = addPlot("correlation", least_plot_height);
    numbers_ = withName(new QuantityTable(content), "residualNumbers");
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->addWidget(spectrum_, 0, 0, 1, 2);
    grid->addWidget(histogram_, 1, 0);
    grid->addWidget(correlation_, 1, 1);
    grid->addWidget(numbers_, 2, 0, 1, 2);
    grid->setRowStretch(0, 3);
    grid->setRowStretch(1, 2);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    connect(spectrum_, &XYPlotView::pointClicked, this,
            [this](int line) { chooseLine(static_cast<std::size_t>(line)); });
    connect(spectrum_, &XYPlotView::stepWanted, this, [this](int by) {
        const int count = lines_->count();
        lines_->setCurrentIndex((lines_->currentIndex() + by + count) % count);
    });
    connect(lines_, &QComboBox::currentIndexChanged, this, [this](int index) {
        chooseLine(index > 0 ? std::optional(static_cast<std::size_t>(index - 1)) : std::nullopt);
    });
    connect(filter_, &QPushButton::clicked, this, &ResidualsPage::putFilter);
    return content;
}

FigureSource ResidualsPage::figures() const {
    const QString title = entry() ? entry()->shown.recording : QString();
    return figuresOf({spectrum_, histogram_, correlation_}, QStringLiteral("residuals"), title);
}

ResidualsPage::Range ResidualsPage::range() const {
    return static_cast<Range>(range_->currentIndex());
}

const AnalysisEntry* ResidualsPage::entry() const {
    return document_.analysis(analysis_id_);
}

void ResidualsPage::setAnalysis(AnalysisId id) {
    analysis_id_ = id;
    refresh();
}

void ResidualsPage::setCursor(double time_s) {
    cursor_s_ = time_s;
    refresh();
}

std::optional<ResidualsPage::Request> ResidualsPage::wanted() const {
    const AnalysisEntry* chosen = entry();
    if (chosen == nullptr || chosen->partial() || chosen->shown.analysis->track.rows() == 0) {
        return std::nullopt;
    }
    Request request{chosen->shown.analysis, {}};
    switch (range()) {
        case Range::window:
            request.range.window =
                static_cast<std::int64_t>(nearestRow(chosen->shown.analysis->track, cursor_s_));
            break;
        case Range::visible:
            request.range.time = {tracks_.timeRange().lower, tracks_.timeRange().upper};
            break;
        case Range::whole: break;
    }
    return request;
}

QString ResidualsPage::unit() const {
    const AnalysisEntry* chosen = entry();
    const RecordingEntry* recording = chosen ? document_.recording(chosen->recording_id) : nullptr;
    return recording && recording->recording ? channelUnit(*recording->recording) : QString();
}

// Compares the wanted residuals with those shown or under way. Hidden, the page waits.
void ResidualsPage::refresh() {
    time_->setVisible(range() == Range::window);
    time_->setValue(cursor_s_);
    if (!isVisible()) {
        return;
    }
    const auto request = wanted();
    if (request && request == asked_) {
        return;
    }
    asked_ = request;
    computing_ = request.has_value();
    if (request) {
        pause_.start();
        state_->setText(stateText());
    } else {
        pause_.stop();
        job_.forget(job_key);
        found_.reset();
        chosen_.reset();
        showFound();
    }
}

void ResidualsPage::compute() {
    const AnalysisEntry* chosen = entry();
    const RecordingEntry* recording = chosen ? document_.recording(chosen->recording_id) : nullptr;
    if (asked_ && recording && recording->recording) {
        job_.run<Residuals>(
            job_key,
            [of = *recording->recording, asked = *asked_](const JobControl& job) {
                return find_residuals(of, *asked.analysis, asked.range, job);
            },
            [this](Result<Residuals> result) { take(std::move(result)); });
    }
}

void ResidualsPage::take(Result<Residuals> result) {
    computing_ = false;
    chosen_.reset();
    failure_ = result ? std::nullopt : std::optional(result.error());
    found_ = result ? std::optional(std::move(*result)) : std::nullopt;
    showFound();
}

QString ResidualsPage::stateText() const {
    const AnalysisEntry* chosen = entry();
    if (!chosen) {
        return tr(
            "No analysis is chosen. Keep (F5) adds one of the current recording; a row of the "
            "table below chooses one.");
    }
    // The usual name of an analysis begins with that of its recording.
    const ShownAnalysis& shown = chosen->shown;
    const bool told = shown.name.startsWith(QFileInfo(shown.recording).completeBaseName());
    const QString name =
        QStringLiteral("<b>%1.</b> ")
            .arg((told ? shown.name : shown.recording + QStringLiteral(", ") + shown.name)
                     .toHtmlEscaped());
    if (!asked_) {
        return name + tr("The residual appears when all windows of the analysis are there.");
    }
    if (computing_) {
        return name + tr("The residual is being computed…");
    }
    if (failure_) {
        return name + errorText(*failure_).toHtmlEscaped();
    }
    if (found_ && found_->used() == 0) {
        return name + tr("No sample of this range has a wave: samples are missing, the wave is "
                         "circular, or the range lies outside the analysed one.");
    }
    return found_ ? name + coverageText(*found_) +
                        (found_->lines.empty() ? ' ' + tr("No line above the noise.") : QString())
                  : name;
}

void ResidualsPage::showFound() {
    const bool any = found_ && found_->used() > 0;
    const int count = any ? static_cast<int>(found_->lines.size()) : 0;
    {
        const QSignalBlocker quiet(lines_);
        lines_->clear();
        lines_->addItem(tr("%n line(s) above the noise: choose one", nullptr, count));
        for (int k = 0; k < count; ++k) {
            lines_->addItem(lineName(found_->lines[static_cast<std::size_t>(k)]));
        }
    }
    lines_->setVisible(count > 0);
    numbers_->setVisible(any);
    if (any) {
        showNumbers();
    }
    histogram_->setContent(histogramPlot(residuals(), emptyText()));
    correlation_->setContent(correlationPlot(residuals(), emptyText()));
    chooseLine(chosen_);
    emit figuresChanged();
}

// A quantity is a column, a channel a row: as wide as the plots and low.
void ResidualsPage::showNumbers() {
    numbers_->setColumns(residualRows(*found_, unit(), theme().warning),
                         {{QStringLiteral("C"), {}, {}}, {QStringLiteral("D"), {}, {}}});
}

QString ResidualsPage::emptyText() const {
    return found_ ? tr("The range is too short for this plot.") : QString();
}

void ResidualsPage::chooseLine(std::optional<std::size_t> line) {
    chosen_ = found_ && line && *line < found_->lines.size() ? line : std::nullopt;
    const QSignalBlocker quiet(lines_);
    lines_->setCurrentIndex(chosen_ ? static_cast<int>(*chosen_) + 1 : 0);
    spectrum_->setContent(spectrumPlot(residuals(), unit(), chosen_, emptyText()));
    spectrum_->setPickable(spectrum_lines);
    showLine();
}

// A chosen line has the place of the note about the residual, two lines of text, so that no plot
// moves under the mouse.
void ResidualsPage::showLine() {
    constexpr int lines_of_text = 2;
    const bool any = found_ && !found_->lines.empty();
    state_->setMinimumHeight(any ? lines_of_text * state_->fontMetrics().lineSpacing() : 0);
    state_->setText(chosen_ ? lineSentence(found_->lines[*chosen_], *found_, unit()) : stateText());
    const auto filter = chosen_ ? found_->lines[*chosen_].filter : std::nullopt;
    filter_->setVisible(filter.has_value());
    if (filter) {
        filter_->setText(tr("Filter %1").arg(bandText(*filter)));
    }
}

void ResidualsPage::putFilter() {
    const AnalysisEntry* chosen = document_.analysis(analysis_id_);
    if (chosen && chosen_ && found_->lines[*chosen_].filter) {
        document_.setCurrentRecording(chosen->recording_id);
        Settings settings = document_.settings();
        settings.filter = found_->lines[*chosen_].filter;
        document_.setSettings(settings);
    }
}

// A computation under way is asked for again when the page is shown.
void ResidualsPage::stop() {
    pause_.stop();
    job_.forget(job_key);
    if (computing_) {
        asked_.reset();
    }
}

void ResidualsPage::retranslate() {
    setTexts(*range_,
             {tr("the window at the cursor"), tr("the visible part"), tr("the whole analysis")});
    setWords(*range_, tr("Range of the residual"),
             tr("Samples less the wave of their window: of one window, of what the plots "
                "of the tracks show, or of all"));
    time_->setUnit(tr("s"));
    setWords(*time_, tr("Time of the window"),
             tr("The window nearest to this time, which cursor A or the mouse over the "
                "tracks sets, too"));
    setWords(*lines_, tr("Lines above the noise"),
             tr("Peaks that rise above the noise around them; white noise shows one in "
                "one of a hundred spectra"));
    filter_->setToolTip(tr("Puts this band-pass into the panel Analysis; Undo takes it back"));
    setWords(*spectrum_, tr("Spectrum of the residual"),
             tr("A click on a line names it; Left and Right go from line to line"));
    setWords(*histogram_, tr("Distribution of the residual"),
             tr("Against the normal curve of the same standard deviation"));
    setWords(*correlation_, tr("Autocorrelation of the residual"),
             tr("Of white noise, 95 % of the lags lie between the dashed lines"));
    setWords(*numbers_, tr("Numbers of the residual"), tr("Ctrl+C copies the table"));
    showFound();
}

}  // namespace vybeg::ui

#include "moc_residuals_page.cpp"
