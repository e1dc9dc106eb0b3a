#pragma once

#include "ui/document/document.h"
#include "ui/values/ids.h"

#include <QWidget>

#include <vector>

class QAction;
class QFormLayout;
class QLabel;
class QListWidgetItem;

namespace vybeg::ui {

class CheckList;
class RecordingDragList;

// The open recordings and properties of the current one. Recordings can be dragged into a set or
// added with Insert.
class RecordingPanel : public QWidget {
    Q_OBJECT

public:
    explicit RecordingPanel(Document& document, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {310, 340}; }

signals:
    // The user chose the place of a finding, seconds from the start.
    void placeChosen(double time_s, double seconds);
    void reopenWanted(const QString& path, const OpenOptions& options);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Row { file, format, rate, length, channels, start, carrier, sha256, row_count };

    void rebuildList();
    void showRow(QListWidgetItem& item, const RecordingEntry& entry);
    void refreshRow(RecordingId id);
    void refreshInfo();
    void retranslate();

    Document& document_;
    RecordingDragList* list_;
    QAction* close_;
    QAction* reopen_;
    QAction* add_to_set_;
    QFormLayout* info_;
    CheckList* check_;
    std::vector<QLabel*> names_;
    std::vector<QLabel*> values_;
};

}  // namespace vybeg::ui
