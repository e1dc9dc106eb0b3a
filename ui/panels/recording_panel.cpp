#include "ui/panels/recording_panel.h"

#include "ui/panels/recording_drag.h"
#include "ui/widgets/check_list.h"
#include "ui/words/format_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/short_names.h"

#include <QAction>
#include <QDir>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

// As high as its wrapped text: a form layout gives the height of another width where a scroll bar
// comes or goes.
class WrappedLabel : public QLabel {
public:
    using QLabel::QLabel;

protected:
    void resizeEvent(QResizeEvent* event) override {
        QLabel::resizeEvent(event);
        setMinimumHeight(std::max(0, heightForWidth(width())));
    }
};

bool isWorthAWarning(const Diagnostic& diagnostic) {
    return severity(diagnostic.kind) != Severity::note;
}

// Allows line breaks anywhere in a long text without spaces (a path, a hash).
QString breakable(const QString& text) {
    QString broken;
    for (const QChar character : text) {
        broken += character;
        broken += QChar(0x200b);
    }
    return broken;
}

QString channelText(const Recording& recording, int number) {
    const Channel& channel = recording.channels.at(static_cast<std::size_t>(number - 1));
    const QString name = QString::fromStdString(channel.name);
    // The name is omitted if the file names its channels by number.
    QString text = RecordingPanel::tr("%1 of %2").arg(number).arg(recording.channels.size());
    if (name != QString::number(number)) {
        text = QStringLiteral("%1 (%2)").arg(name, text);
    }
    return channel.unit.empty()
               ? text
               : QStringLiteral("%1, %2").arg(text, QString::fromStdString(channel.unit));
}

}  // namespace

RecordingPanel::RecordingPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), list_(new RecordingDragList(this)) {
    list_->setIconSize({16, 16});
    list_->setItemDelegate(new NameDelegate(list_));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
    close_ = new QAction(this);
    close_->setShortcut(QKeySequence::Delete);
    close_->setShortcutContext(Qt::WidgetShortcut);
    reopen_ = new QAction(this);
    add_to_set_ = new QAction(this);
    add_to_set_->setShortcut(Qt::Key_Insert);
    add_to_set_->setShortcutContext(Qt::WidgetShortcut);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->addActions({add_to_set_, reopen_, close_});

    auto* content = new QWidget;
    info_ = new QFormLayout(content);
    info_->setContentsMargins(8, 4, 4, 4);
    info_->setHorizontalSpacing(8);
    info_->setVerticalSpacing(2);
    info_->setRowWrapPolicy(QFormLayout::DontWrapRows);
    for (int row = 0; row < row_count; ++row) {
        auto* name = new QLabel(content);
        name->setForegroundRole(QPalette::PlaceholderText);
        auto* value = new WrappedLabel(content);
        value->setWordWrap(true);
        value->setTextFormat(Qt::PlainText);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        name->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        info_->addRow(name, value);
        names_.push_back(name);
        values_.push_back(value);
    }
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    layout->addWidget(list_);
    layout->addWidget(scroll, 3);
    check_ = new CheckList(this);
    layout->addWidget(check_, 2);
    connect(check_, &CheckList::placeChosen, this, &RecordingPanel::placeChosen);

    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0) {
            document_.setCurrentRecording(recordingOf(*list_->item(row)));
        }
    });
    connect(close_, &QAction::triggered, this, [this] {
        if (const QListWidgetItem* item = list_->currentItem()) {
            document_.closeRecording(recordingOf(*item));
        }
    });
    connect(add_to_set_, &QAction::triggered, this,
            [this] { document_.sets().addToCurrent(list_->selectedRecordings()); });
    connect(reopen_, &QAction::triggered, this, [this] {
        if (const RecordingEntry* entry = document_.currentRecording()) {
            emit reopenWanted(entry->path, entry->options);
        }
    });
    connect(&document_, &Document::recordingsChanged, this, &RecordingPanel::rebuildList);
    connect(&document_, &Document::currentRecordingChanged, this, &RecordingPanel::rebuildList);
    connect(&document_, &Document::recordingChanged, this, &RecordingPanel::refreshRow);
    connect(&document_, &Document::carrierChanged, this, &RecordingPanel::refreshInfo);
    retranslate();
}

void RecordingPanel::rebuildList() {
    const QSignalBlocker blocker(list_);
    // Existing items are kept, because one of them may be about to be dragged.
    list_->setRecordings(document_.recordings());
    int row = 0;
    for (const RecordingEntry& entry : document_.recordings()) {
        QListWidgetItem* item = list_->item(row++);
        showRow(*item, entry);
        if (document_.isCurrent(entry.id)) {
            if (list_->currentItem() != item) {
                list_->setCurrentItem(item, QItemSelectionModel::ClearAndSelect);
            }
            list_->scrollToItem(item);
        }
    }
    // As high as its rows, from two to six of them.
    constexpr int most_rows = 6;
    const int rows = std::clamp(list_->count(), 2, most_rows);
    const int row_height = std::max(list_->sizeHintForRow(0), fontMetrics().height());
    list_->setFixedHeight(rows * row_height + 2 * list_->frameWidth());
    const bool any = document_.currentRecording() != nullptr;
    close_->setEnabled(any);
    reopen_->setEnabled(any);
    add_to_set_->setEnabled(any);
    refreshInfo();
}

void RecordingPanel::showRow(QListWidgetItem& item, const RecordingEntry& entry) {
    item.setText(entry.recording ? entry.name : tr("%1 (opening)").arg(entry.name));
    item.setToolTip(plainTip(QDir::toNativeSeparators(entry.path)));
    const bool doubtful =
        entry.faults
            ? std::ranges::any_of(entry.faults->findings, isWorthAWarning)
            : entry.recording && std::ranges::any_of(entry.recording->diagnostics, isWorthAWarning);
    item.setIcon(doubtful ? style()->standardIcon(QStyle::SP_MessageBoxWarning) : QIcon());
}

void RecordingPanel::refreshRow(RecordingId id) {
    const auto& recordings = document_.recordings();
    const auto entry = std::ranges::find(recordings, id, &RecordingEntry::id);
    QListWidgetItem* item = list_->item(static_cast<int>(entry - recordings.begin()));
    if (item) {
        const QSignalBlocker blocker(list_);
        showRow(*item, *entry);
        if (document_.isCurrent(id)) {
            refreshInfo();
        }
    }
}

void RecordingPanel::refreshInfo() {
    const RecordingEntry* entry = document_.currentRecording();
    const bool known = entry && entry->recording;
    info_->parentWidget()->setVisible(known);
    check_->setVisible(known);
    if (!known) {
        return;
    }
    const Recording& recording = *entry->recording;
    const QLocale locale;
    const auto set = [this](Row row, const QString& text) {
        values_[row]->setText(text);
        names_[row]->setVisible(!text.isEmpty());
        values_[row]->setVisible(!text.isEmpty());
    };
    set(file, breakable(QDir::toNativeSeparators(entry->path)));
    set(format, formatText(recording.format));
    const QString hertz = locale.toString(recording.rate_hz, 'g', 10);
    switch (recording.rate_from) {
        case RateOrigin::file: set(rate, tr("%1 Hz, from the file").arg(hertz)); break;
        case RateOrigin::time_column:
            set(rate, tr("%1 Hz, from the time column").arg(hertz));
            break;
        case RateOrigin::option: set(rate, tr("%1 Hz, typed").arg(hertz)); break;
    }
    set(length, tr("%1 s, %n sample(s)", nullptr, static_cast<int>(recording.frames()))
                    .arg(locale.toString(recording.seconds(), 'g', 8)));
    set(channels, QStringLiteral("C: %1\nD: %2")
                      .arg(channelText(recording, recording.channel_c),
                           channelText(recording, recording.channel_d)));
    set(start, QString::fromStdString(recording.start));
    set(carrier, entry->f0_hz ? tr("%1 Hz").arg(locale.toString(*entry->f0_hz, 'f', 4))
                              : QStringLiteral("…"));
    set(sha256, entry->sha256.isEmpty() ? QStringLiteral("…") : breakable(entry->sha256));
    if (entry->faults) {
        check_->setFindings(entry->faults->findings, recording.rate_hz);
    } else {
        check_->setRunning();
    }
}

void RecordingPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void RecordingPanel::retranslate() {
    list_->setAccessibleName(tr("Open recordings"));
    list_->setToolTip(
        tr("The chosen recording is analysed. Delete closes, Insert adds to the set; "
           "drag recordings into a set, too"));
    close_->setText(tr("Close recording"));
    reopen_->setText(tr("Import again…"));
    add_to_set_->setText(tr("Add to the set of the resonator"));
    const QString texts[row_count] = {tr("File"),     tr("Format"), tr("Rate"), tr("Length"),
                                      tr("Channels"), tr("Start"),  tr("f₀"),   tr("SHA-256")};
    for (int row = 0; row < row_count; ++row) {
        names_[static_cast<std::size_t>(row)]->setText(texts[row]);
        values_[static_cast<std::size_t>(row)]->setAccessibleName(texts[row]);
    }
    rebuildList();
}

}  // namespace vybeg::ui
