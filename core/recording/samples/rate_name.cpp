#include "core/recording/samples/rate_name.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace vybeg {
namespace {

constexpr std::array<std::string_view, 9> rate_names{
    "fs",           "sr",         "rate",    "samplerate",       "samplingrate",
    "samplingfreq", "samplefreq", "fsample", "samplingfrequency"};
constexpr std::array<std::string_view, 7> step_names{
    "dt",           "wfincrement",   "increment", "sampleinterval", "samplinginterval",
    "sampleperiod", "samplingperiod"};

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

std::optional<double> rate_by_name(std::string_view name, double value) {
    const std::string letters = plain(name);
    if (!holds(rate_names, letters) && !holds(step_names, letters)) {
        return {};
    }
    const double rate = holds(rate_names, letters) ? value : 1 / value;
    return std::isfinite(rate) && rate > 0 ? std::optional(rate) : std::nullopt;
}

std::string_view last_name(std::string_view path) {
    const std::size_t separator = path.find_last_of("./");
    return separator == std::string_view::npos ? path : path.substr(separator + 1);
}

}  // namespace vybeg
