#include "tests/ui/resonator_runs.h"

#include <numbers>

namespace vybeg::ui {

QStringList resonatorRuns(const GuiTestHome& home, const QString& prefix,
                          const TestResonator& resonator) {
    QStringList paths;
    for (int k = 0; k < 4; ++k) {
        FreeDecay decay;
        decay.seconds = 4;
        decay.rate_hz = 8000;
        decay.f0_hz = 1000 + 0.01 * k;
        decay.two_theta_A = k * std::numbers::pi / 4;
        decay.split_hz = resonator.split_hz;
        decay.theta_w = resonator.theta_w;
        decay.tau_s = resonator.tau_s;
        decay.kappa = resonator.kappa;
        decay.delay_d_s = resonator.delay_d_s;
        decay.offset_c = resonator.offset_c;
        decay.noise = 1e-3;
        decay.seed = static_cast<std::uint64_t>(k + 1);
        paths << home.recording(QStringLiteral("%1-%2.wav").arg(prefix).arg(k * 45 / 2), decay);
    }
    return paths;
}

}  // namespace vybeg::ui
