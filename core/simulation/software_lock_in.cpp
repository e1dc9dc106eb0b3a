#include "core/simulation/software_lock_in.h"

#include "core/base/number_text.h"
#include "core/simulation/decay_motion.h"

#include <cmath>
#include <numbers>

namespace vybeg {

SoftwareLockIn::SoftwareLockIn(const LockIn& filter, double f_ref_hz, double rate_hz,
                               std::int64_t samples_per_row)
    : filter_(filter),
      f_ref_hz_(f_ref_hz),
      rate_hz_(rate_hz),
      samples_per_row_(samples_per_row),
      keep_(std::exp(-1 / (rate_hz * filter.tau_s()))) {
    for (auto& stages : stages_) {
        stages.assign(static_cast<std::size_t>(filter.order), 0);
    }
}

void SoftwareLockIn::take(std::span<const double> c, std::span<const double> d) {
    for (std::size_t k = 0; k < c.size(); ++k, ++frame_) {
        const double turns = turns_at(static_cast<double>(frame_), f_ref_hz_, rate_hz_);
        const Complex reference = std::polar(2.0, -2 * std::numbers::pi * turns);
        const std::array samples{c[k], d[k]};
        for (std::size_t channel = 0; channel < samples.size(); ++channel) {
            Complex z = samples[channel] * reference;
            for (Complex& stage : stages_[channel]) {
                stage += (1 - keep_) * (z - stage);
                z = stage;
            }
            if (frame_ % samples_per_row_ == 0) {
                rows_[channel].push_back(z);
            }
        }
    }
}

std::string SoftwareLockIn::table() const {
    // To 1e-6 of a step.
    const double settled_s = (14 + 2.5 * filter_.order) * filter_.tau_s();
    std::string text = "t (s),Xc,Yc,Xd,Yd,F (Hz)\n";
    for (std::size_t k = 0; k < rows_[0].size(); ++k) {
        const double t = static_cast<double>(k) * static_cast<double>(samples_per_row_) / rate_hz_;
        if (t < settled_s) {
            continue;
        }
        text += round_trip_text(t);
        for (const Complex z : {rows_[0][k], rows_[1][k]}) {
            text += ',' + round_trip_text(z.real()) + ',' + round_trip_text(z.imag());
        }
        text += ',' + round_trip_text(f_ref_hz_) + '\n';
    }
    return text;
}

}  // namespace vybeg
