#include "core/drift/coloured_fit.h"

#include "core/numerics/dense_solvers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace vybeg {
namespace {

// Step of the filter's two states over a time: the walk (with the integral of a slow rate), and the
// slow noise.
struct Step {
    double walk_by_slow = 0;
    double slow_by_slow = 0;
    double q_walk = 0;
    double q_cross = 0;
    double q_slow = 0;
};

Step step_of(const SeriesNoise& noise, double h) {
    Step step;
    step.q_walk = noise.walk * h;
    if (noise.slow == SeriesNoise::Slow::none) {
        return step;
    }
    const double x = noise.slow_rate * h;
    const double lost = -std::expm1(-x);
    step.slow_by_slow = 1 - lost;
    step.q_slow = -noise.slow_variance * std::expm1(-2 * x);
    if (noise.slow == SeriesNoise::Slow::rate) {
        step.walk_by_slow = lost / noise.slow_rate;
        step.q_cross = noise.slow_variance / noise.slow_rate * lost * lost;
        // 2 (x - 2 (1 - e^-x) + (1 - e^-2x)/2), which loses its digits where x is small.
        constexpr double small = 1e-2;
        const double grown = x < small ? 2 * x * x * x * (1.0 / 3 - x / 4)
                                       : 2 * (x - 2 * lost - 0.5 * std::expm1(-2 * x));
        step.q_walk += noise.slow_variance / (noise.slow_rate * noise.slow_rate) * grown;
    }
    return step;
}

// Sum of the logarithms of positive numbers, with few logarithms.
class LogSum {
public:
    void add(double number) {
        constexpr double large = 1e100;
        product_ *= number;
        if (!(product_ < large && product_ > 1 / large)) {
            sum_ += std::log(product_);
            product_ = 1;
        }
    }
    double value() const { return sum_ + std::log(product_); }

private:
    double product_ = 1;
    double sum_ = 0;
};

// Sum of the squares of rows, row^T row, a block of them at once.
class RowSquares {
public:
    explicit RowSquares(Eigen::Index columns)
        : block_(block_rows, columns), sum_(Eigen::MatrixXd::Zero(columns, columns)) {}

    // Place of the next row, until the next call.
    Eigen::Ref<Eigen::RowVectorXd> next() {
        if (filled_ == block_rows) {
            flush();
        }
        return block_.row(filled_++);
    }

    Eigen::MatrixXd sum() {
        flush();
        return sum_.selfadjointView<Eigen::Lower>();
    }

private:
    static constexpr Eigen::Index block_rows = 64;

    void flush() {
        sum_.selfadjointView<Eigen::Lower>().rankUpdate(block_.topRows(filled_).transpose());
        filled_ = 0;
    }

    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> block_;
    Eigen::MatrixXd sum_;
    Eigen::Index filled_ = 0;
};

// The columns of all segments made white, as sums of their products.
struct Whitened {
    Eigen::MatrixXd normal;  // of the regressors and, last, the measured values
    double log_det = 0;      // of the covariances of rows and of eliminated starts
    double freedom = 0;
};

// Adds a segment under a noise; with a start of its own one more column is eliminated.
void add_white(const FitSegment& segment, bool own_start, const SeriesNoise& noise, Whitened& sum) {
    const Eigen::Index columns = segment.rows.cols() + (own_start ? 1 : 0);
    RowSquares white_rows(columns);
    LogSum log_det;
    Eigen::RowVectorXd walk = Eigen::RowVectorXd::Zero(columns);
    Eigen::RowVectorXd slow = Eigen::RowVectorXd::Zero(columns);
    Step step;
    double step_s = 0;
    double p_walk = 0;
    double p_cross = 0;
    double p_slow = noise.slow == SeriesNoise::Slow::none ? 0 : noise.slow_variance;
    // Determinant of the covariance of the states, by which its update subtracts nothing: where
    // the slow noise is far above the white one, a difference has no digit and no sign.
    double det = 0;
    const double sees_slow = noise.slow == SeriesNoise::Slow::value ? 1 : 0;
    for (std::size_t k = 0; k < segment.time_s.size(); ++k) {
        if (k > 0) {
            // Most rows are as far apart as those before, up to the rounding of their times.
            constexpr double rounding = 1e-9;
            const double h = segment.time_s[k] - segment.time_s[k - 1];
            if (std::abs(h - step_s) > rounding * step_s) {
                step = step_of(noise, h);
                step_s = h;
            }
            walk += step.walk_by_slow * slow;
            slow *= step.slow_by_slow;
            p_walk +=
                2 * step.walk_by_slow * p_cross + step.walk_by_slow * step.walk_by_slow * p_slow;
            p_cross = step.slow_by_slow * (p_cross + step.walk_by_slow * p_slow);
            p_slow *= step.slow_by_slow * step.slow_by_slow;
            det = step.slow_by_slow * step.slow_by_slow * det + p_walk * step.q_slow +
                  p_slow * step.q_walk - 2 * p_cross * step.q_cross + step.q_walk * step.q_slow -
                  step.q_cross * step.q_cross;
            p_walk += step.q_walk;
            p_cross += step.q_cross;
            p_slow += step.q_slow;
        }
        const auto at = static_cast<Eigen::Index>(k);
        auto row = white_rows.next();
        if (own_start) {
            row[0] = 1;
        }
        row.tail(segment.rows.cols()) = segment.rows.row(at);
        row -= walk + sees_slow * slow;
        const double seen_walk = p_walk + sees_slow * p_cross;
        const double seen_slow = p_cross + sees_slow * p_slow;
        const double white = noise.white / segment.count[at];
        const double variance = seen_walk + sees_slow * seen_slow + white;
        log_det.add(variance);
        const double weight = 1 / variance;
        walk += (seen_walk * weight) * row;
        slow += (seen_slow * weight) * row;
        row *= std::sqrt(weight);
        p_walk = (p_walk * white + sees_slow * det) * weight;
        p_cross = (p_cross * white - sees_slow * det) * weight;
        p_slow = (p_slow * white + det) * weight;
        det *= white * weight;
    }
    const Eigen::MatrixXd normal = white_rows.sum();
    sum.log_det += log_det.value();
    sum.freedom += static_cast<double>(segment.time_s.size());
    if (own_start) {
        const double start = normal(0, 0);
        const Eigen::Index others = columns - 1;
        const Eigen::VectorXd mixed = normal.col(0).tail(others);
        sum.normal += normal.bottomRightCorner(others, others) - mixed * mixed.transpose() / start;
        sum.log_det += std::log(start);
        sum.freedom -= 1;
    } else {
        sum.normal += normal;
    }
}

// The fit under a noise known up to its scale, and the logarithm of its restricted likelihood.
struct Trial {
    ColouredFit fit;
    double likelihood = -std::numeric_limits<double>::infinity();
};

Trial trial_of(const std::vector<FitSegment>& segments, SeriesKind kind, const SeriesNoise& noise) {
    const Eigen::Index columns = segments.front().rows.cols();
    Whitened sum;
    sum.normal = Eigen::MatrixXd::Zero(columns, columns);
    for (const FitSegment& segment : segments) {
        add_white(segment, kind == SeriesKind::angle, noise, sum);
    }
    const Eigen::Index terms = columns - 1;
    const Eigen::VectorXd scale =
        sum.normal.diagonal().head(terms).cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
    const Eigen::MatrixXd scaled =
        scale.asDiagonal() * sum.normal.topLeftCorner(terms, terms) * scale.asDiagonal();
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(scaled);
    const Eigen::VectorXd moment = scale.asDiagonal() * sum.normal.col(terms).head(terms);
    Trial trial;
    const Eigen::VectorXd solution = ldlt.solve(moment);
    const double freedom = sum.freedom - static_cast<double>(terms);
    const double square = sum.normal(terms, terms) - moment.dot(solution);
    constexpr double least = 1e-40;  // of values without any noise
    const double unit = std::max(square / freedom, least);
    // A difference that the digits of its terms do not hold is no residual.
    constexpr double digits = 1e-11;
    const bool lost = square < digits * sum.normal(terms, terms);
    if (lost || !std::isfinite(unit) || !(ldlt.vectorD().minCoeff() > 0)) {
        return trial;
    }
    const double log_terms = ldlt.vectorD().array().log().sum() - 2 * scale.array().log().sum();
    trial.likelihood = -0.5 * (freedom * std::log(unit) + sum.log_det + log_terms);
    trial.fit.coefficients = scale.asDiagonal() * solution;
    const Eigen::MatrixXd inverse = ldlt.solve(Eigen::MatrixXd::Identity(terms, terms));
    trial.fit.covariance = unit * (scale.asDiagonal() * inverse * scale.asDiagonal());
    trial.fit.noise = noise;
    trial.fit.noise.white *= unit;
    trial.fit.noise.walk *= unit;
    trial.fit.noise.slow_variance *= unit;
    return trial;
}

// Decades of the walk, of the slow variance and of the slow rate beside a white noise of one.
using Decades = std::array<double, 3>;

class NoiseSearch {
public:
    NoiseSearch(const std::vector<FitSegment>& segments, SeriesKind kind, const JobControl& job)
        : segments_(segments), kind_(kind), job_(job) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t rows = 0;
        for (const FitSegment& segment : segments) {
            seconds_ = std::max(seconds_, segment.time_s.back() - segment.time_s.front());
            for (std::size_t k = 1; k < segment.time_s.size(); ++k) {
                least = std::min(least, segment.time_s[k] - segment.time_s[k - 1]);
            }
            rows += segment.time_s.size();
        }
        step_s_ = std::isfinite(least) ? least : 1;
        count_ = segments.front().count.mean();
    }

    Trial find() {
        Trial best = without_slow();
        if (job_.cancelled()) {
            return best;
        }
        constexpr double rise = 4;
        Trial slow;
        for (const auto kind : {SeriesNoise::Slow::value, SeriesNoise::Slow::rate}) {
            if (kind == SeriesNoise::Slow::rate && kind_ == SeriesKind::value) {
                continue;
            }
            for (const double rate :
                 {3 / seconds_, std::sqrt(3 / seconds_ / step_s_), 0.3 / step_s_}) {
                Trial found = with_slow(kind, rate);
                if (found.likelihood > slow.likelihood) {
                    slow = std::move(found);
                }
            }
        }
        return slow.likelihood > best.likelihood + rise ? slow : best;
    }

private:
    // Units in which a decade is one of the white noise of a row.
    SeriesNoise noise_of(const Decades& at, SeriesNoise::Slow slow) const {
        SeriesNoise noise;
        noise.white = 1;
        const double row = 1 / count_;
        noise.walk = kind_ == SeriesKind::angle ? row * std::pow(10.0, at[0]) / step_s_ : 0;
        noise.slow = slow;
        if (slow != SeriesNoise::Slow::none) {
            noise.slow_rate = std::pow(10.0, at[2]);
            const double unit =
                slow == SeriesNoise::Slow::rate
                    ? std::max(noise.slow_rate / seconds_, noise.slow_rate * noise.slow_rate)
                    : 1;
            noise.slow_variance = row * std::pow(10.0, at[1]) * unit;
        }
        return noise;
    }

    Trial at(const Decades& decades, SeriesNoise::Slow slow) const {
        return trial_of(segments_, kind_, noise_of(decades, slow));
    }

    // The greatest likelihood about a start: steps along each coordinate, halved where none helps.
    Trial climbed(Decades from, SeriesNoise::Slow slow, std::span<const std::size_t> along,
                  Trial best) const {
        constexpr double far = 12;
        for (double step = 1; step > 0.03 && !job_.cancelled(); step /= 2) {
            for (bool moved = true; moved && !job_.cancelled();) {
                moved = false;
                for (const std::size_t i : along) {
                    for (const double side : {step, -step}) {
                        Decades next = from;
                        next[i] += side;
                        if (i < 2 ? std::abs(next[i]) > far : !within(next[i])) {
                            continue;
                        }
                        Trial trial = at(next, slow);
                        if (trial.likelihood > best.likelihood + 1e-3) {
                            best = std::move(trial);
                            from = next;
                            moved = true;
                            break;
                        }
                    }
                }
            }
        }
        return best;
    }

    bool within(double log_rate) const {
        return log_rate >= std::log10(0.3 / seconds_) && log_rate <= std::log10(1 / step_s_);
    }

    Trial without_slow() {
        if (kind_ == SeriesKind::value) {
            return at({}, SeriesNoise::Slow::none);
        }
        Trial best;
        for (double decade = -10; decade <= 6; decade += 2) {
            Trial trial = at({decade, 0, 0}, SeriesNoise::Slow::none);
            if (trial.likelihood > best.likelihood) {
                best = std::move(trial);
                walk_ = decade;
            }
        }
        static constexpr std::array<std::size_t, 1> alone{0};
        return climbed({walk_, 0, 0}, SeriesNoise::Slow::none, alone, std::move(best));
    }

    Trial with_slow(SeriesNoise::Slow slow, double rate) const {
        static constexpr std::array<std::size_t, 3> all{1, 2, 0};
        Trial best;
        Decades from{};
        for (double decade = -4; decade <= 4; decade += 2) {
            const Decades next{walk_, decade, std::log10(rate)};
            Trial trial = at(next, slow);
            if (trial.likelihood > best.likelihood) {
                best = std::move(trial);
                from = next;
            }
        }
        const bool walks = kind_ == SeriesKind::angle;
        return climbed(from, slow, std::span(all).first(walks ? 3 : 2), std::move(best));
    }

    const std::vector<FitSegment>& segments_;
    SeriesKind kind_;
    const JobControl& job_;
    double seconds_ = 0;
    double step_s_ = 1;
    double count_ = 1;
    double walk_ = 0;
};

}  // namespace

double SeriesNoise::variance_of_change(double seconds) const {
    const Step step = step_of(*this, seconds);
    double variance = 2 * white + step.q_walk;
    if (slow == Slow::value) {
        variance += 2 * slow_variance * (1 - step.slow_by_slow);
    } else if (slow == Slow::rate) {
        variance += step.walk_by_slow * step.walk_by_slow * slow_variance;
    }
    return variance;
}

ColouredFit coloured_fit(const std::vector<FitSegment>& segments, SeriesKind kind,
                         const JobControl& job) {
    // The measured values less their plain fit: sums of their squares would lose the digits of a
    // noise that is 1e-8 of a whole turn.
    std::vector<FitSegment> reduced = segments;
    Eigen::Index rows = 0;
    for (FitSegment& segment : reduced) {
        if (kind == SeriesKind::angle) {
            segment.rows.rowwise() -= Eigen::RowVectorXd(segment.rows.colwise().mean());
        }
        rows += segment.rows.rows();
    }
    Eigen::MatrixXd all(rows, reduced.front().rows.cols());
    Eigen::Index at = 0;
    for (const FitSegment& segment : reduced) {
        all.middleRows(at, segment.rows.rows()) = segment.rows;
        at += segment.rows.rows();
    }
    const Eigen::Index terms = all.cols() - 1;
    const Eigen::VectorXd plain =
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(Eigen::MatrixXd(all.leftCols(terms)))
            .solve(all.col(terms));
    for (FitSegment& segment : reduced) {
        segment.rows.col(terms) -= segment.rows.leftCols(terms) * plain;
    }
    ColouredFit fit = NoiseSearch(reduced, kind, job).find().fit;
    if (fit.coefficients.size() > 0) {
        fit.coefficients += plain;
    }
    return fit;
}

}  // namespace vybeg
