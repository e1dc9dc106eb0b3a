#include "core/estimators/batch/projection_sums.h"

#include "core/estimators/batch/projection_kernels.h"

#include <algorithm>

namespace vybeg {
namespace {

// Up to this length a projection is faster than a sum of hops.
constexpr std::int64_t longest_apart = 128;

SampleColumns columns_of(const WindowBlock& block, std::span<const double> delayed) {
    const SampleColumns all{block.c.data(), block.d.data(),
                            delayed.empty() ? nullptr : delayed.data()};
    return all.from(block.first);
}

}  // namespace

SampleCut ProjectionSums::cut(std::int64_t first, std::int64_t length, double distance) const {
    SampleCut cut{first, length, {}};
    // A single segment needs no shift where its time equals that of the basis rows.
    if (first + length > basis_.segment() || distance != static_cast<double>(first)) {
        cut.shifts.reserve(static_cast<std::size_t>(length / basis_.segment() + 1));
        for (std::int64_t j = 0; j < length; j += basis_.segment()) {
            cut.shifts.push_back(centre_shift(basis_, distance + static_cast<double>(j)));
        }
    }
    return cut;
}

void ProjectionSums::prepare(std::int64_t hop) {
    const std::int64_t n = basis_.length();
    hop_ = hop;
    overlapping_ = n > longest_apart && 2 * hop <= n;
    if (!overlapping_) {
        whole_ = cut(0, n, 0.5 * static_cast<double>(basis_.segment() - n));
    } else {
        const std::int64_t head = n % hop;
        // The time of a hop of several segments counts from its own centre, that of a shorter one
        // from the centre of a segment.
        const double middle = 0.5 * static_cast<double>(basis_.segment() - 1);
        origin_ = hop > basis_.segment() ? 0.5 * static_cast<double>(hop - 1) : middle;
        head_ = cut(0, head, middle - origin_);
        rest_ = cut(head, hop - head, static_cast<double>(head) + middle - origin_);
    }
}

void ProjectionSums::take(const WindowBlock& block, std::size_t count,
                          std::span<const double> delayed) {
    block_ = block;
    delayed_ = delayed;
    if (block.hop != hop_) {
        prepare(block.hop);
    }
    count_ = count;
    state_ = Runs::none;
}

void ProjectionSums::move(std::size_t first, std::size_t count, const TaylorFrame& frame) {
    if (state_ != Runs::of_one_hop) {
        project_hops(count_);
        state_ = Runs::of_one_hop;
    }
    const std::size_t whole = most_moved();
    const auto hop = static_cast<double>(hop_);
    const auto n = static_cast<double>(basis_.length());
    // All sums move to the common centre of these windows.
    const double to_first = static_cast<double>(first) * hop;
    const double centre = to_first + 0.5 * (static_cast<double>(count - 1) * hop + n - 1);
    const double x = 0.5 * n * (frame.w0() - basis_.w0());
    const auto distance = [&](std::size_t run) {
        return static_cast<double>(run) * hop + origin_ - centre;
    };
    tables_->terms.reset(whole + count - 1);
    move_hops(tables_->terms, tables_->runs, first, whole + count - 1,
              {n, frame.w0(), x, distance(first), hop});
    if (head_.length > 0) {
        tables_->ends.reset(count);
        move_hops(tables_->ends, tables_->heads, first + whole, count,
                  {n, frame.w0(), x, distance(first + whole), hop});
    }
    tables_->sums.reset(count);
    sum_windows(tables_->sums, tables_->terms, tables_->ends, head_.length > 0, whole, count);
    tables_->windows.reset(count);
    move_hops(tables_->windows, tables_->sums, 0, count,
              {n, frame.w0(), 0, centre - to_first - 0.5 * (n - 1), -hop});
    in_windows_ = first;
}

// Sums of the single hops of the block, and of their heads.
void ProjectionSums::project_hops(std::size_t count) {
    const auto in_window = static_cast<std::size_t>(basis_.length() / hop_);
    const std::size_t whole = count + in_window - 1;
    const std::size_t heads = head_.length > 0 ? whole + 1 : 0;
    tables_->runs.reset(whole);
    tables_->heads.reset(heads);
    const auto put = [](HopSums& table, std::size_t run, const ProjectionBatch& batch) {
        for_numbers(batch, [&](std::size_t kind, const Lanes& lanes) {
            std::copy(lanes.begin(), lanes.end(), &table.numbers[kind * table.pitch + run]);
        });
    };
    const SampleColumns block = columns_of(block_, delayed_);
    for (std::size_t run = 0; run < std::max(whole, heads); run += lane_count) {
        const SampleColumns samples = block.from(static_cast<std::int64_t>(run) * hop_);
        ProjectionBatch head;
        if (run < heads) {
            sum_cuts(samples, hop_, std::min(lane_count, heads - run), head_, basis_, head);
            put(tables_->heads, run, head);
        }
        if (run < whole) {
            ProjectionBatch hop;
            sum_cuts(samples, hop_, std::min(lane_count, whole - run), rest_, basis_, hop);
            if (heads > 0) {
                for_numbers(hop, [&](std::size_t kind, Lanes& lanes) {
                    for (std::size_t lane = 0; lane < lane_count; ++lane) {
                        lanes[lane] +=
                            tables_->heads.numbers[kind * tables_->heads.pitch + run + lane];
                    }
                });
            }
            put(tables_->runs, run, hop);
        }
    }
}

void ProjectionSums::join_hops(std::size_t count) {
    tables_->windows.reset(count);
    std::fill(tables_->windows.numbers.begin(), tables_->windows.numbers.end(), 0.0);
    const auto hop = static_cast<double>(hop_);
    // From the centre of a window's first hop to that of the window.
    const double to_centre = origin_ - 0.5 * static_cast<double>(basis_.length() - 1);
    const auto whole = static_cast<std::size_t>(basis_.length() / hop_);
    std::size_t runs = count + whole - 1;
    std::size_t done = 0;  // hops of the windows
    const auto add = [&](const HopSums& from) {
        add_shifted_runs(tables_->windows, from, done, count,
                         centre_shift(basis_, static_cast<double>(done) * hop + to_centre));
    };
    for (std::size_t length = 1; length <= whole; length *= 2) {
        if ((whole & length) != 0) {
            add(tables_->runs);
            done += length;
        }
        if (2 * length <= whole) {
            runs -= length;
            add_shifted_runs(tables_->runs, tables_->runs, length, runs,
                             centre_shift(basis_, static_cast<double>(length) * hop));
        }
    }
    if (head_.length > 0) {
        add(tables_->heads);
    }
}

void ProjectionSums::batch(std::size_t first, std::size_t count, ProjectionBatch& batch) {
    if (!overlapping_) {
        const SampleColumns block = columns_of(block_, delayed_);
        sum_cuts(block.from(static_cast<std::int64_t>(first) * hop_), hop_, count, whole_, basis_,
                 batch);
        return;
    }
    if (state_ == Runs::none) {
        project_hops(count_);
        join_hops(count_);
        state_ = Runs::joined;
        in_windows_ = 0;
    }
    for_numbers(batch, [&](std::size_t kind, Lanes& lanes) {
        const double* from =
            &tables_->windows.numbers[kind * tables_->windows.pitch + first - in_windows_];
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            lanes[lane] = from[std::min(lane, count - 1)];
        }
    });
}

}  // namespace vybeg
