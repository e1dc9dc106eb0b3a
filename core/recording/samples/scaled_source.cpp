#include "core/recording/samples/scaled_source.h"

#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

class ScaledSource final : public SampleSource {
public:
    ScaledSource(std::shared_ptr<const SampleSource> source, double scale_c, double scale_d)
        : source_(std::move(source)), scale_c_(scale_c), scale_d_(scale_d) {}

    std::int64_t frames() const override { return source_->frames(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        Status status = source_->read(first, c, d);
        if (status) {
            scale_samples(c, scale_c_);
            scale_samples(d, scale_d_);
        }
        return status;
    }

private:
    std::shared_ptr<const SampleSource> source_;
    double scale_c_;
    double scale_d_;
};

}  // namespace

void scale_samples(std::span<double> values, double scale) {
    for (double& value : values) {
        value *= scale;
        value = std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
    }
}

std::shared_ptr<const SampleSource> scaled_source(std::shared_ptr<const SampleSource> source,
                                                  double scale_c, double scale_d) {
    return std::make_shared<ScaledSource>(std::move(source), scale_c, scale_d);
}

}  // namespace vybeg
