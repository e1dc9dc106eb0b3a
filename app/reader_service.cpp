#include "app/reader_service.h"

#include "app/reader_confinement.h"
#include "core/recording/mat_hdf5/hdf5_file.h"
#include "core/recording/sndfile/audio_file.h"
#include "core/recording/variables/reader_protocol.h"

#include <algorithm>
#include <cstdlib>
#include <sys/resource.h>
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
    auto file = FileBytes::adopt("", reader_file);
    return file ? open_audio_file(std::move(*file)) : file.error();
}

void serve(HelperFile& file) {
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
