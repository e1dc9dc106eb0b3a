#include "ui/open_options_dialog.h"

#include "ui/number_field.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace vybeg::ui {

OpenOptionsDialog::OpenOptionsDialog(const QString& path, const OpenOptions& options,
                                     QWidget* parent)
    : QDialog(parent), path_(path) {
    setAttribute(Qt::WA_DeleteOnClose);
    const auto spin = [this](int value) {
        auto* box = new QSpinBox(this);
        box->setRange(1, 4096);
        box->setValue(value);
        return box;
    };
    for (QLabel*& label : labels_) {
        label = new QLabel(this);
    }
    title_ = new QLabel(this);
    title_->setWordWrap(true);
    rate_ = new NumberField(this);
    rate_->setOptional(true);
    rate_->setLimits(1e-9, 1e12);
    rate_->setValue(options.rate_hz);
    channel_c_ = spin(options.channel_c);
    channel_d_ = spin(options.channel_d);

    QStringList names;
    for (const std::string& name : options.variables) {
        names << QString::fromStdString(name);
    }
    variables_ = new QLineEdit(names.join(QStringLiteral(", ")), this);

    const RawLayout layout = options.raw.value_or(RawLayout{});
    raw_ = new QGroupBox(this);
    raw_->setCheckable(true);
    raw_->setChecked(options.raw.has_value());
    type_ = new QComboBox(raw_);
    type_->addItems({{}, {}, {}, {}});
    type_->setCurrentIndex(static_cast<int>(layout.type));
    order_ = new QComboBox(raw_);
    order_->addItems({{}, {}});
    order_->setCurrentIndex(layout.big_endian ? 1 : 0);
    channels_ = spin(layout.channels);
    skip_ = new NumberField(raw_);
    skip_->setInteger(true);
    skip_->setLimits(0, 1e15);
    skip_->setValue(static_cast<double>(layout.skip_bytes));
    scale_ = new NumberField(raw_);
    scale_->setValue(layout.scale);

    auto* form = new QFormLayout;
    form->addRow(labels_[rate], rate_);
    form->addRow(labels_[channel_c], channel_c_);
    form->addRow(labels_[channel_d], channel_d_);
    form->addRow(labels_[variables], variables_);
    auto* raw_form = new QFormLayout(raw_);
    raw_form->addRow(labels_[raw_type], type_);
    raw_form->addRow(labels_[raw_order], order_);
    raw_form->addRow(labels_[raw_channels], channels_);
    raw_form->addRow(labels_[raw_skip], skip_);
    raw_form->addRow(labels_[raw_scale], scale_);
    buttons_ = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    auto* column = new QVBoxLayout(this);
    column->addWidget(title_);
    column->addLayout(form);
    column->addWidget(raw_);
    column->addWidget(buttons_);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
        emit chosen(path_, this->options());
        accept();
    });
    const auto check = [this] {
        buttons_->button(QDialogButtonBox::Open)
            ->setEnabled(rate_->isValid() && skip_->isValid() && scale_->isValid() &&
                         channel_c_->value() != channel_d_->value());
    };
    for (const NumberField* field : {rate_, skip_, scale_}) {
        connect(field, &QLineEdit::textChanged, this, check);
    }
    for (const QSpinBox* box : {channel_c_, channel_d_}) {
        connect(box, &QSpinBox::valueChanged, this, check);
    }
    retranslate();
}

OpenOptions OpenOptionsDialog::options() const {
    // The text counts, whether or not the field has lost the focus.
    OpenOptions options{.rate_hz = readNumber(rate_->text()),
                        .channel_c = channel_c_->value(),
                        .channel_d = channel_d_->value(),
                        .raw = std::nullopt,
                        .variables = {}};
    if (!variables_->text().trimmed().isEmpty()) {
        for (const QString& name : variables_->text().split(QLatin1Char(','))) {
            options.variables.push_back(name.trimmed().toStdString());
        }
    }
    if (raw_->isChecked()) {
        options.raw = RawLayout{
            .type = static_cast<RawType>(type_->currentIndex()),
            .big_endian = order_->currentIndex() == 1,
            .channels = channels_->value(),
            .skip_bytes = static_cast<std::int64_t>(readNumber(skip_->text()).value_or(0)),
            .scale = readNumber(scale_->text()).value_or(1)};
    }
    return options;
}

void OpenOptionsDialog::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void OpenOptionsDialog::retranslate() {
    setWindowTitle(tr("Open with options"));
    title_->setText(tr("How to read %1").arg(QFileInfo(path_).fileName()));
    const QString texts[row_count] = {tr("Sample rate"), tr("Channel C"),   tr("Channel D"),
                                      tr("Variables"),   tr("Sample type"), tr("Byte order"),
                                      tr("Channels"),    tr("Skip"),        tr("Scale")};
    QWidget* fields[row_count] = {rate_,  channel_c_, channel_d_, variables_, type_,
                                  order_, channels_,  skip_,      scale_};
    for (int row = 0; row < row_count; ++row) {
        labels_[row]->setText(texts[row]);
        fields[row]->setAccessibleName(texts[row]);
    }
    rate_->setUnit(tr("Hz"));
    rate_->setPlaceholderText(tr("from the file"));
    rate_->setToolTip(tr("Used where the file has no rate of its own"));
    channel_c_->setToolTip(tr("Counted from 1; a time column does not count"));
    channel_d_->setToolTip(tr("Counted from 1; a time column does not count"));
    variables_->setPlaceholderText(tr("the first that fit"));
    variables_->setToolTip(
        tr("Names of the variables that hold C and D and, third, the rate, in a file of several "
           "(NPZ, MAT, HDF5), with commas between them"));
    skip_->setUnit(tr("bytes"));
    scale_->setToolTip(tr("Recording units per count"));
    raw_->setTitle(tr("Raw samples without a header"));
    const QString types[] = {tr("16 bit integer"), tr("32 bit integer"), tr("32 bit float"),
                             tr("64 bit float")};
    for (int i = 0; i < 4; ++i) {
        type_->setItemText(i, types[i]);
    }
    order_->setItemText(0, tr("little endian"));
    order_->setItemText(1, tr("big endian"));
}

}  // namespace vybeg::ui
