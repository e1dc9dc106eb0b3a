#include "core/analysis/logs.h"
#include "core/base/read_value.h"

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

// Refuses columns whose largest is another one than `role`, whose values `largest` are.
Status check_largest(const LogChoice& choice, const char* role, const std::vector<double>& largest,
                     const char* other, const std::vector<double>& values) {
    constexpr double margin = 1.1;  // both may be the same but for the noise
    std::size_t smaller = 0;
    std::size_t rows = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (std::isfinite(largest[k] + values[k])) {
            ++rows;
            smaller += std::abs(values[k]) > margin * largest[k] ? 1 : 0;
        }
    }
    if (2 * smaller <= rows) {
        return {};
    }
    return refused_value("--columns", choice.names,
                         Phrase::tr("%1 is smaller than %2 in %3 rows of %4, which it cannot be: "
                                    "the columns are exchanged or have unlike units",
                                    {role, other, count_arg(static_cast<std::int64_t>(smaller)),
                                     count_arg(static_cast<std::int64_t>(rows))}));
}

// What the calibration says of D and of the electrodes' angle: (E + R)/2 and (E - R)/2 are |c|^2
// and |d|^2, (S + iQ)/2 is c d*, and R + iS turns by 4 theta.
Status calibrate(const SignalSettings& signal, PowerRun& run) {
    using Complex = std::complex<double>;
    constexpr double pi = std::numbers::pi;
    const Calibration& told = signal.calibration;
    if (told.delay_d_s != 0 && !signal.f0_hz) {
        return refused_delay("--delay", told.delay_d_s);
    }
    const Complex gain =
        std::polar(told.kappa, -2 * pi * signal.f0_hz.value_or(0) * told.delay_d_s);
    run.two_theta_zero = told.two_theta_zero();
    const Complex turn = std::polar(1.0, -2 * run.two_theta_zero);
    for (std::size_t k = 0; k < run.e.size(); ++k) {
        const double of_c = (run.e[k] + run.r[k]) / 2;
        const double of_d = std::norm(gain) * (run.e[k] - run.r[k]) / 2;
        const Complex both = gain * Complex(run.s[k], run.q[k]);
        const Complex turned = turn * Complex(of_c - of_d, both.real());
        run.e[k] = of_c + of_d;
        run.r[k] = turned.real();
        run.s[k] = turned.imag();
        run.q[k] = both.imag();
    }
    return {};
}

}  // namespace

const std::vector<ColumnRole>& roles_of_powers() {
    static const std::vector<ColumnRole> roles{
        time_of_log(), {"E", {"E"}}, {"R", {"R"}}, {"S", {"S"}}, {"Q", {"Q"}}};
    return roles;
}

const std::vector<ColumnRole>& roles_of_waves() {
    static const std::vector<ColumnRole> roles{
        time_of_log(),
        {"a", {"a", "a_A"}},
        {"b", {"b", "a_B"}},
        {"theta",
         {"theta", "theta_rad", "theta_deg", "theta_A", "theta_A_rad", "two_theta_A_rad"}}};
    return roles;
}

Result<LogTable> read_log_columns(const LogFile& file, const std::vector<ColumnWish>& wishes) {
    auto table = TRY(read_log(file.path, file.options, wishes, file.job));
    TRY(keep_times(file.path, file.signal.from_s.value_or(TimeRange{}.from_s),
                   file.signal.to_s.value_or(TimeRange{}.to_s), table));
    return table;
}

Result<PowerRun> read_power_log(const LogFile& file) {
    const LogChoice& columns = file.choice;
    const auto waves = column_wishes(columns.names, roles_of_waves());
    const auto wishes = TRY(waves ? waves : column_wishes(columns.names, roles_of_powers()));
    auto table = TRY(read_log_columns(file, wishes));
    PowerRun run;
    if (waves) {
        LogColumn& theta = table.of("theta");
        const auto factor = TRY(rad_per_unit(file, theta));
        for (double& value : theta.values) {
            value *= factor;
        }
        bring_to_unit_of(table.of("a"), table.of("b"));
        TRY(check_largest(columns, "a", table.of("a").values, "b", table.of("b").values));
        run = powers_of_waves(std::move(table.time_s), table.of("a").values, table.of("b").values,
                              theta.values);
    } else {
        for (const char* const other : {"R", "S", "Q"}) {
            TRY(check_largest(columns, "E", table.of("E").values, other, table.of(other).values));
        }
        run.e = std::move(table.of("E").values);
        run.r = std::move(table.of("R").values);
        run.s = std::move(table.of("S").values);
        run.q = std::move(table.of("Q").values);
        run.time_s = std::move(table.time_s);
    }
    TRY(calibrate(file.signal, run));
    return run;
}

Error refused_delay(const char* option, double delay_s) {
    return refused_value(option, number_arg(delay_s, 3, "s"),
                         Phrase::tr("a log without a phase has no frequency, and a delay is a "
                                    "phase at one: give the carrier f0, too"));
}

}  // namespace vybeg
