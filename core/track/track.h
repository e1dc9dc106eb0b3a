#pragma once

#include "core/base/result.h"
#include "core/estimators/wave/estimator.h"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace vybeg {

// The slow variables of a track; plots, tables and files iterate over this list.
enum class SlowVariable {
    a_A,
    a_B,
    two_theta_A,
    f,
    delta_phi_CD,
    alpha,
    noise,
    rms,
    orthogonality
};

inline constexpr int slow_variable_count = 9;

inline constexpr std::array<SlowVariable, slow_variable_count> all_slow_variables{
    SlowVariable::a_A,   SlowVariable::a_B,          SlowVariable::two_theta_A,
    SlowVariable::f,     SlowVariable::delta_phi_CD, SlowVariable::alpha,
    SlowVariable::noise, SlowVariable::rms,          SlowVariable::orthogonality};

// Variables of plots and tables. rms is in files only, replaced by noise: rms falls in short
// windows, because five parameters absorb more of their noise.
inline constexpr std::array<SlowVariable, slow_variable_count - 1> shown_slow_variables{
    SlowVariable::a_A,   SlowVariable::a_B,          SlowVariable::two_theta_A,
    SlowVariable::f,     SlowVariable::delta_phi_CD, SlowVariable::alpha,
    SlowVariable::noise, SlowVariable::orthogonality};

// The five that are always plotted, from top to bottom.
inline constexpr std::array<SlowVariable, 5> main_slow_variables{
    SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A, SlowVariable::f,
    SlowVariable::delta_phi_CD};

enum class Quantity { amplitude, angle, frequency, ratio };

struct SlowVariableInfo {
    const char* column;   // name in the track CSV, e.g. "two_theta_A_rad"
    const char* symbol;   // for people, e.g. "2θ_A"; the underscore introduces an index
    const char* unit;     // unit of the stored values: "" (recording units), "rad", "Hz"
    const char* meaning;  // English, translatable in context "SlowVariable"
    Quantity quantity;
    bool has_sd;  // with a standard deviation
};

const SlowVariableInfo& info(SlowVariable variable);

// The slow variables over time, a row per window. analyse() or the simulator fills it once; later
// it is only read.
//
// Units: seconds from the start of the recording (window centres), recording units, rad, Hz.
// two_theta_A is unwrapped modulo pi with alpha carried along, the first valid value in (-pi/2,
// pi/2]; delta_phi_CD and alpha lie in (-pi, pi]. A value that does not exist is NaN; the flags of
// its row are the reason.
class Track {
public:
    Track() = default;
    explicit Track(std::size_t rows);

    std::size_t rows() const { return time_s_.size(); }
    std::span<const double> time_s() const { return time_s_; }
    std::span<const double> values(SlowVariable variable) const { return values_[index(variable)]; }
    // Standard deviations; empty where the variable has none.
    std::span<const double> sds(SlowVariable variable) const { return sds_[index(variable)]; }
    std::span<const Flags> flags() const { return flags_; }
    // Frequency of a closed form (algorithms 1 to 4) less that of the best wave of its window, Hz;
    // 0 for the others. Its square is in the frequency's variance.
    std::span<const double> leakage_f_hz() const { return leakage_f_hz_; }

    // For filling the track.
    std::span<double> time_s() { return time_s_; }
    std::span<double> values(SlowVariable variable) { return values_[index(variable)]; }
    std::span<double> sds(SlowVariable variable) { return sds_[index(variable)]; }
    std::span<Flags> flags() { return flags_; }
    std::span<double> leakage_f_hz() { return leakage_f_hz_; }
    // A value with its standard deviation, which is ignored where the variable has none.
    void put(std::size_t row, SlowVariable variable, double value, double sd);
    void append(const Track& rows);

private:
    static std::size_t index(SlowVariable variable) { return static_cast<std::size_t>(variable); }

    std::vector<double> time_s_;
    std::array<std::vector<double>, slow_variable_count> values_;
    std::array<std::vector<double>, slow_variable_count> sds_;
    std::vector<Flags> flags_;
    std::vector<double> leakage_f_hz_;
};

// Whether a window has all its samples, unclipped and clear of filter and delay, and its estimate
// converged within its bounds.
inline constexpr bool is_sound_window(Flags flags) {
    constexpr Flags bad = static_cast<Flags>(Flag::gap | Flag::clipped) |
                          static_cast<Flags>(Flag::not_converged | Flag::at_bound) |
                          static_cast<Flags>(Flag::filter_transient | Flag::delay_reach);
    return (flags & bad) == 0;
}

// Receives the rows of a track during its computation, some thousand at a time, in order, from any
// thread but never from two at once. An error ends the computation.
using TrackSink = std::function<Status(const Track& rows)>;

// One that appends them to a track, which must outlive it.
TrackSink appended_to(Track& track);

// Consecutive rows of a track that get a flag after their estimation, because the reason is known
// only at the end of the recording.
struct FlaggedRows {
    std::size_t first = 0;
    std::size_t count = 0;
    Flag flag{};

    friend bool operator==(const FlaggedRows&, const FlaggedRows&) = default;
};

// Sets the flags of a part of the track that begins with its row `first`. Rows of other parts are
// ignored.
void set_flags(std::span<Flags> part, std::size_t first, std::span<const FlaggedRows> flagged);

// Makes the angle of a track continuous. From 2theta_A, estimated modulo pi, it subtracts
// `two_theta_zero` (angle of the first electrode, doubled), then selects the branch nearest to the
// last valid value; alpha follows, so that each row remains the same motion. The first valid
// 2theta_A lies in (-pi/2, pi/2], alpha in (-pi, pi].
//
// The track may arrive in consecutive pieces.
class AngleUnwrapper {
public:
    explicit AngleUnwrapper(double two_theta_zero) : two_theta_zero_(two_theta_zero) {}

    void unwrap(Track& next_rows);

private:
    double two_theta_zero_;
    double last_ = 0;  // the last valid 2theta_A
    bool any_ = false;
};

}  // namespace vybeg
