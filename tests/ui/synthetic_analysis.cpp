#include "tests/ui/synthetic_analysis.h"

#include "core/numerics/phase.h"
#include "ui/widgets/theme.h"

#include <cmath>
#include <numbers>
#include <random>

namespace vybeg::ui {

ShownAnalysis syntheticAnalysis(int index, const SyntheticAnalysis& what) {
    constexpr double rate = 33333;
    constexpr double f0 = 5300;
    const auto rows = static_cast<std::size_t>(what.seconds * rate / what.window);
    auto analysis = std::make_shared<Analysis>();
    analysis->track = Track(rows);
    analysis->settings.window = what.window;
    analysis->settings.f0_hz = f0;
    Track& track = analysis->track;
    std::mt19937 random(what.seed);
    std::normal_distribution<double> normal;
    const double n = what.window;
    const double sd = what.noise * std::sqrt(2 / n);
    const double sd_f =
        what.noise * rate * std::sqrt(24 / (n * (n * n - 1))) / (2 * std::numbers::pi);
    const auto put = [&](SlowVariable variable, std::size_t row, double value, double deviation) {
        track.values(variable)[row] = value + deviation * normal(random);
        if (info(variable).has_sd) {
            track.sds(variable)[row] = deviation;
        }
    };
    for (std::size_t row = 0; row < rows; ++row) {
        const double t = (static_cast<double>(row) * n + 0.5 * (n - 1)) / rate;
        track.time_s()[row] = t;
        if (t > what.gap_from_s && t < what.gap_to_s) {
            track.flags()[row] = static_cast<Flags>(Flag::gap);
            continue;
        }
        const double a_A = std::exp(-t / 60);
        put(SlowVariable::a_A, row, a_A, sd);
        if (what.no_quadrature) {
            track.flags()[row] = static_cast<Flags>(Flag::no_quadrature);
        } else {
            put(SlowVariable::a_B, row, 0.02 * std::sin(0.4 * t), sd);
        }
        put(SlowVariable::two_theta_A, row, 0.3 + 0.05 * t, sd / a_A);
        put(SlowVariable::f, row, f0 + 0.004 * std::exp(-t / 10), sd_f / a_A);
        put(SlowVariable::delta_phi_CD, row, std::numbers::pi + 0.3 * std::sin(0.4 * t),
            2 * sd / a_A);
        put(SlowVariable::alpha, row, 0.4 + 0.8 * t, sd / a_A);
        for (const SlowVariable wrapped : {SlowVariable::delta_phi_CD, SlowVariable::alpha}) {
            track.values(wrapped)[row] = wrap(track.values(wrapped)[row]);
        }
        put(SlowVariable::noise, row, what.noise, 0.1 * what.noise);
        put(SlowVariable::rms, row, std::numbers::sqrt2 * what.noise, 0.1 * what.noise);
        put(SlowVariable::orthogonality, row, 0, 0.5 * sd / a_A);
    }
    const CurveStyle style = curveStyle(index);
    ShownAnalysis shown;
    shown.id = static_cast<AnalysisId>(index);
    shown.name = QStringLiteral("maximum-likelihood, n = %1").arg(what.window);
    shown.recording = QStringLiteral("demo_%1.wav").arg(index);
    shown.color = style.color;
    shown.shade = style.shade;
    shown.rate_hz = rate;
    shown.analysis = analysis;
    return shown;
}

}  // namespace vybeg::ui
