#pragma once

#include "core/simulation/free_decay.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

// Loses and doubles samples of one channel. Blocks are consecutive from frame 0 on.
class Recorder {
public:
    explicit Recorder(std::span<const LostSamples> lost) : lost_(lost.begin(), lost.end()) {}

    // The recorded samples of the next block.
    void record(std::vector<double>& samples);

private:
    std::vector<LostSamples> lost_;
    std::size_t next_ = 0;        // present or next fault
    std::int64_t frame_ = 0;      // of the next sample
    std::vector<double> twice_;   // of the present doubling
    std::vector<double> passed_;  // kept to reuse its memory
};

}  // namespace vybeg
