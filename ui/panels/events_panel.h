#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace vybeg::ui {

// The events of one run in the order of time. A click emits eventChosen().
class EventsPanel : public QWidget {
    Q_OBJECT

public:
    explicit EventsPanel(Document& document, QWidget* parent = nullptr);

    void setRun(int run_id);
    int run() const { return run_id_; }

signals:
    void eventChosen(double time_s, double seconds);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void fillList(const RunEntry* entry);
    void retranslate();

    Document& document_;
    QLabel* title_;
    QTreeWidget* list_;
    int run_id_ = 0;
    std::shared_ptr<const Analysis> listed_;  // analysis of the listed events
};

}  // namespace vybeg::ui
