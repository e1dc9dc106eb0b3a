#pragma once

#include "ui/document/log_tracks.h"
#include "ui/plots/plot_view.h"
#include "ui/values/ids.h"

class QLabel;

namespace vybeg::ui {

class Document;
class TrackView;

// The plots of all shown analyses, as the document has them, and of the tracks of logs, whose names
// stand above.
class TracksPage : public MeasuredPage {
    Q_OBJECT

public:
    explicit TracksPage(Document& document, QWidget* parent = nullptr);

    TrackView& tracks() const { return *tracks_; }
    const LogTracks& logTracks() const { return log_tracks_; }
    // The analysis whose axis crossings are marked, and which is drawn alone where others are
    // unlike it.
    void chooseAnalysis(AnalysisId id);
    // Centres the present zoom on an event, wide enough to see it from both sides.
    void goToEvent(double time_s, double seconds);
    void setTheme(const Theme& theme) override;
    void setUnits(const DisplayUnits& units) override;
    FigureSource figures() const override;
    // The article's figure, a column for each analysis that is shown.
    FigureSource articleFigure() const;

private:
    void showAnalyses();
    void nameLogs();
    void retranslate() override { nameLogs(); }

    Document& document_;
    LogTracks log_tracks_;
    QLabel* logs_;
    TrackView* tracks_;
    AnalysisId chosen_ = AnalysisId::none;
};

}  // namespace vybeg::ui
