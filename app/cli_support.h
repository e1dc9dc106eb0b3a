#pragma once

#include "app/cli_log.h"
#include "core/base/job_control.h"
#include "core/output/output_file.h"
#include "core/recording/samples/recording.h"

#include <functional>
#include <future>
#include <stop_token>
#include <string>

namespace vybeg::cli {

// What the subcommands share.

// A monotonic clock, seconds.
double seconds_now();

// The longest part of the work, with its progress in the log.
JobControl job_of(std::stop_token stop, Log& log);
// Everything else: heard when it is to stop, without its own progress.
JobControl silent_job(std::stop_token stop);

// A file, or standard output for "-".
Result<OutputFile> open_output(const std::string& name, const JobControl& job);
// Text to standard output.
Status write_text(const std::string& text, const JobControl& job);

// The hash of a recording, made beside other work by a thread of its own, or, where there is to be
// one thread alone, when it is asked for. The thread stops where the object goes.
class HashBeside {
public:
    HashBeside(const Recording& recording, int threads, std::stop_token stop);
    ~HashBeside() { given_up_.request_stop(); }
    HashBeside(const HashBeside&) = delete;
    HashBeside& operator=(const HashBeside&) = delete;

    Result<std::string> get() { return hash_.get(); }

private:
    std::stop_source given_up_;
    std::stop_callback<std::function<void()>> interrupted_;
    std::future<Result<std::string>> hash_;
};

}  // namespace vybeg::cli
