#include "core/drift/whole_angle_drift.h"

#include "core/drift/held_resonator.h"
#include "core/drift/log_drift.h"
#include "core/numerics/dense_solvers.h"
#include "core/numerics/harmonic_terms.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

// Where the terms of a harmonic stand, and how many they are.
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
    Eigen::MatrixXd covariance;
    double chi2 = 0;
    double freedom = 0;

    double deviations() const { return freedom > 0 ? chi2_deviations(chi2, freedom) : 0; }
};

Mean mean_of(const std::vector<const LogDrift*>& logs, Eigen::Index first, Eigen::Index count) {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd moment = Eigen::VectorXd::Zero(count);
    for (const LogDrift* log : logs) {
        const Eigen::MatrixXd weight =
            inverse_of(log->covariance.block(first, first, count, count));
        information += weight;
        moment += weight * log->coefficients.segment(first, count);
    }
    Mean mean;
    mean.covariance = inverse_of(information);
    mean.value = mean.covariance * moment;
    for (const LogDrift* log : logs) {
        const Eigen::VectorXd off = log->coefficients.segment(first, count) - mean.value;
        mean.chi2 += off.dot(inverse_of(log->covariance.block(first, first, count, count)) * off);
    }
    mean.freedom = static_cast<double>(count) * (static_cast<double>(logs.size()) - 1);
    return mean;
}

std::vector<LogAgreement> agreement_of(const std::vector<const LogDrift*>& logs) {
    std::vector<LogAgreement> found;
    for (const Place& place : places) {
        const Mean mean = mean_of(logs, place.first, place.count);
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
std::optional<std::size_t> foreign_log(const std::vector<LogDrift>& logs) {
    std::optional<std::size_t> foreign;
    constexpr std::size_t least = 3;
    for (std::size_t k = 0; logs.size() >= least && k < logs.size(); ++k) {
        if (harmonics_agree(agreement_of(pointers_to(logs, k)))) {
            if (foreign) {
                return std::nullopt;
            }
            foreign = k;
        }
    }
    return foreign;
}

void examine_logs(WholeAngleDrift& found) {
    found.agreement = agreement_of(pointers_to(found.logs));
    if (harmonics_agree(found.agreement)) {
        return;
    }
    const int harmonic = worst_of(found.agreement).harmonic;
    found.left_out = foreign_log(found.logs);
    if (found.left_out) {
        found.warnings.push_back({DiagnosticKind::log_left_out,
                                  {found.logs[*found.left_out].name, count_arg(harmonic)}});
        return;
    }
    std::string names;
    for (const LogDrift& log : found.logs) {
        names += names.empty() ? "" : ", ";
        names += log.name;
    }
    for (const LogAgreement& each : found.agreement) {
        if (each.harmonic != 0 && !each.agrees) {
            found.warnings.push_back(
                {DiagnosticKind::logs_differ,
                 {count_arg(each.harmonic), number_arg(each.deviations, 3), names}});
        }
    }
}

void put_together(WholeAngleDrift& found) {
    const std::vector<const LogDrift*> used = pointers_to(found.logs, found.left_out);
    const std::vector<LogAgreement> agreement = agreement_of(used);
    Eigen::VectorXd value = Eigen::VectorXd::Zero(log_terms);
    found.covariance = Eigen::MatrixXd::Zero(log_terms, log_terms);
    const auto take = [&](Eigen::Index first, Eigen::Index count) {
        const Mean mean = mean_of(used, first, count);
        value.segment(first, count) = mean.value;
        found.covariance.block(first, first, count, count) = mean.covariance;
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
        }
    }
    std::vector<LogDrift> logs;
    logs.reserve(used.size());
    for (const LogDrift* log : used) {
        logs.push_back(*log);
    }
    constexpr Eigen::Index fourth = 3;
    if (agreement.back().agrees) {
        found.resonator =
            held_resonator(value.tail<2>(), found.covariance.block<2, 2>(fourth, fourth), logs);
        return;
    }
    for (Estimate* each :
         {&found.resonator.damping_anisotropy_per_s, &found.resonator.theta_tau_rad,
          &found.resonator.tau_s, &found.resonator.split_hz, &found.resonator.theta_w_rad}) {
        each->reason = {ReasonCode::logs_differ, {}};
    }
}

// The weighted mean of the bins of the logs that are used.
void add_bins(const std::vector<std::vector<LogBin>>& of_logs, WholeAngleDrift& found) {
    found.bins = of_logs.front();
    for (std::size_t bin = 0; bin < found.bins.size(); ++bin) {
        double weight = 0;
        double moment = 0;
        found.bins[bin].seconds = 0;
        for (std::size_t k = 0; k < of_logs.size(); ++k) {
            const LogBin& one = of_logs[k][bin];
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

Result<WholeAngleDrift> whole_angle_drift(std::span<const WholeAngleLog> logs,
                                          const JobControl& job) {
    WholeAngleDrift found;
    std::vector<std::vector<LogBin>> bins;
    for (std::size_t k = 0; k < logs.size(); ++k) {
        for (std::size_t other = 0; other < k && !logs[k].sha256.empty(); ++other) {
            if (logs[other].sha256 == logs[k].sha256) {
                return Error{ErrorCode::same_recording, logs[k].name, {logs[other].name}};
            }
        }
    }
    for (const WholeAngleLog& log : logs) {
        auto binned = TRY(log_drift(log, job));
        constexpr double quarter = std::numbers::pi / 2;
        if (binned.period == quarter) {
            found.warnings.push_back({DiagnosticKind::angle_of_quarter, {log.name}});
        }
        found.logs.push_back(std::move(binned.drift));
        bins.push_back(std::move(binned.bins));
        job.report(static_cast<double>(found.logs.size()) / static_cast<double>(logs.size()));
    }
    examine_logs(found);
    put_together(found);
    add_bins(bins, found);
    return found;
}

}  // namespace vybeg
