#include "core/batch/set_identification.h"

#include "core/analysis/idle_options.h"
#include "core/analysis/set_conditions.h"
#include "core/batch/hash_beside.h"
#include "core/output/passport_json.h"
#include "core/recording/bytes/sha256.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/file_changes.h"

#include <list>

namespace vybeg {
namespace {

Status open_passport(const std::string& path, OpenSet& open, const JobControl& job) {
    auto passport = TRY(read_passport_file(path));
    const auto sha256 = TRY(file_sha256(path, job));
    open.passport = std::move(passport);
    open.comparison = PassportComparison{path, sha256, open.passport->program, {}};
    return {};
}

// All hashes beside each other.
Result<std::vector<std::string>> hashes_of(const std::vector<Recording>& recordings, int threads,
                                           std::stop_token stop) {
    std::list<HashBeside> beside;
    for (const Recording& recording : recordings) {
        beside.emplace_back(recording, threads, stop);
    }
    std::vector<std::string> hashes;
    for (; !beside.empty(); beside.pop_front()) {
        auto sha256 = TRY(beside.front().get());
        hashes.push_back(std::move(sha256));
    }
    return hashes;
}

Status all_unchanged(const std::vector<Recording>& recordings) {
    for (const Recording& recording : recordings) {
        TRY(unchanged(recording));
    }
    return {};
}

}  // namespace

Result<OpenSet> open_set(const MeasurementSet& set, const std::string& passport,
                         std::stop_token stop) {
    OpenSet open;
    TRY(check_conditions(set));
    if (!passport.empty()) {
        TRY(open_passport(passport, open, JobControl(stop)));
    }
    for (const ListedRecording& listed : set.recordings) {
        auto recording = TRY(open_recording(listed.path, listed.open, JobControl(stop)));
        open.recordings.push_back(std::move(recording));
    }
    const auto hashes = TRY(hashes_of(open.recordings, set.settings.threads, stop));
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        const Recording& recording = open.recordings[k];
        open.told.push_back({recording.path.filename().string(), hashes[k], recording.start,
                             recording.seconds(), recording.rate_hz, 0});
    }
    TRY(check_distinct(open.recordings, hashes));
    return open;
}

Result<IdentifiedSet> identify_set(OpenSet& open, const MeasurementSet& set,
                                   const CompareOptions& compare, const JobControl& job) {
    Result<Identification> found = identify(open.recordings, set.settings, job);
    TRY(all_unchanged(open.recordings));
    if (!found) {
        return found.error();
    }
    IdentifiedSet result{std::move(*found), {}};
    if (open.comparison) {
        open.comparison->differences = vybeg::compare(*open.passport, result.found.fit, compare);
        if (const auto other = other_gyro(*open.passport, gyro_of(set))) {
            result.found.fit.warnings.push_back(*other);
        }
    }
    result.warnings.emplace_back("", result.found.fit.warnings);
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        const IdentifiedRun& run = result.found.runs[k];
        open.told[k].f0_hz = run.f0_hz;
        result.warnings.emplace_back(open.told[k].name, run.diagnostics);
    }
    result.warnings.emplace_back("", without_effect(set.settings));
    for (std::size_t k = 0; k < open.recordings.size(); ++k) {
        result.warnings.emplace_back(open.told[k].name,
                                     without_effect(set.recordings[k].open, open.recordings[k]));
    }
    return result;
}

std::vector<NamedWarnings> warnings_of(const OpenSet& open) {
    std::vector<NamedWarnings> warnings;
    for (const Recording& recording : open.recordings) {
        warnings.emplace_back(recording.path.filename().string(), recording.diagnostics);
    }
    return warnings;
}

}  // namespace vybeg
