#pragma once

#include "core/analysis/analysis.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"
#include "core/residuals/residuals.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

// Residuals of both channels, run after run of consecutive frames.
struct ResidualSamples {
    std::vector<double> c;
    std::vector<double> d;
    std::vector<std::size_t> run_begins;  // in c and d
    std::int64_t frames = 0;              // as of Residuals
    std::int64_t examined = 0;
    std::int64_t without = 0;

    std::size_t runs() const { return run_begins.size(); }
    std::span<const double> run_c(std::size_t run) const { return part(c, run); }
    std::span<const double> run_d(std::size_t run) const { return part(d, run); }

private:
    std::span<const double> part(const std::vector<double>& all, std::size_t run) const {
        const std::size_t end = run + 1 < runs() ? run_begins[run + 1] : all.size();
        return std::span(all).subspan(run_begins[run], end - run_begins[run]);
    }
};

// The samples of a range, conditioned as the analysis conditions them, less the wave (6) of the
// window whose centre is nearest, the later one of two; of a single window, less its own wave. Of
// more than 2^20 frames 16 blocks at even distances are read. Precondition: the analysis is one of
// this recording and has all rows of its plan. Errors: those of prepare(); interrupted.
Result<ResidualSamples> residual_samples(const Recording& recording, const Analysis& analysis,
                                         const ResidualRange& range, const JobControl& job);

}  // namespace vybeg
