#include "ui/window/export_dialogs.h"

#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"
#include "ui/words/rich_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include <cmath>

namespace vybeg::ui {

namespace {

const QString dpi_key = QStringLiteral("export/dpi");
const QString titled_key = QStringLiteral("export/titled");
const QString settings_key = QStringLiteral("export/settings");

constexpr double least_width_mm = 80;
// Of the height that the plots propose: below it their ticks have no room.
constexpr double least_of_proposed = 1.0 / 3;
constexpr double least_height_mm = 20;
constexpr double most_mm = 1200;
constexpr double least_dpi = 36;
constexpr double most_dpi = 1200;
constexpr double default_dpi = 300;

double toMm(int pixels) {
    return std::round(pixels * mm_per_inch / pixels_per_inch);
}

int toPixels(double mm) {
    return static_cast<int>(std::lround(mm / mm_per_inch * pixels_per_inch));
}

}  // namespace

ExportDialog::ExportDialog(FigureSource source, QWidget* parent)
    : QDialog(parent),
      source_(std::move(source)),
      preview_(new QLabel(this)),
      width_mm_(new NumberField(this)),
      height_mm_(new NumberField(this)),
      dpi_(new NumberField(this)),
      title_(withName(new QLineEdit(this), "title")),
      settings_(new QCheckBox(tr("Settings of the analyses below the plots"), this)),
      copy_(new QPushButton(tr("&Copy"), this)),
      save_(withName(new QPushButton(tr("&Save…"), this), "save")) {
    setWindowTitle(tr("Export plots"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(900, 620);
    auto* form = new QFormLayout;
    if (source_.plots.size() > 1) {
        auto* list = new QVBoxLayout;
        for (const QString& name : source_.plots) {
            auto* box = new QCheckBox(name, this);
            box->setChecked(true);
            box->setToolTip(tr("Whether the figure holds this plot"));
            connect(box, &QCheckBox::toggled, this, [this] {
                propose();
                refresh();
            });
            plots_.push_back(box);
            list->addWidget(box);
        }
        form->addRow(tr("Plots"), list);
    }
    const auto number = [&](NumberField* field, const QString& name, const QString& tip,
                            const QString& unit, double least, double most) {
        field->setLimits(least, most);
        field->setUnit(unit);
        addRow(*form, name, field, tip);
        connect(field, &NumberField::valueEdited, this, &ExportDialog::refresh);
        connect(field, &NumberField::faultChanged, this, &ExportDialog::refresh);
    };
    number(width_mm_, tr("Width"), tr("Of the figure on paper"), tr("mm"), least_width_mm, most_mm);
    number(height_mm_, tr("Height"), tr("Of the figure on paper"), tr("mm"), least_height_mm,
           most_mm);
    number(dpi_, tr("Resolution"),
           tr("Pixels per inch of a PNG image; SVG and PDF are vectors and need none"), tr("dpi"),
           least_dpi, most_dpi);
    const QSettings kept;
    dpi_->setValue(kept.value(dpi_key, default_dpi).toDouble());
    if (kept.value(titled_key, true).toBool()) {
        title_->setText(source_.title);
    }
    title_->setPlaceholderText(tr("No title"));
    title_->setClearButtonEnabled(true);
    addRow(*form, tr("Title"), title_, tr("Above the plots; empty: none"));
    settings_->setChecked(kept.value(settings_key, true).toBool() && !source_.settings.isEmpty());
    settings_->setEnabled(!source_.settings.isEmpty());
    settings_->setToolTip(plainTip(source_.settings));
    form->addRow(settings_);
    connect(title_, &QLineEdit::textChanged, this, &ExportDialog::refresh);
    connect(settings_, &QCheckBox::toggled, this, &ExportDialog::refresh);

    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(save_, QDialogButtonBox::AcceptRole);
    buttons->addButton(copy_, QDialogButtonBox::ActionRole);
    buttons->addButton(QDialogButtonBox::Cancel);
    save_->setDefault(true);
    save_->setToolTip(tr("As PNG, SVG or PDF, by the ending of the name"));
    copy_->setToolTip(tr("To the clipboard, as an image and as vectors"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        QSettings keep;
        keep.setValue(dpi_key, *dpi_->value());
        keep.setValue(titled_key, !title_->text().isEmpty());
        if (settings_->isEnabled()) {
            keep.setValue(settings_key, settings_->isChecked());
        }
        emit saveWanted();
    });
    connect(copy_, &QPushButton::clicked, this,
            [this] { copyDrawing(figure().draw, {paper().size}); });

    preview_->setAccessibleName(tr("The figure as it will be"));
    preview_->setAlignment(Qt::AlignCenter);
    preview_->setMinimumSize(420, 300);
    auto* left = new QWidget(this);
    left->setLayout(form);
    left->setMaximumWidth(340);
    auto* sides = fill(new QHBoxLayout, {left, {preview_, 1}});
    fill(new QVBoxLayout(this), {{sides, 1}, buttons});
    whenChanged(*this, {QEvent::Resize}, [this] { refresh(); });
    propose();
    refresh();
}

std::vector<int> ExportDialog::chosen() const {
    std::vector<int> places;
    for (int k = 0; k < source_.plots.size(); ++k) {
        if (plots_.empty() || plots_[static_cast<std::size_t>(k)]->isChecked()) {
            places.push_back(k);
        }
    }
    return places;
}

QString ExportDialog::shownSettings() const {
    return settings_->isChecked() ? source_.settings : QString();
}

void ExportDialog::propose() {
    if (!chosen().empty()) {
        const QSize size = source_.figure(chosen()).size;
        width_mm_->setValue(toMm(size.width()));
        height_mm_->setValue(
            toMm(size.height() + captionHeight(title_->text(), shownSettings(), size.width())));
    }
}

Figure ExportDialog::figure() const {
    Figure figure = source_.figure(chosen());
    figure.draw = withCaption(figure.draw, title_->text().trimmed(), shownSettings());
    figure.size = paper().size;
    return figure;
}

Paper ExportDialog::paper() const {
    return {{toPixels(*width_mm_->value()), toPixels(*height_mm_->value())}, *dpi_->value()};
}

double ExportDialog::leastHeightMm() const {
    if (chosen().empty()) {
        return 0;
    }
    const int plots = source_.figure(chosen()).size.height();
    const int caption = captionHeight(title_->text(), shownSettings(),
                                      toPixels(width_mm_->value().value_or(least_width_mm)));
    return std::ceil(toMm(plots) * least_of_proposed + toMm(caption));
}

QString ExportDialog::fault() const {
    if (chosen().empty()) {
        return tr("Choose at least one plot.");
    }
    for (const NumberField* field : {width_mm_, height_mm_, dpi_}) {
        if (!field->fault().isEmpty() || !field->isValid()) {
            return QStringLiteral("%1: %2").arg(field->accessibleName(), field->fault());
        }
    }
    return {};
}

void ExportDialog::refresh() {
    const double least = leastHeightMm();
    height_mm_->setConflict(
        height_mm_->value().value_or(least) < least
            ? tr("At least %1 mm is needed for these plots.").arg(shortNumberText(least, 4))
            : QString());
    const QString wrong = fault();
    save_->setEnabled(wrong.isEmpty());
    copy_->setEnabled(wrong.isEmpty());
    if (!wrong.isEmpty()) {
        preview_->setText(wrong);
        return;
    }
    const QSize size = paper().size;
    const double scale = devicePixelRatioF() * std::min(double(preview_->width()) / size.width(),
                                                        double(preview_->height()) / size.height());
    QImage image = toImage(figure().draw, {size, scale * pixels_per_inch});
    image.setDevicePixelRatio(devicePixelRatioF());
    preview_->setPixmap(QPixmap::fromImage(image));
}

namespace {

const QString all_plots_key = QStringLiteral("report/all_plots");
const QString summary_key = QStringLiteral("report/summary");
const QString instrument_key = QStringLiteral("report/instrument");

}  // namespace

ReportDialog::ReportDialog(Document& document, bool of_set, QWidget* parent)
    : QDialog(parent),
      document_(document),
      subjects_(reportSubjects(document)),
      subject_(new QComboBox(this)),
      summary_(new QCheckBox(tr("One page to be signed: result, limits, warnings"), this)),
      all_plots_(new QCheckBox(tr("All plots, also phase, noise and orthogonality"), this)) {
    setWindowTitle(tr("Report"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(460);
    auto* form = new QFormLayout(this);
    for (const ReportSubject& each : subjects_) {
        subject_->addItem(each.name);
        if (of_set && document.sets().current() && each.set == document.sets().current()->id) {
            subject_->setCurrentIndex(subject_->count() - 1);
        }
    }
    addRow(*form, tr("Report of"), subject_,
           tr("A recording, a set of them with its resonator, or all sets"));
    const QString by_hand = tr("Empty: a line to fill in by hand");
    for (std::size_t k = 0; k < title_fields.size(); ++k) {
        fields_[k] = new QLineEdit(this);
        fields_[k]->setObjectName(QLatin1String(title_fields[k].option));
        addRow(*form, ReportWords::tr(title_fields[k].name), fields_[k], by_hand);
    }
    all_plots_->setToolTip(tr("Off: the five slow variables"));
    form->addRow(summary_);
    form->addRow(all_plots_);
    connect(summary_, &QCheckBox::toggled, all_plots_, &QWidget::setDisabled);
    summary_->setChecked(QSettings().value(summary_key, false).toBool());
    all_plots_->setChecked(QSettings().value(all_plots_key, false).toBool());
    connect(subject_, &QComboBox::currentIndexChanged, this, &ReportDialog::propose);
    propose();
    auto* buttons = new QDialogButtonBox(this);
    auto* save = withName(new QPushButton(tr("&Save…"), this), "save");
    save->setToolTip(tr("As a PDF document"));
    save->setDefault(true);
    buttons->addButton(save, QDialogButtonBox::AcceptRole);
    buttons->addButton(QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        keep();
        emit saveWanted();
    });
    form->addRow(buttons);
}

const ReportSubject& ReportDialog::subject() const {
    return subjects_[static_cast<std::size_t>(subject_->currentIndex())];
}

// The subject's data of a measurement list, otherwise those of the dossier.
void ReportDialog::propose() {
    proposed_ = titleOf(document_.dossier().dossier().gyro);
    // Each of several sets has its own date, and the data of its list.
    if (!subject().all_sets) {
        proposed_ = reportContentOf(document_, subject(), proposed_).title;
    }
    proposed_.instrument = QSettings().value(instrument_key).toString();
    for (std::size_t k = 0; k < title_fields.size(); ++k) {
        const TitleField& field = title_fields[k];
        fields_[k]->setText(proposed_.*field.text);
        fields_[k]->setEnabled(field.text != &ReportTitle::date || !subject().all_sets);
    }
}

ReportTitle ReportDialog::typed() const {
    ReportTitle title;
    for (std::size_t k = 0; k < title_fields.size(); ++k) {
        title.*title_fields[k].text = fields_[k]->text().trimmed();
    }
    return title;
}

std::vector<ReportContent> ReportDialog::contents() const {
    const ReportTitle title = typed();
    std::vector<ReportContent> contents = reportContentsOf(document_, subject(), title);
    for (ReportContent& content : contents) {
        content.title = subject().all_sets ? content.title : title;
        content.summary = summary_->isChecked();
        if (all_plots_->isChecked()) {
            content.variables.assign(shown_slow_variables.begin(), shown_slow_variables.end());
        }
    }
    return contents;
}

// The dossier takes what was typed over the proposal.
void ReportDialog::keep() {
    GyroData gyro = document_.dossier().dossier().gyro;
    const ReportTitle title = typed();
    const auto take = [](QString& kept, const QString& now, const QString& proposed) {
        kept = now == proposed ? kept : now;
    };
    take(gyro.serial, title.gyro, proposed_.gyro);
    take(gyro.operator_name, title.engineer, proposed_.engineer);
    take(gyro.comment, title.comment, proposed_.comment);
    document_.dossier().setGyro(gyro);
    QSettings().setValue(all_plots_key, all_plots_->isChecked());
    QSettings().setValue(summary_key, summary_->isChecked());
    QSettings().setValue(instrument_key, title.instrument);
}

}  // namespace vybeg::ui

#include "moc_export_dialogs.cpp"
