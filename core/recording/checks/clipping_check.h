#pragma once

#include <cstddef>
#include <cstdint>
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

// Finds the samples of one channel that lie at the rail of the converter, as the samples come by.
//
// A rail shows in the samples themselves: the extreme value is met again and again, far more often
// than the next one inward, and in clusters. A clean sinusoid of a coarse converter also meets its
// top level often, but then the next level nearly half as often.
class ClippingCheck {
public:
    // The next samples, in order; first_frame is the place of x[0]. NaN does not count.
    void add(std::int64_t first_frame, std::span<const double> x);

    // Whether samples between these would only be counted; then count them without a look at each.
    bool are_inside(double lowest, double highest) const;
    void pass_over(std::size_t count) { count_ += static_cast<std::int64_t>(count); }

    struct Rail {
        double level = 0;
        std::int64_t count = 0;
        std::vector<FrameRange> places;  // in order; near ones drawn together beyond `most_places`
    };
    // The rails that were met, none to two: the upper, the lower.
    std::vector<Rail> rails() const;

    // How many levels the channel takes: 1 (constant), 2, or 3 for more; 0 without a sample. One or
    // two are no rail: the signal is below one bit of the converter.
    int levels() const;

    static constexpr std::size_t most_places = 1 << 16;

private:
    // The extreme of one side, seen as a maximum.
    struct Extreme {
        double level = 0;
        double next = 0;  // the highest level below
        std::int64_t count = 0;
        std::int64_t next_count = 0;
        std::int64_t last_frame = 0;
        std::int64_t neighbours = 0;  // meetings soon after the one before
        std::int64_t common = 0;      // divisor of all distances between meetings
        std::vector<FrameRange> places;
        std::int64_t drawn_together = 0;  // frames between places that count as one

        void add(std::int64_t frame, double value);
        void draw_together();
        bool is_rail() const;
    };

    std::int64_t count_ = 0;  // finite samples
    Extreme upper_;
    Extreme lower_;  // of the negated samples
};

}  // namespace vybeg
