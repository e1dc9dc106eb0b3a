// vybeg-reader: reads one MAT or HDF5 file for the program that started it, and may die of it
// (core/recording/reader_process.h). Not meant to be started by hand.
#include "core/libraries/library_file.h"
#include "core/recording/reader_protocol.h"

#include <cstdio>
#include <fstream>
#include <string_view>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace vybeg;

// Memory beyond what the process has already: the file's size and 64 MB.
void limit_memory() {
#ifndef __SANITIZE_ADDRESS__  // whose shadow takes the whole address space
    constexpr rlim_t allowance = rlim_t{64} << 20;
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    struct stat file {};
    if (pages > 0 && ::fstat(reader_file, &file) == 0) {
        const rlim_t limit = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) +
                             static_cast<rlim_t>(file.st_size) + allowance;
        const rlimit memory{limit, limit};
        ::setrlimit(RLIMIT_AS, &memory);
    }
#endif
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
}

// The program gives us up earlier; this is for the case that it has died itself.
void allow_processor(int seconds) {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    rlimit limit{};
    ::getrlimit(RLIMIT_CPU, &limit);
    limit.rlim_cur =
        static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec + 2 + seconds);
    ::setrlimit(RLIMIT_CPU, &limit);
}

bool answer(ReplyKind kind, std::span<const char> bytes) {
    const Reply reply{kind, static_cast<std::int64_t>(bytes.size())};
    return send_value(reader_socket, reply) && send_bytes(reader_socket, bytes);
}

Result<std::unique_ptr<LibraryFile>> open_file(std::string_view kind) {
    const std::string path = "/proc/self/fd/" + std::to_string(reader_file);
    if (kind == "mat") {
        return open_mat_file(path);
    }
    return open_hdf5_file(path, kind == "mat73" ? Naming::matlab : Naming::hdf5);
}

void serve(LibraryFile& file) {
    SampleRequest request;
    std::vector<double> samples;
    while (receive_value(reader_socket, request) && fits(request, file.catalogue())) {
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

}  // namespace

int main(int argc, char** argv) {
    struct stat file {};
    if (argc != 2 || ::fstat(reader_file, &file) != 0) {
        std::fputs("vybeg-reader is started by vybeg and vybeg-cli.\n", stderr);
        return 2;
    }
    limit_memory();
    allow_processor(seconds_for_catalogue);
    const auto opened = open_file(argv[1]);
    if (!opened) {
        answer(ReplyKind::error, encode(opened.error()));
        return 1;
    }
    if (answer(ReplyKind::catalogue, encode((*opened)->catalogue()))) {
        serve(**opened);
    }
    // Without the libraries' own clearing up: of a damaged file it may fail.
    std::_Exit(0);
}
