#include "ui/panels/wave_panel.h"

#include "core/track/wave_pattern.h"
#include "ui/charts/round_plot.h"
#include "ui/panels/measuring.h"
#include "ui/plots/plot_content.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"
#include "ui/words/rich_text.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg::ui {

namespace {

constexpr int steps = 180;
constexpr std::size_t most_waves = 6;  // more would hide each other
constexpr double degree = std::numbers::pi / 180;

RoundSeries curveOf(const ShownAnalysis& shown, ClosedCurve curve, double x_factor) {
    RoundSeries series;
    series.name = shown.name;
    series.color = shown.color;
    series.shade = shown.shade;
    series.x = std::move(curve.x);
    series.y = std::move(curve.y);
    for (double& x : series.x) {
        x *= x_factor;
    }
    return series;
}

// The next round number, so that the scale stays while a wave decays; its half is round, too.
double roundReach(double amplitude) {
    const double power = std::pow(10, std::floor(std::log10(amplitude)));
    for (const double step : {1., 1.2, 1.6, 2., 3., 4., 6., 8.}) {
        if (amplitude <= step * power) {
            return step * power;
        }
    }
    return 10 * power;
}

}  // namespace

WavePanel::WavePanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      time_(new QLabel(this)),
      pattern_(withName(new RoundView(true, this), "pattern")),
      ellipse_(withName(new RoundView(false, this), "ellipse")) {
    time_->setContentsMargins(6, 2, 6, 2);
    // The ledger below is the legend of the tracks, too.
    pattern_->setLegendShown(false);
    ellipse_->setLegendShown(false);
    fill(new QVBoxLayout(this), {}, 0, {time_, {pattern_, 1}, {ellipse_, 1}});
    connect(pattern_, &RoundView::exportWanted, this, &WavePanel::exportWanted);
    connect(ellipse_, &RoundView::exportWanted, this, &WavePanel::exportWanted);
    connect(&document_, &Document::analysesChanged, this, &WavePanel::refresh);
    keepTranslated(*this, [this] { retranslate(); });
    whenChanged(*this, {QEvent::Show}, [this] { refresh(); });
}

void WavePanel::setTime(std::optional<double> time_s) {
    time_s_ = time_s;
    refresh();
}

void WavePanel::setAnalysis(AnalysisId id) {
    chosen_ = id;
    refresh();
}

// A hidden panel draws nothing: the mouse moves over the plots all the time.
void WavePanel::refresh() {
    if (!isVisible()) {
        return;
    }
    RoundPlot pattern;
    RoundPlot ellipse;
    ellipse.polar = false;
    ellipse.x_name = QStringLiteral("C");
    ellipse.y_name = QStringLiteral("D");
    pattern.empty = ellipse.empty = tr("No wave here");
    double largest = 0;
    std::optional<double> shown_s = time_s_;
    std::vector<ShownAnalysis> analyses = document_.plottedAnalyses();
    drawnWith(chosen_, analyses);
    for (const ShownAnalysis& shown : analyses) {
        const Track& track = shown.analysis->track;
        if (!shown.visible || track.rows() == 0 || pattern.series.size() == most_waves) {
            continue;
        }
        shown_s = shown_s.value_or(track.time_s().front());
        const std::size_t row = nearestRow(track, *shown_s);
        const WaveState wave{track.values(SlowVariable::a_A)[row],
                             track.values(SlowVariable::a_B)[row],
                             track.values(SlowVariable::two_theta_A)[row]};
        if (!std::isfinite(wave.a_A + wave.a_B + wave.two_theta_A)) {
            continue;
        }
        largest = std::max({largest, wave.a_A, std::abs(wave.a_B)});
        pattern.series.push_back(curveOf(shown, polar_pattern(wave, steps), 1 / degree));
        ellipse.series.push_back(curveOf(shown, channel_ellipse(wave, steps), 1));
    }
    if (pattern.series.size() == 1) {  // a single wave needs no legend
        pattern.series[0].name = ellipse.series[0].name = QString();
    }
    pattern.reach = ellipse.reach = largest > 0 ? roundReach(largest) : 1;
    time_->setText(shown_s ? tr("t = %1 s").arg(numberLabel(*shown_s, 5)) : QString());
    pattern_->setContent(pattern);
    ellipse_->setContent(ellipse);
}

void WavePanel::retranslate() {
    pattern_->setAccessibleName(tr("Amplitude of the wave around the rim"));
    pattern_->setToolTip(richTip(
        tr("Amplitude against the angle on the rim, from the electrode of channel C at the top, "
           "clockwise: a_A at the four antinodes, |a_B| between them")));
    ellipse_->setAccessibleName(tr("Ellipse of the channels"));
    ellipse_->setToolTip(
        richTip(tr("D against C over one period: the semi-axes are a_A and |a_B|, "
                   "and the major axis stands at 2θ_A from C")));
    refresh();
}

}  // namespace vybeg::ui

#include "moc_wave_panel.cpp"
