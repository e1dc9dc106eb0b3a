#include "ui/import/import_dialog.h"

#include "core/recording/samples/open_table.h"
#include "core/recording/samples/reader_rules.h"
#include "ui/values/json_fields.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStringList>
#include <QTableWidget>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr std::size_t frames_shown = 256;  // initially; the wheel shows more
constexpr int widest_column = 240;         // pixels

constexpr qsizetype most_kinds = 50;
const QString imports_key = QStringLiteral("imports");
const QString kind_key = QStringLiteral("kind");
const QString options_key = QStringLiteral("options");

QJsonArray imports() {
    return QJsonDocument::fromJson(QSettings().value(imports_key).toByteArray()).array();
}

constexpr int preview_key = 0;

// Numbers with a true minus, as beside all axes.
class MinusTicker : public QCPAxisTicker {
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
        return QCPAxisTicker::getTickLabel(tick, locale, format, precision)
            .replace('-', QChar(0x2212));
    }
};

}  // namespace

ImportPreview::ImportPreview(QWidget* parent)
    : QWidget(parent),
      what_(withName(new QLabel(this), "what")),
      table_(new QTableWidget(this)),
      plot_(new QCustomPlot(this)) {
    what_->setWordWrap(true);
    what_->setTextFormat(Qt::PlainText);
    what_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    table_->setAccessibleName(tr("First rows"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setTabKeyNavigation(false);
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->setWordWrap(false);
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_->horizontalHeader()->setHighlightSections(false);
    plot_->setAccessibleName(tr("First samples"));
    plot_->setLocale(QLocale());
    plot_->setMinimumHeight(140);
    plot_->setInteraction(QCP::iRangeDrag);
    plot_->setInteraction(QCP::iRangeZoom);
    plot_->axisRect()->setRangeDrag(Qt::Horizontal);
    plot_->axisRect()->setRangeZoom(Qt::Horizontal);
    plot_->addGraph()->setName(QStringLiteral("C"));
    plot_->addGraph()->setName(QStringLiteral("D"));
    plot_->legend->setVisible(true);
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
    plot_->legend->setBorderPen(Qt::NoPen);
    // Above the samples, which it would cover.
    plot_->plotLayout()->insertRow(0);
    plot_->plotLayout()->addElement(0, 0, plot_->legend);
    plot_->plotLayout()->setRowStretchFactor(0, 0.001);
    plot_->yAxis->setTicker(QSharedPointer<MinusTicker>::create());
    plot_->xAxis->ticker()->setTickCount(7);
    plot_->yAxis->ticker()->setTickCount(4);
    auto* parts = new QSplitter(Qt::Vertical, this);
    parts->setChildrenCollapsible(false);
    parts->addWidget(table_);
    parts->addWidget(plot_);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 2);
    fill(new QVBoxLayout(this), {}, {what_, {parts, 1}});
    applyLook();
    setPreview({});
    whenChanged(*this, {QEvent::PaletteChange}, [this] {
        if (isDark(palette()) != theme_.dark) {
            applyLook();
            setPreview(RecordingPreview(preview_));
        }
    });
}

void ImportPreview::setPreview(const RecordingPreview& preview) {
    preview_ = preview;
    QPalette palette = what_->parentWidget()->palette();
    if (preview_.problem) {
        palette.setColor(QPalette::WindowText, theme_.warning);
    }
    what_->setPalette(palette);
    what_->setText(preview_.problem ? errorText(*preview_.problem) : formatText(preview_.format));
    fillTable();
    drawSamples();
}

void ImportPreview::setError(const Error& error) {
    RecordingPreview none;
    none.problem = error;
    setPreview(none);
}

void ImportPreview::fillTable() {
    table_->clearSpans();
    table_->clear();
    std::size_t columns = std::max<std::size_t>(preview_.columns.size(), 1);
    for (const PreviewLine& line : preview_.lines) {
        columns = std::max(columns, line.cells.size());
    }
    table_->setColumnCount(static_cast<int>(columns));
    table_->setRowCount(static_cast<int>(preview_.lines.size()));
    QStringList numbers;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const PreviewLine& line = preview_.lines[static_cast<std::size_t>(row)];
        numbers << QLocale().toString(static_cast<qint64>(line.number));
        for (int column = 0; column < static_cast<int>(line.cells.size()); ++column) {
            auto* item = new QTableWidgetItem(
                QString::fromStdString(line.cells[static_cast<std::size_t>(column)]));
            item->setToolTip(plainTip(item->text()));
            if (!line.is_row) {
                item->setForeground(theme_.mutedText);
            } else {
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
                const bool c = column == preview_.c_column;
                if (c || column == preview_.d_column) {
                    item->setBackground(translucent(c ? theme_.signalC : theme_.signalD, 0.18));
                } else {
                    item->setForeground(column == preview_.time_column ? theme_.accent
                                                                       : theme_.mutedText);
                }
            }
            table_->setItem(row, column, item);
        }
        if (!line.is_row && columns > 1) {
            table_->setSpan(row, 0, 1, static_cast<int>(columns));
        }
    }
    QStringList titles;
    for (int column = 0; column < static_cast<int>(columns); ++column) {
        const auto i = static_cast<std::size_t>(column);
        const bool known = i < preview_.columns.size();
        QString title = known ? QString::fromStdString(preview_.columns[i].name) : QString();
        title = title.isEmpty() ? QString::number(column + 1) : title;
        if (known && !preview_.columns[i].unit.empty()) {
            title += QStringLiteral(" [%1]").arg(QString::fromStdString(preview_.columns[i].unit));
        }
        const QString role = column == preview_.c_column      ? QStringLiteral("C")
                             : column == preview_.d_column    ? QStringLiteral("D")
                             : column == preview_.time_column ? QStringLiteral("t")
                                                              : QString();
        titles << (role.isEmpty() || role == title ? title : role + QStringLiteral(" = ") + title);
    }
    table_->setHorizontalHeaderLabels(titles);
    table_->setVerticalHeaderLabels(numbers);
    table_->resizeColumnsToContents();
    for (int column = 0; columns > 1 && column < table_->columnCount(); ++column) {
        table_->setColumnWidth(column, std::min(table_->columnWidth(column), widest_column));
    }
}

// Of text the channels, not the columns, know that a scale leaves no unit of the file.
QString ImportPreview::unitOfSamples() const {
    const std::vector<Channel>& from = preview_.used ? preview_.channels : preview_.columns;
    const auto unit = [&](int column) {
        const bool behind_time =
            preview_.used && preview_.time_column >= 0 && preview_.time_column < column;
        const auto k = static_cast<std::size_t>(column - (behind_time ? 1 : 0));
        return column >= 0 && k < from.size() ? from[k].unit : std::string();
    };
    const bool alone = preview_.d_column < 0;  // channel D has a file of its own
    const std::string of_c = unit(preview_.c_column);
    return alone || of_c == unit(preview_.d_column) ? QString::fromStdString(of_c) : QString();
}

void ImportPreview::drawSamples() {
    plot_->setVisible(!preview_.c.empty());
    const auto frames = preview_.c.size();
    QVector<double> x(static_cast<int>(frames));
    const bool timed = preview_.time_s.size() >= frames && frames > 0;
    for (std::size_t i = 0; i < frames; ++i) {
        constexpr double ms = 1e3;
        x[static_cast<int>(i)] = timed ? ms * preview_.time_s[i]
                                 : preview_.rate_hz
                                     ? ms * static_cast<double>(i) / *preview_.rate_hz
                                     : static_cast<double>(i);
    }
    plot_->graph(0)->setData(x, {preview_.c.begin(), preview_.c.end()}, true);
    plot_->graph(1)->setData(x, {preview_.d.begin(), preview_.d.end()}, true);
    plot_->yAxis->setLabel(unitOfSamples());
    plot_->xAxis->setLabel(timed || preview_.rate_hz ? tr("ms") : tr("samples"));
    if (frames > 0) {
        plot_->yAxis->rescale();
        plot_->yAxis->scaleRange(1.1);
        plot_->xAxis->setRange(x.first(), x[static_cast<int>(std::min(frames, frames_shown)) - 1]);
    }
    plot_->replot();
}

void ImportPreview::applyLook() {
    theme_ = themeOf(palette());
    plot_->setBackground(theme_.plotBackground);
    plot_->legend->setBrush(translucent(theme_.plotBackground, 0.85));
    plot_->legend->setTextColor(theme_.text);
    plot_->legend->setFont(font());
    for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setBasePen(theme_.axis);
        axis->setTickPen(theme_.axis);
        axis->setSubTickPen(theme_.axis);
        axis->setTickLabelColor(theme_.text);
        axis->setLabelColor(theme_.text);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->grid()->setPen(theme_.grid);
        axis->grid()->setZeroLinePen(theme_.zeroLine);
    }
    plot_->graph(0)->setPen(theme_.signalC);
    plot_->graph(1)->setPen(QPen(theme_.signalD, 1));
}

QString importKind(const QString& path, const RecordingPreview& preview, bool raw) {
    const QString ending = QFileInfo(path).suffix().toLower();
    if (raw) {
        return QStringLiteral("raw;%1").arg(ending);
    }
    if (!preview.guessed) {
        return QStringLiteral("file;%1").arg(ending);
    }
    QStringList words{QStringLiteral("text"), ending, QString::number(preview.guessed->columns)};
    for (const Channel& heading : preview.guessed->headings) {
        words << QString::fromStdString(heading.name);
    }
    return words.join(QLatin1Char(';'));
}

std::optional<OpenOptions> rememberedImport(const QString& kind) {
    for (const auto& each : imports()) {
        if (each[kind_key].toString() == kind) {
            return optionsFromJson(each[options_key].toObject());
        }
    }
    return {};
}

void rememberImport(const QString& kind, const OpenOptions& options) {
    QJsonArray kept{QJsonObject{{kind_key, kind}, {options_key, optionsToJson(options)}}};
    for (const auto& each : imports()) {
        if (each[kind_key].toString() != kind && kept.size() < most_kinds) {
            kept.append(each);
        }
    }
    QSettings().setValue(imports_key, QJsonDocument(kept).toJson(QJsonDocument::Compact));
}

ImportDialog::ImportDialog(BackgroundJobs& job, const QString& path, const OpenOptions& options,
                           QWidget* parent)
    : QDialog(parent),
      job_(&job),
      path_(path),
      proposed_(options != OpenOptions{}),
      raw_proposed_(options.raw.has_value()),
      fields_(new ImportFields),
      view_(new ImportPreview(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Import"));
    auto* title = new QLabel(tr("How to read %1").arg(QFileInfo(path_).fileName()), this);
    title->setTextFormat(Qt::PlainText);
    title->setWordWrap(true);
    fields_->setOptions(options);
    auto* choices = scrolled(fields_, this);
    choices->setFocusPolicy(Qt::NoFocus);
    auto* columns = fill(new QHBoxLayout, {choices, {view_, 1}});
    fill(new QVBoxLayout(this), {title, {columns, 1}, buttons_});
    connect(buttons_, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
    connect(fields_, &ImportFields::filesWanted, this, &ImportDialog::filesWanted);
    connect(fields_, &ImportFields::edited, this, [this] {
        proposed_ = true;  // from here on, user edits win over guesses
        // Ignores repeated signals: a field that loses the focus, as on a click on Open, emits its
        // last edit again.
        if (this->options() != asked_) {
            refresh();
        } else {
            enableOpen();
        }
    });
    choices->setMinimumWidth(fields_->sizeHint().width() + 20);
    resize(980, 620);
    refresh();
}

ImportDialog::~ImportDialog() {
    fields_->disconnect(this);  // avoids signals of fields to a destroyed object
    if (job_) {
        job_->forget(preview_key);
    }
}

OpenOptions ImportDialog::options() const {
    OpenOptions options = fields_->options();
    find_files_from(QFileInfo(path_).absolutePath().toStdU16String(), options);
    return options;
}

void ImportDialog::refresh() {
    preview_.reset();
    enableOpen();
    asked_ = options();
    job_->run<RecordingPreview>(
        preview_key,
        [path = std::filesystem::path(path_.toStdU16String()),
         options = asked_](const JobControl& job) { return preview_recording(path, options, job); },
        [this](const Result<RecordingPreview>& result) { take(result); });
}

std::optional<OpenOptions> ImportDialog::proposal(const RecordingPreview& preview) {
    const bool unknown = !preview.file_format;
    if (!proposed_) {
        proposed_ = true;
        raw_proposed_ = unknown;
        const auto partner = partner_of(path_.toStdU16String());
        if (partner && preview.problem && preview.problem->code == ErrorCode::too_few_channels) {
            OpenOptions pair = options();
            pair.channel_d_file = partner->string();
            return pair;
        }
        if (const auto last = rememberedImport(importKind(path_, preview, unknown))) {
            return last;
        }
        if (unknown) {
            OpenOptions raw = options();
            raw.raw = RawLayout{};
            return raw;
        }
    }
    if (options().raw && !raw_proposed_) {
        raw_proposed_ = true;
        return rememberedImport(importKind(path_, preview, true));
    }
    return {};
}

void ImportDialog::take(const Result<RecordingPreview>& result) {
    if (!result) {
        view_->setError(result.error());
        return;
    }
    const auto better = proposal(*result);
    if (better && *better != options()) {
        fields_->setOptions(*better);
        refresh();
        return;
    }
    preview_ = *result;
    fields_->setPreview(*preview_);
    view_->setPreview(*preview_);
    enableOpen();
    const bool lacks_rate = preview_->problem && preview_->problem->code == ErrorCode::rate_unknown;
    if (!std::exchange(shown_, true) && lacks_rate) {
        fields_->focusRate();  // the only missing value can be typed at once
    }
}

void ImportDialog::enableOpen() {
    buttons_->button(QDialogButtonBox::Open)
        ->setEnabled(preview_ && !preview_->problem && fields_->isValid());
}

void ImportDialog::accept() {
    if (!buttons_->button(QDialogButtonBox::Open)->isEnabled()) {
        return;
    }
    const OpenOptions chosen_options = options();
    OpenOptions of_kind = chosen_options;  // other files have others beside them
    of_kind.channel_d_file.clear();
    of_kind.join.clear();
    rememberImport(importKind(path_, *preview_, chosen_options.raw.has_value()), of_kind);
    emit chosen(path_, chosen_options);
    QDialog::accept();
}

}  // namespace vybeg::ui

#include "moc_import_dialog.cpp"
