#include "core/recording/variables/library_variables.h"

#include "core/base/guarded.h"
#include "core/base/message_arg.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <limits>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t most_text_bytes = std::int64_t{16} << 20;
constexpr int above_the_readers_descriptors = 10;
constexpr int slice_ms = 50;
constexpr int idle_slices = 400;  // 20 s

// Starts the helper with its descriptors, no other; an empty environment; signals as in a fresh
// program; in a process group of its own, so that Ctrl-C in a terminal reaches only the program.
// Returns 0, or the error's number.
int start_helper(const std::string& program, std::string kind, int socket, int file, pid_t& id) {
    std::string name = program;
    std::array<char*, 3> arguments{name.data(), kind.data(), nullptr};
#ifdef __SANITIZE_ADDRESS__  // its options come from there
    char** const environment = environ;
#else
    std::array<char*, 1> none{nullptr};
    char** const environment = none.data();
#endif
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, socket, reader_socket);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, file, reader_file);
    ::posix_spawn_file_actions_addclosefrom_np(&actions, reader_file + 1);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t signals;
    sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes, &signals);
    sigfillset(&signals);
    ::posix_spawnattr_setsigdefault(&attributes, &signals);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    const int number =
        ::posix_spawn(&id, program.c_str(), &actions, &attributes, arguments.data(), environment);
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
    return number;
}

// Beside the running program where that was built; apart from users' programs where it is
// installed.
std::filesystem::path helper_path(const std::string& name) {
    std::error_code ignored;  // without /proc the path is that of no program, and starting fails
    const std::filesystem::path folder =
        std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    const std::filesystem::path beside = folder / name;
    const std::filesystem::path installed =
        (folder / VYBEG_HELPER_FOLDER / name).lexically_normal();
    return !std::filesystem::exists(beside, ignored) && std::filesystem::exists(installed, ignored)
               ? installed
               : beside;
}

Error no_helper(const FileBytes& file, const std::string& program, int number) {
    return file.error(ErrorCode::reader_not_started, {program, system_reason(number)});
}

struct Started {
    Descriptor socket;
    pid_t id = 0;
};

// When it returns, our copies of the helper's end are closed: else its death would not be heard.
Result<Started> spawn(const FileBytes& file, const std::string& kind, const std::string& name) {
    const std::string program = helper_path(name).string();
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return no_helper(file, program, errno);
    }
    Descriptor ours(ends[0]);
    const Descriptor theirs(ends[1]);
    // Copies out of the way of the numbers that they become.
    const Descriptor socket(::fcntl(theirs.get(), F_DUPFD_CLOEXEC, above_the_readers_descriptors));
    const Descriptor lent(
        ::fcntl(file.descriptor(), F_DUPFD_CLOEXEC, above_the_readers_descriptors));
    if (!socket || !lent) {
        return no_helper(file, program, errno);
    }
    pid_t id = 0;
    const int number = start_helper(program, kind, socket.get(), lent.get(), id);
    if (number != 0) {
        return no_helper(file, program, number);
    }
    return Started{std::move(ours), id};
}

}  // namespace

Result<std::unique_ptr<ReaderProcess>> ReaderProcess::start(std::shared_ptr<const FileBytes> file,
                                                            const std::string& kind,
                                                            const std::string& format,
                                                            const std::string& program) {
    auto started = TRY(spawn(*file, kind, program));
    std::unique_ptr<ReaderProcess> process(
        new ReaderProcess(std::move(file), format, std::move(started.socket), started.id));
    TRY(process->take_catalogue());
    return process;
}

ReaderProcess::ReaderProcess(std::shared_ptr<const FileBytes> file, std::string format,
                             Descriptor socket, pid_t id)
    : file_(std::move(file)), format_(std::move(format)), socket_(std::move(socket)), id_(id) {}

ReaderProcess::~ReaderProcess() {
    end();
}

Status ReaderProcess::take_catalogue() {
    allow(seconds_for_catalogue);
    Reply reply;
    if (!receive(reply)) {
        return broken_off();
    }
    if (reply.kind != ReplyKind::catalogue) {
        return failed_reply(reply);
    }
    const auto bytes = receive_text(reply);
    if (!bytes) {
        return broken_off();
    }
    auto catalogue = decode_catalogue(*bytes);
    if (!catalogue) {
        return file_->damaged(
            format_, VYBEG_MESSAGE("Words", "its library returned no sensible list of variables"));
    }
    catalogue_ = std::move(*catalogue);
    return {};
}

Status ReaderProcess::read(const SampleRequest& request, std::span<double> out) {
    allow(seconds_allowed(request));
    Reply reply;
    if (!send_value(socket_.get(), request) || !receive(reply)) {
        return broken_off();
    }
    if (reply.kind != ReplyKind::samples ||
        reply.bytes != static_cast<std::int64_t>(out.size_bytes())) {
        return failed_reply(reply);
    }
    if (!receive({reinterpret_cast<char*>(out.data()), out.size_bytes()})) {
        return broken_off();
    }
    return {};
}

void ReaderProcess::allow(int seconds) {
    seconds_ = seconds;
    used_up_at_s_ = processor_s() + seconds;
    last_wait_ = Wait::ready;
}

// Of the helper, since it was started.
double ReaderProcess::processor_s() const {
    clockid_t clock{};
    timespec time{};
    if (::clock_getcpuclockid(id_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) {
        return 0;
    }
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Until there is something to receive, be it the end.
ReaderProcess::Wait ReaderProcess::wait() {
    constexpr double any_progress_s = 1e-4;
    double used_s = processor_s();
    for (int idle = 0; idle < idle_slices; ++idle) {
        pollfd waited{socket_.get(), POLLIN, 0};
        if (::poll(&waited, 1, slice_ms) > 0) {
            return Wait::ready;
        }
        const double now_s = processor_s();
        if (now_s > used_up_at_s_) {
            return Wait::used_up;
        }
        if (now_s > used_s + any_progress_s) {
            used_s = now_s;
            idle = 0;
        }
    }
    return Wait::idle;
}

// The whole of `bytes`; false where the helper ended (errno is 0 then), failed or was waited for
// too long.
bool ReaderProcess::receive(std::span<char> bytes) {
    while (!bytes.empty()) {
        last_wait_ = wait();
        if (last_wait_ != Wait::ready) {
            return false;
        }
        const ssize_t got = ::recv(socket_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) {
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    }
    return true;
}

std::optional<std::string> ReaderProcess::receive_text(const Reply& reply) {
    if (reply.bytes < 0 || reply.bytes > most_text_bytes) {
        return {};
    }
    std::string bytes(static_cast<std::size_t>(reply.bytes), '\0');
    return receive(bytes) ? std::optional(std::move(bytes)) : std::nullopt;
}

Error ReaderProcess::failed_reply(const Reply& reply) {
    if (reply.kind == ReplyKind::unconfined) {
        return file_->error(
            ErrorCode::file_read_failed,
            {Phrase::tr("this system cannot confine the helper program that reads this format: it "
                        "has no list of allowed system calls (seccomp)")});
    }
    if (reply.kind == ReplyKind::error) {
        const auto bytes = receive_text(reply);
        if (!bytes) {
            return broken_off();
        }
        if (auto error = decode_error(*bytes)) {
            error->where = file_->path().string();
            return *error;
        }
    }
    return file_->damaged(format_, VYBEG_MESSAGE("Words", "its library returned nonsense"));
}

// Why nothing came, by the exit status of the helper.
Error ReaderProcess::broken_off() {
    const int status = end();
    if (last_wait_ == Wait::used_up) {
        return file_->damaged(
            format_,
            VYBEG_MESSAGE("Words",
                          "its library did not come to an end within %1 s of processor time"),
            {count_arg(seconds_)});
    }
    if (last_wait_ == Wait::idle) {
        return file_->damaged(format_,
                              VYBEG_MESSAGE("Words", "its library stopped working on it for %1 s"),
                              {count_arg(idle_slices * slice_ms / 1000)});
    }
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return file_->damaged(
        format_,
        signal == SIGXCPU ? VYBEG_MESSAGE("Words", "its library did not come to an end")
        : signal == SIGSYS
            ? VYBEG_MESSAGE("Words", "its library was stopped when it tried to do more than read")
            : VYBEG_MESSAGE("Words", "its library failed on it"));
}

// Ends the helper and returns the status that waitpid() gives.
int ReaderProcess::end() {
    if (!socket_) {
        return 0;
    }
    socket_.close();
    // Our hanging up ends a sound one at its next message; one that is stuck needs more.
    ::kill(id_, SIGKILL);
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

namespace {

constexpr std::string_view hdf5_signature("\x89HDF\r\n\x1a\n", 8);
constexpr std::string_view matlab_signature = "MATLAB 7.3 MAT-file";

class HelperVariables final : public VariableReader,
                              public std::enable_shared_from_this<HelperVariables> {
public:
    HelperVariables(std::shared_ptr<const FileBytes> file, std::string kind, std::string format,
                    std::unique_ptr<ReaderProcess> process)
        : file_(std::move(file)),
          kind_(std::move(kind)),
          format_(std::move(format)),
          catalogue_(process->catalogue()),
          process_(std::move(process)) {}

    const Catalogue& catalogue() const override { return catalogue_; }

    Status read(const ChannelPlace& place, std::int64_t first,
                std::span<double> out) const override {
        const auto process = process_.hold();
        if (!*process) {
            *process = TRY(ReaderProcess::start(file_, kind_, format_));
        }
        const SampleRequest request{place.variable, place.channel, first,
                                    static_cast<std::int64_t>(out.size())};
        if (!fits(request, (*process)->catalogue())) {
            process->reset();
            return file_->error(ErrorCode::file_read_failed,
                                {"the file changed while it was read"});
        }
        if (const Status status = (*process)->read(request, out); !status) {
            process->reset();
            return status;
        }
        std::replace_if(
            out.begin(), out.end(), [](double sample) { return std::isinf(sample); },
            std::numeric_limits<double>::quiet_NaN());
        return {};
    }

    // In turn, so that what the library has decoded for C serves D. A packed variable is unpacked
    // from its start: of an audio file alone any frame is reached at once.
    Result<std::shared_ptr<const SampleSource>> source(const ChannelPlace& c, const ChannelPlace& d,
                                                       std::int64_t frames) const override {
        return source_of(
            frames, kind_ == "audio",
            [self = shared_from_this(), c, d](std::int64_t first, std::span<double> out_c,
                                              std::span<double> out_d) -> Status {
                for (std::size_t done = 0; done < out_c.size(); done += frames_per_request) {
                    const std::size_t count =
                        std::min(static_cast<std::size_t>(frames_per_request), out_c.size() - done);
                    const std::int64_t from = first + static_cast<std::int64_t>(done);
                    TRY(self->read(c, from, out_c.subspan(done, count)));
                    TRY(self->read(d, from, out_d.subspan(done, count)));
                }
                return {};
            });
    }

private:
    std::shared_ptr<const FileBytes> file_;
    std::string kind_;
    std::string format_;
    Catalogue catalogue_;
    Guarded<std::unique_ptr<ReaderProcess>> process_;
};

}  // namespace

Result<std::shared_ptr<const VariableReader>> open_library(
    const std::shared_ptr<const FileBytes>& file, const std::string& kind,
    const std::string& format) {
    auto process = TRY(ReaderProcess::start(file, kind, format));
    return std::shared_ptr<const VariableReader>(
        std::make_shared<HelperVariables>(file, kind, format, std::move(process)));
}

bool is_hdf5(std::string_view head, const FileBytes& file) {
    if (head.starts_with(matlab_signature)) {
        return true;
    }
    std::array<char, hdf5_signature.size()> bytes{};
    for (std::int64_t at = 0; at < file.size(); at = at == 0 ? 512 : 2 * at) {
        const auto got = file.read(at, bytes);
        if (got && std::string_view(bytes.data(), bytes.size()) == hdf5_signature) {
            return true;
        }
    }
    return false;
}

Result<Recording> open_hdf5(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    const auto head = TRY(file->text(0, std::ssize(matlab_signature)));
    const bool matlab = head == matlab_signature;
    const auto library =
        TRY(open_library(file, matlab ? "mat73" : "hdf5", matlab ? "MAT 7.3" : "HDF5"));
    return open_variables(*file, *library, options, job);
}

}  // namespace vybeg
