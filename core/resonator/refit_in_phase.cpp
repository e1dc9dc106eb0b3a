#include "core/resonator/refit_in_phase.h"

#include <cmath>
#include <complex>
#include <vector>

namespace vybeg {

MapFit refit_in_phase(const FitProblem& problem, const MapFit& fit, const JobControl& job) {
    constexpr double large = 4;    // mean square phase, in units of the windows' noise
    constexpr double clear = 0.2;  // of a wave: largest share that all is left of it
    constexpr int steps = 60;
    std::vector<ScaledRun> turned(problem.runs.begin(), problem.runs.end());
    const Eigen::VectorXd shared = fit.p.head(shared_count);
    double squares = 0;
    double count = 0;
    for (std::size_t k = 0; k < turned.size(); ++k) {
        ScaledRun& run = turned[k];
        const std::vector<Eigen::Vector2cd> expected =
            expected_phasors(run, shared, own_of(problem.layout, fit.p, k), run.size());
        double left = 0;
        for (std::size_t window = 0; window < run.size(); ++window) {
            left += (run.z[window] - expected[window]).squaredNorm();
        }
        const double least = std::sqrt(left / static_cast<double>(run.size())) / clear;
        for (std::size_t window = 0; window < run.size(); ++window) {
            if (expected[window].norm() < least) {
                continue;
            }
            const double phase = std::arg(expected[window].dot(run.z[window]));
            squares += std::pow(phase * run.z[window].norm() * run.weight[window], 2);
            run.z[window] *= std::polar(1.0, -phase);
        }
        count += static_cast<double>(run.size());
    }
    if (squares < large * count) {
        return fit;
    }
    FitProblem in_phase = problem;
    in_phase.runs = turned;
    MapFit again = minimise(in_phase, fit.p, steps, job);
    again.chi2 = 0;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        again.chi2 += chi_square(problem.runs[k], again.p.head(shared_count),
                                 own_of(problem.layout, again.p, k), problem.runs[k].size());
    }
    return again;
}

}  // namespace vybeg
