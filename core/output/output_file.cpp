#include "core/output/output_file.h"

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/base/read_value.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/text_fields.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace vybeg {
namespace {

std::optional<struct stat> status_of(const std::filesystem::path& path) {
    struct stat status {};
    const int failed = path == "-" ? fstat(STDOUT_FILENO, &status) : stat(path.c_str(), &status);
    return failed == 0 ? std::optional(status) : std::nullopt;
}

bool is_null_device(const struct stat& status) {
    return S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
}

// The first link of a path without others, which thus leads nowhere, and what comes after it;
// empty: there is none.
std::pair<std::filesystem::path, std::filesystem::path> link_to_nowhere(
    const std::filesystem::path& path) {
    std::filesystem::path link;
    for (auto part = path.begin(); part != path.end(); ++part) {
        link /= *part;
        std::error_code unknown;
        if (is_symlink(symlink_status(link, unknown))) {
            std::filesystem::path rest;
            for (++part; part != path.end(); ++part) {
                rest /= *part;
            }
            return {link, rest};
        }
    }
    return {};
}

// The file that a path leads to, also where it does not exist yet: without links, of which one, to
// a file or a folder, may lead nowhere. `failed`: why this is unknown.
std::filesystem::path end_of_links(const std::filesystem::path& path, std::error_code& failed) {
    constexpr int most_links = 40;  // as the system follows
    std::filesystem::path end = weakly_canonical(absolute(path, failed), failed);
    for (int links = 0; !failed; ++links) {
        const auto [link, rest] = link_to_nowhere(end);
        if (link.empty()) {
            break;
        }
        if (links == most_links) {
            failed = std::make_error_code(std::errc::too_many_symbolic_link_levels);
            break;
        }
        const std::filesystem::path target = link.parent_path() / read_symlink(link, failed);
        end = weakly_canonical(rest.empty() ? target : target / rest, failed);
    }
    // That there is no file at the end is no failure.
    if (failed == std::errc::no_such_file_or_directory) {
        failed.clear();
    }
    return end;
}

constexpr std::string_view prefix = ".vybeg-";
constexpr std::string_view ending = ".part";

// Start of a process in clock ticks since the system's; empty without such a process or without
// /proc. It is the 22nd field of `stat`, the 20th after the name in brackets.
std::optional<std::int64_t> start_of(std::int64_t process) {
    std::ifstream file("/proc/" + integer_text(process) + "/stat");
    // Of a process that ends meanwhile the reading fails, which an iterator would throw.
    std::string text;
    std::getline(file, text, '\0');
    std::size_t at = text.rfind(')');
    for (int field = 0; field < 20 && at != std::string::npos; ++field) {
        at = text.find(' ', at + 1);
    }
    if (at == std::string::npos) {
        return {};
    }
    return whole_number<std::int64_t>(
        std::string_view(text).substr(at + 1, text.find(' ', at + 1) - at - 1));
}

struct Owner {
    std::int64_t process = 0;
    std::optional<std::int64_t> start;  // none in names of earlier versions: PID-N
};

// Owner of a temporary file by its name; empty for other names.
std::optional<Owner> owner_of(std::string_view name) {
    if (!name.starts_with(prefix) || !name.ends_with(ending)) {
        return {};
    }
    name.remove_prefix(prefix.size());
    name.remove_suffix(ending.size());
    std::vector<std::int64_t> numbers;
    for (const std::string_view part : parts_between(name, '-')) {
        numbers.push_back(whole_number<std::int64_t>(part).value_or(-1));
    }
    if (numbers.size() < 2 || numbers.size() > 3 || std::ranges::min(numbers) < 0) {
        return {};
    }
    return Owner{numbers[0], numbers.size() == 3 ? std::optional(numbers[1]) : std::nullopt};
}

bool lives(const Owner& owner) {
    // A process of another user exists as well (EPERM).
    if (owner.process > 0 && kill(static_cast<pid_t>(owner.process), 0) != 0 && errno == ESRCH) {
        return false;
    }
    const auto start = start_of(owner.process);
    return !owner.start || !start || *owner.start == 0 || *owner.start == *start;
}

constexpr std::size_t buffer_size = std::size_t{1} << 20;
constexpr std::size_t least_direct = std::size_t{1} << 17;  // bytes written without the buffer
// Bytes after which the disk begins to write, so that the final wait is short.
constexpr std::int64_t written_behind = std::int64_t{1} << 23;
// Bytes that a pipe accepts without blocking if poll() reports it as writable (PIPE_BUF).
constexpr std::size_t pipe_chunk = 4096;
constexpr int poll_ms = 50;

Error failure_of(const std::string& name, int error) {
    return {ErrorCode::output_failed, name, {system_reason(error)}};
}

}  // namespace

std::optional<FilePlace> place_of(const std::filesystem::path& path) {
    std::error_code failed;
    std::filesystem::path folder = end_of_links(path, failed);
    std::filesystem::path name;
    while (!failed && folder.has_relative_path()) {
        name = name.empty() ? folder.filename() : folder.filename() / name;
        folder = folder.parent_path();
        if (const auto status = status_of(folder)) {
            return FilePlace{status->st_dev, status->st_ino, name};
        }
    }
    return {};
}

bool same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
    const auto first = status_of(one);
    const auto second = status_of(other);
    if (first && second) {
        return first->st_dev == second->st_dev && first->st_ino == second->st_ino &&
               !is_null_device(*first);
    }
    if (first || second || one == "-" || other == "-" || one.empty() || other.empty()) {
        return one == other && one == "-";
    }
    const auto new_one = place_of(one);
    const auto new_other = place_of(other);
    return new_one && new_other ? *new_one == *new_other : one == other;
}

std::string file_ending(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return ending;
}

Status check_ending(const std::filesystem::path& path,
                    std::initializer_list<std::string_view> endings) {
    const std::string ending = file_ending(path);
    if (std::ranges::find(endings, ending) != endings.end()) {
        return {};
    }
    return Error{ErrorCode::output_format_unknown, path.string(), {ending, joined(endings, ", ")}};
}

void add_recording_files(std::vector<InputPath>& inputs, const std::filesystem::path& recording,
                         const OpenOptions& open) {
    std::vector<std::filesystem::path> files = further_files(open);
    files.push_back(recording);
    for (const std::filesystem::path& file : files) {
        inputs.push_back({file.string(), Phrase::tr("it is one of the recordings")});
    }
}

Status check_outputs(const std::vector<OutputPath>& outputs, const std::vector<InputPath>& inputs) {
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        const OutputPath& output = outputs[k];
        if (output.path.empty()) {
            continue;
        }
        const auto refused = [&output](const MessageArg& reason) {
            return refused_value(output.option, output.path, reason);
        };
        for (const InputPath& input : inputs) {
            if (!input.path.empty() && same_file(input.path, output.path)) {
                return refused(input.taken);
            }
        }
        for (std::size_t earlier = 0; earlier < k; ++earlier) {
            if (!outputs[earlier].path.empty() && same_file(outputs[earlier].path, output.path)) {
                return refused(outputs[earlier].taken);
            }
        }
    }
    return {};
}

TemporaryFile make_temporary(const std::filesystem::path& folder) {
    const std::int64_t process = getpid();
    const std::string own = std::string(prefix) + integer_text(process) + "-" +
                            integer_text(start_of(process).value_or(0)) + "-";
    for (std::int64_t attempt = 0;; ++attempt) {
        TemporaryFile file{Descriptor(), 0,
                           folder / (own + integer_text(attempt) + std::string(ending))};
        file.descriptor =
            Descriptor(open(file.path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (!file.descriptor) {
            if (errno == EEXIST) {
                continue;
            }
            file.error = errno;
            return file;
        }
        // On a file system without locks the process number alone decides.
        flock(file.descriptor.get(), LOCK_EX | LOCK_NB);
        struct stat status {};
        if (fstat(file.descriptor.get(), &status) == 0 && status.st_nlink > 0) {
            return file;
        }
        // It was removed as abandoned before it was locked.
    }
}

void remove_abandoned(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::directory_iterator entries(folder.empty() ? "." : folder, failed);
    for (; !failed && entries != std::filesystem::directory_iterator(); entries.increment(failed)) {
        const std::filesystem::path path = entries->path();
        const auto owner = owner_of(path.filename().string());
        if (!owner || lives(*owner)) {
            continue;
        }
        const Descriptor descriptor(
            open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        struct stat status {};
        if (fstat(descriptor.get(), &status) == 0 && S_ISREG(status.st_mode) &&
            flock(descriptor.get(), LOCK_EX | LOCK_NB) == 0) {
            unlink(path.c_str());
        }
    }
}

Result<OutputFile> OutputFile::create(const std::filesystem::path& target, const JobControl& job) {
    const std::string name = target.string();
    struct stat existing {};
    const bool exists = stat(target.c_str(), &existing) == 0;
    if (exists && S_ISDIR(existing.st_mode)) {
        return failure_of(name, EISDIR);
    }
    if (exists && !S_ISREG(existing.st_mode)) {
        // Without O_NONBLOCK, opening a pipe without reader would block and ignore cancellation.
        Descriptor own(open(target.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
        if (!own) {
            return failure_of(name, errno);
        }
        fcntl(own.get(), F_SETFL, fcntl(own.get(), F_GETFL) & ~O_NONBLOCK);
        OutputFile file(own.get(), name, job);
        file.own_ = std::move(own);
        return file;
    }
    std::error_code unresolved;
    std::filesystem::path resolved = end_of_links(target, unresolved);
    if (unresolved) {
        return failure_of(name, unresolved.value());
    }
    // rename() checks the permissions of the folder only; a write-protected file must stay
    // protected.
    if (exists && faccessat(AT_FDCWD, resolved.c_str(), W_OK, AT_EACCESS) != 0) {
        return failure_of(name, errno);
    }
    const std::filesystem::path folder = resolved.parent_path();
    remove_abandoned(folder);
    TemporaryFile temporary = make_temporary(folder);
    if (!temporary.descriptor) {
        return failure_of(name, temporary.error);
    }
    OutputFile file(temporary.descriptor.get(), name, job);
    file.own_ = std::move(temporary.descriptor);
    file.target_ = std::move(resolved);
    file.temporary_ = std::move(temporary.path);
    if (exists && fchmod(file.descriptor_, existing.st_mode & 07777) != 0) {
        return failure_of(name, errno);
    }
    return file;
}

OutputFile OutputFile::onto(int descriptor, std::string name, const JobControl& job) {
    return {descriptor, std::move(name), job};
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      own_(std::move(other.own_)),
      name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      buffer_(std::move(other.buffer_)),
      bytes_out_(other.bytes_out_),
      sent_to_disk_(other.sent_to_disk_),
      placed_(std::exchange(other.placed_, Placed::no)),
      job_(std::move(other.job_)) {}

OutputFile::~OutputFile() {
    discard();
}

void OutputFile::discard() noexcept {
    own_.close();
    if (!temporary_.empty()) {
        unlink(temporary_.c_str());
        temporary_.clear();
    }
}

Status OutputFile::wait_until_writable() const {
    for (;;) {
        if (job_.cancelled()) {
            return as_it_stands({ErrorCode::interrupted, {}, {}});
        }
        pollfd waiting{descriptor_, POLLOUT, 0};
        const int ready = poll(&waiting, 1, poll_ms);
        if (ready > 0) {
            return {};  // also for a broken pipe; write() then reports it
        }
        if (ready < 0 && errno != EINTR) {
            return failed(errno);
        }
    }
}

Status OutputFile::write(std::string_view bytes) {
    // Large pieces are written without copying.
    if (bytes.size() >= least_direct) {
        TRY(flush());
        return write_out(bytes);
    }
    buffer_.append(bytes);
    return buffer_.size() < buffer_size ? Status{} : flush();
}

Status OutputFile::flush() {
    TRY(write_out(buffer_));
    buffer_.clear();
    return {};
}

Status OutputFile::write_out(std::string_view left) {
    while (!left.empty()) {
        TRY(wait_until_writable());
        const std::size_t chunk = seekable() ? left.size() : std::min(left.size(), pipe_chunk);
        const ssize_t written = ::write(descriptor_, left.data(), chunk);
        if (written < 0 && errno != EINTR && errno != EAGAIN) {
            return failed(errno);
        }
        bytes_out_ += std::max<ssize_t>(written, 0);
        if (seekable() && bytes_out_ - sent_to_disk_ >= written_behind) {
            // A hint; fsync() reports errors.
            sync_file_range(descriptor_, sent_to_disk_, bytes_out_ - sent_to_disk_,
                            SYNC_FILE_RANGE_WRITE);
            sent_to_disk_ = bytes_out_;
        }
        left.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return {};
}

// All steps that can fail before the rename.
Status OutputFile::settle() {
    TRY(flush());
    // fsync also reports delayed errors of the disk.
    return !seekable() || fsync(descriptor_) == 0 ? Status{} : failed(errno);
}

// Moves the file to its target. `returnable`: an old file is kept under the temporary name until
// all files of a group are in place.
Status OutputFile::take_place(bool returnable) {
    if (!seekable()) {
        return {};
    }
    // close() reports errors of a network drive; a copy of the descriptor keeps the lock.
    Descriptor copy(fcntl(descriptor_, F_DUPFD_CLOEXEC, 0));
    if (own_.close() != 0) {
        return failed(errno);
    }
    descriptor_ = copy.get();
    own_ = std::move(copy);
    if (returnable &&
        renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
        placed_ = Placed::exchanged;
        return {};
    }
    const bool first = access(target_.c_str(), F_OK) != 0;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
        return failed(errno);
    }
    placed_ = returnable && first ? Placed::new_name : Placed::for_good;
    return {};
}

// Restores the state of the target before take_place().
void OutputFile::leave_place() noexcept {
    if (placed_ == Placed::exchanged) {
        renameat2(AT_FDCWD, target_.c_str(), AT_FDCWD, temporary_.c_str(), RENAME_EXCHANGE);
    } else if (placed_ == Placed::new_name) {
        std::rename(target_.c_str(), temporary_.c_str());
    }
    placed_ = Placed::no;
}

Status OutputFile::commit() {
    return commit_together(std::array{this});
}

Status OutputFile::commit_together(std::span<OutputFile* const> files) {
    // Files written directly come last: until the first of them begins, no effect is visible, and
    // after it the others follow.
    for (OutputFile* file : files) {
        TRY(file->seekable() ? file->settle() : Status{});
    }
    for (const OutputFile* file : files) {
        if (file->job_.cancelled()) {
            return file->as_it_stands({ErrorCode::interrupted, {}, {}});
        }
    }
    for (OutputFile* file : files) {
        TRY(file->seekable() ? Status{} : file->settle());
    }
    std::string standing;  // files in place, on a file system that cannot exchange two names
    for (std::size_t k = 0; k < files.size(); ++k) {
        const Status placed = files[k]->take_place(files.size() > 1);
        if (!placed) {
            for (std::size_t before = k; before > 0; --before) {
                files[before - 1]->leave_place();
            }
            return standing.empty()
                       ? placed
                       : files[k]->failure(
                             Phrase::tr("%1 (%2 was written)", {placed.error().args[0], standing}));
        }
        if (files[k]->placed_ == Placed::for_good) {
            standing += (standing.empty() ? "" : ", ") + files[k]->name_;
        }
    }
    for (OutputFile* file : files) {
        if (file->placed_ != Placed::exchanged) {
            file->temporary_.clear();
        }
        file->discard();  // removes the old file of an exchange
        file->placed_ = Placed::no;
    }
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

Error OutputFile::failure(MessageArg reason) const {
    return {partly_out() ? ErrorCode::output_incomplete : ErrorCode::output_failed,
            name_,
            {std::move(reason)}};
}

Error OutputFile::failed(int error) const {
    return failure(system_reason(error));
}

Error OutputFile::as_it_stands(const Error& error) const {
    return error.code == ErrorCode::interrupted && partly_out()
               ? Error{ErrorCode::interrupted_partly, name_, {}}
               : error;
}

Result<OutputFile> open_output(const std::string& name, const JobControl& job) {
    return name == "-" ? OutputFile::onto(STDOUT_FILENO, "standard output", job)
                       : OutputFile::create(name, job);
}

Status write_file(const std::filesystem::path& target, std::string_view bytes,
                  const JobControl& job) {
    auto file = TRY(OutputFile::create(target, job));
    TRY(file.write(bytes));
    return file.commit();
}

}  // namespace vybeg
