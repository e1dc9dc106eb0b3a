#pragma once

#include "ui/document/document.h"
#include "ui/values/ids.h"

#include <QFrame>
#include <QToolButton>

class QLabel;
class QTreeWidget;

namespace vybeg::ui {

class CheckList;

// The flag beside the overview: the number of findings of the current recording and of events of
// the chosen analysis. A click opens their lists, a click in them goes to the place.
class FindingsFlag : public QToolButton {
    Q_OBJECT

public:
    explicit FindingsFlag(Document& document, QWidget* parent = nullptr);

    void setAnalysis(AnalysisId analysis_id);

signals:
    // Seconds from the start of the recording.
    void placeChosen(double time_s, double seconds);

private:
    void open();
    void refresh();
    void fillEvents(const AnalysisEntry* entry);
    void retranslate();

    Document& document_;
    QFrame* popup_;
    CheckList* check_;
    QLabel* title_;
    QTreeWidget* events_;
    AnalysisId analysis_id_ = AnalysisId::none;
    std::shared_ptr<const Analysis> listed_;  // analysis of the listed events
};

}  // namespace vybeg::ui
