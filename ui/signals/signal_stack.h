#pragma once

#include "core/recording/conditioning/conditioned_source.h"
#include "core/recording/envelope/envelope.h"
#include "core/residuals/signal_curves.h"
#include "ui/plots/plot_file.h"
#include "ui/plots/time_gestures.h"
#include "ui/plots/time_panel.h"
#include "ui/values/curve_data.h"
#include "ui/widgets/theme.h"

#include <QString>

#include <array>
#include <memory>
#include <vector>

namespace vybeg::ui {

// The plots of the page, from above.
enum class SignalPart { c, d, residual };
inline constexpr std::array all_signal_parts{SignalPart::c, SignalPart::d, SignalPart::residual};

// Content of the plots of the signals, common to screen and paper.
struct SignalContent {
    std::shared_ptr<const Envelope> envelope;  // of the samples as recorded; null: nothing read yet
    double rate_hz = 0;
    std::int64_t frames = 0;                       // of the recording
    std::shared_ptr<const SignalExcerpt> excerpt;  // null: none yet
    std::shared_ptr<const Analysis> analysis;      // has all its windows; null: none
    std::shared_ptr<const CurveData> rms;          // of the analysis
    Calibration calibration;  // of the analysis; gain and offsets are applied to the envelope
    bool wave = true;         // whether the fitted wave is shown
    QString unit;             // of the samples
    QString no_residual;      // text of the plot of the residual without an analysis
    Theme theme = lightTheme();
    AxisRange time;
};

// What lies in a time range over a number of pixels.
struct SignalPicture {
    bool samples = false;  // few enough to be drawn one by one; otherwise columns
    // The samples of the excerpt that are seen: [from, to), with one beyond each end.
    std::size_t from = 0;
    std::size_t to = 0;
    bool whole = false;  // the excerpt has all of them
    // Minima and maxima; empty where all samples are drawn.
    std::vector<EnvelopeBucket> columns;
    double columns_from_s = 0;
    double columns_to_s = 0;
    // The wave itself where its periods can be distinguished, otherwise its amplitudes; empty where
    // it is hidden.
    SignalCurve wave;
    bool smooth = false;
    double period_pixels = 0;
    std::vector<CurveColumn> rms;  // beside columns
};

// Whether samples are drawn one by one: up to four to a pixel.
bool fewSamples(const AxisRange& time, double rate_hz, int width);
// Whether an excerpt has all samples of a time range, as far as the recording has them.
bool covers(const SignalExcerpt& excerpt, const AxisRange& time, std::int64_t frames);

// Precondition: width >= 1.
SignalPicture pictureOf(const SignalContent& content, int width);

// The value axis of a plot: all that is drawn in it, and the samples beside, with a margin.
AxisRange valuesOf(const SignalContent& content, const SignalPicture& picture, SignalPart part);

// The plots of the signals, on paper with a legend above; on the screen the overlay says what the
// curves are.
class SignalStack : public TimeStack {
public:
    SignalStack(QCustomPlot& plot, const std::vector<SignalPart>& parts, PlotHead head);

    // Those of frames().
    const std::vector<SignalPart>& parts() const { return parts_; }

    // Everything for a plot of that size, device-independent pixels.
    void setContent(SignalContent content, QSize size);

    const SignalContent& content() const { return content_; }
    const SignalPicture& picture() const { return picture_; }

private:
    void refresh(SignalPart part, TimePanel& panel);
    void showLegend();

    SignalContent content_;
    SignalPicture picture_;
    std::vector<SignalPart> parts_;
};

// A figure of some plots in the light theme, with its proposed size.
Figure signalFigure(SignalContent content, const std::vector<SignalPart>& parts);

// Over the signals: the values of the sample nearest to the tracker.
class SignalOverlay : public TimeOverlay {
public:
    SignalOverlay(const SignalStack& stack, const TimeGestures& gestures)
        : TimeOverlay(stack, gestures), stack_(stack) {}

protected:
    void draw(QCPPainter* painter) override;

private:
    QString note(SignalPart part, const TimePanel& panel) const;

    const SignalStack& stack_;
};

}  // namespace vybeg::ui
