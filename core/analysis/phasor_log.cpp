#include "core/analysis/phasor_log.h"

#include "core/base/describe.h"
#include "core/base/read_value.h"
#include "core/numerics/lock_in.h"
#include "core/numerics/median.h"
#include "core/recording/open/log_columns.h"
#include "core/recording/samples/channel_pair.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double usual_window_s = 0.015;
constexpr double settled = 3;  // delays of the filter in a window
constexpr std::size_t least_windows = 100;
constexpr double least_correlation = 1e-3;

// Rows relative to f_ref_hz.
struct Rows {
    double f_ref_hz = 0;
    std::vector<double> time_s;
    std::vector<Complex> c;
    std::vector<Complex> d;
};

double step_of(const Rows& rows) {
    std::vector<double> steps;
    for (std::size_t k = 1; k < rows.time_s.size(); ++k) {
        steps.push_back(rows.time_s[k] - rows.time_s[k - 1]);
    }
    return median(std::move(steps));
}

// Columns of a channel in the table of both.
std::vector<ColumnRole> roles_of_both(PhasorFrame frame) {
    const bool own = frame == PhasorFrame::pll;
    return {time_of_log(),
            {"Xc", {"Xc", "Input 1 I", "Input 1 X"}},
            {"Yc", {"Yc", "Input 1 Q", "Input 1 Y"}},
            {"Xd", {"Xd", "Input 2 I", "Input 2 X"}},
            {"Yd", {"Yd", "Input 2 Q", "Input 2 Y"}},
            {"Pc", {"Pc", "Input 1 Phase"}, own},
            {"Pd", {"Pd", "Input 2 Phase"}, own},
            {"F", {"F", "f", "freq", "frequency", "Input 1 Set Frequency"}, false},
            {"P", {"P"}, false}};
}

// Columns of the table of one channel.
std::vector<ColumnRole> roles_of_one(PhasorFrame frame) {
    return {time_of_log(),
            {"X", {"X", "I"}},
            {"Y", {"Y", "Q"}},
            {"P", {"P"}, frame == PhasorFrame::pll},
            {"F", {"F", "f", "freq", "frequency"}, false}};
}

struct NamedColumns {
    std::vector<ColumnWish> wishes;
    LogTable table;

    // Precondition: `role` is among the wishes.
    const LogColumn& of(std::string_view role) const {
        const auto wish = std::ranges::find_if(
            wishes, [role](const ColumnWish& each) { return each.role.name == role; });
        return table.columns[static_cast<std::size_t>(wish - wishes.begin())];
    }
    // nullptr: the file has no such column.
    const LogColumn* find(std::string_view role) const {
        const LogColumn& column = of(role);
        return column.values.empty() ? nullptr : &column;
    }
};

Result<NamedColumns> read_columns(const std::filesystem::path& path, const OpenOptions& options,
                                  const LogChoice& choice, const SignalSettings& signal,
                                  std::vector<ColumnRole> roles, const JobControl& job) {
    NamedColumns columns;
    auto wishes = TRY(column_wishes(choice.names, roles));
    // What is not named may be there by its usual name.
    for (const ColumnRole& role : roles) {
        if (std::ranges::none_of(wishes, [&](const ColumnWish& wish) {
                return wish.role.name == std::string_view(role.name);
            })) {
            wishes.push_back({role, ""});
        }
    }
    columns.wishes = std::move(wishes);
    auto table = TRY(read_log(path, options, columns.wishes, job));
    TRY(keep_times(path, signal.from_s.value_or(TimeRange{}.from_s),
                   signal.to_s.value_or(TimeRange{}.to_s), table));
    columns.table = std::move(table);
    return columns;
}

// One channel: X + iY, turned by its phase.
struct Channel {
    const LogColumn& x;
    const LogColumn& y;
    const LogColumn* phase;  // nullptr: that of the reference
};

Result<std::vector<Complex>> phasors_of(const std::filesystem::path& path, const Channel& channel,
                                        const LogChoice& choice) {
    const PhasorChoice& how = choice.phasors;
    double rad = 0;
    if (channel.phase != nullptr) {
        rad = TRY(angle_factor(path, *channel.phase, choice.rad_per_angle_unit));
    }
    std::vector<Complex> phasors(channel.x.values.size());
    for (std::size_t k = 0; k < phasors.size(); ++k) {
        phasors[k] =
            how.peak_per_unit * Complex(channel.x.values[k], how.y_sign * channel.y.values[k]);
        if (channel.phase != nullptr) {
            phasors[k] *= std::polar(1.0, rad * channel.phase->values[k]);
        }
    }
    return phasors;
}

// What the choice does not tell, or tells otherwise than the file.
Error not_told(const PhasorChoice& choice, const char* what, std::vector<MessageArg> args = {}) {
    return {ErrorCode::setting_invalid,
            "",
            {"--phasors", frame_name(choice.frame), words(what, std::move(args))}};
}

Status check_told(const PhasorChoice& choice) {
    if (choice.y_sign == 0) {
        return not_told(choice, VYBEG_MESSAGE("Words",
                                              "no data show the sign of Y: give --y-sign + "
                                              "or -"));
    }
    if (choice.peak_per_unit == 0) {
        return not_told(choice, VYBEG_MESSAGE("Words",
                                              "no data show whether amplitudes are peak values: "
                                              "give --amplitude peak or rms"));
    }
    return {};
}

// Phase of an oscillator whose frequency moves, relative to its mean, which it returns: integral of
// the cubic through four rows, at the ends of the straight line through two.
Result<double> turn_by_frequency(const PhasorChoice& choice, const LogColumn& frequency,
                                 Rows& rows) {
    const std::vector<double>& f = frequency.values;
    const std::vector<double>& t = rows.time_s;
    const double step_s = step_of(rows);
    const double mean = median(f);
    double turns = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (!std::isfinite(f[k]) || (k > 0 && t[k] - t[k - 1] > 1.5 * step_s)) {
            return not_told(choice,
                            VYBEG_MESSAGE("Words",
                                          "the frequency of the oscillator is missing at %1, so "
                                          "that the phase is lost: cut there with --from or --to, "
                                          "or name a column P"),
                            {number_arg(t[k], 7, "s")});
        }
        if (k > 0) {
            const double straight = (f[k] + f[k - 1]) / 2;
            const double bent =
                k > 1 && k + 1 < t.size() ? (f[k] + f[k - 1] - f[k - 2] - f[k + 1]) / 24 : 0;
            turns += (t[k] - t[k - 1]) * (straight + bent - mean);
        }
        const Complex turn = std::polar(1.0, 2 * pi * turns);
        rows.c[k] *= turn;
        rows.d[k] *= turn;
    }
    return mean;
}

// The reference of the rows, whose phasors it turns where it moves.
Status refer(const LogColumn* frequency, const LogColumn* phase, const std::filesystem::path& path,
             const LogChoice& choice, Rows& rows) {
    const PhasorChoice& how = choice.phasors;
    rows.f_ref_hz = how.f_ref_hz;
    if (how.frame == PhasorFrame::common && frequency == nullptr && phase == nullptr) {
        return not_told(how, VYBEG_MESSAGE("Words",
                                           "it needs the column of the oscillator's frequency or "
                                           "phase: name it F or P in --columns"));
    }
    if (how.frame == PhasorFrame::common && phase != nullptr) {
        const double rad = TRY(angle_factor(path, *phase, choice.rad_per_angle_unit));
        for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
            const Complex turn = std::polar(1.0, rad * phase->values[k]);
            rows.c[k] *= turn;
            rows.d[k] *= turn;
        }
    } else if (frequency != nullptr && how.frame == PhasorFrame::common) {
        const double mean_hz = TRY(turn_by_frequency(how, *frequency, rows));
        rows.f_ref_hz = mean_hz;
    } else if (frequency != nullptr && rows.f_ref_hz == 0) {
        rows.f_ref_hz = median(frequency->values);
    }
    if (!(rows.f_ref_hz > 0)) {
        return not_told(
            how, VYBEG_MESSAGE("Words",
                               "the frequency of the reference is not in the file: give --f-ref"));
    }
    return {};
}

Result<Rows> rows_of_one_table(const std::filesystem::path& path, const OpenOptions& options,
                               const LogChoice& choice, const SignalSettings& signal,
                               const JobControl& job) {
    const bool own = choice.phasors.frame == PhasorFrame::pll;
    const auto columns =
        TRY(read_columns(path, options, choice, signal, roles_of_both(choice.phasors.frame), job));
    Rows rows;
    rows.time_s = columns.table.time_s;
    const auto channel = [&](const char* x, const char* y, const char* phase) {
        return phasors_of(path, {columns.of(x), columns.of(y), own ? columns.find(phase) : nullptr},
                          choice);
    };
    auto c = TRY(channel("Xc", "Yc", "Pc"));
    rows.c = std::move(c);
    auto d = TRY(channel("Xd", "Yd", "Pd"));
    rows.d = std::move(d);
    TRY(refer(columns.find("F"), columns.find("P"), path, choice, rows));
    return rows;
}

Result<Rows> rows_of_two_tables(const std::filesystem::path& path, const OpenOptions& options,
                                const LogChoice& choice, const SignalSettings& signal,
                                const JobControl& job) {
    const bool own = choice.phasors.frame == PhasorFrame::pll;
    const auto roles = roles_of_one(choice.phasors.frame);
    const auto of_c = TRY(read_columns(path, options, choice, signal, roles, job));
    const auto of_d =
        TRY(read_columns(options.channel_d_file, options, choice, signal, roles, job));
    const auto& t = of_c.table.time_s;
    const auto& other = of_d.table.time_s;
    const std::size_t count = std::min(t.size(), other.size());
    Rows rows;
    for (std::size_t k = 0; k < count; ++k) {
        const double step = k > 0 ? t[k] - t[k - 1] : t[std::min(k + 1, count - 1)] - t[k];
        if (std::abs(other[k] - t[k] + of_d.table.begun_s - of_c.table.begun_s) > step / 100) {
            return refused_value("--channel-d", options.channel_d_file,
                                 "its times are not those of channel C: export both demodulators "
                                 "with the same times");
        }
    }
    rows.time_s.assign(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(count));
    const auto channel = [&](const NamedColumns& from, const std::filesystem::path& file) {
        return phasors_of(file, {from.of("X"), from.of("Y"), own ? from.find("P") : nullptr},
                          choice);
    };
    auto c = TRY(channel(of_c, path));
    rows.c = std::move(c);
    auto d = TRY(channel(of_d, options.channel_d_file));
    rows.d = std::move(d);
    rows.c.resize(count);
    rows.d.resize(count);
    TRY(refer(of_c.find("F"), of_c.find("P"), path, choice, rows));
    return rows;
}

void drop_missing(Rows& rows) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
        if (std::isfinite(std::abs(rows.c[k]) + std::abs(rows.d[k]) + rows.time_s[k])) {
            rows.time_s[kept] = rows.time_s[k];
            rows.c[kept] = rows.c[k];
            rows.d[kept] = rows.d[k];
            ++kept;
        }
    }
    rows.time_s.resize(kept);
    rows.c.resize(kept);
    rows.d.resize(kept);
}

// Brings the reference to the mean frequency: a mean over rows that turn is smaller than they are.
void centre(double step_s, Rows& rows) {
    Complex sum = 0;
    for (std::size_t k = 1; k < rows.time_s.size(); ++k) {
        sum += rows.c[k] * std::conj(rows.c[k - 1]) + rows.d[k] * std::conj(rows.d[k - 1]);
    }
    const double offset_hz = std::arg(sum) / (2 * pi * step_s);
    for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
        const Complex turn = std::polar(1.0, -2 * pi * offset_hz * rows.time_s[k]);
        rows.c[k] *= turn;
        rows.d[k] *= turn;
    }
    rows.f_ref_hz += offset_hz;
}

// What the calibration says of D and of the electrodes' angle (calibration.h, without offsets).
void calibrate(const Calibration& calibration, Rows& rows) {
    const Complex gain =
        std::polar(calibration.kappa, 2 * pi * rows.f_ref_hz * calibration.delay_d_s);
    for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
        rows.d[k] *= gain;
        turn_channels(calibration.two_theta_zero(), rows.c[k], rows.d[k]);
    }
}

// Means of `count` rows that follow each other without a gap.
PhasorRun windows_of_rows(const Rows& rows, std::size_t count, double step_s) {
    PhasorRun run;
    run.f_ref_hz = rows.f_ref_hz;
    run.rate_hz = 1 / step_s;
    run.window_s = static_cast<double>(count) * step_s;
    for (std::size_t from = 0; from + count <= rows.time_s.size();) {
        std::size_t last = from;
        while (last + 1 < from + count &&
               rows.time_s[last + 1] - rows.time_s[last] < 1.5 * step_s) {
            ++last;
        }
        if (last + 1 == from + count) {
            Complex c = 0;
            Complex d = 0;
            for (std::size_t k = from; k <= last; ++k) {
                c += rows.c[k];
                d += rows.d[k];
            }
            run.time_s.push_back((rows.time_s[from] + rows.time_s[last]) / 2);
            run.c.push_back(c / static_cast<double>(count));
            run.d.push_back(d / static_cast<double>(count));
        }
        from = last + 1;
    }
    return run;
}

// Correlation of the noise of windows of `count` rows, and the variance of one relative to that of
// a row.
std::pair<std::vector<double>, double> correlation_of(const LockIn& filter, std::size_t count,
                                                      double step_s) {
    constexpr std::size_t most_lags = 64;
    std::vector<double> sums;
    const auto n = static_cast<std::ptrdiff_t>(count);
    for (std::size_t lag = 0; lag < most_lags; ++lag) {
        double sum = 0;
        for (std::ptrdiff_t i = 1 - n; i < n; ++i) {
            const auto rows = static_cast<double>(static_cast<std::ptrdiff_t>(lag) * n + i);
            sum += static_cast<double>(n - std::abs(i)) * filter.correlation(rows * step_s);
        }
        if (lag > 0 && std::abs(sum) < least_correlation * sums.front()) {
            break;
        }
        sums.push_back(sum);
    }
    const double first = sums.front();
    for (double& sum : sums) {
        sum /= first;
    }
    return {sums, first / static_cast<double>(n * n)};
}

// Sd of the noise of a window's real or imaginary part: what the linear recurrence of the motion
// leaves in stretches of windows.
double noise_of(const PhasorRun& run, double neighbours) {
    constexpr Eigen::Index stretch = 40;
    std::vector<double> variances;
    const auto size = static_cast<Eigen::Index>(run.c.size());
    for (Eigen::Index from = 0; from + 8 <= size; from += stretch) {
        const Eigen::Index steps = std::min(stretch, size - from - 1);
        if (steps < 7) {
            break;
        }
        Eigen::MatrixX2cd before(steps, 2);
        Eigen::MatrixX2cd after(steps, 2);
        for (Eigen::Index k = 0; k < steps; ++k) {
            const auto at = static_cast<std::size_t>(from + k);
            before.row(k) << run.c[at], run.d[at];
            after.row(k) << run.c[at + 1], run.d[at + 1];
        }
        const Eigen::Matrix2cd a = before.colPivHouseholderQr().solve(after);
        const double rest = (after - before * a).squaredNorm();
        const double each = rest / static_cast<double>(4 * (steps - 2));
        const double grows = 1 + a.squaredNorm() / 2 - neighbours * a.trace().real();
        variances.push_back(each / grows);
    }
    return variances.empty() ? 0 : std::sqrt(median(std::move(variances)));
}

}  // namespace

const char* frame_name(PhasorFrame frame) {
    constexpr std::array names{"", "fixed", "common", "pll"};
    return names[static_cast<std::size_t>(frame)];
}

Result<PhasorLog> read_phasor_log(const std::filesystem::path& path, const OpenOptions& options,
                                  const LogChoice& choice, const SignalSettings& signal,
                                  const JobControl& job) {
    TRY(check_told(choice.phasors));
    auto rows = TRY(options.channel_d_file.empty()
                        ? rows_of_one_table(path, options, choice, signal, job)
                        : rows_of_two_tables(path, options, choice, signal, job));
    drop_missing(rows);
    if (rows.time_s.size() < 2) {
        return Error{ErrorCode::no_valid_samples, path.string(), {}};
    }
    const LockIn& filter = choice.phasors.filter;
    const double step_s = step_of(rows);
    const double told_hz = rows.f_ref_hz;
    for (double& t : rows.time_s) {
        t -= filter.delay_s();
    }
    centre(step_s, rows);
    if (choice.phasors.frame == PhasorFrame::fixed) {
        const Complex response = filter.response(rows.f_ref_hz - told_hz);
        for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
            rows.c[k] /= response;
            rows.d[k] /= response;
        }
    }
    calibrate(signal.calibration, rows);
    const double window_s = std::max(usual_window_s, settled * filter.delay_s());
    const auto count =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(window_s / step_s)), 1,
                                std::max<std::size_t>(rows.time_s.size() / least_windows, 1));
    PhasorLog log;
    log.rows = static_cast<std::int64_t>(rows.time_s.size());
    log.rows_per_window = static_cast<std::int64_t>(count);
    log.run = windows_of_rows(rows, count, step_s);
    log.run.two_theta_zero = signal.calibration.two_theta_zero();
    auto [correlation, share] = correlation_of(filter, count, step_s);
    const double neighbours = correlation.size() > 1 ? correlation[1] : 0;
    const double sd = noise_of(log.run, neighbours);
    // Digits of a file without noise.
    constexpr double least = 1e-15;
    double size = 0;
    for (std::size_t k = 0; k < log.run.c.size(); ++k) {
        size = std::max(size, std::hypot(std::abs(log.run.c[k]), std::abs(log.run.d[k])));
    }
    log.run.sd.assign(log.run.c.size(), std::max(sd, least * size));
    log.noise_sd = log.run.sd.empty() ? 0 : log.run.sd.front() / std::sqrt(share);
    if (correlation.size() > 1) {
        log.run.noise_correlation = std::move(correlation);
    }
    return log;
}

}  // namespace vybeg
