#include "ui/settings/settings_panel.h"

#include "ui/document/document.h"
#include "ui/settings/settings_groups.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"
#include "ui/words/settings_text.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

// Of the panel, and in a window that wide or wider.
constexpr int least_width = 216;
constexpr int wide_window = 1920;
constexpr int least_width_there = 240;

// Differences between the plots of the current recording and the settings; empty where a visible
// analysis of it has the settings.
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

SettingsPanel::SettingsPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
    auto* content = new QWidget;
    sections_ = new QVBoxLayout(content);
    sections_->setContentsMargins(2, 4, 2, 2);
    sections_->setSpacing(8);

    algorithm_ = withName(new QComboBox(content), "algorithm");
    algorithm_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const Algorithm algorithm : all_algorithms) {
        algorithm_->addItem({}, static_cast<int>(algorithm));
    }
    sections_->addLayout(fill(new QHBoxLayout, {6, 0, 4, 4}, {algorithm_}));

    add(new WindowFields(content), QT_TR_NOOP("Window"), true);
    auto* range = new RangeFields(content);
    add(range, QT_TR_NOOP("Range"), true);
    add(new CarrierFields(content), QT_TR_NOOP("Carrier and filter"), true);
    add(new StartFields(content), QT_TR_NOOP("Start values"), false);
    auto* calibration = new CalibrationFields(content);
    add(calibration, QT_TR_NOOP("Calibration"), false);
    sections_->addStretch(1);

    scroll_ = scrolled(content, this);
    scroll_->setFocusPolicy(Qt::NoFocus);
    whenChanged(*content, {QEvent::LayoutRequest}, [this] { fitWidth(); });
    whenChanged(*this, {QEvent::Resize}, [this] {
        fitWidth();
        unfold();
    });

    stale_ = withName(new QLabel(this), "stale");
    stale_->setWordWrap(true);
    stale_->setContentsMargins(8, 0, 4, 0);
    live_ = withName(new QCheckBox(this), "live");
    analyse_ = withName(new QPushButton(this), "analyse");
    analyse_->setDefault(true);
    auto* start = fill(new QHBoxLayout, {8, 0, 4, 0}, {live_, {analyse_, 1}});
    fill(new QVBoxLayout(this), {0, 0, 0, 4}, {{scroll_, 1}, stale_, start});

    connect(algorithm_, &QComboBox::activated, this, [this](int index) {
        Settings settings = document_.settings();
        settings.algorithm = static_cast<Algorithm>(algorithm_->itemData(index).toInt());
        document_.setSettings(settings);
    });
    connect(range, &RangeFields::visibleRangeWanted, this, &SettingsPanel::visibleRangeWanted);
    connect(calibration, &CalibrationFields::toleranceEdited, &document_, &Document::setTolerance);
    connect(analyse_, &QPushButton::clicked, this, &SettingsPanel::analyse);
    connect(live_, &QCheckBox::toggled, &document_, &Document::setLive);
    connect(&document_, &Document::liveChanged, live_,
            [this] { live_->setChecked(document_.live()); });
    guardFromWheel(*this);
    // Queued, because a live analysis begins right after the change, and the line would appear for
    // an instant.
    for (const auto changed :
         {&Document::settingsChanged, &Document::analysesChanged,
          &Document::currentRecordingChanged, &Document::busyChanged, &Document::liveChanged}) {
        connect(&document_, changed, this, &SettingsPanel::showStaleness, Qt::QueuedConnection);
    }
    connect(&document_, &Document::settingsChanged, this, &SettingsPanel::refresh);
    connect(&document_, &Document::carrierChanged, this, &SettingsPanel::refresh);
    connect(&document_, &Document::currentRecordingChanged, this, &SettingsPanel::refresh);
    keepTranslated(*this, [this] { retranslate(); });
}

QWidget* SettingsPanel::addTool(QAction* action) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::StrongFocus);
    auto* row = new QWidget(this);
    fill(new QHBoxLayout(row), {8, 0, 4, 0}, {LayoutPart(1), button});
    layout()->addWidget(row);
    return row;
}

// The panel grows instead of cutting its fields, which change with the language and with what is
// open.
void SettingsPanel::fitWidth() {
    const int needed = scroll_->widget()->minimumSizeHint().width() +
                       scroll_->verticalScrollBar()->sizeHint().width();
    const int least = window()->width() < wide_window ? least_width : least_width_there;
    setFixedWidth(std::max(least, needed));
}

void SettingsPanel::add(SettingsFields* fields, const char* title, bool open) {
    auto* section = new Section(fields, sections_->parentWidget());
    section->setOpen(open);
    sections_->addWidget(section);
    groups_.push_back({section, fields, title, !open});
    connect(section, &Section::clicked, this, [this] { folded_by_person_ = true; });
    connect(fields, &SettingsFields::edited, this,
            [this](const Settings& settings) { document_.setSettings(settings); });
}

void SettingsPanel::analyse() {
    // F5 does not move the focus, so the edited field is committed here.
    if (auto* field = qobject_cast<NumberField*>(QApplication::focusWidget())) {
        field->commit();
    }
    for (const Group& group : groups_) {
        if (NumberField* field = group.fields->faulty()) {
            emit wanted();
            group.section->setOpen(true);
            folded_by_person_ = true;
            scroll_->ensureWidgetVisible(field);
            field->setFocus();
            return;
        }
    }
    document_.analyse();
}

void SettingsPanel::refresh() {
    SettingsState state{document_.settings(), document_.carrier(), std::nullopt, std::nullopt,
                        document_.tolerance()};
    const RecordingEntry* entry = document_.currentRecording();
    if (entry && entry->recording) {
        state.rate_hz = entry->recording->rate_hz;
        state.seconds = entry->recording->seconds();
    }
    const auto algorithm = static_cast<int>(state.settings.algorithm);
    algorithm_->setCurrentIndex(algorithm);
    algorithm_->setToolTip(algorithm_->itemData(algorithm, Qt::ToolTipRole).toString());
    for (const Group& group : groups_) {
        group.fields->setState(state);
        group.section->setNote(group.fields->summary());
    }
    analyse_->setEnabled(state.rate_hz.has_value());
}

// Sections that begin folded are open where the window has room for them, the last one first: what
// would be blank is in use. From a person's first click on, they stay as the person leaves them.
void SettingsPanel::unfold() {
    if (folded_by_person_) {
        return;
    }
    layout()->activate();
    const auto height = [this](const Group& group) {
        return group.fields->sizeHint().height() + sections_->spacing();
    };
    int room = scroll_->viewport()->height() - scroll_->widget()->sizeHint().height();
    for (const Group& group : groups_) {
        room += group.folds && group.section->isOpen() ? height(group) : 0;
    }
    for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) {
        if (group->folds) {
            group->section->setOpen(height(*group) <= room);
            room -= group->section->isOpen() ? height(*group) : 0;
        }
    }
}

void SettingsPanel::showStaleness() {
    const bool coming = document_.live() && document_.busy();
    const QStringList differences = coming ? QStringList() : staleness(document_);
    stale_->setVisible(!differences.isEmpty());
    stale_->setText(tr("The plots are older than these settings. Changed since: %1.")
                        .arg(differences.join(QStringLiteral(", "))));
}

void SettingsPanel::retranslate() {
    algorithm_->setAccessibleName(tr("Algorithm"));
    for (std::size_t i = 0; i < all_algorithms.size(); ++i) {
        const int row = static_cast<int>(i);
        algorithm_->setItemText(row, algorithmText(all_algorithms[i]));
        algorithm_->setItemData(row, richTip(algorithmTip(all_algorithms[i])), Qt::ToolTipRole);
    }
    for (const Group& group : groups_) {
        group.section->setTitle(tr(group.title));
    }
    analyse_->setText(tr("Keep"));
    analyse_->setToolTip(
        tr("Analyse the current recording with these settings and keep the analysis (F5)"));
    showStaleness();
    live_->setText(tr("Live"));
    live_->setToolTip(
        richTip(tr("Every change of a setting shows at once: first in the visible part of the "
                   "plots, then in the rest, always in the same analysis. What is to stay for "
                   "comparison is kept by Keep, F5 (Ctrl+L)")));
    refresh();
}

}  // namespace vybeg::ui

#include "moc_settings_panel.cpp"
