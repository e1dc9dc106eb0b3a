#include "core/recording/samples/scaled_source.h"

#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

class ScaledSource final : public SampleSource {
public:
    ScaledSource(std::shared_ptr<const SampleSource> source, double scale)
        : source_(std::move(source)), scale_(scale) {}

    std::int64_t frames() const override { return source_->frames(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        Status status = source_->read(first, c, d);
        if (status) {
            scale_samples(c, scale_);
            scale_samples(d, scale_);
        }
        return status;
    }

private:
    std::shared_ptr<const SampleSource> source_;
    double scale_;
};

}  // namespace

void scale_samples(std::span<double> values, double scale) {
    for (double& value : values) {
        value *= scale;
        value = std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
    }
}

std::shared_ptr<const SampleSource> scaled_source(std::shared_ptr<const SampleSource> source,
                                                  double scale) {
    return std::make_shared<ScaledSource>(std::move(source), scale);
}

}  // namespace vybeg
