#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// The mean squares, both channels summed, that a linear prediction from the 16 samples before
// leaves of each block of `block` frames. The prediction is one for both channels and fits the
// sampled part of the blocks best; a sum of up to eight decaying modes in noise has small errors
// everywhere, and larger ones where samples were lost. NaN for the first block, blocks with missing
// samples and those behind one.
std::vector<double> prediction_errors(std::span<const double> c, std::span<const double> d,
                                      std::size_t block);

}  // namespace vybeg
