#pragma once

#include "ui/plots/track_view.h"
#include "ui/signals/signal_picture.h"

#include <memory>

namespace vybeg::ui {

class SignalOverlay;
class SignalStack;

// The plots of the signals; time range, zoom history, tracker and cursors are those of the view of
// the tracks.
class SignalsView : public TimeGestures {
    Q_OBJECT

public:
    explicit SignalsView(TrackView& tracks, QWidget* parent = nullptr);
    ~SignalsView() override;

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
    const SignalContent& content() const;
    const SignalPicture& picture() const;
    // Width of the time axis, pixels.
    int timeWidth() const;

    QSize sizeHint() const override { return {900, 700}; }
    QSize minimumSizeHint() const override { return {320, 320}; }

signals:
    void resized();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    TrackView& tracks_;
    std::unique_ptr<SignalStack> stack_;
    SignalOverlay* overlay_;
};

}  // namespace vybeg::ui
