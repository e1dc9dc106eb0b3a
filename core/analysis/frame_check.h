#pragma once

#include "core/base/diagnostic.h"

#include <complex>
#include <optional>
#include <vector>

namespace vybeg {

// What the phasors of both channels tell of their reference, before it is believed. The warnings
// are without the recording as first argument.

// Both channels hold the same two modes: only with a sign of Y of their own, or with the reference
// just between modes each of which is in one channel, do they turn against each other.
// `c`, `d`: rows, `step_s` apart.
std::optional<Diagnostic> mirrored_channel(const std::vector<std::complex<double>>& c,
                                           const std::vector<std::complex<double>>& d,
                                           double step_s);

// A channel of two modes beats, in its phase as in its amplitude; with a reference that follows it,
// as the oscillator of a phase-locked loop does, in its amplitude alone, and the other channel has
// the difference of both phases. `c`, `d`: means over so many rows that their noise is new.
std::optional<Diagnostic> followed_channel(const std::vector<std::complex<double>>& c,
                                           const std::vector<std::complex<double>>& d);

}  // namespace vybeg
