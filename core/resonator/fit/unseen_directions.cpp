#include "core/resonator/fit/unseen_directions.h"

#include "core/numerics/dense_solvers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

// Share of the prior's sd above which a direction is refused without a profile.
constexpr double seen_share = 0.1;
// A direction whose five deviations turn the wave by less than this, rad, is linear.
constexpr double linear_turn = 0.05;
constexpr double first_step = 2.5;  // standard deviations
// Depth beyond any local minimum due to noise.
constexpr double deep = 100;
// A single rise may be a refit without convergence.
constexpr int deep_twice = 2;
constexpr int refit_steps = 25;
// Share of the rise by the information, from which on it holds.
constexpr double seen_rise = 0.25;

struct Block {
    std::vector<Eigen::Index> parameters;
    double turn_per_unit;  // rad/s for a unit of the parameter
};

class Profile {
public:
    Profile(const FitProblem& problem, const MapFit& fit, const Posterior& posterior, double scale,
            const JobControl& job)
        : problem_(problem), fit_(fit), posterior_(posterior), scale_(scale), job_(job) {
        for (const ScaledRun& run : problem.runs) {
            longest_s_ = std::max(longest_s_, run.duration_s);
        }
    }

    std::vector<ProfilePoint> points() {
        const std::array<Block, 3> blocks{{{{split_cos_at, split_sin_at}, 2 * std::numbers::pi},
                                           {{damping_cos_at, damping_sin_at}, 1},
                                           {{rotation_at}, 1}}};
        for (const Block& block : blocks) {
            follow(block);
        }
        return std::move(points_);
    }

private:
    void follow(const Block& block) {
        if (job_.cancelled()) {
            return;
        }
        std::vector<Eigen::Index> places;
        for (const Eigen::Index parameter : block.parameters) {
            const auto found = std::ranges::find(posterior_.active, parameter);
            if (found == posterior_.active.end()) {
                return;
            }
            places.push_back(found - posterior_.active.begin());
        }
        const Eigen::MatrixXd part = posterior_.covariance(places, places);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> principal(part);
        const double prior_sd = problem_.priors.sd[block.parameters[0]];
        for (Eigen::Index k = principal.eigenvalues().size() - 1; k >= 0; --k) {
            const double sd = std::sqrt(std::max(principal.eigenvalues()[k], 0.0));
            if (!(sd <= seen_share * prior_sd &&
                  5 * sd * longest_s_ * block.turn_per_unit >= linear_turn)) {
                continue;
            }
            Eigen::VectorXd direction = Eigen::VectorXd::Zero(fit_.p.size());
            direction(block.parameters) = principal.eigenvectors().col(k);
            for (const double side : {-first_step, first_step}) {
                walk(direction, sd, side, prior_sd);
            }
        }
    }

    void walk(const Eigen::VectorXd& direction, double sd, double side, double prior_sd) {
        // Response of all parameters to a step of one deviation.
        Eigen::VectorXd response = Eigen::VectorXd::Zero(fit_.p.size());
        response(posterior_.active) = posterior_.covariance * direction(posterior_.active) / sd;
        FitProblem problem = problem_;
        Eigen::VectorXd p = fit_.p;
        int in_a_row = 0;
        for (; std::abs(side) * sd <= prior_sd && !job_.cancelled(); side *= 2) {
            p += response * (side - direction.dot(p - fit_.p) / sd);
            problem.held = {{direction, direction.dot(fit_.p) + side * sd, sd / 100}};
            const MapFit refit = minimise(problem, p, refit_steps, job_);
            p = refit.p;
            const double rise = (refit.cost - fit_.cost) / scale_;
            in_a_row = rise <= deep ? 0 : in_a_row + 1;
            if (in_a_row == deep_twice) {
                return;
            }
            if (in_a_row == 0) {
                // Where the cost rises as the information says, the direction is seen, and a
                // quantity that moves by b side^2 has a variance of 2 b^2.
                const double squares = side * side;
                const bool seen = rise > seen_rise * squares;
                points_.push_back({p, std::max(rise * (seen ? squares / 2 : 1), 1.0)});
            }
        }
    }

    const FitProblem& problem_;
    const MapFit& fit_;
    const Posterior& posterior_;
    double scale_;
    const JobControl& job_;
    double longest_s_ = 0;
    std::vector<ProfilePoint> points_;
};

}  // namespace

std::vector<ProfilePoint> unseen_directions(const FitProblem& problem, const MapFit& fit,
                                            const Posterior& posterior, double scale,
                                            const JobControl& job) {
    return Profile(problem, fit, posterior, scale, job).points();
}

}  // namespace vybeg
