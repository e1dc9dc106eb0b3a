#include "core/estimators/algorithms/conjugate_gradient.h"

#include "core/estimators/algorithms/closed_form.h"
#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/series_descent.h"
#include "core/estimators/batch/series_estimates.h"
#include "core/estimators/wave/descent.h"
#include "core/estimators/wave/frequency_bracket.h"
#include "core/estimators/wave/window_estimate.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

class ConjugateGradient final : public Estimator {
public:
    explicit ConjugateGradient(const EstimatorOptions& options)
        : options_(options),
          bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)),
          sums_(options.length, bracket_.centre) {}

    bool sequential() const override { return options_.start == StartRule::previous; }

    void estimate(const WindowBlock& block, double centre_s, std::span<WaveEstimate> out) override {
        if (sequential()) {
            for (std::size_t k = 0; k < out.size(); ++k) {
                out[k] = estimate_next(window_of(block, k), centre_of(block, k, centre_s));
            }
            return;
        }
        sums_.take(block, out.size());
        SeriesBatch batch;
        SeriesMaximum maximum;
        SeriesStart start;
        SeriesDescent descent;
        for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
            count = sums_.next(first, batch, maximum);
            const SeriesFrame& frame = sums_.frame();
            in_phase_starts(batch, frame, start);
            if (options_.initial) {
                for (std::size_t lane = 0; lane < series_lanes; ++lane) {
                    const std::size_t k = first + std::min(lane, count - 1);
                    set_start(start, lane, typed_start(centre_of(block, k, centre_s)), frame);
                }
            }
            descend_series(batch, frame, start, descent);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const std::size_t k = first + lane;
                const Window window = window_of(block, k);
                const double power = batch.cc[lane] + batch.dd[lane];
                if (!std::isfinite(power)) {
                    out[k] = no_estimate(Flag::gap);
                } else if (descent.arrived[lane] > 0) {
                    out[k] = estimate_of_lane(descent.waves, lane, window,
                                              {power, descent.residual[lane]}, options_);
                } else {
                    out[k] =
                        estimate_window(window, start_values(window, centre_of(block, k, centre_s)))
                            .estimate;
                }
            }
        }
    }

private:
    struct Previous {
        WaveParameters parameters;
        double centre_s = 0;
    };

    // The same wave at another window's centre: tau = w u - alpha goes on.
    WaveParameters carried(const WaveParameters& from, double from_s, double to_s) const {
        WaveParameters to = from;
        // Wrapped, or the phase of a long recording would lose its digits.
        to.state.alpha = wrap(to.state.alpha - from.w * options_.rate_hz * (to_s - from_s));
        return to;
    }

    double centre_of(const WindowBlock& block, std::size_t k, double first_s) const {
        return first_s + static_cast<double>(k) * static_cast<double>(block.hop) / options_.rate_hz;
    }

    WaveParameters typed_start(double centre_s) const {
        const double w = 2 * std::numbers::pi * options_.initial->f_hz / options_.rate_hz;
        return carried({options_.initial->state, w}, options_.first_centre_s, centre_s);
    }

    WaveParameters start_values(const Window& window, double centre_s) const {
        if (options_.initial) {
            return typed_start(centre_s);
        }
        return {in_phase_start(window, bracket_.centre), bracket_.centre};
    }

    void set_start(SeriesStart& start, std::size_t lane, const WaveParameters& values,
                   const SeriesFrame& frame) const {
        start.a_A[lane] = values.state.a_A;
        start.a_B[lane] = values.state.a_B;
        start.two_theta_A[lane] = values.state.two_theta_A;
        start.alpha[lane] = values.state.alpha;
        start.x[lane] = 0.5 * static_cast<double>(options_.length) * (values.w - frame.w0());
    }

    struct Estimated {
        WaveEstimate estimate;
        Descent descent;
    };

    Estimated estimate_window(const Window& window, const WaveParameters& start) const {
        const Descent descent = descend(window, bracket_, start);
        const WaveParameters& found = descent.parameters;
        Flags flags = 0;
        if (!descent.converged) {
            set(flags, Flag::not_converged);
        }
        const Phasors phasors = to_phasors(found.state);
        return {complete_estimate({canonical(found.state), phasors, found.w, 5, flags}, window,
                                  options_),
                descent};
    }

    // From the window before, where that has been found.
    WaveEstimate estimate_next(const Window& window, double centre_s) {
        if (has_gap(window.c) || has_gap(window.d)) {
            previous_.reset();
            return no_estimate(Flag::gap);
        }
        const Estimated found = estimate_window(
            window, previous_ ? carried(previous_->parameters, previous_->centre_s, centre_s)
                              : start_values(window, centre_s));
        if (found.descent.converged) {
            previous_ = Previous{found.descent.parameters, centre_s};
        }
        return found.estimate;
    }

    EstimatorOptions options_;
    FrequencyBracket bracket_;
    CarrierSums sums_;
    std::optional<Previous> previous_;
};

}  // namespace

std::unique_ptr<Estimator> make_conjugate_gradient(const EstimatorOptions& options) {
    return std::make_unique<ConjugateGradient>(options);
}

}  // namespace vybeg
