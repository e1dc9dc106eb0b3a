#include "core/analysis/frame_check.h"
#include "core/analysis/logs.h"
#include "core/base/read_value.h"
#include "core/numerics/lock_in.h"
#include "core/numerics/statistics.h"
#include "core/recording/open/log_columns.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/vocabulary.h"
#include "core/recording/times/uniform_times.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double usual_window_s = 0.015;
constexpr double settled = 3;  // delays of the filter, after which its noise is nearly new
constexpr std::size_t least_windows = 100;

// Rows relative to f_ref_hz.
struct LogRows {
    double f_ref_hz = 0;
    std::vector<double> time_s;
    std::vector<Complex> c;
    std::vector<Complex> d;
    std::vector<Complex> turn;  // by the oscillator's phase, which they have taken; empty: none
    std::vector<Diagnostic> warnings;
};

// Multiplies the phasors of row k by factor(k).
template <class Factor>
void turn_rows(LogRows& rows, const Factor& factor) {
    for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
        const Complex turn = factor(k);
        rows.c[k] *= turn;
        rows.d[k] *= turn;
    }
}

double step_of(const LogRows& rows) {
    std::vector<double> steps;
    for (std::size_t k = 1; k < rows.time_s.size(); ++k) {
        steps.push_back(rows.time_s[k] - rows.time_s[k - 1]);
    }
    return median(std::move(steps));
}

Result<LogTable> read_columns(const LogFile& file, const std::vector<ColumnRole>& roles) {
    const auto wishes = TRY(column_wishes(file.choice.names, roles));
    auto table = TRY(read_log_columns(file, wishes));
    for (LogColumn& column : table.columns) {
        const double hz = column.role.starts_with('F') ? hertz_per(column.unit).value_or(1) : 1;
        std::ranges::for_each(column.values, [hz](double& value) { value *= hz; });
    }
    return table;
}

// What the choice leaves open, or sets against the file.
Error wrong_choice(const PhasorChoice& choice, MessageArg why) {
    return refused_value("--phasors", frame_name(choice.frame), std::move(why));
}

// Whether a frequency is about that of the carrier, as an oscillator's is.
bool is_near(double hz, double carrier_hz) {
    return carrier_hz > 0 && std::abs(hz / carrier_hz - 1) < 0.05;
}

// One channel: X + iY, in the frame of each channel's own phase turned by that.
struct Channel {
    const LogFile& file;
    const LogColumn& x;
    const LogColumn& y;
    const LogColumn* phase;  // null: there is none
};

// Whether its phase, which is there, is that of X + iY itself: one that a loop follows leaves none
// there.
bool repeats_phase(const Channel& channel, double rad) {
    constexpr double alike = 0.01;
    const std::vector<double>& phase = channel.phase->values;
    std::size_t own = 0;
    std::size_t turned = 0;
    for (std::size_t k = 0; k < phase.size(); ++k) {
        const double of_x_y = std::atan2(channel.y.values[k], channel.x.values[k]);
        own += std::abs(std::remainder(rad * phase[k] - of_x_y, 2 * pi)) < alike ? 1U : 0U;
        turned += std::abs(of_x_y) > alike ? 1U : 0U;
    }
    return 10 * own > 9 * phase.size() && 2 * turned > phase.size();
}

// What the phase holds of the carrier, Hz (carrier_in()). Errors: those of angle_factor();
// setting_invalid where it is that of the reference as well.
Result<double> carrier_of(const LogFile& file, const LogColumn& phase,
                          const std::vector<double>& time_s) {
    const double rad = TRY(rad_per_unit(file, phase));
    const double carrier_hz = carrier_in(rad, phase, time_s);
    if (is_near(carrier_hz, file.choice.phasors.f_ref_hz)) {
        return wrong_choice(
            file.choice.phasors,
            Phrase::tr("the phase in column %1 goes on by the whole carrier, %2: it is relative to "
                       "no reference; leave --f-ref out",
                       {phase.name, number_arg(carrier_hz, 10, "Hz")}));
    }
    return carrier_hz;
}

// e^{i phase} of a row, without what the phase holds of the carrier.
Complex turn_by(double rad, const LogColumn& phase, std::size_t k, double carrier_hz,
                const std::vector<double>& time_s) {
    const double turns = rad * phase.values[k] / (2 * pi) - carrier_hz * time_s[k];
    return std::polar(1.0, 2 * pi * std::remainder(turns, 1.0));
}

// At `time_s`; `carrier_hz` is taken out of the channel's own phase.
Result<std::vector<Complex>> phasors_of(const Channel& channel, const std::vector<double>& time_s,
                                        double carrier_hz) {
    const PhasorChoice& how = channel.file.choice.phasors;
    std::vector<Complex> phasors(channel.x.values.size());
    for (std::size_t k = 0; k < phasors.size(); ++k) {
        phasors[k] =
            how.peak_per_unit * Complex(channel.x.values[k], how.y_sign * channel.y.values[k]);
    }
    if (how.frame != PhasorFrame::pll || channel.phase == nullptr) {
        return phasors;
    }
    const double rad = TRY(rad_per_unit(channel.file, *channel.phase));
    if (repeats_phase(channel, rad)) {
        return wrong_choice(
            how, Phrase::tr("column %1 is the phase of X + iY itself: choose --phasors fixed",
                            {channel.phase->name}));
    }
    for (std::size_t k = 0; k < phasors.size(); ++k) {
        phasors[k] *= turn_by(rad, *channel.phase, k, carrier_hz, time_s);
    }
    return phasors;
}

// A phase beside the phasors that moves, and that the declared frame leaves aside.
Status check_left_aside(const Channel& channel, PhasorFrame of_phase) {
    constexpr double harmless_rad = 0.01 * 2 * pi;
    if (channel.phase == nullptr) {
        return {};
    }
    const auto rad = rad_per_unit(channel.file, *channel.phase);
    const auto [least, most] = range_of(*channel.phase);
    if (!rad || !(*rad * (most - least) > harmless_rad) || repeats_phase(channel, *rad)) {
        return {};
    }
    return wrong_choice(
        channel.file.choice.phasors,
        Phrase::tr(
            "the phase in column %1 moves, so that this is not the frame: choose --phasors %2",
            {channel.phase->name, frame_name(of_phase)}));
}

Status check_told(const PhasorChoice& choice) {
    if (choice.y_sign == 0) {
        return wrong_choice(choice, Phrase::tr("no data show the sign of Y: give --y-sign + or -"));
    }
    if (choice.peak_per_unit == 0) {
        return wrong_choice(
            choice,
            Phrase::tr(
                "no data show whether amplitudes are peak values: give --amplitude peak or rms"));
    }
    return {};
}

// Adds the turn of an oscillator whose frequency moves, relative to its mean, which it returns:
// integral of the cubic through four rows, at the ends of the straight line through two.
Result<double> turn_of_frequency(const PhasorChoice& choice, const LogColumn& frequency,
                                 LogRows& rows) {
    const std::vector<double>& f = frequency.values;
    const std::vector<double>& t = rows.time_s;
    const double step_s = step_of(rows);
    const double mean = median(f);
    double turns = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (!std::isfinite(f[k]) || (k > 0 && t[k] - t[k - 1] > 1.5 * step_s)) {
            return wrong_choice(
                choice,
                Phrase::tr("the frequency of the oscillator is missing at %1, so that the phase is "
                           "lost: cut there with --from or --to, or name a column P",
                           {number_arg(t[k], 7, "s")}));
        }
        if (k > 0) {
            const double straight = (f[k] + f[k - 1]) / 2;
            const double bent =
                k > 1 && k + 1 < t.size() ? (f[k] + f[k - 1] - f[k - 2] - f[k + 1]) / 24 : 0;
            turns += (t[k] - t[k - 1]) * (straight + bent - mean);
        }
        rows.turn.push_back(std::polar(1.0, 2 * pi * turns));
    }
    return mean;
}

// The frequency to which a phase column is relative, where the log also has the oscillator's own:
// its mean less the rate of the phase; of a phase that is wrapped by the smallest step from row to
// row.
double frequency_behind(double rad, const LogColumn& phase, const LogColumn& frequency,
                        const LogRows& rows) {
    std::vector<double> rates;
    rates.reserve(rows.time_s.size());
    for (std::size_t k = 1; k < rows.time_s.size(); ++k) {
        const double turned = std::remainder(rad * (phase.values[k] - phase.values[k - 1]), 2 * pi);
        const double of_phase = turned / (2 * pi * (rows.time_s[k] - rows.time_s[k - 1]));
        const double rate = (frequency.values[k] + frequency.values[k - 1]) / 2 - of_phase;
        if (std::isfinite(rate)) {
            rates.push_back(rate);
        }
    }
    return median(std::move(rates));
}

// Whether two frequencies differ by more than rounding to five digits.
bool is_another(double hz, double other_hz) {
    constexpr double five_digits = 5e-5;
    return std::abs(hz - other_hz) > five_digits * other_hz;
}

Error another_reference(const PhasorChoice& how, const LogColumn& frequency) {
    return wrong_choice(
        how, Phrase::tr("column %1 says that the reference is %2, and --f-ref that it is %3: leave "
                        "--f-ref out, or correct it",
                        {frequency.name, number_arg(median(frequency.values), 10, "Hz"),
                         number_arg(how.f_ref_hz, 10, "Hz")}));
}

// Refuses channels with different references: the phase between them is unknown.
Status check_references(const PhasorChoice& how, const LogColumn* of_c, const LogColumn* of_d) {
    if (how.frame == PhasorFrame::common || of_c == nullptr || of_d == nullptr ||
        !is_another(median(of_d->values), median(of_c->values))) {
        return {};
    }
    return wrong_choice(
        how, Phrase::tr("the reference of channel D is %1, that of channel C %2: record both with "
                        "one oscillator",
                        {number_arg(median(of_d->values), 10, "Hz"),
                         number_arg(median(of_c->values), 10, "Hz")}));
}

// The reference of the rows, whose phasors it turns where it moves; `carrier_hz` is what their own
// phases held of the carrier.
Status refer(const LogFile& file, const LogColumn* frequency, const LogColumn* phase,
             double carrier_hz, LogRows& rows) {
    const PhasorChoice& how = file.choice.phasors;
    rows.f_ref_hz = how.f_ref_hz;
    if (how.frame != PhasorFrame::common && frequency != nullptr) {
        const auto [least, most] = range_of(*frequency);
        constexpr double harmless_turns = 0.01;
        const bool moves =
            (most - least) * (rows.time_s.back() - rows.time_s.front()) > harmless_turns;
        if (moves && how.frame == PhasorFrame::fixed) {
            return wrong_choice(
                how, Phrase::tr("the oscillator's frequency moves from %1 to %2 (column %3), so "
                                "that the reference is not fixed: choose --phasors common",
                                {number_arg(least, 10, "Hz"), number_arg(most, 10, "Hz"),
                                 frequency->name}));
        }
        if (!moves && how.f_ref_hz > 0 && is_another(median(frequency->values), how.f_ref_hz)) {
            return another_reference(how, *frequency);
        }
    }
    if (how.frame == PhasorFrame::common && frequency == nullptr && phase == nullptr) {
        return wrong_choice(how, Phrase::tr("it needs the column of the oscillator's frequency or "
                                            "phase: name it F or P in --columns"));
    }
    if (how.frame == PhasorFrame::common && phase != nullptr) {
        const double rad = TRY(rad_per_unit(file, *phase));
        carrier_hz = TRY(carrier_of(file, *phase, rows.time_s));
        for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
            rows.turn.push_back(turn_by(rad, *phase, k, carrier_hz, rows.time_s));
        }
        if (frequency != nullptr && rows.f_ref_hz == 0) {
            const double mean_hz = median(frequency->values);
            rows.f_ref_hz = carrier_hz == 0 ? frequency_behind(rad, *phase, *frequency, rows)
                            : is_near(carrier_hz, mean_hz) ? 0
                                                           : mean_hz - carrier_hz;
        }
    } else if (frequency != nullptr && how.frame == PhasorFrame::common) {
        const double mean_hz = TRY(turn_of_frequency(how, *frequency, rows));
        const bool deviates = holds_deviations(*frequency, how.f_ref_hz);
        if (deviates && how.f_ref_hz == 0) {
            return wrong_choice(how, Phrase::tr("column %1 holds deviations of a frequency: give "
                                                "the frequency by --f-ref",
                                                {frequency->name}));
        }
        if (!deviates && how.f_ref_hz > 0 && !is_near(mean_hz, how.f_ref_hz)) {
            return another_reference(how, *frequency);
        }
        rows.f_ref_hz = mean_hz + (deviates ? how.f_ref_hz : 0);
    } else if (frequency != nullptr && rows.f_ref_hz == 0) {
        const double mean_hz = median(frequency->values);
        rows.f_ref_hz = is_near(carrier_hz, mean_hz) ? 0 : mean_hz;
    }
    if (!rows.turn.empty()) {
        turn_rows(rows, [&](std::size_t k) { return rows.turn[k]; });
    }
    rows.f_ref_hz += carrier_hz;
    if (!(rows.f_ref_hz > 0)) {
        return wrong_choice(
            how, Phrase::tr("the frequency of the reference is not in the file: give --f-ref"));
    }
    return {};
}

// One table holds both channels, or each has its own.
Result<LogRows> read_rows(const LogFile& file) {
    const PhasorFrame frame = file.choice.phasors.frame;
    const std::filesystem::path d_file = file.options.channel_d_file;
    const bool apart = !d_file.empty();
    std::error_code unknown;
    if (apart && std::filesystem::equivalent(file.path, d_file, unknown)) {
        return refused_value("--channel-d", d_file.string(),
                             Phrase::tr("it is the channel that is read as C"));
    }
    const LogFile file_of_d{apart ? d_file : file.path, file.options, file.choice, file.signal,
                            file.job};
    const auto roles = apart ? roles_of_one(frame) : roles_of_both(frame);
    auto of_c = TRY(read_columns(file, roles));
    auto second = TRY(apart ? read_columns(file_of_d, roles) : Result(LogTable{}));
    LogTable& of_d = apart ? second : of_c;
    const auto column = [apart](LogTable& table, const char* alone,
                                const char* beside) -> LogColumn& {
        return table.of(apart ? alone : beside);
    };
    LogColumn& x_c = column(of_c, "X", "Xc");
    LogColumn& y_c = column(of_c, "Y", "Yc");
    LogColumn& x_d = column(of_d, "X", "Xd");
    LogColumn& y_d = column(of_d, "Y", "Yd");
    for (LogColumn* const other : {&y_c, &x_d, &y_d}) {
        bring_to_unit_of(x_c, *other);
    }
    const Channel c{file, x_c, y_c, of_c.find(apart ? "P" : "Pc")};
    const Channel d{file_of_d, x_d, y_d, of_d.find(apart ? "P" : "Pd")};
    const auto& t = of_c.time_s;
    const auto& t_of_d = of_d.time_s;
    const std::size_t count = std::min(t.size(), t_of_d.size());
    for (std::size_t k = 0; apart && k < count; ++k) {
        const double step = k > 0 ? t[k] - t[k - 1] : t[std::min(k + 1, count - 1)] - t[k];
        if (std::abs(t_of_d[k] - t[k] + of_d.begun_s - of_c.begun_s) > step / 100) {
            return refused_value("--channel-d", d_file.string(),
                                 "its times are not those of channel C: export both demodulators "
                                 "with the same times");
        }
    }
    if (!apart && frame != PhasorFrame::pll) {
        TRY(check_left_aside(c, PhasorFrame::pll));
        TRY(check_left_aside(d, PhasorFrame::pll));
    }
    if (!apart && frame == PhasorFrame::fixed) {
        TRY(check_left_aside({file, x_c, y_c, of_c.find("P")}, PhasorFrame::common));
    }
    LogRows rows;
    rows.time_s.assign(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(count));
    const double carrier_hz =
        TRY(frame == PhasorFrame::pll && c.phase != nullptr ? carrier_of(file, *c.phase, t)
                                                            : Result<double>(0));
    rows.c = TRY(phasors_of(c, t, carrier_hz));
    std::vector<double> by_times_of_c = t_of_d;
    for (double& time_s : by_times_of_c) {
        time_s += of_d.begun_s - of_c.begun_s;
    }
    rows.d = TRY(phasors_of(d, by_times_of_c, carrier_hz));
    rows.c.resize(count);
    rows.d.resize(count);
    if (t.size() != t_of_d.size()) {
        // After the name of the log, the first argument of every warning about it.
        rows.warnings.push_back(
            {DiagnosticKind::channels_unequal,
             {count_arg(static_cast<std::int64_t>(t.size())), d_file.filename().string(),
              count_arg(static_cast<std::int64_t>(t_of_d.size()))}});
    }
    TRY(check_references(file.choice.phasors, of_c.find("F"), of_d.find(apart ? "F" : "Fd")));
    TRY(refer(file, of_c.find("F"), of_c.find("P"), carrier_hz, rows));
    return rows;
}

void drop_missing(LogRows& rows) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
        if (std::isfinite(std::abs(rows.c[k]) + std::abs(rows.d[k]) + rows.time_s[k])) {
            rows.time_s[kept] = rows.time_s[k];
            rows.c[kept] = rows.c[k];
            rows.d[kept] = rows.d[k];
            if (!rows.turn.empty()) {
                rows.turn[kept] = rows.turn[k];
            }
            ++kept;
        }
    }
    rows.time_s.resize(kept);
    rows.c.resize(kept);
    rows.d.resize(kept);
}

// Brings the reference to the mean frequency: a mean over rows that turn is smaller than they are.
void centre(double step_s, LogRows& rows) {
    Complex sum = 0;
    for (std::size_t k = 1; k < rows.time_s.size(); ++k) {
        sum += rows.c[k] * std::conj(rows.c[k - 1]) + rows.d[k] * std::conj(rows.d[k - 1]);
    }
    const double offset_hz = std::arg(sum) / (2 * pi * step_s);
    turn_rows(rows,
              [&](std::size_t k) { return std::polar(1.0, -2 * pi * offset_hz * rows.time_s[k]); });
    rows.f_ref_hz += offset_hz;
}

// What the calibration says of D and of the electrodes' angle (Calibration, without offsets).
void calibrate(const Calibration& calibration, LogRows& rows) {
    const Complex gain =
        std::polar(calibration.kappa, 2 * pi * rows.f_ref_hz * calibration.delay_d_s);
    for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
        rows.d[k] *= gain;
        turn_channels(calibration.two_theta_zero(), rows.c[k], rows.d[k]);
    }
}

// Means of `count` rows that follow each other without a gap.
PhasorRun windows_of_rows(const LogRows& rows, std::size_t count, double step_s) {
    PhasorRun run;
    run.f_ref_hz = rows.f_ref_hz;
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

}  // namespace

double carrier_in(double rad, const LogColumn& phase, const std::vector<double>& time_s) {
    std::vector<double> rates;
    std::size_t fast = 0;
    for (std::size_t k = 1; k < time_s.size(); ++k) {
        const double turns = rad * (phase.values[k] - phase.values[k - 1]) / (2 * pi);
        if (std::isfinite(turns)) {
            rates.push_back(turns / (time_s[k] - time_s[k - 1]));
            fast += std::abs(turns) > 0.5 ? 1U : 0U;
        }
    }
    return 10 * fast > 9 * rates.size() ? median(std::move(rates)) : 0;
}

bool holds_deviations(const LogColumn& frequency, double f_ref_hz) {
    constexpr double least_hz = 10;  // of a resonator
    constexpr double small = 0.05;
    const double mean_hz = std::abs(median(frequency.values));
    return f_ref_hz > 0 ? mean_hz < small * f_ref_hz
                        : mean_hz < least_hz || range_of(frequency).first <= 0;
}

std::vector<ColumnRole> roles_of_both(PhasorFrame frame) {
    const bool own = frame == PhasorFrame::pll;
    return {time_of_log(),
            {"Xc", {"Xc", "Input 1 I", "Input 1 X", "demods/0/sample/x", "demods(1).sample.x"}},
            {"Yc", {"Yc", "Input 1 Q", "Input 1 Y", "demods/0/sample/y", "demods(1).sample.y"}},
            {"Xd", {"Xd", "Input 2 I", "Input 2 X", "demods/1/sample/x", "demods(2).sample.x"}},
            {"Yd", {"Yd", "Input 2 Q", "Input 2 Y", "demods/1/sample/y", "demods(2).sample.y"}},
            {"Pc", {"Pc", "Input 1 Phase"}, own},
            {"Pd", {"Pd", "Input 2 Phase"}, own},
            {"F", {"F", "f", "freq", "frequency", "Input 1 Set Frequency"}, false},
            {"P", {"P"}, false},
            {"Fd", {"Input 2 Set Frequency"}, false}};
}

std::vector<ColumnRole> roles_of_one(PhasorFrame frame) {
    return {time_of_log(),
            {"X", {"X", "I"}},
            {"Y", {"Y", "Q"}},
            {"P", {"P"}, frame == PhasorFrame::pll},
            {"F", {"F", "f", "freq", "frequency"}, false}};
}

Result<PhasorLog> read_phasor_log(const LogFile& file) {
    const PhasorChoice& how = file.choice.phasors;
    TRY(check_told(how));
    auto rows = TRY(read_rows(file));
    drop_missing(rows);
    constexpr std::size_t least_rows = 8;
    if (rows.time_s.size() < least_rows) {
        return Error{ErrorCode::too_few_frames,
                     file.path.string(),
                     {count_arg(static_cast<std::int64_t>(rows.time_s.size())),
                      count_arg(static_cast<std::int64_t>(least_rows))}};
    }
    const LockIn& filter = how.filter;
    const double step_s = step_of(rows);
    constexpr double always = 1e5;  // rows
    const double reach = (rows.time_s.back() - rows.time_s.front()) / step_s;
    if (!is_plausible_grid(reach, static_cast<double>(rows.time_s.size()), always)) {
        return Error{ErrorCode::format_limit,
                     file.path.string(),
                     {"table",
                      Phrase::tr("its %1 times reach over %2 sample periods",
                                 {count_arg(std::ssize(rows.time_s)), number_arg(reach)}),
                      Phrase::tr("Cut the recording where its clock jumps")}};
    }
    const double told_hz = rows.f_ref_hz;
    for (double& t : rows.time_s) {
        t -= filter.delay_s();
    }
    const auto rows_in = [&](double window_s) {
        return std::clamp<std::size_t>(
            static_cast<std::size_t>(std::lround(window_s / step_s)), 1,
            std::max<std::size_t>(rows.time_s.size() / least_windows, 1));
    };
    // The noise shows where that of neighbours is not the same.
    const std::size_t apart = rows_in(std::max(usual_window_s, settled * filter.delay_s()));
    PhasorLog log;
    log.warnings = std::move(rows.warnings);
    const auto warn = [&log](std::optional<Diagnostic> warning) {
        if (warning) {
            log.warnings.push_back(std::move(*warning));
        }
    };
    warn(mirrored_channel(rows.c, rows.d, step_s));
    warn(backward_oscillator(rows.c, rows.d, rows.turn));
    if (how.frame != PhasorFrame::pll) {
        const PhasorRun as_referred = windows_of_rows(rows, apart, step_s);
        warn(followed_channel(as_referred.c, as_referred.d));
    }
    centre(step_s, rows);
    if (how.frame == PhasorFrame::fixed) {
        for (std::vector<Complex>* const channel : {&rows.c, &rows.d}) {
            filter.take_out(rows.f_ref_hz - told_hz, step_s, rows.time_s, *channel);
        }
    }
    remove_image(rows.f_ref_hz, rows.time_s, rows.c, rows.d);
    calibrate(file.signal.calibration, rows);
    const PhasorRun settled_run = windows_of_rows(rows, apart, step_s);
    const auto [settled_correlation, settled_share] = filter.noise_of_means(apart, step_s);
    const double neighbours = settled_correlation.size() > 1 ? settled_correlation[1] : 0;
    const std::optional<double> sd_of_settled = noise_beside_wave(settled_run, neighbours);
    if (!sd_of_settled) {
        return Error{ErrorCode::fit_failed,
                     file.path.string(),
                     {Phrase::tr("no wave stands out of the noise; choose the seconds of the "
                                 "decay, or other columns")}};
    }
    // Means over more than the filter's own would lose a fast beat.
    const std::size_t count = rows_in(std::max(usual_window_s, filter.delay_s() / 10));
    log.rows = static_cast<std::int64_t>(rows.time_s.size());
    log.rate_hz = 1 / step_s;
    log.rows_per_window = static_cast<std::int64_t>(count);
    log.run = windows_of_rows(rows, count, step_s);
    log.run.two_theta_zero = file.signal.calibration.two_theta_zero();
    auto [correlation, share] = filter.noise_of_means(count, step_s);
    const double sd = *sd_of_settled * std::sqrt(share / settled_share);
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
