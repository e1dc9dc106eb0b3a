#include "core/analysis/passport.h"

#include "core/numerics/minimise.h"
#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

namespace vybeg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double single_changed_from = 3;  // deviations
constexpr double same_direction = 0.1;     // rad of 2theta_A
constexpr double unseen_split_hz = 3;      // prior deviation of the split in the fit

// Probability of a normal number beyond z deviations, both sides.
double chance_beyond(double z) {
    return std::erfc(z / std::numbers::sqrt2);
}

// Scatter of the frequency between runs, which needs no change of the gyro. Zero for fewer than two
// runs.
double frequency_spread(const std::vector<RunEstimate>& runs) {
    double squares = 0;
    double count = 0;
    for (const RunEstimate& run : runs) {
        if (run.f_offset_hz.given()) {
            squares += run.f_offset_hz.value * run.f_offset_hz.value;
            count += 1;
        }
    }
    return count > 1 ? std::sqrt(squares / (count - 1)) : 0;
}

// Of two angles 2theta_A.
double apart(const Estimate& one, const Estimate& other) {
    return std::abs(std::remainder(one.value - other.value, std::numbers::pi));
}

// Whether a limit of this parameter holds for a difference: "tau_s" for "modes[0].tau_s", too.
bool is_of(const std::string& difference, const std::string& parameter) {
    const std::string last = difference.substr(difference.find_last_of('.') + 1);
    return last == parameter || (last == "f_hz" && parameter == "f_mean_hz");
}

// Collects the differences; the verdicts follow when all are known.
class Comparison {
public:
    Comparison(const Passport& passport, const ResonatorFit& now, const CompareOptions& options)
        : passport_(passport),
          now_(now),
          options_(options),
          spread_hz_(std::hypot(frequency_spread(passport.runs), frequency_spread(now.runs))) {}

    std::vector<Difference> differences() {
        for (const ResonatorParameter& parameter : resonator_parameters) {
            add({parameter.name, parameter.unit, passport_.resonator.*parameter.member,
                 now_.resonator.*parameter.member},
                parameter.member == &ResonatorEstimate::f_mean_hz, parameter.period);
        }
        add_modes();
        add_directions("f_hz", "Hz", &ResonatorEstimate::f_mean_hz, &RunEstimate::direction_f_hz);
        add_directions("tau_s", "s", &ResonatorEstimate::tau_s, &RunEstimate::direction_tau_s);
        judge();
        return std::move(differences_);
    }

private:
    // `besides`: an additional part of u.
    void add(Difference difference, bool is_frequency, double period = 0,
             Incomparable why = Incomparable::none, double besides = 0) {
        const Estimate& then = difference.then;
        const Estimate& now = difference.now;
        if (!then.given() && !now.given()) {
            return;
        }
        difference.relative = difference.change = difference.sd = difference.u = nan;
        set_limit(difference, is_frequency);
        if (why == Incomparable::none) {
            why = !then.given()  ? Incomparable::then_unknown
                  : !now.given() ? Incomparable::now_unknown
                                 : Incomparable::none;
        }
        if (why != Incomparable::none) {
            difference.why = why;
            difference.verdict = Verdict::not_comparable;
            differences_.push_back(std::move(difference));
            return;
        }
        const double change = now.value - then.value;
        difference.change = period > 0 ? std::remainder(change, period) : change;
        difference.sd = std::hypot(then.sd, now.sd);
        difference.u = std::hypot(then.uncertainty(), now.uncertainty(), besides);
        if (is_frequency) {
            difference.u = std::hypot(difference.u, spread_hz_);
        }
        // A relative change of a value near its noise is meaningless.
        if (period == 0 && std::abs(then.value) > single_changed_from * then.uncertainty()) {
            difference.relative = change / then.value;
        }
        differences_.push_back(std::move(difference));
    }

    void set_limit(Difference& difference, bool follows_temperature) const {
        const double then = std::abs(difference.then.value);
        difference.limit = follows_temperature ? options_.f_limit_ppm * 1e-6 * then : 0;
        for (const PracticalLimit& limit : options_.limits) {
            if (is_of(difference.name, limit.parameter)) {
                difference.limit = limit.relative ? limit.size * then : limit.size;
            }
        }
    }

    void add_modes() {
        const std::size_t modes = std::max(passport_.modes.size(), now_.modes.size());
        const bool alike = passport_.mode_order == now_.mode_order;
        const bool both = !passport_.modes.empty() && !now_.modes.empty();
        const Incomparable order =
            alike || !both ? Incomparable::none : Incomparable::other_mode_order;
        const Reason not_apart{ReasonCode::modes_not_apart, {}};
        const auto told = [](const Reason& reason) { return reason.code != ReasonCode::none; };
        for (std::size_t k = 0; k < modes; ++k) {
            for (const ModeParameter& parameter : mode_parameters) {
                const auto of = [&](const std::vector<ModeEstimate>& side, const Reason& none) {
                    return k < side.size() ? side[k].*parameter.member : Estimate{.reason = none};
                };
                add({"modes[" + std::to_string(k) + "]." + parameter.name, parameter.unit,
                     of(passport_.modes, not_apart),
                     of(now_.modes, told(now_.no_modes) ? now_.no_modes : not_apart)},
                    parameter.member == &ModeEstimate::f_hz, 0, order);
            }
        }
    }

    // The run of the passport that starts nearest to a direction; null: none within the limit.
    const RunEstimate* run_at(const Estimate& two_theta_A) const {
        const RunEstimate* nearest = nullptr;
        double least = same_direction;
        for (const RunEstimate& run : passport_.runs) {
            if (!run.two_theta_A_rad.given() || !two_theta_A.given()) {
                continue;
            }
            const double distance = apart(run.two_theta_A_rad, two_theta_A);
            if (distance <= least) {
                least = distance;
                nearest = &run;
            }
        }
        return nearest;
    }

    void add_directions(const std::string& name, const char* unit,
                        Estimate ResonatorEstimate::*of_resonator, Estimate RunEstimate::*member) {
        if ((passport_.resonator.*of_resonator).given() && (now_.resonator.*of_resonator).given()) {
            return;
        }
        const Estimate none{.reason = {ReasonCode::rests_on_unseen, {}}};
        const bool is_frequency = member == &RunEstimate::direction_f_hz;
        for (std::size_t k = 0; k < now_.runs.size(); ++k) {
            const RunEstimate& run = now_.runs[k];
            const RunEstimate* then = run_at(run.two_theta_A_rad);
            const double apart_rad =
                then != nullptr ? apart(then->two_theta_A_rad, run.two_theta_A_rad) : 0;
            // d f / d 2theta_A is up to the split, d tau / d 2theta_A up to g tau^2: undetermined
            // here, so their priors of the fit replace them.
            const double slope = is_frequency ? unseen_split_hz : std::abs((run.*member).value);
            add({"runs[" + std::to_string(k) + "].direction." + name, unit,
                 then != nullptr ? then->*member : none, now_.runs[k].*member},
                is_frequency, 0,
                then != nullptr ? Incomparable::none : Incomparable::other_direction,
                apart_rad > 0 ? slope * apart_rad : 0);
        }
    }

    void judge() {
        for (Difference& each : differences_) {
            each.follows = follows(each);
            if (is_q(each) && !each.follows) {
                set_limit(each, true);
            }
        }
        const double limit = changed_from(count_compared(differences_));
        for (const bool what_follows : {false, true}) {
            for (Difference& each : differences_) {
                if (each.verdict != Verdict::not_comparable && each.follows == what_follows) {
                    const bool changed = each.deviations() >= limit &&
                                         std::abs(each.change) > each.limit &&
                                         (!what_follows || source_changed(each));
                    each.verdict = changed ? Verdict::changed : Verdict::unchanged;
                } else if (!what_follows && is_beyond_bound(each, limit)) {
                    each.verdict = Verdict::changed;
                }
            }
        }
    }

    // Whether the value of one side lies that many deviations above the bound of the other. Of an
    // axis the reason states the bound of its size.
    static bool is_beyond_bound(const Difference& difference, double deviations) {
        const bool given_then = difference.then.given();
        const Estimate& value = given_then ? difference.then : difference.now;
        const double above =
            value.value - greatest_of(given_then ? difference.now : difference.then);
        return std::string_view(difference.unit) != "rad" && value.given() &&
               above >= deviations * value.uncertainty() && above > difference.limit;
    }

    // The same owner's parameter: "modes[0].tau_s" of "modes[0].q". Null: it is not compared.
    const Difference* beside(const Difference& q, const char* name) const {
        const std::string whole = q.name.substr(0, q.name.size() - 1) + name;
        const auto found = std::ranges::find(differences_, whole, &Difference::name);
        return found != differences_.end() && found->verdict != Verdict::not_comparable ? &*found
                                                                                        : nullptr;
    }
    const Difference* frequency_beside(const Difference& q) const {
        const Difference* of_mode = beside(q, "f_hz");
        return of_mode != nullptr ? of_mode : beside(q, "f_mean_hz");
    }

    static bool is_q(const Difference& difference) {
        return difference.verdict != Verdict::not_comparable &&
               (difference.name == "q" || difference.name.ends_with(".q"));
    }

    bool follows(const Difference& difference) const {
        return is_q(difference) && beside(difference, "tau_s") != nullptr &&
               frequency_beside(difference) != nullptr;
    }

    bool source_changed(const Difference& q) const {
        return beside(q, "tau_s")->verdict == Verdict::changed ||
               frequency_beside(q)->verdict == Verdict::changed;
    }

    const Passport& passport_;
    const ResonatorFit& now_;
    const CompareOptions& options_;
    double spread_hz_;
    std::vector<Difference> differences_;
};

}  // namespace

const char* verdict_name(Verdict verdict) {
    constexpr std::array names{"unchanged", "changed", "not comparable"};
    return names[static_cast<std::size_t>(verdict)];
}

const char* incomparable_sentence(Incomparable why) {
    return why == Incomparable::other_direction
               ? ReasonSentence::tr(
                     "It belongs to one direction, and no recording of the other side "
                     "starts within 3 degrees of it.")
           : why == Incomparable::other_mode_order
               ? ReasonSentence::tr(
                     "The modes of both sides are not named by the same: one by "
                     "frequency, the other by decay.")
               : "";
}

std::string incomparable_text(const Difference& difference) {
    switch (difference.why) {
        case Incomparable::now_unknown: return "now: " + english(difference.now.reason);
        case Incomparable::then_unknown:
            return "in the passport: " + english(difference.then.reason);
        default: return incomparable_sentence(difference.why);
    }
}

double Difference::deviations() const {
    // Values without deviation, such as those given by hand, are compared exactly.
    return change == 0 ? 0 : std::abs(change) / u;
}

double changed_from(std::size_t count) {
    if (count <= 1) {
        return single_changed_from;
    }
    // 1 - (1 - p)^(1/count), solved by halving: the probability falls with the deviations.
    const double alone = chance_beyond(single_changed_from);
    const double each = -std::expm1(std::log1p(-alone) / static_cast<double>(count));
    return bisected(single_changed_from, 10, [each](double z) { return chance_beyond(z) > each; });
}

std::size_t count_compared(const std::vector<Difference>& differences) {
    return static_cast<std::size_t>(std::ranges::count_if(differences, [](const Difference& each) {
        return each.verdict != Verdict::not_comparable && !each.follows;
    }));
}

std::vector<Difference> compare(const Passport& passport, const ResonatorFit& now,
                                const CompareOptions& options) {
    return Comparison(passport, now, options).differences();
}

std::optional<Diagnostic> other_gyro(const Passport& passport, const std::string& gyro) {
    if (passport.gyro.empty() || gyro.empty() || passport.gyro == gyro) {
        return {};
    }
    return Diagnostic{DiagnosticKind::other_gyro, {passport.gyro, gyro}};
}

}  // namespace vybeg
