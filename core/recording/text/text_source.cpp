#include "core/recording/text/text_source.h"

#include "core/recording/samples/recent_blocks.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::int64_t rows_for_threads = std::int64_t{1}
                                          << 14;  // less is read by the caller alone

// The block with a row, by the first rows of all.
std::int64_t block_of(const std::vector<std::int64_t>& first_rows, std::int64_t row) {
    return std::upper_bound(first_rows.begin(), first_rows.end(), row) - first_rows.begin() - 1;
}

// The file has been found in order when it was opened.
Error changed(const TextTable& table) {
    return table.blocks.file().error(ErrorCode::file_read_failed,
                                     {"the file was changed while it was read"});
}

// The rows of a table one after the other.
class TextSource final : public SampleSource {
public:
    TextSource(TextTable table, std::vector<std::int64_t> first_rows)
        : table_(std::move(table)), first_rows_(std::move(first_rows)) {
        table_.columns.time = -1;  // it has done its part
    }

    std::int64_t frames() const override { return first_rows_.back(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        if (c.empty()) {
            return {};
        }
        const std::int64_t end = first + static_cast<std::int64_t>(c.size());
        const std::int64_t first_block = block_of(first_rows_, first);
        const std::int64_t last_block = block_of(first_rows_, end - 1);
        std::vector<Status> read(static_cast<std::size_t>(last_block - first_block + 1));
        const auto read_block = [&](std::int64_t index) {
            const auto samples = block_samples(index, index == last_block);
            if (samples) {
                (*samples)->copy_to(first, c, d);
            } else {
                read[static_cast<std::size_t>(index - first_block)] = samples.error();
            }
        };
        if (end - first < rows_for_threads) {
            for (std::int64_t index = first_block; index <= last_block; ++index) {
                read_block(index);
            }
        } else {
            // Isolated: while it waits, this thread takes no other work, which could be long.
            tbb::this_task_arena::isolate(
                [&] { tbb::parallel_for(first_block, last_block + 1, read_block); });
        }
        const auto failed = std::ranges::find_if(read, [](const Status& s) { return !s; });
        return failed == read.end() ? Status{} : *failed;
    }

private:
    // A block's samples; they are kept until another block's are.
    Result<SampleBlockPointer> block_samples(std::int64_t index, bool keep) const {
        if (auto kept = kept_.find(index)) {
            return kept;
        }
        TextBlock block;
        TRY(table_.blocks.read(index, block));
        const auto at = static_cast<std::size_t>(index);
        const auto count = static_cast<std::size_t>(first_rows_[at + 1] - first_rows_[at]);
        auto samples = std::make_shared<SampleBlock>();
        samples->index = index;
        samples->first = first_rows_[at];
        samples->c.reserve(count);
        samples->d.reserve(count);
        TextRows rows(table_.format, table_.columns, block, SampleUse::read);
        while (rows.next() && samples->c.size() <= count) {
            samples->c.push_back(rows.c());
            samples->d.push_back(rows.d());
        }
        if (rows.fault() || samples->c.size() != count) {
            return changed(table_);
        }
        if (keep) {
            kept_.keep(samples);
        }
        return SampleBlockPointer(std::move(samples));
    }

    TextTable table_;
    std::vector<std::int64_t> first_rows_;
    RecentBlocks kept_{1};
};

}  // namespace

std::shared_ptr<const SampleSource> text_source(const TextTable& table, const TextScan& scan) {
    const auto rows = std::make_shared<TextSource>(table, scan.first_rows);
    if (!scan.even || scan.even->segments.size() == 1) {
        return rows;
    }
    std::vector<SourcePiece> pieces;
    for (const RowSegment& segment : scan.even->segments) {
        pieces.push_back({segment.first_frame, rows, segment.first_row, segment.rows});
    }
    return joined_source(std::move(pieces));
}

Result<TimedSamples> read_timed_rows(const TextTable& table, const TextScan& scan,
                                     const JobControl& job) {
    TimedSamples samples;
    samples.resolution = scan.resolution;
    for (std::vector<double>* values : {&samples.time_s, &samples.c, &samples.d}) {
        values->reserve(static_cast<std::size_t>(scan.rows()));
    }
    TextBlock block;
    const std::int64_t count = table.blocks.count();
    for (std::int64_t index = 0; index < count; ++index) {
        TRY(job.go_on());
        TRY(table.blocks.read(index, block));
        TextRows rows(table.format, table.columns, block, SampleUse::read);
        while (rows.next() && static_cast<std::int64_t>(samples.c.size()) < scan.rows()) {
            samples.time_s.push_back(rows.time() * table.format.time_unit_s);
            samples.c.push_back(rows.c());
            samples.d.push_back(rows.d());
        }
        job.report(static_cast<double>(index) / static_cast<double>(count));
    }
    if (static_cast<std::int64_t>(samples.c.size()) != scan.rows()) {
        return changed(table);
    }
    return samples;
}

}  // namespace vybeg
