#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <vector>

class QAction;
class QFormLayout;
class QLabel;

namespace vybeg::ui {

class CheckList;
class RecordingDragList;

// The open recordings, and what is known of the current one. Recordings are dragged from here into
// a set of runs, or added to it with Insert.
class RecordingPanel : public QWidget {
    Q_OBJECT

public:
    explicit RecordingPanel(Document& document, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {310, 340}; }

signals:
    // The engineer wants to open the current recording in another way (rate, channels).
    void placeChosen(double time_s, double seconds);
    void reopenWanted(const QString& path, const OpenOptions& options);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Row { file, format, rate, length, channels, start, carrier, sha256, row_count };

    void rebuildList();
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
