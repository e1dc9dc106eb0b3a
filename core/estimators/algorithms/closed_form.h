#pragma once

#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/closed_series.h"
#include "core/estimators/batch/window_series.h"
#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/frequency_bracket.h"
#include "core/estimators/wave/window_estimate.h"
#include "core/estimators/wave/window_moments.h"

#include <vector>

namespace vybeg {

// Averages over a window that do not depend on the frequency.
struct WindowPowers {
    double cc = 0;       // <S_C^2>
    double dd = 0;       // <S_D^2>
    double cd = 0;       // <S_C S_D>
    double quarter = 0;  // <S_C(t) S_D(t - t3)>, algorithm 2 only
};

// The two signals as an algorithm's closed forms make them at one frequency: S_C ~ Re(c e^{iwu})
// and so on. (a_A, a_B, 2theta_A, alpha) as that algorithm finds them; a_B is NaN where it does
// not.
struct ClosedForm {
    WaveState state;
    Phasors phasors;
};

// The averages of a window, and its demodulated components 2<S e^{-iwu}>.
WindowPowers window_powers(const Window& window);
Projections demodulate(const Window& window, double w);

// What the article's algorithms 1 to 4 share: four parameters in closed form at a given frequency,
// and the frequency from the minimum of J, (16), (25), (29), in one parameter.
class ClosedFormEstimator : public Estimator {
public:
    void estimate(const WindowBlock& block, double centre_s, std::span<WaveEstimate> out) override;

protected:
    explicit ClosedFormEstimator(const EstimatorOptions& options);

    // The algorithm's closed forms. mean.c = 2<S_C e^{-iwu}>, mean.d likewise: the demodulated
    // components (31) as C_x - i S_x and C_y - i S_y.
    virtual ClosedForm closed_form(const WindowPowers& powers, const Projections& mean,
                                   double w) const = 0;
    // The same for windows side by side, at the minimum of J.
    virtual void closed_series(const SeriesBatch& batch, const SeriesFrame& frame,
                               ClosedSeries& found) const = 0;
    // S_D delayed by a quarter period, as many samples as the block has; empty where it is not
    // needed.
    virtual std::vector<double> quarter_delayed(const WindowBlock& block) const;
    virtual Flags own_flags() const { return 0; }
    virtual int parameter_count() const { return 5; }

    const EstimatorOptions& options() const { return options_; }

private:
    // A window and what was summed up over it.
    struct SummedWindow {
        Window window;
        WindowPowers powers;
        const SeriesBatch& batch;
        std::size_t lane;
        const SeriesFrame& frame;
    };

    // Where Newton's steps on the series do not arrive: J by a search over the main lobe.
    WaveEstimate estimate_window(const SummedWindow& summed) const;
    BestWave best_of_lane(const ClosedSeries& series, std::size_t lane) const;
    // demodulate() and window_kernel(), by the series where it reaches.
    Projections demodulated(const SummedWindow& summed, double w) const;
    static WindowKernel kernel(const SeriesFrame& frame, double w);

    EstimatorOptions options_;
    FrequencyBracket bracket_;
    CarrierSums sums_;
};

// The in-phase closed forms (15), (18) of one window at a given frequency: the start values of
// algorithm 5.
WaveState in_phase_start(const Window& window, double w);

std::unique_ptr<Estimator> make_in_phase(const EstimatorOptions& options);
std::unique_ptr<Estimator> make_phase_shift(const EstimatorOptions& options);
std::unique_ptr<Estimator> make_moving_axes(const EstimatorOptions& options);
std::unique_ptr<Estimator> make_demodulation(const EstimatorOptions& options);

// 4theta_A from (20) with the correct factor, halved: 2theta_A in (-pi/2, pi/2].
double wave_angle(const WindowPowers& powers);

// alpha from (18) in its correct form: the phase of S_A = S_C cos 2theta_A + S_D sin 2theta_A.
double wave_phase(double two_theta_A, const Projections& mean);

}  // namespace vybeg
