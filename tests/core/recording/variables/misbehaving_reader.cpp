// vybeg-reader as it would be with a library that a file has taken over: its kind is "hdf5:open"
// and the like. Once the file is open, it does what it is told to, and ends with status 40 where
// that succeeds. "open" and the like without "hdf5:": the same before anything is given up.
#include "app/reader_service.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <netinet/in.h>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
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

}  // namespace

int main(int argc, char** argv) {
    const std::string_view kind = argc == 2 ? argv[1] : "";
    if (!kind.starts_with("hdf5:")) {
        misbehave(kind);
        return 1;
    }
    return vybeg::serve_file("hdf5", [deed = kind.substr(5)] { misbehave(deed); });
}
