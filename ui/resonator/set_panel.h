#pragma once

#include "ui/document/document.h"

#include <QTreeWidget>
#include <QWidget>

#include <functional>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace vybeg::ui {

// The sets, each with its recordings or logs below it. Of the current set all open recordings are
// there, those of the set checked; without a set they are listed alone. As high as its rows, up
// to a maximum.
class SetTree : public QTreeWidget {
    Q_OBJECT

public:
    enum Kind { set_item = QTreeWidgetItem::UserType, recording_item, log_item };

    explicit SetTree(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    // Of the current set; without a set all.
    std::vector<QTreeWidgetItem*> members() const;
    bool editing() const { return state() == EditingState; }
    // The text shown while the current set has no members, in the language of the window.
    void setHint(std::function<QString()> hint) { hint_ = std::move(hint); }

signals:
    void removalWanted(QTreeWidgetItem* item);

protected:
    // A name, wherever its row is clicked.
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    int rows() const;

    std::function<QString()> hint_;
};

// The sets with their recordings, and options of their identification.
class SetPanel : public QWidget {
    Q_OBJECT

public:
    explicit SetPanel(Document& document, QWidget* parent = nullptr);

private:
    void connectTree();
    void refresh();
    void showSets();
    void addMembers(QTreeWidgetItem* of, const RecordingSet* set);
    QString noteOf(const RecordingSet& set) const;
    // The set of an item; none of a recording beside the sets.
    SetId setOf(const QTreeWidgetItem* item) const;
    void changeMember(const QTreeWidgetItem* item);
    void remove(const QTreeWidgetItem* item);
    void removeLog(const RecordingSet& set, const QString& path);
    void retranslate();

    Document& document_;
    QLabel* title_;
    QToolButton* add_;
    QToolButton* remove_;
    SetTree* sets_;
    QLabel* listed_;     // where the settings are from
    QPushButton* logs_;  // asks what the logs of the set are
    QLabel* model_label_;
    QComboBox* model_;
    QPushButton* identify_;
};

// Name of a set: the given one, what the names of its recordings have in common, or "Set 2".
QString setName(const Document& document, const RecordingSet& set);

}  // namespace vybeg::ui
