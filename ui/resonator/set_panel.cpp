#include "ui/resonator/set_panel.h"

#include "core/analysis/setting_table.h"
#include "ui/panels/file_list.h"
#include "ui/resonator/resonator_text.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

// What was told of logs, in the words of a measurement list.
QString logText(const LogChoice& logs) {
    QStringList told;
    for (const SettingRow<LogChoice>& row : log_settings()) {
        if (const std::string text = row.text(logs); text != not_set) {
            told << QString::fromStdString(row.name) + QLatin1Char(' ') +
                        QString::fromStdString(text);
        }
    }
    return told.join(QStringLiteral(", "));
}

}  // namespace

QString setName(const Document& document, const RecordingSet& set) {
    if (!set.name.isEmpty()) {
        return set.name;
    }
    if (isOfLogs(set)) {
        return QCoreApplication::translate("SetPanel", "Logs %1").arg(set.number);
    }
    if (set.recordings.size() == 1) {
        return QFileInfo(document.recording(set.recordings.front())->path).completeBaseName();
    }
    return QCoreApplication::translate("SetPanel", "Set %1").arg(set.number);
}

SetPanel::SetPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      sets_(withName(new QComboBox(this), "sets")),
      add_(new QToolButton(this)),
      remove_(new QToolButton(this)),
      members_(withName(new FileList(6, this), "members")),
      listed_(withName(new QLabel(this), "listed")),
      logs_(withName(new QPushButton(this), "editLogs")),
      model_label_(new QLabel(this)),
      model_(withName(new QComboBox(this), "model")),
      identify_(withName(new QPushButton(this), "identify")) {
    sets_->setEditable(true);
    sets_->setInsertPolicy(QComboBox::NoInsert);
    sets_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    add_->setText(QStringLiteral("+"));
    remove_->setText(QStringLiteral("−"));
    listed_->setWordWrap(true);
    model_label_->setBuddy(model_);
    model_->addItems({QString(), QString(), QString()});

    auto* names = fill(new QHBoxLayout, {{sets_, 1}, add_, remove_});
    auto* choices = fill(new QHBoxLayout, {model_label_, {model_, 1}});
    fill(new QVBoxLayout(this), {6, 4, 6, 2}, 3,
         {names, members_, listed_, logs_, choices, identify_});

    connect(sets_, &QComboBox::activated, this, [this](int row) {
        document_.sets().setCurrent(static_cast<SetId>(sets_->itemData(row).toInt()));
    });
    connect(sets_->lineEdit(), &QLineEdit::editingFinished, this, [this] {
        const RecordingSet* set = document_.sets().current();
        if (set && sets_->lineEdit()->isModified()) {
            sets_->lineEdit()->setModified(false);
            document_.sets().rename(set->id, sets_->currentText());
        }
    });
    connect(add_, &QToolButton::clicked, this, [this] { document_.sets().add(); });
    connect(remove_, &QToolButton::clicked, this,
            [this] { document_.sets().remove(document_.sets().current()->id); });
    members_->setHint([this] {
        const RecordingSet* set = document_.sets().current();
        return set && isOfLogs(*set)
                   ? tr("Drop logs of the resonator here")
                   : tr("Drop recordings of one resonator here, best started at four angles");
    });
    connect(members_, &FileList::dropped, &document_, &Document::openIntoSet);
    connect(members_, &FileList::removalWanted, this, [this](const QStringList& chosen) {
        const RecordingSet* set = document_.sets().current();
        if (set && isOfLogs(*set)) {
            removeLogs(*set, chosen);
            return;
        }
        for (QListWidgetItem* item : members_->selectedItems()) {
            item->setCheckState(Qt::Unchecked);
        }
    });
    connect(logs_, &QPushButton::clicked, this,
            [this] { document_.askForLogs(document_.sets().current()->id); });
    connect(members_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        const auto id = static_cast<RecordingId>(item->data(Qt::UserRole).toInt());
        // Queued, because the response of the document fills the list again.
        QMetaObject::invokeMethod(
            this,
            [this, id, in = item->checkState() == Qt::Checked] {
                if (in) {
                    document_.sets().addToCurrent({id});
                } else if (const RecordingSet* set = document_.sets().current()) {
                    document_.sets().removeFrom(set->id, {id});
                }
            },
            Qt::QueuedConnection);
    });
    connect(model_, &QComboBox::activated, this, [this](int index) {
        const RecordingSet* set = document_.sets().current();
        document_.sets().setModel(set ? set->id : document_.sets().add(),
                                  static_cast<FitOptions::Model>(index));
    });
    connect(identify_, &QPushButton::clicked, &document_.sets(), &SetStore::identify);
    connect(&document_.sets(), &SetStore::changed, this, &SetPanel::refresh);
    connect(&document_, &Document::recordingsChanged, this, &SetPanel::refresh);
    connect(&document_, &Document::recordingChanged, this, &SetPanel::refresh);
    connect(&document_, &Document::currentRecordingChanged, this, &SetPanel::refresh);
    keepTranslated(*this, [this] { retranslate(); });
}

void SetPanel::refresh() {
    const RecordingSet* set = document_.sets().current();
    const bool typing = sets_->lineEdit()->hasFocus() && sets_->lineEdit()->isModified();
    if (!typing) {
        const QSignalBlocker blocker(sets_);
        sets_->clear();
        for (const RecordingSet& each : document_.sets().all()) {
            sets_->addItem(setName(document_, each), number(each.id));
        }
        sets_->setCurrentIndex(set ? sets_->findData(number(set->id)) : -1);
    }
    sets_->setEnabled(set != nullptr);
    remove_->setEnabled(set != nullptr);
    refreshMembers(set);
    const bool of_logs = set && isOfLogs(*set);
    listed_->setVisible(set && set->listed);
    QStringList facts;
    if (of_logs) {
        facts << tr("Logs, read with %1.").arg(logText(set->listed->settings.logs));
    }
    facts << (of_logs && set->listed->by_panel
                  ? tr("Calibration and tolerances are those of the panel Analysis, which stands "
                       "beside the page Tracks.")
                  : tr("Settings and conditions are those of the measurement list; the panel "
                       "Analysis does not change them."));
    listed_->setText(facts.join(QLatin1Char(' ')));
    logs_->setVisible(of_logs);
    model_->setCurrentIndex(set ? static_cast<int>(set->model) : 0);
    identify_->setEnabled(document_.sets().canIdentify());
}

void SetPanel::removeLogs(const RecordingSet& set, const QStringList& paths) {
    MeasurementSet other = document_.sets().measured(set);
    std::vector<SignalSettings> signal;
    std::vector<RecordingRef> left;
    for (std::size_t k = 0; k < other.recordings.size(); ++k) {
        const RecordingRef& log = other.recordings[k];
        if (!paths.contains(QString::fromStdU16String(log.path.u16string()))) {
            signal.push_back(other.settings.signal_of(k));
            left.push_back(log);
        }
    }
    if (!other.settings.of_recordings.empty()) {
        other.settings.of_recordings = std::move(signal);
    }
    other.recordings = std::move(left);
    document_.sets().setLogs(set.id, other);
}

// All open recordings; those of the set are checked. Of a set of logs these, as they are.
void SetPanel::refreshMembers(const RecordingSet* set) {
    const QSignalBlocker quiet(members_);
    const int row = members_->currentRow();
    members_->clear();
    const auto* listed = set && set->listed ? &*set->listed : nullptr;
    const auto add = [this](const QString& name, const QString& path, const QStringList& told) {
        auto* item = new QListWidgetItem(name, members_);
        item->setToolTip(
            plainTip((QStringList{QDir::toNativeSeparators(path)} + told).join(QLatin1Char('\n'))));
        return item;
    };
    if (set && isOfLogs(*set)) {
        for (const auto& member : listed->members) {
            const RecordingRef& log = member.second.row;
            const QString path = QString::fromStdU16String(log.path.u16string());
            add(QString::fromStdString(log.name()), path, conditionsText(log))
                ->setData(Qt::UserRole, path);
        }
    } else {
        for (const RecordingEntry& entry : document_.recordings()) {
            const bool has_row = listed && listed->members.contains(entry.id);
            auto* item =
                add(entry.name, entry.path,
                    has_row ? conditionsText(listed->members.at(entry.id).row) : QStringList());
            item->setData(Qt::UserRole, number(entry.id));
            const bool in = set && std::ranges::count(set->recordings, entry.id) > 0;
            item->setCheckState(in ? Qt::Checked : Qt::Unchecked);
        }
    }
    members_->setCurrentRow(std::min(row, members_->count() - 1));
    members_->updateGeometry();
}

void SetPanel::retranslate() {
    setWords(
        *sets_, tr("Set of recordings"),
        tr("Recordings of one resonator that are identified together; type here to name them"));
    setWords(*add_, tr("New set"), tr("New set"));
    setWords(*remove_, tr("Remove the set"), tr("Remove the set; its recordings stay open"));
    setWords(*members_, tr("Recordings of the set"),
             tr("The open recordings; those of one resonator are checked"));
    logs_->setText(tr("Logs…"));
    logs_->setToolTip(tr("Add logs to the set, take some out, or tell otherwise what they are"));
    model_label_->setText(tr("Model"));
    setWords(*model_, tr("Model of the resonator"), tr("What the fit assumes of the channels"));
    const QString names[] = {tr("Automatic"), tr("Structured: calibrated pick-offs"),
                             tr("Free: modes alone")};
    const QString tips[] = {
        tr("Structured, unless the free model fits significantly better"),
        tr("The channels are the cosine and sine of the standing wave: split, axes, damping"),
        tr("The channels are any two views of the modes, as with a bell: their frequencies and "
           "decay times")};
    for (int index = 0; index < model_->count(); ++index) {
        model_->setItemText(index, names[index]);
        model_->setItemData(index, tips[index], Qt::ToolTipRole);
    }
    model_->setMinimumContentsLength(10);
    model_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    identify_->setText(tr("Identify"));
    identify_->setToolTip(
        tr("Fit one resonator to all recordings of the set; of an empty set, to "
           "the current recording and those opened together with it (F7)"));
    refresh();
}

}  // namespace vybeg::ui

#include "moc_set_panel.cpp"
