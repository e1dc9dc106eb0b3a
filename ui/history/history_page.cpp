#include "ui/history/history_page.h"

#include "ui/document/document.h"
#include "ui/history/history_choices.h"
#include "ui/history/history_job.h"
#include "ui/history/history_text.h"
#include "ui/history/stored_set.h"
#include "ui/plots/xy_plot_view.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

enum JobKey : int { reading_job, result_job };

const QString path_key = QStringLiteral("history/database");

}  // namespace

HistoryPage::HistoryPage(Document& document, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      adder_(document),
      database_(new QLabel(this)),
      open_(withName(new QPushButton(this), "historyOpen")),
      new_(withName(new QPushButton(this), "historyNew")),
      add_(withName(new QPushButton(this), "historyAdd")),
      export_(withName(new QPushButton(this), "historyExport")),
      state_(sentence(this, "historyState", QMargins())) {
    setObjectName(QStringLiteral("history"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(buildHead());
    content_ = scrolled(buildContent());
    column->addWidget(content_, 1);
    column->addStretch();  // below the sentence where there is nothing to show
    connectWidgets();
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
        makeDatabase(job_, reading_job, document_, path_, [this](const Result<bool>& made) {
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

// The database is read when the page is first seen: it may lie on a slow share.
void HistoryPage::showEvent(QShowEvent* event) {
    MeasuredPage::showEvent(event);
    if (!seen_) {
        seen_ = true;
        path_ = QSettings().value(path_key).toString();
        if (!path_.isEmpty()) {
            read();
        }
    }
}

void HistoryPage::read() {
    reading_ = true;
    failure_.reset();
    readHistory(job_, reading_job, document_, path_, choices_->gyro(), choices_->parameter().name,
                [this](Result<StoredHistory> history) { take(std::move(history)); });
    refresh();
}

void HistoryPage::take(Result<StoredHistory> history) {
    reading_ = false;
    chosen_.reset();
    history_.reset();
    if (history) {
        history_ = std::move(*history);
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
    const OpenPassport* open = document_.sets().passport();
    const Dossier& dossier = document_.dossier().dossier();
    const std::string serial = dossier.gyro.serial.toStdString();
    // Those of the session's gyro are not limits of another one.
    const bool same_gyro = serial.empty() || choices_->gyro().value_or(serial) == serial;
    const ParameterLimit* limit =
        same_gyro ? limit_of(dossier.limits, choices_->parameter().name.c_str()) : nullptr;
    return {choices_->parameter(),
            shownAxis(history_, choices_->axis()),
            units_,
            chosen_,
            passportValue(open ? &open->passport : nullptr, choices_->parameter()),
            open ? open->name : QString(),
            limit ? std::optional(*limit) : std::nullopt};
}

void HistoryPage::showHistory() {
    refresh();
    content_->setVisible(history_.has_value());
    if (!history_) {
        for (XYPlotView* plot : {values_, ranges_, average_, distribution_}) {
            plot->setContent({});
        }
        emit figuresChanged();
        return;
    }
    const HistoryView now = view();
    shown_values_ = valuesPlot(*history_, charts_, now);
    shown_ranges_ = rangesPlot(*history_, charts_, now);
    shown_average_ = averagePlot(*history_, charts_, now);
    for (const auto& [plot, shown] :
         {std::pair{values_, &shown_values_}, std::pair{ranges_, &shown_ranges_},
          std::pair{average_, &shown_average_}}) {
        plot->setContent(shown->plot);
        plot->setPickable(0);
        plot->setPointTips([this, shown = shown](std::size_t place) {
            return place < shown->points.size()
                       ? richTip(pointText(*history_, charts_, view(), shown->points[place]))
                       : QString();
        });
    }
    distribution_->setContent(distributionPlot(charts_, now));
    ranges_->setVisible(charts_.one_gyro);
    average_->setVisible(charts_.one_gyro);
    verdict_->setText(richText(verdictText(*history_, charts_, now, choices_->baseline())));
    point_->setVisible(chosen_.has_value());
    recordings_->setVisible(chosen_.has_value());
    if (chosen_) {
        point_->setText(richText(pointText(*history_, charts_, now, *chosen_)));
    }
    emit figuresChanged();
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

QString HistoryPage::addHint() const {
    return path_.isEmpty()     ? tr("First open a database, or make a new one.")
           : !adder_.addable() ? tr("First identify the resonator of a set, on the page Resonator.")
                               : QString();
}

void HistoryPage::refresh() {
    database_->setText(QFileInfo(path_).fileName());
    database_->setToolTip(plainTip(path_));
    const QString hint = addHint();
    add_->setEnabled(hint.isEmpty());
    add_->setToolTip(
        richTip(hint.isEmpty() ? tr("The identified resonator of the current set into the database")
                               : hint));
    const QString state = stateText();
    state_->setText(state.toHtmlEscaped());
    state_->setVisible(!state.isEmpty());
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
    const auto& points = shown_values_.points;
    if (points.empty()) {
        return;
    }
    const auto now = chosen_ ? std::ranges::find(points, *chosen_) : points.end();
    const auto place = now == points.end() ? (by > 0 ? 0 : std::ssize(points) - 1)
                                           : std::distance(points.begin(), now) + by;
    choose(shown_values_,
           static_cast<int>(std::clamp(place, std::ptrdiff_t{0}, std::ssize(points) - 1)));
}

void HistoryPage::openChosen() {
    if (!history_ || !chosen_) {
        return;
    }
    readResult(job_, result_job, document_, path_, history_->points[*chosen_].id,
               [this](const Result<StoredResult>& result) {
                   if (result) {
                       openStored(*result);
                   } else {
                       document_.report(errorMessage(result.error()));
                   }
               });
}

void HistoryPage::openStored(const StoredResult& result) {
    const StoredSet stored = storedSet(result, document_.sets().measured(RecordingSet()).settings);
    const auto warn = [this](std::function<QString()> text) {
        document_.report(warningMessage(std::move(text)));
    };
    if (!stored.missing.isEmpty()) {
        warn([missing = stored.missing, name = QString::fromStdString(result.set)] {
            return tr("Of the result %1 these recordings are not where they were: %2.")
                .arg(name, missing.join(QStringLiteral(", ")));
        });
    }
    if (stored.list.sets.empty()) {
        return;
    }
    if (!stored.settings_known) {
        warn([name = QString::fromStdString(result.set)] {
            return tr("The settings of the result %1 cannot be read: the set has those of the "
                      "panel Analysis.")
                .arg(name);
        });
    }
    document_.sets().open(stored.list);
    emit setOpened();
}

void HistoryPage::askToAdd() {
    QStringList gyros;
    for (const StoredGyro& each : history_ ? history_->gyros : std::vector<StoredGyro>()) {
        if (!each.name.empty()) {
            gyros << QString::fromStdString(each.name);
        }
    }
    if (!path_.isEmpty()) {
        adder_.ask(path_, gyros, this);
    }
}

FigureSource HistoryPage::figures() const {
    if (!history_) {
        return {};
    }
    const QString parameter = indexPlain(parameterTitle(view().parameter));
    const auto gyro = choices_->gyro();
    return figuresOf(
        {values_, ranges_, average_, distribution_}, QStringLiteral("history"),
        gyro ? QStringLiteral("%1: %2").arg(QString::fromStdString(*gyro), parameter) : parameter);
}

void HistoryPage::setUnits(const DisplayUnits& units) {
    units_ = units;
    showHistory();
}

}  // namespace vybeg::ui
