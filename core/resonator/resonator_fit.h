#pragma once

#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/resonator/fitted_motion.h"
#include "core/resonator/phasor_run.h"
#include "core/resonator/reason.h"

#include <span>
#include <string>
#include <vector>

namespace vybeg {

// structured: the pick-offs are a calibrated cos/sin pair, M has the form of METHOD section 8;
// free: M is any complex 2x2 matrix, and only its modes are told.
enum class ResonatorModel { structured, free };

struct FitOptions {
    enum class Model { automatic, structured, free };
    Model model = Model::automatic;
    bool estimate_kappa = true;  // look for the gain ratio of the channels where the data can tell
    bool fit_drift = true;       // look for a drift of frequency, over time and with amplitude
};

// A normal mode: an eigenvalue i 2 pi f - 1/tau of M.
struct ModeEstimate {
    Estimate f_hz;
    Estimate tau_s;
    Estimate q;
};

// Where one direction alone was seen (decay_of_one_direction), f_mean, tau and Q are those of the
// wave as it stood.
struct ResonatorEstimate {
    Estimate f_mean_hz;    // of both modes, mean of the runs
    Estimate split_hz;     // f_p - f_q >= 0
    Estimate theta_w_rad;  // axis of the faster mode, (-pi/4, pi/4]
    Estimate tau_s;
    Estimate q;                         // pi f_mean tau
    Estimate damping_anisotropy_per_s;  // 1/tau_1 - 1/tau_2 >= 0
    Estimate theta_tau_rad;             // axis of larger damping, (-pi/4, pi/4]
    Estimate angle_rate_rad_s;          // d theta_A/dt = -k Omega = -r/2
    Estimate kappa;                     // D = kappa S_D
    Estimate non_orthogonality_rad;     // of the pick-offs; never told, for the reason that it has
    Estimate delay_s;                   // of D behind C; likewise
    Estimate frequency_per_power;       // Hz per squared recording unit of |z|^2 = a_A^2 + a_B^2
};

// Frequencies of a run that drifts are those of the instant at which its frequency is known best:
// the middle of a run that hardly decays, one decay time from the start of one that decays away.
struct RunEstimate {
    Estimate f_offset_hz;  // of this run from f_mean_hz; the runs' offsets have mean zero
    Estimate a_A;          // at the start of the recording, as the next two, recording units
    Estimate a_B;
    Estimate two_theta_A_rad;
    Estimate split_sin_hz;  // split * sin 4(theta_A - theta_w) at the start
    Estimate q_envelope;    // pi f tau, tau of the power |z|^2 alone
    Estimate drift_hz_per_s;
};

// The fitted numbers themselves, for a passport: named, with their whole covariance.
struct RawParameters {
    std::vector<std::string> names;
    std::vector<double> values;
    std::vector<double> covariance;  // row by row, names.size() squared
};

// What the recordings can tell at all.
struct Identifiable {
    bool split = false;
    bool theta_w = false;
    bool tau = false;
    bool damping_anisotropy = false;
    bool theta_tau = false;
    bool rotation = false;
    bool kappa = false;
};

struct ResonatorFit {
    ResonatorModel model{};
    std::vector<ModeEstimate> modes;  // two by falling frequency, or none
    Reason no_modes;                  // why, where there are none
    ResonatorEstimate resonator;      // each with reason free_model for the free model
    std::vector<RunEstimate> runs;    // as the runs given
    Identifiable identifiable;
    double residual_rms = 0;          // of the windows' phasors per signal, recording units
    double chi2_per_dof = 0;          // squared residuals in units of the windows' sd
    double free_over_structured = 0;  // likelihood ratio: fall of chi^2 (over chi2_per_dof, if
                                      // above 1) from structured to free M; about 1 by chance
    RawParameters raw;
    FittedMotion motion;
    std::vector<Diagnostic> warnings;
};

// Fits one resonator to all runs together (METHOD section 8): one M; each run its own start and
// frequency. The standard deviations are those of the windows, enlarged by sqrt(chi2_per_dof) where
// that is above 1 by more than four of its own deviations. Deterministic, one thread.
// Errors: fit_too_few_windows, fit_failed, interrupted.
Result<ResonatorFit> fit_resonator(std::span<const PhasorRun> runs, const FitOptions& options,
                                   const JobControl& job);

}  // namespace vybeg
