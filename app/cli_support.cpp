#include "app/cli_support.h"

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

Result<std::optional<OutputFile>> open_named(const std::string& name, const JobControl& job) {
    if (name.empty()) {
        return std::optional<OutputFile>();
    }
    auto file = TRY(open_output(name, job));
    return std::optional(std::move(file));
}

Status write_text(const std::string& text, const JobControl& job) {
    OutputFile output = OutputFile::onto(STDOUT_FILENO, "standard output", job);
    TRY(output.write(text));
    return output.commit();
}

}  // namespace vybeg::cli
