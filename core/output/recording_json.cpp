#include "core/output/recording_json.h"

#include "core/base/diagnostic.h"
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
    Json info{{"format", english(recording.format)},
              {"frames", recording.frames()},
              {"seconds", recording.seconds()},
              {"rate_hz", recording.rate_hz},
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
