#include "core/report/output_file.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;
// A pipe that poll() calls writable takes this much without blocking (PIPE_BUF).
constexpr std::size_t pipe_chunk = 4096;
constexpr int poll_ms = 50;

std::string system_reason(int error) {
    return std::generic_category().message(error);
}

Error failed(const std::string& name, int error) {
    return {ErrorCode::output_failed, name, {system_reason(error)}};
}

// A name of its own beside the target; short, so that it fits wherever the target's name does.
std::filesystem::path temporary_name(const std::filesystem::path& target, int attempt) {
    return target.parent_path() /
           (".vybeg-" + integer_text(getpid()) + "-" + integer_text(attempt) + ".part");
}

}  // namespace

Result<OutputFile> OutputFile::create(const std::filesystem::path& target, const JobControl& job) {
    const std::string name = target.string();
    struct stat existing {};
    const bool exists = stat(target.c_str(), &existing) == 0;
    if (exists && S_ISDIR(existing.st_mode)) {
        return failed(name, EISDIR);
    }
    if (exists && !S_ISREG(existing.st_mode)) {
        // Without O_NONBLOCK a pipe without a reader would hang here, deaf to the stop token.
        const int descriptor = open(target.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) {
            return failed(name, errno);
        }
        fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
        OutputFile file(descriptor, name, job);
        file.owned_ = true;
        return file;
    }
    std::error_code unresolved;
    std::filesystem::path resolved = std::filesystem::weakly_canonical(target, unresolved);
    if (unresolved) {
        return failed(name, unresolved.value());
    }
    // rename() asks only the folder; a file protected against writing must stay protected.
    if (exists && faccessat(AT_FDCWD, resolved.c_str(), W_OK, AT_EACCESS) != 0) {
        return failed(name, errno);
    }
    std::filesystem::path temporary;
    int descriptor = -1;
    for (int attempt = 0; descriptor < 0; ++attempt) {
        temporary = temporary_name(resolved, attempt);
        descriptor = open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0 && errno != EEXIST) {
            return failed(name, errno);
        }
    }
    OutputFile file(descriptor, name, job);
    file.owned_ = true;
    file.target_ = std::move(resolved);
    file.temporary_ = std::move(temporary);
    if (exists && fchmod(descriptor, existing.st_mode & 07777) != 0) {
        return failed(name, errno);
    }
    return file;
}

OutputFile OutputFile::onto(int descriptor, std::string name, const JobControl& job) {
    return {descriptor, std::move(name), job};
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      owned_(std::exchange(other.owned_, false)),
      name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      buffer_(std::move(other.buffer_)),
      job_(std::move(other.job_)) {}

OutputFile::~OutputFile() {
    discard();
}

void OutputFile::discard() noexcept {
    if (owned_) {
        close(descriptor_);
        owned_ = false;
    }
    if (!temporary_.empty()) {
        unlink(temporary_.c_str());
        temporary_.clear();
    }
}

Status OutputFile::wait_until_writable() const {
    for (;;) {
        if (job_.cancelled()) {
            return Error{ErrorCode::interrupted, {}, {}};
        }
        pollfd waiting{descriptor_, POLLOUT, 0};
        const int ready = poll(&waiting, 1, poll_ms);
        if (ready > 0) {
            return {};  // also where the pipe is broken: write() then says so
        }
        if (ready < 0 && errno != EINTR) {
            return failed(name_, errno);
        }
    }
}

Status OutputFile::write(std::string_view bytes) {
    buffer_.append(bytes);
    return buffer_.size() < buffer_size ? Status{} : flush();
}

Status OutputFile::flush() {
    std::string_view left = buffer_;
    while (!left.empty()) {
        if (const Status ready = wait_until_writable(); !ready) {
            return ready;
        }
        const std::size_t chunk = seekable() ? left.size() : std::min(left.size(), pipe_chunk);
        const ssize_t written = ::write(descriptor_, left.data(), chunk);
        if (written < 0 && errno != EINTR && errno != EAGAIN) {
            return failed(name_, errno);
        }
        left.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    buffer_.clear();
    return {};
}

Status OutputFile::commit() {
    if (const Status flushed = flush(); !flushed) {
        return flushed;
    }
    if (job_.cancelled()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    if (!seekable()) {
        return {};
    }
    // fsync also reports what the disk refused late, and close() what a network drive did.
    if (fsync(descriptor_) != 0) {
        return failed(name_, errno);
    }
    owned_ = false;
    if (close(descriptor_) != 0 || std::rename(temporary_.c_str(), target_.c_str()) != 0) {
        return failed(name_, errno);
    }
    temporary_.clear();
    return {};
}

std::filesystem::path OutputFile::spool_folder() const {
    std::error_code missing;
    if (!seekable()) {
        return std::filesystem::temp_directory_path(missing);
    }
    const std::filesystem::path folder = temporary_.parent_path();
    return folder.empty() ? "." : folder;
}

Error OutputFile::failure(std::string reason) const {
    return {ErrorCode::output_failed, name_, {std::move(reason)}};
}

}  // namespace vybeg
