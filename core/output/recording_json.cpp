#include "core/output/recording_json.h"

#include "core/base/diagnostic.h"
#include "core/base/number_text.h"
#include "core/output/quantity_json.h"

namespace vybeg {

std::string recording_json(const Recording& recording, const std::string& sha256,
                           std::span<const Diagnostic> findings) {
    Json channels = Json::array();
    for (const Channel& channel : recording.channels) {
        channels.push_back({{"name", channel.name}, {"unit", channel.unit}});
    }
    Json check = Json::array();
    for (const Diagnostic& diagnostic : findings) {
        check.push_back({{"kind", kind_name(diagnostic.kind)},
                         {"severity", severity_name(severity(diagnostic.kind))},
                         {"first_frame", diagnostic.first_frame},
                         {"count", diagnostic.count},
                         {"text", english(diagnostic)}});
    }
    // Of times it is a quotient, whose last digits are those of the machine: 33332.99999999999.
    constexpr int digits_of_times = 12;
    const double rate_hz = recording.rate_from == RateOrigin::time_column
                               ? *parse_number(short_text(recording.rate_hz, digits_of_times))
                               : recording.rate_hz;
    Json info{{"format", english(recording.format)},
              {"frames", recording.frames()},
              {"seconds", recording.seconds()},
              {"rate_hz", rate_hz},
              {"rate_from", rate_origin_name(recording.rate_from)},
              {"channels", channels},
              {"start", recording.start},
              {"sha256", sha256},
              {"check", check}};
    if (recording.rate_relative_sd > 0) {
        info["rate_relative_sd"] = recording.rate_relative_sd;
    }
    return json_text(info);
}

}  // namespace vybeg
