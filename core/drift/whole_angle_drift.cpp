#include "core/drift/whole_angle_drift.h"

#include "core/base/plain_text.h"
#include "core/numerics/dense_solvers.h"
#include "core/numerics/harmonic_terms.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

// The place of the terms of a harmonic, and their number.
struct Place {
    int harmonic;
    Eigen::Index first;
    Eigen::Index count;
};
constexpr std::array places{Place{0, 0, 1}, Place{2, 1, 2}, Place{4, 3, 2}};

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix) {
    const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(scaled);
    const Eigen::MatrixXd inverse =
        ldlt.solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
    return scale.asDiagonal() * inverse * scale.asDiagonal();
}

// The weighted mean of some terms over logs, and chi^2 about it.
struct Mean {
    Eigen::VectorXd value;
    Eigen::MatrixXd covariance;  // of the noise
    Eigen::MatrixXd with_channels;
    Eigen::Vector2d errors = Eigen::Vector2d::Zero();  // of gain ratio and skew
    double chi2 = 0;
    double freedom = 0;

    double deviations() const { return freedom > 0 ? chi2_deviations(chi2, freedom) : 0; }
};

// What a small error of the channels makes of a drift with these coefficients at an angle, per unit
// of it. The angle is seen at theta + e f(theta): f is sin 4 theta/4 of the gain ratio,
// (1 + cos 4 theta)/4 of the skew, and the rate seen there has g f' - g' f more.
double seen_at(double theta, const Eigen::VectorXd& drift, Eigen::Index error) {
    const double shift = error == 0 ? std::sin(4 * theta) / 4 : (1 + std::cos(4 * theta)) / 4;
    const double stretch = error == 0 ? std::cos(4 * theta) : -std::sin(4 * theta);
    const Eigen::VectorXd terms = harmonic_terms(log_harmonics, theta);
    Eigen::VectorXd slopes = Eigen::VectorXd::Zero(log_terms);
    for (std::size_t i = 0; i < log_harmonics.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(2 * i);
        slopes[at + 1] = -log_harmonics[i] * terms[at + 2];
        slopes[at + 2] = log_harmonics[i] * terms[at + 1];
    }
    return stretch * drift.dot(terms) - shift * drift.dot(slopes);
}

// The same as coefficients.
Eigen::VectorXd seen_of(const Eigen::VectorXd& drift, Eigen::Index error) {
    constexpr int samples = 16;  // of a product up to the eighth harmonic
    Eigen::VectorXd seen = Eigen::VectorXd::Zero(log_terms);
    for (int k = 0; k < samples; ++k) {
        const double theta = k * std::numbers::pi / samples;
        seen += 2.0 / samples * seen_at(theta, drift, error) * harmonic_terms(log_harmonics, theta);
    }
    seen[0] /= 2;
    return seen;
}

// Errors of the channels make a fourth harmonic of the turn m: m (gain cos 4 theta - skew sin 4
// theta). They are unknowns of all logs with a prior of their tolerance, and logs that turn
// differently separate them from the drift. Solved for the drift at the mean turn: the turn of a
// log alone takes nothing from its digits. Their effect on the drift itself is alike in all logs,
// and that on the second harmonic, 3/4 of the gain's error of it, is in no other number.
Mean mean_of(const std::vector<const LogDrift*>& logs, const ChannelTolerance& channels,
             Eigen::Index first, Eigen::Index count) {
    Eigen::VectorXd centre = Eigen::VectorXd::Zero(log_terms);
    double weights = 0;
    for (const LogDrift* log : logs) {
        const double weight = 1 / log->covariance(log_terms - 1, log_terms - 1);
        centre += weight * log->coefficients;
        weights += weight;
    }
    centre /= weights;
    struct SeenError {
        Eigen::Index error;       // as of seen_of()
        double weight;            // of its prior
        Eigen::VectorXd of_turn;  // its effect on a turn of 1: a fourth harmonic
    };
    std::vector<SeenError> errors;
    const std::array tolerances{channels[kappa_error], channels[skew_error]};
    for (Eigen::Index k = 0; k < 2; ++k) {
        const double sd = tolerances[static_cast<std::size_t>(k)];
        if (sd > 0) {
            errors.push_back({k, 1 / (sd * sd), seen_of(Eigen::VectorXd::Unit(log_terms, 0), k)});
        }
    }
    const auto size = count + static_cast<Eigen::Index>(errors.size());
    const auto weight_of = [&](const LogDrift& log) -> Eigen::MatrixXd {
        return inverse_of(log.covariance.block(first, first, count, count));
    };
    const auto terms_of = [&](const LogDrift& log) {
        Eigen::MatrixXd terms = Eigen::MatrixXd::Identity(count, size);
        for (std::size_t k = 0; k < errors.size(); ++k) {
            terms.col(count + static_cast<Eigen::Index>(k)) =
                (log.coefficients[0] - centre[0]) * errors[k].of_turn.segment(first, count);
        }
        return terms;
    };
    Eigen::MatrixXd of_noise = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd moment = Eigen::VectorXd::Zero(size);
    for (const LogDrift* log : logs) {
        const Eigen::MatrixXd terms = terms_of(*log);
        const Eigen::MatrixXd weighted = terms.transpose() * weight_of(*log);
        of_noise += weighted * terms;
        moment += weighted * log->coefficients.segment(first, count);
    }
    Eigen::MatrixXd information = of_noise;
    for (std::size_t k = 0; k < errors.size(); ++k) {
        const Eigen::Index at = count + static_cast<Eigen::Index>(k);
        information(at, at) += errors[k].weight;
    }
    const Eigen::MatrixXd inverse = inverse_of(information);
    const Eigen::VectorXd solved = inverse * moment;
    Mean mean;
    double squares = 0;
    for (std::size_t k = 0; k < errors.size(); ++k) {
        const Eigen::Index at = count + static_cast<Eigen::Index>(k);
        mean.errors[errors[k].error] = solved[at];
        mean.chi2 += solved[at] * solved[at] * errors[k].weight;
        squares += solved[at] * solved[at] + inverse(at, at);
    }
    // From the unknowns to the drift, without the effect of the errors.
    Eigen::MatrixXd to_drift = Eigen::MatrixXd::Identity(count, size);
    Eigen::VectorXd drift = centre;
    for (int pass = 0; pass < 2; ++pass) {  // the mean holds the errors of the turn, too
        for (std::size_t k = 0; k < errors.size(); ++k) {
            to_drift.col(count + static_cast<Eigen::Index>(k)) =
                -seen_of(drift, errors[k].error).segment(first, count);
        }
        drift.segment(first, count) = to_drift * solved;
    }
    mean.value = to_drift * solved;
    mean.covariance = to_drift * inverse * of_noise * inverse * to_drift.transpose();
    mean.with_channels = to_drift * inverse * to_drift.transpose();
    if (first == 0) {
        // The turn seen is m (1 + (gain^2 + skew^2)/2): rms of that of normal errors.
        const double second = std::sqrt(3.0) / 2 * squares * centre[0];
        mean.with_channels(0, 0) += second * second;
    }
    for (const LogDrift* log : logs) {
        const Eigen::VectorXd off =
            log->coefficients.segment(first, count) - terms_of(*log) * solved;
        mean.chi2 += off.dot(weight_of(*log) * off);
    }
    mean.freedom = static_cast<double>(count) * (static_cast<double>(logs.size()) - 1);
    return mean;
}

std::vector<LogAgreement> agreement_of(const std::vector<const LogDrift*>& logs,
                                       const ChannelTolerance& channels) {
    std::vector<LogAgreement> found;
    for (const Place& place : places) {
        const Mean mean = mean_of(logs, channels, place.first, place.count);
        found.push_back({place.harmonic, mean.chi2, mean.freedom, mean.deviations(),
                         mean.deviations() < log_differs});
    }
    return found;
}

// The turn may differ: it is the input rate.
bool harmonics_agree(const std::vector<LogAgreement>& agreement) {
    return std::ranges::all_of(
        agreement, [](const LogAgreement& each) { return each.harmonic == 0 || each.agrees; });
}

const LogAgreement& worst_of(const std::vector<LogAgreement>& agreement) {
    return *std::ranges::max_element(agreement, {}, [](const LogAgreement& each) {
        return each.harmonic == 0 ? -std::numeric_limits<double>::infinity() : each.deviations;
    });
}

std::vector<const LogDrift*> pointers_to(const std::vector<LogDrift>& logs,
                                         std::optional<std::size_t> without = {}) {
    std::vector<const LogDrift*> pointers;
    for (std::size_t k = 0; k < logs.size(); ++k) {
        if (without != k) {
            pointers.push_back(&logs[k]);
        }
    }
    return pointers;
}

// The one log without which the others agree, if there are three or more and only one is such.
std::optional<std::size_t> foreign_log(const std::vector<LogDrift>& logs,
                                       const ChannelTolerance& channels) {
    std::optional<std::size_t> foreign;
    constexpr std::size_t least = 3;
    for (std::size_t k = 0; logs.size() >= least && k < logs.size(); ++k) {
        if (harmonics_agree(agreement_of(pointers_to(logs, k), channels))) {
            if (foreign) {
                return std::nullopt;
            }
            foreign = k;
        }
    }
    return foreign;
}

void examine_logs(const ChannelTolerance& channels, WholeAngleDrift& found) {
    found.agreement = agreement_of(pointers_to(found.logs), channels);
    if (harmonics_agree(found.agreement)) {
        return;
    }
    const int harmonic = worst_of(found.agreement).harmonic;
    found.left_out = foreign_log(found.logs, channels);
    if (found.left_out) {
        found.warnings.push_back({DiagnosticKind::log_left_out,
                                  {found.logs[*found.left_out].name, count_arg(harmonic)}});
        return;
    }
    const std::string names = joined(found.logs, ", ", &LogDrift::name);
    for (const LogAgreement& each : found.agreement) {
        if (each.harmonic != 0 && !each.agrees) {
            found.warnings.push_back(
                {DiagnosticKind::logs_differ,
                 {count_arg(each.harmonic), number_arg(each.deviations, 3), names}});
        }
    }
}

// Where the fourth harmonic is known by the tolerance of the channels alone.
void warn_of_one_turn(WholeAngleDrift& found) {
    constexpr double much = 3;
    double size = 0;
    bool unsure = false;
    for (Eigen::Index term = fourth; term < log_terms; ++term) {
        const Estimate& each = found.harmonics[static_cast<std::size_t>(term)];
        unsure = unsure || each.u > much * each.sd;
        size = std::max(size, each.u);
    }
    if (unsure) {
        constexpr double deg_h = 3600 * 180 / std::numbers::pi;
        found.warnings.push_back(
            {DiagnosticKind::turn_one_way, {number_arg(deg_h * size, 2, "deg/h")}});
    }
}

// Returns the errors of the channels that all logs together determine.
Eigen::Vector2d put_together(const ChannelTolerance& channels, WholeAngleDrift& found) {
    const std::vector<const LogDrift*> used = pointers_to(found.logs, found.left_out);
    const std::vector<LogAgreement> agreement = agreement_of(used, channels);
    Eigen::VectorXd value = Eigen::VectorXd::Zero(log_terms);
    found.covariance = Eigen::MatrixXd::Zero(log_terms, log_terms);
    Eigen::MatrixXd with_channels = found.covariance;
    Eigen::Vector2d errors = Eigen::Vector2d::Zero();
    const auto take = [&](Eigen::Index first, Eigen::Index count) {
        const Mean mean = mean_of(used, channels, first, count);
        value.segment(first, count) = mean.value;
        found.covariance.block(first, first, count, count) = mean.covariance;
        with_channels.block(first, first, count, count) = mean.with_channels;
        errors = mean.errors;  // of the last block, the fourth harmonic
    };
    // A number in which the logs differ would move the others.
    if (harmonics_agree(agreement)) {
        const Eigen::Index first = agreement.front().agrees ? 0 : 1;
        take(first, log_terms - first);
    } else {
        for (const Place& place : places) {
            take(place.first, place.count);
        }
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
        for (Eigen::Index term = places[k].first; term < places[k].first + places[k].count;
             ++term) {
            Estimate& estimate = found.harmonics[static_cast<std::size_t>(term)];
            if (!agreement[k].agrees) {
                estimate.reason = {ReasonCode::logs_differ, {}};
                constexpr double none = std::numeric_limits<double>::quiet_NaN();
                found.covariance.row(term).setConstant(none);
                found.covariance.col(term).setConstant(none);
                continue;
            }
            estimate.value = value[term];
            estimate.sd = std::sqrt(found.covariance(term, term));
            estimate.u = std::sqrt(with_channels(term, term));
        }
    }
    if (agreement.back().agrees) {
        found.resonator =
            held_resonator(value.tail<2>(), found.covariance.block<2, 2>(fourth, fourth),
                           with_channels.block<2, 2>(fourth, fourth), used);
        warn_of_one_turn(found);
        return errors;
    }
    refuse(held_parameters, {ReasonCode::logs_differ, {}}, found.resonator);
    return Eigen::Vector2d::Zero();
}

// Takes out of the rates of a log what the errors of the channels make of its turn and of the
// drift.
void take_out(const Eigen::Vector2d& errors, const WholeAngleDrift& found, LogDrift& log) {
    Eigen::VectorXd drift = Eigen::VectorXd::Zero(log_terms);
    drift[0] = log.coefficients[0];
    for (Eigen::Index term = 1; term < log_terms; ++term) {
        const Estimate& each = found.harmonics[static_cast<std::size_t>(term)];
        drift[term] = each.given() ? each.value : 0;
    }
    const double half = std::numbers::pi / (2 * static_cast<double>(log.bins.size()));
    for (const Eigen::Index error : {0, 1}) {
        const auto seen = [&](double theta) { return seen_at(theta, drift, error); };
        const double of_turn = seen_of(drift, error)[0];  // which is taken out
        for (LogBin& bin : log.bins) {
            // The mean over the bin, by Simpson's rule.
            const double mean =
                (seen(bin.theta - half) + 4 * seen(bin.theta) + seen(bin.theta + half)) / 6;
            bin.rate -= errors[error] * (mean - of_turn);
        }
    }
}

// The weighted mean of the bins of the logs that are used.
void add_bins(WholeAngleDrift& found) {
    found.bins = found.logs.front().bins;
    for (std::size_t bin = 0; bin < found.bins.size(); ++bin) {
        double weight = 0;
        double moment = 0;
        found.bins[bin].seconds = 0;
        for (std::size_t k = 0; k < found.logs.size(); ++k) {
            const LogBin& one = found.logs[k].bins[bin];
            if (found.left_out != k && one.sd > 0) {
                weight += 1 / (one.sd * one.sd);
                moment += one.rate / (one.sd * one.sd);
                found.bins[bin].seconds += one.seconds;
            }
        }
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        found.bins[bin].rate = weight > 0 ? moment / weight : none;
        found.bins[bin].sd = weight > 0 ? 1 / std::sqrt(weight) : none;
    }
}

}  // namespace

double WholeAngleDrift::rate(double theta) const {
    const Eigen::VectorXd terms = harmonic_terms(log_harmonics, theta);
    double sum = 0;
    for (Eigen::Index k = 1; k < log_terms; ++k) {
        sum += harmonics[static_cast<std::size_t>(k)].value * terms[k];
    }
    return sum;
}

double WholeAngleDrift::sd_rate(double theta) const {
    const Eigen::VectorXd terms = harmonic_terms(log_harmonics, theta).tail(log_terms - 1);
    return std::sqrt(terms.dot(covariance.bottomRightCorner(log_terms - 1, log_terms - 1) * terms));
}

ChannelTolerance usual_pick_offs() {
    ChannelTolerance usual = untold_channels;
    usual[skew_error] = tolerated_errors[skew_error].factor *
                        std::ranges::find(usual_errors, skew_error, &UsualError::source)->size;
    return usual;
}

Result<WholeAngleDrift> whole_angle_drift(std::span<const WholeAngleLog> logs,
                                          const JobControl& job, const ChannelTolerance& channels) {
    WholeAngleDrift found;
    for (std::size_t k = 0; k < logs.size(); ++k) {
        for (std::size_t other = 0; other < k && !logs[k].sha256.empty(); ++other) {
            if (logs[other].sha256 == logs[k].sha256) {
                return Error{ErrorCode::same_recording, logs[k].name, {logs[other].name}};
            }
        }
    }
    for (const WholeAngleLog& log : logs) {
        auto drift = TRY(log_drift(log, job));
        constexpr double quarter = std::numbers::pi / 2;
        if (drift.period == quarter) {
            found.warnings.push_back({DiagnosticKind::angle_of_quarter, {log.name}});
        }
        for (Diagnostic warning : std::exchange(drift.warnings, {})) {
            warning.args.insert(warning.args.begin(), log.name);
            found.warnings.push_back(std::move(warning));
        }
        found.logs.push_back(std::move(drift));
        job.report(static_cast<double>(found.logs.size()) / static_cast<double>(logs.size()));
    }
    examine_logs(channels, found);
    const Eigen::Vector2d errors = put_together(channels, found);
    for (LogDrift& log : found.logs) {
        take_out(errors, found, log);
    }
    add_bins(found);
    return found;
}

}  // namespace vybeg
