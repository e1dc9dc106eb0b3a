#include "core/recording/conditioning/conditioned_source.h"

#include "core/numerics/fft.h"
#include "core/numerics/kaiser.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
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

namespace {

// A band-pass is the difference of two low-passes, whose ripples may add: 87 dB each (4.5e-5) keep
// their sum within 1e-4 and 80 dB.
constexpr double attenuation_db = 87;

// From an edge of the band to where the stopband begins, Hz. One width serves both sides: the
// narrower one decides about the length anyway.
double transition_hz(double low_hz, double high_hz, double rate_hz) {
    return std::min({(high_hz - low_hz) / 2, low_hz, rate_hz / 2 - high_hz});
}

KaiserDesign design(double low_hz, double high_hz, double rate_hz) {
    return kaiser_design(attenuation_db, transition_hz(low_hz, high_hz, rate_hz) / rate_hz);
}

// Response of a symmetric filter h[-M] .. h[M] at a frequency, cycles per sample.
double gain_at(const std::vector<double>& taps, double frequency) {
    double gain = taps[0];
    for (std::size_t m = 1; m < taps.size(); ++m) {
        const double turns = std::remainder(frequency * static_cast<double>(m), 1.0);
        gain += 2 * taps[m] * std::cos(2 * std::numbers::pi * turns);
    }
    return gain;
}

// out[i] becomes NaN where one of in[i] .. in[i + 2 reach] is missing.
void spread_missing(std::span<const double> in, std::int64_t reach, std::span<double> out) {
    std::int64_t marked = 0;
    for (std::int64_t j = 0; j < std::ssize(in); ++j) {
        if (!std::isfinite(in[j])) {
            const std::int64_t end = std::min(std::ssize(out), j + 1);
            for (marked = std::max(marked, j - 2 * reach); marked < end; ++marked) {
                out[marked] = std::numeric_limits<double>::quiet_NaN();
            }
        }
    }
}

// The output lies on a grid of blocks from frame 0, each computed from the same input samples
// whatever is read: a frame has the same bits however reads are cut.
class FilteredSource final : public SampleSource {
public:
    FilteredSource(std::shared_ptr<const SampleSource> source, const std::vector<double>& taps)
        : source_(std::move(source)),
          reach_(std::ssize(taps) - 1),
          fft_(fft_size(reach_)),
          block_length_(static_cast<std::int64_t>(fft_.size()) - 2 * reach_) {
        // A symmetric filter wrapped around time 0 has a real response: no phase.
        std::vector<std::complex<double>> wrapped(fft_.size());
        wrapped[0] = taps[0];
        for (std::size_t m = 1; m < taps.size(); ++m) {
            wrapped[m] = wrapped[wrapped.size() - m] = taps[m];
        }
        fft_.forward(wrapped);
        response_.reserve(wrapped.size());
        for (const std::complex<double>& value : wrapped) {
            response_.push_back(value.real() / static_cast<double>(fft_.size()));
        }
    }

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        const std::int64_t end = first + std::ssize(c);
        for (std::int64_t index = first / block_length_; index * block_length_ < end; ++index) {
            const auto block = TRY(find_or_compute(index));
            block->copy_to(first, c, d);
        }
        return {};
    }

private:
    // Eight half-lengths or more: at most a quarter of a transform is overlap.
    static std::size_t fft_size(std::int64_t reach) {
        return std::bit_ceil(std::max<std::size_t>(4096, 8 * static_cast<std::size_t>(reach)));
    }

    // Several threads compute at once, at worst the same block.
    Result<SampleBlockPointer> find_or_compute(std::int64_t index) const {
        if (auto block = recent_.find(index)) {
            return block;
        }
        auto block = compute(index);
        if (block) {
            recent_.keep(*block);
        }
        return block;
    }

    Result<SampleBlockPointer> compute(std::int64_t index) const {
        const std::size_t size = fft_.size();
        std::vector<double> in_c(size, std::numeric_limits<double>::quiet_NaN());
        std::vector<double> in_d(in_c);
        const std::int64_t start = index * block_length_ - reach_;
        const std::int64_t begin = std::max<std::int64_t>(0, start);
        const std::int64_t end = std::min(frames(), start + static_cast<std::int64_t>(size));
        const auto at = static_cast<std::size_t>(begin - start);
        const auto count = static_cast<std::size_t>(end - begin);
        TRY(source_->read(begin, std::span(in_c).subspan(at, count),
                          std::span(in_d).subspan(at, count)));

        // The response is real, so that C + iD goes through in one transform, and stays apart.
        std::vector<std::complex<double>> both(size);
        for (std::size_t j = 0; j < size; ++j) {
            both[j] = {std::isfinite(in_c[j]) ? in_c[j] : 0, std::isfinite(in_d[j]) ? in_d[j] : 0};
        }
        fft_.forward(both);
        for (std::size_t j = 0; j < size; ++j) {
            both[j] *= response_[j];
        }
        fft_.inverse(both);

        auto block = std::make_shared<SampleBlock>();
        block->index = index;
        block->first = index * block_length_;
        block->c.reserve(static_cast<std::size_t>(block_length_));
        block->d.reserve(static_cast<std::size_t>(block_length_));
        for (std::int64_t j = reach_; j < reach_ + block_length_; ++j) {
            block->c.push_back(both[j].real());
            block->d.push_back(both[j].imag());
        }
        spread_missing(in_c, reach_, block->c);
        spread_missing(in_d, reach_, block->d);
        return SampleBlockPointer(std::move(block));
    }

    // Reads of a few threads, each going on where its last one ended inside a block.
    static constexpr std::size_t recent_blocks = 4;

    std::shared_ptr<const SampleSource> source_;
    std::int64_t reach_;
    Fft fft_;
    std::int64_t block_length_;
    std::vector<double> response_;  // divided by the size, which Fft leaves to its callers
    RecentBlocks recent_{recent_blocks};
};

}  // namespace

Result<std::shared_ptr<const SampleSource>> band_passed(std::shared_ptr<const SampleSource> source,
                                                        double low_hz, double high_hz,
                                                        double rate_hz,
                                                        std::optional<double> unit_hz) {
    if (!(0 < low_hz && low_hz < high_hz && high_hz < rate_hz / 2)) {
        return Error{.code = ErrorCode::band_invalid,
                     .where = "",
                     .args = {number_arg(low_hz), number_arg(high_hz), number_arg(rate_hz / 2)}};
    }
    const KaiserDesign kaiser = design(low_hz, high_hz, rate_hz);
    if (2 * kaiser.half_length >= source->frames()) {
        return Error{.code = ErrorCode::filter_too_long,
                     .where = "",
                     .args = {count_arg(kaiser.half_length), count_arg(source->frames())}};
    }
    std::vector<double> taps = band_pass_response(low_hz, high_hz, rate_hz);
    if (unit_hz && low_hz <= *unit_hz && *unit_hz <= high_hz) {
        const double gain = gain_at(taps, *unit_hz / rate_hz);
        for (double& tap : taps) {
            tap /= gain;
        }
    }
    return std::shared_ptr<const SampleSource>(
        std::make_shared<FilteredSource>(std::move(source), taps));
}

std::int64_t band_pass_reach(double low_hz, double high_hz, double rate_hz) {
    return design(low_hz, high_hz, rate_hz).half_length;
}

std::vector<double> band_pass_response(double low_hz, double high_hz, double rate_hz) {
    const double half_transition = transition_hz(low_hz, high_hz, rate_hz) / 2;
    return band_pass_taps((low_hz - half_transition) / rate_hz,
                          (high_hz + half_transition) / rate_hz, design(low_hz, high_hz, rate_hz));
}

}  // namespace vybeg
