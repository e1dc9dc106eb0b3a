#pragma once

#include "core/analysis/logs.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/passport.h"
#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"
#include "core/resonator/model/power_run.h"

#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace vybeg {

// The hash of a recording, made beside other work by a thread of its own, or, where there is to be
// one thread alone, when it is asked for. The thread stops where the object goes.
class BackgroundHash {
public:
    BackgroundHash(const Recording& recording, int threads, std::stop_token stop);
    ~BackgroundHash() { given_up_.request_stop(); }
    BackgroundHash(const BackgroundHash&) = delete;
    BackgroundHash& operator=(const BackgroundHash&) = delete;

    Result<std::string> get() { return hash_.get(); }

private:
    std::stop_source given_up_;
    std::stop_callback<std::function<void()>> interrupted_;
    std::future<Result<std::string>> hash_;
};

// The one road from the recordings of a set to its resonator: identify, compare, batch, report and
// window take it.

// A set whose recordings are open, and the passport that it is compared with.
struct OpenSet {
    MeasurementSet set;
    std::vector<Recording> recordings;  // of the set, in its order
    std::vector<PowerRun> logs;         // in place of recordings
    std::vector<PhasorLog> phasors;     // likewise
    std::optional<PassportComparison> comparison;
};

// A passport, before its comparison. Errors: those of read_passport_file() and file_sha256().
Result<PassportComparison> open_passport(const std::string& path, const JobControl& job);

// Opens the recordings, or reads the logs of a set of logs, and, unless `passport` is empty, that
// file. Errors: conditions_differ, those of open_recording(), open_passport() and
// read_contents().
Result<OpenSet> open_set(const MeasurementSet& set, const std::string& passport,
                         std::stop_token stop);

// Start, length and sampling rate of the recording that is open.
void set_extent(RecordingRef& told, const Recording& recording);

// Reads the contents of the recordings into the set; hashes those without a SHA-256, all beside
// each other. Of a set of logs it reads these, too. Errors: same_recording where two have the same
// file content and the same two channels, those of recording_sha256(), read_phasor_log() and
// read_power_log().
Status read_contents(OpenSet& open, std::stop_token stop);

// Precondition: read_contents(). Errors: those of identify(), file_changed.
Result<SetResult> identify_set(const OpenSet& open, const std::string& program,
                               const CompareOptions& compare, const JobControl& job);

// Warnings of the recordings alone, and of the result.
std::vector<NamedWarnings> warnings_of(const OpenSet& open);
std::vector<NamedWarnings> warnings_of(const OpenSet& open, const SetResult& result);

}  // namespace vybeg
