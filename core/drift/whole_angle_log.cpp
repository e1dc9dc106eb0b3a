#include "core/drift/whole_angle_log.h"

#include "core/numerics/median.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

constexpr double quarter = std::numbers::pi / 2;

// The change of an angle from row to row, of a wrapped one the smallest that it may be.
double turn_between(double before, double after) {
    return std::remainder(after - before, quarter);
}

// Rows with an angle, and what two neighbours among them usually have between them.
struct Usual {
    std::vector<std::size_t> rows;
    double step_s = 0;
    double rate = 0;  // rad/s
};

Usual usual_of(const WholeAngleLog& log) {
    Usual usual;
    for (std::size_t k = 0; k < log.theta.size(); ++k) {
        if (std::isfinite(log.theta[k])) {
            usual.rows.push_back(k);
        }
    }
    std::vector<double> steps;
    std::vector<double> rates;
    for (std::size_t k = 1; k < usual.rows.size(); ++k) {
        const std::size_t at = usual.rows[k];
        const std::size_t before = usual.rows[k - 1];
        const double step = log.time_s[at] - log.time_s[before];
        if (step > 0) {
            steps.push_back(step);
            rates.push_back(turn_between(log.theta[before], log.theta[at]) / step);
        }
    }
    usual.step_s = median(std::move(steps));
    usual.rate = median(std::move(rates));
    return usual;
}

// The period by which neighbours jump most often; 0: they do not.
double period_of(const WholeAngleLog& log, const Usual& usual) {
    std::array<std::size_t, 5> jumps{};  // by quarters of a turn
    for (std::size_t k = 1; k < usual.rows.size(); ++k) {
        const std::size_t at = usual.rows[k];
        const std::size_t before = usual.rows[k - 1];
        if (log.time_s[at] - log.time_s[before] > 1.5 * usual.step_s) {
            continue;
        }
        const double change = log.theta[at] - log.theta[before];
        const double jump = std::abs(change - turn_between(log.theta[before], log.theta[at]));
        const auto quarters = static_cast<std::size_t>(std::lround(std::min(jump / quarter, 9.0)));
        if (quarters > 0 && quarters < jumps.size()) {
            ++jumps[quarters];
        }
    }
    const auto most = std::ranges::max_element(jumps);
    return *most == 0 ? 0 : quarter * static_cast<double>(most - jumps.begin());
}

}  // namespace

UnwrappedAngle unwrapped_angle(const WholeAngleLog& log) {
    const Usual usual = usual_of(log);
    UnwrappedAngle found;
    found.period = period_of(log, usual);
    // How well the turn of a gap is known from the usual rate.
    constexpr double unsure = 0.2;
    for (const std::size_t row : usual.rows) {
        double theta = log.theta[row];
        bool goes_on = false;
        if (!found.stretches.empty()) {
            const AngleStretch& last = found.stretches.back();
            const double seconds = log.time_s[row] - last.time_s.back();
            if (seconds <= 0) {
                continue;
            }
            const bool next = seconds <= 1.5 * usual.step_s;
            const double turned = usual.rate * seconds;
            goes_on = next || found.period == 0 || unsure * std::abs(turned) < found.period / 4;
            if (goes_on && found.period > 0) {
                const double expected = last.theta.back() + (next ? 0 : turned);
                theta = nearest_branch(theta, expected, found.period);
            }
        }
        if (!goes_on) {
            found.stretches.emplace_back();
        }
        AngleStretch& stretch = found.stretches.back();
        stretch.rows.push_back(row);
        stretch.time_s.push_back(log.time_s[row]);
        stretch.theta.push_back(theta);
    }
    for (const AngleStretch& stretch : found.stretches) {
        const auto [least, most] = std::ranges::minmax(stretch.theta);
        found.turn = std::max(found.turn, most - least);
    }
    return found;
}

}  // namespace vybeg
