#include "ui/panels/stale_mark.h"

#include "ui/document/document.h"
#include "ui/words/settings_text.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace vybeg::ui {

namespace {

// Differences between the plots of the current recording and the panel; empty without differences.
QStringList staleness(const Document& document) {
    const RecordingEntry* current = document.currentRecording();
    QStringList newest;
    for (const AnalysisEntry& entry : document.analyses()) {
        if (current && entry.recording_id == current->id && entry.shown.visible) {
            newest = changedGroups(entry.requested, document.settings());
            if (newest.isEmpty()) {
                return {};
            }
        }
    }
    return newest;
}

}  // namespace

StaleMark::StaleMark(const Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      text_(new QLabel(this)),
      analyse_(new QPushButton(this)) {
    text_->setWordWrap(true);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->addWidget(text_, 1);
    layout->addWidget(analyse_);
    connect(analyse_, &QPushButton::clicked, this, &StaleMark::analyseWanted);
    // Queued, because a live analysis begins right after the change, and the mark would appear for
    // an instant.
    for (const auto changed :
         {&Document::settingsChanged, &Document::analysesChanged,
          &Document::currentRecordingChanged, &Document::busyChanged, &Document::liveChanged}) {
        connect(&document_, changed, this, &StaleMark::refresh, Qt::QueuedConnection);
    }
    refresh();
}

QString StaleMark::text() const {
    return text_->text();
}

void StaleMark::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

void StaleMark::refresh() {
    const bool coming = document_.live() && document_.busy();
    const QStringList differences = coming ? QStringList() : staleness(document_);
    setVisible(!differences.isEmpty());
    text_->setText(tr("The plots are older than the Analysis panel. Changed since: %1.")
                       .arg(differences.join(QStringLiteral(", "))));
    analyse_->setText(tr("Analyse"));
    analyse_->setToolTip(tr("Analyse the current recording with the settings of the panel (F5)"));
}

}  // namespace vybeg::ui
