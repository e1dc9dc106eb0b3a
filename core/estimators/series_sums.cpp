#include "core/estimators/series_sums.h"

#include <algorithm>

namespace vybeg {
namespace {

// Shorter windows are projected faster than they are put together.
constexpr std::int64_t longest_apart = 128;

SampleColumns columns_of(const WindowBlock& block, std::span<const double> delayed) {
    const SampleColumns all{block.c.data(), block.d.data(),
                            delayed.empty() ? nullptr : delayed.data()};
    return all.from(block.first);
}

}  // namespace

SeriesCut SeriesSums::cut(std::int64_t first, std::int64_t length, double distance) const {
    SeriesCut cut{first, length, {}};
    if (first + length > basis_.stretch()) {
        for (std::int64_t j = 0; j < length; j += basis_.stretch()) {
            cut.shifts.push_back(series_shift(basis_, distance + static_cast<double>(j)));
        }
    }
    return cut;
}

void SeriesSums::prepare(std::int64_t hop) {
    const std::int64_t n = basis_.length();
    hop_ = hop;
    overlapping_ = n > longest_apart && 2 * hop <= n;
    if (!overlapping_) {
        whole_ = cut(0, n, 0.5 * static_cast<double>(basis_.stretch() - n));
    } else {
        const std::int64_t head = n % hop;
        head_ = cut(0, head, 0);
        rest_ = cut(head, hop - head, static_cast<double>(head));
    }
}

void SeriesSums::take(const WindowBlock& block, std::size_t count,
                      std::span<const double> delayed) {
    block_ = block;
    delayed_ = delayed;
    if (block.hop != hop_) {
        prepare(block.hop);
    }
    if (overlapping_) {
        project_hops(count);
        join_hops(count);
    }
}

// The block's hops as runs of one, and their heads.
void SeriesSums::project_hops(std::size_t count) {
    const auto in_window = static_cast<std::size_t>(basis_.length() / hop_);
    const std::size_t whole = count + in_window - 1;
    const std::size_t heads = head_.length > 0 ? whole + 1 : 0;
    runs_.reset(whole);
    heads_.reset(heads);
    const auto put = [](RunTable& table, std::size_t run, const SeriesBatch& batch) {
        for_numbers(batch, [&](std::size_t kind, const Lanes& lanes) {
            std::copy(lanes.begin(), lanes.end(), &table.numbers[kind * table.pitch + run]);
        });
    };
    const SampleColumns block = columns_of(block_, delayed_);
    for (std::size_t run = 0; run < std::max(whole, heads); run += series_lanes) {
        const SampleColumns samples = block.from(static_cast<std::int64_t>(run) * hop_);
        SeriesBatch head;
        if (run < heads) {
            sum_cuts(samples, hop_, std::min(series_lanes, heads - run), head_, basis_, head);
            put(heads_, run, head);
        }
        if (run < whole) {
            SeriesBatch hop;
            sum_cuts(samples, hop_, std::min(series_lanes, whole - run), rest_, basis_, hop);
            if (heads > 0) {
                for_numbers(hop, [&](std::size_t kind, Lanes& lanes) {
                    for (std::size_t lane = 0; lane < series_lanes; ++lane) {
                        lanes[lane] += heads_.numbers[kind * heads_.pitch + run + lane];
                    }
                });
            }
            put(runs_, run, hop);
        }
    }
}

void SeriesSums::join_hops(std::size_t count) {
    windows_.reset(count);
    std::fill(windows_.numbers.begin(), windows_.numbers.end(), 0.0);
    const auto hop = static_cast<double>(hop_);
    // From the middle of a stretch that begins with a window to the window's.
    const double to_centre = 0.5 * static_cast<double>(basis_.stretch() - basis_.length());
    const auto whole = static_cast<std::size_t>(basis_.length() / hop_);
    std::size_t runs = count + whole - 1;
    std::size_t done = 0;  // hops of the windows
    const auto add = [&](const RunTable& from) {
        add_shifted_runs(windows_, from, done, count,
                         series_shift(basis_, static_cast<double>(done) * hop + to_centre));
    };
    for (std::size_t length = 1; length <= whole; length *= 2) {
        if ((whole & length) != 0) {
            add(runs_);
            done += length;
        }
        if (2 * length <= whole) {
            runs -= length;
            add_shifted_runs(runs_, runs_, length, runs,
                             series_shift(basis_, static_cast<double>(length) * hop));
        }
    }
    if (head_.length > 0) {
        add(heads_);
    }
}

void SeriesSums::batch(std::size_t first, std::size_t count, SeriesBatch& batch) const {
    if (!overlapping_) {
        const SampleColumns block = columns_of(block_, delayed_);
        sum_cuts(block.from(static_cast<std::int64_t>(first) * hop_), hop_, count, whole_, basis_,
                 batch);
        return;
    }
    for_numbers(batch, [&](std::size_t kind, Lanes& lanes) {
        const double* from = &windows_.numbers[kind * windows_.pitch + first];
        for (std::size_t lane = 0; lane < series_lanes; ++lane) {
            lanes[lane] = from[std::min(lane, count - 1)];
        }
    });
}

}  // namespace vybeg
