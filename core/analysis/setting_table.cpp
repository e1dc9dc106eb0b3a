#include "core/analysis/setting_table.h"

#include <tbb/info.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

namespace vybeg {
namespace {

// The most that samples and offsets may be, so that sums of squares stay finite.
constexpr double most_amplitude = 1e30;
// Angles keep their digits below this, rad.
constexpr double most_angle = 1e6;
constexpr double most_samples = 1e15;  // exact as a double
constexpr double above_zero = std::numeric_limits<double>::min();
constexpr double most_number = std::numeric_limits<double>::max();

template <class S>
using Rows = std::vector<SettingRow<S>>;

SettingRow<SignalSettings> band_row(SettingRow<SignalSettings> row,
                                    std::optional<Band> SignalSettings::*member) {
    const Bounds low{0, most_number, "a band needs a low edge of at least 0 Hz and a higher edge"};
    const Bounds high{above_zero, low.most, low.allowed};
    row.bounds = {low, high};
    return value_row<Band>(
        row, [=](auto& s) -> auto& { return s.*member; },
        [option = row.option()](const std::string& from) -> Result<Band> {
            const auto edges =
                read_numbers(option, from, 2, "it must be two frequencies in Hz, LO,HI", "Hz");
            return edges ? Result(Band{(*edges)[0], (*edges)[1]}) : edges.error();
        },
        [](const Band& band) {
            return joined({band.low_hz, band.high_hz});
        },
        [low, option = row.option()](const Band& band) {
            // False for NaN.
            const bool rises =
                band.low_hz >= low.least && band.high_hz > band.low_hz && band.high_hz <= low.most;
            return rises ? Status()
                         : refused_value(option, short_text(band.low_hz, 12), low.allowed);
        });
}

SettingRow<SignalSettings> offset_row() {
    SettingRow<SignalSettings> row{
        "offset", "C,D|auto",
        "Offsets of the channels, recording units; auto: the mean of each over whole periods "
        "(default 0,0)"};
    row.read = [](const std::string& from, SignalSettings& settings) -> Status {
        Calibration& calibration = settings.calibration;
        calibration.offset_auto = from == "auto";
        if (calibration.offset_auto) {
            return {};
        }
        const auto offsets =
            TRY(read_numbers("--offset", from, 2, "it is two numbers C,D or auto"));
        calibration.offset_c = offsets[0];
        calibration.offset_d = offsets[1];
        return {};
    };
    row.text = [](const SignalSettings& settings) {
        const Calibration& calibration = settings.calibration;
        return calibration.offset_auto ? std::string("auto")
                                       : joined({calibration.offset_c, calibration.offset_d});
    };
    const Bounds bounds{-most_amplitude, most_amplitude, "it must lie within +-1e30"};
    row.bounds = {bounds, bounds};
    row.check = [bounds](const SignalSettings& settings) -> Status {
        TRY(within(bounds, "--offset", settings.calibration.offset_c));
        return within(bounds, "--offset", settings.calibration.offset_d);
    };
    return row;
}

Rows<SignalSettings> rows_of_signal() {
    using S = SignalSettings;
    const Bounds time{0, most_number, "it cannot be negative"};
    return {
        number_row<S>({"f0", "HZ", "The carrier, Hz; skips the search for it"},
                      [](auto& s) -> auto& { return s.f0_hz; },
                      {1e-6, most_number, "it must be at least 1e-6 Hz"}),
        number_row<S>(
            {"from", "S", "Start of the part to analyse, s"},
            [](auto& s) -> auto& { return s.from_s; }, time),
        number_row<S>(
            {"to", "S", "End of the part to analyse, s"}, [](auto& s) -> auto& { return s.to_s; },
            time),
        band_row({"band", "LO,HI", "Look for the carrier between two frequencies, Hz"}, &S::band),
        band_row({"filter", "LO,HI", "Zero-phase band-pass before everything, Hz"}, &S::filter),
        number_row<S>({"kappa", "K", "Gain ratio of the channels: S_D = D / K (default 1)"},
                      [](auto& s) -> auto& { return s.calibration.kappa; },
                      {1e-6, 1e6, "it must lie between 1e-6 and 1e6"}),
        offset_row(),
        number_row<S>({"delay", "S", "By how much channel D comes late, s (default 0)"},
                      [](auto& s) -> auto& { return s.calibration.delay_d_s; },
                      {-1, 1, "it must lie within +-1 s"}),
        number_row<S>({"angle-zero", "DEG",
                       "Angle of the first electrode, degrees; subtracted from theta_A (default "
                       "0)"},
                      [](auto& s) -> auto& { return s.calibration.angle_zero_deg; },
                      {-360, 360, "it must lie within +-360 degrees"}),
        switch_row<S>(
            {"repair-lost", "",
             "Make gaps where samples were lost, so that time runs on behind them"},
            [](auto& s) -> auto& { return s.repair_lost; }),
    };
}

const Rows<SignalSettings>& signal_settings() {
    static const Rows<SignalSettings> rows = rows_of_signal();
    return rows;
}

// Of WindowSettings or PhasorWindowSettings. The length in samples has no effect where periods are
// given.
template <class S>
Rows<S> window_rows(const std::string& help, Bounds bounds) {
    SettingRow<S> window = value_row<std::int64_t>(
        SettingRow<S>{"window", "N", help}, [](auto& s) -> auto& { return s.window; },
        [](const std::string& from) { return read_whole("--window", from); }, integer_text,
        any_value, "default");
    window.bounds = {bounds};
    window.check = [bounds](const S& settings) {
        const std::optional<std::int64_t> samples = settings.window;
        return settings.periods || !samples
                   ? Status()
                   : within(bounds, "--window", static_cast<double>(*samples));
    };
    return {window,
            number_row<S>(
                {"periods", "P", "Window length in periods of the carrier; may be fractional"},
                [](auto& s) -> auto& { return s.periods; },
                {above_zero, 1e9, "it must be above zero and at most 1e9"}),
            switch_row<S>(
                {"snap", "",
                 "Move the window to whole half-periods, where the averages are "
                 "orthogonal"},
                [](auto& s) -> auto& { return s.snap; })};
}

template <class S>
SettingRow<S> threads_row() {
    SettingRow<S> row =
        count_row<S>({"threads", "N", "Threads (default: as many as the machine has)"},
                     [](auto& s) -> auto& { return s.threads; }, "all",
                     {1, std::numeric_limits<int>::max(), "it must be at least 1"});
    row.has_part = false;
    return row;
}

Result<Algorithm> read_algorithm(const std::string& from) {
    const std::optional<Algorithm> algorithm = algorithm_from_name(from);
    if (!algorithm) {
        return refused_value("--algorithm", from, "it is " + algorithm_names());
    }
    return *algorithm;
}

SettingRow<Settings> algorithm_row() {
    return value_row<Algorithm, Settings>(
        {"algorithm", "NAME", algorithm_names() + " (default)"},
        [](auto& s) -> auto& { return s.algorithm; }, read_algorithm,
        [](Algorithm algorithm) { return std::string(algorithm_name(algorithm)); }, any_value);
}

Result<StartValues> read_initial(const std::string& from) {
    const auto v = TRY(read_numbers("--initial", from, 5, "it must be five numbers with commas"));
    return StartValues{{v[0], v[1], v[2], v[3]}, v[4]};
}

std::string initial_text(const StartValues& initial) {
    const WaveState& state = initial.state;
    return joined({state.a_A, state.a_B, state.two_theta_A, state.alpha, initial.f_hz});
}

SettingRow<Settings> initial_row() {
    SettingRow<Settings> row{"initial", "aA,aB,2thetaA,alpha,f",
                             "Start values of conjugate-gradient: recording units, rad, Hz; alpha "
                             "at the centre of the first window"};
    const Bounds angle{-most_angle, most_angle, "an angle must lie within +-1e6 rad"};
    row.bounds = {{above_zero, most_amplitude,
                   "the amplitude a_A must be above zero and at most "
                   "1e30"},
                  {-most_amplitude, most_amplitude, "an amplitude must lie within +-1e30"},
                  angle,
                  angle,
                  {above_zero, most_number, "the frequency must be above zero"}};
    const auto check = [bounds = row.bounds](const StartValues& initial) -> Status {
        const WaveState& state = initial.state;
        const std::array values{state.a_A, state.a_B, state.two_theta_A, state.alpha, initial.f_hz};
        for (std::size_t k = 0; k < values.size(); ++k) {
            TRY(within(bounds[k], "--initial", values[k]));
        }
        return {};
    };
    return value_row<StartValues, Settings>(
        row, [](auto& s) -> auto& { return s.initial; }, read_initial, initial_text, check);
}

Tolerance assumed() {
    Tolerance tolerance;
    for (const ToleranceInUse& each : tolerances_in_use({}, 1)) {
        tolerance[each.error.source] = each.value;
    }
    return tolerance;
}

SettingRow<IdentifySettings> tolerance_row() {
    return value_row<Tolerance, IdentifySettings>(
        {"tolerance", "NAME=X[,NAME=X]",
         "How well the channels are known, standard deviations: " +
             joined(channel_errors, ", ",
                    [](const ToleratedError& error) {
                        return std::string(error.name) + " (" + error.amount + ")";
                    }) +
             "; rate (ppm), the recorder's clock; and spread (relative), by which recordings of "
             "one set may differ. 0 is exact; where none is told, u assumes " +
             tolerance_text(assumed()) + ". Units may follow, as in skew=0.1deg,delay=10ns"},
        [](auto& s) -> auto& { return s.tolerance; }, read_tolerance, tolerance_text, any_value);
}

SettingRow<LogChoice> f_ref_row() {
    SettingRow<LogChoice> row{"f-ref", "HZ",
                              "With --phasors: frequency of the reference (default: of the file)"};
    const Bounds bounds{above_zero, 1e12, "it is a frequency above zero"};
    row.bounds = {bounds};
    return value_row<double>(
        row, [](auto& s) -> auto& { return s.phasors.f_ref_hz; },
        [bounds, option = row.option()](const std::string& from) -> Result<double> {
            const auto f_hz = TRY(from == not_set ? 0 : read_number(option, from, "Hz"));
            TRY(from == not_set ? Status() : within(bounds, option, f_hz));
            return f_hz;
        },
        [](double f_hz) { return f_hz == 0 ? not_set : round_trip_text(f_hz); },
        [bounds, option = row.option()](double f_hz) {
            return f_hz == 0 ? Status() : within(bounds, option, f_hz);
        });
}

SettingRow<LogChoice> lock_in_row() {
    return value_row<LockIn, LogChoice>(
        {"lock-in", "ORDER,BW",
         "With --phasors: RC stages of the lock-in's filter, 1 to 8, and its 3 dB bandwidth, Hz "
         "(default: none)"},
        [](auto& s) -> auto& { return s.phasors.filter; },
        [](const std::string& from) {
            return from == not_set ? Result(LockIn{}) : read_lock_in("--lock-in", from);
        },
        [](const LockIn& filter) {
            return filter.order == 0
                       ? not_set
                       : integer_text(filter.order) + "," + round_trip_text(filter.bandwidth_hz);
        },
        any_value);
}

Rows<LogChoice> rows_of_logs() {
    using S = LogChoice;
    return {
        value_row<std::string, S>(
            {"columns", "NAMES",
             "The files are logs or tracks without a phase, with the columns E,R,S,Q or "
             "a,b,theta, each with =COLUMN, a name or a number, where the file calls it "
             "otherwise"},
            [](auto& s) -> auto& { return s.names; },
            [](const std::string& from) { return Result(from == not_set ? std::string() : from); },
            [](const std::string& names) { return names.empty() ? not_set : names; }, any_value),
        choice_row<S>(
            {"angle-unit", "deg|rad|cyc",
             "Unit of theta, or of the phases, where the file does not tell it; cyc: whole turns"},
            [](auto& s) -> auto& { return s.rad_per_angle_unit; },
            {{not_set, log_angle_units[0]},
             {"deg", log_angle_units[1]},
             {"rad", log_angle_units[2]},
             {"cyc", log_angle_units[3]}},
            "it is deg, rad or cyc"),
        choice_row<S>(
            {"phasors", "fixed|common|pll",
             "The files are logs of a lock-in or a phasemeter, with the columns Xc,Yc,Xd,Yd: "
             "relative to one frequency, to an oscillator that moves (column F or P), or each "
             "channel to its own phase (Pc,Pd)"},
            [](auto& s) -> auto& { return s.phasors.frame; },
            {{not_set, PhasorFrame::none},
             {"fixed", PhasorFrame::fixed},
             {"common", PhasorFrame::common},
             {"pll", PhasorFrame::pll}},
            "it is fixed, common or pll"),
        f_ref_row(),
        choice_row<S>(
            {"y-sign", "+|-",
             "With --phasors: the signal is Re((X + iY) e^iwt) or Re((X - iY) e^iwt)"},
            [](auto& s) -> auto& { return s.phasors.y_sign; }, {{not_set, 0}, {"+", 1}, {"-", -1}},
            "it is + or -"),
        choice_row<S>(
            {"amplitude", "peak|rms", "With --phasors: what sqrt(X^2 + Y^2) is"},
            [](auto& s) -> auto& { return s.phasors.peak_per_unit; },
            {{not_set, 0}, {"peak", 1}, {"rms", std::numbers::sqrt2}}, "it is peak or rms"),
        lock_in_row()};
}

// Adds the rows of settings that `part` returns of S.
template <class Of, class Part, class S>
void add(const Of& rows_of_part, Part part, Rows<S>& rows) {
    for (const auto& row : rows_of_part) {
        rows.push_back(row_of_part<S>(row, part));
    }
}

Rows<Settings> rows_of_analysis() {
    const auto whole = [](auto& s) -> auto& {
        return s;
    };
    Rows<Settings> rows{algorithm_row()};
    add(window_rows<WindowSettings>(
            "Window length, samples (default " + integer_text(WindowSettings().window) + ")",
            {5, most_samples, "it must be 5 to 1e15 samples: there are five parameters"}),
        whole, rows);
    rows.push_back(
        count_row<Settings>({"hop", "N", "Samples between window starts (default: the window)"},
                            [](auto& s) -> auto& { return s.hop; }, "window",
                            {1, most_samples, "it must be 1 to 1e15 samples"}));
    add(std::span(signal_settings()).first(1), whole, rows);
    rows.push_back(initial_row());
    rows.push_back(choice_row<Settings>(
        {"start", "first|previous",
         "conjugate-gradient starts each window from in-phase or from the window before "
         "(default first)"},
        [](auto& s) -> auto& { return s.start; },
        {{"first", StartRule::first}, {"previous", StartRule::previous}},
        "it is first or previous"));
    add(std::span(signal_settings()).subspan(1), whole, rows);
    rows.push_back(threads_row<Settings>());
    return rows;
}

Rows<IdentifySettings> rows_of_identification() {
    Rows<IdentifySettings> rows{choice_row<IdentifySettings>(
        {"model", "NAME",
         "auto (default), structured (the pick-offs are a calibrated "
         "pair) or free (only the modes)"},
        [](auto& s) -> auto& { return s.model; },
        {{"auto", FitOptions::Model::automatic},
         {"structured", FitOptions::Model::structured},
         {"free", FitOptions::Model::free}},
        "it is auto, structured or free")};
    add(
        window_rows<PhasorWindowSettings>(
            "Window length, samples (default: 15 ms, 12 periods at least)",
            {16, most_number, "the resonator's fit needs at least 16 samples"}),
        [](auto& s) -> auto& { return s.windows; }, rows);
    add(
        signal_settings(), [](auto& s) -> auto& { return s.signal; }, rows);
    rows.push_back(threads_row<IdentifySettings>());
    rows.push_back(tolerance_row());
    add(
        log_settings(), [](auto& s) -> auto& { return s.logs; }, rows);
    return rows;
}

template <class S>
Status first_fault(const Rows<S>& rows, const S& settings) {
    for (const SettingRow<S>& row : rows) {
        TRY(row.check(settings));
    }
    return {};
}

}  // namespace

bool same_carrier_search(const SignalSettings& a, SignalSettings b) {
    b.f0_hz = a.f0_hz;
    return a == b;
}

int threads_of(int asked) {
    const int cores = tbb::info::default_concurrency();
    return asked > 0 ? std::min(asked, cores) : cores;
}

const std::vector<SettingRow<Settings>>& analysis_settings() {
    static const Rows<Settings> rows = rows_of_analysis();
    return rows;
}

const std::vector<SettingRow<IdentifySettings>>& identify_settings() {
    static const Rows<IdentifySettings> rows = rows_of_identification();
    return rows;
}

const std::vector<SettingRow<LogChoice>>& log_settings() {
    static const Rows<LogChoice> rows = rows_of_logs();
    return rows;
}

Result<LockIn> read_lock_in(const std::string& option, const std::string& text, double* rate_hz) {
    constexpr int most_stages = 8;
    std::vector<double> numbers;
    for (const std::string_view part : parts_between(text, ',')) {
        const auto number = number_with_unit(part, numbers.empty() ? "" : "Hz");
        numbers.push_back(number && *number > 0 && *number < 1e9 ? *number : 0);
    }
    const bool whole_stages = numbers[0] == std::floor(numbers[0]) && numbers[0] <= most_stages;
    if (numbers.size() != (rate_hz == nullptr ? 2 : 3) || !whole_stages ||
        std::ranges::count(numbers, 0.0) > 0) {
        return refused_value(
            option, text,
            rate_hz == nullptr
                ? "it is an order from 1 to 8 and a bandwidth, e.g. 4,20Hz"
                : "it is an order from 1 to 8, a bandwidth and a rate, e.g. 4,20Hz,200Hz");
    }
    if (rate_hz != nullptr) {
        *rate_hz = numbers[2];
    }
    return LockIn{static_cast<int>(numbers[0]), numbers[1]};
}

const Bounds& bounds_of(const std::string& name, std::size_t number) {
    return row_named(analysis_settings(), name) != nullptr
               ? bounds_in(analysis_settings(), name, number)
               : bounds_in(identify_settings(), name, number);
}

Status validate(const SignalSettings& settings) {
    return first_fault(signal_settings(), settings);
}

Status validate(const Settings& settings) {
    return first_fault(analysis_settings(), settings);
}

Status validate(const IdentifySettings& settings) {
    for (const SignalSettings& signal : settings.of_recordings) {
        TRY(validate(signal));
    }
    return first_fault(identify_settings(), settings);
}

std::vector<NamedValue> settings_list(const Settings& settings) {
    return listed(analysis_settings(), settings);
}

std::vector<NamedValue> settings_list(const IdentifySettings& settings) {
    IdentifySettings one = settings;
    std::vector<NamedValue> list;
    for (const SettingRow<IdentifySettings>& row : identify_settings()) {
        std::vector<std::string> texts;
        for (std::size_t k = 0; k == 0 || k < settings.of_recordings.size(); ++k) {
            one.signal = settings.signal_of(k);
            texts.push_back(row.text(one));
        }
        std::string value = one_or_each(texts, "; ");
        if (row.has_part && (row_named(log_settings(), row.name) == nullptr || value != not_set)) {
            list.emplace_back(row.name, std::move(value));
        }
    }
    return list;
}

}  // namespace vybeg
