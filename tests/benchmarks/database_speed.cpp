// A database of 10,000 results of five gyros: what a first chart takes from opening the file.
#include "core/database/result_rows.h"
#include "core/database/results_database.h"
#include "core/numerics/control_chart.h"
#include "tests/core/database/made_result.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace vybeg;

constexpr int results = 10000;
// As long as identify writes it for four recordings.
constexpr std::size_t json_bytes = 30000;

// With SQL, in one transaction: ten thousand waits for the disk are not what is measured.
std::filesystem::path filled_database() {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / "vybeg-database-benchmark.db";
    std::filesystem::remove(path);
    auto database = ResultsDatabase::open(path, ResultsDatabase::Access::write, JobControl());
    if (!database) {
        std::abort();
    }
    SqliteConnection connection(path.string(), [](int) { return true; });
    SqliteTransaction transaction(connection, "BEGIN IMMEDIATE");
    for (int k = 0; k < results; ++k) {
        StoredResult result = test::made_result(k, "G" + std::to_string(k % 5));
        result.json.resize(json_bytes, ' ');
        write_result(connection, result);
    }
    transaction.commit();
    return path;
}

const std::filesystem::path& database_path() {
    static const std::filesystem::path path = filled_database();
    return path;
}

// Opens the file, takes the history and makes the charts.
void first_chart(benchmark::State& state, const std::optional<std::string>& gyro) {
    const std::filesystem::path& path = database_path();
    std::size_t points = 0;
    for (auto _ : state) {
        auto database = ResultsDatabase::open(path, ResultsDatabase::Access::read, JobControl());
        const auto history = database->history(gyro, "tau_s");
        std::vector<double> values;
        std::vector<double> u;
        for (const HistoryPoint& point : *history) {
            values.push_back(point.value.value);
            u.push_back(point.value.uncertainty());
        }
        points = values.size();
        benchmark::DoNotOptimize(control_charts(values, u, 100));
    }
    state.counters["points"] = static_cast<double>(points);
}

void all_gyros(benchmark::State& state) {
    first_chart(state, std::nullopt);
}
void one_gyro(benchmark::State& state) {
    first_chart(state, "G3");
}

// With the wait for the disk that makes it safe.
void add_a_result(benchmark::State& state) {
    auto database =
        ResultsDatabase::open(database_path(), ResultsDatabase::Access::write, JobControl());
    const StoredResult result = test::made_result(1);
    for (auto _ : state) {
        benchmark::DoNotOptimize(database->add(result));
    }
}

BENCHMARK(all_gyros)->Unit(benchmark::kMillisecond);
BENCHMARK(one_gyro)->Unit(benchmark::kMillisecond);
BENCHMARK(add_a_result)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
