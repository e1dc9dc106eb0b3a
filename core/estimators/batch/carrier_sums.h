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

// Sums of the windows of a block as power series about the frequency of each window. Newton's steps
// then converge although the carrier drifts or is given with an error; windows without convergence
// are estimated one by one, a thousand times slower.
//
// The reference is the carrier if the windows of a block have its frequency, which is the usual
// case. Otherwise it follows a straight line through the frequencies of the first and the last
// window, computed from phases of a few short pieces. Windows without common hops are projected at
// that frequency; windows with common hops are moved to it from one reference of the block, some at
// a time (ProjectionSums::move()). A window without convergence moves the line. Beyond the main
// lobe of the carrier the line follows a wave only if the lobe contains none, so that of two waves
// in a window that of the carrier is estimated.
//
// x is the distance from the carrier as in taylor_window.h, (w - w0) n/2.
class CarrierSums {
public:
    // Windows of n samples, carrier w0 (rad per sample).
    CarrierSums(std::int64_t n, double w0);

    // As ProjectionSums::take().
    void take(const WindowBlock& block, std::size_t count, std::span<const double> delayed = {});

    // Computes the sums of at most lane_count windows with one reference, from `first` on, and
    // their maxima of the profile power. Returns the number of windows. Precondition: ascending
    // `first`.
    std::size_t next(std::size_t first, ProjectionBatch& batch, BatchMaximum& maximum);
    // Reference of these windows, valid until the next call.
    const TaylorFrame& frame() const { return zone_ ? *zone_ : at_->basis; }

private:
    // Basis of one reference and its sums.
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
    // x of window `from`, and its slope per window.
    struct Line {
        double x = 0;
        double slope = 0;
        double from = 0;
    } line_;
    int left_to_follow_ = 0;  // windows of the block that may move the line
    Reference* at_ = nullptr;
    // Frame of windows moved to another frequency than that of at_.
    std::optional<TaylorFrame> zone_;
    std::size_t zone_end_ = 0;
};

}  // namespace vybeg
