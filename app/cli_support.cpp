#include "app/cli_support.h"

#include "core/recording/bytes/sha256.h"
#include "core/recording/samples/file_changes.h"

#include <chrono>
#include <unistd.h>
#include <utility>

namespace vybeg::cli {

double seconds_now() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

JobControl job_of(std::stop_token stop, Log& log) {
    return JobControl(
        std::move(stop), [&log](double fraction) { log.progress(fraction); }, seconds_now);
}

JobControl silent_job(std::stop_token stop) {
    return JobControl(std::move(stop), {}, seconds_now);
}

Result<OutputFile> open_output(const std::string& name, const JobControl& job) {
    if (name == "-") {
        return OutputFile::onto(STDOUT_FILENO, "standard output", job);
    }
    return OutputFile::create(name, job);
}

Status write_text(const std::string& text, const JobControl& job) {
    OutputFile output = OutputFile::onto(STDOUT_FILENO, "standard output", job);
    if (const Status written = output.write(text); !written) {
        return written;
    }
    return output.commit();
}

namespace {

std::future<Result<std::string>> hash_of(const Recording& recording, int threads,
                                         std::stop_token stop) {
    prepare_sha256();
    return std::async(threads == 1 ? std::launch::deferred : std::launch::async,
                      [&recording, job = silent_job(std::move(stop))] {
                          return recording_sha256(recording, job);
                      });
}

}  // namespace

HashBeside::HashBeside(const Recording& recording, int threads, std::stop_token stop)
    : interrupted_(std::move(stop), [this] { given_up_.request_stop(); }),
      hash_(hash_of(recording, threads, given_up_.get_token())) {}

}  // namespace vybeg::cli
