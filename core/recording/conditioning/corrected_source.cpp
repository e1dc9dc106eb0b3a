#include "core/recording/conditioning/corrected_source.h"

#include "core/recording/samples/sample_source.h"

#include <utility>

namespace vybeg {

std::shared_ptr<const SampleSource> calibrated(std::shared_ptr<const SampleSource> source,
                                               const Calibration& calibration, double rate_hz) {
    if (calibration.delay_d_s != 0) {
        source = delayed_source(std::move(source), -calibration.delay_d_s * rate_hz);
    }
    if (calibration.kappa == 1 && calibration.offset_c == 0 && calibration.offset_d == 0) {
        return source;
    }
    return mapped_source(std::move(source), [=](std::span<double> c, std::span<double> d) {
        for (double& value : c) {
            value -= calibration.offset_c;
        }
        for (double& value : d) {
            value = calibration.kappa * (value - calibration.offset_d);
        }
    });
}

std::shared_ptr<const SampleSource> with_gaps(std::shared_ptr<const SampleSource> source,
                                              std::span<const PhaseStep> steps) {
    std::vector<SourcePiece> pieces{{0, source, 0, 0}};
    for (const PhaseStep& step : steps) {
        if (step.lost > 0) {
            pieces.back().count = step.frame - pieces.back().from;
            const std::int64_t first = pieces.back().end() + step.lost;
            pieces.push_back({first, source, step.frame, 0});
        }
    }
    pieces.back().count = source->frames() - pieces.back().from;
    return pieces.size() == 1 ? source : joined_source(std::move(pieces));
}

}  // namespace vybeg
