#pragma once

#include "core/recording/samples/sample_source.h"

#include <vector>

namespace vybeg {

// Samples in memory.
class MemorySource : public SampleSource {
public:
    // Precondition: equal lengths.
    MemorySource(std::vector<double> c, std::vector<double> d);

    std::int64_t frames() const override;
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override;

private:
    std::vector<double> c_;
    std::vector<double> d_;
};

}  // namespace vybeg
