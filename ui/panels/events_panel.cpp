#include "ui/panels/events_panel.h"

#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace vybeg::ui {

namespace {

// Limit of rows in the list; the title shows the number of events.
constexpr std::size_t most_events = 2000;

}  // namespace

EventsPanel::EventsPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), title_(new QLabel(this)), list_(new QTreeWidget(this)) {
    title_->setContentsMargins(6, 2, 6, 2);
    title_->setWordWrap(true);
    title_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setColumnCount(2);
    list_->setItemDelegateForColumn(1, new IndexDelegate(list_));
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setResizeContentsPrecision(0);  // of the visible rows
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(title_);
    layout->addWidget(list_, 1);
    const auto choose = [this](const QTreeWidgetItem* item) {
        emit eventChosen(item->data(0, Qt::UserRole).toDouble(),
                         item->data(1, Qt::UserRole).toDouble());
    };
    connect(list_, &QTreeWidget::itemClicked, this, choose);
    connect(list_, &QTreeWidget::itemActivated, this, choose);
    retranslate();
}

void EventsPanel::setAnalysis(AnalysisId analysis_id) {
    analysis_id_ = analysis_id;
    refresh();
}

void EventsPanel::refresh() {
    const AnalysisEntry* entry = document_.analysis(analysis_id_);
    if (listed_ != (entry ? entry->shown.analysis : nullptr)) {
        fillList(entry);
    }
    list_->setVisible(entry && !entry->events.empty());
    if (!entry) {
        title_->setText(
            tr("Axis crossings, gaps and windows without convergence of the chosen analysis appear "
               "here."));
    } else if (entry->partial()) {
        title_->setText(
            tr("%1: events are looked for when all windows are there.").arg(entry->shown.name));
    } else if (entry->events.empty()) {
        title_->setText(tr("%1: no axis crossings, no gaps.").arg(entry->shown.name));
    } else {
        title_->setText(tr("%1: %n event(s)", nullptr, static_cast<int>(entry->events.size()))
                            .arg(entry->shown.name));
    }
}

void EventsPanel::fillList(const AnalysisEntry* entry) {
    list_->clear();
    listed_.reset();
    if (!entry) {
        return;
    }
    listed_ = entry->shown.analysis;
    const QLocale locale;
    QList<QTreeWidgetItem*> items;
    for (std::size_t i = 0; i < std::min(entry->events.size(), most_events); ++i) {
        const Event& event = entry->events[i];
        auto* item = new QTreeWidgetItem({locale.toString(event.time_s, 'f', 4), eventText(event)});
        item->setData(0, Qt::UserRole, event.time_s);
        item->setData(1, Qt::UserRole, event.seconds);
        item->setTextAlignment(0, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(1, richTip(item->text(1)));
        items << item;
    }
    list_->addTopLevelItems(items);
}

void EventsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void EventsPanel::retranslate() {
    list_->setAccessibleName(tr("Events"));
    list_->setHeaderLabels({tr("t, s"), tr("What")});
    fillList(document_.analysis(analysis_id_));
    refresh();
}

}  // namespace vybeg::ui
