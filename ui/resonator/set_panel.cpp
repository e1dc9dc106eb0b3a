#include "ui/resonator/set_panel.h"

#include "core/analysis/setting_table.h"
#include "ui/panels/file_list.h"
#include "ui/resonator/resonator_text.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"
#include "ui/words/short_names.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

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

SetTree::SetTree(QWidget* parent) : QTreeWidget(parent) {
    setColumnCount(2);
    setHeaderHidden(true);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    constexpr int step = 14;
    setIndentation(step);
    setUniformRowHeights(true);
    setExpandsOnDoubleClick(false);
    setEditTriggers(EditKeyPressed | DoubleClicked);
    setItemDelegate(new NameDelegate(this));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // beside which no name is shortened
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    for (const auto changed : {&QTreeWidget::itemExpanded, &QTreeWidget::itemCollapsed}) {
        connect(this, changed, this, [this] { updateGeometry(); });
    }
}

int SetTree::rows() const {
    int count = 0;
    for (int top = 0; top < topLevelItemCount(); ++top) {
        const QTreeWidgetItem* item = topLevelItem(top);
        count += 1 + (item->isExpanded() ? item->childCount() : 0);
    }
    return count;
}

QSize SetTree::sizeHint() const {
    constexpr int least = 6;
    constexpr int most = 18;
    const int row = std::max(sizeHintForRow(0), fontMetrics().height() + 4);
    return {200, std::clamp(rows(), least, most) * row + 2 * frameWidth()};
}

std::vector<QTreeWidgetItem*> SetTree::members() const {
    std::vector<QTreeWidgetItem*> found;
    for (int top = 0; top < topLevelItemCount(); ++top) {
        QTreeWidgetItem* item = topLevelItem(top);
        if (item->type() != set_item) {
            found.push_back(item);
        }
        for (int k = 0; item->font(0).bold() && k < item->childCount(); ++k) {
            found.push_back(item->child(k));
        }
    }
    return found;
}

bool SetTree::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    return QTreeWidget::edit(index.siblingAtColumn(0), trigger, event);
}

void SetTree::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete && currentItem()) {
        emit removalWanted(currentItem());
    } else {
        QTreeWidget::keyPressEvent(event);
    }
}

void SetTree::paintEvent(QPaintEvent* event) {
    QTreeWidget::paintEvent(event);
    if (members().empty()) {
        const int top = topLevelItemCount();
        QRect room = viewport()->rect();
        room.setTop(top > 0 ? visualItemRect(topLevelItem(top - 1)).bottom() : 0);
        drawHint(*this, room, hint_());
    }
}

SetPanel::SetPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      title_(new QLabel(this)),
      add_(withName(new QToolButton(this), "addSet")),
      remove_(withName(new QToolButton(this), "removeSet")),
      sets_(withName(new SetTree(this), "sets")),
      listed_(withName(new QLabel(this), "listed")),
      logs_(withName(new QPushButton(this), "editLogs")),
      model_label_(new QLabel(this)),
      model_(withName(new QComboBox(this), "model")),
      identify_(withName(new QPushButton(this), "identify")) {
    add_->setText(QStringLiteral("+"));
    remove_->setText(QStringLiteral("−"));
    title_->setBuddy(sets_);
    listed_->setWordWrap(true);
    model_label_->setBuddy(model_);
    model_->addItems({QString(), QString(), QString()});

    auto* head = fill(new QHBoxLayout, {{title_, 1}, add_, remove_});
    auto* choices = fill(new QHBoxLayout, {model_label_, {model_, 1}});
    fill(new QVBoxLayout(this), {6, 4, 6, 2}, 3, {head, sets_, listed_, logs_, choices, identify_});

    connectTree();
    connect(add_, &QToolButton::clicked, this, [this] { document_.sets().add(); });
    connect(remove_, &QToolButton::clicked, this,
            [this] { document_.sets().remove(document_.sets().current()->id); });
    connect(logs_, &QPushButton::clicked, this,
            [this] { document_.askForLogs(document_.sets().current()->id); });
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

// What changes the document is queued, because its response fills the tree again.
void SetPanel::connectTree() {
    takeFiles(*sets_, [this](const QStringList& files) { document_.openIntoSet(files); });
    sets_->setHint([this] {
        const RecordingSet* set = document_.sets().current();
        return set && isOfLogs(*set)
                   ? tr("Drop logs of the resonator here")
                   : tr("Drop recordings of one resonator here, best started at four angles");
    });
    connect(sets_, &SetTree::removalWanted, this, &SetPanel::remove);
    connect(sets_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        QMetaObject::invokeMethod(
            this, [this, id = setOf(item)] { document_.sets().setCurrent(id); },
            Qt::QueuedConnection);
    });
    connect(sets_, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item) {
        if (item->type() == SetTree::set_item) {
            document_.sets().rename(setOf(item), item->text(0));
        } else {
            changeMember(item);
        }
    });
    connect(sets_->itemDelegate(), &QAbstractItemDelegate::closeEditor, this, &SetPanel::refresh,
            Qt::QueuedConnection);
}

SetId SetPanel::setOf(const QTreeWidgetItem* item) const {
    const QTreeWidgetItem* top = item && item->parent() ? item->parent() : item;
    return top && top->type() == SetTree::set_item
               ? static_cast<SetId>(top->data(0, Qt::UserRole).toInt())
               : SetId::none;
}

void SetPanel::changeMember(const QTreeWidgetItem* item) {
    const auto id = static_cast<RecordingId>(item->data(0, Qt::UserRole).toInt());
    QMetaObject::invokeMethod(
        this,
        [this, id, set = setOf(item), in = item->checkState(0) == Qt::Checked] {
            if (!in) {
                document_.sets().removeFrom(set, {id});
            } else if (set == SetId::none) {
                document_.sets().addToCurrent({id});
            } else {
                document_.sets().addTo(set, {id});
            }
        },
        Qt::QueuedConnection);
}

void SetPanel::remove(const QTreeWidgetItem* item) {
    const RecordingSet* set = document_.sets().find(setOf(item));
    if (!set) {
        return;
    }
    if (item->type() == SetTree::set_item) {
        document_.sets().remove(set->id);
    } else if (item->type() == SetTree::log_item) {
        removeLog(*set, item->data(0, Qt::UserRole).toString());
    } else {
        const auto id = static_cast<RecordingId>(item->data(0, Qt::UserRole).toInt());
        document_.sets().removeFrom(set->id, {id});
    }
}

void SetPanel::refresh() {
    const RecordingSet* set = document_.sets().current();
    if (!sets_->editing()) {
        showSets();
    }
    remove_->setEnabled(set != nullptr);
    const bool of_logs = set && isOfLogs(*set);
    listed_->setVisible(set && set->listed);
    QStringList facts;
    if (of_logs) {
        facts << tr("Logs, read with %1.").arg(logText(set->listed->settings.logs));
    }
    facts << (of_logs && set->by_panel
                  ? tr("Calibration and tolerances are those of the panel Analysis, which stands "
                       "beside the page Tracks.")
                  : tr("Settings and conditions come from the measurement list and from offers "
                       "accepted since; the panel Analysis does not change them."));
    listed_->setText(facts.join(QLatin1Char(' ')));
    logs_->setVisible(of_logs);
    model_->setCurrentIndex(set ? static_cast<int>(set->model) : 0);
    identify_->setEnabled(document_.sets().canIdentify());
}

// The chosen row stays chosen, of another set than the current one it becomes that of the current
// one; what is unfolded stays so.
void SetPanel::showSets() {
    const QSignalBlocker quiet(sets_);
    const QTreeWidgetItem* before = sets_->currentItem();
    const SetId chosen_set = setOf(before);
    const int chosen_kind = before ? before->type() : 0;
    const QVariant chosen = before ? before->data(0, Qt::UserRole) : QVariant();
    std::set<SetId> unfolded;
    for (int top = 0; top < sets_->topLevelItemCount(); ++top) {
        if (sets_->topLevelItem(top)->isExpanded()) {
            unfolded.insert(setOf(sets_->topLevelItem(top)));
        }
    }
    sets_->clear();
    const RecordingSet* current = document_.sets().current();
    for (const RecordingSet& set : document_.sets().all()) {
        auto* item =
            new QTreeWidgetItem(sets_, {setName(document_, set), noteOf(set)}, SetTree::set_item);
        item->setData(0, Qt::UserRole, number(set.id));
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(0, plainTip(item->text(0)));
        QFont font = sets_->font();
        font.setBold(&set == current);
        item->setFont(0, font);
        addMembers(item, &set);
        item->setExpanded(&set == current || unfolded.contains(set.id));
        if (&set == current) {
            sets_->setCurrentItem(item);
        }
    }
    if (!current) {
        addMembers(sets_->invisibleRootItem(), nullptr);
    }
    for (QTreeWidgetItemIterator item(sets_); *item; ++item) {
        if ((*item)->type() == chosen_kind && (*item)->data(0, Qt::UserRole) == chosen &&
            setOf(*item) == chosen_set && (!current || chosen_set == current->id)) {
            sets_->setCurrentItem(*item);
        }
    }
    sets_->updateGeometry();
}

// Of the current set, or without one, all open recordings; those of the set are checked. Of other
// sets theirs, of a set of logs these, as they are.
void SetPanel::addMembers(QTreeWidgetItem* of, const RecordingSet* set) {
    const auto add = [of](const QString& name, const QString& path, const RecordingRef* row,
                          SetTree::Kind kind) {
        const auto temperature = row ? row->conditions.temperature_c : std::nullopt;
        auto* item = new QTreeWidgetItem(
            of,
            {name,
             temperature ? tr("%1 °C").arg(QLocale().toString(*temperature, 'g', 4)) : QString()},
            kind);
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setFirstColumnSpanned(!temperature);
        QStringList told{QDir::toNativeSeparators(path)};
        told += row ? conditionsText(*row) : QStringList();
        item->setToolTip(0, plainTip(told.join(QLatin1Char('\n'))));
        return item;
    };
    if (set && isOfLogs(*set)) {
        for (const RecordingRef& log : set->listed->recordings) {
            const QString path = pathText(log);
            add(QString::fromStdString(log.name()), path, &log, SetTree::log_item)
                ->setData(0, Qt::UserRole, path);
        }
        return;
    }
    for (const RecordingEntry& entry : document_.recordings()) {
        const bool in = set && std::ranges::count(set->recordings, entry.id) > 0;
        if (!in && set != document_.sets().current()) {
            continue;
        }
        const auto row = set ? rowOf(*set, entry.id) : std::nullopt;
        auto* item = add(entry.name, entry.path, row ? &set->listed->recordings[*row] : nullptr,
                         SetTree::recording_item);
        item->setData(0, Qt::UserRole, number(entry.id));
        item->setCheckState(0, in ? Qt::Checked : Qt::Unchecked);
    }
}

// How many it has, and whether they are identified as they are.
QString SetPanel::noteOf(const RecordingSet& set) const {
    const bool of_logs = isOfLogs(set);
    const auto count = of_logs ? set.listed->recordings.size() : set.recordings.size();
    const QString members = (of_logs ? tr("%1 logs") : tr("%1 rec."))
                                .arg(QLocale().toString(static_cast<qulonglong>(count)));
    const auto outcome = document_.sets().outcome(set);
    const bool found = outcome && !document_.sets().outOfDate(set, *outcome);
    return found ? members + QStringLiteral(" ✓") : members;
}

void SetPanel::removeLog(const RecordingSet& set, const QString& path) {
    MeasurementSet other = document_.sets().measured(set);
    leave_out(other, [&path](const RecordingRef& log) { return pathText(log) == path; });
    document_.sets().setLogs(set.id, other);
}

void SetPanel::retranslate() {
    title_->setText(QStringLiteral("<b>%1</b>").arg(tr("Sets")));
    setWords(*sets_, tr("Sets of recordings"),
             tr("Each with its recordings: those that are checked are of one resonator and are "
                "identified together. A check mark behind their number: identified. F2 names a "
                "set; Delete removes a recording or a set"));
    setWords(*add_, tr("New set"), tr("New set"));
    setWords(*remove_, tr("Remove the set"), tr("Remove the set; its recordings stay open"));
    logs_->setText(tr("Logs…"));
    logs_->setToolTip(tr("Add logs to the set, remove some, or tell otherwise what they are"));
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
