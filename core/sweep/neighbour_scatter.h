#pragma once

#include "core/estimators/wave/estimator.h"
#include "core/sweep/window_sweep.h"
#include "core/track/track.h"
#include "core/windows/window_plan.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vybeg {

// Scatter of adjacent windows (hop = length) of one track, whose rows arrive in pieces.
//
// Scatter: sixth differences of seven neighbouring windows over sqrt(924), in units of the
// Cramer-Rao bound of the window in the middle. The errors of adjacent windows in white noise are
// independent, so that every order of differences has the same expectation, while a motion of the
// angular frequency v enters with (2 sin(vT/2))^6: of a beat of 1 Hz in windows of 18 ms 7e-8 of
// its amplitude remains, of first differences 8e-2. The unit of the bound makes windows of
// different amplitude comparable. Values beyond four times the median's deviation do not count,
// so that some disturbed windows do not matter.
//
// Motion: second differences D of the same windows, x'' T^2, less the part of the scatter:
// sqrt(<D^2> - 6 scatter^2) / 24.
//
// Of more than 2^16 windows every k-th is the middle of such a group: memory does not grow.
class NeighbourScatter {
public:
    // `angle_zero`: twice the angle of the first electrode, which the track has subtracted.
    // `faults`: windows over faults of the samples. `noise`: the white noise of the recording, for
    // phasors and frequency.
    NeighbourScatter(const WindowPlan& plan, double rate_hz, double angle_zero,
                     std::vector<FlaggedRows> faults, const EquivalentNoise& noise);

    void take(const Track& next_rows);
    SweepLength finish() const;

private:
    struct Row {
        std::array<double, sweep_variable_count> values{};
        std::array<double, sweep_variable_count> sds{};
        double alpha = 0;
        bool counts = false;
    };
    struct Sums {
        std::vector<double> sixth;   // differences in units of the bound
        std::vector<double> second;  // of the same windows
        std::vector<double> stated;  // in units of the bound
        std::vector<double> bound;   // for noise of one recording unit
    };
    static constexpr std::size_t held_rows = 7;

    Row row_of(const Track& track, std::size_t k);
    bool over_fault(std::size_t row);
    void judge_middle();

    WindowPlan plan_;
    double rate_hz_;
    double angle_zero_;
    std::vector<FlaggedRows> faults_;
    std::size_t next_fault_ = 0;
    EquivalentNoise noise_;
    std::size_t stride_;
    std::size_t rows_ = 0;
    std::int64_t used_ = 0;
    double rms_squares_ = 0;
    double noise_squares_ = 0;
    std::array<Row, held_rows> held_;
    std::array<Sums, sweep_variable_count> sums_;
};

}  // namespace vybeg
