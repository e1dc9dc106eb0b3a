#include "core/analysis/log_look.h"

#include "core/analysis/logs.h"
#include "core/base/plain_text.h"
#include "core/recording/open/log_columns.h"
#include "core/recording/open/preview.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

bool is_missing_column(const Error& error) {
    return error.code == ErrorCode::column_missing || error.code == ErrorCode::variable_missing;
}

// Whether an oscillator's frequency is another one from row to row.
bool moves(const LogColumn& frequency) {
    constexpr double digits = 1e-9;
    const auto [least, most] = range_of(frequency);
    return most - least > digits * std::abs(most);
}

class Looker {
public:
    Looker(const std::filesystem::path& path, const OpenOptions& options, const JobControl& job,
           LogLook& look)
        : path_(path), options_(options), job_(job), look_(look) {}

    Status look() {
        const bool given = look_.choice.given();
        if (!given && is_nameless()) {
            return {};
        }
        const std::string names = look_.choice.names;
        if (look_.choice.phasors.frame == PhasorFrame::none) {
            TRY(look_for_powers(names));
        }
        // Columns given for a log without a phase: their problem is the log's.
        if (!found_ && (!given || look_.choice.phasors.frame != PhasorFrame::none)) {
            TRY(look_for_phasors(names));
        }
        if (!found_ && !given && is_missing_column(*look_.problem)) {
            look_.problem.reset();
        }
        return {};
    }

private:
    bool is_nameless() const {
        return look_.preview.used &&
               std::ranges::all_of(look_.preview.used->headings,
                                   [](const Channel& each) { return each.name.empty(); });
    }

    // Nothing where the file cannot be read so: look_.problem. Errors: interrupted.
    Result<std::optional<LogTable>> see(const std::string& names,
                                        const std::vector<ColumnRole>& roles) {
        auto wishes = column_wishes(names, roles);
        if (!wishes) {
            look_.problem = wishes.error();
            return std::optional<LogTable>();
        }
        OpenOptions rated = options_;
        auto table = read_log(path_, rated, *wishes, job_);
        const bool unrated = !table && table.error().code == ErrorCode::rate_unknown;
        if (unrated) {
            rated.rate_hz = 1;  // any: the columns are looked at, not the times
            table = read_log(path_, rated, *wishes, job_);
        }
        if (!table && table.error().code == ErrorCode::interrupted) {
            return table.error();
        }
        if (!table) {
            look_.problem = table.error();
            return std::optional<LogTable>();
        }
        look_.needs_rate = unrated;
        look_.problem.reset();
        found_ = true;
        return std::optional(std::move(*table));
    }

    Status look_for_powers(const std::string& names) {
        if (names.empty() || column_wishes(names, roles_of_powers())) {
            const auto powers = TRY(see(names, roles_of_powers()));
            look_.choice.names = powers && names.empty() ? "E,R,S,Q" : names;
            if (powers || !names.empty()) {
                return {};
            }
        }
        const auto waves = TRY(see(names, roles_of_waves()));
        if (waves) {
            look_.choice.names = names.empty() ? "a,b,theta" : names;
            ask_for_unit(*waves->find("theta"));
        }
        return {};
    }

    Status look_for_phasors(const std::string& names) {
        const PhasorFrame given = look_.choice.phasors.frame;
        // Of all frames this one needs the fewest columns.
        const PhasorFrame wanted = given == PhasorFrame::none ? PhasorFrame::fixed : given;
        const auto of_both = TRY(see(names, roles_of_both(wanted)));
        if (of_both) {
            describe_phasors(*of_both, {"Pc", "Pd"});
            return {};
        }
        const std::optional<Error> problem = look_.problem;
        const auto of_one = TRY(see(names, roles_of_one(wanted)));
        look_.one_channel = of_one.has_value();
        if (of_one) {
            describe_phasors(*of_one, {"P"});
        } else {
            look_.problem = problem;
        }
        return {};
    }

    // `own`: columns of the phases of the channels themselves.
    void describe_phasors(const LogTable& columns, const std::vector<const char*>& own) {
        PhasorChoice& how = look_.choice.phasors;
        const LogColumn* const frequency = columns.find("F");
        // In a table of one channel, P is its own where no frame is given.
        const LogColumn* const phase = columns.find("P");
        const bool has_own = std::ranges::all_of(
            own, [&](const char* role) { return columns.find(role) != nullptr; });
        if (how.frame == PhasorFrame::none && has_own) {
            how.frame = PhasorFrame::pll;
        } else if (how.frame == PhasorFrame::none) {
            const bool oscillates = phase != nullptr || (frequency != nullptr && moves(*frequency));
            how.frame = oscillates ? PhasorFrame::common : PhasorFrame::fixed;
        }
        const LogColumn* const held = how.frame == PhasorFrame::pll      ? columns.find(own.front())
                                      : how.frame == PhasorFrame::common ? phase
                                                                         : nullptr;
        const bool deviates = frequency != nullptr && held == nullptr &&
                              how.frame == PhasorFrame::common && holds_deviations(*frequency, 0);
        look_.needs_f_ref =
            how.f_ref_hz == 0 && (frequency == nullptr ? !holds_carrier(held, columns) : deviates);
        if (how.frame == PhasorFrame::common && frequency == nullptr && phase == nullptr) {
            look_.problem = Error{ErrorCode::column_missing,
                                  path_.string(),
                                  {"F", joined(look_.preview.columns, ", ", &Channel::name)}};
        }
        for (const char* role : own) {
            if (const LogColumn* own_phase = columns.find(role);
                own_phase && how.frame == PhasorFrame::pll) {
                ask_for_unit(*own_phase);
            }
        }
        if (how.frame == PhasorFrame::common && phase != nullptr) {
            ask_for_unit(*phase);
        }
        if (is_of_labone(columns)) {
            how.y_sign = how.y_sign == 0 ? 1 : how.y_sign;
            how.peak_per_unit = how.peak_per_unit == 0 ? std::numbers::sqrt2 : how.peak_per_unit;
        }
    }

    bool holds_carrier(const LogColumn* phase, const LogTable& columns) const {
        const auto rad =
            phase ? angle_factor(path_, *phase, look_.choice.rad_per_angle_unit) : Result(0.0);
        return rad && *rad > 0 && carrier_in(*rad, *phase, columns.time_s) > 0;
    }

    bool is_of_labone(const LogTable& columns) const {
        const LogColumn* const x =
            columns.find("Xc") != nullptr ? columns.find("Xc") : columns.find("X");
        const auto has = [this](std::string_view name) {
            return look_.preview.used &&
                   std::ranges::find(look_.preview.used->headings, name, &Channel::name) !=
                       look_.preview.used->headings.end();
        };
        return x != nullptr && (x->name.find("demods") != std::string::npos ||
                                (has("chunk") && has("timestamp") && has("auxin0")));
    }

    void ask_for_unit(const LogColumn& angles) {
        look_.needs_angle_unit =
            look_.needs_angle_unit || !angle_factor(path_, angles, look_.choice.rad_per_angle_unit);
    }

    const std::filesystem::path& path_;
    const OpenOptions& options_;
    const JobControl& job_;
    LogLook& look_;
    bool found_ = false;
};

}  // namespace

Result<LogLook> look_at_log(const std::filesystem::path& path, const OpenOptions& options,
                            const LogChoice& given, const JobControl& job) {
    LogLook look;
    look.choice = given;
    OpenOptions alone = options;
    alone.channel_d_file.clear();
    look.preview = TRY(preview_recording(path, alone, job));
    // It shows lines, not two of the columns as samples.
    look.preview.problem.reset();
    look.preview.c_column = look.preview.d_column = -1;
    look.preview.c.clear();
    look.preview.d.clear();
    TRY(Looker(path, alone, job, look).look());
    return look;
}

}  // namespace vybeg
