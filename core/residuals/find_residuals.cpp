#include "core/residuals/find_residuals.h"

#include "core/numerics/spectral_density.h"
#include "core/residuals/signal_curves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t longest_segment = std::size_t{1} << 15;  // 1 Hz at 33333 Hz
constexpr std::size_t least_segment = 16;
constexpr std::size_t most_lags = 1000;

// A segment of which there are about eight in all samples and two in the longest part, but no less
// than 256 bins where the samples suffice.
std::size_t segment_of(const ResidualSamples& samples) {
    std::size_t longest = 0;
    for (std::size_t part = 0; part < samples.parts(); ++part) {
        longest = std::max(longest, samples.c_of(part).size());
    }
    const std::size_t wished =
        std::clamp(std::min(samples.c.size() / 8, longest / 2), std::size_t{512}, longest_segment);
    return std::bit_floor(std::min(wished, longest));
}

void add(const Densities& from, Densities& to) {
    for (std::size_t channel = 0; channel < to.size(); ++channel) {
        to[channel].resize(from[channel].size());
        for (std::size_t k = 0; k < from[channel].size(); ++k) {
            to[channel][k] += from[channel][k];
        }
    }
}

void divide(Densities& sums, int count) {
    for (std::vector<double>& sum : sums) {
        for (double& density : sum) {
            density /= std::max(count, 1);
        }
    }
}

Result<ResidualSpectrum> spectrum_of(const ResidualSamples& samples, double rate_hz,
                                     const JobControl& job) {
    ResidualSpectrum spectrum;
    const std::size_t size = segment_of(samples);
    if (size < least_segment) {
        return spectrum;
    }
    SpectralDensity density(size, rate_hz);
    spectrum.bin_hz = density.bin_hz();
    for (std::size_t part = 0; part < samples.parts(); ++part) {
        const auto c = samples.c_of(part);
        const auto d = samples.d_of(part);
        for (const std::size_t begin : segments_of(c.size(), size)) {
            TRY(job.go_on());
            const std::size_t middle = samples.part_begins[part] + begin + size / 2;
            const std::size_t half = 2 * middle < samples.c.size() ? 0 : 1;
            density.add_to(spectrum.halves[half], c.subspan(begin, size), d.subspan(begin, size));
            ++spectrum.segments_of_half[half];
        }
    }
    for (std::size_t half = 0; half < spectrum.halves.size(); ++half) {
        if (spectrum.segments_of_half[half] > 0) {
            add(spectrum.halves[half], spectrum.mean);
            divide(spectrum.halves[half], spectrum.segments_of_half[half]);
        }
        spectrum.segments += spectrum.segments_of_half[half];
    }
    divide(spectrum.mean, spectrum.segments);
    return spectrum;
}

// Mean diagonal of the projection onto the parameters of a window, over the samples that belong to
// it: one half for the phase and amplitude of each channel, and the square of the time from the
// centre for the frequency, which weighs the ends of the window most.
double taken_up_by(const Analysis& analysis) {
    const auto n = static_cast<double>(analysis.plan.length);
    const double own = std::min(1.0, static_cast<double>(analysis.plan.hop) / n);
    const double at_centre = analysis.settings.algorithm == Algorithm::in_phase ? 3 : 4;
    return (at_centre + own * own) / (2 * n);
}

ResidualChannel channel_of(const std::vector<double>& samples, bool white, double taken_up) {
    ResidualChannel channel;
    channel.moments = moments_of(samples);
    channel.histogram = histogram_of(samples, channel.moments);
    if (white && taken_up < 1) {
        channel.noise_sd = channel.moments.sd / std::sqrt(1 - taken_up);
    }
    return channel;
}

constexpr std::int64_t most_frames = std::int64_t{1} << 20;
constexpr std::int64_t block_frames = std::int64_t{1} << 16;

// First frame and end.
std::pair<std::int64_t, std::int64_t> frames_of(const ResidualRange& range, const WindowPlan& plan,
                                                double rate_hz) {
    if (range.window) {
        return {plan.start(*range.window), plan.start(*range.window) + plan.length};
    }
    const std::int64_t end = plan.start(plan.count - 1) + plan.length;
    const auto frame_at = [&](double seconds) {
        return std::clamp(seconds * rate_hz, static_cast<double>(plan.first),
                          static_cast<double>(end));
    };
    const auto last = static_cast<std::int64_t>(std::floor(frame_at(range.time.to_s) + 1e-6));
    return {static_cast<std::int64_t>(std::ceil(frame_at(range.time.from_s) - 1e-6)),
            std::min(last + 1, end)};
}

}  // namespace

Result<Residuals> find_residuals(const Recording& recording, const Analysis& analysis,
                                 const ResidualRange& range, const JobControl& job) {
    auto samples = TRY(residual_samples(recording, analysis, range, job));
    Residuals found;
    static_cast<ResidualFrames&>(found) = samples;
    found.rate_hz = recording.rate_hz;
    found.f0_hz = analysis.f0_hz();
    found.taken_up = taken_up_by(analysis);
    const bool white = !analysis.settings.filter;
    found.c = channel_of(samples.c, white, found.taken_up);
    found.d = channel_of(samples.d, white, found.taken_up);
    if (samples.c.empty()) {
        return found;
    }
    found.correlation_limit = 1.96 / std::sqrt(static_cast<double>(samples.c.size()));
    for (double& value : samples.c) {
        value -= found.c.moments.mean;
    }
    for (double& value : samples.d) {
        value -= found.d.moments.mean;
    }
    auto spectrum = TRY(spectrum_of(samples, recording.rate_hz, job));
    LaggedProducts products(std::min(most_lags, samples.c.size() / 4));
    for (std::size_t part = 0; part < samples.parts(); ++part) {
        TRY(job.go_on());
        products.add(samples.c_of(part), samples.d_of(part));
    }
    found.lines = residual_lines(spectrum, recording, analysis);
    found.bin_hz = spectrum.bin_hz;
    found.segments = spectrum.segments;
    found.c.density = std::move(spectrum.mean[0]);
    found.d.density = std::move(spectrum.mean[1]);
    auto correlations = products.correlations();
    found.c.autocorrelation = std::move(correlations[0]);
    found.d.autocorrelation = std::move(correlations[1]);
    return found;
}

Result<ResidualSamples> residual_samples(const Recording& recording, const Analysis& analysis,
                                         const ResidualRange& range, const JobControl& job) {
    // Of an analysis that outlives this function.
    const auto source =
        TRY(signal_source(recording, {std::shared_ptr<const Analysis>(), &analysis}, job));
    const auto [begin, end] = frames_of(range, analysis.plan, recording.rate_hz);
    const std::int64_t count = std::max<std::int64_t>(end - begin, 0);
    ResidualSamples found;
    found.frames = count;
    const auto expected = static_cast<std::size_t>(std::min(count, most_frames));
    found.c.reserve(expected);
    found.d.reserve(expected);
    const bool whole = count <= most_frames;
    const std::int64_t blocks =
        whole ? (count + block_frames - 1) / block_frames : most_frames / block_frames;
    bool in_part = false;
    std::int64_t next = begin;  // frame that continues the part
    for (std::int64_t b = 0; b < blocks; ++b) {
        const std::int64_t first =
            begin + (whole ? b * block_frames : (count - block_frames) / (blocks - 1) * b);
        const auto block = TRY(
            signal_excerpt(source, first, std::min(block_frames, end - first), job, range.window));
        in_part = in_part && first == next;
        next = first + static_cast<std::int64_t>(block.size());
        found.examined += next - first;
        for (std::size_t k = 0; k < block.size(); ++k) {
            const double c = block.residual_c(k);
            const double d = block.residual_d(k);
            if (!std::isfinite(c) || !std::isfinite(d)) {
                ++found.without;
                in_part = false;
                continue;
            }
            if (!in_part) {
                found.part_begins.push_back(found.c.size());
                in_part = true;
            }
            found.c.push_back(c);
            found.d.push_back(d);
        }
        job.report(static_cast<double>(b + 1) / static_cast<double>(blocks));
    }
    return found;
}

}  // namespace vybeg
