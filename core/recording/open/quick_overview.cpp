#include "core/recording/open/quick_overview.h"

#include "core/recording/bytes/file_bytes.h"
#include "core/recording/envelope/envelope.h"
#include "core/recording/open/file_format.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/text/text_recording.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::int64_t most_text_parts = 1024;
// Shorter text files open so fast that a first look is useless.
constexpr std::int64_t blocks_to_look_at = 256;
constexpr std::size_t rows_per_look = 256;

// Rows of one block of text.
struct Rows {
    std::vector<double> time;  // as in the column
    std::vector<double> c;
    std::vector<double> d;
};

// The first rows of a block, at most `most`; empty for a fault or no row.
std::optional<Rows> rows_of(const TextTable& table, std::int64_t index, std::size_t most) {
    TextBlock block;
    if (!table.blocks.read(index, block)) {
        return {};
    }
    Rows read;
    TextRows rows(table.format, table.columns, block, SampleUse::read);
    while (read.c.size() < most && rows.next()) {
        read.time.push_back(rows.time());
        read.c.push_back(rows.c());
        read.d.push_back(rows.d());
    }
    return rows.fault() || read.c.empty() ? std::nullopt : std::optional(std::move(read));
}

// Extent of a table, from its ends.
struct Extent {
    double rate_hz = 0;
    double frames = 0;
    double first_time = 0;  // as in the column
    double last_time = 0;
};

std::optional<Extent> extent_of(const TextTable& table, const OpenOptions& options) {
    const std::int64_t last = table.blocks.count() - 1;
    const auto head = rows_of(table, 0, std::numeric_limits<std::size_t>::max());
    auto tail = rows_of(table, last, std::numeric_limits<std::size_t>::max());
    if (!tail) {
        tail = rows_of(table, last - 1, std::numeric_limits<std::size_t>::max());
    }
    if (!head || !tail || head->c.size() < 2) {
        return {};
    }
    Extent extent;
    if (table.columns.time < 0) {
        const auto c = static_cast<std::size_t>(table.columns.c);
        const std::vector<SampleRate>& named = table.format.rates;
        extent.rate_hz = named.empty() ? options.rate_hz.value_or(0) : named[c].hz;
        extent.frames = static_cast<double>(head->c.size()) * static_cast<double>(last + 1);
        return extent;
    }
    const double unit_s = table.format.time_unit_s;
    extent.first_time = head->time.front();
    extent.last_time = tail->time.back();
    extent.rate_hz = static_cast<double>(head->time.size() - 1) /
                     ((head->time.back() - extent.first_time) * unit_s);
    extent.frames = (extent.last_time - extent.first_time) * unit_s * extent.rate_hz + 1;
    return extent;
}

std::optional<QuickOverview> look_at_table(const TextTable& table, const OpenOptions& options,
                                           const JobControl& job) {
    const std::int64_t blocks = table.blocks.count();
    if (blocks < blocks_to_look_at) {
        return {};
    }
    const auto extent = extent_of(table, options);
    // More frames than characters are impossible for uniform times.
    const double most_frames = static_cast<double>(table.blocks.file().size());
    if (!extent || !(extent->rate_hz > 0) || !(extent->frames >= 1) ||
        extent->frames > most_frames) {
        return {};
    }
    const auto look = [&](std::int64_t part, std::int64_t parts) -> Result<ScannedPlace> {
        auto rows = rows_of(table, blocks * part / parts, rows_per_look);
        if (!rows) {
            return table.blocks.file().error(ErrorCode::file_read_failed);
        }
        scale_samples(rows->c, options.scale);
        scale_samples(rows->d, options.scale);
        ScannedPlace seen{static_cast<double>(part) / static_cast<double>(parts),
                          bucket_of(rows->c, rows->d)};
        if (table.columns.time >= 0) {
            seen.place = (rows->time.front() - extent->first_time) /
                         (extent->last_time - extent->first_time);
        }
        return seen;
    };
    auto seen = sparse_scan(std::min(most_text_parts, blocks), job, look);
    if (!seen || seen->empty()) {
        return {};
    }
    const auto frames = static_cast<std::int64_t>(extent->frames);
    return QuickOverview{extent->rate_hz, sampled_envelope(frames, std::move(*seen))};
}

}  // namespace

std::optional<QuickOverview> quick_overview(const std::filesystem::path& path,
                                            const OpenOptions& options, const JobControl& job) {
    const auto file = FileBytes::open(path);
    if (options.raw || !file) {
        return {};
    }
    const auto head = file_head(**file);
    const FileFormat* const format = head ? find_format(*head, **file) : nullptr;
    if (!format || !format->is_text) {
        return {};
    }
    const auto table = choose_table(*file, options, job);
    return table ? look_at_table(*table, options, job) : std::nullopt;
}

}  // namespace vybeg
