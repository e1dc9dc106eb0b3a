#include "ui/panels/findings_flag.h"

#include "core/base/diagnostic.h"
#include "core/base/number_text.h"
#include "core/residuals/find_residuals.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QHeaderView>
#include <QLabel>
#include <QTextBrowser>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

const QString fold_link = QStringLiteral("more");
const QString remedy_link = QStringLiteral("remedy");
// Limit of rows in the list of events; its title shows their number.
constexpr std::size_t most_events = 2000;

// How many of them are worse than a note, as on lines passed over.
int findingsIn(const std::vector<Diagnostic>& diagnostics) {
    return static_cast<int>(std::ranges::count_if(diagnostics, [](const Diagnostic& diagnostic) {
        return severity(diagnostic.kind) != Severity::note;
    }));
}

// What the settings can do about a finding: words of a button, and the settings with it.
struct Remedy {
    QString words;
    Settings settings;
};

std::optional<Remedy> remedyOf(const Diagnostic& finding, const RecordingEntry& entry,
                               Settings settings) {
    switch (finding.kind) {
        case DiagnosticKind::offset:
            if (settings.calibration.offset_auto) {
                return std::nullopt;
            }
            settings.calibration.offset_auto = true;
            return Remedy{FindingsFlag::tr("Take the offsets from the signals"), settings};
        case DiagnosticKind::mains: {
            SignalSettings about = settings;
            about.f0_hz = settings.f0_hz ? settings.f0_hz : entry.f0_hz;
            const auto line_hz = parse_number(finding.args.front().text);
            settings.filter = about.f0_hz && line_hz
                                  ? filter_without(*line_hz, about, *entry.recording)
                                  : std::nullopt;
            if (!settings.filter) {
                return std::nullopt;
            }
            return Remedy{FindingsFlag::tr("Filter %1 … %2 Hz")
                              .arg(numberLabel(settings.filter->low_hz, 0),
                                   numberLabel(settings.filter->high_hz, 0)),
                          settings};
        }
        case DiagnosticKind::start_transient: {
            const double end_s =
                static_cast<double>(finding.first_frame + finding.count) / entry.recording->rate_hz;
            if (settings.from_s.value_or(0) >= end_s) {
                return std::nullopt;
            }
            settings.from_s = end_s;
            return Remedy{FindingsFlag::tr("Analyse from %1 s").arg(shortNumberText(end_s, 3)),
                          settings};
        }
        default: return std::nullopt;
    }
}

}  // namespace

bool hasFindings(const RecordingEntry& entry) {
    return entry.faults ? findingsIn(entry.faults->findings) > 0
                        : entry.recording && findingsIn(entry.recording->diagnostics) > 0;
}

CheckList::CheckList(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), list_(new QTextBrowser(this)) {
    title_->setWordWrap(true);
    title_->setContentsMargins(6, 2, 6, 2);
    list_->setOpenLinks(false);
    list_->setFrameShape(QFrame::NoFrame);
    fill(new QVBoxLayout(this), {}, 0, {title_, {list_, 1}});
    connect(list_, &QTextBrowser::anchorClicked, this, &CheckList::choose);
    keepTranslated(*this, [this] { refresh(); });
    // The HTML keeps the colour that links had.
    whenChanged(*this, {QEvent::PaletteChange}, [this] { refresh(); });
}

void CheckList::setRunning() {
    running_ = true;
    findings_.clear();
    refresh();
}

void CheckList::setFindings(const std::vector<Diagnostic>& findings, double rate_hz,
                            const QStringList& remedies) {
    if (!running_ && findings == findings_ && rate_hz == rate_hz_ && remedies == remedies_) {
        return;  // keeps the scroll position of the list
    }
    running_ = false;
    findings_ = findings;
    remedies_ = remedies;
    rate_hz_ = rate_hz;
    refresh();
}

void CheckList::refresh() {
    list_->setAccessibleName(tr("Recording check"));
    list_->setVisible(!findings_.empty());
    if (running_) {
        title_->setText(tr("Recording check: reading…"));
        return;
    }
    const int found = findingsIn(findings_);  // notes are in the list all the same
    title_->setText(found == 0 ? tr("Recording check: nothing found")
                               : tr("Recording check: %n finding(s)", nullptr, found));
    const std::vector<Finding> findings = findings_of(findings_);
    QString rows;
    for (std::size_t k = 0; k < findings.size() && (open_ || k < most_shown); ++k) {
        const Finding& finding = findings[k];
        rows += rowOf(finding.diagnostic,
                      open_ ? diagnosticText(finding.diagnostic) : findingText(finding));
        for (std::size_t i = 0; open_ && i < finding.more.size(); ++i) {
            rows += rowOf(finding.more[i], diagnosticText(finding.more[i]));
        }
    }
    std::size_t hidden = 0;
    for (std::size_t k = 0; k < findings.size(); ++k) {
        hidden += findings[k].more.size() + (k < most_shown ? 0 : 1);
    }
    if (hidden > 0) {
        rows += QStringLiteral("<tr><td></td><td><a href=\"%1\">%2</a></td></tr>")
                    .arg(fold_link, open_ ? tr("Only the worst") : moreText(hidden));
    }
    list_->setHtml(QStringLiteral("<table cellspacing=\"3\">%1</table>").arg(rows));
}

// The place of a finding is its link; one without a place has none.
QString CheckList::rowOf(const Diagnostic& finding, const QString& text) const {
    QString place;
    if (finding.first_frame >= 0) {
        const QString time = numberLabel(seconds(finding.first_frame), 4);
        place = QStringLiteral("<a href=\"%1,%2\">%3</a>")
                    .arg(finding.first_frame)
                    .arg(finding.count)
                    .arg(tr("%1 s").arg(time));
    }
    QString words = text.toHtmlEscaped();
    const auto at = std::ranges::find(findings_, finding) - findings_.begin();
    if (const QString remedy = remedies_.value(at); !remedy.isEmpty()) {
        words += QStringLiteral("<br><a href=\"%1,%2\">%3</a>")
                     .arg(remedy_link)
                     .arg(at)
                     .arg(remedy.toHtmlEscaped());
    }
    return QStringLiteral("<tr><td align=\"right\">%1</td><td>%2</td></tr>").arg(place, words);
}

void CheckList::choose(const QUrl& link) {
    if (link.toString() == fold_link) {
        open_ = !open_;
        refresh();
        return;
    }
    const QStringList place = link.toString().split(QLatin1Char(','));
    if (place.front() == remedy_link) {
        emit remedyWanted(place.value(1).toInt());
        return;
    }
    emit placeChosen(seconds(place.value(0).toLongLong()), seconds(place.value(1).toLongLong()));
}

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
    connect(check_, &CheckList::remedyWanted, this, [this](int finding) {
        const RecordingEntry& recording = *document_.currentRecording();
        const auto& findings = recording.faults->findings;
        if (const auto found = remedyOf(findings.at(static_cast<std::size_t>(finding)), recording,
                                        document_.settings())) {
            document_.setSettings(found->settings);
        }
    });
    connect(events_, &QTreeWidget::itemClicked, this, choose);
    connect(events_, &QTreeWidget::itemActivated, this, choose);
    connect(this, &QToolButton::clicked, this, [this] {
        refresh();
        popup_->move(mapToGlobal(QPoint(0, height())));
        popup_->show();
    });
    for (const auto changed : {&Document::recordingsChanged, &Document::currentRecordingChanged,
                               &Document::analysesChanged, &Document::settingsChanged}) {
        connect(&document_, changed, this, &FindingsFlag::refresh);
    }
    connect(&document_, &Document::recordingChanged, this, &FindingsFlag::refresh);
    keepTranslated(*this, [this] { retranslate(); });
}

void FindingsFlag::setAnalysis(AnalysisId analysis_id) {
    analysis_id_ = analysis_id;
    refresh();
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
        QStringList remedies;
        for (const Diagnostic& finding : recording->faults->findings) {
            const auto found = remedyOf(finding, *recording, document_.settings());
            remedies << (found ? found->words : QString());
        }
        check_->setFindings(recording->faults->findings, recording->recording->rate_hz, remedies);
        count += static_cast<std::size_t>(findingsIn(recording->faults->findings));
    } else {
        check_->setRunning();
    }
    setText(QStringLiteral("⚑ %1").arg(countLabel(static_cast<std::int64_t>(count))));
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
    QList<QTreeWidgetItem*> items;
    for (std::size_t i = 0; i < std::min(entry->events.size(), most_events); ++i) {
        const Event& event = entry->events[i];
        auto* item = new QTreeWidgetItem({numberLabel(event.time_s, 4), eventText(event)});
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

#include "moc_findings_flag.cpp"
