#include "ui/drift/drift_panel.h"

#include "core/recording/samples/open_table.h"
#include "ui/drift/drift_text.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

namespace vybeg::ui {

namespace {

// As the entries of the lists; the first one is what the file tells.
constexpr std::array angle_units{0.0, std::numbers::pi / 180, 1.0};
constexpr std::array<std::optional<double>, 5> log_time_units{std::nullopt, 1.0, 1e-3, 1e-6, 1e-9};

template <class List, class Value>
int placeIn(const List& list, const Value& value) {
    const auto found = std::ranges::find(list, value);
    return found == list.end() ? 0 : static_cast<int>(found - list.begin());
}

}  // namespace

DriftLogs::DriftLogs(Document& document, QWidget* parent)
    : FileList(8, parent), document_(document) {
    setObjectName(QStringLiteral("driftLogs"));
    setSelectionMode(QAbstractItemView::ExtendedSelection);
}

void DriftLogs::refresh() {
    const QStringList chosen = chosenPaths();
    const QSignalBlocker quiet(this);
    const auto outcome = document_.drift().outcome();
    const std::vector<DriftLog>& logs = document_.drift().logs();
    clear();
    for (std::size_t k = 0; k < logs.size(); ++k) {
        auto* item =
            new QListWidgetItem(outcome ? logName(outcome->drift, k) : logs[k].name(), this);
        item->setData(Qt::UserRole, logs[k].path);
        QString facts = QDir::toNativeSeparators(logs[k].path);
        if (!logs[k].sha256.isEmpty()) {
            facts += QStringLiteral("\nSHA-256 ") + logs[k].sha256;
        }
        item->setToolTip(plainTip(facts));
        item->setSelected(chosen.contains(logs[k].path));
    }
    updateGeometry();
}

void DriftLogs::take(const QStringList& files) {
    document_.drift().open(files);
}

void DriftLogs::remove(const QStringList& files) {
    document_.drift().remove(files);
}

QString DriftLogs::hint() const {
    return DriftPanel::tr("Drop whole-angle logs of one gyro here");
}

DriftPanel::DriftPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      logs_(new DriftLogs(document, this)),
      open_(withName(new QPushButton(this), "driftOpen")),
      remove_(withName(new QPushButton(this), "driftRemove")),
      columns_(withName(new QLineEdit(this), "driftColumns")),
      fault_(withName(new QLabel(this), "driftFault")),
      angle_unit_(withName(new QComboBox(this), "driftAngleUnit")),
      time_unit_(withName(new QComboBox(this), "driftTimeUnit")),
      rate_(makeNumber("driftRate")),
      kappa_(makeNumber("driftKappa")),
      skew_(makeNumber("driftSkew")) {
    fault_->setWordWrap(true);
    angle_unit_->addItems(QStringList(static_cast<qsizetype>(angle_units.size())));
    time_unit_->addItems(QStringList(static_cast<qsizetype>(log_time_units.size())));
    for (QComboBox* box : {angle_unit_, time_unit_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
    }
    rate_->setLimits(bounds_in(open_settings(), "rate"));
    kappa_->setLimits(tolerance_bounds);
    kappa_->setStep(0.001);
    skew_->setLimits(tolerance_bounds);
    skew_->setStep(0.1);

    auto* buttons = fill(new QHBoxLayout, {{open_, 1}, remove_});
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(6);
    form->setVerticalSpacing(3);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setRowWrapPolicy(QFormLayout::DontWrapRows);
    columns_label_ = addRow(form, columns_);
    form->addRow(fault_);
    angle_unit_label_ = addRow(form, angle_unit_);
    time_unit_label_ = addRow(form, time_unit_);
    rate_label_ = addRow(form, rate_);
    kappa_label_ = addRow(form, kappa_);
    skew_label_ = addRow(form, skew_);
    auto* layout = fill(new QVBoxLayout(this), {6, 4, 6, 2}, 3, {logs_, buttons});
    layout->addSpacing(4);
    layout->addLayout(form);

    connect(open_, &QPushButton::clicked, this, &DriftPanel::openWanted);
    connect(remove_, &QPushButton::clicked, logs_, [this] { logs_->removeChosen(); });
    connect(logs_, &QListWidget::itemSelectionChanged, this,
            [this] { remove_->setEnabled(!logs_->selectedItems().isEmpty()); });
    connect(columns_, &QLineEdit::editingFinished, this, &DriftPanel::editColumns);
    connect(angle_unit_, &QComboBox::activated, this, [this](int place) {
        edit([place](DriftSettings& settings) {
            settings.reading.rad_per_angle_unit = angle_units.at(static_cast<std::size_t>(place));
        });
    });
    connect(time_unit_, &QComboBox::activated, this, [this](int place) {
        edit([place](DriftSettings& settings) {
            std::optional<TextChoice>& text = settings.reading.open.text;
            TextChoice choice = text.value_or(TextChoice{});
            choice.time_unit_s = log_time_units.at(static_cast<std::size_t>(place));
            text = choice == TextChoice{} ? std::nullopt : std::optional(choice);
        });
    });
    connect(rate_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
        edit([value](DriftSettings& settings) { settings.reading.open.rate_hz = value; });
    });
    connect(kappa_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
        edit([value](DriftSettings& settings) { settings.tolerance.kappa = value; });
    });
    connect(skew_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
        edit([value](DriftSettings& settings) { settings.tolerance.skew_deg = value; });
    });
    connect(&document_.drift(), &DriftStore::changed, this, &DriftPanel::refresh);
    keepTranslated(*this, [this] { retranslate(); });
}

QLabel* DriftPanel::addRow(QFormLayout* form, QWidget* field) {
    auto* label = new QLabel(this);
    label->setBuddy(field);
    label->setWordWrap(true);
    form->addRow(label, field);
    return label;
}

NumberField* DriftPanel::makeNumber(const char* name) {
    auto* field = withName(new NumberField(this), name);
    field->setOptional(true);
    return field;
}

void DriftPanel::edit(const std::function<void(DriftSettings&)>& change) {
    DriftSettings settings = document_.drift().settings();
    change(settings);
    document_.drift().setSettings(settings);
}

// What is no list of columns stays in the field, with the reason below it.
void DriftPanel::editColumns() {
    const std::string columns = columns_->text().trimmed().toStdString();
    if (const Status possible = check_log_columns(columns); !possible) {
        showFault(errorText(possible.error()));
        return;
    }
    showFault({});
    edit([&columns](DriftSettings& settings) { settings.reading.columns = columns; });
}

void DriftPanel::showFault(const QString& sentence) {
    fault_->setVisible(!sentence.isEmpty());
    fault_->setText(sentence.isEmpty() ? sentence : tr("Not in effect: %1").arg(sentence));
    columns_->setAccessibleDescription(sentence);
}

void DriftPanel::refresh() {
    logs_->refresh();
    remove_->setEnabled(!logs_->selectedItems().isEmpty());
    const DriftSettings& settings = document_.drift().settings();
    const QString columns = QString::fromStdString(settings.reading.columns);
    // A text that is not in effect stays until the setting becomes another one, as by an undo.
    if (columns != columns_shown_ || !columns_->hasFocus() ||
        columns_->text().trimmed() == columns) {
        columns_shown_ = columns;
        columns_->setText(columns);
        showFault({});
    }
    const std::optional<TextChoice>& text = settings.reading.open.text;
    angle_unit_->setCurrentIndex(placeIn(angle_units, settings.reading.rad_per_angle_unit));
    time_unit_->setCurrentIndex(placeIn(log_time_units, text ? text->time_unit_s : std::nullopt));
    rate_->setValue(settings.reading.open.rate_hz);
    kappa_->setValue(settings.tolerance.kappa);
    skew_->setValue(settings.tolerance.skew_deg);
    const ChannelTolerance usual = usual_pick_offs();
    kappa_->setPlaceholderText(QLocale().toString(usual.kappa));
    skew_->setPlaceholderText(QLocale().toString(usual.skew_rad * 180 / std::numbers::pi));
}

void DriftPanel::retranslate() {
    const auto name = [](QLabel* label, QWidget* field, const QString& text, const QString& tip) {
        label->setText(richText(text));
        label->setToolTip(richTip(tip));
        field->setToolTip(richTip(tip));
        field->setAccessibleName(text);
    };
    logs_->setAccessibleName(tr("Whole-angle logs"));
    logs_->setToolTip(
        tr("Logs of one gyro: its angle, written down while a controller holds the amplitude. "
           "Delete removes the chosen ones"));
    open_->setText(tr("Open…"));
    open_->setAccessibleName(tr("Open whole-angle logs"));
    open_->setToolTip(tr("Text, NPZ, MAT or HDF5 with a column of the wave angle"));
    remove_->setText(tr("Remove"));
    remove_->setAccessibleName(tr("Remove the chosen logs"));
    remove_->setToolTip(tr("The files stay; Undo takes it back"));
    name(columns_label_, columns_, tr("Columns"),
         tr("What the columns are: t, theta, amplitude and quadrature effort, each with =COLUMN, a "
            "name or a number, where the file calls it otherwise: t,theta=angle. Empty: by their "
            "names"));
    columns_->setPlaceholderText(tr("by their names"));
    name(angle_unit_label_, angle_unit_, tr("Angle in"),
         tr("Unit of the angle, where the name of its column does not tell it"));
    const QString from_file = tr("as the file says");
    setTexts(*angle_unit_, {from_file, tr("degrees"), tr("radians")});
    name(time_unit_label_, time_unit_, tr("Time in"), tr("Unit of the time in a text file"));
    setTexts(*time_unit_, {from_file, tr("s"), tr("ms"), tr("µs"), tr("ns")});
    name(rate_label_, rate_, tr("Rate"), tr("Rows a second, of a file without times"));
    rate_->setUnit(tr("Hz"));
    name(kappa_label_, kappa_, tr("κ ±"),
         tr("How well the gain ratio of the channels is known: relative standard deviation. A gain "
            "error gives a wave that turns a fourth harmonic; u holds it. Grey: assumed; 0: "
            "exact"));
    kappa_->setAccessibleName(tr("Gain ratio of the logs’ channels ±"));
    name(skew_label_, skew_, tr("ε ±"),
         tr("How well the non-orthogonality of the channels is known: standard deviation. Grey: "
            "assumed; 0: exact"));
    skew_->setAccessibleName(tr("Non-orthogonality of the logs’ channels ±"));
    skew_->setUnit(QStringLiteral("°"));
    refresh();
}

}  // namespace vybeg::ui
