// How fast recordings are read from the page cache, against the least that reading takes.
#include "core/base/error.h"
#include "core/recording/open/open_recording.h"
#include "core/recording/samples/recording.h"
#include "tests/benchmarks/ratio_table.h"
#include "tests/benchmarks/recording_files.h"

#include <tbb/global_control.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>
#include <vector>

namespace {

using namespace vybeg;
using namespace vybeg::benchmarks;

constexpr std::size_t frames_at_once = std::size_t{1} << 18;  // as an analysis reads them
constexpr std::size_t bytes_at_once = std::size_t{1} << 18;   // fits the processor's own cache

[[noreturn]] void fail(const std::string& reason) {
    std::fprintf(stderr, "%s\n", reason.c_str());
    std::exit(1);
}

// read() of all bytes into memory, piece after piece into the same place.
void read_bytes(benchmark::State& state, const RecordingFile& file) {
    std::vector<char> bytes(bytes_at_once);
    const int descriptor = open(file.path.c_str(), O_RDONLY | O_CLOEXEC);
    for ([[maybe_unused]] const auto _ : state) {
        lseek(descriptor, 0, SEEK_SET);
        while (read(descriptor, bytes.data(), bytes.size()) > 0) {
            benchmark::DoNotOptimize(bytes.data());
        }
    }
    close(descriptor);
}

// The whole recording, in the pieces of an analysis.
void read_samples(const Recording& recording, std::vector<double>& c, std::vector<double>& d) {
    const std::int64_t frames = recording.frames();
    for (std::int64_t at = 0; at < frames; at += static_cast<std::int64_t>(c.size())) {
        const auto count = std::min(c.size(), static_cast<std::size_t>(frames - at));
        const Status status =
            recording.source->read(at, std::span(c).first(count), std::span(d).first(count));
        if (!status) {
            fail(english(status.error()));
        }
    }
}

Recording opened(const RecordingFile& file) {
    auto recording = open_recording(file.path, file.open, {});
    if (!recording) {
        fail(english(recording.error()));
    }
    return *recording;
}

void read_recording(benchmark::State& state, const RecordingFile& file) {
    std::vector<double> c(frames_at_once);
    std::vector<double> d(frames_at_once);
    const Recording recording = opened(file);
    for ([[maybe_unused]] const auto _ : state) {
        read_samples(recording, c, d);
    }
}

// A text is looked through when it is opened: that belongs to its reading. One thread, as the loop
// that it is compared with.
void open_and_read(benchmark::State& state, const RecordingFile& file) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    std::vector<double> c(frames_at_once);
    std::vector<double> d(frames_at_once);
    for ([[maybe_unused]] const auto _ : state) {
        read_samples(opened(file), c, d);
    }
}

// Every number of a text in memory by std::from_chars, and nothing else.
void parse_numbers(benchmark::State& state, const RecordingFile& file) {
    std::vector<char> text(std::filesystem::file_size(file.path));
    const int descriptor = open(file.path.c_str(), O_RDONLY | O_CLOEXEC);
    if (read(descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
        fail("The text cannot be read.");
    }
    close(descriptor);
    const char* const end = text.data() + text.size();
    const char* const begin = std::find(text.data(), const_cast<char*>(end), '\n') + 1;
    for ([[maybe_unused]] const auto _ : state) {
        double sum = 0;
        for (const char* at = begin; at < end; ++at) {
            double value = 0;
            at = std::from_chars(at, end, value).ptr;
            sum += value;
        }
        benchmark::DoNotOptimize(sum);
    }
}

template <class Function, class... Arguments>
void add(const std::string& name, Function function, const Arguments&... arguments) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) { function(state, arguments...); })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(7);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const RecordingFiles files;
    std::vector<Ratio> ratios;
    const auto add_reading = [&](const std::string& name, const RecordingFile& file, double least) {
        add("read() of " + name, read_bytes, file);
        add(name, read_recording, file);
        ratios.push_back({name, "read() of " + name, least});
    };
    add_reading("raw f64", files.raw, 0.5);
    add_reading("NPY f64", files.npy, 0.5);
    add_reading("WAV f64", files.wav_f64, 0.4);
    add_reading("WAV f32", files.wav_f32, 0.4);
    add_reading("WAV 32 bit", files.wav_i32, 0.4);
    add_reading("WAV 24 bit", files.wav_i24, 0.4);
    add_reading("WAV 16 bit", files.wav_i16, 0.4);
    add("from_chars loop", parse_numbers, files.csv);
    add("CSV, one thread", open_and_read, files.csv);
    ratios.push_back({"CSV, one thread", "from_chars loop", 0.3});

    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    const bool enough = reporter.print(ratios);
    return enough ? 0 : 1;
}
