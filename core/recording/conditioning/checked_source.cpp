#include "core/recording/conditioning/checked_source.h"

#include <algorithm>
#include <utility>

namespace vybeg {

CheckedSource::CheckedSource(std::shared_ptr<const SampleSource> source,
                             std::shared_ptr<FaultCheck> check)
    : source_(std::move(source)), watch_(Watch{std::move(check)}) {}

Status CheckedSource::read(std::int64_t first, std::span<double> c, std::span<double> d) const {
    TRY(source_->read(first, c, d));
    const auto watch = watch_.hold();
    const auto end = first + static_cast<std::int64_t>(c.size());
    if (end > watch->next) {
        const auto seen = static_cast<std::size_t>(std::max<std::int64_t>(watch->next - first, 0));
        watch->check->add(first + static_cast<std::int64_t>(seen), c.subspan(seen),
                          d.subspan(seen));
        watch->next = end;
    }
    return {};
}

}  // namespace vybeg
