#pragma once

#include "core/base/result.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace vybeg {

// The source behind a zero-phase band-pass (METHOD section 3, --filter): a symmetric
// Kaiser-windowed FIR, passband flat within 1e-4 from low_hz to high_hz, 80 dB down beyond a
// transition of half the band's width on either side (less where 0 or half the rate is nearer),
// applied by FFT overlap-save while reading. A channel is NaN where the filter's half-length
// reaches beyond an end or to a missing sample of it. Errors: band_invalid, filter_too_long
// (`where` is left to the caller).
//
// The gain at unit_hz is exactly 1 where that lies in the passband: a carrier keeps its amplitude,
// which windows know better than the passband's ripple. Without it the gain is 1 within the ripple.
Result<std::shared_ptr<const SampleSource>> band_passed(std::shared_ptr<const SampleSource> source,
                                                        double low_hz, double high_hz,
                                                        double rate_hz,
                                                        std::optional<double> unit_hz = {});

// The filter's half-length in samples: what it takes at each end. Precondition: 0 < low_hz <
// high_hz < rate_hz / 2.
std::int64_t band_pass_reach(double low_hz, double high_hz, double rate_hz);

// The half h[0] .. h[M] of its impulse response, M its half-length. Same precondition.
std::vector<double> band_pass_response(double low_hz, double high_hz, double rate_hz);

}  // namespace vybeg
