#pragma once

#include <complex>
#include <vector>

namespace vybeg {

// What the fit of a resonator sees of one recording: its phasors z = (c, d) of METHOD section 1,
// averaged over windows of one length, relative to one fixed reference frequency:
//     C(t) = Re(c e^{2 pi i f_ref t}), t in seconds from the start of the recording.
// Windows that hold gaps or faults are left out; the others need not be evenly spaced, but stand in
// the order of time and do not overlap. The beat and the offset from f_ref must turn by less than
// half a turn from one window to the next. Some hundred to some thousand windows are enough.
struct PhasorRun {
    double f_ref_hz = 0;
    double window_s = 0;
    std::vector<double> time_s;           // centres of the windows
    std::vector<std::complex<double>> c;  // recording units
    std::vector<std::complex<double>> d;
    std::vector<double> sd;  // of the real and of the imaginary part of c and of d
    // Correlation of the noise of windows 0, 1, 2, ... windows apart; empty where it is white.
    std::vector<double> noise_correlation{};
    // Instants at which an unknown number of samples is missing: the phase of the windows after one
    // is not known against that of the windows before it.
    std::vector<double> phase_breaks_s{};
    double rate_hz = 0;  // of the recording's samples; 0: not known
};

}  // namespace vybeg
