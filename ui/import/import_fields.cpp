#include "ui/import/import_fields.h"

#include "core/recording/samples/open_table.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/theme.h"

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>

namespace vybeg::ui {

namespace {

constexpr int most_columns = 200;  // offered in a list

void select(QComboBox& box, int number) {
    int index = box.findData(number);
    if (index < 0) {
        // Not in the file, or unknown yet.
        box.addItem(QString::number(number), number);
        index = box.count() - 1;
    }
    box.setCurrentIndex(index);
}

QString namesText(const std::vector<std::string>& names) {
    QStringList texts;
    for (const std::string& name : names) {
        texts << QString::fromStdString(name);
    }
    return texts.join(QStringLiteral(", "));
}

std::vector<std::string> namesIn(const QLineEdit& field) {
    std::vector<std::string> names;
    for (const QString& name : field.text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        names.push_back(name.trimmed().toStdString());
    }
    return names;
}

QString named(int number, const Channel& channel) {
    const QString name = QString::fromStdString(channel.name);
    QString text = QString::number(number);
    if (!name.isEmpty() && name != text) {
        text += QStringLiteral(": ") + name;
    }
    return channel.unit.empty()
               ? text
               : QStringLiteral("%1 [%2]").arg(text, QString::fromStdString(channel.unit));
}

}  // namespace

void FormRows::add(const char* name, const FieldWords& words, QWidget* field) const {
    addRow(*form, words.label, withName(field, name), words.tip);
    form->labelForField(field)->setToolTip(words.tip);
}

QComboBox* FormRows::list(const char* name, const FieldWords& words,
                          const QStringList& entries) const {
    auto* box = new QComboBox(parent);
    add(name, words, box);
    box->addItems(entries);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(characters);
    QObject::connect(box, &QComboBox::currentIndexChanged, parent,
                     [told = changed, box] { told(box); });
    return box;
}

NumberField* FormRows::number(const char* name, const FieldWords& words,
                              const Bounds& limits) const {
    auto* field = new NumberField(parent);
    add(name, words, field);
    field->setLimits(limits);
    const auto tell = [told = changed, field] { told(field); };
    QObject::connect(field, &QLineEdit::textEdited, parent, tell);
    QObject::connect(field, &NumberField::valueEdited, parent, tell);
    return field;
}

QLineEdit* FormRows::text(const char* name, const FieldWords& words) const {
    auto* field = new QLineEdit(parent);
    add(name, words, field);
    QObject::connect(field, &QLineEdit::textEdited, parent,
                     [told = changed, field] { told(field); });
    return field;
}

ImportFields::ImportFields(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const FormRows rows{this, form_, 16, [this](QWidget*) { emit edited(); }};
    const auto bounds = [](const char* option) -> const Bounds& {
        return bounds_in(open_settings(), option);
    };
    const QString automatic;  // showAutomatic() has its words
    read_as_ =
        rows.list("read_as", {tr("Read as"), tr("By its content, or as what it is said to be")},
                  {tr("what it is by content"), tr("text"), tr("raw samples")});
    delimiter_ = rows.list(
        "delimiter", {tr("Separator"), tr("What stands between the columns")},
        {automatic, tr("comma"), tr("semicolon"), tr("tab"), tr("spaces"), tr("vertical bar")});
    decimal_ = rows.list("decimal", {tr("Decimal sign"), tr("Of the numbers in the file")},
                         {automatic, tr("point"), tr("comma")});
    skip_lines_ =
        rows.number("skip_lines", {tr("Lines to skip"), tr("Above the first row of numbers")},
                    bounds("skip-lines"));
    skip_lines_->setInteger(true);
    skip_lines_->setOptional(true);
    time_column_ = rows.list(
        "time_column",
        {tr("Time column"), tr("Gives the sample rate and is no channel; all other columns are")},
        {automatic, tr("none")});
    time_column_->setItemData(1, 0);
    time_unit_ = rows.list("time_unit", {tr("Unit of time"), tr("Of the time column")},
                           {automatic, tr("s"), tr("ms"), tr("µs"), tr("ns")});
    raw_type_ = rows.list(
        "raw_type", {tr("Sample type"), tr("How each sample is stored")},
        {tr("16 bit integer"), tr("32 bit integer"), tr("32 bit float"), tr("64 bit float")});
    raw_order_ =
        rows.list("raw_order", {tr("Byte order"), tr("Little endian: the lowest byte comes first")},
                  {tr("little endian"), tr("big endian")});
    raw_channels_ = new QSpinBox(this);
    rows.add("raw_channels",
             {tr("Channels"), tr("Interleaved: a sample of each, then the next of each")},
             raw_channels_);
    const Bounds& channels = bounds("raw-channels");
    raw_channels_->setRange(static_cast<int>(channels.least), static_cast<int>(channels.most));
    connect(raw_channels_, &QSpinBox::valueChanged, this, &ImportFields::edited);
    raw_skip_ = rows.number("raw_skip", {tr("Header"), tr("Bytes before the first sample")},
                            bounds("skip"));
    raw_skip_->setInteger(true);
    raw_skip_->setUnit(tr("bytes"));
    variables_ = rows.text(
        "variables",
        {tr("Variables"),
         tr("Names of the variables that hold C and D and, third, the rate, with commas between "
            "them")});
    variables_->setPlaceholderText(tr("the first that fit"));
    channel_d_file_ = rows.text(
        "channel_d_file", {tr("File of channel D"),
                           tr("Where each channel has a file of its own: its name, or its path")});
    join_ = rows.text(
        "join", {tr("Further pieces"),
                 tr("Where a recording is in pieces: the names or paths of the further ones, in "
                    "their order, with commas between them")});
    addChoice(*channel_d_file_);
    addChoice(*join_);
    const QString counted = tr("Counted from 1; a time column does not count");
    channel_c_ = rows.list("channel_c", {tr("Channel C"), counted}, {});
    channel_d_ = rows.list("channel_d", {tr("Channel D"), counted}, {});
    rate_ =
        rows.number("rate", {tr("Sample rate"), tr("Used where the file has no rate of its own")},
                    bounds("rate"));
    rate_->setOptional(true);
    rate_->setUnit(tr("Hz"));
    scale_ =
        rows.number("scale", {tr("Scale"), tr("Recording units per count or per unit of the file")},
                    bounds("scale"));
    unit_ = rows.text("unit", {tr("Unit"), tr("Of the samples, once they are scaled")});
    setOptions({});
    guardFromWheel(*this);
    showChoices();
    showAutomatic();
    whenChanged(*this, {QEvent::PaletteChange}, [this] { showChoices(); });
    connect(this, &ImportFields::edited, this, &ImportFields::showRows);
}

void ImportFields::addChoice(QLineEdit& field) {
    QAction* choose = field.addAction(QIcon(), QLineEdit::TrailingPosition);
    choose->setText(tr("Choose…"));
    choose->setToolTip(choose->text());
    choose_.push_back(choose);
    connect(choose, &QAction::triggered, this, [this, &field] {
        emit filesWanted([fields = QPointer(this), &field](const QStringList& files) {
            if (fields) {
                field.setText(&field == fields->join_ ? files.join(QStringLiteral(", "))
                                                      : files.first());
                emit fields->edited();
            }
        });
    });
}

void ImportFields::setOptions(const OpenOptions& options) {
    const QSignalBlocker blocker(this);
    const TextChoice text = options.text.value_or(TextChoice{});
    const RawLayout raw = options.raw.value_or(RawLayout{});
    read_as_->setCurrentIndex(static_cast<int>(options.raw    ? ReadAs::raw
                                               : options.text ? ReadAs::text
                                                              : ReadAs::content));
    delimiter_->setCurrentIndex(placeIn(entriesOf(delimiters), text.delimiter));
    decimal_->setCurrentIndex(placeIn(entriesOf(decimal_signs), text.decimal_comma));
    skip_lines_->setValue(text.lines_to_skip
                              ? std::optional(static_cast<double>(*text.lines_to_skip))
                              : std::nullopt);
    if (text.time_column) {
        select(*time_column_, *text.time_column);
    } else {
        time_column_->setCurrentIndex(0);
    }
    time_unit_->setCurrentIndex(placeIn(entriesOf(time_units), text.time_unit_s));
    raw_type_->setCurrentIndex(static_cast<int>(raw.type));
    raw_order_->setCurrentIndex(raw.big_endian ? 1 : 0);
    raw_channels_->setValue(raw.channels);
    raw_skip_->setValue(static_cast<double>(raw.skip_bytes));
    variables_->setText(namesText(options.variables));
    select(*channel_c_, options.channel_c);
    select(*channel_d_, options.channel_d);
    rate_->setValue(options.rate_hz);
    scale_->setValue(options.scale);
    unit_->setText(QString::fromStdString(options.unit));
    channel_d_file_->setText(QString::fromStdString(options.channel_d_file));
    pieces_ = options.join;
    join_->setText(namesText(pieces_));
    showRows();
}

ImportFields::ReadAs ImportFields::readAs() const {
    return static_cast<ReadAs>(read_as_->currentIndex());
}

bool ImportFields::isText() const {
    return readAs() == ReadAs::text || (readAs() == ReadAs::content && preview_ &&
                                        preview_->file_format && preview_->file_format->is_text());
}

bool ImportFields::hasVariables() const {
    return readAs() == ReadAs::content && preview_ && preview_->file_format &&
           preview_->file_format->has_variables;
}

TextChoice ImportFields::textChoice() const {
    TextChoice choice;
    const auto listed = [](const QComboBox& box, const auto& words) {
        return entriesOf(words).at(static_cast<std::size_t>(box.currentIndex()));
    };
    choice.delimiter = listed(*delimiter_, delimiters);
    choice.decimal_comma = listed(*decimal_, decimal_signs);
    if (const auto lines = skip_lines_->typed()) {
        choice.lines_to_skip = static_cast<std::int64_t>(*lines);
    }
    if (time_column_->currentIndex() > 0) {
        choice.time_column = time_column_->currentData().toInt();
    }
    choice.time_unit_s = listed(*time_unit_, time_units);
    return choice;
}

std::vector<std::string> ImportFields::pieces() const {
    return join_->text() == namesText(pieces_) ? pieces_ : namesIn(*join_);
}

OpenOptions ImportFields::options() const {
    OpenOptions options;
    options.rate_hz = rate_->typed();
    options.channel_c = channel_c_->currentData().toInt();
    options.channel_d = channel_d_->currentData().toInt();
    options.scale = scale_->typed().value_or(1);
    options.unit = unit_->text().trimmed().toStdString();
    options.channel_d_file = channel_d_file_->text().trimmed().toStdString();
    options.join = options.channel_d_file.empty() ? pieces() : std::vector<std::string>{};
    if (readAs() == ReadAs::raw) {
        options.raw = {.type = static_cast<RawType>(raw_type_->currentIndex()),
                       .big_endian = raw_order_->currentIndex() == 1,
                       .channels = raw_channels_->value(),
                       .skip_bytes = static_cast<std::int64_t>(raw_skip_->typed().value_or(0))};
    } else if (isText()) {
        const TextChoice choice = textChoice();
        if (readAs() == ReadAs::text || choice != TextChoice{}) {
            options.text = choice;
        }
    } else if (hasVariables() && !variables_->text().trimmed().isEmpty()) {
        for (const QString& name : variables_->text().split(QLatin1Char(','))) {
            options.variables.push_back(name.trimmed().toStdString());
        }
    }
    return options;
}

bool ImportFields::isValid() const {
    return std::ranges::all_of(
        std::array{skip_lines_, raw_skip_, rate_, scale_}, [](const NumberField* field) {
            return field->isHidden() || (field->isValid() && field->fault().isEmpty());
        });
}

void ImportFields::setPreview(const RecordingPreview& preview) {
    preview_ = preview;
    showAutomatic();
    showColumns();
    showChannels(*channel_c_);
    showChannels(*channel_d_);
    showRows();
}

void ImportFields::showRows() {
    const bool raw = readAs() == ReadAs::raw;
    const auto show = [this](std::initializer_list<QWidget*> fields, bool shown) {
        for (QWidget* field : fields) {
            form_->setRowVisible(field, shown);
        }
    };
    show({delimiter_, decimal_, skip_lines_, time_column_, time_unit_}, isText());
    show({raw_type_, raw_order_, raw_channels_, raw_skip_}, raw);
    show({variables_}, hasVariables());
    // A recording has a file for each channel, or pieces.
    const bool pair = !channel_d_file_->text().trimmed().isEmpty();
    join_->setEnabled(!pair);
    channel_d_file_->setEnabled(pair || pieces().empty());
    scale_->setConflict(scale_->typed() == 0 ? tr("A number other than 0 is needed.") : QString());
}

// Shows the automatic values in the first entry of each list and in empty fields.
void ImportFields::showAutomatic() {
    const auto automatic = [this](const QString& value) {
        return value.isEmpty() ? tr("automatic") : tr("automatic: %1").arg(value);
    };
    // The value of an automatic choice is that of the used format.
    const auto format = [this](bool is_automatic) {
        return !preview_                        ? nullptr
               : is_automatic && preview_->used ? &*preview_->used
               : preview_->guessed              ? &*preview_->guessed
                                                : nullptr;
    };
    const auto entry = [&](QComboBox& box, auto&& value) {
        const TextFormat* found = format(box.currentIndex() == 0);
        box.setItemText(0, automatic(found ? value(*found) : QString()));
    };
    entry(*delimiter_, [this](const TextFormat& found) {
        return delimiter_->itemText(placeIn(entriesOf(delimiters), found.delimiter));
    });
    entry(*decimal_, [this](const TextFormat& found) {
        return decimal_->itemText(found.decimal_comma ? 2 : 1);
    });
    entry(*time_column_, [this](const TextFormat& found) {
        const int column = found.time_column;
        return column < 0 ? time_column_->itemText(1)
                          : named(column + 1, {found.heading(column).name, {}});
    });
    entry(*time_unit_, [this](const TextFormat& found) {
        const int index = placeIn(entriesOf(time_units), found.time_unit_s);
        return found.time_column >= 0 && index > 0 ? time_unit_->itemText(index) : QString();
    });
    const TextFormat* lines = format(!skip_lines_->typed());
    skip_lines_->setPlaceholderText(
        automatic(lines ? QLocale().toString(lines->lines_to_skip) : QString()));
    const bool needed = preview_ && !preview_->rate_hz && preview_->time_column < 0;
    rate_->setPlaceholderText(needed                                   ? tr("needed")
                              : preview_ && preview_->time_column >= 0 ? tr("from the time column")
                                                                       : tr("from the file"));
    unit_->setPlaceholderText(tr("from the file"));
    channel_d_file_->setPlaceholderText(tr("the same file"));
    join_->setPlaceholderText(tr("none"));
}

void ImportFields::focusRate() {
    rate_->setFocus();
}

void ImportFields::showColumns() {
    const QSignalBlocker blocker(time_column_);
    const TextFormat* format = preview_->used ? &*preview_->used : nullptr;
    const bool said = time_column_->currentIndex() > 0;
    const int chosen = said ? time_column_->currentData().toInt() : 0;
    while (time_column_->count() > 2) {
        time_column_->removeItem(2);
    }
    for (int column = 0; format && column < std::min(format->columns, most_columns); ++column) {
        time_column_->addItem(named(column + 1, format->heading(column)), column + 1);
    }
    if (said) {
        select(*time_column_, chosen);
    }
}

void ImportFields::showChannels(QComboBox& box) {
    const QSignalBlocker blocker(box);
    const int chosen = box.currentData().toInt();
    box.clear();
    const int count = std::min(static_cast<int>(preview_->channels.size()), most_columns);
    for (int channel = 1; channel <= count; ++channel) {
        box.addItem(named(channel, preview_->channels[static_cast<std::size_t>(channel - 1)]),
                    channel);
    }
    select(box, chosen);
}

// The signs in the fields of files.
void ImportFields::showChoices() {
    for (QAction* choose : choose_) {
        choose->setIcon(themedIcon(QStringLiteral("open"), palette()));
    }
}

}  // namespace vybeg::ui

#include "moc_import_fields.cpp"
