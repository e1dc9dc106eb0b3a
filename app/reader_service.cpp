#include "app/reader_service.h"

#include "core/recording/mat_hdf5/hdf5_file.h"
#include "core/recording/sndfile/audio_file.h"
#include "core/recording/variables/reader_protocol.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <span>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace vybeg {
namespace {

// The program gives us up earlier; this is for the case that it has died itself.
void allow_processor(int seconds) {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    rlimit limit{};
    ::getrlimit(RLIMIT_CPU, &limit);
    limit.rlim_cur =
        std::min(static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec + 2 + seconds),
                 limit.rlim_max);
    ::setrlimit(RLIMIT_CPU, &limit);
}

bool answer(ReplyKind kind, std::span<const char> bytes) {
    const Reply reply{kind, static_cast<std::int64_t>(bytes.size())};
    return send_value(reader_socket, reply) && send_bytes(reader_socket, bytes);
}

Result<std::unique_ptr<HelperFile>> open_file(std::string_view kind) {
    if (kind != "audio") {
        return open_hdf5_file(reader_file, kind == "mat73" ? Naming::matlab : Naming::hdf5);
    }
    auto file = FileBytes::adopt("", Descriptor(reader_file));
    return file ? open_audio_file(std::move(*file)) : file.error();
}

// The whole of a request; false where the program hangs up.
bool receive(SampleRequest& request) {
    const std::span bytes(reinterpret_cast<char*>(&request), sizeof request);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t got = ::recv(reader_socket, &bytes[done], bytes.size() - done, 0);
        if (got == 0 || (got < 0 && errno != EINTR)) {
            return false;
        }
        done += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    return true;
}

void serve(HelperFile& file) {
    SampleRequest request;
    std::vector<double> samples;
    while (receive(request) && fits(request, file.catalogue())) {
        allow_processor(seconds_allowed(request));
        samples.resize(static_cast<std::size_t>(request.count));
        const Status status = file.read(request, samples);
        const bool heard =
            status ? answer(ReplyKind::samples, {reinterpret_cast<const char*>(samples.data()),
                                                 samples.size() * sizeof(double)})
                   : answer(ReplyKind::error, encode(status.error()));
        if (!heard) {
            return;
        }
    }
}

void limit(__rlimit_resource resource, rlim_t most) {
    const rlimit both{most, most};
    ::setrlimit(resource, &both);
}

// Beyond what the process has already: the file's size and 64 MB; at most what the largest pieces
// need as well.
void limit_memory() {
#ifndef __SANITIZE_ADDRESS__  // whose shadow takes the whole address space
    constexpr rlim_t allowance = rlim_t{64} << 20;
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    struct stat file {};
    if (pages > 0 && ::fstat(reader_file, &file) == 0) {
        const rlim_t usual = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) +
                             static_cast<rlim_t>(file.st_size) + allowance;
        const rlimit both{usual, usual + packed_pieces_held * most_packed_bytes};
        ::setrlimit(RLIMIT_AS, &both);
    }
#endif
}

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;
#endif

[[maybe_unused]] constexpr std::array allowed_calls{
    SYS_read,         SYS_readv,        SYS_pread64,        SYS_preadv,       SYS_lseek,
    SYS_close,        SYS_fstat,        SYS_recvfrom,       SYS_sendto,       SYS_brk,
    SYS_munmap,       SYS_mremap,       SYS_madvise,        SYS_futex,        SYS_clock_gettime,
    SYS_gettimeofday, SYS_getrusage,    SYS_getrandom,      SYS_sysinfo,      SYS_getpid,
    SYS_gettid,       SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_restart_syscall,
    SYS_sched_yield,  SYS_exit,         SYS_exit_group};

// A call that is allowed where a test of the low half of an argument has this result.
struct Condition {
    int call;
    std::uint32_t argument;
    std::uint16_t test;
    std::uint32_t value;
    bool result;
};

// The lists as the kernel's filter runs them for each system call.
[[maybe_unused]] std::vector<sock_filter> call_filter(std::span<const Condition> conditions) {
    constexpr sock_filter allow BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    constexpr sock_filter kill BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
    const auto load = [](std::size_t offset) -> sock_filter {
        return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
    };
    // Passes over so many instructions where it is another call.
    const auto unless = [](int call, std::uint8_t over) -> sock_filter {
        return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, over);
    };
    std::vector<sock_filter> code{load(offsetof(seccomp_data, arch)),
                                  BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0), kill,
                                  load(offsetof(seccomp_data, nr))};
    for (const int call : allowed_calls) {
        code.insert(code.end(), {unless(call, 1), allow});
    }
    for (const Condition& each : conditions) {
        const std::uint8_t over_if_so = each.result ? 0 : 1;
        const std::uint8_t over_if_not = each.result ? 1 : 0;
        const auto test = static_cast<std::uint16_t>(BPF_JMP | each.test | BPF_K);
        code.insert(code.end(),
                    {unless(each.call, 4),
                     load(offsetof(seccomp_data, args) + std::size_t{each.argument} * 8),
                     {test, over_if_so, over_if_not, each.value},
                     allow,
                     kill});
    }
    code.push_back(kill);
    return code;
}

// What vybeg-reader gives up before it looks at a file: new privileges, memory beyond the file's
// size and 64 MB (until allow_memory()) and 6 pieces of most_packed_bytes at all, writing to files,
// more than 8 descriptors, other processes and threads, core dumps, and more than ten hours of
// processor time in all.
void give_up_resources() {
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    limit_memory();
    constexpr rlim_t ten_hours = 36000;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_NPROC, 0);
    limit(RLIMIT_CPU, ten_hours);
#ifndef __SANITIZE_ADDRESS__  // which looks at /proc with descriptors of its own
    limit(RLIMIT_NOFILE, 8);
#endif
}

// So many bytes more, for the pieces that the file says it is packed in.
void allow_memory(std::int64_t bytes) {
    rlimit memory{};
    ::getrlimit(RLIMIT_AS, &memory);
    if (memory.rlim_cur != RLIM_INFINITY) {
        memory.rlim_cur = std::min(memory.rlim_cur + static_cast<rlim_t>(bytes), memory.rlim_max);
        ::setrlimit(RLIMIT_AS, &memory);
    }
}

// From here on, a system call that reading from open files, memory and the socket does not need
// ends the process (SIGSYS). False where the system has no seccomp, or on another processor than
// x86-64 and ARM64. With AddressSanitizer, which itself opens files, it forbids nothing and returns
// true: such a build is for tests.
bool forbid_system_calls() {
#ifdef __SANITIZE_ADDRESS__
    return true;
#else
    if (architecture == 0) {
        return false;
    }
    const std::array conditions{
        Condition{SYS_mmap, 2, BPF_JSET, PROT_EXEC, false},
        Condition{SYS_mprotect, 2, BPF_JSET, PROT_EXEC, false},
        Condition{SYS_newfstatat, 3, BPF_JEQ, AT_EMPTY_PATH, true},  // fstat() of the C library
        Condition{SYS_prlimit64, 0, BPF_JEQ, 0, true},               // its own limits, downwards
        // What abort() does: a sentence to /dev/null, and a signal to itself.
        Condition{SYS_write, 0, BPF_JEQ, STDERR_FILENO, true},
        Condition{SYS_writev, 0, BPF_JEQ, STDERR_FILENO, true},
        Condition{SYS_tgkill, 0, BPF_JEQ, static_cast<std::uint32_t>(::getpid()), true}};
    std::vector<sock_filter> code = call_filter(conditions);
    const sock_fprog program{static_cast<unsigned short>(code.size()), code.data()};
    return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
#endif
}

}  // namespace

int serve_file(std::string_view kind, const std::function<void()>& once_confined) {
    give_up_resources();
    allow_processor(seconds_for_catalogue);
    if (!forbid_system_calls()) {
        answer(ReplyKind::unconfined, {});
        std::_Exit(1);
    }
    if (once_confined) {
        once_confined();
    }
    const auto opened = open_file(kind);
    if (opened) {
        allow_memory((*opened)->memory_bytes());
    }
    if (!opened) {
        answer(ReplyKind::error, encode(opened.error()));
        std::_Exit(1);
    }
    if (answer(ReplyKind::catalogue, encode((*opened)->catalogue()))) {
        serve(**opened);
    }
    // Without the libraries' own clearing up: of a damaged file it may fail.
    std::_Exit(0);
}

}  // namespace vybeg
