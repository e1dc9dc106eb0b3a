#include "ui/history/history_choices.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QSettings>
#include <QSpinBox>

#include <algorithm>

namespace vybeg::ui {

namespace {

constexpr int least_results = 2;
constexpr int most_results = 10'000;
constexpr int usual_results = 20;

const QString baseline_key = QStringLiteral("history/baseline");

}  // namespace

HistoryChoices::HistoryChoices(QWidget* parent)
    : QWidget(parent),
      gyro_(withName(new QComboBox(this), "historyGyro")),
      parameter_(withName(new QComboBox(this), "historyParameter")),
      axis_(withName(new QComboBox(this), "historyAxis")),
      baseline_(withName(new QSpinBox(this), "historyBaseline")),
      choices_{{{labelFor(gyro_, [] { return tr("Gyro"); }), gyro_},
                {labelFor(parameter_, [] { return tr("Parameter"); }), parameter_},
                {labelFor(axis_, [] { return tr("Against"); }), axis_},
                {labelFor(baseline_, [] { return tr("Baseline"); }), baseline_}}},
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
    placeByWidth(*this, wide, false, [this](bool is_wide) { place(is_wide ? 4 : 2); });
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

// So many choices stand beside each other.
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

}  // namespace vybeg::ui

#include "moc_history_choices.cpp"
