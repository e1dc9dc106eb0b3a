#include "ui/run_list.h"

#include "ui/display_units.h"
#include "ui/error_text.h"
#include "ui/settings_panel.h"
#include "ui/theme.h"

#include <QAction>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>

namespace vybeg::ui {

QIcon runIcon(const Run& run) {
    constexpr int width = 28;
    constexpr int height = 14;
    constexpr int scale = 2;
    QPixmap pixmap(width * scale, height * scale);
    pixmap.setDevicePixelRatio(scale);
    // Its own ground: the line must also be seen on the colour of a selected row.
    pixmap.fill(QGuiApplication::palette().color(QPalette::Base));
    QPainter painter(&pixmap);
    const Theme theme = isDark(QGuiApplication::palette()) ? darkTheme() : lightTheme();
    painter.setPen(QPen(readable(run.color, theme), 2.5, run.dash, Qt::FlatCap));
    painter.drawLine(QPointF(2, height / 2.0), QPointF(width - 2, height / 2.0));
    painter.end();
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

RunList::RunList(Document& document, QWidget* parent) : QTreeWidget(parent), document_(document) {
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setColumnCount(column_count);
    setIconSize({28, 14});
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    header()->setStretchLastSection(true);
    header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);

    rename_ = new QAction(this);
    rename_->setShortcut(Qt::Key_F2);
    rerun_ = new QAction(this);
    rerun_->setShortcut(QKeyCombination(Qt::CTRL, Qt::Key_R));
    remove_ = new QAction(this);
    remove_->setShortcut(QKeySequence::Delete);
    for (QAction* action : {rename_, rerun_, remove_}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        addAction(action);
    }
    connect(rename_, &QAction::triggered, this, [this] {
        if (currentItem()) {
            editItem(currentItem(), name);
        }
    });
    connect(rerun_, &QAction::triggered, this, [this] { document_.rerun(currentRun()); });
    connect(remove_, &QAction::triggered, this, [this] { document_.removeRun(currentRun()); });
    connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int column) {
        if (column == name) {
            editItem(item, name);
        }
    });
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (column == name) {
            const int id = item->data(name, Qt::UserRole).toInt();
            const bool visible = item->checkState(name) == Qt::Checked;
            const QString text = item->text(name);
            // Queued: the document's answer rebuilds this list, and with it the item.
            QMetaObject::invokeMethod(
                this,
                [this, id, visible, text] {
                    document_.setRunVisible(id, visible);
                    document_.renameRun(id, text);
                },
                Qt::QueuedConnection);
        }
    });
    connect(this, &QTreeWidget::currentItemChanged, this,
            [this] { emit currentRunChanged(currentRun()); });
    connect(&document_, &Document::runsChanged, this, &RunList::rebuild);
    connect(&document_, &Document::liveChanged, this, &RunList::rebuild);
    connect(&document_, &Document::runAdded, this, [this](int id) {
        for (int row = 0; row < topLevelItemCount(); ++row) {
            if (topLevelItem(row)->data(name, Qt::UserRole).toInt() == id) {
                setCurrentItem(topLevelItem(row));
            }
        }
    });
    retranslate();
    const int digit = fontMetrics().averageCharWidth();
    const int widths[column_count] = {27, 14, 25, 7, 23, 25, 12, 8};
    for (int column = 0; column < column_count; ++column) {
        setColumnWidth(column, widths[column] * digit);
    }
}

int RunList::currentRun() const {
    return currentItem() ? currentItem()->data(name, Qt::UserRole).toInt() : 0;
}

void RunList::fill(QTreeWidgetItem& item, const RunEntry& entry) const {
    const QLocale locale;
    const Analysis& analysis = *entry.run.analysis;
    item.setData(name, Qt::UserRole, entry.run.id);
    item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable |
                  Qt::ItemIsEditable);
    item.setCheckState(name, entry.run.visible ? Qt::Checked : Qt::Unchecked);
    item.setIcon(name, runIcon(entry.run));
    item.setText(name, entry.run.name);
    item.setText(recording, entry.run.recording);
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
    item.setText(frequency, valueText(entry.summary.mean_f_hz, entry.summary.sd_mean_f_hz));
    item.setText(rms, locale.toString(entry.summary.rms, 'g', 4));
    const double ms = 1e3 * entry.run.seconds_taken;
    item.setText(time, entry.partial() ? QString() : locale.toString(ms, 'f', ms < 10 ? 2 : 0));
    QStringList notes;
    if (entry.live && document_.live()) {
        QFont font = this->font();
        font.setItalic(true);
        item.setFont(name, font);
        notes << tr("Follows the settings while Live is on; Run keeps a run as it is");
    }
    for (const Diagnostic& diagnostic : analysis.diagnostics) {
        notes << diagnosticText(diagnostic);
    }
    for (int column = 0; column < column_count; ++column) {
        item.setToolTip(column,
                        notes.isEmpty() ? item.text(column) : notes.join(QLatin1Char('\n')));
    }
}

void RunList::rebuild() {
    const int current = currentRun();
    {
        const QSignalBlocker blocker(this);
        clear();
        for (const RunEntry& entry : document_.runs()) {
            auto* item = new QTreeWidgetItem(this);
            fill(*item, entry);
            if (entry.run.id == current) {
                setCurrentItem(item);
            }
        }
        if (!currentItem() && topLevelItemCount() > 0) {
            setCurrentItem(topLevelItem(topLevelItemCount() - 1));
        }
    }
    for (QAction* action : {rename_, rerun_, remove_}) {
        action->setEnabled(currentItem() != nullptr);
    }
    emit currentRunChanged(currentRun());
}

void RunList::changeEvent(QEvent* event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void RunList::retranslate() {
    setAccessibleName(tr("Runs"));
    setHeaderLabels({tr("Run"), tr("Recording"), tr("Algorithm"), tr("n"), tr("Windows"),
                     tr("Mean f, Hz"), tr("rms"), tr("Time, ms")});
    headerItem()->setToolTip(frequency,
                             tr("Mean frequency f_cp over all windows ± standard deviation of the "
                                "mean, from the scatter between windows"));
    headerItem()->setToolTip(rms, tr("Root of the functional F (7), mean over all windows"));
    headerItem()->setToolTip(time, tr("Time in the estimators alone"));
    headerItem()->setToolTip(window, tr("Window, samples"));
    rename_->setText(tr("Rename"));
    rerun_->setText(tr("Run again with its settings"));
    remove_->setText(tr("Remove"));
    rebuild();
}

}  // namespace vybeg::ui
