#include "ui/panels/ledger_rows.h"

#include "ui/panels/findings_flag.h"
#include "ui/plots/axis_ticks.h"
#include "ui/widgets/page_parts.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/settings_text.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

struct RowWords {
    Q_DECLARE_TR_FUNCTIONS(LedgerRows)
};

QString channelText(const Recording& recording, int number) {
    const Channel& channel = recording.channels.at(static_cast<std::size_t>(number - 1));
    const QString name = QString::fromStdString(channel.name);
    // The name is omitted if the file names its channels by number.
    QString text = RowWords::tr("%1 of %2").arg(number).arg(recording.channels.size());
    if (name != QString::number(number)) {
        text = QStringLiteral("%1 (%2)").arg(name, text);
    }
    return withUnit(text, QString::fromStdString(channel.unit));
}

QString rateText(const Recording& recording) {
    const QString hertz = shortNumberText(recording.rate_hz, 10);
    switch (recording.rate_from) {
        case RateOrigin::file: return RowWords::tr("%1 Hz, from the file").arg(hertz);
        case RateOrigin::time_column: return RowWords::tr("%1 Hz, from the time column").arg(hertz);
        case RateOrigin::option: break;
    }
    return RowWords::tr("%1 Hz, typed").arg(hertz);
}

constexpr int analysis_role = Qt::UserRole;
constexpr int recording_role = Qt::UserRole + 1;
constexpr int short_name_role = Qt::UserRole + 2;
constexpr int sets_role = Qt::UserRole + 3;

// The name of an analysis as its row shows it: without the ending that other columns show, where it
// is alone, and only by its ending below its recording. Null: as it is.
QVariant shortName(const LedgerRow& row) {
    const QString own = QFileInfo(row.recording->path).completeBaseName();
    const QString& name = row.analysis->shown.name;
    if (!name.startsWith(own + QStringLiteral(", "))) {
        return {};
    }
    return !row.first  ? QStringLiteral("   ") + name.mid(own.size() + 2)
           : row.alone ? QVariant(own)
                       : QVariant();
}

QStringList analysisFacts(const AnalysisEntry& entry, bool live) {
    const Analysis& analysis = *entry.shown.analysis;
    const std::size_t count = entry.summary.windows;
    QStringList facts{entry.shown.name, algorithmText(analysis.settings.algorithm)};
    facts << (entry.partial() ? RowWords::tr("%1 of %2 windows")
                                    .arg(countLabel(static_cast<std::int64_t>(count)),
                                         countLabel(analysis.plan.count))
                              : RowWords::tr("%n window(s), %1 flagged, in %2", nullptr,
                                             static_cast<int>(count))
                                    .arg(entry.summary.flagged)
                                    .arg(secondsText(analysis.timing.estimate_s)));
    if (live) {
        facts << RowWords::tr(
            "Follows the settings while Live is on; Keep keeps an analysis as it is");
    }
    return facts << QString();
}

// A sample of an analysis's line: its colour and shade.
QIcon curveIcon(const ShownAnalysis& shown) {
    constexpr int width = 28;
    constexpr int height = 14;
    constexpr int scale = 2;
    QPixmap pixmap(width * scale, height * scale);
    pixmap.setDevicePixelRatio(scale);
    // An opaque background, so that the line is visible on a selected row.
    pixmap.fill(QGuiApplication::palette().color(QPalette::Base));
    QPainter painter(&pixmap);
    const Theme theme = themeOf(QGuiApplication::palette());
    painter.setPen(
        QPen(readable(shown.color, theme, shown.shade), 2.5, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(2, height / 2.0), QPointF(width - 2, height / 2.0));
    painter.end();
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

// The power of ten of a column, so that its numbers have no more than seven digits before or three
// zeros after the decimal sign.
int exponentOf(const std::vector<Reading>& readings) {
    double largest = 0;
    for (const Reading& reading : readings) {
        for (const double number : {std::abs(reading.value), reading.sd}) {
            largest = std::isfinite(number) ? std::max(largest, number) : largest;
        }
    }
    const bool ordinary = largest == 0 || (largest >= 1e-3 && largest < 1e7);
    return ordinary
               ? 0
               : std::clamp(3 * static_cast<int>(std::floor(std::log10(largest) / 3)), -15, 12);
}

Reading read(const LedgerReader& reader, const AnalysisEntry* entry, SlowVariable variable) {
    if (!entry || !entry->shown.visible) {
        return {};
    }
    const Analysis& analysis = *entry->shown.analysis;
    Measuring here = reader.measuring;
    if (!here.mouse_s && analysis.track.rows() > 0) {
        here.mouse_s = analysis.track.time_s().front();
    }
    return readingOf(analysis, variable, reader.at, here, reader.trends.of(entry->shown.id),
                     reader.units);
}

// Symbol and unit, with the prefix or power of ten of the column.
QString headOf(const LedgerReader& reader, SlowVariable variable, const QString& of_file,
               int exponent) {
    const bool beat = reader.at == ReadAt::rate && reader.measuring.kind == TrendKind::beat;
    QString unit = displayUnit(variable, reader.units, of_file);
    if (beat) {
        unit = RowWords::tr("Hz");
    } else if (reader.at == ReadAt::rate) {
        unit = unit.isEmpty() ? RowWords::tr("1/s") : RowWords::tr("%1/s").arg(unit);
    }
    const QString scaled =
        scaledUnit(unit, beat || takesPrefix(variable, reader.units, of_file), exponent);
    return withUnit(displaySymbol(variable, reader.units), scaled);
}

}  // namespace

QString recordingFacts(const RecordingEntry& entry) {
    QStringList lines;
    const auto add = [&lines](const QString& name, const QString& value) {
        if (!value.isEmpty()) {
            lines << QStringLiteral("%1: %2").arg(name, value);
        }
    };
    add(RowWords::tr("File"), QDir::toNativeSeparators(entry.path));
    if (entry.recording) {
        const Recording& recording = *entry.recording;
        add(RowWords::tr("Format"), formatText(recording.format));
        add(RowWords::tr("Rate"), rateText(recording));
        add(RowWords::tr("Length"),
            RowWords::tr("%1 s, %n sample(s)", nullptr, static_cast<int>(recording.frames()))
                .arg(shortNumberText(recording.seconds(), 8)));
        add(QStringLiteral("C"), channelText(recording, recording.channel_c));
        add(QStringLiteral("D"), channelText(recording, recording.channel_d));
        add(RowWords::tr("Start"), QString::fromStdString(recording.start));
        if (entry.f0_hz) {
            add(RowWords::tr("f₀"), RowWords::tr("%1 Hz").arg(numberLabel(*entry.f0_hz, 4)));
        }
        add(QStringLiteral("SHA-256"), entry.sha256);
    }
    return lines.join(QLatin1Char('\n'));
}

std::vector<LedgerRow> ledgerRows(const Document& document) {
    std::vector<LedgerRow> rows;
    for (const RecordingEntry& recording : document.recordings()) {
        bool first = true;
        for (const AnalysisEntry& entry : document.analyses()) {
            if (entry.recording_id == recording.id) {
                if (!first) {
                    rows.back().alone = false;
                }
                rows.push_back({&recording, &entry, first, first});
                first = false;
            }
        }
        if (first) {
            rows.push_back({&recording, nullptr, true, true});
        }
    }
    return rows;
}

void nameRow(const LedgerRow& row, const QString& sets, bool live, QTreeWidgetItem& item) {
    constexpr int name = name_column;
    const RecordingEntry& recording = *row.recording;
    const AnalysisEntry* entry = row.analysis;
    item.setData(name, recording_role, number(recording.id));
    item.setData(name, analysis_role, number(entry ? entry->shown.id : AnalysisId::none));
    item.setData(name, short_name_role, entry ? shortName(row) : QVariant());
    item.setData(name, sets_role, row.first ? sets : QString());
    QFont font = item.treeWidget()->font();
    font.setBold(row.first);
    font.setItalic(entry && entry->live && live);
    item.setFont(name, font);
    QStringList tip;
    if (entry) {
        item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable |
                      Qt::ItemIsEditable);
        item.setCheckState(name, entry->shown.visible ? Qt::Checked : Qt::Unchecked);
        item.setIcon(name, curveIcon(entry->shown));
        item.setText(name, entry->shown.name);
        tip = analysisFacts(*entry, entry->live && live);
    } else {
        item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        item.setData(name, Qt::CheckStateRole, QVariant());
        item.setIcon(name, {});
        item.setText(name, recording.recording ? recording.name
                                               : RowWords::tr("%1 (opening)").arg(recording.name));
    }
    if (!sets.isEmpty()) {
        tip << RowWords::tr("Set: %1").arg(sets);
    }
    tip << recordingFacts(recording);
    item.setToolTip(name, plainTip(tip.join(QLatin1Char('\n'))));
}

QString rowNotes(const LedgerRow& row) {
    QStringList sentences;
    if (row.analysis) {
        const TrackSummary& summary = row.analysis->summary;
        if (summary.leakage_limits()) {
            sentences << RowWords::tr("Leakage of the window limits the mean frequency, by %1 Hz.")
                             .arg(shortNumberText(summary.leakage_f_hz, 2));
        }
        if (summary.at_bound > 0) {
            sentences << RowWords::tr(
                "The frequency of %n window(s) lies at the bound of the search; the mean's "
                "deviation allows for them.",
                nullptr, static_cast<int>(summary.at_bound));
        }
        sentences << findingTexts(findings_of(row.analysis->shown.analysis->diagnostics));
    }
    if (row.first && hasFindings(*row.recording)) {
        const auto& found = row.recording->faults ? row.recording->faults->findings
                                                  : row.recording->recording->diagnostics;
        sentences << findingTexts(findings_of(found));
    }
    return worstOf(sentences).join(QLatin1Char('\n'));
}

RecordingId recordingOf(const QTreeWidgetItem& item) {
    return static_cast<RecordingId>(item.data(name_column, recording_role).toInt());
}

AnalysisId analysisIdOf(const QTreeWidgetItem& item) {
    return static_cast<AnalysisId>(item.data(name_column, analysis_role).toInt());
}

void LedgerNames::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    NameDelegate::initStyleOption(option, index);
    if (const QString text = index.data(short_name_role).toString(); !text.isEmpty()) {
        option->text = text;
    }
    if (const QString sets = index.data(sets_role).toString(); !sets.isEmpty()) {
        option->text += QStringLiteral(" · ") + sets;
    }
}

CellColumn variableColumn(const LedgerReader& reader, const std::vector<const AnalysisEntry*>& rows,
                          SlowVariable variable, bool concise) {
    std::vector<Reading> readings;
    readings.reserve(rows.size());
    QStringList file_units;
    for (const AnalysisEntry* entry : rows) {
        readings.push_back(read(reader, entry, variable));
        if (entry && entry->shown.visible) {
            file_units << entry->shown.unit;
        }
    }
    const int exponent = exponentOf(readings);
    const double scale = std::pow(10., -exponent);
    CellColumn column{headOf(reader, variable, commonUnit(file_units), exponent), {}};
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double value = scale * readings[row].value;
        const double sd = scale * readings[row].sd;
        column.cells << (!rows[row]       ? QString()
                         : std::isnan(sd) ? threeDigits(value)
                         : concise        ? conciseText(value, sd)
                                          : valueText(value, sd));
    }
    return column;
}

std::pair<QString, QString> trendCell(const LedgerReader& reader, const AnalysisEntry* entry) {
    if (!entry || !entry->shown.visible) {
        return {};
    }
    const Analysis& analysis = *entry->shown.analysis;
    const Measuring& measuring = reader.measuring;
    const auto& time_s = reader.at == ReadAt::a   ? measuring.a_s
                         : reader.at == ReadAt::b ? measuring.b_s
                                                  : measuring.mouse_s;
    const bool between = reader.at == ReadAt::difference || reader.at == ReadAt::rate;
    QString text = !between && time_s ? reasonAt(analysis, *time_s) : QString();
    if (text.isEmpty() && measuring.both()) {
        if (isInside(analysis, measuring.a_s) && isInside(analysis, measuring.b_s)) {
            const auto& trends = reader.trends.of(entry->shown.id);
            QStringList sentences =
                measuredSentences(reader.document, *entry, measuring, trends, reader.units);
            std::ranges::transform(sentences, sentences.begin(), richText);
            return {trendSummary(measuring.kind, trends, reader.units),
                    QStringLiteral("<p>%1</p>").arg(sentences.join(QStringLiteral("<br>")))};
        }
        text = RowWords::tr("no windows there");
    }
    return {text, plainTip(text)};
}

LedgerHead::LedgerHead(QWidget* parent)
    : QWidget(parent), kind_(withName(new QComboBox(this), "trend")) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(2, 0, 2, 0);
    line->setSpacing(1);
    auto* group = new QButtonGroup(this);
    constexpr std::array names{"readMouse", "readA", "readB", "readDifference", "readRate"};
    for (std::size_t at = 0; at < buttons_.size(); ++at) {
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1String(names[at]));
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        group->addButton(button, static_cast<int>(at));
        line->addWidget(button);
        buttons_[at] = button;
    }
    kind_->addItems(QStringList(trend_kinds));
    kind_->setFrame(false);
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // in another language, too
    line->addWidget(kind_);
    line->addStretch(1);
    connect(group, &QButtonGroup::idClicked, this,
            [this](int at) { emit readAtChosen(static_cast<ReadAt>(at)); });
    connect(kind_, &QComboBox::activated, this,
            [this](int kind) { emit kindChosen(static_cast<TrendKind>(kind)); });
    keepTranslated(*this, [this] { retranslate(); });
}

void LedgerHead::show(ReadAt at, const Measuring& measuring) {
    const std::array usable{true, measuring.a_s.has_value(), measuring.b_s.has_value(),
                            measuring.both(), measuring.both()};
    for (std::size_t k = 0; k < buttons_.size(); ++k) {
        buttons_[k]->setEnabled(usable[k]);
    }
    buttons_[static_cast<std::size_t>(at)]->setChecked(true);
    mouse_ = measuring.mouse_s.has_value();
    showFirst();
    kind_->setCurrentIndex(static_cast<int>(measuring.kind));
    kind_->setVisible(measuring.both());
}

// Without a mouse over the plots the first windows are read. The button has room for both words.
void LedgerHead::showFirst() {
    QToolButton& first = *buttons_.front();
    first.setText(mouse_ ? tr("mouse") : tr("start"));
    first.setToolTip(
        tr("Values of the windows at the mouse in the plots, with standard "
           "deviations; of the first ones while it is elsewhere"));
}

void LedgerHead::retranslate() {
    const std::array texts{tr("mouse"), tr("A"), tr("B"), tr("B − A"), tr("trend")};
    const std::array tips{
        QString(), tr("Values of the windows at cursor A"), tr("Values of the windows at cursor B"),
        tr("Differences of the windows at the cursors; without standard deviation where they "
           "share samples"),
        tr("Rates of the trends between the cursors, or frequencies of the beats")};
    for (std::size_t k = 0; k < buttons_.size(); ++k) {
        buttons_[k]->setText(texts[k]);
        buttons_[k]->setToolTip(tips[k]);
    }
    QToolButton& first = *buttons_.front();
    first.setMinimumWidth(0);
    int room = first.sizeHint().width();
    first.setText(tr("start"));
    first.setMinimumWidth(std::max(room, first.sizeHint().width()));
    showFirst();
    setTexts(*kind_, {tr("line"), tr("beat")});
    kind_->setAccessibleName(tr("Trend between the cursors"));
    kind_->setToolTip(
        tr("A line is an exponential for the working wave; a beat is a damped sinusoid, or the "
           "sum of two modes of a resonator where none fits. "
           "Fitted by weighted least squares to the windows between the cursors that share no "
           "samples. Where they scatter more than their noise, the deviations grow by that."));
}

}  // namespace vybeg::ui

#include "moc_ledger_rows.cpp"
