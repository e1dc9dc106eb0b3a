#include "ui/history/history_page.h"

#include "ui/document/document.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

constexpr int least_results = 2;
constexpr int most_results = 10'000;
constexpr int usual_results = 20;

const QString baseline_key = QStringLiteral("history/baseline");

enum JobKey : int { reading_job, looking_job, result_job, storing_job };

const QString path_key = QStringLiteral("history/database");

}  // namespace

HistoryChoices::HistoryChoices(QWidget* parent)
    : QWidget(parent),
      gyro_(withName(new QComboBox(this), "historyGyro")),
      parameter_(withName(new QComboBox(this), "historyParameter")),
      axis_(withName(new QComboBox(this), "historyAxis")),
      baseline_(withName(new QSpinBox(this), "historyBaseline")),
      choices_{{{labelFor(gyro_, [] { return HistoryChoices::tr("Gyro"); }), gyro_},
                {labelFor(parameter_, [] { return HistoryChoices::tr("Parameter"); }), parameter_},
                {labelFor(axis_, [] { return HistoryChoices::tr("Against"); }), axis_},
                {labelFor(baseline_, [] { return HistoryChoices::tr("Baseline"); }), baseline_}}},
      grid_(new QGridLayout(this)) {
    gyro_->addItem(QString());
    parameter_->setItemDelegate(new IndexDelegate(parameter_));
    parameter_->addItems(QStringList(std::ssize(historyParameters())));
    parameter_->setCurrentIndex(1);
    for (QComboBox* box : {gyro_, parameter_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(9);
    }
    axis_->addItems({QString(), QString(), QString()});
    baseline_->setRange(least_results, most_results);
    baseline_->setValue(QSettings().value(baseline_key, usual_results).toInt());
    baseline_->setKeyboardTracking(false);
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setColumnStretch(1, 1);
    grid_->setColumnStretch(3, 1);
    constexpr int wide = 1000;
    place(2);
    whenChanged(*this, {QEvent::Resize}, [this, now = 2]() mutable {
        if (const int wanted = width() < wide ? 2 : 4; wanted != now) {
            now = wanted;
            place(now);
        }
    });
    connect(gyro_, &QComboBox::activated, this, &HistoryChoices::dataWanted);
    connect(parameter_, &QComboBox::currentIndexChanged, this, &HistoryChoices::dataWanted);
    connect(axis_, &QComboBox::currentIndexChanged, this, &HistoryChoices::axisChanged);
    connect(baseline_, &QSpinBox::valueChanged, this, [this](int count) {
        QSettings().setValue(baseline_key, count);
        emit limitsChanged();
    });
    keepTranslated(*this, [this] { retranslate(); });
}

std::optional<std::string> HistoryChoices::gyro() const {
    const auto row = static_cast<std::size_t>(std::max(0, gyro_->currentIndex()));
    return row > 0 && row <= gyros_.size() ? std::optional(gyros_[row - 1].name) : std::nullopt;
}

const HistoryParameter& HistoryChoices::parameter() const {
    return historyParameters()[static_cast<std::size_t>(parameter_->currentIndex())];
}

HistoryAxis HistoryChoices::axis() const {
    return static_cast<HistoryAxis>(axis_->currentIndex());
}

std::size_t HistoryChoices::baseline() const {
    return static_cast<std::size_t>(baseline_->value());
}

void HistoryChoices::chooseAllGyros() {
    gyro_->setCurrentIndex(0);
}

void HistoryChoices::setGyros(const std::vector<StoredGyro>& gyros) {
    const auto before = gyro();
    gyros_ = gyros;
    while (gyro_->count() > 1) {
        gyro_->removeItem(1);
    }
    for (const StoredGyro& each : gyros_) {
        gyro_->addItem(QString());
        if (before == each.name) {
            gyro_->setCurrentIndex(gyro_->count() - 1);
        }
    }
    retranslate();
}

// So many choices are in a row.
void HistoryChoices::place(int in_a_row) {
    for (int k = 0; const auto& [label, choice] : choices_) {
        grid_->removeWidget(label);
        grid_->removeWidget(choice);
        grid_->addWidget(label, k / in_a_row, 2 * (k % in_a_row));
        grid_->addWidget(choice, k / in_a_row, 2 * (k % in_a_row) + 1);
        ++k;
    }
}

void HistoryChoices::retranslate() {
    setWords(*gyro_, tr("Gyro of the history"),
             richTip(tr("Whose results are shown; the number of its results stands behind "
                        "its name")));
    gyro_->setItemText(0, tr("All gyros"));
    for (std::size_t k = 0; k < gyros_.size(); ++k) {
        const QString name = QString::fromStdString(gyros_[k].name);
        gyro_->setItemText(static_cast<int>(k) + 1,
                           QStringLiteral("%1 (%2)").arg(
                               name.isEmpty() ? tr("without a name") : name,
                               QLocale().toString(static_cast<qlonglong>(gyros_[k].results))));
    }
    setWords(*parameter_, tr("Parameter of the history"),
             richTip(tr("Which of its parameters is shown")));
    const auto& parameters = historyParameters();
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        parameter_->setItemText(
            static_cast<int>(k),
            indexPlain(shownAs(parameters[k].name, parameters[k].unit, {}).title));
    }
    setWords(*axis_, tr("Axis of the history"),
             richTip(tr("The mean frequency follows the temperature of the resonator")));
    setTexts(*axis_, {tr("Date"), tr("Frequency"), tr("Order")});
    setWords(*baseline_, tr("Baseline of the control charts"),
             richTip(tr("So many first results of the gyro set centre and limits of the charts")));
}

HistoryPage::HistoryPage(Document& document, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      database_(new QLabel(this)),
      open_(withName(new QPushButton(this), "historyOpen")),
      new_(withName(new QPushButton(this), "historyNew")),
      add_(withName(new QPushButton(this), "historyAdd")),
      export_(withName(new QPushButton(this), "historyExport")),
      state_(hint(this, "historyState")) {
    setObjectName(QStringLiteral("history"));
    auto* head = buildHead();
    content_ = scrolled(buildContent());
    fill(new QVBoxLayout(this), {}, 4, {head, {state_, 0, Qt::AlignCenter}, {content_, 1}});
    connectWidgets();
    // The database is read when the page is first seen: it may lie on a slow share; again, when
    // another program has written into it.
    whenChanged(*this, {QEvent::Show, QEvent::WindowActivate}, [this] {
        if (!isVisible()) {
            return;
        }
        const bool first = !std::exchange(seen_, true);
        if (first) {
            path_ = QSettings().value(path_key).toString();
        }
        if (!path_.isEmpty() && first) {
            read();
        } else if (!path_.isEmpty() && !reading_) {
            look();
        }
    });
    retranslate();
}

void HistoryPage::openDatabase(const QString& path, bool make) {
    seen_ = true;
    path_ = QFileInfo(path).absoluteFilePath();
    QSettings().setValue(path_key, path_);
    history_.reset();
    chosen_.reset();
    choices_->chooseAllGyros();
    showHistory();  // no longer that of the database before
    if (make) {
        reading_ = true;
        refresh();
        makeDatabase(job(reading_job), [this](const Result<bool>& made) {
            if (made) {
                read();
            } else {
                take(made.error());
            }
        });
    } else {
        read();
    }
}

// Reads the file again if it was written since.
void HistoryPage::look() {
    job_.run<QDateTime>(
        looking_job,
        [path = path_](const JobControl&) { return Result(QFileInfo(path).lastModified()); },
        [this](const Result<QDateTime>& written) {
            if (written && *written != written_) {
                read();
            }
        });
}

void HistoryPage::read() {
    job_.forget(looking_job);
    reading_ = true;
    failure_.reset();
    written_ = {};
    readHistory(job(reading_job), choices_->gyro(), choices_->parameter().name,
                [this](Result<StoredHistory> history) { take(std::move(history)); });
    refresh();
}

void HistoryPage::take(Result<StoredHistory> history) {
    reading_ = false;
    chosen_.reset();
    history_.reset();
    if (history) {
        history_ = std::move(*history);
        written_ = history_->written;
        const auto asked = choices_->gyro();
        choices_->setGyros(history_->gyros);
        if (choices_->gyro() != asked) {  // it has no results any more
            read();
            return;
        }
    } else {
        failure_ = history.error();
    }
    compute();
}

void HistoryPage::compute() {
    if (history_) {
        charts_ = historyCharts(history_->points, choices_->parameter(),
                                choices_->gyro().has_value(), choices_->baseline());
    }
    showHistory();
}

HistoryView HistoryPage::view() const {
    const Passport* open = document_.passport().content();
    const Dossier& dossier = document_.dossier().dossier();
    const std::string serial = dossier.gyro.serial.toStdString();
    // Those of the session's gyro are not limits of another one, nor of several.
    const bool one_gyro = choices_->gyro() || history_->gyros.size() == 1;
    const bool same_gyro =
        one_gyro && (serial.empty() || choices_->gyro().value_or(serial) == serial);
    const ParameterLimit* limit =
        same_gyro ? limit_of(dossier.limits, choices_->parameter().name.c_str()) : nullptr;
    return {*history_,
            charts_,
            choices_->baseline(),
            choices_->parameter(),
            shownAxis(*history_, choices_->axis()),
            units(),
            chosen_,
            open ? choices_->parameter().in(*open) : nullptr,
            limit ? std::optional(*limit) : std::nullopt};
}

void HistoryPage::showHistory() {
    refresh();
    content_->setVisible(hasResults());
    static_cast<QVBoxLayout*>(layout())->setStretchFactor(state_, hasResults() ? 0 : 1);
    if (!history_) {
        for (XYPlotView* plot : findChildren<XYPlotView*>()) {
            plot->setContent({});
        }
        emit figuresChanged();
        return;
    }
    const HistoryView now = view();
    // One axis for all, but for the frequency, where the lower ones are sequences. These are low
    // and have no legend: dashed are limits, as above.
    for (Chart& chart : plots_) {
        chart.shown = chart.plotOf(now);
        XYPlot& plot = chart.shown.plot;
        if (&chart == &values()) {
            plot.y_range = wholeRange(now, plot);
        } else {
            if (now.axis != HistoryAxis::frequency) {
                plot.x_range = shownPlaces(values().shown.plot);
            }
            std::ranges::for_each(plot.series, [](XYSeries& series) { series.name.clear(); });
            plot.x_below = &chart != &plots_.back();
            chart.plot->setVisible(charts_.one_gyro);
        }
        chart.plot->setContent(plot);
        chart.plot->setPickable(0);
        chart.plot->setPointTips([this, &points = chart.shown.points](std::size_t place) {
            return place < points.size() ? richTip(pointText(view(), points[place])) : QString();
        });
    }
    showDistribution(now);
    // A click on a name chooses its result.
    QString verdict = richText(verdictText(now));
    const bool judged = charts_.one_gyro && charts_.control.fault != BaselineFault::too_few;
    for (std::size_t k = 0; judged && k < charts_.values.size(); ++k) {
        if (charts_.control.is_out(k)) {
            const QString name = richText(nameOf(history_->points[k]));
            verdict.replace(name + QStringLiteral(" ("),
                            QStringLiteral("<a href=\"%1\">%2</a> (").arg(k).arg(name));
        }
    }
    verdict_->setText(verdict);
    point_->setVisible(chosen_.has_value());
    recordings_->setVisible(chosen_.has_value());
    if (chosen_) {
        point_->setText(richText(pointText(now, *chosen_)));
    }
    emit figuresChanged();
}

// Its frame begins as high as that of the values.
void HistoryPage::showDistribution(const HistoryView& now) {
    XYPlot plot = besideValues(distributionPlot(now), values().shown.plot);
    plot.least_head = values().plot->head();
    distribution_->setContent(plot);
}

QString HistoryPage::stateText() const {
    if (path_.isEmpty()) {
        return tr(
            "A database keeps the results of a laboratory, of this window and of the command "
            "line, so that each parameter of a gyro can be followed. Open one, or make a "
            "new one.");
    }
    if (failure_) {
        return errorText(*failure_);
    }
    if (reading_) {
        return tr("The database is being read…");
    }
    if (history_ && history_->gyros.empty()) {
        return tr(
            "The database holds no results yet. Identify a resonator and add its result, or "
            "fill it from the command line.");
    }
    return {};
}

void HistoryPage::refresh() {
    database_->setText(QFileInfo(path_).fileName());
    database_->setToolTip(plainTip(path_));
    const QString hint = path_.isEmpty() ? tr("First open a database, or make a new one.")
                         : !addableResult(document_)
                             ? tr("First identify the resonator of a set, on the page Resonator.")
                             : QString();
    add_->setVisible(!path_.isEmpty());
    export_->setVisible(!path_.isEmpty());
    add_->setEnabled(hint.isEmpty());
    add_->setToolTip(
        richTip(hint.isEmpty() ? tr("The identified resonator of the current set into the database")
                               : hint));
    const QString state = stateText();
    state_->setText(state.toHtmlEscaped());
    state_->setVisible(!state.isEmpty() && !hasResults());
    choices_->setVisible(history_.has_value());
    export_->setEnabled(history_ && !history_->points.empty());
}

void HistoryPage::choose(const HistoryPlot& shown, int place) {
    if (place >= 0 && place < std::ssize(shown.points)) {
        chosen_ = shown.points[static_cast<std::size_t>(place)];
        showHistory();
    }
}

// To the neighbour on the axis of the values.
void HistoryPage::step(int by) {
    const auto& points = values().shown.points;
    if (points.empty()) {
        return;
    }
    const auto now = chosen_ ? std::ranges::find(points, *chosen_) : points.end();
    const auto place = now == points.end() ? (by > 0 ? 0 : std::ssize(points) - 1)
                                           : std::distance(points.begin(), now) + by;
    choose(values().shown,
           static_cast<int>(std::clamp(place, std::ptrdiff_t{0}, std::ssize(points) - 1)));
}

void HistoryPage::openChosen() {
    if (!history_ || !chosen_) {
        return;
    }
    readResult(job(result_job), history_->points[*chosen_].id,
               [this](const Result<StoredResult>& result) {
                   if (result) {
                       openStored(*result);
                   } else {
                       document_.report(errorMessage(result.error()));
                   }
               });
}

void HistoryPage::openStored(const StoredResult& result) {
    const auto settings = settingsOf(result);
    MeasurementSet set{result.set, result.recordings,
                       settings.value_or(document_.sets().measured(RecordingSet()).settings)};
    const QStringList missing = leaveOutMissing(set);
    const auto warn = [this](std::function<QString()> text) {
        document_.report(warningMessage(std::move(text)));
    };
    if (!missing.isEmpty()) {
        warn([missing, name = QString::fromStdString(result.set)] {
            return tr("Of the result %1 these recordings are not where they were: %2.")
                .arg(name, missing.join(QStringLiteral(", ")));
        });
    }
    if (set.recordings.empty()) {
        return;
    }
    if (!settings) {
        warn([name = QString::fromStdString(result.set)] {
            return tr("The settings of the result %1 cannot be read: the set has those of the "
                      "panel Analysis.")
                .arg(name);
        });
    }
    document_.sets().open({{}, {set}, {}});
    emit setOpened();
}

void HistoryPage::add() {
    QStringList gyros;
    for (const StoredGyro& each : history_ ? history_->gyros : std::vector<StoredGyro>()) {
        if (!each.name.empty()) {
            gyros << QString::fromStdString(each.name);
        }
    }
    if (!path_.isEmpty()) {
        askToAdd(job(storing_job), gyros, this, [this, path = path_] {
            if (path == path_) {
                read();
            }
        });
    }
}

FigureSource HistoryPage::figures() const {
    if (!history_) {
        return {};
    }
    const QString parameter = indexPlain(shownIn(view()).title);
    const auto gyro = choices_->gyro();
    std::vector<const XYPlotView*> plots;
    std::ranges::transform(plots_, std::back_inserter(plots), &Chart::plot);
    plots.push_back(distribution_);
    return figuresOf(
        plots, QStringLiteral("history"),
        gyro ? QStringLiteral("%1: %2").arg(QString::fromStdString(*gyro), parameter) : parameter);
}

namespace {

// At least, pixels.
constexpr int values_height = 240;
constexpr int ranges_height = 96;
constexpr int average_height = 128;
constexpr int distribution_width = 220;

}  // namespace

QLayout* HistoryPage::buildHead() {
    database_->setTextFormat(Qt::PlainText);
    database_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* first = fill(new QHBoxLayout, {{database_, 1}, open_, new_, add_, export_});

    choices_ = new HistoryChoices(this);
    return fill(new QVBoxLayout, {6, 4, 6, 0}, 4, {first, choices_});
}

QWidget* HistoryPage::buildContent() {
    auto* content = new QWidget(this);
    verdict_ = sentence(content, "historyVerdict", QMargins());
    verdict_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(verdict_, &QLabel::linkActivated, this, [this](const QString& place) {
        chosen_ = place.toULongLong();
        showHistory();
    });
    point_ = sentence(content, "historyPoint", QMargins());
    recordings_ = withName(new QPushButton(content), "historyRecordings");
    plots_ = {
        {valuesPlot, QT_TR_NOOP("Values of the parameter"),
         addPlot("historyValues", values_height)},
        {rangesPlot, QT_TR_NOOP("Moving range"), addPlot("historyRanges", ranges_height)},
        {averagePlot, QT_TR_NOOP("Weighted average"), addPlot("historyAverage", average_height)}};
    distribution_ = addPlot("historyDistribution", values_height);
    distribution_->setFixedWidth(distribution_width);
    whenChanged(*values().plot, {QEvent::Resize}, [this] {
        if (history_) {
            showDistribution(view());
        }
    });
    // The charts over each other, on one axis; beside them the distribution and the chosen result.
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    for (int row = 0; row < std::ssize(plots_); ++row) {
        grid->addWidget(plots_[row].plot, row, 0);
        grid->setRowStretch(row, row == 0 ? 6 : 2);
    }
    grid->addWidget(distribution_, 0, 1);
    grid->addLayout(fill(new QVBoxLayout, {point_, {recordings_, 0, Qt::AlignLeft}, LayoutPart(1)}),
                    1, 1, -1, 1);
    grid->setColumnStretch(0, 1);
    fill(new QVBoxLayout(content), {6, 0, 6, 0}, 4, {verdict_, {grid, 1}});
    return content;
}

void HistoryPage::connectWidgets() {
    connect(open_, &QPushButton::clicked, this, [this] { emit databaseWanted(false); });
    connect(new_, &QPushButton::clicked, this, [this] { emit databaseWanted(true); });
    connect(add_, &QPushButton::clicked, this, &HistoryPage::add);
    connect(export_, &QPushButton::clicked, this, [this] {
        emit exportAllWanted(historyExport(view(), database_->text(), choices_->gyro()));
    });
    connect(recordings_, &QPushButton::clicked, this, &HistoryPage::openChosen);
    connect(choices_, &HistoryChoices::dataWanted, this, &HistoryPage::read);
    connect(choices_, &HistoryChoices::axisChanged, this, &HistoryPage::showHistory);
    connect(choices_, &HistoryChoices::limitsChanged, this, &HistoryPage::compute);
    for (const Chart& chart : plots_) {
        connect(chart.plot, &XYPlotView::stepWanted, this, &HistoryPage::step);
        connect(chart.plot, &XYPlotView::pointClicked, this,
                [this, &chart](int place) { choose(chart.shown, place); });
        connect(chart.plot, &XYPlotView::pointActivated, this, [this, &chart](int place) {
            choose(chart.shown, place);
            openChosen();
        });
    }
    connect(&document_.sets(), &SetStore::changed, this, &HistoryPage::refresh);
    connect(&document_.passport(), &PassportStore::changed, this, &HistoryPage::showHistory);
    connect(&document_.dossier(), &DossierModel::changed, this, &HistoryPage::showHistory);
}

void HistoryPage::retranslate() {
    open_->setText(tr("Open…"));
    setWords(*open_, tr("Open a database"),
             richTip(tr("A database of results, of this window or of the command line")));
    new_->setText(tr("New…"));
    setWords(*new_, tr("Make a database"),
             richTip(tr("An empty database of results in a new file")));
    add_->setText(tr("Add this result…"));
    export_->setText(tr("Export…"));
    setWords(
        *export_, tr("Export the results shown"),
        richTip(tr("The results shown as a table (CSV), or as a report with the charts (PDF)")));
    recordings_->setText(tr("Open its recordings"));
    recordings_->setToolTip(
        richTip(tr("As a set, with the settings and conditions of the result; a double click on "
                   "the point does the same")));
    distribution_->setAccessibleName(tr("Distribution of the parameter"));
    const QString tip =
        richTip(tr("A click chooses a result, a double click opens its recordings; "
                   "Left and Right go to its neighbours"));
    for (const Chart& chart : plots_) {
        chart.plot->setAccessibleName(tr(chart.name));
        chart.plot->setToolTip(tip);
    }
    distribution_->setToolTip(richTip(tr("How often each value occurs among the results shown")));
    showHistory();
}

}  // namespace vybeg::ui

#include "moc_history_page.cpp"
