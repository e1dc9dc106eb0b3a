#include "core/drift/log_drift.h"

#include "core/numerics/harmonic_terms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

constexpr double half_turn = std::numbers::pi;  // period of the second harmonic
// Rows of a fit: more are merged, as the fit is linear in them.
constexpr std::size_t most_rows = 1500;
// Pieces of a log along which slow departures from the fitted motion are smoothed.
constexpr std::size_t smooth_pieces = 200;
constexpr int bin_count = 36;
constexpr std::size_t least_rows = 32;

using Terms = Eigen::Matrix<double, log_terms, 1>;

Terms terms_at(double theta) {
    return harmonic_terms<Terms>(log_harmonics, theta);
}

// A stretch with the angles along which its terms are integrated.
struct Path {
    const AngleStretch* stretch;
    std::vector<double> theta;
};

// The angle after a time of a wave that drifts so, by a step of fourth order.
double drifted(double theta, double seconds, const Terms& drift) {
    const auto rate = [&](double at) { return drift.dot(terms_at(at)); };
    const double first = rate(theta);
    const double second = rate(theta + 0.5 * seconds * first);
    const double third = rate(theta + 0.5 * seconds * second);
    const double fourth = rate(theta + seconds * third);
    return theta + seconds / 6 * (first + 2 * second + 2 * third + fourth);
}

// The integrals at the rows of a path. Between rows the wave drifts, and its remaining distance to
// the next row is spread evenly: a straight line between rows 3 degrees apart made the turn 1e-6 of
// itself wrong by a drift of 2 % of it.
std::vector<Terms> integrals_along(const Path& path, const Terms& drift) {
    constexpr double straight = 1e-3;  // rad: a line is as good
    constexpr double longest = 0.05;   // part of a line, by Simpson's rule
    const std::vector<double>& time_s = path.stretch->time_s;
    std::vector<Terms> sums{Terms::Zero()};
    sums.reserve(time_s.size());
    std::vector<double> angles;
    for (std::size_t k = 1; k < time_s.size(); ++k) {
        const double turn = path.theta[k] - path.theta[k - 1];
        const auto parts =
            static_cast<std::size_t>(std::clamp(std::ceil(std::abs(turn) / longest), 1.0, 1e4));
        const double half = (time_s[k] - time_s[k - 1]) / (2 * static_cast<double>(parts));
        angles.assign(1, path.theta[k - 1]);
        for (std::size_t part = 0; part < 2 * parts; ++part) {
            angles.push_back(std::abs(turn) < straight ? angles.back()
                                                       : drifted(angles.back(), half, drift));
        }
        const double lacking = (path.theta[k] - angles.back()) / (2 * static_cast<double>(parts));
        for (std::size_t part = 1; part < angles.size(); ++part) {
            angles[part] += static_cast<double>(part) * lacking;
        }
        Terms sum = Terms::Zero();
        for (std::size_t part = 0; part < parts; ++part) {
            sum += terms_at(angles[2 * part]) + 4 * terms_at(angles[2 * part + 1]) +
                   terms_at(angles[2 * part + 2]);
        }
        sums.push_back(sums.back() + half / 3 * sum);
    }
    return sums;
}

// Rows of a stretch, so many merged into one; `value` is the row with the measured number after
// its regressors.
template <class Value>
FitSegment segment_of(const std::vector<double>& time_s, std::size_t merged, Eigen::Index columns,
                      Value value) {
    const std::size_t rows = (time_s.size() + merged - 1) / merged;
    FitSegment segment;
    segment.count.resize(static_cast<Eigen::Index>(rows));
    segment.rows.resize(static_cast<Eigen::Index>(rows), columns);
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t first = row * time_s.size() / rows;
        const std::size_t end = (row + 1) * time_s.size() / rows;
        const auto count = static_cast<double>(end - first);
        double time = 0;
        Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(columns);
        for (std::size_t k = first; k < end; ++k) {
            time += time_s[k];
            mean += value(k);
        }
        const auto at = static_cast<Eigen::Index>(row);
        segment.time_s.push_back(time / count);
        segment.count[at] = count;
        segment.rows.row(at) = mean / count;
    }
    return segment;
}

// The share of each term in the time of the log: whether its angles separate the terms.
Eigen::MatrixXd terms_seen(const std::vector<Path>& paths) {
    Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(log_terms, log_terms);
    for (const Path& path : paths) {
        for (std::size_t k = 1; k < path.theta.size(); ++k) {
            const double seconds = path.stretch->time_s[k] - path.stretch->time_s[k - 1];
            const Terms terms = terms_at(0.5 * (path.theta[k] + path.theta[k - 1]));
            seen += seconds * terms * terms.transpose();
        }
    }
    return seen;
}

class LogFit {
public:
    LogFit(const UnwrappedAngle& angle, const JobControl& job) : job_(job) {
        std::size_t rows = 0;
        for (const AngleStretch& stretch : angle.stretches) {
            // A start of its own, and some more.
            constexpr std::size_t least = 4;
            if (stretch.rows.size() >= least) {
                paths_.push_back({&stretch, stretch.theta});
                rows += stretch.rows.size();
            }
        }
        rows_ = rows;
        merged_ = rows / most_rows + 1;
    }

    std::size_t rows() const { return rows_; }
    bool separates() const { return separates_terms(terms_seen(paths_)); }

    // The terms follow the fitted motion and its slow departures, not the noise of the angle: the
    // first fit goes along the angle as it is, each of the others along the motion of the one
    // before.
    ColouredFit fit() {
        ColouredFit found = fit_along();
        constexpr int most = 8;
        constexpr double still = 0.05;  // of the deviation
        for (int pass = 1; pass < most && found.coefficients.size() > 0 && !job_.cancelled();
             ++pass) {
            smooth(found.coefficients);
            ColouredFit next = fit_along();
            const bool settled =
                next.coefficients.size() > 0 && ((next.coefficients - drift_).array().abs() <
                                                 still * next.covariance.diagonal().array().sqrt())
                                                    .all();
            found = std::move(next);
            if (settled) {
                break;
            }
        }
        return found;
    }

    std::optional<ColouredFit> effort(const std::vector<double>& values) const {
        std::vector<FitSegment> segments;
        std::size_t rows = 0;
        for (const Path& path : paths_) {
            std::vector<double> time_s;
            std::vector<std::size_t> places;
            for (std::size_t k = 0; k < path.theta.size(); ++k) {
                const std::size_t row = path.stretch->rows[k];
                if (row < values.size() && std::isfinite(values[row])) {
                    time_s.push_back(path.stretch->time_s[k]);
                    places.push_back(k);
                }
            }
            if (places.empty()) {
                continue;
            }
            rows += places.size();
            segments.push_back(segment_of(time_s, merged_, log_terms + 1, [&](std::size_t k) {
                Eigen::RowVectorXd row(log_terms + 1);
                row << terms_at(path.theta[places[k]]).transpose(),
                    values[path.stretch->rows[places[k]]];
                return row;
            }));
        }
        if (rows < least_rows) {
            return std::nullopt;
        }
        ColouredFit fit = coloured_fit(segments, SeriesKind::value, job_);
        return fit.coefficients.size() > 0 ? std::optional(std::move(fit)) : std::nullopt;
    }

    // Passes through each range of angles: turn less that of the mean rate, over the time.
    std::vector<LogBin> bins(const ColouredFit& fit) const {
        std::vector<LogBin> bins(bin_count);
        std::vector<double> weight(bin_count, 0);
        std::vector<double> moment(bin_count, 0);
        for (const Path& path : paths_) {
            const std::vector<double>& time_s = path.stretch->time_s;
            const auto bin_of = [&](std::size_t k) {
                const double middle = 0.5 * (path.theta[k] + path.theta[k + 1]);
                const double place = std::floor(middle / half_turn * bin_count);
                return static_cast<std::size_t>(place - bin_count * std::floor(place / bin_count));
            };
            for (std::size_t k = 0; k + 1 < time_s.size();) {
                const std::size_t first = k;
                const std::size_t bin = bin_of(k);
                while (k + 1 < time_s.size() && bin_of(k) == bin) {
                    ++k;
                }
                const double seconds = time_s[k] - time_s[first];
                const double turn = path.stretch->theta[k] - path.stretch->theta[first];
                const double w = seconds * seconds / fit.noise.variance_of_change(seconds);
                weight[bin] += w;
                moment[bin] += w * (turn / seconds - fit.coefficients[0]);
                bins[bin].seconds += seconds;
            }
        }
        for (std::size_t k = 0; k < bins.size(); ++k) {
            bins[k].theta = (static_cast<double>(k) + 0.5) * half_turn / bin_count;
            bins[k].rate =
                weight[k] > 0 ? moment[k] / weight[k] : std::numeric_limits<double>::quiet_NaN();
            bins[k].sd =
                weight[k] > 0 ? 1 / std::sqrt(weight[k]) : std::numeric_limits<double>::quiet_NaN();
        }
        return bins;
    }

private:
    ColouredFit fit_along() const {
        std::vector<FitSegment> segments;
        for (const Path& path : paths_) {
            const std::vector<Terms> sums = integrals_along(path, drift_);
            const std::vector<double>& theta = path.stretch->theta;
            segments.push_back(
                segment_of(path.stretch->time_s, merged_, log_terms + 1, [&](std::size_t k) {
                    Eigen::RowVectorXd row(log_terms + 1);
                    row << sums[k].transpose(), theta[k] - theta[0];
                    return row;
                }));
        }
        return coloured_fit(segments, SeriesKind::angle, job_);
    }

    void smooth(const Terms& coefficients) {
        const std::size_t piece = rows_ / smooth_pieces + 1;
        for (Path& path : paths_) {
            const std::vector<Terms> sums = integrals_along(path, drift_);
            const std::vector<double>& theta = path.stretch->theta;
            std::vector<double> residual;
            for (std::size_t k = 0; k < sums.size(); ++k) {
                residual.push_back(theta[k] - coefficients.dot(sums[k]));
            }
            const FitSegment means = segment_of(path.stretch->time_s, piece, 1, [&](std::size_t k) {
                return Eigen::RowVectorXd::Constant(1, residual[k]);
            });
            std::size_t at = 0;
            for (std::size_t k = 0; k < sums.size(); ++k) {
                const double time = path.stretch->time_s[k];
                while (at + 2 < means.time_s.size() && time > means.time_s[at + 1]) {
                    ++at;
                }
                const auto row = static_cast<Eigen::Index>(at);
                double slow = means.rows(row, 0);
                if (at + 1 < means.time_s.size()) {
                    const double share = std::clamp(
                        (time - means.time_s[at]) / (means.time_s[at + 1] - means.time_s[at]), 0.0,
                        1.0);
                    slow += share * (means.rows(row + 1, 0) - slow);
                }
                path.theta[k] = coefficients.dot(sums[k]) + slow;
            }
        }
        drift_ = coefficients;
    }

    const JobControl& job_;
    std::vector<Path> paths_;
    Terms drift_ = Terms::Zero();  // between the rows of the paths
    std::size_t rows_ = 0;
    std::size_t merged_ = 1;
};

}  // namespace

Result<LogDrift> log_drift(const WholeAngleLog& log, const JobControl& job) {
    const UnwrappedAngle angle = unwrapped_angle(log);
    LogFit fit(angle, job);
    if (fit.rows() < least_rows) {
        return Error{ErrorCode::too_few_frames,
                     log.name,
                     {count_arg(static_cast<std::int64_t>(fit.rows())),
                      count_arg(static_cast<std::int64_t>(least_rows))}};
    }
    if (angle.too_fast) {
        return Error{ErrorCode::turn_too_fast, log.name, {}};
    }
    constexpr double degree = half_turn / 180;
    if (angle.odd_period > 0) {
        return Error{
            ErrorCode::angle_unit_wrong, log.name, {number_arg(angle.odd_period / degree, 3)}};
    }
    if (!fit.separates()) {
        return Error{ErrorCode::turn_too_short, log.name, {number_arg(angle.turn / degree, 3)}};
    }
    const ColouredFit found = fit.fit();
    if (found.coefficients.size() == 0) {
        return Error{ErrorCode::no_valid_samples, log.name, {}};
    }
    LogDrift drift{found,
                   log.name,
                   log.sha256,
                   log.time_s.back() - log.time_s.front(),
                   angle.turn,
                   angle.period,
                   angle.warnings,
                   fit.rows(),
                   log.time_s.size() - fit.rows(),
                   fit.effort(log.amplitude_effort),
                   fit.effort(log.quadrature_effort),
                   fit.bins(found)};
    TRY(job.go_on());
    return drift;
}

}  // namespace vybeg
