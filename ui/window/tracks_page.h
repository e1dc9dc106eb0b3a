#pragma once

#include "ui/plots/figure_source.h"
#include "ui/values/ids.h"
#include "ui/widgets/theme.h"

#include <QElapsedTimer>
#include <QWidget>

class QScrollArea;

namespace vybeg::ui {

class Document;
class SignalView;
class StaleMark;
class TrackView;

// The overview of the current recording over the plots of all shown analyses. It follows the
// document, and keeps the ranges that both views show the same.
class TracksPage : public QWidget {
    Q_OBJECT

public:
    explicit TracksPage(Document& document, QWidget* parent = nullptr);

    TrackView& tracks() const { return *tracks_; }
    // The analysis whose axis crossings are marked, and which is drawn alone where others are
    // unlike it.
    void chooseAnalysis(AnalysisId id);
    // Centres the present zoom on an event, wide enough to see it from both sides.
    void goToEvent(double time_s, double seconds);
    // Analyses from now on what the plots show.
    void analyseVisibleRange();
    void setTheme(const Theme& theme);
    FigureSource figures() const;

signals:
    void analyseWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showRecording();
    void showEnvelope();
    void showAnalysedRange();
    void showAnalyses();
    void editAnalysedRange(double from_s, double to_s);
    void retranslate();

    Document& document_;
    SignalView* signal_;
    StaleMark* stale_;
    TrackView* tracks_;
    QScrollArea* scroll_;  // of the plots, where the page is too low for all of them
    AnalysisId chosen_ = AnalysisId::none;
    QElapsedTimer last_range_edit_;
    int range_gesture_ = 0;
};

}  // namespace vybeg::ui
