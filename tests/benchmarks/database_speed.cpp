// A database of 10,000 results of five gyros: its size, and what a first chart takes from opening
// the file.
#include "core/base/number_text.h"
#include "core/database/results_database.h"
#include "core/numerics/control_chart.h"
#include "tests/core/database/made_result.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace vybeg;

constexpr int results = 10000;

// As many numbers, parameters and bytes as identify writes for four recordings.
void add_document(StoredResult& result) {
    constexpr int numbers = 1100;
    constexpr int short_numbers = 1600;
    constexpr std::size_t parameters = 31;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int k = 0; k < numbers; ++k) {
        result.json += "        \"value\": ";
        result.json += round_trip_text(uniform(random));
        result.json += ",\n";
    }
    for (int k = 0; k < short_numbers; ++k) {
        result.json += "        ";
        result.json += short_text(1e-6 * uniform(random));
        result.json += ",\n";
    }
    result.raw = {};
    for (std::size_t row = 0; row < parameters; ++row) {
        result.raw.names.push_back("run" + std::to_string(row));
        result.raw.values.push_back(uniform(random));
        for (std::size_t column = 0; column < parameters; ++column) {
            result.raw.covariance.push_back(uniform(random));
        }
    }
}

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
    StoredResult document;
    add_document(document);
    for (int k = 0; k < results; ++k) {
        StoredResult result = test::made_result(k, "G" + std::to_string(k % 5));
        result.json = document.json;
        result.raw = document.raw;
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
    state.counters["MB"] = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
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
