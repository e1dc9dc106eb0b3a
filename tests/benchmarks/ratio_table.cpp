#include "tests/benchmarks/ratio_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vybeg::benchmarks {

void RatioReporter::ReportRuns(const std::vector<Run>& runs) {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.iterations == 0) {
            continue;
        }
        const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
        const auto [known, first] = seconds_.emplace(run.run_name.function_name, seconds);
        known->second = std::min(known->second, seconds);
    }
}

double RatioReporter::seconds(const std::string& name) const {
    const auto measured = seconds_.find(name);
    return measured == seconds_.end() ? std::nan("") : measured->second;
}

bool RatioReporter::print(const std::vector<Ratio>& ratios) const {
    std::printf("\n%-28s %-24s %8s %8s\n", "speed of", "against", "ratio", "least");
    bool enough = true;
    for (const Ratio& ratio : ratios) {
        const double value = seconds(ratio.reference) / seconds(ratio.name);
        if (std::isnan(value)) {
            std::printf("%-28s %-24s not measured\n", ratio.name.c_str(), ratio.reference.c_str());
            enough = false;
            continue;
        }
        std::printf("%-28s %-24s %8.2f %8.2f\n", ratio.name.c_str(), ratio.reference.c_str(), value,
                    ratio.least);
        enough = enough && value >= ratio.least;
    }
    return enough;
}

}  // namespace vybeg::benchmarks
