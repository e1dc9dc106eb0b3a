#include "core/estimators/algorithms/closed_form.h"

namespace vybeg {
namespace {

// Algorithm 4, (31)-(33): phasors by synchronous averages, then the inversion of METHOD section 1.
class Demodulation final : public ClosedFormEstimator {
public:
    explicit Demodulation(const EstimatorOptions& options) : ClosedFormEstimator(options) {}

private:
    ClosedForm closed_form(const WindowPowers&, const Projections& mean, double) const override {
        const Phasors phasors{mean.c, mean.d};
        return {to_wave_state(phasors), phasors};
    }

    void closed_series(const SeriesBatch& batch, const SeriesFrame& frame,
                       ClosedSeries& found) const override {
        demodulation_series(batch, frame, found);
    }
};

}  // namespace

std::unique_ptr<Estimator> make_demodulation(const EstimatorOptions& options) {
    return std::make_unique<Demodulation>(options);
}

}  // namespace vybeg
