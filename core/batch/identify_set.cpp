#include "core/batch/identify_set.h"

#include "core/analysis/analyse_logs.h"
#include "core/analysis/ignored_options.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/prepare.h"
#include "core/base/job_control.h"
#include "core/base/number_text.h"
#include "core/base/read_value.h"
#include "core/output/passport_json.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/recording.h"

#include <limits>
#include <list>
#include <map>
#include <utility>

namespace vybeg {
namespace {

Status hash_all(OpenSet& open, std::stop_token stop) {
    std::list<std::pair<RecordingRef&, BackgroundHash>> beside;
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        if (RecordingRef& told = open.set.recordings[k]; told.sha256.empty()) {
            beside.emplace_back(
                std::piecewise_construct, std::forward_as_tuple(told),
                std::forward_as_tuple(open.recordings[k], open.set.settings.threads, stop));
        }
    }
    for (; !beside.empty(); beside.pop_front()) {
        auto& [told, hash] = beside.front();
        told.sha256 = TRY(hash.get());
    }
    return {};
}

// The content of a file and the two channels: no two recordings of a set may share them.
std::vector<std::string> signals_of(const RecordingRef& told, const Recording& recording) {
    std::vector<std::string> signals{told.sha256};
    for (const int channel : {recording.channel_c, recording.channel_d}) {
        const auto place = static_cast<std::size_t>(channel - 1);
        signals.push_back(integer_text(channel));
        signals.push_back(place < recording.channels.size() ? recording.channels[place].name : "");
    }
    return signals;
}

// No two logs of a set may be one file.
Status read_logs(OpenSet& open, const JobControl& job) {
    const LogChoice& choice = open.set.settings.logs;
    const bool of_phasors = choice.phasors.frame != PhasorFrame::none;
    std::map<std::string, std::string> known;
    for (std::size_t k = 0; k < open.set.recordings.size(); ++k) {
        RecordingRef& told = open.set.recordings[k];
        const LogFile file{told.path, told.open, choice, open.set.settings.signal_of(k), job};
        if (of_phasors) {
            auto log = TRY(read_phasor_log(file));
            open.phasors.push_back(std::move(log));
        } else {
            auto log = TRY(read_power_log(file));
            open.logs.push_back(std::move(log));
        }
        told.sha256 = TRY(file_sha256(told.path, job));
        const auto& time_s = of_phasors ? open.phasors.back().run.time_s : open.logs.back().time_s;
        const auto rows = static_cast<double>(time_s.size());
        told.seconds = rows > 0 ? time_s.back() - time_s.front() : 0;
        told.rate_hz = of_phasors ? open.phasors.back().rate_hz
                       : rows > 1 ? (rows - 1) / told.seconds
                                  : 0;
        told.f0_hz = of_phasors ? open.phasors.back().run.f_ref_hz
                                : std::numeric_limits<double>::quiet_NaN();
        const auto [same, is_new] = known.emplace(told.sha256, told.path.string());
        if (!is_new) {
            return Error{ErrorCode::same_recording, same->second, {told.path.string()}};
        }
    }
    return {};
}

// Of recordings, or of logs.
Result<Identification> identification_of(const OpenSet& open, const JobControl& job) {
    if (open.logs.empty() && open.phasors.empty()) {
        return identify(open.recordings, open.set.settings, job);
    }
    std::vector<std::string> names;
    for (const RecordingRef& told : open.set.recordings) {
        names.push_back(told.name());
    }
    return open.phasors.empty() ? identify_powers(open.logs, names, open.set.settings, job)
                                : identify_phasors(open.phasors, names, open.set.settings, job);
}

// The file of a channel D, or a further piece, belongs to one recording: with several files on the
// command line it would silently be that of all.
Status check_parts(const MeasurementSet& set) {
    std::map<std::pair<std::string, int>, const RecordingRef*> known;
    for (const RecordingRef& told : set.recordings) {
        const OpenOptions& open = told.open;
        std::vector<std::string> parts = open.join;
        if (!open.channel_d_file.empty()) {
            parts.push_back(open.channel_d_file);
        }
        for (const std::string& part : parts) {
            const int channel = open.channel_d_file.empty() ? 0 : open.channel_d;
            const auto [one, is_new] = known.emplace(std::pair{part, channel}, &told);
            if (!is_new && one->second != &told) {
                return refused_value(open.channel_d_file.empty() ? "--join" : "--channel-d", part,
                                     Phrase::tr("it would belong to several recordings. Name one "
                                                "for each in a measurement list"));
            }
        }
    }
    return {};
}

}  // namespace

BackgroundHash::BackgroundHash(const Recording& recording, int threads, std::stop_token stop)
    : interrupted_(std::move(stop), [this] { given_up_.request_stop(); }) {
    prepare_sha256();
    hash_ = std::async(threads == 1 ? std::launch::deferred : std::launch::async,
                       [&recording, job = JobControl(given_up_.get_token())] {
                           return recording_sha256(recording, job);
                       });
}

Result<PassportComparison> open_passport(const std::string& path, const JobControl& job) {
    auto passport = TRY(read_passport_file(path));
    auto sha256 = TRY(file_sha256(path, job));
    return PassportComparison{path, std::move(sha256), std::move(passport), {}};
}

Result<OpenSet> open_set(const MeasurementSet& set, const std::string& passport,
                         std::stop_token stop) {
    OpenSet open;
    open.set = set;
    TRY(check_conditions(set));
    TRY(check_parts(set));
    if (!passport.empty()) {
        open.comparison = TRY(open_passport(passport, JobControl(stop)));
    }
    for (const RecordingRef& listed : set.recordings) {
        if (!set.settings.logs.given()) {
            auto recording = TRY(open_recording(listed.path, listed.open, JobControl(stop)));
            open.recordings.push_back(std::move(recording));
        }
    }
    TRY(read_contents(open, stop));
    return open;
}

void set_extent(RecordingRef& told, const Recording& recording) {
    told.start = recording.start;
    told.seconds = recording.seconds();
    told.rate_hz = recording.rate_hz;
}

Status read_contents(OpenSet& open, std::stop_token stop) {
    if (open.set.settings.logs.given()) {
        return read_logs(open, JobControl(std::move(stop)));
    }
    TRY(hash_all(open, std::move(stop)));
    std::map<std::vector<std::string>, const Recording*> known;
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        const Recording& recording = open.recordings[k];
        RecordingRef& told = open.set.recordings[k];
        set_extent(told, recording);
        const auto [same, is_new] = known.emplace(signals_of(told, recording), &recording);
        if (!is_new) {
            return Error{ErrorCode::same_recording,
                         recording_name(*same->second),
                         {recording_name(recording)}};
        }
    }
    return {};
}

Result<SetResult> identify_set(const OpenSet& open, const std::string& program,
                               const CompareOptions& compare, const JobControl& job) {
    const double begun = job.now();
    Result<Identification> found = identification_of(open, job);
    for (const Recording& recording : open.recordings) {
        TRY(unchanged(recording));
    }
    if (!found) {
        return found.error();
    }
    SetResult result{program, open.set, std::move(*found), open.comparison};
    if (result.comparison) {
        const Passport& passport = result.comparison->passport;
        ResonatorFit& fit = result.identification.fit;
        result.comparison->differences = vybeg::compare(passport, fit, compare);
        if (const auto other = other_gyro(passport, gyro_of(open.set))) {
            fit.warnings.push_back(*other);
        }
    }
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        result.set.recordings[k].f0_hz = result.identification.runs[k].f0_hz;
    }
    result.seconds = job.now() - begun;
    return result;
}

std::vector<NamedWarnings> warnings_of(const OpenSet& open) {
    std::vector<NamedWarnings> warnings;
    for (const Recording& recording : open.recordings) {
        warnings.emplace_back(recording.path.filename().string(), recording.diagnostics);
    }
    return warnings;
}

std::vector<NamedWarnings> warnings_of(const OpenSet& open, const SetResult& result) {
    const std::vector<RecordingRef>& recordings = result.set.recordings;
    std::vector<NamedWarnings> warnings{{"", result.identification.fit.warnings}};
    for (std::size_t k = 0; k < recordings.size(); ++k) {
        warnings.emplace_back(recordings[k].name(), result.identification.runs[k].diagnostics);
    }
    warnings.emplace_back("", without_effect(result.set.settings));
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        warnings.emplace_back(recordings[k].name(),
                              without_effect(recordings[k].open, open.recordings[k]));
    }
    return warnings;
}

}  // namespace vybeg
