#include "core/recording/conditioning/calibrated_source.h"

#include "core/numerics/fractional_delay.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

class CalibratedSource final : public SampleSource {
public:
    CalibratedSource(std::shared_ptr<const SampleSource> source, const Calibration& calibration,
                     double delay_samples)
        : source_(std::move(source)),
          kappa_(calibration.kappa),
          offset_c_(calibration.offset_c),
          offset_d_(calibration.offset_d),
          delayed_(calibration.delay_d_s != 0),
          delay_(delay_samples) {}

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        const Status status = delayed_ ? read_delayed(first, c, d) : source_->read(first, c, d);
        if (!status) {
            return status;
        }
        for (double& value : c) {
            value -= offset_c_;
        }
        for (double& value : d) {
            value = kappa_ * (value - offset_d_);
        }
        return {};
    }

private:
    Status read_delayed(std::int64_t first, std::span<double> c, std::span<double> d) const {
        const std::int64_t before = delay_.reach_before();
        const std::int64_t after = delay_.reach_after();
        std::ranges::fill(c, missing);
        std::ranges::fill(d, missing);
        const std::int64_t begin = std::max(first, before);
        const std::int64_t end = std::min(first + std::ssize(c), frames() - after);
        // Blocks bound the memory of a long read, and are never short beside what is read twice.
        const std::int64_t block = std::max<std::int64_t>(1 << 16, before + after);
        std::vector<double> raw_c;
        std::vector<double> raw_d;
        for (std::int64_t at = begin; at < end; at += block) {
            const std::int64_t length = std::min(block, end - at);
            raw_c.resize(static_cast<std::size_t>(before + length + after));
            raw_d.resize(raw_c.size());
            TRY(source_->read(at - before, raw_c, raw_d));
            std::copy_n(raw_c.begin() + before, length, c.begin() + (at - first));
            delay_.apply(
                raw_d, before,
                d.subspan(static_cast<std::size_t>(at - first), static_cast<std::size_t>(length)));
        }
        return {};
    }

    std::shared_ptr<const SampleSource> source_;
    double kappa_;
    double offset_c_;
    double offset_d_;
    bool delayed_;
    FractionalDelay delay_;
};

}  // namespace

std::shared_ptr<const SampleSource> calibrated(std::shared_ptr<const SampleSource> source,
                                               const Calibration& calibration, double rate_hz) {
    if (calibration.kappa == 1 && calibration.offset_c == 0 && calibration.offset_d == 0 &&
        calibration.delay_d_s == 0) {
        return source;
    }
    // A shift by the whole recording leaves as little of it as any larger one.
    const auto frames = static_cast<double>(source->frames());
    const double advance = std::clamp(calibration.delay_d_s * rate_hz, -frames, frames);
    return std::make_shared<CalibratedSource>(std::move(source), calibration, -advance);
}

}  // namespace vybeg
