#pragma once

#include "ui/values/ids.h"
#include "ui/widgets/theme.h"

#include <QElapsedTimer>
#include <QWidget>

namespace vybeg::ui {

class Document;
class FindingsFlag;
class SignalView;
class TimeGestures;
class TrackView;

// The overview of the current recording over the plots of a page, with the flag of its findings in
// the plots' left margin. It keeps the visible range the same as that of the plots.
class Overview : public QWidget {
    Q_OBJECT

public:
    Overview(Document& document, TrackView& tracks, QWidget* parent = nullptr);

    FindingsFlag& flag() const { return *flag_; }
    // Aligned with the time axis of a view while that is shown, as of the tracks.
    void standOver(const TimeGestures& view);
    // Analyses from now on what the plots show.
    void analyseVisibleRange();

private:
    void showRecording();
    void showEnvelope();
    void showAnalysedRange();
    void showVisibleRange();
    void editAnalysedRange(double from_s, double to_s);

    Document& document_;
    TrackView& tracks_;
    SignalView* signal_;
    FindingsFlag* flag_;
    QElapsedTimer last_range_edit_;
    int range_gesture_ = 0;
};

}  // namespace vybeg::ui
