#pragma once

#include "core/estimators/batch/profile.h"
#include "core/estimators/batch/projection_sums.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace vybeg {

// The sums of a block's windows as power series about the frequency that each of them has, so that
// Newton's steps arrive whether the carrier drifts or was told wrong: a window in which they do not
// is estimated by itself, a thousand times slower.
//
// Where the windows of a block have the carrier's frequency, as almost always, that is the
// reference. Else it follows a straight line through the frequencies that the phases of a few short
// pieces tell of the first and the last window. Windows that stand apart are projected at that
// frequency; those that share their hops are brought to it from one reference for the block, some
// of them at a time (ProjectionSums::move()). A window in which the steps do not arrive all the
// same moves the line. Beyond the carrier's main lobe the line follows a wave only
// where the lobe holds none: with two waves in a window, that of the carrier is estimated.
//
// x is the distance from the carrier as in taylor_window.h, (w - w0) n/2.
class CarrierSums {
public:
    // Windows of n samples, carrier w0 (rad per sample).
    CarrierSums(std::int64_t n, double w0);

    // As ProjectionSums::take().
    void take(const WindowBlock& block, std::size_t count, std::span<const double> delayed = {});

    // The sums of windows from `first` on that have one reference, lane_count at most, and where
    // the power that they take out is largest. Returns how many. Windows are asked for in order.
    std::size_t next(std::size_t first, ProjectionBatch& batch, BatchMaximum& maximum);
    // Their reference, until the next call.
    const TaylorFrame& frame() const { return zone_ ? *zone_ : at_->basis; }

private:
    // Sums by one basis.
    struct Reference {
        TaylorBasis basis;
        ProjectionSums sums;
        Reference(std::int64_t n, double w0, std::shared_ptr<ProjectionSums::Tables> tables)
            : basis(n, w0), sums(basis, std::move(tables)) {}
    };

    double x_at(double window) const;
    Reference& reference(double x);
    std::optional<double> probe(std::size_t window) const;
    double rough_maximum(const ProjectionBatch& batch, std::size_t lane) const;
    void use(double x);
    std::size_t sum_up(std::size_t first, ProjectionBatch& batch);
    bool follow(std::size_t first, std::size_t lane, ProjectionBatch& batch, BatchMaximum& maximum,
                std::size_t& count);

    std::int64_t n_;
    double w0_;
    std::shared_ptr<ProjectionSums::Tables> tables_ = std::make_shared<ProjectionSums::Tables>();
    std::map<std::int64_t, std::unique_ptr<Reference>> references_;  // by x in steps
    WindowBlock block_;
    std::size_t count_ = 0;
    std::span<const double> delayed_;
    // The line: x of window `from_`, and its slope by windows.
    double x_ = 0;
    double slope_ = 0;
    double from_ = 0;
    int left_to_follow_ = 0;  // windows of the block that may move the line
    Reference* at_ = nullptr;
    std::optional<TaylorFrame> zone_;  // of windows brought to another frequency than at_'s
    std::size_t zone_end_ = 0;
};

}  // namespace vybeg
