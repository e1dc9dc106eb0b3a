#include "core/recording/reader_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t most_text_bytes = std::int64_t{16} << 20;
constexpr int above_the_readers_descriptors = 10;

// A descriptor that is closed at the end of its scope.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) {
            ::close(number_);
        }
    }
    int get() const { return number_; }
    int release() { return std::exchange(number_, -1); }

private:
    int number_;
};

// How the helper is started: its descriptors, no other; signals as in a fresh program; in a process
// group of its own, so that Ctrl-C in a terminal reaches only the program.
class SpawnPlan {
public:
    SpawnPlan(int socket, int file) {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_adddup2(&actions_, socket, reader_socket);
        ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions_, file, reader_file);
        ::posix_spawn_file_actions_addclosefrom_np(&actions_, reader_file + 1);
        ::posix_spawnattr_init(&attributes_);
        sigset_t signals;
        sigemptyset(&signals);
        ::posix_spawnattr_setsigmask(&attributes_, &signals);
        sigfillset(&signals);
        ::posix_spawnattr_setsigdefault(&attributes_, &signals);
        ::posix_spawnattr_setpgroup(&attributes_, 0);
        ::posix_spawnattr_setflags(
            &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;
    ~SpawnPlan() {
        ::posix_spawn_file_actions_destroy(&actions_);
        ::posix_spawnattr_destroy(&attributes_);
    }

    // 0, or the error's number.
    int run(const std::string& program, const std::string& kind, pid_t& id) const {
        std::string name = program;
        std::string argument = kind;
        std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
        return ::posix_spawn(&id, program.c_str(), &actions_, &attributes_, arguments.data(),
                             environ);
    }

private:
    posix_spawn_file_actions_t actions_;
    posix_spawnattr_t attributes_;
};

Error no_helper(const FileBytes& file, const std::string& program, int number) {
    const char* reason = strerrordesc_np(number);
    return file.error(ErrorCode::file_read_failed,
                      {"the helper program " + program + " cannot be started (" +
                       (reason ? reason : "unknown error") + ")"});
}

struct Started {
    int socket = -1;
    pid_t id = 0;
};

// When it returns, our copies of the helper's end are closed: else its death would not be heard.
Result<Started> spawn(const FileBytes& file, const std::string& kind) {
    std::error_code ignored;  // without /proc the path is that of no program, and starting fails
    const std::string program =
        (std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / "vybeg-reader")
            .string();
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
    if (socket.get() < 0 || lent.get() < 0) {
        return no_helper(file, program, errno);
    }
    pid_t id = 0;
    const int number = SpawnPlan(socket.get(), lent.get()).run(program, kind, id);
    if (number != 0) {
        return no_helper(file, program, number);
    }
    return Started{ours.release(), id};
}

}  // namespace

Result<std::unique_ptr<ReaderProcess>> ReaderProcess::start(std::shared_ptr<const FileBytes> file,
                                                            const std::string& kind,
                                                            const std::string& format) {
    const auto started = spawn(*file, kind);
    if (!started) {
        return started.error();
    }
    std::unique_ptr<ReaderProcess> process(
        new ReaderProcess(std::move(file), format, started->socket, started->id));
    if (const Status status = process->take_catalogue(); !status) {
        return status.error();
    }
    return process;
}

ReaderProcess::ReaderProcess(std::shared_ptr<const FileBytes> file, std::string format, int socket,
                             pid_t id)
    : file_(std::move(file)), format_(std::move(format)), socket_(socket), id_(id) {}

ReaderProcess::~ReaderProcess() {
    end();
}

Status ReaderProcess::take_catalogue() {
    allow(seconds_for_catalogue);
    Reply reply;
    if (!receive_value(socket_, reply)) {
        return broken_off(seconds_for_catalogue);
    }
    if (reply.kind != ReplyKind::catalogue) {
        return failed_reply(reply, seconds_for_catalogue);
    }
    const auto bytes = receive_text(reply);
    if (!bytes) {
        return broken_off(seconds_for_catalogue);
    }
    auto catalogue = decode_catalogue(*bytes);
    if (!catalogue) {
        return damaged("its library returned no sensible list of variables");
    }
    catalogue_ = std::move(*catalogue);
    return {};
}

Status ReaderProcess::read(const SampleRequest& request, std::span<double> out) {
    const int seconds = seconds_allowed(request);
    allow(seconds);
    Reply reply;
    if (!send_value(socket_, request) || !receive_value(socket_, reply)) {
        return broken_off(seconds);
    }
    if (reply.kind != ReplyKind::samples ||
        reply.bytes != static_cast<std::int64_t>(out.size_bytes())) {
        return failed_reply(reply, seconds);
    }
    if (!receive_bytes(socket_, {reinterpret_cast<char*>(out.data()), out.size_bytes()})) {
        return broken_off(seconds);
    }
    return {};
}

// How long the helper may keep us waiting before we give it up.
void ReaderProcess::allow(int seconds) {
    timeval time{};
    time.tv_sec = seconds;
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof time);
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &time, sizeof time);
}

std::optional<std::string> ReaderProcess::receive_text(const Reply& reply) {
    if (reply.bytes < 0 || reply.bytes > most_text_bytes) {
        errno = 0;
        return {};
    }
    std::string bytes(static_cast<std::size_t>(reply.bytes), '\0');
    return receive_bytes(socket_, bytes) ? std::optional(std::move(bytes)) : std::nullopt;
}

Error ReaderProcess::failed_reply(const Reply& reply, int seconds) {
    if (reply.kind == ReplyKind::error) {
        const auto bytes = receive_text(reply);
        if (!bytes) {
            return broken_off(seconds);
        }
        if (auto error = decode_error(*bytes)) {
            error->where = file_->path().string();
            return *error;
        }
    }
    return damaged("its library returned nonsense");
}

// Why nothing came, as far as the end of the helper tells.
Error ReaderProcess::broken_off(int seconds) {
    if (errno == EAGAIN || errno == EWOULDBLOCK) {
        end();
        return damaged("its library did not come to an end within " + std::to_string(seconds) +
                       " s");
    }
    const int status = end();
    return damaged(WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU
                       ? "its library did not come to an end"
                       : "its library failed on it");
}

// Ends the helper and returns the status that waitpid() gives.
int ReaderProcess::end() {
    if (socket_ < 0) {
        return 0;
    }
    ::close(std::exchange(socket_, -1));
    // Our hanging up ends a sound one at its next message; one that is stuck needs more.
    ::kill(id_, SIGKILL);
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

Error ReaderProcess::damaged(const std::string& reason) const {
    return file_->error(ErrorCode::format_damaged, {format_, reason});
}

}  // namespace vybeg
