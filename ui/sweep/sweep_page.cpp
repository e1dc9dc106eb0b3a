#include "ui/sweep/sweep_page.h"

#include "core/analysis/setting_table.h"
#include "core/sweep/window_sweep.h"
#include "ui/document/document.h"
#include "ui/sweep/shown_sweep.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/settings_text.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

constexpr std::int64_t most = 1'000'000'000;
constexpr std::size_t most_lengths = 60;

std::optional<std::int64_t> readLength(const QString& text) {
    bool whole = false;
    const qint64 length = text.toLongLong(&whole);
    return whole ? std::optional<std::int64_t>(length) : std::nullopt;
}

constexpr int job_key = 1;

constexpr int least_scatter_height = 210;
constexpr int least_residual_height = 160;
constexpr int progress_steps = 1000;

}  // namespace

LengthList readLengthList(const QString& text) {
    const auto refused = [](const QString& sentence) { return LengthList{{}, sentence}; };
    static const QRegularExpression separators(QStringLiteral("[\\s,;]+"));
    static const QRegularExpression dots(QStringLiteral("\\s*(\\.\\.+|…)\\s*"));
    const auto least = static_cast<std::int64_t>(bounds_of("window").least);
    LengthList list;
    QString joined = text;
    joined.replace(dots, QStringLiteral("…"));
    for (const QString& part : joined.split(separators, Qt::SkipEmptyParts)) {
        const QStringList ends = part.split(QStringLiteral("…"));
        const auto first = readLength(ends.front());
        const auto last = readLength(ends.back());
        if (ends.size() > 2 || !first || !last) {
            return refused(
                LengthField::tr("“%1” is neither a whole number nor a range as 6..600.")
                    .arg(QString(part).replace(QStringLiteral("…"), QStringLiteral(".."))));
        }
        if (std::min(*first, *last) < least || std::max(*first, *last) > most) {
            return refused(LengthField::tr("A window has %1 samples at least and %2 at most.")
                               .arg(least)
                               .arg(QLocale().toString(static_cast<qlonglong>(most))));
        }
        const auto range = spaced_lengths(std::min(*first, *last), std::max(*first, *last));
        list.lengths.insert(list.lengths.end(), range.begin(), range.end());
    }
    std::ranges::sort(list.lengths);
    const auto last = std::unique(list.lengths.begin(), list.lengths.end());
    list.lengths.erase(last, list.lengths.end());
    if (list.lengths.empty()) {
        return refused(
            LengthField::tr("A list of window lengths is needed, e.g. 6..600 or 6, 60."));
    }
    if (list.lengths.size() > most_lengths) {
        return refused(LengthField::tr("At most %1 lengths are possible.").arg(most_lengths));
    }
    return list;
}

LengthField::LengthField(QWidget* parent) : QLineEdit(QStringLiteral("6..600"), parent) {
    connect(this, &QLineEdit::textChanged, this, &LengthField::retranslate);
    retranslate();
}

void LengthField::retranslate() {
    const QString refusal = list().refusal;
    setAccessibleName(tr("Window lengths, samples"));
    setToolTip(richTip(
        refusal.isEmpty()
            ? tr("Samples per window: numbers and ranges, e.g. 6, 22, 60..600. A range stands for "
                 "15 lengths in equal ratios.")
            : refusal));
    update();
}

void LengthField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (!list().refusal.isEmpty() && isEnabled()) {
        frameFault(*this);
    }
}

SweepPage::SweepPage(Document& document, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      algorithm_(withName(new QComboBox(this), "sweepAlgorithm")),
      snap_(withName(new QCheckBox(this), "sweepSnap")),
      lengths_(withName(new LengthField(this), "sweepLengths")),
      compute_(withName(new QPushButton(this), "computeSweep")),
      progress_(new QProgressBar(this)),
      cancel_(withName(new QPushButton(this), "sweepCancel")),
      state_(sentence(this, "sweepState", QMargins())) {
    setObjectName(QStringLiteral("sweep"));
    auto* head = buildHead();
    content_ = buildContent();
    fill(new QVBoxLayout(this), {}, 4, {head, {scrolled(content_), 1}});
    connectWidgets();
    followSettings();
    retranslate();
}

const RecordingEntry* SweepPage::current() const {
    return document_.currentRecording();
}

const SweepPage::Found* SweepPage::found() const {
    const auto result = current() ? results_.find(current()->id) : results_.end();
    return result != results_.end() ? &result->second : nullptr;
}

FigureSource SweepPage::figures() const {
    return sweep() ? figuresOf({scatter_, residual_}, QStringLiteral("windows"), current()->name)
                   : FigureSource();
}

const WindowSweep* SweepPage::sweep() const {
    return found() ? &found()->sweep : nullptr;
}

Settings SweepPage::wanted() const {
    Settings settings = document_.settings();
    static_cast<WindowSettings&>(settings) = WindowSettings();
    settings.snap = snap_->isChecked();
    settings.algorithm = all_algorithms[static_cast<std::size_t>(algorithm_->currentIndex())];
    return settings;
}

SweepView SweepPage::view() const {
    SweepView view;
    view.variable = static_cast<std::size_t>(variable_->currentIndex());
    view.chosen = chosen_;
    view.units = units();
    if (current() && current()->recording) {
        view.channel_unit = channelUnit(*current()->recording);
    }
    return view;
}

std::optional<std::size_t> SweepPage::offered() const {
    if (chosen_) {
        return chosen_;
    }
    return sweep() && sweep()->advice ? std::optional(sweep()->advice->best) : std::nullopt;
}

// Algorithm and Snap are those of the panel until they are changed here.
void SweepPage::followSettings() {
    const Settings& settings = document_.settings();
    if (settings.algorithm != followed_) {
        followed_ = settings.algorithm;
        algorithm_->setCurrentIndex(static_cast<int>(*followed_));
    }
    if (settings.snap != followed_snap_) {
        followed_snap_ = settings.snap;
        snap_->setChecked(followed_snap_);
    }
    refresh();
}

// Results and failures of recordings that are closed or have other samples now.
void SweepPage::dropOldResults() {
    const auto entry = [this](RecordingId id) -> const Recording* {
        const RecordingEntry* recording = document_.recording(id);
        return recording && recording->recording ? &*recording->recording : nullptr;
    };
    const auto dropped = std::erase_if(results_, [&](const auto& result) {
        const Recording* recording = entry(result.first);
        return !recording || recording->source != result.second.source.lock();
    });
    std::erase_if(failures_, [&](const auto& failure) { return !entry(failure.first); });
    if (running_ != RecordingId::none && !entry(running_)) {
        cancel();
    }
    if (dropped > 0) {
        chosen_.reset();
        showFound();
    } else {
        refresh();
    }
}

void SweepPage::compute() {
    const RecordingEntry* entry = current();
    const LengthList list = lengths_->list();
    if (running() || !entry || !entry->recording || !list.refusal.isEmpty()) {
        return;
    }
    running_ = entry->id;
    failures_.erase(running_);
    progress_->setValue(0);
    job_.run<WindowSweep>(
        job_key,
        [recording = *entry->recording, settings = wanted(),
         lengths = list.lengths](const JobControl& job) -> Result<WindowSweep> {
            Result<WindowSweep> found = sweep_windows(recording, settings, lengths, job);
            TRY(unchanged(recording));
            return found;
        },
        [this, id = running_, asked = wanted()](Result<WindowSweep> result) {
            take(id, asked, std::move(result));
        });
    refresh();
}

void SweepPage::cancel() {
    job_.forget(job_key);
    running_ = RecordingId::none;
    refresh();
}

void SweepPage::take(RecordingId recording, const Settings& asked, Result<WindowSweep> result) {
    running_ = RecordingId::none;
    const RecordingEntry* entry = document_.recording(recording);
    if (entry && entry->recording) {
        results_.erase(recording);
        if (result) {
            results_[recording] = {std::move(*result), asked, entry->recording->source};
        } else {
            failures_[recording] = result.error();
        }
    }
    chosen_.reset();
    showFound();
}

void SweepPage::choose(std::optional<std::size_t> length) {
    chosen_ = length;
    showFound();
}

// Algorithm and window belong together: the sweep says nothing about others.
void SweepPage::useWindow() {
    if (const auto length = offered()) {
        Settings settings = document_.settings();
        settings.window = sweep()->lengths[*length].length;
        settings.periods.reset();
        settings.snap = false;
        settings.algorithm = found()->asked.algorithm;
        document_.setSettings(settings);
    }
}

QString SweepPage::missing() const {
    if (!current()) {
        return tr("No recording is open.");
    }
    if (!current()->recording) {
        return tr("The recording is being read.");
    }
    return lengths_->list().refusal;
}

QString SweepPage::stateText() const {
    if (running()) {
        return tr("The windows are being estimated…");
    }
    if (const QString hint = missing(); !hint.isEmpty()) {
        return hint;
    }
    if (const auto failure = failures_.find(current()->id); failure != failures_.end()) {
        return errorText(failure->second);
    }
    if (!found()) {
        return tr(
            "Compute estimates this recording once for each length: it shows how much the values "
            "scatter and which window is recommended.");
    }
    const QString refused = refusedText(found()->sweep);
    return found()->asked == wanted()
               ? refused
               : tr("The result is older than the settings: Compute does it anew.");
}

void SweepPage::refresh() {
    const bool ready = !running() && missing().isEmpty();
    compute_->setEnabled(ready);
    compute_->setToolTip(richTip(ready ? tr("Estimates adjacent windows of each length with the "
                                            "settings of the panel Analysis")
                                       : stateText()));
    progress_->setVisible(running());
    cancel_->setVisible(running());
    const QString state = stateText();
    state_->setText(state.toHtmlEscaped());
    state_->setVisible(!state.isEmpty());
}

void SweepPage::showFound() {
    refresh();
    const WindowSweep* shown = sweep();
    const SweepView view = this->view();
    content_->setVisible(shown != nullptr);
    auto scatter = scatterPlot(shown, view);
    auto residual = residualPlot(shown, view);
    scatter.x_below = true;
    for (const XYPlot& plot : {scatter, residual}) {
        for (const XYSeries& series : plot.series) {
            scatter.names_at_ends << series.name;
        }
    }
    residual.names_at_ends = scatter.names_at_ends;
    scatter_->setContent(scatter);
    residual_->setContent(residual);
    point_->setVisible(shown && chosen_);
    emit figuresChanged();
    if (!shown) {
        return;
    }
    QStringList tips;
    for (std::size_t k = 0; k < shown->lengths.size(); ++k) {
        tips << richText(pointText(*shown, k, view));
    }
    for (XYPlotView* plot : {scatter_, residual_}) {
        plot->setPickable(0);
        plot->setPointTips(
            [tips](std::size_t point) { return tips.value(static_cast<qsizetype>(point)); });
    }
    if (chosen_) {
        point_->setText(tips[static_cast<qsizetype>(*chosen_)]);
    }
    advice_->setText(richText(adviceText(*shown, view)));
    const auto length = offered();
    use_->setVisible(length.has_value());
    if (length) {
        use_->setText(tr("Use n = %1").arg(shown->lengths[*length].length));
    }
    table_->setContent(sweepHeaders(*shown, view), sweepRows(*shown, view));
    table_->horizontalHeaderItem(0)->setText(QStringLiteral("n"));
    numbers_->setMinimumWidth(std::max(table_->leastWidth(), numbers_->minimumSizeHint().width()));
}

void SweepPage::resizeEvent(QResizeEvent* event) {
    constexpr int least_beside = 1100;  // of the window
    parts_->setDirection(window()->width() < least_beside ? QBoxLayout::TopToBottom
                                                          : QBoxLayout::LeftToRight);
    MeasuredPage::resizeEvent(event);
}

QLayout* SweepPage::buildHead() {
    algorithm_->addItems(QStringList(std::ssize(all_algorithms)));
    algorithm_->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // in another language, too
    progress_->setRange(0, progress_steps);
    progress_->setMaximumHeight(compute_->sizeHint().height());
    auto* choices = fill(new QHBoxLayout, {labelFor(algorithm_, [] { return tr("Algorithm"); }),
                                           algorithm_,
                                           snap_,
                                           labelFor(lengths_, [] { return tr("Lengths"); }),
                                           {lengths_, 2},
                                           compute_,
                                           {progress_, 1},
                                           cancel_});
    return fill(new QVBoxLayout, {6, 4, 6, 0}, 4, {choices, state_});
}

QWidget* SweepPage::buildContent() {
    auto* content = new QWidget(this);
    variable_ = withName(new QComboBox(content), "sweepVariable");
    variable_->setItemDelegate(new IndexDelegate(variable_));
    variable_->addItems(QStringList(std::ssize(main_slow_variables)));
    variable_->setCurrentIndex(2);
    copy_ = withName(new QPushButton(content), "sweepCopy");
    scatter_ = addPlot("sweepScatter", least_scatter_height);
    residual_ = addPlot("sweepResidual", least_residual_height);
    advice_ = sentence(content, "sweepAdvice", QMargins());
    point_ = sentence(content, "sweepPoint", QMargins());
    use_ = withName(new QPushButton(content), "sweepUse");
    table_ = withName(new QuantityTable(content), "sweepTable");
    numbers_ = new QWidget(content);
    auto* choice =
        fill(new QHBoxLayout, {labelFor(variable_, [] { return tr("Variable"); }), {variable_, 1}});
    auto* advice = fill(new QHBoxLayout, {{advice_, 1}, {use_, 0, Qt::AlignTop}});
    auto* copy = fill(new QHBoxLayout, {LayoutPart(1), copy_});
    auto* plots = fill(new QVBoxLayout, {}, 4, {{scatter_, 3}, {residual_, 2}});
    fill(new QVBoxLayout(numbers_), {}, 4, {choice, advice, table_, copy, point_, LayoutPart(1)});
    parts_ = fill(new QBoxLayout(QBoxLayout::LeftToRight, content), {6, 0, 6, 0}, 8,
                  {{plots, 5}, {numbers_, 3}});
    return content;
}

void SweepPage::connectWidgets() {
    connect(compute_, &QPushButton::clicked, this, &SweepPage::compute);
    connect(cancel_, &QPushButton::clicked, this, &SweepPage::cancel);
    connect(use_, &QPushButton::clicked, this, &SweepPage::useWindow);
    connect(lengths_, &QLineEdit::textChanged, this, &SweepPage::refresh);
    connect(lengths_, &QLineEdit::returnPressed, this, &SweepPage::compute);
    connect(algorithm_, &QComboBox::currentIndexChanged, this, &SweepPage::refresh);
    connect(snap_, &QCheckBox::toggled, this, &SweepPage::refresh);
    connect(variable_, &QComboBox::currentIndexChanged, this, &SweepPage::showFound);
    connect(copy_, &QPushButton::clicked, this, [this] {
        if (sweep()) {
            QGuiApplication::clipboard()->setText(sweepTable(*sweep(), view()));
        }
    });
    for (XYPlotView* plot : {scatter_, residual_}) {
        connect(plot, &XYPlotView::pointClicked, this,
                [this](int point) { choose(static_cast<std::size_t>(point)); });
        connect(plot, &XYPlotView::stepWanted, this, [this](int by) {
            if (const WindowSweep* shown = sweep()) {
                const int count = static_cast<int>(shown->lengths.size());
                const int from = static_cast<int>(offered().value_or(0));
                choose(static_cast<std::size_t>(std::clamp(from + by, 0, count - 1)));
            }
        });
    }
    connect(&job_, &BackgroundJobs::analysisProgress, this, [this](int, double fraction) {
        progress_->setValue(static_cast<int>(progress_steps * fraction));
    });
    connect(&document_, &Document::settingsChanged, this, &SweepPage::followSettings);
    connect(&document_, &Document::recordingsChanged, this, &SweepPage::dropOldResults);
    connect(&document_, &Document::recordingChanged, this, &SweepPage::dropOldResults);
    connect(&document_, &Document::currentRecordingChanged, this, [this] {
        chosen_.reset();
        showFound();
    });
}

void SweepPage::retranslate() {
    {
        const QSignalBlocker quiet(algorithm_);
        for (std::size_t k = 0; k < all_algorithms.size(); ++k) {
            algorithm_->setItemText(static_cast<int>(k), algorithmText(all_algorithms[k]));
        }
    }
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        variable_->setItemText(static_cast<int>(v),
                               indexPlain(displaySymbol(main_slow_variables[v], units())) +
                                   QStringLiteral(" – ") + displayMeaning(main_slow_variables[v]));
    }
    setWords(*algorithm_, tr("Algorithm of the sweep"),
             richTip(tr("Follows the panel Analysis; may be another one here")));
    snap_->setText(tr("Snap"));
    setWords(*snap_, tr("Snap every length"),
             richTip(tr("Moves every length to whole half-periods of the carrier")));
    lengths_->retranslate();
    compute_->setText(tr("Compute"));
    compute_->setAccessibleName(tr("Compute the sweep"));
    cancel_->setText(tr("Cancel"));
    cancel_->setAccessibleName(tr("Cancel the sweep"));
    progress_->setAccessibleName(tr("Progress of the sweep"));
    setWords(*variable_, tr("Variable of the sweep"),
             richTip(tr("The variable of the left plot and of the table")));
    copy_->setText(tr("Copy table"));
    copy_->setToolTip(richTip(tr("All variables and lengths to the clipboard, for a spreadsheet")));
    use_->setToolTip(
        richTip(tr("Puts this window and the algorithm of the sweep into the panel "
                   "Analysis; Undo takes them back")));
    scatter_->setAccessibleName(tr("Scatter against the length of the window"));
    residual_->setAccessibleName(tr("Residual against the length of the window"));
    table_->setAccessibleName(tr("Numbers of the sweep"));
    showFound();
}

}  // namespace vybeg::ui

#include "moc_sweep_page.cpp"
