#pragma once

#include "core/base/job_control.h"
#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/model/reason.h"

namespace vybeg {

// Motion of the wave of one recording without a model of the resonator: means over the recording.
// Each is the slope of a weighted straight line through a series of the windows' phasors z, with
// the weights 1/sd^2 of the series:
//     series                                                sd (of z's parts: sd)
//     phase, the sum of arg(z_k^H z_{k+1})                  sd / |z|
//     log amplitude, log(|z|^2 - 4 sd^2) / 2                sd / |z|
//     theta_A, from 2theta_A unwrapped modulo pi            sd |z| / (2 (a_A^2 - a_B^2))
//     a_B / a_A                                             sd |z| / a_A^2
// A slope is the mean of the series' rate over the recording, with a weight that is zero at both
// ends and largest in the middle. Outliers of a series and windows of a circular wave are excluded.
//
// Standard deviations: noise of the windows, plus the excess scatter about a smooth trend (a
// parabola) as noise of one correlation time (restricted maximum likelihood). Curvature beyond the
// trend widens the deviation.
struct WaveMotion {
    Estimate f_hz;                   // mean rate of phase of both channels by power, absolute, Hz
    Estimate tau_s;                  // decay time of sqrt(a_A^2 + a_B^2), s
    Estimate theta_rate_rad_s;       // d theta_A / dt, rad/s
    Estimate quadrature_rate_per_s;  // d(a_B / a_A) / dt, 1/s
    Estimate decay_per_s;            // 1 / tau, 1/s: given also without a significant decay
};

// `u` of each number: sd combined with the change by one deviation of each channel error, errors
// independent. Reasons: too_few_windows (fewer than eight windows count), circular_wave (angle and
// quadrature; the angle also where the wave passes so near the circular state that the sense of its
// turn is unknown), those of decay_time(). Precondition: the vectors of a run have one length.
WaveMotion wave_motion(const PhasorRun& run, const ChannelTolerance& tolerance = {},
                       const JobControl& job = {});

}  // namespace vybeg
