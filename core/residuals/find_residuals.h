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

// The residual of an analysis in a range, its distribution, spectrum and autocorrelation.
// Precondition and errors as of residual_samples().
Result<Residuals> find_residuals(const Recording& recording, const Analysis& analysis,
                                 const ResidualRange& range, const JobControl& job);

// Residuals of both channels, part after part of consecutive frames.
struct ResidualSamples {
    std::vector<double> c;
    std::vector<double> d;
    std::vector<std::size_t> part_begins;  // in c and d
    std::int64_t frames = 0;               // as of Residuals
    std::int64_t examined = 0;
    std::int64_t without = 0;

    std::size_t parts() const { return part_begins.size(); }
    std::span<const double> c_of(std::size_t part) const { return cut(c, part); }
    std::span<const double> d_of(std::size_t part) const { return cut(d, part); }

private:
    std::span<const double> cut(const std::vector<double>& all, std::size_t part) const {
        const std::size_t end = part + 1 < parts() ? part_begins[part + 1] : all.size();
        return std::span(all).subspan(part_begins[part], end - part_begins[part]);
    }
};

// The samples of a range, conditioned as the analysis conditions them, less the wave (6) of the
// window whose centre is nearest, the later one of two; of a single window, less its own wave. Of
// more than 2^20 frames 16 blocks at even distances are read. Precondition: the analysis is one of
// this recording and has all rows of its plan. Errors: those of prepare(); interrupted.
Result<ResidualSamples> residual_samples(const Recording& recording, const Analysis& analysis,
                                         const ResidualRange& range, const JobControl& job);

}  // namespace vybeg
