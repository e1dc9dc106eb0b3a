#include "core/resonator/runs/channel_balance.h"

#include "core/estimators/wave/wave_state.h"

#include <algorithm>
#include <cmath>

namespace vybeg {

ChannelBalance channel_balance(const PhasorRun& run, const FittedMotion& motion, std::size_t index,
                               std::size_t most_points) {
    ChannelBalance balance;
    const std::size_t windows = run.time_s.size();
    const std::size_t points = std::min(most_points, windows);
    const std::vector<Phasors> fitted = predicted_phasors(motion, index, run.time_s);
    for (std::size_t point = 0; point < points; ++point) {
        double count = 0;
        double time = 0;
        double sum = 0;
        double variance = 0;
        std::complex<double> direction;  // its period is 90 degrees of theta
        for (std::size_t k = point * windows / points; k < (point + 1) * windows / points; ++k) {
            const WaveState wave = to_wave_state(fitted[k]);
            if (wave.a_A - std::abs(wave.a_B) < 6 * run.sd[k]) {
                continue;
            }
            const double cosine = std::cos(wave.two_theta_A);
            const double sine = std::sin(wave.two_theta_A);
            const std::complex<double> s_A = run.c[k] * cosine + run.d[k] * sine;
            const std::complex<double> s_B = run.d[k] * cosine - run.c[k] * sine;
            const double power = std::norm(s_A) + std::norm(s_B);
            count += 1;
            time += run.time_s[k];
            sum += (s_A * std::conj(s_B)).real() / power;
            direction += std::polar(1.0, 2 * wave.two_theta_A);
            variance += run.sd[k] * run.sd[k] / power;
        }
        if (count > 0) {
            balance.time_s.push_back(time / count);
            balance.theta_rad.push_back(std::arg(direction) / 4);
            balance.orthogonality.push_back(sum / count);
            balance.sd.push_back(std::sqrt(variance) / count);
        }
    }
    return balance;
}

}  // namespace vybeg
