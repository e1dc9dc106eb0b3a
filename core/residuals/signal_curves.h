#pragma once

#include "core/analysis/analysis.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace vybeg {

// What excerpts are taken from: the samples as an analysis conditions them (calibration, band-pass,
// gaps for lost samples), or as recorded without one. Kept for the next excerpt, because what a
// band-pass and lost samples need to know is searched once.
struct SignalSource {
    std::shared_ptr<const SampleSource> samples;
    double rate_hz = 0;
    std::shared_ptr<const Analysis> analysis;  // null: none
};

// Precondition: the analysis is one of this recording and has all rows of its plan. Errors: those
// of prepare().
Result<SignalSource> signal_source(const Recording& recording,
                                   std::shared_ptr<const Analysis> analysis, const JobControl& job);

// Samples of consecutive frames with the fitted wave (6) of the window that each belongs to
// (signal_curves.cpp), recording units. The wave is NaN where no window, or one without a wave, has
// the sample; its residual is the sample less the wave.
struct SignalExcerpt {
    std::int64_t first = 0;
    double rate_hz = 0;
    std::vector<double> c;
    std::vector<double> d;
    std::vector<double> fit_c;  // as long as c
    std::vector<double> fit_d;

    std::size_t size() const { return c.size(); }
    double time_s(std::size_t k) const {
        return (static_cast<double>(first) + static_cast<double>(k)) / rate_hz;
    }
    double residual_c(std::size_t k) const { return c[k] - fit_c[k]; }
    double residual_d(std::size_t k) const { return d[k] - fit_d[k]; }
};

// The frames [first, first + count) as far as the source has them; with `window` the wave is that
// of this window on all of them. Errors: those of the source; interrupted.
Result<SignalExcerpt> signal_excerpt(const SignalSource& source, std::int64_t first,
                                     std::int64_t count, const JobControl& job,
                                     std::optional<std::int64_t> window = {});

// A curve of both channels over time: seconds, recording units. NaN where no window, or one without
// a wave, has the time.
struct SignalCurve {
    std::vector<double> time_s;
    std::vector<double> c;
    std::vector<double> d;
};

// The wave (6) of the windows at `count` times at equal distances from from_s to to_s, also between
// samples; each time has the wave of the sample nearest to it (signal_curves.cpp). Preconditions:
// the track has all rows of its plan; count >= 2.
SignalCurve wave_curve(const Analysis& analysis, double rate_hz, double from_s, double to_s,
                       int count);

// Amplitudes of C and D, sqrt(a_A^2 cos^2 2theta_A + a_B^2 sin^2 2theta_A) and its like by (6), in
// columns of equal width: the mean of eight windows at most in each. Columns begin at whole
// multiples of their width, so that a curve that is panned does not flicker; one lies beyond each
// end. Preconditions: as above; count >= 1, from_s < to_s.
SignalCurve amplitude_curve(const Analysis& analysis, double rate_hz, double from_s, double to_s,
                            int count);

}  // namespace vybeg
