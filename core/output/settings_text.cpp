#include "core/output/settings_text.h"

#include "core/base/number_text.h"

#include <initializer_list>
#include <optional>

namespace vybeg {
namespace {

constexpr const char* none = "none";

std::string joined(std::initializer_list<double> numbers) {
    std::string text;
    for (const double number : numbers) {
        text += text.empty() ? "" : ",";
        append_round_trip(text, number);
    }
    return text;
}

std::string text_of(const std::optional<double>& number) {
    return number ? round_trip_text(*number) : none;
}

std::string text_of(const std::optional<Band>& band) {
    return band ? joined({band->low_hz, band->high_hz}) : none;
}

std::string text_of(const std::optional<StartValues>& values) {
    if (!values) {
        return none;
    }
    const WaveState& state = values->state;
    return joined({state.a_A, state.a_B, state.two_theta_A, state.alpha, values->f_hz});
}

// What carries the signals to the windows, whatever is done there.
std::vector<NamedValue> signal_list(const Settings& settings) {
    const Calibration& calibration = settings.calibration;
    return {
        {"from", text_of(settings.from_s)},
        {"to", text_of(settings.to_s)},
        {"band", text_of(settings.band)},
        {"filter", text_of(settings.filter)},
        {"kappa", round_trip_text(calibration.kappa)},
        {"offset",
         calibration.offset_auto ? "auto" : joined({calibration.offset_c, calibration.offset_d})},
        {"delay", round_trip_text(calibration.delay_d_s)},
        {"angle-zero", round_trip_text(calibration.angle_zero_deg)},
        {"repair-lost", settings.repair_lost ? "yes" : "no"},
    };
}

void append(const std::vector<NamedValue>& more, std::vector<NamedValue>& list) {
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

std::vector<NamedValue> settings_list(const Settings& settings) {
    std::vector<NamedValue> list{
        {"algorithm", std::string(algorithm_name(settings.algorithm))},
        {"window", integer_text(settings.window)},
        {"periods", text_of(settings.periods)},
        {"snap", settings.snap ? "yes" : "no"},
        {"hop", settings.hop > 0 ? integer_text(settings.hop) : "window"},
        {"f0", text_of(settings.f0_hz)},
        {"initial", text_of(settings.initial)},
        {"start", settings.start == StartRule::first ? "first" : "previous"},
    };
    append(signal_list(settings), list);
    return list;
}

const char* model_name(FitOptions::Model model) {
    switch (model) {
        case FitOptions::Model::automatic: return "auto";
        case FitOptions::Model::structured: return "structured";
        case FitOptions::Model::free: return "free";
    }
    return "";
}

std::vector<NamedValue> settings_list(const IdentifySettings& settings) {
    std::vector<NamedValue> list{
        {"model", model_name(settings.model)},
        {"window", settings.window ? integer_text(*settings.window) : "default"},
        {"periods", text_of(settings.signal.periods)},
        {"snap", settings.signal.snap ? "yes" : "no"},
        {"f0", text_of(settings.signal.f0_hz)},
    };
    append(signal_list(settings.signal), list);
    list.emplace_back("tolerance", tolerance_text(settings.tolerance));
    return list;
}

}  // namespace vybeg
