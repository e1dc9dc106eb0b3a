#include "core/database/stored_result.h"

#include "core/analysis/list_fields.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/output/identify_json.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/open_table.h"
#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace vybeg {
namespace {

std::string settings_text(IdentifySettings settings) {
    settings.threads = 0;
    settings.of_recordings.clear();
    std::string text;
    for (const auto& [name, value] : settings_list(settings)) {
        add_part(text, name);
        add_part(text, value);
    }
    return text;
}

Result<std::string> result_key(const MeasurementSet& set) {
    std::vector<std::string> each;
    for (std::size_t k = 0; k < set.recordings.size(); ++k) {
        const OpenOptions& open = set.recordings[k].open;
        IdentifySettings own = set.settings;
        own.signal = set.settings.signal_of(k);
        std::string text;
        for (const std::string& part :
             {set.recordings[k].sha256, integer_text(open.channel_c), integer_text(open.channel_d),
              options_text(open), open.rate_hz ? round_trip_text(*open.rate_hz) : std::string(),
              settings_text(own)}) {
            add_part(text, part);
        }
        each.push_back(text);
    }
    std::ranges::sort(each);
    std::string whole;
    add_part(whole, settings_text(set.settings));
    for (const std::string& text : each) {
        add_part(whole, text);
    }
    return text_sha256(whole);
}

std::filesystem::path absolute_path(const std::filesystem::path& path) {
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::absolute(path, failed);
    return (failed ? path : whole).lexically_normal();
}

std::vector<StoredParameter> parameters_of(const ResonatorFit& fit) {
    std::vector<StoredParameter> parameters;
    parameters.reserve(resonator_parameters.size() + fit.modes.size() * mode_parameters.size());
    for (const ResonatorParameter& parameter : resonator_parameters) {
        parameters.push_back({parameter.name, fit.resonator.*parameter.member});
    }
    for (std::size_t k = 0; k < fit.modes.size(); ++k) {
        for (const ModeParameter& parameter : mode_parameters) {
            parameters.push_back({"modes[" + std::to_string(k) + "]." + parameter.name,
                                  fit.modes[k].*parameter.member});
        }
    }
    return parameters;
}

}  // namespace

StoredDate date_of(const MeasurementSet& set) {
    if (const std::string date = list_date_of(set); !date.empty()) {
        return {date, DateSource::list};
    }
    for (const RecordingRef& recording : set.recordings) {
        if (is_iso_date(recording.start)) {
            return {recording.start, DateSource::recording};
        }
    }
    return {};
}

Result<StoredResult> stored_result(const SetResult& result, std::string json) {
    const MeasurementSet& set = result.set;
    const Identification& found = result.identification;
    auto key = TRY(result_key(set));
    StoredResult stored;
    stored.key = std::move(key);
    stored.set = set.name;
    stored.gyro = gyro_of(set);
    stored.date = date_of(set);
    stored.program = result.program;
    stored.model = found.fit.model == ResonatorModel::structured ? "structured" : "free";
    stored.warnings = warning_kinds(findings_of(found));
    stored.recordings = set.recordings;
    for (RecordingRef& recording : stored.recordings) {
        recording.path = absolute_path(recording.path);
        find_files_from(absolute_path("."), recording.open);
    }
    stored.parameters = parameters_of(found.fit);
    stored.raw = found.fit.raw;
    stored.json = std::move(json);
    return stored;
}

}  // namespace vybeg
