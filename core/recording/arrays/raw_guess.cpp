#include "core/recording/arrays/raw_guess.h"

#include "core/recording/arrays/raw_reader.h"
#include "core/recording/bytes/number_decoding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace vybeg {
namespace {

constexpr std::size_t channels = 2;
constexpr std::int64_t front_bytes = std::int64_t{1} << 14;  // possible extent of a header
constexpr std::int64_t body_bytes = std::int64_t{1} << 16;   // after it, basis of the guess
constexpr std::int64_t longest_raw_header = std::int64_t{1} << 13;
constexpr std::int64_t round_length = 64;  // usual multiple of header lengths
constexpr double never = std::numeric_limits<double>::infinity();

// A layout and the statistics of the body under it.
struct Candidate {
    RawLayout layout;
    std::int64_t shift = 0;  // offset of the first sample from a multiple of its width, bytes
    double noise = never;  // residual power of the prediction from two samples, relative; 1: white
    double rms = 0;
    double step_rms = 0;  // of x[n] - a x[n-1] + x[n-2]
    double a = 0;
    std::array<double, channels> mean{};
};

std::vector<double> samples(std::string_view bytes, const RawLayout& layout, std::int64_t shift) {
    const NumberType type = number_type(layout.type);
    const std::int64_t width = bytes_of(type);
    const std::int64_t room = static_cast<std::int64_t>(bytes.size()) - shift;
    std::vector<double> values(static_cast<std::size_t>(std::max<std::int64_t>(room / width, 0)));
    if (!values.empty()) {
        decode(type, layout.big_endian, bytes.data() + shift, width, {}, values);
    }
    return values;
}

// Removes each channel's mean from its samples.
std::array<double, channels> centre(std::vector<double>& values) {
    std::array<double, channels> mean{};
    std::array<double, channels> count{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isnan(values[i])) {
            mean[i % channels] += values[i];
            count[i % channels] += 1;
        }
    }
    for (std::size_t k = 0; k < channels; ++k) {
        mean[k] = count[k] > 0 ? mean[k] / count[k] : 0;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] -= mean[i % channels];
    }
    return mean;
}

Candidate judge(std::string_view body, const RawLayout& layout, std::int64_t shift) {
    Candidate found{.layout = layout, .shift = shift};
    std::vector<double> x = samples(body, layout, shift);
    found.mean = centre(x);
    double cross = 0;
    double power = 0;
    double sums = 0;
    double count = 0;
    for (std::size_t i = 2 * channels; i < x.size(); ++i) {
        const double middle = x[i - channels];
        const double sum = x[i] + x[i - 2 * channels];
        if (std::isnan(middle) || std::isnan(sum)) {
            continue;
        }
        cross += sum * middle;
        power += middle * middle;
        sums += sum * sum;
        count += 1;
    }
    // No real unit yields values beyond these bounds; misread bytes do.
    constexpr double smallest = 1e-15;
    constexpr double largest = 1e15;
    found.rms = std::sqrt(power / count);
    if (!(count > 0.9 * static_cast<double>(x.size())) || !(found.rms > smallest) ||
        !(found.rms < largest)) {
        return found;
    }
    found.a = std::clamp(cross / power, -2.0, 2.0);
    const double left = std::max(sums - 2 * found.a * cross + found.a * found.a * power, 0.0);
    found.step_rms = std::sqrt(left / count);
    found.noise = left / ((2 + found.a * found.a) * power);  // 1 for white noise, whatever a is
    return found;
}

constexpr double narrow = 0.25;  // upper limit of the noise of probable samples

// Noise with weights for the comparison of layouts.
double weighed(const Candidate& candidate) {
    const RawType type = candidate.layout.type;
    double noise = candidate.noise;
    if (type == RawType::f32 || type == RawType::f64) {
        // The bits of integers never form floating point numbers of a narrow band, while those of
        // floating point numbers can form integers of one.
        noise *= noise < narrow ? 1e-3 : 1.0;
    } else if (type == RawType::i32) {
        noise *=
            4;  // two consecutive 16 bit samples form one of 32 bits, with less noise if D is zero
    }
    return noise;
}

// The best candidate, its samples at multiples of their width or, `shifted`, between them.
Candidate best_of(std::string_view body, bool shifted) {
    Candidate best;
    for (const RawType type : {RawType::f64, RawType::f32, RawType::i16, RawType::i32}) {
        for (const bool big : {false, true}) {
            const RawLayout layout{.type = type, .big_endian = big};
            const std::int64_t shifts = shifted ? bytes_of(number_type(type)) : 1;
            for (std::int64_t shift = shifted ? 1 : 0; shift < shifts; ++shift) {
                const Candidate next = judge(body, layout, shift);
                // Counts below 128 are narrow in both byte orders, but larger in the wrong one.
                const bool same_bytes = best.layout.type == type && best.shift == shift;
                const double factor = same_bytes && next.rms < best.rms / 16   ? 2.0
                                      : same_bytes && next.rms > best.rms * 16 ? 0.5
                                                                               : 1.0;
                if (weighed(next) < factor * weighed(best)) {
                    best = next;
                }
            }
        }
    }
    return best;
}

// Start of the samples: after the last number at the front that does not follow from its
// neighbours.
std::int64_t header_length(std::string_view front, const Candidate& found) {
    constexpr double surely = 6;  // standard deviations
    std::vector<double> x = samples(front, found.layout, found.shift);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] -= found.mean[i % channels];
    }
    std::size_t begin = 0;
    for (std::size_t i = 2 * channels; i < x.size(); ++i) {
        const double step = x[i] - found.a * x[i - channels] + x[i - 2 * channels];
        if (!(std::abs(step) <= surely * found.step_rms)) {
            begin = i - 2 * channels + 1;
        }
    }
    const std::int64_t width = bytes_of(number_type(found.layout.type));
    const std::int64_t header = found.shift + static_cast<std::int64_t>(begin) * width;
    // The last number of a header may look like a sample, which makes the length one short.
    if (begin > 0 && (header + width) % round_length == 0) {
        return header + width;
    }
    return header <= longest_raw_header ? header : found.shift;
}

}  // namespace

Result<std::optional<RawLayout>> guess_raw_layout(const FileBytes& file) {
    // The body begins at a multiple of every width.
    const std::int64_t front_end = std::min(front_bytes, file.size() / 2 / 16 * 16);
    std::string bytes(static_cast<std::size_t>(front_bytes + body_bytes), '\0');
    const auto got = TRY(file.read(0, bytes));
    bytes.resize(static_cast<std::size_t>(got));
    const std::string_view whole = bytes;
    constexpr double most_noise = 0.5;
    const std::string_view body = whole.substr(static_cast<std::size_t>(front_end));
    Candidate best = best_of(body, false);
    if (!(best.noise < narrow)) {
        const Candidate shifted = best_of(body, true);
        best = weighed(shifted) < weighed(best) ? shifted : best;
    }
    if (!(best.noise < most_noise)) {
        return std::optional<RawLayout>{};
    }
    best.layout.skip_bytes =
        header_length(whole.substr(0, static_cast<std::size_t>(front_end)), best);
    return std::optional(best.layout);
}

}  // namespace vybeg
