#include "core/sweep/window_sweep.h"

namespace vybeg {
namespace {

constexpr double same_loss = 1.25;
constexpr double dominant = 3;
// Loss of a length without windows flagged as moving, over that of one with them.
constexpr double worth_a_warning = 2;

struct Loss {
    double ratio = 0;
    std::size_t variable = 0;
};

// A window about as long as a beat no longer shows it: motion is then foretold from the shorter
// windows in which it is beyond doubt, and grows with the square of the length.
std::vector<SweepLength> with_foretold_motion(std::span<const SweepLength> measured) {
    std::vector<SweepLength> lengths(measured.begin(), measured.end());
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        double bend = 0;  // motion over the square of the length
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            const double square =
                static_cast<double>(lengths[k].length) * static_cast<double>(lengths[k].length);
            SweepValue& value = lengths[k].values[v];
            if (value.motion >
                std::hypot(std::max(value.scatter, value.leaking), value.unmodelled)) {
                bend = std::max(bend, value.motion / square);
            }
            value.motion = std::max(value.motion, bend * square);
        }
    }
    return lengths;
}

// Lengths up to the first at which motion dominates a variable: beyond it the bend of one variable
// shifts others in ways that their own bend does not show, first of all the frequency.
std::size_t before_motion(std::span<const SweepLength> lengths) {
    constexpr std::size_t least = 2;
    std::size_t k = 0;
    const auto dominates = [](const SweepValue& value) {
        return value.motion > dominant * std::max(value.scatter, value.leaking);
    };
    while (k < lengths.size() && std::ranges::none_of(lengths[k].values, dominates)) {
        ++k;
    }
    return std::min(std::max(k, least), lengths.size());
}

// A variable that has an error in half of the lengths or more, with the least one.
struct Comparable {
    std::size_t variable;
    double least;
};

std::vector<Comparable> comparable(std::span<const SweepLength> lengths) {
    std::vector<Comparable> found;
    for (std::size_t v = 0; v < sweep_variable_count; ++v) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t count = 0;
        for (const SweepLength& each : lengths) {
            const double error = each.values[v].error();
            if (std::isfinite(error) && error > 0) {
                least = std::min(least, error);
                ++count;
            }
        }
        if (count > 0 && 2 * count >= lengths.size()) {
            found.push_back({v, least});
        }
    }
    return found;
}

// The largest ratio of a length; infinite where one of the errors is missing.
Loss loss_of(const SweepLength& length, const std::vector<Comparable>& variables) {
    Loss loss;
    for (const Comparable& each : variables) {
        const double ratio = length.values[each.variable].error() / each.least;
        if (!(ratio <= loss.ratio)) {
            loss = {std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity(),
                    each.variable};
        }
    }
    return loss;
}

// The motion, or else the scatter, of the variable that the step from one length to the next
// worsens most.
void explain(const SweepLength& at, const SweepLength& next,
             const std::vector<Comparable>& variables, WindowAdvice& advice) {
    advice.limit = WindowAdvice::Limit::no_values;
    double worst = 0;
    for (const Comparable& each : variables) {
        const SweepValue& value = next.values[each.variable];
        const double growth = value.error() / at.values[each.variable].error();
        if (growth > worst) {
            worst = growth;
            advice.variable = each.variable;
            advice.limit = growth <= 1                    ? WindowAdvice::Limit::flat
                           : value.motion > value.scatter ? WindowAdvice::Limit::motion
                                                          : WindowAdvice::Limit::scatter;
        }
    }
}

}  // namespace

std::optional<WindowAdvice> advise_window(std::span<const SweepLength> measured) {
    const std::vector<SweepLength> foretold = with_foretold_motion(measured);
    const auto lengths = std::span(foretold).first(before_motion(foretold));
    const std::vector<Comparable> variables = comparable(lengths);
    std::vector<Loss> losses;
    for (const SweepLength& each : lengths) {
        losses.push_back(loss_of(each, variables));
    }
    const auto compared =
        std::ranges::count_if(losses, [](const Loss& loss) { return std::isfinite(loss.ratio); });
    if (variables.empty() || compared < 2) {
        return std::nullopt;
    }
    WindowAdvice advice;
    // Of lengths of nearly the same loss the shortest: beyond the best one motion grows fast.
    const double least = std::ranges::min_element(losses, {}, &Loss::ratio)->ratio;
    while (losses[advice.best].ratio > same_loss * least) {
        ++advice.best;
    }
    if (lengths[advice.best].moving > 0) {
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            if (lengths[k].moving == 0 && std::isfinite(losses[k].ratio) &&
                (!advice.quiet || losses[k].ratio < losses[*advice.quiet].ratio)) {
                advice.quiet = k;
            }
        }
        if (advice.quiet) {
            const double loss = losses[*advice.quiet].ratio / losses[advice.best].ratio;
            if (loss <= worth_a_warning) {
                advice.best = *advice.quiet;
                advice.quiet.reset();
            } else {
                advice.quiet_loss = loss;
            }
        }
    }
    advice.loss = losses[advice.best].ratio;
    advice.loser = losses[advice.best].variable;
    const auto acceptable = [&](std::size_t k) {
        return losses[k].ratio <= loss_span * advice.loss;
    };
    advice.shortest = advice.best;
    while (advice.shortest > 0 && acceptable(advice.shortest - 1)) {
        --advice.shortest;
    }
    advice.longest = advice.best;
    while (advice.longest + 1 < lengths.size() && acceptable(advice.longest + 1)) {
        ++advice.longest;
    }
    if (advice.best + 1 < foretold.size()) {
        explain(lengths[advice.best], foretold[advice.best + 1], variables, advice);
    }
    for (const Comparable& each : variables) {
        const SweepValue& value = lengths[advice.best].values[each.variable];
        if (advice.best == 0 && value.motion > value.scatter) {
            advice.limit = WindowAdvice::Limit::list_begin;
            advice.variable = each.variable;
        }
    }
    return advice;
}

}  // namespace vybeg
