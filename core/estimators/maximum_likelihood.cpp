#include "core/estimators/maximum_likelihood.h"

#include "core/estimators/profile.h"
#include "core/estimators/window_estimate.h"

namespace vybeg {
namespace {

class MaximumLikelihood final : public Estimator {
public:
    explicit MaximumLikelihood(const EstimatorOptions& options)
        : rate_hz_(options.rate_hz),
          bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)) {}

    void estimate(const WindowBlock& block, double, std::span<WaveEstimate> out) override {
        for (std::size_t k = 0; k < out.size(); ++k) {
            const Window window = window_of(block, k);
            out[k] = has_gap(window.c) || has_gap(window.d) ? no_estimate(Flag::gap)
                                                            : estimate_window(window);
        }
    }

private:
    WaveEstimate estimate_window(const Window& window) const {
        const ProfileMaximum maximum = maximise_profile(window, bracket_);
        Flags flags = 0;
        if (maximum.at_bound) {
            set(flags, Flag::at_bound);
        }
        if (!maximum.converged) {
            set(flags, Flag::not_converged);
        }
        constexpr int parameters = 5;
        return complete_estimate(window, rate_hz_, to_wave_state(maximum.phasors), maximum.phasors,
                                 maximum.w, parameters, flags);
    }

    double rate_hz_;
    FrequencyBracket bracket_;
};

}  // namespace

std::unique_ptr<Estimator> make_maximum_likelihood(const EstimatorOptions& options) {
    return std::make_unique<MaximumLikelihood>(options);
}

}  // namespace vybeg
