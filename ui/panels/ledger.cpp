#include "ui/panels/ledger.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"
#include "ui/words/rich_text.h"
#include "ui/words/settings_text.h"

#include <QAction>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

// A window as high as that has six rows, a lower one four.
constexpr int low_window = 850;

QWidget* titlesOf(QTreeWidget& tree) {
    tree.setHeader(new IndexHeader(Qt::Horizontal, &tree));
    return tree.header()->viewport();
}

}  // namespace

Ledger::Ledger(Document& document, QWidget* parent)
    : QTreeWidget(parent), document_(document), head_(new LedgerHead(titlesOf(*this))) {
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setIconSize({28, 14});
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setItemDelegate(new IndexDelegate(this));
    setItemDelegateForColumn(name, new LedgerNames(this));
    setContextMenuPolicy(Qt::ActionsContextMenu);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(QFrame::NoFrame);
    header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::Fixed);
    header()->setSectionsMovable(false);
    header()->setMinimumSectionSize(8);
    addActions();
    connect(head_, &LedgerHead::readAtChosen, this, &Ledger::setReadAt);
    connect(head_, &LedgerHead::kindChosen, this, &Ledger::setTrendKind);
    connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int column) {
        if (column == name && analysisIdOf(*item) != AnalysisId::none) {
            editItem(item, name);
        }
    });
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        const AnalysisId id = analysisIdOf(*item);
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
    connect(this, &QTreeWidget::currentItemChanged, this, [this] {
        if (currentItem()) {
            document_.setCurrentRecording(recordingOf(*currentItem()));
        }
        measure();
        enableActions();
        emit currentAnalysisChanged(currentAnalysis());
    });
    connect(&document_, &Document::recordingsChanged, this, &Ledger::rebuild);
    connect(&document_, &Document::recordingChanged, this, &Ledger::rebuild);
    connect(&document_, &Document::analysesChanged, this, &Ledger::rebuild);
    connect(&document_, &Document::liveChanged, this, &Ledger::rebuild);
    connect(&document_.sets(), &SetStore::changed, this, &Ledger::rebuild);
    connect(&document_, &Document::currentRecordingChanged, this, &Ledger::chooseRow);
    connect(&document_, &Document::analysisAdded, this, [this](AnalysisId id) {
        // Of another recording than the current one it gets its row, but is not chosen.
        const AnalysisEntry* entry = document_.analysis(id);
        if (entry && document_.isCurrent(entry->recording_id)) {
            setCurrentAnalysis(id);
        }
    });
    keepTranslated(*this, [this] { retranslate(); });
    // The icons are drawn in the theme's colours.
    whenChanged(*this, {QEvent::PaletteChange}, [this] { rebuild(); });
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
    rename_ = add(Qt::Key_F2, [this] { editItem(currentItem(), name); });
    again_ = add(QKeyCombination(Qt::CTRL, Qt::Key_R),
                 [this] { document_.analyseAgain(currentAnalysis()); });
    add_to_set_ =
        add(Qt::Key_Insert, [this] { document_.sets().addToCurrent(selectedRecordings()); });
    reopen_ = add({}, [this] {
        const RecordingEntry& entry = *document_.currentRecording();
        emit document_.importWanted(entry.path, entry.options);
    });
    copy_facts_ = add({}, [this] {
        QGuiApplication::clipboard()->setText(recordingFacts(*document_.currentRecording()));
    });
    // A recording without analyses has nothing else to remove.
    remove_ = add(QKeySequence::Delete, [this] {
        if (currentAnalysis() != AnalysisId::none) {
            document_.removeAnalysis(currentAnalysis());
        } else {
            document_.closeRecording(document_.currentRecording()->id);
        }
    });
}

AnalysisId Ledger::currentAnalysis() const {
    return currentItem() ? analysisIdOf(*currentItem()) : AnalysisId::none;
}

void Ledger::setCurrentAnalysis(AnalysisId id) {
    for (int row = 0; row < topLevelItemCount(); ++row) {
        if (id != AnalysisId::none && analysisIdOf(*topLevelItem(row)) == id) {
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

void Ledger::rebuild() {
    {
        const QSignalBlocker quiet(this);
        const AnalysisId chosen = currentAnalysis();
        const std::vector<LedgerRow> wanted = ledgerRows(document_);
        while (topLevelItemCount() > static_cast<int>(wanted.size())) {
            delete takeTopLevelItem(topLevelItemCount() - 1);
        }
        while (topLevelItemCount() < static_cast<int>(wanted.size())) {
            new QTreeWidgetItem(this);
        }
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            fill(wanted[k], *topLevelItem(static_cast<int>(k)));
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

// Empty where one set alone has recordings, and nothing is to tell apart. A set that is called as
// the recording says nothing.
QString Ledger::setsOf(RecordingId id) const {
    int sets = 0;
    QStringList names;
    for (const RecordingSet& set : document_.sets().all()) {
        sets += set.recordings.empty() ? 0 : 1;
        if (name_of_set_ && std::ranges::count(set.recordings, id) > 0) {
            names << name_of_set_(set);
        }
    }
    names.removeAll(QFileInfo(document_.recording(id)->path).completeBaseName());
    return sets > 1 ? names.join(QStringLiteral(", ")) : QString();
}

void Ledger::fill(const LedgerRow& row, QTreeWidgetItem& item) {
    nameRow(row, setsOf(row.recording->id), document_.live(), item);
    item.setText(algorithm, {});
    for (const int column :
         {static_cast<int>(window), static_cast<int>(frequency), noiseColumn()}) {
        item.setText(column, {});
        item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    if (row.analysis) {
        const TrackSummary& summary = row.analysis->summary;
        const Analysis& analysis = *row.analysis->shown.analysis;
        item.setText(algorithm, algorithmText(analysis.settings.algorithm));
        item.setText(window, countLabel(analysis.plan.length));
        const QString mean = valueText(summary.mean_f_hz, summary.sd_mean_f_hz);
        item.setText(frequency, mean);
        item.setToolTip(frequency,
                        std::isfinite(summary.mean_at_s)
                            ? tr("%1 Hz at %2 s").arg(mean, shortNumberText(summary.mean_at_s, 4))
                            : QString());
        item.setText(noiseColumn(), threeDigits(summary.noise));
    }
    const QString notes = rowNotes(row);
    const QIcon mark = style()->standardIcon(QStyle::SP_MessageBoxWarning);
    item.setToolTip(notesColumn(), plainTip(notes));
    item.setData(notesColumn(), Qt::AccessibleTextRole, notes);
    item.setIcon(notesColumn(), notes.isEmpty() ? QIcon() : mark);
    if (!row.analysis || !row.analysis->summary.leakage_limits() || row.analysis->requested.snap) {
        removeItemWidget(&item, notesColumn());
        return;
    }
    auto* snap = withName(new QPushButton(mark, tr("Snap"), this), "snapAnalysis");
    snap->setToolTip(
        plainTip(notes + QLatin1Char('\n') +
                 tr("Analyse again with a window of whole half-periods, which leaks least")));
    snap->setFixedHeight(fontMetrics().height() + 2);
    setItemWidget(&item, notesColumn(), snap);
    item.setSizeHint(notesColumn(), {snap->sizeHint().width(), fontMetrics().height() + 4});
    // Queued, because the new analysis fills this list again and deletes the button.
    connect(
        snap, &QPushButton::clicked, &document_,
        [this, id = row.analysis->shown.id] { document_.analyseAgain(id, true); },
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
               ? at_mouse +
                     cursorTable(chosen->shown, measuring_, trends_.of(chosen->shown.id), units_)
               : at_mouse;
}

void Ledger::measure() {
    trends_.fit(document_, measuring_, currentAnalysis());
    fillCells();
    std::vector<TrendCurve> curves;
    const AnalysisEntry* chosen = document_.analysis(currentAnalysis());
    if (chosen && chosen->shown.visible) {
        for (const FittedTrend& fitted : trends_.of(chosen->shown.id)) {
            curves.push_back(
                curveOf(*chosen->shown.analysis, fitted, *measuring_.a_s, *measuring_.b_s, units_));
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
    fillVariables();
    bool narrow = false;
    for (int row = 0; row < topLevelItemCount(); ++row) {
        QTreeWidgetItem& item = *topLevelItem(row);
        const auto [text, tip] = trendCell(reader(), document_.analysis(analysisIdOf(item)));
        item.setText(trend, text);
        item.setToolTip(trend, tip);
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

void Ledger::fillVariables() {
    std::vector<const AnalysisEntry*> rows;
    rows.reserve(static_cast<std::size_t>(topLevelItemCount()));
    for (int row = 0; row < topLevelItemCount(); ++row) {
        rows.push_back(document_.analysis(analysisIdOf(*topLevelItem(row))));
    }
    for (const SlowVariable variable : variables_) {
        const int column = columnOf(variable);
        const CellColumn read = variableColumn(reader(), rows, variable, concise_);
        for (int row = 0; row < topLevelItemCount(); ++row) {
            topLevelItem(row)->setText(column, read.cells[row]);
            topLevelItem(row)->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        }
        headerItem()->setText(column, indexPlain(read.head));
        headerItem()->setData(column, IndexHeader::title_role, read.head);
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        headerItem()->setToolTip(column, displayMeaning(variable));
    }
}

// Names may be shortened, numbers may not: a column without room for its numbers gives way. Those
// of wide windows do not come and go with what is read.
void Ledger::layoutColumns() {
    constexpr int wide = 1500;
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
        fillVariables();
        std::vector<int> hidden;
        if (room >= wide && lay(hidden)) {
            break;
        }
        hidden = {algorithm, frequency};
        if (lay(hidden)) {
            break;
        }
        if (concise) {
            for (const int column : {noiseColumn(), static_cast<int>(window)}) {
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
    for (QAction* action : {add_to_set_, reopen_, copy_facts_}) {
        action->setEnabled(currentItem());
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
        headerItem()->setData(column, IndexHeader::title_role, {});
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
    rebuild();
}

}  // namespace vybeg::ui

#include "moc_ledger.cpp"
