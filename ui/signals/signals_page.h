#pragma once

#include "ui/document/background_jobs.h"
#include "ui/plots/plot_view.h"
#include "ui/plots/track_view.h"
#include "ui/signals/signal_stack.h"
#include "ui/values/ids.h"

#include <QTimer>

#include <memory>
#include <optional>

class QLabel;

namespace vybeg::ui {

// The plots of the signals; time range, zoom history, tracker and cursors are those of the view of
// the tracks.
class SignalsView : public TimeGestures {
    Q_OBJECT

public:
    explicit SignalsView(TrackView& tracks, QWidget* parent = nullptr);

    ZoomNavigator& zoom() override { return tracks_.zoom(); }
    std::optional<double> tracker() const override { return tracks_.tracker(); }
    std::optional<double> cursor(Cursor which) const override { return tracks_.cursor(which); }
    void moveTracker(std::optional<double> time_s) override;
    void moveCursor(Cursor which, std::optional<double> time_s) override {
        tracks_.moveCursor(which, time_s);
    }
    void fit() override { tracks_.fit(); }

    // The time range of the content is that of the tracks.
    void setContent(SignalContent content);
    const SignalContent& content() const { return stack_.content(); }
    const SignalPicture& picture() const { return stack_.picture(); }
    // Width of the time axis, pixels.
    int timeWidth() const { return stack_.frameWidth(plot().width()); }

    QSize sizeHint() const override { return {900, 700}; }
    QSize minimumSizeHint() const override { return {320, 320}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    TrackView& tracks_;
    SignalStack& stack_;
};

class Document;
struct RecordingEntry;
struct AnalysisEntry;

// The signals of the current recording as samples, with the wave that the chosen analysis fitted to
// them and the residual. Few samples are read in the background; those read before are shown
// until they are there. Time range, zoom history and cursors are those of the tracks.
class SignalsPage : public MeasuredPage {
    Q_OBJECT

public:
    // `tracks` outlives the page's work.
    SignalsPage(Document& document, TrackView& tracks, QWidget* parent = nullptr);

    void setAnalysis(AnalysisId id) override;
    // Whether the wave of the analysis is drawn over the samples.
    void setWave(bool shown);
    // Draws the cursors again.
    void showCursors();
    SignalsView& view() const { return *view_; }
    // Whether samples are being read, or are about to be.
    bool reading() const { return reading_ || pause_.isActive(); }

    FigureSource figures() const override;

private:
    // Samples with their fitted wave, and what the next excerpt of the same is taken from.
    struct Excerpt {
        SignalSource source;
        std::shared_ptr<const SignalExcerpt> samples;
    };

    // The part of a recording that was read.
    struct Known {
        RecordingId recording = RecordingId::none;
        std::shared_ptr<const SampleSource> samples{};  // as recorded
        std::optional<SignalSource> source{};           // of this excerpt, and of the next one
        std::shared_ptr<const SignalExcerpt> excerpt{};
        std::optional<Error> failure{};
    };

    // The chosen analysis, if it is one of the current recording and has all its windows.
    const AnalysisEntry* fitted() const;
    void refresh();
    void request();
    void stop();
    void take(Result<Excerpt> result);
    SignalContent content() const;
    void showState();
    QString stateText() const;
    void showAgain() override { refresh(); }
    void retranslate() override;

    Document& document_;
    TrackView& tracks_;
    BackgroundJobs job_;
    QTimer pause_;      // between the first change and the reading
    bool wave_ = true;  // of the analysis, over the samples
    QLabel* state_;
    SignalsView* view_;
    AnalysisId analysis_id_ = AnalysisId::none;
    Known known_;
    bool reading_ = false;
};

}  // namespace vybeg::ui
