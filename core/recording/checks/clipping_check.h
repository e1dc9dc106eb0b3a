#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace vybeg {

// Frames [first, first + count).
struct FrameRange {
    std::int64_t first = 0;
    std::int64_t count = 0;

    std::int64_t end() const { return first + count; }

    friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

// Finds the samples of one channel at the rail of the converter, in one pass.
//
// Criterion of a rail: the extreme value occurs repeatedly, in clusters, and far more often than
// the levels inward. A clean sinusoid also repeats its top level, but then the next level occurs
// nearly half as often, and the top m levels together sqrt(m) times.
class ClippingCheck {
public:
    // Adds the next samples, in order; first_frame is the frame of x[0]. NaN is ignored.
    void add(std::int64_t first_frame, std::span<const double> x);

    // Whether samples between these values only need counting, without a test of each.
    bool are_inside(double lowest, double highest) const;
    void pass_over(std::size_t count) { count_ += static_cast<std::int64_t>(count); }

    struct Rail {
        double level = 0;
        std::int64_t count = 0;
        std::vector<FrameRange> places;  // in order; neighbours are merged beyond `most_places`
    };
    // Detected rails, none to two: the upper, the lower.
    std::vector<Rail> rails() const;

    // Number of levels of the channel: 1 (constant), 2, or 3 for more; 0 without a sample. One or
    // two are no rail: the signal is below one bit of the converter.
    int levels() const;

    static constexpr std::size_t most_places = 1 << 16;

private:
    // Extreme of one side, as a maximum.
    struct Extreme {
        struct Level {
            double value = std::numeric_limits<double>::lowest();
            std::int64_t count = 0;
        };
        double level = std::numeric_limits<double>::lowest();
        std::int64_t count = 0;
        std::array<Level, 15> below;  // the highest levels below, falling
        std::int64_t last_frame = 0;
        std::int64_t neighbours = 0;  // occurrences soon after the previous one
        std::int64_t common = 0;      // divisor of all distances between occurrences
        std::vector<FrameRange> places;
        std::int64_t drawn_together = 0;  // frames between merged places

        void add(std::int64_t frame, double value);
        void add_below(const Level& more);
        void draw_together();
        bool is_rail() const;
        // Below it a sample changes nothing.
        double least() const { return below.back().value; }
    };

    std::int64_t count_ = 0;  // finite samples
    Extreme upper_;
    Extreme lower_;  // of the negated samples
};

}  // namespace vybeg
