#include "core/recording/conditioning/calibrated_source.h"

#include "core/recording/samples/delayed_source.h"

#include <utility>

namespace vybeg {
namespace {

class CalibratedSource final : public SampleSource {
public:
    CalibratedSource(std::shared_ptr<const SampleSource> source, const Calibration& calibration)
        : source_(std::move(source)),
          kappa_(calibration.kappa),
          offset_c_(calibration.offset_c),
          offset_d_(calibration.offset_d) {}

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        TRY(source_->read(first, c, d));
        for (double& value : c) {
            value -= offset_c_;
        }
        for (double& value : d) {
            value = kappa_ * (value - offset_d_);
        }
        return {};
    }

private:
    std::shared_ptr<const SampleSource> source_;
    double kappa_;
    double offset_c_;
    double offset_d_;
};

}  // namespace

std::shared_ptr<const SampleSource> calibrated(std::shared_ptr<const SampleSource> source,
                                               const Calibration& calibration, double rate_hz) {
    if (calibration.delay_d_s != 0) {
        source = delayed_source(std::move(source), -calibration.delay_d_s * rate_hz);
    }
    if (calibration.kappa == 1 && calibration.offset_c == 0 && calibration.offset_d == 0) {
        return source;
    }
    return std::make_shared<CalibratedSource>(std::move(source), calibration);
}

}  // namespace vybeg
