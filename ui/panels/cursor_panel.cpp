#include "ui/panels/cursor_panel.h"

#include "ui/panels/analysis_list.h"
#include "ui/panels/reading.h"
#include "ui/values/covered_time.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/short_names.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

constexpr int cursor_rows = static_cast<int>(shown_slow_variables.size());

std::vector<const AnalysisEntry*> visibleAnalyses(const Document& document) {
    std::vector<const AnalysisEntry*> visible;
    for (const AnalysisEntry& entry : document.analyses()) {
        if (entry.shown.visible && entry.shown.analysis->track.rows() > 0) {
            visible.push_back(&entry);
        }
    }
    return visible;
}

}  // namespace

CursorPanel::CursorPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      time_(new QLabel(this)),
      table_(new QTableWidget(this)) {
    time_->setContentsMargins(6, 2, 6, 2);
    time_->setWordWrap(true);
    time_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    table_->setRowCount(cursor_rows + 1);
    table_->setItemDelegate(new IndexDelegate(table_));
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::ContiguousSelection);
    table_->setIconSize({28, 14});
    table_->setWordWrap(true);
    // To their contents once all of them are there: by itself the table measures all of its texts
    // after each one.
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(time_);
    layout->addWidget(table_, 1);
    connect(&document_, &Document::analysesChanged, this, &CursorPanel::refresh);
    retranslate();
}

void CursorPanel::setTime(std::optional<double> time_s) {
    time_s_ = time_s;
    refresh();
}

void CursorPanel::setUnits(const DisplayUnits& units) {
    units_ = units;
    retranslate();
}

double CursorPanel::shownTime(const ShownAnalysis& first) const {
    return time_s_.value_or(first.analysis->track.time_s().front());
}

void CursorPanel::refresh() {
    const auto analyses = visibleAnalyses(document_);
    table_->setVisible(!analyses.empty());
    if (analyses.empty()) {
        time_->setText(tr("The values of every shown analysis at the mouse appear here."));
        return;
    }
    const double time_s = shownTime(analyses.front()->shown);
    time_->setText(tr("t = %1 s").arg(QLocale().toString(time_s, 'f', 5)));
    table_->setColumnCount(static_cast<int>(analyses.size()) + 1);
    QStringList names;
    for (const AnalysisEntry* entry : analyses) {
        names << entry->shown.name;
    }
    const QStringList short_names = distinctNames(names);
    bool any_flag = false;
    for (int column = 1; column < table_->columnCount(); ++column) {
        const AnalysisEntry& entry = *analyses[static_cast<std::size_t>(column - 1)];
        const Analysis& analysis = *entry.shown.analysis;
        const std::size_t row = nearestRow(analysis.track, time_s);
        auto* header = new QTableWidgetItem(curveIcon(entry.shown), short_names[column - 1]);
        header->setToolTip(
            plainTip(QStringLiteral("%1\n%2").arg(entry.shown.name, entry.shown.recording)));
        table_->setHorizontalHeaderItem(column, header);
        const auto set = [this, column](int line, const QString& text) {
            auto* item = new QTableWidgetItem(text);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(line, column, item);
        };
        const bool covered = covers(analysis, time_s);
        for (int line = 0; line < cursor_rows; ++line) {
            const SlowVariable variable = shown_slow_variables[static_cast<std::size_t>(line)];
            const Reading reading =
                covered ? readingAt(analysis, variable, row, units_) : Reading();
            QString text = valueText(reading.value, reading.sd);
            if (analyses.size() > 1) {
                text.replace(QStringLiteral(" ± "), QStringLiteral("\n± "));  // narrower columns
            }
            set(line, text);
        }
        const QString reason =
            covered ? flagsText(analysis.track.flags()[row]) : tr("no windows there");
        set(cursor_rows, reason);
        any_flag = any_flag || !reason.isEmpty();
    }
    // Columns are as wide as their numbers; a reason, which is longer, is wrapped in them.
    table_->setRowHidden(cursor_rows, true);
    table_->resizeColumnsToContents();
    table_->setRowHidden(cursor_rows, !any_flag);
    table_->resizeRowsToContents();
}

QString CursorPanel::tableText() const {
    const auto analyses = visibleAnalyses(document_);
    if (analyses.empty()) {
        return {};
    }
    const double time_s = shownTime(analyses.front()->shown);
    QStringList lines;
    QStringList head{tr("t = %1 s").arg(spreadsheetNumber(time_s))};
    for (const AnalysisEntry* entry : analyses) {
        head << entry->shown.name << tr("sd");
    }
    lines << head.join(QLatin1Char('\t'));
    for (const SlowVariable variable : shown_slow_variables) {
        const QString unit = displayUnit(variable, units_);
        const QString symbol = displaySymbol(variable, units_);
        QStringList cells{unit.isEmpty() ? symbol : QStringLiteral("%1, %2").arg(symbol, unit)};
        for (const AnalysisEntry* entry : analyses) {
            const Analysis& analysis = *entry->shown.analysis;
            const Reading reading =
                covers(analysis, time_s)
                    ? readingAt(analysis, variable, nearestRow(analysis.track, time_s), units_)
                    : Reading();
            cells << spreadsheetNumber(reading.value) << spreadsheetNumber(reading.sd);
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void CursorPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        refresh();  // the icons are drawn in the theme's colours
    }
}

void CursorPanel::retranslate() {
    table_->setAccessibleName(tr("Values at the cursor"));
    table_->setToolTip(
        tr("Of the window nearest to the mouse in the plots, with standard "
           "deviations"));
    table_->setColumnCount(std::max(1, table_->columnCount()));
    table_->setHorizontalHeaderItem(0, new QTableWidgetItem);
    for (int line = 0; line < cursor_rows; ++line) {
        const SlowVariable variable = shown_slow_variables[static_cast<std::size_t>(line)];
        const QString unit = displayUnit(variable, units_);
        const QString symbol = displaySymbol(variable, units_);
        auto* item = new QTableWidgetItem(
            unit.isEmpty() ? symbol : QStringLiteral("%1, %2").arg(symbol, unit));
        item->setToolTip(displayMeaning(variable));
        table_->setItem(line, 0, item);
    }
    table_->setItem(cursor_rows, 0, new QTableWidgetItem(tr("Reason")));
    refresh();
}

}  // namespace vybeg::ui
