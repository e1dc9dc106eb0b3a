#pragma once

#include "core/base/diagnostic.h"
#include "core/resonator/model/phasor_run.h"

#include <complex>
#include <optional>
#include <vector>

namespace vybeg {

// Checks of the declared reference by the phasors of both channels, and of the motion that the
// reference leaves in them. The warnings are without the recording as first argument.

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

// An oscillator that moves by itself leaves its motion in the phasors, which its phase takes out; a
// phase of the wrong sign doubles it, in both channels. One that follows the wave shows nothing.
// `turn`: by which the rows have been multiplied; empty: by none.
std::optional<Diagnostic> backward_oscillator(const std::vector<std::complex<double>>& c,
                                              const std::vector<std::complex<double>>& d,
                                              const std::vector<std::complex<double>>& turn);

// Removes from the phasors of both channels, relative to f_ref_hz, what a filter of few stages
// leaves of the mixer's sum at twice the carrier: the image
//     h conj(z) exp(-2i 2 pi f_ref t)
// with one complex h of both channels, by least squares of the second differences, in which the
// motion is small. Rows that are too far apart for these, an image below the noise, and one that
// folds onto the motion itself stay as they are. `time_s`, `c`, `d`: of one length, in the order of
// time; all values finite.
void remove_image(double f_ref_hz, const std::vector<double>& time_s,
                  std::vector<std::complex<double>>& c, std::vector<std::complex<double>>& d);

// Standard deviation of the noise of a window's real or imaginary part, by what a linear recurrence
// z(t + T) = A z(t) leaves of the windows; nothing where they follow their neighbours no more than
// noise does. `neighbours`: correlation of the noise of a window with that of the next.
std::optional<double> noise_beside_wave(const PhasorRun& run, double neighbours);

}  // namespace vybeg
