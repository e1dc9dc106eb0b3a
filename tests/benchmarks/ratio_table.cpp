#include "tests/benchmarks/ratio_table.h"

#include <algorithm>
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

bool RatioReporter::print(const std::vector<Ratio>& ratios) const {
    std::printf("\n%-28s %-24s %8s %8s\n", "speed of", "against", "ratio", "least");
    bool enough = true;
    for (const Ratio& ratio : ratios) {
        const auto measured = seconds_.find(ratio.name);
        const auto reference = seconds_.find(ratio.reference);
        if (measured == seconds_.end() || reference == seconds_.end()) {
            std::printf("%-28s %-24s not measured\n", ratio.name.c_str(), ratio.reference.c_str());
            enough = false;
            continue;
        }
        const double value = reference->second / measured->second;
        std::printf("%-28s %-24s %8.2f %8.2f\n", ratio.name.c_str(), ratio.reference.c_str(), value,
                    ratio.least);
        enough = enough && value >= ratio.least;
    }
    return enough;
}

}  // namespace vybeg::benchmarks
