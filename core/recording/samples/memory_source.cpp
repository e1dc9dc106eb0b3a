#include "core/recording/samples/memory_source.h"

#include <algorithm>
#include <utility>

namespace vybeg {

MemorySource::MemorySource(std::vector<double> c, std::vector<double> d)
    : c_(std::move(c)), d_(std::move(d)) {}

std::int64_t MemorySource::frames() const {
    return static_cast<std::int64_t>(c_.size());
}

Status MemorySource::read(std::int64_t first, std::span<double> c, std::span<double> d) const {
    std::copy_n(c_.begin() + first, c.size(), c.begin());
    std::copy_n(d_.begin() + first, d.size(), d.begin());
    return {};
}

}  // namespace vybeg
