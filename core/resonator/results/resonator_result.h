#pragma once

#include "core/base/diagnostic.h"
#include "core/resonator/fit/fitted_break.h"
#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/model/fitted_motion.h"
#include "core/resonator/model/reason.h"
#include "core/resonator/noise/residual_noise.h"
#include "core/resonator/runs/decay.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// structured: the pick-offs are a calibrated cos/sin pair, M has the form of METHOD section 8;
// free: M is any complex 2x2 matrix, and only its modes are given.
enum class ResonatorModel { structured, free };

// Modes by falling frequency, or by falling decay rate where the frequencies do not differ.
enum class ModeOrder { frequency, decay };

// A normal mode: an eigenvalue i 2 pi f - 1/tau of M.
struct ModeEstimate {
    Estimate f_hz;
    Estimate tau_s;
    Estimate q;
    // Of these three, as ResonatorFit::sensitivities; empty for the free model.
    std::vector<BySource> sensitivities;
};

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
    Estimate non_orthogonality_rad;     // of the pick-offs
    Estimate delay_s;                   // of D relative to C
    Estimate frequency_per_power;       // Hz per squared recording unit of |z|^2 = a_A^2 + a_B^2
};

// Frequencies of a drifting run refer to its reference instant, the mean time weighted with the
// power.
struct RunEstimate {
    Estimate f_offset_hz;  // of this run from f_mean_hz; the runs' offsets have mean zero
    Estimate a_A;          // at the start of the recording, like the next two, recording units
    Estimate a_B;
    Estimate two_theta_A_rad;
    Estimate split_sin_hz;     // split * sin 4(theta_A - theta_w) at the start
    Estimate direction_f_hz;   // of a wave that stays in the start direction of this one
    Estimate direction_tau_s;  // likewise: known for a still wave if f_mean and tau are not
    Estimate q_envelope;       // pi f tau, tau of the power |z|^2 alone
    Estimate drift_hz_per_s;
    // Of this run's windows, which share the degrees of freedom; NaN where there is no fit.
    double chi2_per_dof = std::numeric_limits<double>::quiet_NaN();
    // The decay over the amplitude where it is not constant; q_envelope then holds at one
    // amplitude.
    std::optional<DecayLaw> law;
};

// Fitted parameters for a passport, with names and full covariance.
struct RawParameters {
    std::vector<std::string> names;
    std::vector<double> values;
    std::vector<double> covariance;  // row by row, names.size() squared
};

// Rotation and damping anisotropy, the terms of the drift of the angle, with their covariance: r,
// g cos 4theta_tau, g sin 4theta_tau.
struct DriftTerms {
    // A channel error of the size of its tolerance, stated or assumed.
    struct Tolerated {
        Eigen::Vector3d moved;  // of the terms that the fit finds
        FittedMotion motion;    // that has the error, where the fit finds ResonatorFit::motion;
                                // of the same runs
    };

    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // statistical
    Eigen::Matrix3d spread =
        Eigen::Matrix3d::Zero();  // by the spread between the runs and drifts of C
    std::vector<Tolerated> tolerated;
    bool given = false;
};

// What a passport keeps of a fit.
struct ResonatorNumbers {
    ResonatorModel model{};
    ResonatorEstimate resonator;      // each with reason free_model for the free model
    std::vector<ModeEstimate> modes;  // two in the order of the modes, or none
    ModeOrder mode_order{};
    std::vector<RunEstimate> runs;  // in the order of the given runs
    RawParameters raw;
};

struct ResonatorFit : ResonatorNumbers {
    Reason no_modes;  // reason for the absence of modes
    // By how much each of the resonator's parameters, in the order of resonator_parameters.h, is
    // wrong per unit of an error of which the fit does not know, in the units of usual_errors; NaN
    // if the parameter is not given. Springs and the eighth harmonic: in their worst direction.
    std::vector<BySource> sensitivities;
    // Contribution of each tolerance to u, in the same order and in the parameter's unit: u^2 is
    // the sum of their squares and of sd^2. Zeros if the parameter is not given.
    std::vector<BySource> shares;
    DriftTerms drift_terms;
    double residual_rms = 0;          // of the windows' phasors per signal, recording units
    double chi2_per_dof = 0;          // squared residuals in units of the windows' sd
    double free_over_structured = 0;  // fall of chi^2 (over chi^2/dof of the free fit, if above 1)
                                      // from structured to free M; about 1 by chance
    ResidualNoise noise;
    FittedMotion motion;
    std::vector<FittedBreak> breaks;      // found by the fit, with parameters of their own
    std::optional<std::size_t> left_out;  // the run that does not belong to the set
    std::vector<Diagnostic> warnings;
};

}  // namespace vybeg
