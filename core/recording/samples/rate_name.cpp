#include "core/recording/samples/rate_name.h"

#include "core/recording/samples/column_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace vybeg {
namespace {

constexpr std::array<std::string_view, 9> rate_names{
    "fs",           "sr",         "rate",    "samplerate",       "samplingrate",
    "samplingfreq", "samplefreq", "fsample", "samplingfrequency"};
constexpr std::array<std::string_view, 10> step_names{"dt",
                                                      "ts",
                                                      "tinterval",
                                                      "sampletime",
                                                      "wfincrement",
                                                      "increment",
                                                      "sampleinterval",
                                                      "samplinginterval",
                                                      "sampleperiod",
                                                      "samplingperiod"};

struct RateUnit {
    std::string_view name;
    double hertz;
};
constexpr std::array<RateUnit, 20> rate_units{
    {{"hz", 1},      {"khz", 1e3},  {"mhz", 1e6},   {"ghz", 1e9},     {"гц", 1},
     {"кгц", 1e3},   {"мгц", 1e6},  {"s/s", 1},     {"sa/s", 1},      {"ks/s", 1e3},
     {"ksa/s", 1e3}, {"ms/s", 1e6}, {"msa/s", 1e6}, {"gs/s", 1e9},    {"gsa/s", 1e9},
     {"sps", 1},     {"ksps", 1e3}, {"1/s", 1},     {"samples/s", 1}, {"samples/sec", 1}}};

std::string plain(std::string_view name) {
    std::string letters;
    for (const char letter : name) {
        if (letter != '_' && letter != ' ' && letter != '-') {
            const bool upper = letter >= 'A' && letter <= 'Z';
            letters += static_cast<char>(upper ? letter - 'A' + 'a' : letter);
        }
    }
    return letters;
}

template <std::size_t n>
bool holds(const std::array<std::string_view, n>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::optional<double> rate_by_name(std::string_view name, double value, std::string_view unit) {
    const std::string letters = plain(name);
    const bool is_rate = holds(rate_names, letters);
    if (!is_rate && !holds(step_names, letters)) {
        return {};
    }
    const auto factor = unit.empty() ? std::optional(1.0)
                        : is_rate    ? hertz_per(unit)
                                     : seconds_per(unit);
    if (!factor) {
        return {};
    }
    const double rate = is_rate ? value * *factor : 1 / (value * *factor);
    return std::isfinite(rate) && rate > 0 ? std::optional(rate) : std::nullopt;
}

std::optional<double> hertz_per(std::string_view unit) {
    const std::string small = lower_text(unit);
    const auto found = std::ranges::find(rate_units, std::string_view(small), &RateUnit::name);
    return found == rate_units.end() ? std::nullopt : std::optional(found->hertz);
}

std::string_view last_name(std::string_view path) {
    const std::size_t separator = path.find_last_of("./");
    return separator == std::string_view::npos ? path : path.substr(separator + 1);
}

}  // namespace vybeg
