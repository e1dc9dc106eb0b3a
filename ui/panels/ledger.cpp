#include "ui/panels/ledger.h"

#include "ui/panels/ledger_head.h"
#include "ui/panels/recording_drag.h"
#include "ui/panels/recording_facts.h"
#include "ui/plots/axis_ticks.h"
#include "ui/widgets/theme.h"
#include "ui/words/algorithm_text.h"
#include "ui/words/error_text.h"
#include "ui/words/index_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/short_names.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLocale>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

constexpr int analysis_role = Qt::UserRole;
constexpr int recording_role = Qt::UserRole + 1;
constexpr int short_name_role = Qt::UserRole + 2;

// Fits of more windows than that are made of the chosen analysis alone.
constexpr std::size_t quick_rows = 100'000;

// A window as high as that has six rows, a lower one four.
constexpr int low_window = 850;

RecordingId recordingOf(const QTreeWidgetItem& item) {
    return static_cast<RecordingId>(item.data(Ledger::name, recording_role).toInt());
}

AnalysisId idOf(const QTreeWidgetItem& item) {
    return static_cast<AnalysisId>(item.data(Ledger::name, analysis_role).toInt());
}

// A name without what it shares with the recording above it, from which it is indented.
class LedgerNames : public NameDelegate {
public:
    using NameDelegate::NameDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        NameDelegate::initStyleOption(option, index);
        if (const QString text = index.data(short_name_role).toString(); !text.isEmpty()) {
            option->text = text;
        }
    }
};

// The name of an analysis as its recording's row shows it: without the ending that other columns
// tell, where it is alone, and only by its ending below the first one.
QString shortName(const AnalysisEntry& entry, const RecordingEntry& recording, bool first,
                  bool alone) {
    const QString own = QFileInfo(recording.path).completeBaseName();
    if (!entry.shown.name.startsWith(own + QStringLiteral(", "))) {
        return {};
    }
    return !first  ? QStringLiteral("   ") + entry.shown.name.mid(own.size() + 2)
           : alone ? own
                   : QString();
}

// The power of ten of a column, so that its numbers have no more than seven digits before or three
// zeros behind the decimal sign.
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

}  // namespace

QIcon curveIcon(const ShownAnalysis& shown) {
    constexpr int width = 28;
    constexpr int height = 14;
    constexpr int scale = 2;
    QPixmap pixmap(width * scale, height * scale);
    pixmap.setDevicePixelRatio(scale);
    // An opaque background, so that the line is visible on a selected row.
    pixmap.fill(QGuiApplication::palette().color(QPalette::Base));
    QPainter painter(&pixmap);
    const Theme theme = isDark(QGuiApplication::palette()) ? darkTheme() : lightTheme();
    painter.setPen(
        QPen(readable(shown.color, theme, shown.shade), 2.5, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(2, height / 2.0), QPointF(width - 2, height / 2.0));
    painter.end();
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

Ledger::Ledger(Document& document, QWidget* parent)
    : QTreeWidget(parent), document_(document), head_(new LedgerHead(header()->viewport())) {
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setIconSize({28, 14});
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setDragEnabled(true);
    setDragDropMode(QAbstractItemView::DragOnly);
    setItemDelegate(new IndexDelegate(this));
    setItemDelegateForColumn(name, new LedgerNames(this));
    setContextMenuPolicy(Qt::ActionsContextMenu);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::Fixed);
    header()->setSectionsMovable(false);
    header()->setMinimumSectionSize(8);
    addActions();
    connect(head_, &LedgerHead::readAtChosen, this, &Ledger::setReadAt);
    connect(head_, &LedgerHead::kindChosen, this, &Ledger::setTrendKind);
    connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int column) {
        if (column == name && idOf(*item) != AnalysisId::none) {
            editItem(item, name);
        }
    });
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        const AnalysisId id = idOf(*item);
        if (column != name || id == AnalysisId::none) {
            return;
        }
        // Queued, because the response of the document fills the item again.
        QMetaObject::invokeMethod(
            this,
            [this, id, visible = item->checkState(name) == Qt::Checked, text = item->text(name)] {
                document_.setAnalysisVisible(id, visible);
                document_.renameAnalysis(id, text);
            },
            Qt::QueuedConnection);
    });
    connect(this, &QTreeWidget::currentItemChanged, this, &Ledger::whenChosen);
    connect(&document_, &Document::recordingsChanged, this, &Ledger::rebuild);
    connect(&document_, &Document::recordingChanged, this, &Ledger::rebuild);
    connect(&document_, &Document::analysesChanged, this, &Ledger::rebuild);
    connect(&document_, &Document::liveChanged, this, &Ledger::rebuild);
    connect(&document_.sets(), &SetStore::changed, this, &Ledger::fillCells);
    connect(&document_, &Document::currentRecordingChanged, this, &Ledger::chooseRow);
    connect(&document_, &Document::analysisAdded, this, [this](AnalysisId id) {
        // Of another recording than the current one it stands in its row, and waits.
        const AnalysisEntry* entry = document_.analysis(id);
        if (entry && document_.isCurrent(entry->recording_id)) {
            setCurrentAnalysis(id);
        }
    });
    retranslate();
}

void Ledger::addActions() {
    const auto add = [this](const QKeySequence& key, auto&& act) {
        auto* action = new QAction(this);
        action->setShortcut(key);
        action->setShortcutContext(Qt::WidgetShortcut);
        addAction(action);
        connect(action, &QAction::triggered, this, act);
        return action;
    };
    const auto current = [this] {
        return currentItem() ? document_.recording(recordingOf(*currentItem())) : nullptr;
    };
    rename_ = add(Qt::Key_F2, [this] { editItem(currentItem(), name); });
    again_ = add(QKeyCombination(Qt::CTRL, Qt::Key_R),
                 [this] { document_.analyseAgain(currentAnalysis()); });
    add_to_set_ =
        add(Qt::Key_Insert, [this] { document_.sets().addToCurrent(selectedRecordings()); });
    reopen_ = add({}, [this, current] {
        if (const RecordingEntry* entry = current()) {
            emit reopenWanted(entry->path, entry->options);
        }
    });
    copy_facts_ = add({}, [current] {
        if (const RecordingEntry* entry = current()) {
            QGuiApplication::clipboard()->setText(recordingFacts(*entry));
        }
    });
    // A recording without analyses has nothing else to remove.
    remove_ = add(QKeySequence::Delete, [this, current] {
        if (currentAnalysis() != AnalysisId::none) {
            document_.removeAnalysis(currentAnalysis());
        } else if (const RecordingEntry* entry = current()) {
            document_.closeRecording(entry->id);
        }
    });
    close_ = add({}, [this, current] {
        if (const RecordingEntry* entry = current()) {
            document_.closeRecording(entry->id);
        }
    });
}

const AnalysisEntry* Ledger::analysisOf(const QTreeWidgetItem& item) const {
    return document_.analysis(idOf(item));
}

AnalysisId Ledger::currentAnalysis() const {
    return currentItem() ? idOf(*currentItem()) : AnalysisId::none;
}

void Ledger::setCurrentAnalysis(AnalysisId id) {
    for (int row = 0; row < topLevelItemCount(); ++row) {
        if (id != AnalysisId::none && idOf(*topLevelItem(row)) == id) {
            setCurrentItem(topLevelItem(row));
        }
    }
}

std::vector<RecordingId> Ledger::selectedRecordings() const {
    std::vector<RecordingId> ids;
    for (int row = 0; row < topLevelItemCount(); ++row) {
        const RecordingId id = recordingOf(*topLevelItem(row));
        if (topLevelItem(row)->isSelected() && std::ranges::count(ids, id) == 0) {
            ids.push_back(id);
        }
    }
    return ids;
}

QStringList Ledger::mimeTypes() const {
    const std::unique_ptr<QMimeData> none(recordingMimeData({}));
    return none->formats();
}

QMimeData* Ledger::mimeData(const QList<QTreeWidgetItem*>&) const {
    return recordingMimeData(selectedRecordings());
}

std::vector<Ledger::Row> Ledger::rows() const {
    std::vector<Row> rows;
    for (const RecordingEntry& recording : document_.recordings()) {
        bool first = true;
        for (const AnalysisEntry& entry : document_.analyses()) {
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

void Ledger::rebuild() {
    {
        const QSignalBlocker quiet(this);
        const AnalysisId chosen = currentAnalysis();
        const std::vector<Row> wanted = rows();
        // Existing items are kept, because one of them may be about to be dragged.
        while (topLevelItemCount() > static_cast<int>(wanted.size())) {
            delete takeTopLevelItem(topLevelItemCount() - 1);
        }
        while (topLevelItemCount() < static_cast<int>(wanted.size())) {
            new QTreeWidgetItem(this);
        }
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            follow(wanted[k], *topLevelItem(static_cast<int>(k)));
        }
        setCurrentAnalysis(chosen);
    }
    chooseRow();
    measure();
    layoutColumns();
    fitHeight();
    enableActions();
    emit currentAnalysisChanged(currentAnalysis());
}

// The chosen analysis is one of the current recording: the last, where none of it is chosen.
void Ledger::chooseRow() {
    const RecordingEntry* current = document_.currentRecording();
    const QTreeWidgetItem* item = currentItem();
    if (!current || (item && recordingOf(*item) == current->id &&
                     (currentAnalysis() != AnalysisId::none ||
                      std::ranges::count(document_.analyses(), current->id,
                                         &AnalysisEntry::recording_id) == 0))) {
        return;
    }
    for (int row = topLevelItemCount() - 1; row >= 0; --row) {
        if (recordingOf(*topLevelItem(row)) == current->id) {
            setCurrentItem(topLevelItem(row));
            return;
        }
    }
}

void Ledger::whenChosen() {
    if (currentItem()) {
        document_.setCurrentRecording(recordingOf(*currentItem()));
    }
    measure();
    enableActions();
    emit currentAnalysisChanged(currentAnalysis());
}

void Ledger::follow(const Row& row, QTreeWidgetItem& item) {
    const RecordingEntry& recording = *row.recording;
    const QLocale locale;
    item.setData(name, recording_role, number(recording.id));
    item.setData(name, analysis_role,
                 number(row.analysis ? row.analysis->shown.id : AnalysisId::none));
    item.setData(name, short_name_role, QVariant());
    QFont font = this->font();
    font.setBold(row.first);
    font.setItalic(row.analysis && row.analysis->live && document_.live());
    item.setFont(name, font);
    QStringList tip;
    if (!row.analysis) {
        item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
        item.setData(name, Qt::CheckStateRole, QVariant());
        item.setIcon(name, {});
        item.setText(name,
                     recording.recording ? recording.name : tr("%1 (opening)").arg(recording.name));
        for (const int column : {algorithm, window, frequency}) {
            item.setText(column, {});
        }
        item.setText(noiseColumn(), {});
    } else {
        const AnalysisEntry& entry = *row.analysis;
        const Analysis& analysis = *entry.shown.analysis;
        item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable |
                      Qt::ItemIsEditable | Qt::ItemIsDragEnabled);
        item.setCheckState(name, entry.shown.visible ? Qt::Checked : Qt::Unchecked);
        item.setIcon(name, curveIcon(entry.shown));
        item.setText(name, entry.shown.name);
        item.setData(name, short_name_role, shortName(entry, recording, row.first, row.alone));
        item.setText(algorithm, algorithmText(analysis.settings.algorithm));
        item.setText(window, locale.toString(static_cast<qint64>(analysis.plan.length)));
        const QString mean = valueText(entry.summary.mean_f_hz, entry.summary.sd_mean_f_hz);
        item.setText(frequency, mean);
        item.setToolTip(
            frequency,
            std::isfinite(entry.summary.mean_at_s)
                ? tr("%1 Hz at %2 s").arg(mean, locale.toString(entry.summary.mean_at_s, 'g', 4))
                : QString());
        item.setText(noiseColumn(), noiseText(entry.summary.noise));
        const auto count = static_cast<qint64>(entry.summary.windows);
        tip << entry.shown.name << algorithmText(analysis.settings.algorithm);
        tip << (entry.partial()
                    ? tr("%1 of %2 windows")
                          .arg(locale.toString(count),
                               locale.toString(static_cast<qint64>(analysis.plan.count)))
                    : tr("%n window(s), %1 flagged, in %2 ms", nullptr, static_cast<int>(count))
                          .arg(entry.summary.flagged)
                          .arg(locale.toString(1e3 * entry.shown.seconds_taken, 'g', 3)));
        if (entry.live && document_.live()) {
            tip << tr("Follows the settings while Live is on; Keep keeps an analysis as it is");
        }
        tip << QString();
    }
    tip << recordingFacts(recording);
    item.setToolTip(name, plainTip(tip.join(QLatin1Char('\n'))));
    for (const int column :
         {static_cast<int>(window), static_cast<int>(frequency), noiseColumn()}) {
        item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    fillNotes(row, item);
}

void Ledger::fillNotes(const Row& row, QTreeWidgetItem& item) {
    QStringList sentences;
    bool snaps = false;
    if (row.analysis) {
        const AnalysisEntry& entry = *row.analysis;
        snaps = entry.summary.leakage_limits() && !entry.requested.snap;
        if (entry.summary.leakage_limits()) {
            sentences << tr("Leakage of the window limits the mean frequency, by %1 Hz.")
                             .arg(QLocale().toString(entry.summary.leakage_f_hz, 'g', 2));
        }
        if (entry.summary.at_bound > 0) {
            sentences << tr(
                "The frequency of %n window(s) lies at the bound of the search; the mean's "
                "deviation allows for them.",
                nullptr, static_cast<int>(entry.summary.at_bound));
        }
        for (const Finding& finding : findings_of(entry.shown.analysis->diagnostics)) {
            sentences << findingText(finding);
        }
    }
    if (row.first && hasFindings(*row.recording)) {
        const auto& found = row.recording->faults ? row.recording->faults->findings
                                                  : row.recording->recording->diagnostics;
        for (const Finding& finding : findings_of(found)) {
            sentences << findingText(finding);
        }
    }
    if (const auto count = static_cast<std::size_t>(sentences.size()); count > most_shown) {
        sentences.resize(most_shown);
        sentences << moreText(count - most_shown);
    }
    const int notes = notesColumn();
    const QString text = sentences.join(QLatin1Char('\n'));
    item.setToolTip(notes, plainTip(text));
    item.setData(notes, Qt::AccessibleTextRole, text);
    item.setIcon(
        notes, sentences.isEmpty() ? QIcon() : style()->standardIcon(QStyle::SP_MessageBoxWarning));
    if (!snaps) {
        removeItemWidget(&item, notes);
        return;
    }
    auto* snap = new QPushButton(tr("Snap"), this);
    snap->setObjectName(QStringLiteral("snapAnalysis"));
    snap->setToolTip(
        plainTip(text + QLatin1Char('\n') +
                 tr("Analyse again with a window of whole half-periods, which leaks least")));
    snap->setIcon(style()->standardIcon(QStyle::SP_MessageBoxWarning));
    snap->setFixedHeight(fontMetrics().height() + 2);
    setItemWidget(&item, notes, snap);
    item.setSizeHint(notes, {snap->sizeHint().width(), fontMetrics().height() + 4});
    // Queued, because the new analysis fills this list again and deletes the button.
    connect(
        snap, &QPushButton::clicked, &document_,
        [this, id = row.analysis->shown.id] { document_.analyseSnapped(id); },
        Qt::QueuedConnection);
}

void Ledger::setUnits(const DisplayUnits& units) {
    units_ = units;
    retranslate();
}

void Ledger::setVariables(const std::vector<SlowVariable>& variables) {
    if (variables != variables_) {
        variables_ = variables;
        retranslate();
    }
}

void Ledger::setMouse(std::optional<double> time_s) {
    measuring_.mouse_s = time_s;
    if (read_at_ == ReadAt::mouse) {
        fillCells();
    }
}

void Ledger::setCursors(std::optional<double> a_s, std::optional<double> b_s) {
    measuring_.a_s = a_s;
    measuring_.b_s = b_s;
    const bool readable = read_at_ == ReadAt::mouse || (read_at_ == ReadAt::a && a_s) ||
                          (read_at_ == ReadAt::b && b_s) || measuring_.both();
    read_at_ = readable ? read_at_ : ReadAt::mouse;
    measure();
}

void Ledger::setTrendKind(TrendKind kind) {
    measuring_.kind = kind;
    measure();
}

void Ledger::setReadAt(ReadAt at) {
    read_at_ = at;
    concise_ = false;
    fillCells();
    layoutColumns();
}

int Ledger::columnOf(SlowVariable variable) const {
    const auto found = std::ranges::find(variables_, variable);
    return found == variables_.end()
               ? -1
               : first_variable + static_cast<int>(found - variables_.begin());
}

QString Ledger::tableText() const {
    const AnalysisEntry* chosen = document_.analysis(currentAnalysis());
    const QString at_mouse = mouseTable(document_, measuring_, units_);
    return chosen && chosen->shown.visible
               ? at_mouse + cursorTable(chosen->shown, measuring_, trendsOf(*chosen), units_)
               : at_mouse;
}

QStringList Ledger::sentences() const {
    const AnalysisEntry* chosen = document_.analysis(currentAnalysis());
    const bool both = chosen && isInside(*chosen->shown.analysis, measuring_.a_s) &&
                      isInside(*chosen->shown.analysis, measuring_.b_s);
    return both ? measuredSentences(document_, *chosen, measuring_, trendsOf(*chosen), units_)
                : QStringList();
}

const std::vector<FittedTrend>& Ledger::trendsOf(const AnalysisEntry& entry) const {
    static const std::vector<FittedTrend> none;
    const auto found = std::ranges::find(trends_, entry.shown.id, &Measured::id);
    return found == trends_.end() ? none : found->trends;
}

// Fits the trends that are new: of the visible analyses, of long ones and beats the chosen alone.
void Ledger::measure() {
    Measuring wanted = measuring_;
    wanted.mouse_s.reset();
    const std::vector<Measured> before =
        wanted == measured_ ? std::move(trends_) : std::vector<Measured>();
    measured_ = wanted;
    trends_.clear();
    for (const AnalysisEntry& entry : document_.analyses()) {
        const ShownAnalysis& shown = entry.shown;
        const bool chosen = shown.id == currentAnalysis();
        const bool quick =
            wanted.kind != TrendKind::beat && shown.analysis->track.rows() <= quick_rows;
        if (!wanted.both() || !shown.visible || !(chosen || quick)) {
            continue;
        }
        const auto known = std::ranges::find_if(before, [&shown](const Measured& each) {
            return each.id == shown.id && each.analysis == shown.analysis;
        });
        trends_.push_back(
            known != before.end()
                ? *known
                : Measured{shown.id, shown.analysis, trendsBetween(*shown.analysis, measuring_)});
    }
    fillCells();
    std::vector<TrendCurve> curves;
    const AnalysisEntry* chosen = document_.analysis(currentAnalysis());
    if (chosen && chosen->shown.visible) {
        for (const FittedTrend& trend : trendsOf(*chosen)) {
            curves.push_back(
                curveOf(*chosen->shown.analysis, trend, *measuring_.a_s, *measuring_.b_s, units_));
            curves.back().of = chosen->shown.id;
        }
    }
    if (curves != drawn_) {
        drawn_ = std::move(curves);
        emit trendsChanged(drawn_);
    }
}

void Ledger::fillCells() {
    const QSignalBlocker quiet(this);
    head_->show(read_at_, measuring_);
    for (std::size_t k = 0; k < variables_.size(); ++k) {
        fillVariable(first_variable + static_cast<int>(k), concise_);
    }
    bool narrow = false;
    for (int row = 0; row < topLevelItemCount(); ++row) {
        QTreeWidgetItem& item = *topLevelItem(row);
        const AnalysisEntry* entry = analysisOf(item);
        if (entry && entry->shown.visible) {
            fillTrend(item, *entry);
        } else {
            item.setText(trend, {});
            item.setToolTip(trend, {});
        }
    }
    for (int column = trend; column < noiseColumn(); ++column) {
        narrow =
            narrow || (!isColumnHidden(column) && sizeHintForColumn(column) > columnWidth(column));
    }
    if (narrow) {
        layoutColumns();
    }
    viewport()->update();
}

void Ledger::fillVariable(int column, bool concise) {
    const SlowVariable variable = variables_[static_cast<std::size_t>(column - first_variable)];
    std::vector<Reading> readings;
    for (int row = 0; row < topLevelItemCount(); ++row) {
        const AnalysisEntry* entry = analysisOf(*topLevelItem(row));
        Measuring here = measuring_;
        if (entry && entry->shown.visible && !here.mouse_s &&
            entry->shown.analysis->track.rows() > 0) {
            here.mouse_s = entry->shown.analysis->track.time_s().front();
        }
        readings.push_back(entry && entry->shown.visible
                               ? readingOf(*entry->shown.analysis, variable, read_at_, here,
                                           trendsOf(*entry), units_)
                               : Reading());
    }
    const int exponent = exponentOf(readings);
    const double scale = std::pow(10., -exponent);
    for (int row = 0; row < topLevelItemCount(); ++row) {
        const Reading& reading = readings[static_cast<std::size_t>(row)];
        QTreeWidgetItem& item = *topLevelItem(row);
        const double value = reading.value * scale;
        const double sd = reading.sd * scale;
        item.setText(column, !analysisOf(item) ? QString()
                             : concise         ? conciseText(value, sd)
                                               : valueText(value, sd));
        item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    QString unit = displayUnit(variable, units_);
    if (read_at_ == ReadAt::rate) {
        unit = measuring_.kind == TrendKind::beat ? tr("Hz")
               : unit.isEmpty()                   ? tr("1/s")
                                                  : tr("%1/s").arg(unit);
    }
    const bool prefix = read_at_ == ReadAt::rate && measuring_.kind == TrendKind::beat
                            ? true
                            : takesPrefix(variable, units_);
    const QString scaled = scaledUnit(unit, prefix, exponent);
    const QString symbol = indexPlain(displaySymbol(variable, units_));
    headerItem()->setText(column,
                          scaled.isEmpty() ? symbol : QStringLiteral("%1, %2").arg(symbol, scaled));
    headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    headerItem()->setToolTip(column, displayMeaning(variable));
}

// What the trend says, or why there is nothing to read.
void Ledger::fillTrend(QTreeWidgetItem& item, const AnalysisEntry& entry) {
    const Analysis& analysis = *entry.shown.analysis;
    const std::optional<double> time_s = read_at_ == ReadAt::mouse ? measuring_.mouse_s
                                         : read_at_ == ReadAt::a   ? measuring_.a_s
                                         : read_at_ == ReadAt::b   ? measuring_.b_s
                                                                   : std::nullopt;
    QString text;
    QString tip;
    if (time_s) {
        text = reasonAt(analysis, *time_s);
    }
    if (text.isEmpty() && measuring_.both()) {
        if (!isInside(analysis, measuring_.a_s) || !isInside(analysis, measuring_.b_s)) {
            text = tr("no windows there");
        } else {
            const auto& trends = trendsOf(entry);
            text = trendSummary(measuring_.kind, trends, units_);
            tip = measuredSentences(document_, entry, measuring_, trends, units_)
                      .join(QLatin1Char('\n'));
        }
    }
    item.setText(trend, text);
    item.setToolTip(trend, tip.isEmpty() ? plainTip(text) : richTip(tip.replace('\n', "<br>")));
}

// Names may be shortened, numbers may not: a column without room for its numbers gives way.
void Ledger::layoutColumns() {
    const int room = viewport()->width();
    const int least_name = 14 * fontMetrics().averageCharWidth() + 48;
    const auto lay = [&](const std::vector<int>& hidden) {
        int others = 0;
        for (int column = 0; column < columnCount(); ++column) {
            const bool hide = std::ranges::count(hidden, column) > 0;
            setColumnHidden(column, hide);
            if (!hide && column != name) {
                resizeColumnToContents(column);
                others += columnWidth(column);
            }
        }
        const int switches = head_->sizeHint().width() + 4;
        if (columnWidth(trend) < switches) {
            others += switches - columnWidth(trend);
            setColumnWidth(trend, switches);
        }
        resizeColumnToContents(name);
        const int left = room - others;
        setColumnWidth(name, std::min(columnWidth(name), std::max(left, least_name)));
        setColumnWidth(trend, columnWidth(trend) + std::max(0, left - columnWidth(name)));
        return left >= least_name;
    };
    const QSignalBlocker quiet(this);
    for (const bool concise : {false, true}) {
        concise_ = concise;
        for (std::size_t k = 0; k < variables_.size(); ++k) {
            fillVariable(first_variable + static_cast<int>(k), concise);
        }
        std::vector<int> hidden;
        if (lay(hidden) || (!concise && (hidden = {algorithm, frequency}, lay(hidden)))) {
            break;
        }
        if (concise) {
            for (const int column : {static_cast<int>(algorithm), static_cast<int>(frequency),
                                     noiseColumn(), static_cast<int>(window)}) {
                hidden.push_back(column);
                if (lay(hidden)) {
                    break;
                }
            }
        }
    }
    head_->setGeometry(header()->sectionViewportPosition(trend), 0, columnWidth(trend),
                       header()->height());
}

// As high as its rows; the rest belongs to the plots.
void Ledger::fitHeight() {
    const int most = QWidget::window()->height() < low_window ? 4 : 6;
    const QTreeWidgetItem* first = topLevelItem(0);
    const int row = first ? rowHeight(indexFromItem(first)) : fontMetrics().height() + 4;
    const int head = std::max(header()->sizeHint().height(), head_->sizeHint().height());
    header()->setFixedHeight(head);
    setFixedHeight(head + std::clamp(topLevelItemCount(), 1, most) * row + 2 * frameWidth());
    if (topLevelItemCount() <= most) {
        scrollToTop();
    }
}

void Ledger::resizeEvent(QResizeEvent* event) {
    QTreeWidget::resizeEvent(event);
    layoutColumns();
    fitHeight();
}

// The live analysis stays while Live is on: it would come back with the next change.
void Ledger::enableActions() {
    const AnalysisEntry* entry = document_.analysis(currentAnalysis());
    rename_->setEnabled(entry);
    again_->setEnabled(entry);
    remove_->setEnabled(currentItem() && !(entry && entry->live && document_.live()));
    for (QAction* action : {add_to_set_, reopen_, copy_facts_, close_}) {
        action->setEnabled(currentItem());
    }
}

void Ledger::changeEvent(QEvent* event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        rebuild();  // the icons are drawn in the theme's colours
    }
}

void Ledger::retranslate() {
    setAccessibleName(tr("Recordings and analyses"));
    setToolTip(tr(
        "The chosen row is what is analysed, measured and shown by the other pages. Space hides, "
        "Delete removes, F2 renames"));
    setColumnCount(notesColumn() + 1);
    for (int column = 0; column < columnCount(); ++column) {
        headerItem()->setText(column, {});
        headerItem()->setToolTip(column, {});
    }
    headerItem()->setText(name, tr("Recording, analysis"));
    headerItem()->setText(algorithm, tr("Algorithm"));
    headerItem()->setText(window, tr("n"));
    headerItem()->setToolTip(window, tr("Window, samples"));
    headerItem()->setText(frequency, tr("Mean f, Hz"));
    headerItem()->setToolTip(
        frequency,
        tr("Weighted mean of the frequency f_cp over all valid windows ± its standard deviation: "
           "scatter between windows, leakage of algorithms 1 to 4, bounds of the search"));
    headerItem()->setText(noiseColumn(), tr("Noise"));
    headerItem()->setToolTip(noiseColumn(),
                             tr("Noise per sample and channel: residual of the windows, its "
                                "degrees of freedom counted"));
    headerItem()->setText(notesColumn(), tr("⚠"));
    headerItem()->setToolTip(notesColumn(), tr("Warnings of the recording and the analysis"));
    for (const int column :
         {static_cast<int>(window), static_cast<int>(frequency), noiseColumn()}) {
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    rename_->setText(tr("Rename"));
    again_->setText(tr("Analyse again with its settings"));
    remove_->setText(tr("Remove"));
    add_to_set_->setText(tr("Add to the set of the resonator"));
    reopen_->setText(tr("Import again…"));
    copy_facts_->setText(tr("Copy the facts of the recording"));
    close_->setText(tr("Close recording"));
    rebuild();
}

}  // namespace vybeg::ui
