#include "ui/panels/analysis_list.h"

#include "ui/widgets/theme.h"
#include "ui/words/algorithm_text.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/short_names.h"

#include <QAction>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyle>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

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

AnalysisList::AnalysisList(Document& document, QWidget* parent)
    : QTreeWidget(parent), document_(document) {
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setColumnCount(column_count);
    setIconSize({28, 14});
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setItemDelegateForColumn(name, new NameDelegate(this));
    setItemDelegateForColumn(recording, new NameDelegate(this));
    setContextMenuPolicy(Qt::ActionsContextMenu);
    header()->setStretchLastSection(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);

    rename_ = new QAction(this);
    rename_->setShortcut(Qt::Key_F2);
    again_ = new QAction(this);
    again_->setShortcut(QKeyCombination(Qt::CTRL, Qt::Key_R));
    remove_ = new QAction(this);
    remove_->setShortcut(QKeySequence::Delete);
    for (QAction* action : {rename_, again_, remove_}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        addAction(action);
    }
    connect(rename_, &QAction::triggered, this, [this] {
        if (currentItem()) {
            editItem(currentItem(), name);
        }
    });
    connect(again_, &QAction::triggered, this,
            [this] { document_.analyseAgain(currentAnalysis()); });
    connect(remove_, &QAction::triggered, this,
            [this] { document_.removeAnalysis(currentAnalysis()); });
    connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int column) {
        if (column == name) {
            editItem(item, name);
        }
    });
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (column == name) {
            const AnalysisId id = analysisOf(*item);
            const bool visible = item->checkState(name) == Qt::Checked;
            const QString text = item->text(name);
            // Queued, because the response of the document rebuilds this list and deletes the item.
            QMetaObject::invokeMethod(
                this,
                [this, id, visible, text] {
                    document_.setAnalysisVisible(id, visible);
                    document_.renameAnalysis(id, text);
                },
                Qt::QueuedConnection);
        }
    });
    connect(this, &QTreeWidget::currentItemChanged, this, [this] {
        enableActions();
        emit currentAnalysisChanged(currentAnalysis());
    });
    connect(&document_, &Document::analysesChanged, this, &AnalysisList::rebuild);
    connect(&document_, &Document::liveChanged, this, &AnalysisList::rebuild);
    connect(&document_, &Document::analysisAdded, this, &AnalysisList::setCurrentAnalysis);
    retranslate();
}

void AnalysisList::setCurrentAnalysis(AnalysisId id) {
    for (int row = 0; row < topLevelItemCount(); ++row) {
        if (analysisOf(*topLevelItem(row)) == id) {
            setCurrentItem(topLevelItem(row));
        }
    }
}

AnalysisId AnalysisList::currentAnalysis() const {
    return currentItem() ? analysisOf(*currentItem()) : AnalysisId::none;
}

AnalysisId AnalysisList::analysisOf(const QTreeWidgetItem& item) {
    return static_cast<AnalysisId>(item.data(name, Qt::UserRole).toInt());
}

void AnalysisList::fill(QTreeWidgetItem& item, const AnalysisEntry& entry) {
    const QLocale locale;
    const Analysis& analysis = *entry.shown.analysis;
    item.setData(name, Qt::UserRole, number(entry.shown.id));
    item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable |
                  Qt::ItemIsEditable);
    item.setCheckState(name, entry.shown.visible ? Qt::Checked : Qt::Unchecked);
    item.setIcon(name, curveIcon(entry.shown));
    item.setText(name, entry.shown.name);
    item.setText(recording, entry.shown.recording);
    item.setText(algorithm, algorithmText(analysis.settings.algorithm));
    item.setText(window, locale.toString(static_cast<qint64>(analysis.plan.length)));
    const QString count = locale.toString(static_cast<qint64>(entry.summary.windows));
    const QString flagged = entry.summary.flagged == 0
                                ? count
                                : tr("%1 (%2 flagged)").arg(count).arg(entry.summary.flagged);
    item.setText(
        windows,
        entry.partial()
            ? tr("%1 of %2").arg(count, locale.toString(static_cast<qint64>(analysis.plan.count)))
            : flagged);
    const QString mean = valueText(entry.summary.mean_f_hz, entry.summary.sd_mean_f_hz);
    item.setText(frequency,
                 std::isfinite(entry.summary.mean_at_s)
                     ? tr("%1 at %2 s").arg(mean, shortNumberText(entry.summary.mean_at_s, 4))
                     : mean);
    item.setText(noise, noiseText(entry.summary.noise));
    const double ms = 1e3 * entry.shown.seconds_taken;
    item.setText(time, entry.partial() ? QString() : locale.toString(ms, 'f', ms < 10 ? 2 : 0));
    for (int column = 0; column < column_count; ++column) {
        item.setToolTip(column, plainTip(item.text(column)));
    }
    if (entry.live && document_.live()) {
        QFont font = this->font();
        font.setItalic(true);
        item.setFont(name, font);
        item.setToolTip(
            name, tr("Follows the settings while Live is on; Analyse keeps an analysis as it is"));
    }
    fillNotes(item, entry);
}

void AnalysisList::fillNotes(QTreeWidgetItem& item, const AnalysisEntry& entry) {
    QStringList sentences;
    const bool snaps = entry.summary.leakage_limits() && !entry.requested.snap;
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
    if (sentences.isEmpty()) {
        return;
    }
    item.setToolTip(notes, plainTip(sentences.join(QLatin1Char('\n'))));
    if (const std::size_t count = static_cast<std::size_t>(sentences.size()); count > most_shown) {
        sentences.resize(most_shown);
        sentences << moreText(count - most_shown);
    }
    const QString text = sentences.join(QLatin1Char(' '));
    const QIcon mark = style()->standardIcon(QStyle::SP_MessageBoxWarning);
    if (!snaps) {
        item.setIcon(notes, mark);
        item.setText(notes, text);
        return;
    }
    auto* const sign = new QLabel(this);
    sign->setPixmap(mark.pixmap(fontMetrics().height()));
    auto* cell = new QWidget(this);
    auto* snap = new QPushButton(tr("Snap"), cell);
    snap->setObjectName(QStringLiteral("snapAnalysis"));
    snap->setToolTip(tr("Analyse again with a window of whole half-periods, which leaks least"));
    snap->setFixedHeight(fontMetrics().height() + 2);
    auto* layout = new QHBoxLayout(cell);
    layout->setContentsMargins(2, 0, 2, 0);
    layout->addWidget(sign);
    layout->addWidget(snap);
    auto* const note = new QLabel(text, cell);
    note->setObjectName(QStringLiteral("note"));
    layout->addWidget(note);
    layout->addStretch(1);
    setItemWidget(&item, notes, cell);
    item.setSizeHint(notes, {cell->sizeHint().width(), fontMetrics().height() + 4});
    // Queued, because the new analysis rebuilds this list and deletes the button.
    connect(
        snap, &QPushButton::clicked, &document_,
        [this, id = entry.shown.id] { document_.analyseSnapped(id); }, Qt::QueuedConnection);
}

void AnalysisList::rebuild() {
    const AnalysisId current = currentAnalysis();
    {
        const QSignalBlocker blocker(this);
        clear();
        for (const AnalysisEntry& entry : document_.analyses()) {
            auto* item = new QTreeWidgetItem(this);
            fill(*item, entry);
            if (entry.shown.id == current) {
                setCurrentItem(item);
            }
        }
        if (!currentItem() && topLevelItemCount() > 0) {
            setCurrentItem(topLevelItem(topLevelItemCount() - 1));
        }
    }
    // Names may be shortened, to what the numbers leave of the width; numbers may not.
    int left = viewport()->width();
    for (int column = algorithm; column < column_count; ++column) {
        resizeColumnToContents(column);
        left -= column < notes ? columnWidth(column) : header()->sectionSizeHint(column);
    }
    for (const auto& [column, part] : {std::pair{recording, 0.4}, std::pair{name, 1.0}}) {
        const int least = 14 * fontMetrics().averageCharWidth();
        resizeColumnToContents(column);
        setColumnWidth(
            column, std::min(columnWidth(column), std::max(least, static_cast<int>(part * left))));
        left -= columnWidth(column);
    }
    // As high as its rows, from two to six of them; the rest belongs to the plots.
    constexpr int most_rows = 6;
    setFixedHeight(header()->sizeHint().height() + horizontalScrollBar()->sizeHint().height() +
                   std::clamp(topLevelItemCount(), 2, most_rows) * rowHeight() + 2 * frameWidth());
    enableActions();
    emit currentAnalysisChanged(currentAnalysis());
}

int AnalysisList::rowHeight() const {
    return topLevelItem(0) ? visualItemRect(topLevelItem(0)).height() : fontMetrics().height();
}

// The live analysis stays while Live is on: it would come back with the next change.
void AnalysisList::enableActions() {
    const AnalysisEntry* entry = document_.analysis(currentAnalysis());
    rename_->setEnabled(entry);
    again_->setEnabled(entry);
    remove_->setEnabled(entry && !(entry->live && document_.live()));
}

void AnalysisList::changeEvent(QEvent* event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        rebuild();  // the icons are drawn in the theme's colours
    }
}

void AnalysisList::retranslate() {
    setAccessibleName(tr("Analyses"));
    setToolTip(
        tr("The chosen analysis is what cursors, events and residuals show. Space hides, Delete "
           "removes, F2 renames"));
    setHeaderLabels({tr("Analysis"), tr("Recording"), tr("Algorithm"), tr("n"), tr("Windows"),
                     tr("Mean f, Hz"), tr("Noise"), tr("Time, ms"), tr("Notes")});
    headerItem()->setToolTip(
        frequency,
        tr("Weighted mean of the frequency f_cp over all valid windows ± its standard deviation: "
           "scatter between windows, leakage of algorithms 1 to 4, bounds of the search"));
    headerItem()->setToolTip(noise, tr("Noise per sample and channel: residual of the windows, its "
                                       "degrees of freedom counted"));
    headerItem()->setToolTip(time, tr("Time in the estimators alone"));
    headerItem()->setToolTip(window, tr("Window, samples"));
    rename_->setText(tr("Rename"));
    again_->setText(tr("Analyse again with its settings"));
    remove_->setText(tr("Remove"));
    rebuild();
}

}  // namespace vybeg::ui
