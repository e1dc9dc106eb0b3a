#pragma once

#include "ui/document/document.h"
#include "ui/values/ids.h"

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace vybeg::ui {

// The events of one analysis in the order of time. A click emits eventChosen().
class EventsPanel : public QWidget {
    Q_OBJECT

public:
    explicit EventsPanel(Document& document, QWidget* parent = nullptr);

    void setAnalysis(AnalysisId analysis_id);
    AnalysisId analysis() const { return analysis_id_; }

signals:
    void eventChosen(double time_s, double seconds);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void fillList(const AnalysisEntry* entry);
    void retranslate();

    Document& document_;
    QLabel* title_;
    QTreeWidget* list_;
    AnalysisId analysis_id_ = AnalysisId::none;
    std::shared_ptr<const Analysis> listed_;  // analysis of the listed events
};

}  // namespace vybeg::ui
