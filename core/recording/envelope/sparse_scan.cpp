#include "core/recording/envelope/sparse_scan.h"

#include <algorithm>
#include <utility>

namespace vybeg {
namespace {

constexpr double look_s = 0.3;  // limit of time for slow disks
constexpr std::int64_t least_parts = 64;

// Looks as buckets of equal parts.
std::vector<EnvelopeBucket> in_parts(const std::vector<ScannedPlace>& looks, std::int64_t parts) {
    EnvelopeBucket unseen = empty_bucket;
    unseen.coverage = Coverage::none;
    std::vector<EnvelopeBucket> buckets(static_cast<std::size_t>(parts), unseen);
    for (const ScannedPlace& look : looks) {
        // Places follow from times of a file and may have any value.
        if (look.place >= 0 && look.place <= 1) {
            const auto at = static_cast<std::int64_t>(look.place * static_cast<double>(parts));
            EnvelopeBucket& bucket = buckets[static_cast<std::size_t>(std::min(at, parts - 1))];
            merge(bucket, look.seen);
            bucket.coverage = Coverage::some;
        }
    }
    return buckets;
}

}  // namespace

Result<std::vector<EnvelopeBucket>> sparse_scan(
    std::int64_t most, const JobControl& job,
    const std::function<Result<ScannedPlace>(std::int64_t part, std::int64_t parts)>& look) {
    const double until = job.now() + look_s;
    std::vector<ScannedPlace> looks;
    std::int64_t complete = 0;
    for (std::int64_t parts = least_parts; parts <= most; parts *= 2) {
        // Even parts were read with half as many parts.
        const std::int64_t step = parts > least_parts ? 2 : 1;
        for (std::int64_t part = step - 1; part < parts; part += step) {
            TRY(job.go_on());
            if (job.now() > until) {
                return complete > 0 ? in_parts(looks, complete) : std::vector<EnvelopeBucket>{};
            }
            auto seen = TRY(look(part, parts));
            looks.push_back(std::move(seen));
        }
        complete = parts;
    }
    return in_parts(looks, complete);
}

}  // namespace vybeg
