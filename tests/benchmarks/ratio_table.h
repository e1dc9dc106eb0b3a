#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace vybeg::benchmarks {

// One line of the table: how fast `name` is against `reference`, both names of benchmarks over the
// same bytes, and the least that it should be.
struct Ratio {
    std::string name;
    std::string reference;
    double least;
};

// The usual table of times, and a table of ratios below it. Of the repetitions of a benchmark the
// fastest counts: whatever else the machine does only adds to the others.
class RatioReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override;

    // Seconds of the fastest iteration; NaN where the benchmark was not run.
    double seconds(const std::string& name) const;

    // Prints the ratios; false where one of them is below its least, or has not been measured.
    bool print(const std::vector<Ratio>& ratios) const;

private:
    std::map<std::string, double> seconds_;  // of one iteration
};

}  // namespace vybeg::benchmarks
