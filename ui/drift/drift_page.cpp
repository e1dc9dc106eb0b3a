#include "ui/drift/drift_page.h"

#include "core/recording/samples/open_table.h"
#include "ui/drift/drift_text.h"
#include "ui/panels/file_list.h"
#include "ui/resonator/warning_list.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/short_names.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <limits>
#include <optional>
#include <type_traits>

namespace vybeg::ui {

DriftPanel::DriftPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      logs_(withName(new FileList(8, this), "driftLogs")),
      open_(withName(new QPushButton(this), "driftOpen")),
      remove_(withName(new QPushButton(this), "driftRemove")),
      form_(new QFormLayout),
      columns_(withName(new QLineEdit(this), "driftColumns")),
      fault_(withName(new QLabel(this), "driftFault")),
      angle_unit_(makeList("driftAngleUnit", log_angle_units.size())),
      time_unit_(makeList("driftTimeUnit", 1 + time_units.size())),
      delimiter_(makeList("driftDelimiter", 1 + delimiters.size())),
      decimal_(makeList("driftDecimal", 1 + decimal_signs.size())),
      skip_lines_(makeNumber("driftSkipLines")),
      time_column_(makeNumber("driftTimeColumn")),
      rate_(makeNumber("driftRate")),
      kappa_(makeNumber("driftKappa")),
      skew_(makeNumber("driftSkew")) {
    logs_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    logs_->setHint([] { return tr("Drop whole-angle logs of one gyro here"); });
    fault_->setWordWrap(true);
    skip_lines_->setInteger(true);
    skip_lines_->setLimits(bounds_in(open_settings(), "skip-lines"));
    time_column_->setInteger(true);
    time_column_->setLimits(0, std::numeric_limits<int>::max());
    rate_->setLimits(bounds_in(open_settings(), "rate"));
    kappa_->setLimits(tolerance_bounds);
    kappa_->setStep(0.001);
    skew_->setLimits(tolerance_bounds);
    skew_->setStep(0.1);

    auto* buttons = fill(new QHBoxLayout, {{open_, 1}, remove_});
    form_->setHorizontalSpacing(6);
    form_->setVerticalSpacing(3);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->setRowWrapPolicy(QFormLayout::DontWrapRows);
    const auto add = [this](QWidget* field) {
        auto* label = new QLabel(this);
        label->setBuddy(field);
        label->setWordWrap(true);
        form_->addRow(label, field);
    };
    add(columns_);
    form_->addRow(fault_);
    for (QWidget* field :
         std::initializer_list<QWidget*>{angle_unit_, time_unit_, rate_, delimiter_, decimal_,
                                         skip_lines_, time_column_, kappa_, skew_}) {
        add(field);
    }
    auto* layout = fill(new QVBoxLayout(this), {6, 4, 6, 2}, 3, {logs_, buttons});
    layout->addSpacing(4);
    layout->addLayout(form_);

    connect(open_, &QPushButton::clicked, this, &DriftPanel::openWanted);
    connect(remove_, &QPushButton::clicked, logs_, &FileList::removeChosen);
    connect(logs_, &FileList::dropped, &document_.drift(), &DriftStore::open);
    connect(logs_, &FileList::removalWanted, &document_.drift(), &DriftStore::remove);
    connect(logs_, &QListWidget::itemSelectionChanged, this,
            [this] { remove_->setEnabled(!logs_->selectedItems().isEmpty()); });
    connect(columns_, &QLineEdit::editingFinished, this, &DriftPanel::editColumns);
    connect(angle_unit_, &QComboBox::activated, this, [this](int place) {
        edit([place](DriftSettings& settings) {
            settings.log.rad_per_angle_unit = log_angle_units.at(static_cast<std::size_t>(place));
        });
    });
    const auto chooses = [this](QComboBox* box, const auto& words, auto member) {
        connect(box, &QComboBox::activated, this, [this, &words, member](int place) {
            editText([&](TextChoice& text) {
                text.*member = entriesOf(words).at(static_cast<std::size_t>(place));
            });
        });
    };
    chooses(time_unit_, time_units, &TextChoice::time_unit_s);
    chooses(delimiter_, delimiters, &TextChoice::delimiter);
    chooses(decimal_, decimal_signs, &TextChoice::decimal_comma);
    const auto counts = [this](NumberField* field, auto member) {
        connect(field, &NumberField::valueEdited, this,
                [this, member](const std::optional<double>& number) {
                    editText([&](TextChoice& text) {
                        auto& value = text.*member;
                        using Whole = typename std::decay_t<decltype(value)>::value_type;
                        value = number ? std::optional(static_cast<Whole>(*number)) : std::nullopt;
                    });
                });
    };
    counts(skip_lines_, &TextChoice::lines_to_skip);
    counts(time_column_, &TextChoice::time_column);
    const auto edits = [this](NumberField* field, const auto& member) {
        connect(field, &NumberField::valueEdited, this, [this, member](auto value) {
            edit([&](DriftSettings& settings) { member(settings) = value; });
        });
    };
    edits(
        rate_, [](DriftSettings & settings) -> auto& { return settings.open.rate_hz; });
    edits(
        kappa_, [](DriftSettings & settings) -> auto& { return settings.tolerance[kappa_error]; });
    edits(
        skew_, [](DriftSettings & settings) -> auto& { return settings.tolerance[skew_error]; });
    connect(&document_.drift(), &DriftStore::changed, this, &DriftPanel::refresh);
    keepTranslated(*this, [this] { retranslate(); });
}

NumberField* DriftPanel::makeNumber(const char* name) {
    auto* field = withName(new NumberField(this), name);
    field->setOptional(true);
    return field;
}

// A list whose first entry is the choice of the file.
QComboBox* DriftPanel::makeList(const char* name, std::size_t entries) {
    auto* box = withName(new QComboBox(this), name);
    box->addItems(QStringList(static_cast<qsizetype>(entries)));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(6);
    return box;
}

void DriftPanel::editText(const std::function<void(TextChoice&)>& change) {
    edit([&change](DriftSettings& settings) {
        std::optional<TextChoice>& text = settings.open.text;
        TextChoice choice = text.value_or(TextChoice{});
        change(choice);
        text = choice == TextChoice{} ? std::nullopt : std::optional(choice);
    });
}

void DriftPanel::edit(const std::function<void(DriftSettings&)>& change) {
    DriftSettings settings = document_.drift().settings();
    change(settings);
    document_.drift().setSettings(settings);
}

// A text that is no list of columns stays in the field, with the reason below it.
void DriftPanel::editColumns() {
    const std::string columns = columns_->text().trimmed().toStdString();
    if (const Status possible = check_log_columns(columns); !possible) {
        showFault(errorText(possible.error()));
        return;
    }
    showFault({});
    edit([&columns](DriftSettings& settings) { settings.log.names = columns; });
}

void DriftPanel::showFault(const QString& sentence) {
    fault_->setVisible(!sentence.isEmpty());
    fault_->setText(sentence.isEmpty() ? sentence : tr("Not in effect: %1").arg(sentence));
    columns_->setAccessibleDescription(sentence);
}

void DriftPanel::refreshLogs() {
    const QStringList chosen = logs_->chosenPaths();
    const QSignalBlocker quiet(logs_);
    const auto outcome = document_.drift().outcome();
    const std::vector<RecordingRef>& logs = document_.drift().logs();
    logs_->clear();
    for (std::size_t k = 0; k < logs.size(); ++k) {
        auto* item = new QListWidgetItem(
            outcome ? logName(outcome->drift, k) : QString::fromStdString(logs[k].name()), logs_);
        const QString path = pathText(logs[k]);
        item->setData(Qt::UserRole, path);
        QString facts = QDir::toNativeSeparators(path);
        if (!logs[k].sha256.empty()) {
            facts += QStringLiteral("\nSHA-256 ") + QString::fromStdString(logs[k].sha256);
        }
        item->setToolTip(plainTip(facts));
        item->setSelected(chosen.contains(path));
    }
    logs_->updateGeometry();
}

void DriftPanel::refresh() {
    refreshLogs();
    remove_->setEnabled(!logs_->selectedItems().isEmpty());
    const DriftSettings& settings = document_.drift().settings();
    const QString columns = QString::fromStdString(settings.log.names);
    // A text that is not in effect stays until the setting becomes another one, as by an undo.
    if (columns != columns_shown_ || !columns_->hasFocus() ||
        columns_->text().trimmed() == columns) {
        columns_shown_ = columns;
        columns_->setText(columns);
        showFault({});
    }
    const TextChoice text = settings.open.text.value_or(TextChoice{});
    angle_unit_->setCurrentIndex(placeIn(log_angle_units, settings.log.rad_per_angle_unit));
    time_unit_->setCurrentIndex(placeIn(entriesOf(time_units), text.time_unit_s));
    delimiter_->setCurrentIndex(placeIn(entriesOf(delimiters), text.delimiter));
    decimal_->setCurrentIndex(placeIn(entriesOf(decimal_signs), text.decimal_comma));
    const auto show = [](NumberField* field, const auto& number) {
        field->setValue(number ? std::optional(static_cast<double>(*number)) : std::nullopt);
    };
    show(skip_lines_, text.lines_to_skip);
    show(time_column_, text.time_column);
    rate_->setValue(settings.open.rate_hz);
    kappa_->setValue(settings.tolerance[kappa_error]);
    skew_->setValue(settings.tolerance[skew_error]);
    kappa_->setPlaceholderText(shortNumberText(assumed_tolerance(kappa_error, 1), 6));
    skew_->setPlaceholderText(shortNumberText(assumed_tolerance(skew_error, 1), 6));
}

void DriftPanel::retranslate() {
    const auto name = [this](QWidget* field, const QString& text, const QString& tip) {
        auto* label = static_cast<QLabel*>(form_->labelForField(field));
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
    name(columns_, tr("Columns"),
         tr("What the columns are: t, theta, amplitude and quadrature effort, each with =COLUMN, a "
            "name or a number, where the file calls it otherwise: t,theta=angle. Empty: by their "
            "names"));
    columns_->setPlaceholderText(tr("by their names"));
    name(angle_unit_, tr("Angle in"),
         tr("Unit of the angle, where the name of its column does not tell it"));
    const QString from_file = tr("as the file says");
    setTexts(*angle_unit_, {from_file, tr("degrees"), tr("radians"), tr("turns")});
    name(time_unit_, tr("Time in"), tr("Unit of the time in a text file"));
    setTexts(*time_unit_, {from_file, tr("s"), tr("ms"), tr("µs"), tr("ns")});
    name(delimiter_, tr("Separator"), tr("What stands between the columns of a text file"));
    setTexts(*delimiter_, {from_file, tr("comma"), tr("semicolon"), tr("tab"), tr("spaces"),
                           tr("vertical bar")});
    name(decimal_, tr("Decimal sign"), tr("Of the numbers in a text file"));
    setTexts(*decimal_, {from_file, tr("point"), tr("comma")});
    name(skip_lines_, tr("Lines to skip"),
         tr("Lines of a text file above its first row of numbers"));
    name(time_column_, tr("Time column"),
         tr("Column of a text file that is the time, counted from 1; 0: none"));
    for (NumberField* field : {skip_lines_, time_column_}) {
        field->setPlaceholderText(from_file);
    }
    name(rate_, tr("Rate"), tr("Rows a second, of a file without times"));
    rate_->setUnit(tr("Hz"));
    name(kappa_, tr("κ ±"),
         tr("How well the gain ratio of the channels is known: relative standard deviation. A gain "
            "error gives a wave that turns a fourth harmonic; u holds it. Grey: assumed; 0: "
            "exact"));
    kappa_->setAccessibleName(tr("Gain ratio of the logs’ channels ±"));
    name(skew_, tr("ε ±"),
         tr("How well the non-orthogonality of the channels is known: standard deviation. Grey: "
            "assumed; 0: exact"));
    skew_->setAccessibleName(tr("Non-orthogonality of the logs’ channels ±"));
    skew_->setUnit(QStringLiteral("°"));
    refresh();
}

namespace {

constexpr int panel_width = 244;  // its lists are not cut in Russian
constexpr int least_plot_height = 260;

}  // namespace

DriftPage::DriftPage(Document& document, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      panel_(new DriftPanel(document, this)),
      export_(withName(new QPushButton(this), "driftExport")),
      state_(sentence(this, "driftState")),
      hint_(hint(this, "driftHint")) {
    setObjectName(QStringLiteral("driftPage"));
    auto* row = fill(new QHBoxLayout, {6, 0, 6, 0}, {export_});
    auto* left = fill(new QVBoxLayout, {}, 0, {panel_, row, state_, LayoutPart(1)});
    auto* side = scrolled(left);  // a low window shows the panel in part
    side->setFixedWidth(panel_width);
    content_ = buildContent();
    fill(new QHBoxLayout(this), {}, 4, {side, {hint_, 1, Qt::AlignCenter}, {content_, 1}});
    connect(panel_, &DriftPanel::openWanted, this, &DriftPage::openWanted);
    connect(export_, &QPushButton::clicked, this, &DriftPage::exportResultWanted);
    connect(&document_.drift(), &DriftStore::changed, this, &DriftPage::refresh);
    guardFromWheel(*this);
    retranslate();
}

QWidget* DriftPage::buildContent() {
    auto* content = new QWidget(this);
    plot_ = addPlot("driftPlot", least_plot_height);
    warnings_ = withName(new WarningList(content), "driftWarnings");
    harmonics_ = withName(new QuantityTable(this), "driftHarmonics");
    agreement_ = sentence(content, "driftAgreement");
    resonator_ = withName(new QuantityTable(this), "driftResonator");
    statistical_ = sentence(content, "driftStatistical");
    auto* numbers = new QVBoxLayout;
    numbers->setSpacing(2);
    numbers->addWidget(warnings_);
    harmonics_section_ = addSection(*numbers, {harmonics_, agreement_});
    resonator_section_ = addSection(*numbers, {resonator_, statistical_});
    numbers->addStretch(1);
    fill(new QHBoxLayout(content), {}, 4, {{plot_, 6}, {scrolled(numbers), 7}});
    return content;
}

FigureSource DriftPage::figures() const {
    return shown_ ? figuresOf({plot_}, QStringLiteral("drift"), QString()) : FigureSource();
}

void DriftPage::refresh() {
    if (!document_.drift().computing()) {
        shown_ = document_.drift().outcome();
    }
    showFound();
}

// Empty where the drift says all.
QString DriftPage::stateText() const {
    const DriftStore& drift = document_.drift();
    if (drift.computing()) {
        return tr("The drift is being computed…");
    }
    return shown_ || !drift.failure()
               ? QString()
               : tr("There is no drift: %1").arg(errorText(*drift.failure()));
}

void DriftPage::showFound() {
    const QString state = stateText();
    state_->setVisible(shown_ && !state.isEmpty());
    state_->setText(richText(state));
    hint_->setVisible(!shown_);
    hint_->setText(
        richText(!state.isEmpty()
                     ? state
                     : tr("Open whole-angle logs: a controller holds the amplitude while the "
                          "wave turns by 180 degrees or more, and its angle is written down over "
                          "the time. Here appear the drift against the angle with its harmonics, "
                          "and, where the log has the efforts, the resonator's damping and "
                          "split.")));
    content_->setVisible(shown_ != nullptr);
    export_->setEnabled(document_.drift().outcome() != nullptr);
    if (shown_) {
        const WholeAngleDrift& drift = shown_->drift;
        plot_->setContent(wholeAnglePlot(drift, units()));
        warnings_->setFindings(findings_of(drift.warnings));
        // The list has the whole names.
        const QStringList headers = logHeaders(drift);
        QStringList logs;
        for (const QString& name : headers.mid(1)) {
            logs << QFileInfo(name).completeBaseName();
        }
        const QStringList all = headers.mid(0, 1);
        harmonics_->setContent(all + logs, logRows(drift, units()), all + distinctNames(logs));
        agreement_->setText(paragraphs(agreementTexts(drift), QStringLiteral("%1")));
        resonator_->setContent({}, heldRows(drift.resonator, units()));
        statistical_->setText(richText(channelsText(pick_offs(shown_->settings.tolerance))));
    }
    emit figuresChanged();
}

void DriftPage::retranslate() {
    const auto name = [](Section* section, QWidget* widget, const QString& title) {
        section->setTitle(title);
        widget->setAccessibleName(title);
    };
    name(harmonics_section_, harmonics_, tr("Drift of the angle"));
    name(resonator_section_, resonator_, tr("Resonator, from drift and efforts"));
    harmonics_->setToolTip(
        tr("The turn and the harmonics of the drift; of several logs each by itself, too. Ctrl+C "
           "copies the table"));
    resonator_->setToolTip(tr("Ctrl+C copies the table"));
    plot_->setAccessibleName(tr("Drift against the angle"));
    plot_->setToolTip(richTip(
        tr("Drift of the wave angle less the turn of each log: means over ranges of the angle with "
           "their standard deviations, and the fitted harmonics with theirs as a band")));
    export_->setText(tr("Export result…"));
    export_->setToolTip(tr("The drift by angle as a table (CSV), or the whole result (JSON)"));
    showFound();
}

}  // namespace vybeg::ui

#include "moc_drift_page.cpp"
