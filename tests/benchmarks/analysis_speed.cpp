// What a whole analysis takes, from the file to the finished track, and its search for the carrier,
// against the least that such a thing takes: one pass over the samples; one read() of the file and
// one write() of the track, also with hash and fsync. 28 s at 33333 Hz, the article's case, 60 dB,
// a file in the page cache. Four recordings to their resonator are timed, too.
#include "app/cli_commands.h"
#include "app/cli_support.h"
#include "core/output/sample_files.h"
#include "core/recording/samples/open_options.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "core/windows/carrier_search.h"
#include "tests/benchmarks/ratio_table.h"
#include "tests/needed.h"

#include <openssl/evp.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using namespace vybeg;
using namespace vybeg::benchmarks;
namespace fs = std::filesystem;

[[noreturn]] void fail(const char* reason) {
    std::fprintf(stderr, "%s\n", reason);
    std::exit(1);
}

// In a folder that goes with the program.
class Files {
public:
    Files() {
        std::string name = (fs::temp_directory_path() / "vybeg-speed-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            fail("no folder for the recordings");
        }
        folder_ = name;
        for (int k = 0; k < 4; ++k) {
            recordings.push_back(folder_ / ("run-" + std::to_string(k) + ".wav"));
            write(recordings.back(), k);
        }
    }
    ~Files() { fs::remove_all(folder_); }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;

    fs::path path(const std::string& name) const { return folder_ / name; }

    std::vector<fs::path> recordings;
    SimulatedDecay first;

private:
    // One gyro, started at four angles.
    void write(const fs::path& path, int k) {
        FreeDecay decay = demo_decay();
        decay.seconds = 28;
        decay.f0_hz = 5300 + 0.01 * k;
        decay.tau_s = 400;
        decay.damping_anisotropy_per_s = 0;
        decay.noise = 1e-3 * decay.a_A;
        decay.two_theta_A = k * std::numbers::pi / 4;
        decay.seed = static_cast<std::uint64_t>(k + 1);
        SimulatedDecay samples = test::needed(simulate(decay, {}));
        OutputFile file = test::needed(OutputFile::create(path, {}));
        test::needed(write_samples(file, test::needed(sample_format(path)),
                                   in_memory(samples.c, samples.d, decay.rate_hz, {})));
        test::needed(file.commit());
        if (k == 0) {
            first = std::move(samples);
        }
    }

    fs::path folder_;
};

// As tests/benchmarks/estimator_speed.cpp has it.
void plain_pass(benchmark::State& state, const SimulatedDecay& samples) {
    for ([[maybe_unused]] const auto _ : state) {
        double c = 0;
        double d = 0;
        for (std::size_t j = 0; j < samples.c.size(); ++j) {
            c += samples.c[j];
            d += samples.d[j];
        }
        benchmark::DoNotOptimize(c);
        benchmark::DoNotOptimize(d);
    }
}

void carrier_search(benchmark::State& state, const SimulatedDecay& samples) {
    for ([[maybe_unused]] const auto _ : state) {
        const auto found = find_carrier(samples.c, samples.d, 33333, 1, 16666);
        if (!found || std::abs(*found - 5300) > 0.01) {
            state.SkipWithError("the carrier is not found");
        }
    }
}

enum class Output { plain, durable };

// One read() of a whole file into memory that is there, and one write() of another's bytes into a
// new file. Durable: with the SHA-256 of what is read and the wait for the disk (fsync), which a
// track has too.
void read_and_write(benchmark::State& state, const fs::path& from, std::vector<char> text,
                    const fs::path& to, Output output) {
    std::vector<char> bytes(fs::file_size(from));
    for ([[maybe_unused]] const auto _ : state) {
        const int in = open(from.c_str(), O_RDONLY | O_CLOEXEC);
        const ssize_t got = read(in, bytes.data(), bytes.size());
        close(in);
        if (output == Output::durable) {
            std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
            EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr);
            benchmark::DoNotOptimize(digest);
        }
        const int out = open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        const ssize_t put = write(out, text.data(), text.size());
        const bool settled = output == Output::plain || fsync(out) == 0;
        close(out);
        if (!settled || got != std::ssize(bytes) || put != std::ssize(text)) {
            state.SkipWithError("not read or written as a whole");
        }
        unlink(to.c_str());
    }
}

// A command as its program runs it: from opening its files to the last rename, which waits for the
// disk.
void run(benchmark::State& state, const std::function<Status(cli::Log&)>& command) {
    cli::Log log({.quiet = true});
    for ([[maybe_unused]] const auto _ : state) {
        if (const Status done = command(log); !done) {
            log.fail(done.error());
            state.SkipWithError("the command failed");
        }
    }
}

std::vector<char> bytes_of(const fs::path& path) {
    std::vector<char> bytes(fs::file_size(path));
    const int in = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const ssize_t got = read(in, bytes.data(), bytes.size());
    close(in);
    return got == std::ssize(bytes) ? bytes : std::vector<char>{};
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const Files files;
    const auto add = [](const std::string& name, auto function) {
        benchmark::RegisterBenchmark(name.c_str(), function)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.2)
            ->Repetitions(5);
    };
    add("plain pass", [&](auto& state) { plain_pass(state, files.first); });
    add("carrier", [&](auto& state) { carrier_search(state, files.first); });
    for (const std::int64_t n : {60, 6}) {
        const std::string of_n = ", n " + std::to_string(n);
        const fs::path track = files.path("track" + std::to_string(n) + ".csv");
        cli::AnalyzeRequest request;
        request.input = files.recordings[0].string();
        request.output = track.string();
        request.settings.window = n;
        const auto analyze = [request](cli::Log& log) {
            return cli::run_analyze(request, log, {});
        };
        cli::Log log({.quiet = true});
        if (const Status done = analyze(log); !done) {
            log.fail(done.error());
            fail("the recording cannot be analysed");
        }
        for (const auto& [name, output] : {std::pair("read and write", Output::plain),
                                           {"read, SHA-256, write and fsync", Output::durable}}) {
            add(name + of_n,
                [&, text = bytes_of(track), to = files.path("copy"), output](auto& state) {
                    read_and_write(state, files.recordings[0], text, to, output);
                });
        }
        add("analyze" + of_n, [analyze](auto& state) { run(state, analyze); });
    }
    cli::IdentifyRequest identify;
    for (const fs::path& path : files.recordings) {
        identify.inputs.push_back(path.string());
    }
    identify.output = files.path("resonator.json").string();
    add("identify four", [&](auto& state) {
        run(state, [&](cli::Log& log) { return cli::run_identify(identify, log, {}); });
    });
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    const bool fast =
        reporter.print({{"carrier", "plain pass", 1.0 / 12},
                        {"analyze, n 60", "read, SHA-256, write and fsync, n 60", 1.0 / 5},
                        {"analyze, n 6", "read, SHA-256, write and fsync, n 6", 1.0 / 5},
                        {"analyze, n 60", "read and write, n 60", 1.0 / 5},
                        {"analyze, n 6", "read and write, n 6", 1.0 / 5}});
    const double identified = reporter.seconds("identify four");
    std::printf("\nfour recordings to their resonator: %.3f s (0.4 s at most)\n", identified);
    return fast && identified <= 0.4 ? 0 : 1;
}
