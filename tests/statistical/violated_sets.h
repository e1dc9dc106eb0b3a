#pragma once

#include "core/resonator/results/resonator_fit.h"
#include "core/resonator/results/resonator_parameters.h"
#include "tests/core/resonator/simulated_phasors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace vybeg::test {

// Kinds of sets: of one resonator (faultless), with one run of another resonator (foreign), partly
// of another (part), with exchanged channels, with the sign of D reversed, with the amplitude held
// by a drive, with a gain ratio, decay or split of its own; all runs a little or much unlike.
enum class SetKind {
    faultless,
    foreign,
    part,
    exchanged,
    sign,
    drive,
    kappa,
    tau,
    split,
    all_differ,
    widely
};

// A random set of runs of 10 s with at most one violation, and its truth.
struct ViolatedSet {
    FreeDecay resonator;  // that of the runs that belong to the set
    std::size_t bad = 0;  // the run with the violation
    std::vector<PhasorRun> runs;
};

struct SetRandom {
    std::mt19937_64 engine;

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }
    double one_of(std::initializer_list<double> list) {
        return list.begin()[engine() % list.size()];
    }
    // Standard normal, by Box and Muller.
    double normal() {
        return std::sqrt(-2 * std::log(uniform(1e-300, 1))) *
               std::cos(2 * std::numbers::pi * uniform(0, 1));
    }
};

inline FreeDecay random_gyro(SetRandom& random) {
    using std::numbers::pi;
    FreeDecay gyro;
    gyro.seconds = 10;
    gyro.tau_s = std::pow(10, random.uniform(1.3, 3));
    gyro.split_hz = std::pow(10, random.uniform(-4, -0.52));
    gyro.theta_w = random.uniform(-pi, pi) / 4;
    gyro.damping_anisotropy_per_s = random.uniform(0, 0.1) / gyro.tau_s;
    gyro.theta_tau = random.uniform(-pi, pi) / 4;
    gyro.omega_rad_s = random.one_of({0, 4e-5, random.uniform(-0.05, 0.05)}) / (2 * gyro.bryan);
    gyro.kappa = random.uniform(0.99, 1.01);
    return gyro;
}

// The phasors with the amplitude held at its start, as by a drive.
inline PhasorRun driven_phasors(FreeDecay decay, std::int64_t window, std::uint64_t seed,
                                double offset_hz) {
    FreeDecay quiet = decay;
    quiet.noise = 1e-300;
    PhasorRun run = simulated_phasors(quiet, window, seed, offset_hz);
    GaussianNoise noise(seed);
    const double sd = decay.noise * std::sqrt(2 / static_cast<double>(window));
    for (std::size_t k = 0; k < run.c.size(); ++k) {
        const double size = std::hypot(std::abs(run.c[k]), std::abs(run.d[k]));
        const auto [c_re, c_im] = noise.next();
        const auto [d_re, d_im] = noise.next();
        run.c[k] = run.c[k] / size + sd * std::complex(c_re, c_im);
        run.d[k] = run.d[k] / size + sd * std::complex(d_re, d_im);
        run.sd[k] = sd;
    }
    return run;
}

// `size`: relative size of a violation of part, kappa, tau, split; of exchanged and sign the split,
// Hz, of a good gyro at rest whose runs start 22.5 degrees apart, where the run's own frequency
// makes up for other channels; 0: of any gyro and starts. `runs`: 0 draws 2, 3, 4 or 6.
// `two_theta_zero`: of the electrode from which all angles count.
inline ViolatedSet violated_set(SetKind kind, std::uint64_t seed, double size, std::size_t runs = 0,
                                double two_theta_zero = 0) {
    using std::numbers::pi;
    SetRandom random{std::mt19937_64(seed * 16 + static_cast<std::uint64_t>(kind))};
    ViolatedSet set;
    const auto drawn = static_cast<std::size_t>(random.one_of({2, 3, 4, 6}));
    const std::size_t count = runs > 0 ? runs : drawn;
    set.resonator = random_gyro(random);
    set.resonator.noise = std::pow(10, -random.uniform(50, 70) / 20);
    FreeDecay other = random_gyro(random);
    other.kappa = set.resonator.kappa;
    other.noise = set.resonator.noise;
    set.bad = random.engine() % count;
    const double step = random.one_of({0, pi / 4});
    const double first = random.uniform(-3, 3);
    const double quadrature = random.one_of({0, 0.01, 0.1});
    const bool regular = size > 0 && (kind == SetKind::exchanged || kind == SetKind::sign);
    if (regular) {
        set.resonator.split_hz = size;
        set.resonator.omega_rad_s = 0;
        set.resonator.damping_anisotropy_per_s /= 30;
        set.resonator.kappa = 1;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const bool bad = k == set.bad;
        FreeDecay run = bad && kind == SetKind::foreign ? other : set.resonator;
        double offset_hz = random.uniform(-0.3, 0.3);
        double tau = 1;
        double split = 1;
        double kappa = 1;
        if (kind == SetKind::all_differ || kind == SetKind::widely) {
            const bool widely = kind == SetKind::widely;
            tau += random.normal() * (widely ? 0.05 : 0.01);
            split += random.normal() * (widely ? 0.1 : 0.03);
            kappa += random.normal() * (widely ? 0.01 : 0.001);
        } else if (bad) {
            tau += kind == SetKind::tau ? size : 0;
            split += kind == SetKind::split ? size : 0;
            kappa += kind == SetKind::kappa ? size : 0;
        }
        if (bad && kind == SetKind::foreign) {
            offset_hz += random.one_of({0, 3, 300});
        }
        if (bad && kind == SetKind::part) {
            const auto mix = [&](double a, double b) { return a + size * (b - a); };
            run.tau_s = 1 / mix(1 / run.tau_s, 1 / other.tau_s);
            const std::complex<double> w = std::polar(run.split_hz, 4 * run.theta_w) * (1 - size) +
                                           std::polar(other.split_hz, 4 * other.theta_w) * size;
            run.split_hz = std::abs(w);
            run.theta_w = std::arg(w) / 4;
            run.omega_rad_s = mix(run.omega_rad_s, other.omega_rad_s);
        }
        run.tau_s /= tau;
        run.split_hz *= split;
        run.kappa *= kappa;
        run.a_B = quadrature * random.uniform(-1, 1);
        run.two_theta_A = step > 0 ? first + static_cast<double>(k) * step : random.uniform(-3, 3);
        if (regular) {
            run.a_B /= 10;
            run.two_theta_A = static_cast<double>((3 * k + seed) % 8) * pi / 4 + run.a_B;
        }
        run.alpha = random.uniform(-3, 3);
        constexpr std::int64_t window = 3333;
        const std::uint64_t own = seed * 64 + k;
        // The run's reference follows its frequency, as the search for the carrier does.
        run.f0_hz += offset_hz;
        PhasorRun phasors = bad && kind == SetKind::drive ? driven_phasors(run, window, own, 0)
                                                          : simulated_phasors(run, window, own);
        if (bad && kind == SetKind::exchanged) {
            std::swap(phasors.c, phasors.d);
        }
        for (std::complex<double>& d : phasors.d) {
            d *= bad && kind == SetKind::sign ? -1 : 1;
        }
        phasors.two_theta_zero = two_theta_zero;
        for (std::size_t at = 0; at < phasors.c.size(); ++at) {
            turn_channels(two_theta_zero, phasors.c[at], phasors.d[at]);
        }
        set.runs.push_back(std::move(phasors));
    }
    set.resonator.theta_w -= two_theta_zero / 2;
    set.resonator.theta_tau -= two_theta_zero / 2;
    return set;
}

inline bool has(const ResonatorFit& fit, DiagnosticKind kind) {
    return std::ranges::any_of(fit.warnings,
                               [&](const Diagnostic& found) { return found.kind == kind; });
}

// Largest distance from the truth of what the fit gives of split, axis, decay, anisotropy, rotation
// and gain ratio, in its combined uncertainty; 0 where nothing is given.
inline double worst_pull(const ResonatorFit& fit, const FreeDecay& truth) {
    const ResonatorEstimate& r = fit.resonator;
    double worst = 0;
    const auto add = [&](const Estimate& found, double expected, double period) {
        if (found.given()) {
            const double off = period > 0 ? std::remainder(found.value - expected, period)
                                          : found.value - expected;
            worst = std::max(worst, std::abs(off) / found.uncertainty());
        }
    };
    add(r.split_hz, truth.split_hz, 0);
    add(r.theta_w_rad, truth.theta_w, std::numbers::pi / 2);
    if (r.tau_s.given()) {
        const double relative = r.tau_s.uncertainty() / r.tau_s.value;
        worst = std::max(worst, std::abs(r.tau_s.value / truth.tau_s - 1) / relative);
    }
    add(r.damping_anisotropy_per_s, truth.damping_anisotropy_per_s, 0);
    add(r.theta_tau_rad, truth.theta_tau, std::numbers::pi / 2);
    add(r.angle_rate_rad_s, -truth.bryan * truth.omega_rad_s, 0);
    add(r.kappa, truth.kappa, 0);
    return worst;
}

}  // namespace vybeg::test
