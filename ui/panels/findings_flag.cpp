#include "ui/panels/findings_flag.h"

#include "ui/panels/ledger_rows.h"
#include "ui/widgets/check_list.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

// Limit of rows in the list; the title shows the number of events.
constexpr std::size_t most_events = 2000;

}  // namespace

FindingsFlag::FindingsFlag(Document& document, QWidget* parent)
    : QToolButton(parent),
      document_(document),
      popup_(new QFrame(this, Qt::Popup)),
      check_(new CheckList(popup_)),
      title_(new QLabel(popup_)),
      events_(new QTreeWidget(popup_)) {
    setObjectName(QStringLiteral("findings"));
    setAutoRaise(true);
    setFocusPolicy(Qt::StrongFocus);
    popup_->setFrameShape(QFrame::StyledPanel);
    popup_->setFixedSize(480, 400);
    title_->setContentsMargins(6, 2, 6, 2);
    title_->setTextFormat(Qt::PlainText);
    title_->setWordWrap(true);
    events_->setRootIsDecorated(false);
    events_->setUniformRowHeights(true);
    events_->setColumnCount(2);
    events_->setItemDelegateForColumn(1, new IndexDelegate(events_));
    events_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    events_->header()->setResizeContentsPrecision(0);  // of the visible rows
    fill(new QVBoxLayout(popup_), {2, 2, 2, 2}, 2, {{check_, 2}, title_, {events_, 3}});
    const auto go = [this](double time_s, double seconds) {
        popup_->hide();
        emit placeChosen(time_s, seconds);
    };
    const auto choose = [go](const QTreeWidgetItem* item) {
        go(item->data(0, Qt::UserRole).toDouble(), item->data(1, Qt::UserRole).toDouble());
    };
    connect(check_, &CheckList::placeChosen, this, go);
    connect(events_, &QTreeWidget::itemClicked, this, choose);
    connect(events_, &QTreeWidget::itemActivated, this, choose);
    connect(this, &QToolButton::clicked, this, &FindingsFlag::open);
    for (const auto changed : {&Document::recordingsChanged, &Document::currentRecordingChanged,
                               &Document::analysesChanged}) {
        connect(&document_, changed, this, &FindingsFlag::refresh);
    }
    connect(&document_, &Document::recordingChanged, this, &FindingsFlag::refresh);
    keepTranslated(*this, [this] { retranslate(); });
}

void FindingsFlag::setAnalysis(AnalysisId analysis_id) {
    analysis_id_ = analysis_id;
    refresh();
}

void FindingsFlag::open() {
    refresh();
    popup_->move(mapToGlobal(QPoint(0, height())));
    popup_->show();
}

void FindingsFlag::refresh() {
    const RecordingEntry* recording = document_.currentRecording();
    const AnalysisEntry* entry = document_.analysis(analysis_id_);
    setVisible(recording && recording->recording);
    if (!recording || !recording->recording) {
        return;
    }
    std::size_t count = entry ? entry->events.size() : 0;
    if (recording->faults) {
        check_->setFindings(recording->faults->findings, recording->recording->rate_hz);
        count += static_cast<std::size_t>(findingsIn(recording->faults->findings));
    } else {
        check_->setRunning();
    }
    setText(QStringLiteral("⚑ %1").arg(QLocale().toString(static_cast<qulonglong>(count))));
    QFont font = this->font();
    font.setBold(hasFindings(*recording));
    setFont(font);
    if (listed_ != (entry ? entry->shown.analysis : nullptr)) {
        fillEvents(entry);
    }
    events_->setVisible(entry && !entry->events.empty());
    if (!entry) {
        title_->setText(
            tr("Axis crossings, gaps and windows without convergence of the chosen "
               "analysis appear here."));
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

void FindingsFlag::fillEvents(const AnalysisEntry* entry) {
    events_->clear();
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
    events_->addTopLevelItems(items);
}

void FindingsFlag::retranslate() {
    setAccessibleName(tr("Findings and events"));
    setToolTip(
        tr("Findings of the recording check and events of the chosen analysis; a click in "
           "their lists goes there"));
    events_->setAccessibleName(tr("Events"));
    events_->setHeaderLabels({tr("t, s"), tr("What")});
    fillEvents(document_.analysis(analysis_id_));
    refresh();
}

}  // namespace vybeg::ui
