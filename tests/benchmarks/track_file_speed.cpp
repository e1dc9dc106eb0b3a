// What writing a track of 155,554 windows (28 s at 33333 Hz, 6 samples a window) takes beyond one
// write() of the same bytes into a new file: from memory, as the window exports it, and as
// `analyze` writes it, whose rows wait for their header. All wait for the disk (fsync).
#include "core/output/track_file.h"
#include "tests/benchmarks/ratio_table.h"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

using namespace vybeg;
using namespace vybeg::benchmarks;
namespace fs = std::filesystem;

constexpr std::size_t windows = 155554;
constexpr std::size_t windows_at_once = 4096;  // as an analysis hands them over
constexpr double most_beyond_s = 0.030;

Track random_track(std::size_t rows) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> any(-1, 1);
    Track track(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        track.time_s()[row] = 0.00018 * static_cast<double>(row);
        for (const SlowVariable variable : all_slow_variables) {
            track.values(variable)[row] = any(engine);
            if (info(variable).has_sd) {
                track.sds(variable)[row] = any(engine);
            }
        }
        if (row % 10 == 0) {
            set(track.flags()[row], Flag::clipped);
        }
    }
    return track;
}

const std::vector<std::string> header(30, "a line of the header, as long as most of them are");

void from_memory(benchmark::State& state, const Track& track, const fs::path& path) {
    for ([[maybe_unused]] const auto _ : state) {
        auto file = OutputFile::create(path, {});
        if (!file || !write_track(*file, *track_format(path), track, header, {}) ||
            !file->commit()) {
            state.SkipWithError("not written");
        }
    }
}

void while_computed(benchmark::State& state, const std::vector<Track>& pieces,
                    const fs::path& path) {
    for ([[maybe_unused]] const auto _ : state) {
        auto file = OutputFile::create(path, {});
        TrackSpool spool(*file, {});
        bool written = true;
        for (const Track& piece : pieces) {
            written = written && spool.append(piece);
        }
        if (!written || !write_track(*file, *track_format(path), spool, header, {}) ||
            !file->commit()) {
            state.SkipWithError("not written");
        }
    }
}

void plain_write(benchmark::State& state, std::size_t size, const fs::path& path) {
    const std::string bytes(size, 'x');
    const std::string fresh = path.string() + ".new";
    for ([[maybe_unused]] const auto _ : state) {
        const int out = open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        const ssize_t put = write(out, bytes.data(), bytes.size());
        const bool settled = fsync(out) == 0;
        close(out);
        if (!settled || put != std::ssize(bytes) || std::rename(fresh.c_str(), path.c_str()) != 0) {
            state.SkipWithError("not written as a whole");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::string name = (fs::temp_directory_path() / "vybeg-tracks-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        std::fputs("no folder for the tracks\n", stderr);
        return 1;
    }
    const fs::path folder = name;
    const Track track = random_track(windows);
    const std::vector<Track> pieces(windows / windows_at_once, random_track(windows_at_once));
    const auto add = [](const std::string& of, auto function) {
        benchmark::RegisterBenchmark(of.c_str(), function)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1)  // the fastest counts, whatever else the machine does
            ->Repetitions(30);
    };
    const std::vector<std::string> endings{".npz", ".h5", ".mat", ".csv"};
    for (const std::string& ending : endings) {
        const fs::path path = folder / ("track" + ending);
        auto file = OutputFile::create(path, {});
        if (!file || !write_track(*file, *track_format(path), track, header, {}) ||
            !file->commit()) {
            std::fputs("the track cannot be written\n", stderr);
            return 1;
        }
        const std::size_t size = fs::file_size(path);
        add("plain write, " + ending, [=](auto& state) { plain_write(state, size, path); });
        add("from memory, " + ending, [&, path](auto& state) { from_memory(state, track, path); });
        add("while computed, " + ending,
            [&, path](auto& state) { while_computed(state, pieces, path); });
    }
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    fs::remove_all(folder);
    std::printf("\nms beyond a plain write    from memory   while computed\n");
    bool fast = true;
    for (const std::string& ending : endings) {
        const double plain = reporter.seconds("plain write, " + ending);
        const double memory = reporter.seconds("from memory, " + ending) - plain;
        const double computed = reporter.seconds("while computed, " + ending) - plain;
        std::printf("%-20s %17.1f %16.1f\n", ending.c_str(), 1e3 * memory, 1e3 * computed);
        if (ending == ".npz" || ending == ".h5") {
            fast = fast && memory <= most_beyond_s && computed <= most_beyond_s;
        }
    }
    return fast ? 0 : 1;
}
