#pragma once

#include "core/track/track.h"
#include "ui/document/log_tracks.h"
#include "ui/plots/plot_view.h"
#include "ui/values/ids.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace vybeg::ui {

class Document;
class NumberField;
class TrackView;

// The plots of all shown analyses, as the document has them, and of the tracks of logs, whose names
// are above.
class TracksPage : public MeasuredPage {
    Q_OBJECT

public:
    explicit TracksPage(Document& document, QWidget* parent = nullptr);

    TrackView& tracks() const { return *tracks_; }
    const LogTracks& logTracks() const { return log_tracks_; }
    // The analysis whose axis crossings are marked, and which is drawn alone where others are
    // unlike it.
    void setAnalysis(AnalysisId id) override;
    // Centres the present zoom on an event, wide enough to see it from both sides.
    void goToEvent(double time_s, double seconds);
    void setUnits(const DisplayUnits& units) override;
    FigureSource figures() const override;
    // The article's figure, a column for each analysis that is shown.
    FigureSource articleFigure() const;

private:
    void showAnalyses();
    void nameLogs();
    void showAgain() override { nameLogs(); }
    void retranslate() override { nameLogs(); }

    Document& document_;
    LogTracks log_tracks_;
    QLabel* logs_;
    TrackView* tracks_;
    AnalysisId chosen_ = AnalysisId::none;
};

// Asks for the limits of the value axis of one plot of the tracks, displayed units: an empty field
// leaves that end to the data.
class AxisLimitsDialog : public QDialog {
    Q_OBJECT

public:
    AxisLimitsDialog(TrackView& tracks, SlowVariable variable, QWidget* parent);

private:
    void check();
    void apply();

    TrackView& tracks_;
    SlowVariable variable_;
    NumberField* lower_;
    NumberField* upper_;
    QLabel* fault_;
    QPushButton* ok_;
};

// Of the chosen plot; nothing without one.
void askForAxisLimits(TrackView& tracks, QWidget* window);

}  // namespace vybeg::ui
