#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// Mean squared errors, both channels summed, of a linear prediction from the 16 samples before, for
// each block of `block` frames. One prediction for both channels is fitted to a sample of the
// blocks. A sum of up to eight decaying modes in noise has small errors everywhere except at lost
// samples. NaN for the first block, blocks with missing samples and the blocks after these.
std::vector<double> prediction_errors(std::span<const double> c, std::span<const double> d,
                                      std::size_t block);

}  // namespace vybeg
