#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace vybeg {

// Why a window's value is missing or doubtful. A window may have several reasons.
enum class Flag : std::uint16_t {
    no_quadrature = 1,  // the algorithm does not estimate a_B
    circular = 2,       // a_A = |a_B| within the noise: the angle is undefined
    // Samples are missing inside the window or around it where they are needed (no values), or were
    // lost inside it (values mix the times before and after the loss).
    gap = 4,
    not_converged = 8,
    at_bound = 16,          // the frequency reached the edge of the main lobe
    clipped = 32,           // samples inside the window lie at the rail of the converter
    filter_transient = 64,  // the band-pass at the window reaches beyond an end of the recording
    delay_reach = 128,      // the quarter-period delay reaches beyond the samples (algorithm 2)
    // The closed form lies more than one standard deviation from the best wave of its window.
    leakage = 256,
    // A slow variable bends inside the window by half its standard deviation, the residual is far
    // above the recording's noise, or the branch of the angle between windows is unknown.
    moving = 512,
};

using Flags = std::uint16_t;  // any number of Flag, or-ed

inline constexpr Flags operator|(Flag a, Flag b) {
    return static_cast<Flags>(static_cast<Flags>(a) | static_cast<Flags>(b));
}
inline constexpr bool has(Flags flags, Flag flag) {
    return (flags & static_cast<Flags>(flag)) != 0;
}
inline constexpr void set(Flags& flags, Flag flag) {
    flags = static_cast<Flags>(flags | static_cast<Flags>(flag));
}

// Text of the flags in the track CSV, joined by ';', e.g. "gap;not-converged"; empty without flags.
std::string flags_text(Flags flags);
// Upper limit of the length of such a text.
inline constexpr std::size_t longest_flags_text = 128;

}  // namespace vybeg
