#include "core/drift/whole_angle_log.h"

#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/open/log_columns.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

constexpr double quarter = std::numbers::pi / 2;
constexpr double degree = std::numbers::pi / 180;

// Rows with an angle, and what two neighbours among them usually have between them.
struct Usual {
    std::vector<std::size_t> rows;
    bool wraps = false;  // or may
    double step_s = 0;
    double rate = 0;  // rad/s

    // The change of an angle from row to row, of a wrapped one the smallest that it may be.
    double turn_between(double before, double after) const {
        return wraps ? std::remainder(after - before, quarter) : after - before;
    }
};

// Whether the angles may lie within one turn: nearly all do.
bool may_wrap(std::vector<double> angles) {
    if (angles.empty()) {
        return false;
    }
    constexpr std::size_t aside = 100;
    const std::size_t few = angles.size() / aside;
    const auto low = angles.begin() + static_cast<std::ptrdiff_t>(few);
    const auto high = angles.end() - 1 - static_cast<std::ptrdiff_t>(few);
    std::ranges::nth_element(angles, low);
    const double least = *low;
    std::ranges::nth_element(angles, high);
    return *high - least < 2 * std::numbers::pi;
}

Usual usual_of(const WholeAngleLog& log) {
    Usual usual;
    std::vector<double> angles;
    for (std::size_t k = 0; k < log.theta.size(); ++k) {
        if (std::isfinite(log.theta[k])) {
            usual.rows.push_back(k);
            angles.push_back(log.theta[k]);
        }
    }
    usual.wraps = may_wrap(std::move(angles));
    std::vector<double> steps;
    std::vector<double> rates;
    for (std::size_t k = 1; k < usual.rows.size(); ++k) {
        const std::size_t at = usual.rows[k];
        const std::size_t before = usual.rows[k - 1];
        const double step = log.time_s[at] - log.time_s[before];
        if (step > 0) {
            steps.push_back(step);
            rates.push_back(usual.turn_between(log.theta[before], log.theta[at]) / step);
        }
    }
    usual.step_s = median(std::move(steps));
    usual.rate = median(std::move(rates));
    return usual;
}

// Relative uncertainty of a turn computed from the usual rate alone: twice the spread of the rates
// of ten parts of the log.
double uncertainty_of_turn(const WholeAngleLog& log, const Usual& usual) {
    constexpr double least = 0.02;
    constexpr double most = 0.2;
    constexpr std::size_t parts = 10;
    std::array<double, parts> turns{};
    std::array<double, parts> seconds{};
    for (std::size_t k = 1; k < usual.rows.size(); ++k) {
        const std::size_t at = usual.rows[k];
        const std::size_t before = usual.rows[k - 1];
        const double step = log.time_s[at] - log.time_s[before];
        if (step > 0 && step <= 1.5 * usual.step_s) {
            const std::size_t part = k * parts / usual.rows.size();
            turns[part] += usual.turn_between(log.theta[before], log.theta[at]);
            seconds[part] += step;
        }
    }
    double low = usual.rate;
    double high = usual.rate;
    for (std::size_t part = 0; part < parts; ++part) {
        if (seconds[part] > 0) {
            low = std::min(low, turns[part] / seconds[part]);
            high = std::max(high, turns[part] / seconds[part]);
        }
    }
    return usual.rate == 0 ? most
                           : std::clamp(2 * (high - low) / std::abs(usual.rate), least, most);
}

struct Jumps {
    double period = 0;   // by which neighbours jump most often; 0: they do not
    bool often = false;  // between every other row: the wave turns too fast for its rows
};

Jumps jumps_of(const WholeAngleLog& log, const Usual& usual) {
    std::array<std::size_t, 5> jumps{};  // by quarters of a turn
    for (std::size_t k = 1; k < usual.rows.size() && usual.wraps; ++k) {
        const std::size_t at = usual.rows[k];
        const std::size_t before = usual.rows[k - 1];
        if (log.time_s[at] - log.time_s[before] > 1.5 * usual.step_s) {
            continue;
        }
        const double change = log.theta[at] - log.theta[before];
        const double jump = std::abs(change - usual.turn_between(log.theta[before], log.theta[at]));
        const auto quarters = static_cast<std::size_t>(std::lround(std::min(jump / quarter, 9.0)));
        if (quarters < jumps.size()) {
            ++jumps[quarters];
        }
    }
    const auto most = std::max_element(jumps.begin() + 1, jumps.end());
    Jumps found;
    found.period = *most == 0 ? 0 : quarter * static_cast<double>(most - jumps.begin());
    found.often = std::accumulate(jumps.begin() + 1, jumps.end(), std::size_t{0}) > jumps[0];
    return found;
}

// By how much the angle comes back each time from one end of its range to the other, whatever its
// unit; 0: it does not, or only now and then.
double period_in_its_unit(const WholeAngleLog& log, const Usual& usual) {
    constexpr double most_of_range = 0.6;  // a wrapped angle lacks less than two eighths of it
    constexpr double alike = 0.05;
    constexpr std::size_t least_times = 3;
    std::vector<double> changes;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t k = 0; k < usual.rows.size(); ++k) {
        const double theta = log.theta[usual.rows[k]];
        least = std::min(least, theta);
        most = std::max(most, theta);
        if (k > 0) {
            changes.push_back(theta - log.theta[usual.rows[k - 1]]);
        }
    }
    const double step = median(changes);
    std::vector<double> back;
    for (const double change : changes) {
        if (std::abs(change) > most_of_range * (most - least)) {
            back.push_back(std::abs(change - step));
        }
    }
    if (back.size() < least_times || back.size() > changes.size() / 4) {
        return 0;
    }
    const auto [shortest, longest] = std::ranges::minmax(back);
    const double usual_back = median(std::move(back));
    return longest - shortest < alike * usual_back ? usual_back : 0;
}

// Whether an angle may wrap there: at a quarter, a half or a whole turn.
bool is_period(double angle) {
    constexpr double near = 0.05;
    return std::ranges::any_of(std::array{1, 2, 4}, [&](int quarters) {
        return std::abs(angle / (quarters * quarter) - 1) < near;
    });
}

// The step in which the angles are written, rad, where nearly all second differences are whole
// multiples of it, and small ones; 0: there is none.
double step_of_digits(const UnwrappedAngle& angle) {
    constexpr double rounding = 1e-9;
    std::vector<double> bends;
    for (const AngleStretch& stretch : angle.stretches) {
        for (std::size_t k = 2; k < stretch.theta.size(); ++k) {
            bends.push_back(
                std::abs(stretch.theta[k] - 2 * stretch.theta[k - 1] + stretch.theta[k - 2]));
        }
    }
    std::vector<double> moving;
    std::ranges::copy_if(bends, std::back_inserter(moving),
                         [](double bend) { return bend > rounding; });
    if (moving.empty()) {
        return 0;
    }
    const double digit = std::ranges::min(moving);
    const auto fits = std::ranges::count_if(moving, [digit](double bend) {
        return std::abs(std::remainder(bend, digit)) < 0.05 * digit + rounding;
    });
    const bool few = std::ranges::max(moving) < 1000 * digit;
    // Noise of a digit or more makes the steps harmless.
    const double mean =
        std::accumulate(bends.begin(), bends.end(), 0.0) / static_cast<double>(bends.size());
    return few && mean < 1.2 * digit && 10 * fits > 9 * std::ssize(moving) ? digit : 0;
}

// Ends a stretch where the angle goes on by far more than it does between other rows: at a new
// reference of the controller, or on either side of a false row, which is left out.
void cut_at_jumps(const Usual& usual, UnwrappedAngle& angle) {
    constexpr double deviations = 15;
    constexpr double beyond_most = 3;  // a rate that changes is no jump
    constexpr double most = 0.98;
    constexpr double normal = 1.4826;  // sd of a median deviation
    const auto beyond = [&](const AngleStretch& stretch, std::size_t k) {
        const double seconds = stretch.time_s[k] - stretch.time_s[k - 1];
        const double turned = stretch.theta[k] - stretch.theta[k - 1] - usual.rate * seconds;
        return seconds > 1.5 * usual.step_s ? 0 : turned;
    };
    std::vector<double> sizes;
    for (const AngleStretch& stretch : angle.stretches) {
        for (std::size_t k = 1; k < stretch.theta.size(); ++k) {
            sizes.push_back(std::abs(beyond(stretch, k)));
        }
    }
    constexpr std::size_t least_rows = 50;
    if (sizes.size() < least_rows) {
        return;
    }
    const auto high =
        sizes.begin() + static_cast<std::ptrdiff_t>(most * static_cast<double>(sizes.size()));
    std::ranges::nth_element(sizes, high);
    // Of an angle of few digits one digit is no jump.
    const double limit = std::max({beyond_most * *high, 4 * step_of_digits(angle),
                                   deviations * normal * median(std::vector(sizes))});
    std::vector<AngleStretch> cut;
    std::int64_t jumps = 0;
    for (AngleStretch& stretch : angle.stretches) {
        cut.emplace_back();
        const auto is_far = [&](std::size_t k) {
            return k > 0 && k < stretch.rows.size() && std::abs(beyond(stretch, k)) > limit;
        };
        for (std::size_t k = 0; k < stretch.rows.size(); ++k) {
            // Three in a row are another rate.
            const bool another_rate = (is_far(k + 1) && (is_far(k + 2) || is_far(k - 1))) ||
                                      (k > 2 && is_far(k - 1) && is_far(k - 2));
            if (is_far(k) && !another_rate) {
                const double jump = beyond(stretch, k);
                if (jumps++ == 0) {
                    angle.warnings.push_back(
                        {DiagnosticKind::angle_jumps,
                         {number_arg(jump / degree, 3), number_arg(stretch.time_s[k], 7)}});
                }
                if (cut.back().rows.size() == 1) {
                    cut.pop_back();
                }
                cut.emplace_back();
            }
            cut.back().rows.push_back(stretch.rows[k]);
            cut.back().time_s.push_back(stretch.time_s[k]);
            cut.back().theta.push_back(stretch.theta[k]);
        }
    }
    if (jumps > 0) {
        angle.warnings.back().args.push_back(count_arg(jumps));
        angle.stretches = std::move(cut);
    }
}

const std::vector<ColumnRole>& log_roles() {
    static const std::vector<ColumnRole> roles{
        {"t", {"t", "t_s", "time", "time_s", "время"}, false},
        {"theta", wave_angle_names},
        {"amplitude", amplitude_effort_names, false},
        {"quadrature", quadrature_effort_names, false}};
    return roles;
}

}  // namespace

UnwrappedAngle unwrapped_angle(const WholeAngleLog& log) {
    const Usual usual = usual_of(log);
    UnwrappedAngle found;
    const Jumps jumps = jumps_of(log, usual);
    found.period = jumps.period;
    found.too_fast = jumps.often;
    const double back = period_in_its_unit(log, usual);
    found.odd_period = is_period(back) ? 0 : back;
    // How well the turn of a gap is known from the usual rate.
    const double unsure = uncertainty_of_turn(log, usual);
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
    cut_at_jumps(usual, found);
    for (const AngleStretch& stretch : found.stretches) {
        const auto [least, most] = std::ranges::minmax(stretch.theta);
        found.turn = std::max(found.turn, most - least);
    }
    constexpr double coarse = 0.2;
    const double digit = step_of_digits(found);
    const double turn =
        found.turn / static_cast<double>(std::max<std::size_t>(usual.rows.size(), 1));
    if (digit > coarse * turn) {
        found.warnings.push_back({DiagnosticKind::angle_coarse,
                                  {number_arg(digit / degree, 2), number_arg(turn / degree, 2)}});
    }
    return found;
}

Status check_log_columns(const std::string& columns) {
    const auto wishes = column_wishes(columns, log_roles());
    return wishes ? Status() : Status(wishes.error());
}

Result<WholeAngleLog> read_whole_angle_log(const std::filesystem::path& path,
                                           const OpenOptions& options, const LogChoice& choice,
                                           const JobControl& job) {
    const auto wishes = TRY(column_wishes(choice.names, log_roles()));
    auto table = TRY(read_log(path, options, wishes, job));
    WholeAngleLog log;
    log.name = path.filename().string();
    log.sha256 = TRY(file_sha256(path, job));
    log.time_s = std::move(table.time_s);
    const auto amplitude = std::ranges::find_if(wishes, [](const ColumnWish& wish) {
        return wish.role.name == std::string_view("amplitude");
    });
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        LogColumn& column = table.columns[k];
        const std::string_view role = wishes[k].role.name;
        if (role == "theta") {
            const auto factor = TRY(angle_factor(path, column, choice.rad_per_angle_unit));
            for (const double value : column.values) {
                log.theta.push_back(factor * value);
            }
        } else if (role == "amplitude") {
            log.amplitude_effort = std::move(column.values);
        } else if (role == "quadrature") {
            bring_to_unit_of(table.columns[static_cast<std::size_t>(amplitude - wishes.begin())],
                             column);
            log.quadrature_effort = std::move(column.values);
        }
    }
    return log;
}

}  // namespace vybeg
