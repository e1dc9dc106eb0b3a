#include "core/analysis/power_log.h"

#include "core/base/messages.h"
#include "core/recording/open/log_columns.h"

#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

const std::vector<ColumnRole>& roles_of_powers() {
    static const std::vector<ColumnRole> roles{
        time_of_log(), {"E", {"E"}}, {"R", {"R"}}, {"S", {"S"}}, {"Q", {"Q"}}};
    return roles;
}

// Those of a track, too.
const std::vector<ColumnRole>& roles_of_waves() {
    static const std::vector<ColumnRole> roles{
        time_of_log(),
        {"a", {"a", "a_A"}},
        {"b", {"b", "a_B"}},
        {"theta",
         {"theta", "theta_rad", "theta_deg", "theta_A", "theta_A_rad", "two_theta_A_rad"}}};
    return roles;
}

// Column of a role among the wishes; null: not among them.
LogColumn* column_of(const std::vector<ColumnWish>& wishes, LogTable& table,
                     const std::string& role) {
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        if (wishes[k].role.name == role) {
            return &table.columns[k];
        }
    }
    return nullptr;
}

// What the calibration says of D and of the electrodes' angle: (E + R)/2 and (E - R)/2 are |c|^2
// and |d|^2, (S + iQ)/2 is c d*, and R + iS turns by 4 theta.
Status calibrate(const SignalSettings& signal, PowerRun& run) {
    using Complex = std::complex<double>;
    constexpr double pi = std::numbers::pi;
    const Calibration& told = signal.calibration;
    if (told.delay_d_s != 0 && !signal.f0_hz) {
        return Error{ErrorCode::setting_invalid,
                     "",
                     {"--delay", number_arg(told.delay_d_s, 3, "s"),
                      words(VYBEG_MESSAGE("Words",
                                          "a log without a phase has no frequency, and a delay is "
                                          "a phase at one: give the carrier f0, too"))}};
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

Result<PowerRun> read_power_log(const std::filesystem::path& path, const OpenOptions& options,
                                const LogChoice& columns, const SignalSettings& signal,
                                const JobControl& job) {
    const double from_s = signal.from_s.value_or(TimeRange{}.from_s);
    const double to_s = signal.to_s.value_or(TimeRange{}.to_s);
    const auto waves = column_wishes(columns.names, roles_of_waves());
    if (!waves) {
        const auto wishes = TRY(column_wishes(columns.names, roles_of_powers()));
        auto table = TRY(read_log(path, options, wishes, job));
        TRY(keep_times(path, from_s, to_s, table));
        PowerRun run;
        run.e = std::move(column_of(wishes, table, "E")->values);
        run.r = std::move(column_of(wishes, table, "R")->values);
        run.s = std::move(column_of(wishes, table, "S")->values);
        run.q = std::move(column_of(wishes, table, "Q")->values);
        run.time_s = std::move(table.time_s);
        TRY(calibrate(signal, run));
        return run;
    }
    auto table = TRY(read_log(path, options, *waves, job));
    TRY(keep_times(path, from_s, to_s, table));
    LogColumn& theta = *column_of(*waves, table, "theta");
    const auto factor = TRY(angle_factor(path, theta, columns.rad_per_angle_unit));
    for (double& value : theta.values) {
        value *= factor;
    }
    PowerRun run = powers_of_waves(std::move(table.time_s), column_of(*waves, table, "a")->values,
                                   column_of(*waves, table, "b")->values, theta.values);
    TRY(calibrate(signal, run));
    return run;
}

}  // namespace vybeg
