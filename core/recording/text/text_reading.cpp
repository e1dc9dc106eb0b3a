#include "core/recording/text/text_reading.h"

#include "core/recording/samples/text_fields.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

// Blocks between two looks at the stop token: some ten milliseconds.
constexpr std::int64_t blocks_at_once = 16;

// The finest digits of the times seen so far.
class FinestDigits {
public:
    void add(const NumberDigits& digits, double time) {
        include(digits);
        if (single_) {
            if (digits.decimals != last_decimals_) {
                last_decimals_ = digits.decimals;
                half_digit_ = half_digit_of(digits.decimals);
            }
            single_ = is_single(time, half_digit_);
        }
    }
    void add(const FinestDigits& other) {
        include({other.decimals_, other.significant_});
        single_ = single_ && other.single_;
    }

    TimeResolution resolution(double unit_s) const {
        return {std::pow(10.0, -static_cast<double>(decimals_)) * unit_s, significant_};
    }
    // Of times that were 32 bit floats before they were written, if all of these may have been.
    TimeResolution of_singles(double unit_s) const {
        TimeResolution resolution = this->resolution(unit_s);
        resolution.single_unit_s = single_ ? unit_s : 0;
        return resolution;
    }

private:
    static double half_digit_of(int decimals) { return 0.5 * std::pow(10.0, -decimals); }

    void include(const NumberDigits& digits) {
        decimals_ = std::max(decimals_, digits.decimals);
        significant_ = std::max(significant_, digits.significant);
    }

    int decimals_ = std::numeric_limits<int>::min();
    int significant_ = 1;
    bool single_ = true;
    int last_decimals_ = 0;
    double half_digit_ = half_digit_of(0);
};

// Findings in rows that follow each other, of one block or of several; rows and lines are
// counted from the first.
struct RowScan {
    UniformTimeDetector times;
    Status read{};
    std::int64_t rows = 0;
    std::int64_t lines = 0;
    LeftOut left_out{};
    std::optional<TextFault> fault{};  // after the last row
    double first_time = 0;             // in the column's unit
    double last_time = 0;              // that did not lie below the one before
    std::int64_t first_line = 0;       // of the first time; 0: there is none
    // The first time that is the one before again: times may be written more coarsely than they
    // step; of those that are even otherwise it is no error.
    std::optional<TextFault> repeated{};
    FinestDigits digits{};

    // Takes on the time of a row; false where it lies below the one before.
    bool add_time(const TextRows& row, double unit_s) {
        compare(row.lines(), row.time());
        if (fault) {
            return false;
        }
        if (rows == 0) {
            first_time = row.time();
            first_line = row.lines();
        }
        last_time = row.time();
        digits.add(row.time_digits(), row.time());
        times.add(row.time() * unit_s);
        return true;
    }

    void append(const RowScan& next) {
        const auto moved = [this](std::optional<TextFault> found) {
            if (found) {
                found->line += lines;
            }
            return found;
        };
        if (next.first_line > 0) {
            compare(lines + next.first_line, next.first_time);
            first_time = first_line > 0 ? first_time : next.first_time;
            first_line = first_line > 0 ? first_line : lines + next.first_line;
            last_time = next.last_time;
        }
        fault = fault ? fault : moved(next.fault);
        repeated = repeated ? repeated : moved(next.repeated);
        digits.add(next.digits);
        times.append(next.times);
        const LeftOut& out = next.left_out;
        if (out.rows_with_missing > 0 && left_out.rows_with_missing == 0) {
            left_out.first_missing_row = rows + out.first_missing_row;
        }
        left_out.missing_samples += out.missing_samples;
        for (std::size_t i = 0; i < out.over_range.size(); ++i) {
            left_out.over_range[i] += out.over_range[i];
        }
        left_out.rows_with_missing += out.rows_with_missing;
        left_out.lines_ignored += out.lines_ignored;
        left_out.ends_within_row = left_out.ends_within_row || out.ends_within_row;
        rows += next.rows;
        lines += next.lines;
    }

private:
    void compare(std::int64_t line, double time) {
        if (rows > 0 && time < last_time) {
            fault = time_fault(line, time, last_time);
        } else if (rows > 0 && time == last_time && !repeated) {
            repeated = time_fault(line, time, last_time);
        }
    }
};

// `empty`: the times to begin with.
RowScan scan_block(const TextTable& table, const UniformTimeDetector& empty, std::int64_t index) {
    RowScan found{empty};
    TextBlock block;
    found.read = table.blocks.read(index, block);
    if (!found.read) {
        return found;
    }
    const bool two = table.columns.d != table.columns.c;
    LeftOut& out = found.left_out;
    TextRows rows(table.format, table.columns, block, SampleUse::check);
    while (rows.next() &&
           (table.columns.time < 0 || found.add_time(rows, table.format.time_unit_s))) {
        const int missing = (std::isnan(rows.c()) ? 1 : 0) + (two && std::isnan(rows.d()) ? 1 : 0);
        if (missing > 0) {
            out.over_range[0] += rows.c_over_range() ? 1 : 0;
            out.over_range[1] += two && rows.d_over_range() ? 1 : 0;
            out.missing_samples += missing;
            if (out.rows_with_missing++ == 0) {
                out.first_missing_row = found.rows;
            }
        }
        ++found.rows;
    }
    found.fault = found.fault ? found.fault : rows.fault();
    found.lines = rows.lines();
    out.lines_ignored = rows.ignored();
    out.ends_within_row = rows.ends_within_row();
    return found;
}

// A line to which no time has been added: with about the step and resolution of the first block
// that has them, a step of 0 where none does.
Result<UniformTimeDetector> empty_line(const TextTable& table) {
    TextBlock block;
    for (std::int64_t index = 0; table.columns.time >= 0 && index < table.blocks.count(); ++index) {
        TRY(table.blocks.read(index, block));
        std::vector<double> times_s;
        FinestDigits digits;
        TextRows rows(table.format, table.columns, block, SampleUse::check);
        while (rows.next()) {
            times_s.push_back(rows.time() * table.format.time_unit_s);
            digits.add(rows.time_digits(), rows.time());
        }
        const TimeResolution resolution = digits.of_singles(table.format.time_unit_s);
        const double step_s = times_s.size() > 1 ? typical_step(times_s, resolution) : 0;
        if (step_s > 0) {
            return UniformTimeDetector(step_s, resolution);
        }
    }
    return UniformTimeDetector(0);
}

constexpr std::int64_t rows_for_threads = std::int64_t{1}
                                          << 14;  // less is read by the caller alone

// The block with a row, by the first rows of all.
std::int64_t block_of(const std::vector<std::int64_t>& first_rows, std::int64_t row) {
    return std::upper_bound(first_rows.begin(), first_rows.end(), row) - first_rows.begin() - 1;
}

// The file has been found in order when it was opened.
Error changed(const TextTable& table) {
    return table.blocks.file().error(ErrorCode::file_read_failed,
                                     {Phrase::tr("the file was changed while it was read")});
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

Result<TextScan> scan_text(const TextTable& table, const JobControl& job) {
    const auto empty = TRY(empty_line(table));
    const auto error = [&table](const TextFault& fault) {
        return fault_error(table.blocks.file(), table.format.lines_to_skip, fault);
    };
    TextScan scan;
    RowScan all{empty};
    std::vector<RowScan> blocks;
    const std::int64_t count = table.blocks.count();
    for (std::int64_t first = 0; first < count; first += blocks_at_once) {
        const std::int64_t end = std::min(first + blocks_at_once, count);
        blocks.assign(static_cast<std::size_t>(end - first), RowScan{empty});
        tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
            if (!job.cancelled()) {
                blocks[i] = scan_block(table, empty, first + static_cast<std::int64_t>(i));
            }
        });
        TRY(job.go_on());
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            TRY(blocks[i].read);
            all.append(blocks[i]);
            if (all.fault) {
                return error(*all.fault);
            }
            scan.first_rows.push_back(all.rows);
            const auto done = static_cast<double>(first) + static_cast<double>(i + 1);
            job.report(done / static_cast<double>(count));
        }
    }
    scan.left_out = all.left_out;
    scan.first_time = all.first_time;
    if (all.first_line > 0) {
        scan.resolution = all.digits.of_singles(table.format.time_unit_s);
        // Of rounded floats, no line passes all texts of more digits than a float has.
        constexpr int digits_beyond_a_float = 9;
        const TimeResolution plain = all.digits.resolution(table.format.time_unit_s);
        if (plain.significant_digits >= digits_beyond_a_float) {
            scan.even = all.times.judge(plain);
        }
        scan.even = scan.even ? scan.even : all.times.judge(scan.resolution);
    }
    if (all.repeated && !scan.even && !table.may_repeat) {
        return error(*all.repeated);
    }
    return scan;
}

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

bool append_rows(const TextTable& table, const TextBlock& block, std::size_t most,
                 TimedSamples& samples) {
    TextRows rows(table.format, table.columns, block, SampleUse::read);
    while (samples.c.size() < most && rows.next()) {
        samples.time_s.push_back(rows.time() * table.format.time_unit_s);
        samples.c.push_back(rows.c());
        samples.d.push_back(rows.d());
    }
    return !rows.fault();
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
        append_rows(table, block, static_cast<std::size_t>(scan.rows()), samples);
        job.report(static_cast<double>(index) / static_cast<double>(count));
    }
    if (static_cast<std::int64_t>(samples.c.size()) != scan.rows()) {
        return changed(table);
    }
    return samples;
}

}  // namespace vybeg
