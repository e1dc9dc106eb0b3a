#include "ui/document/document.h"
#include "ui/history/history_page.h"
#include "ui/plots/xy_plot_view.h"
#include "ui/words/number_label.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

namespace vybeg::ui {

namespace {

constexpr int plot_height = 240;
constexpr int least_baseline_shown = 2;
constexpr int most_baseline = 10'000;
constexpr int usual_baseline = 20;

const QString baseline_key = QStringLiteral("history/baseline");

void makeSentence(QLabel* label, const char* name) {
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label->setFocusPolicy(Qt::ClickFocus);
}

}  // namespace

QLayout* HistoryPage::buildHead() {
    database_->setTextFormat(Qt::PlainText);
    database_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    open_->setObjectName(QStringLiteral("historyOpen"));
    new_->setObjectName(QStringLiteral("historyNew"));
    add_->setObjectName(QStringLiteral("historyAdd"));
    makeSentence(state_, "historyState");
    auto* first = new QHBoxLayout;
    first->addWidget(database_, 1);
    first->addWidget(open_);
    first->addWidget(new_);
    first->addWidget(add_);

    choices_ = new QWidget(this);
    const auto choice = [this](QLabel*& label, QComboBox*& box, const char* name) {
        label = new QLabel(choices_);
        box = new QComboBox(choices_);
        box->setObjectName(QLatin1String(name));
        label->setBuddy(box);
    };
    choice(gyro_label_, gyro_, "historyGyro");
    choice(parameter_label_, parameter_, "historyParameter");
    choice(axis_label_, axis_, "historyAxis");
    gyro_->addItem(QString());
    gyro_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    gyro_->setMinimumContentsLength(9);
    parameter_->setItemDelegate(new IndexDelegate(parameter_));
    parameter_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    parameter_->setMinimumContentsLength(14);
    for ([[maybe_unused]] const HistoryParameter& each : historyParameters()) {
        parameter_->addItem(QString());
    }
    parameter_->setCurrentIndex(1);
    axis_->addItems({QString(), QString(), QString()});
    baseline_label_ = new QLabel(choices_);
    baseline_ = new QSpinBox(choices_);
    baseline_->setObjectName(QStringLiteral("historyBaseline"));
    baseline_->setRange(least_baseline_shown, most_baseline);
    baseline_->setValue(QSettings().value(baseline_key, usual_baseline).toInt());
    baseline_->setKeyboardTracking(false);
    baseline_label_->setBuddy(baseline_);
    auto* second = new QGridLayout(choices_);
    second->setContentsMargins(0, 0, 0, 0);
    second->addWidget(gyro_label_, 0, 0);
    second->addWidget(gyro_, 0, 1);
    second->addWidget(parameter_label_, 0, 2);
    second->addWidget(parameter_, 0, 3);
    second->addWidget(axis_label_, 1, 0);
    second->addWidget(axis_, 1, 1);
    second->addWidget(baseline_label_, 1, 2);
    second->addWidget(baseline_, 1, 3);
    second->setColumnStretch(1, 1);
    second->setColumnStretch(3, 1);

    auto* rows = new QVBoxLayout;
    rows->setContentsMargins(6, 4, 6, 0);
    rows->setSpacing(4);
    rows->addLayout(first);
    rows->addWidget(choices_);
    rows->addWidget(state_);
    return rows;
}

QWidget* HistoryPage::buildContent() {
    auto* content = new QWidget(this);
    verdict_ = new QLabel(content);
    makeSentence(verdict_, "historyVerdict");
    point_ = new QLabel(content);
    makeSentence(point_, "historyPoint");
    recordings_ = new QPushButton(content);
    recordings_->setObjectName(QStringLiteral("historyRecordings"));
    values_ = addPlot("historyValues", plot_height + 20);
    ranges_ = addPlot("historyRanges", plot_height);
    average_ = addPlot("historyAverage", plot_height);
    distribution_ = addPlot("historyDistribution", plot_height);
    auto* chosen = new QHBoxLayout;
    chosen->addWidget(point_, 1);
    chosen->addWidget(recordings_, 0, Qt::AlignTop);
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(6, 0, 6, 0);
    grid->setSpacing(4);
    grid->addWidget(verdict_, 0, 0, 1, 2);
    grid->addWidget(values_, 1, 0, 1, 2);
    grid->addLayout(chosen, 2, 0, 1, 2);
    grid->addWidget(ranges_, 3, 0);
    grid->addWidget(average_, 3, 1);
    grid->addWidget(distribution_, 4, 0, 1, 2);
    grid->setRowStretch(1, 3);
    grid->setRowStretch(3, 2);
    grid->setRowStretch(4, 2);
    return content;
}

XYPlotView* HistoryPage::addPlot(const char* name, int height) {
    auto* plot = new XYPlotView(this);
    plot->setObjectName(QLatin1String(name));
    plot->setMinimumHeight(height);
    plot->setMaximumHeight(QWIDGETSIZE_MAX);
    plot->setMinimumWidth(180);
    connect(plot, &XYPlotView::exportWanted, this, &HistoryPage::exportWanted);
    connect(plot, &XYPlotView::stepWanted, this, &HistoryPage::step);
    return plot;
}

void HistoryPage::connectWidgets() {
    connect(open_, &QPushButton::clicked, this, &HistoryPage::openWanted);
    connect(new_, &QPushButton::clicked, this, &HistoryPage::newWanted);
    connect(add_, &QPushButton::clicked, this, &HistoryPage::askToAdd);
    connect(recordings_, &QPushButton::clicked, this, &HistoryPage::openChosen);
    connect(gyro_, &QComboBox::activated, this, &HistoryPage::read);
    connect(parameter_, &QComboBox::currentIndexChanged, this, &HistoryPage::read);
    connect(axis_, &QComboBox::currentIndexChanged, this, &HistoryPage::showHistory);
    connect(baseline_, &QSpinBox::valueChanged, this, [this](int count) {
        QSettings().setValue(baseline_key, count);
        compute();
    });
    for (const auto& [plot, shown] :
         {std::pair{values_, &shown_values_}, std::pair{ranges_, &shown_ranges_},
          std::pair{average_, &shown_average_}}) {
        connect(plot, &XYPlotView::pointClicked, this,
                [this, shown = shown](int place) { choose(*shown, place); });
        connect(plot, &XYPlotView::pointActivated, this, [this, shown = shown](int place) {
            choose(*shown, place);
            openChosen();
        });
    }
    connect(&document_.sets(), &SetStore::changed, this, &HistoryPage::refresh);
    connect(&document_.sets(), &SetStore::passportChanged, this, &HistoryPage::showHistory);
}

// The chosen gyro stays chosen.
void HistoryPage::fillGyros() {
    const QSignalBlocker quiet(gyro_);
    const std::optional<QString> before =
        gyro_->currentIndex() > 0 ? std::optional(gyro_->currentData().toString()) : std::nullopt;
    while (gyro_->count() > 1) {
        gyro_->removeItem(1);
    }
    for (const StoredGyro& each : history_->gyros) {
        const QString name = QString::fromStdString(each.name);
        gyro_->addItem(
            QStringLiteral("%1 (%2)").arg(name.isEmpty() ? tr("without a name") : name,
                                          QLocale().toString(static_cast<qlonglong>(each.results))),
            name);
    }
    gyro_->setCurrentIndex(before ? std::max(0, gyro_->findData(*before)) : 0);
}

void HistoryPage::nameControls() {
    open_->setText(tr("Open…"));
    open_->setAccessibleName(tr("Open a database"));
    open_->setToolTip(richTip(tr("A database of results, as batch --database writes it")));
    new_->setText(tr("New…"));
    new_->setAccessibleName(tr("Make a database"));
    new_->setToolTip(richTip(tr("An empty database of results in a new file")));
    add_->setText(tr("Add this result…"));
    gyro_label_->setText(tr("Gyro"));
    gyro_->setAccessibleName(tr("Gyro of the history"));
    gyro_->setToolTip(
        richTip(tr("Whose results are shown; the number of its results stands behind "
                   "its name")));
    parameter_label_->setText(tr("Parameter"));
    parameter_->setAccessibleName(tr("Parameter of the history"));
    parameter_->setToolTip(richTip(tr("Which of its parameters is shown")));
    axis_label_->setText(tr("Against"));
    axis_->setAccessibleName(tr("Axis of the history"));
    axis_->setToolTip(richTip(tr("The mean frequency follows the temperature of the resonator")));
    baseline_label_->setText(tr("Baseline"));
    baseline_->setAccessibleName(tr("Baseline of the control charts"));
    baseline_->setToolTip(
        richTip(tr("So many first results of the gyro set centre and limits of the charts")));
    recordings_->setText(tr("Open its recordings"));
    recordings_->setToolTip(
        richTip(tr("As a set, with the settings and conditions of the result; a double click on "
                   "the point does the same")));
    values_->setAccessibleName(tr("Values of the parameter"));
    ranges_->setAccessibleName(tr("Moving range"));
    average_->setAccessibleName(tr("Weighted average"));
    distribution_->setAccessibleName(tr("Distribution of the parameter"));
    const QString tip =
        richTip(tr("A click chooses a result, a double click opens its recordings; "
                   "Left and Right go to its neighbours"));
    for (XYPlotView* plot : {values_, ranges_, average_}) {
        plot->setToolTip(tip);
    }
    distribution_->setToolTip(richTip(tr("How often each value occurs among the results shown")));
}

void HistoryPage::retranslate() {
    nameControls();
    gyro_->setItemText(0, tr("All gyros"));
    for (std::size_t k = 0; k < historyParameters().size(); ++k) {
        parameter_->setItemText(static_cast<int>(k),
                                indexPlain(parameterTitle(historyParameters()[k])));
    }
    const QString axes[] = {tr("Date"), tr("Frequency"), tr("Order")};
    for (int k = 0; k < axis_->count(); ++k) {
        axis_->setItemText(k, axes[k]);
    }
    if (history_) {
        fillGyros();
    }
    showHistory();
}

}  // namespace vybeg::ui
