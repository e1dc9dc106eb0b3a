#pragma once

#include "core/recording/samples/sample_source.h"

#include <QString>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

// What the tests of sources on sources share.

namespace vybeg::test {

inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

struct Samples {
    std::vector<double> c;
    std::vector<double> d;

    bool operator==(const Samples&) const = default;
};

inline std::shared_ptr<const SampleSource> source_of(Samples samples) {
    return memory_source(std::move(samples.c), std::move(samples.d));
}

// Frames [first, first + length), or nothing where the source fails.
inline Samples read(const SampleSource& source, std::int64_t first, std::int64_t length) {
    Samples samples{std::vector<double>(static_cast<std::size_t>(length)),
                    std::vector<double>(static_cast<std::size_t>(length))};
    return source.read(first, samples.c, samples.d) ? samples : Samples{};
}

inline Samples read_all(const SampleSource& source) {
    return read(source, 0, source.frames());
}

// Two independent noises of unit deviation.
inline Samples noise(std::int64_t frames, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Samples samples;
    for (std::int64_t i = 0; i < frames; ++i) {
        samples.c.push_back(normal(random));
        samples.d.push_back(normal(random));
    }
    return samples;
}

// Equal to the last bit, NaN included.
inline bool same_bits(std::span<const double> a, std::span<const double> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

// Equal to the last bit, but for what is NaN in both.
inline bool same_numbers(std::span<const double> a, std::span<const double> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return (std::isnan(x) && std::isnan(y)) || std::memcmp(&x, &y, sizeof x) == 0;
    });
}

// Whether 300 random reads of 1 to `longest` frames, and one through the whole in steps of 777,
// give the bits of one read of everything.
inline bool same_however_cut(const SampleSource& source, std::int64_t longest) {
    const Samples all = read_all(source);
    const auto same_at = [&](std::int64_t first, std::int64_t length) {
        const Samples part = read(source, first, length);
        const auto at = static_cast<std::size_t>(first);
        const auto count = static_cast<std::size_t>(length);
        return same_bits(part.c, std::span(all.c).subspan(at, count)) &&
               same_bits(part.d, std::span(all.d).subspan(at, count));
    };
    std::mt19937_64 random(3);
    for (int i = 0; i < 300; ++i) {
        const auto length = static_cast<std::int64_t>(1 + random() % longest);
        const auto first = static_cast<std::int64_t>(random() % (source.frames() - length + 1));
        if (!same_at(first, length)) {
            return false;
        }
    }
    for (std::int64_t at = 0; at < source.frames(); at += 777) {
        if (!same_at(at, std::min<std::int64_t>(777, source.frames() - at))) {
            return false;
        }
    }
    return true;
}

// Frames that are NaN, as half-open ranges, e.g. "0-21 400-443".
inline QString missing_ranges(const std::vector<double>& x) {
    QStringList ranges;
    for (std::size_t i = 0; i < x.size();) {
        std::size_t end = i;
        while (end < x.size() && std::isnan(x[end])) {
            ++end;
        }
        if (end > i) {
            ranges << QString("%1-%2").arg(i).arg(end);
        }
        i = end + 1;
    }
    return ranges.join(' ');
}

// The largest |a - b| where a is no NaN; infinite where b alone is, or where nothing is left.
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = -1;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!std::isnan(a[i])) {
            const double difference = std::abs(a[i] - b[i]);
            largest = std::isnan(difference) ? std::numeric_limits<double>::infinity()
                                             : std::max(largest, difference);
        }
    }
    return largest < 0 ? std::numeric_limits<double>::infinity() : largest;
}

// A source whose disk has failed.
class FailingSource final : public SampleSource {
public:
    explicit FailingSource(std::int64_t frames) : frames_(frames) {}
    std::int64_t frames() const override { return frames_; }
    Status read(std::int64_t, std::span<double>, std::span<double>) const override {
        return error();
    }
    static Error error() {
        return {.code = ErrorCode::file_read_failed, .where = "a.wav", .args = {"disk"}};
    }

private:
    std::int64_t frames_;
};

}  // namespace vybeg::test
