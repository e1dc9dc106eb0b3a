// vybeg-reader as it would be with a library that a file has taken over: its kind is "hdf5:open",
// "audio:open" and the like. Before the file's first byte is read, it does what it is told to, and
// ends with status 40 where that succeeds. "open" and the like alone: the same before anything is
// given up. "hdf5:unlisted": on a system that refuses lists of system calls.
#include "app/reader_service.h"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <fcntl.h>
#include <iterator>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <netinet/in.h>
#include <string_view>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

// Whether the deed was done.
bool done(std::string_view deed) {
    if (deed == "open") {
        return ::open("/proc/self/status", O_RDONLY) >= 0;
    }
    if (deed == "write") {
        const int file = ::memfd_create("deed", 0);
        return file >= 0 && ::write(file, "x", 1) == 1;
    }
    if (deed == "pipe") {
        int ends[2];
        return ::pipe(ends) == 0 && ::write(ends[1], "x", 1) == 1;
    }
    if (deed == "fork") {
        const pid_t child = ::fork();
        if (child == 0) {
            ::_exit(0);
        }
        return child > 0 && ::waitpid(child, nullptr, 0) == child;
    }
    if (deed == "connect") {
        const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(9);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return socket >= 0 &&
               ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    }
    if (deed == "run") {
        ::execl("/bin/sh", "sh", "-c", "exit 40", nullptr);
        return false;
    }
    if (deed == "remove") {
        return ::unlink("/nonexistent/of/a/test") == 0 || errno == ENOENT;
    }
    if (deed == "kill") {
        return ::kill(::getppid(), 0) == 0;
    }
    if (deed == "code") {
        return ::mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
               MAP_FAILED;
    }
    return false;
}

void misbehave(std::string_view deed) {
    if (deed == "spin") {
        volatile unsigned turns = 0;
        for (;;) {
            turns = turns + 1;
        }
    }
    if (done(deed)) {
        ::_exit(40);
    }
}

// From here on, the kernel refuses this process any further list.
void refuse_lists() {
    sock_filter code[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_prctl, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, PR_SET_SECCOMP, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EINVAL),
    };
    const sock_fprog program{std::size(code), code};
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view kind = argc == 2 ? argv[1] : "";
    const std::size_t colon = kind.find(':');
    if (colon == kind.npos) {
        misbehave(kind);
        return 1;
    }
    const std::string_view deed = kind.substr(colon + 1);
    if (deed == "unlisted") {
        refuse_lists();
    }
    return vybeg::serve_file(kind.substr(0, colon), [deed] { misbehave(deed); });
}
