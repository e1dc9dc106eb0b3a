#include "core/recording/uff_reader.h"

#include "core/base/number_text.h"
#include "core/recording/memory_source.h"
#include "core/recording/selection.h"
#include "core/recording/text_fields.h"
#include "core/recording/text_lines.h"
#include "core/recording/uff_dataset.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::string_view separator = "-1";  // before and behind each dataset
constexpr std::string_view time_history = "58";
constexpr std::int64_t lines_per_report = 1 << 14;
constexpr std::size_t most_channels = 4096;

bool is_dataset_number(std::string_view text) {
    return !text.empty() && text.size() <= 6 &&
           text.find_first_not_of("0123456789") == std::string_view::npos;
}

// "58b" and the numbers behind it.
bool is_binary_dataset(std::string_view line) {
    const std::size_t end = std::min(line.find_first_of("bB"), line.size());
    return end < line.size() && is_dataset_number(line.substr(0, end));
}

// Takes a file's lines one after the other and keeps the values of the two channels that are asked
// for.
class UffFile {
public:
    UffFile(const FileBytes& file, const OpenOptions& options) : file_(file), options_(options) {}

    // `ended`: the line has a line end; without one its last number may be cut off.
    Status take(std::string_view line, std::int64_t number, bool ended) {
        if (trimmed(line) == separator) {
            return take_separator();
        }
        switch (place_) {
            case Place::outside: return {};
            case Place::number: return take_number(trimmed(line));
            case Place::header: return take_header(line);
            case Place::data: return ended ? take_data(line, number) : Status{};
        }
        return {};
    }

    Result<Recording> finish() {
        if (channels_.empty()) {
            return unsupported("no time response (dataset 58)");
        }
        const UffFunction& first = channels_.front();
        if (const Status status =
                check_channels(file_, static_cast<int>(channels_.size()), options_);
            !status) {
            return status.error();
        }
        const bool has_step = std::isfinite(1 / first.step_s) && first.step_s > 0;
        const auto rate =
            choose_rate(file_,
                        has_step ? std::optional(SampleRate{1 / first.step_s, RateOrigin::file,
                                                            first.step_relative_sd})
                                 : std::nullopt,
                        options_);
        if (!rate) {
            return rate.error();
        }
        const std::size_t frames = std::min(c_.size(), d_.size());
        if (const Status status = check_frames(file_, static_cast<std::int64_t>(frames)); !status) {
            return status.error();
        }
        c_.resize(frames);
        d_.resize(frames);
        Recording recording;
        recording.path = file_.path();
        recording.format = "UFF, dataset 58, " + std::to_string(channels_.size()) + " channels";
        recording.rate_hz = rate->hz;
        recording.rate_from = rate->from;
        recording.rate_relative_sd = rate->relative_sd;
        recording.channels = numbered_channels(static_cast<int>(channels_.size()));
        for (std::size_t i = 0; i < channels_.size(); ++i) {
            recording.channels[i].unit = channels_[i].unit;
            if (!channels_[i].name.empty()) {
                recording.channels[i].name = channels_[i].name;
            }
        }
        recording.channel_c = options_.channel_c;
        recording.channel_d = options_.channel_d;
        recording.start = first.start;
        recording.source = std::make_shared<MemorySource>(std::move(c_), std::move(d_));
        note_early_end(first.count, recording);
        return recording;
    }

private:
    enum class Place { outside, number, header, data };

    Error damaged(const std::string& reason) const {
        return file_.error(ErrorCode::format_damaged, {"UFF", reason});
    }

    Error unsupported(const std::string& what) const {
        return file_.error(ErrorCode::format_unsupported, {"UFF", what});
    }

    Status take_separator() {
        if (place_ == Place::header) {
            return damaged("a dataset 58 ends within its header");
        }
        if (place_ == Place::data && is_channel_ && taken_ < channels_.back().count) {
            return damaged("a dataset 58 has " + integer_text(taken_) +
                           " values, and its header says " + integer_text(channels_.back().count));
        }
        // Datasets of other kinds, too, end with a separator.
        const bool begins = place_ == Place::number || (place_ == Place::outside && !skipping_);
        place_ = begins ? Place::number : Place::outside;
        skipping_ = false;
        return {};
    }

    Status take_number(std::string_view line) {
        if (is_binary_dataset(line)) {
            return unsupported("binary data (dataset " + std::string(line.substr(0, 3)) + ")");
        }
        place_ = line == time_history ? Place::header : Place::outside;
        skipping_ = place_ == Place::outside;
        header_.clear();
        return {};
    }

    Status take_header(std::string_view line) {
        header_.emplace_back(line);
        if (header_.size() < uff_header_lines) {
            return {};
        }
        auto function = parse_uff_header(header_);
        if (!function) {
            return damaged("the header of a dataset 58 cannot be understood");
        }
        place_ = Place::data;
        taken_ = 0;
        is_channel_ = function->is_time_response();
        if (!is_channel_) {
            return {};
        }
        if (function->is_complex) {
            return unsupported("complex values");
        }
        if (!function->is_even) {
            return unsupported("unevenly spaced values");
        }
        if (channels_.size() == most_channels) {
            return unsupported("more than " + std::to_string(most_channels) + " channels");
        }
        is_channel_ = channels_.empty() || (channels_.front().count == function->count &&
                                            channels_.front().step_s == function->step_s);
        if (is_channel_) {
            channels_.push_back(std::move(*function));
        }
        return {};
    }

    Status take_data(std::string_view line, std::int64_t number) {
        if (!is_channel_) {
            return {};
        }
        const auto channel = static_cast<int>(channels_.size());
        values_.clear();
        if (!parse_uff_values(line, values_)) {
            return damaged("line " + integer_text(number) + " is not a row of numbers");
        }
        taken_ += static_cast<std::int64_t>(values_.size());
        if (taken_ > channels_.back().count) {
            return damaged("line " + integer_text(number) +
                           " has more values than the header says");
        }
        if (channel == options_.channel_c) {
            c_.insert(c_.end(), values_.begin(), values_.end());
        }
        if (channel == options_.channel_d) {
            d_.insert(d_.end(), values_.begin(), values_.end());
        }
        return {};
    }

    const FileBytes& file_;
    const OpenOptions& options_;
    Place place_ = Place::outside;
    bool skipping_ = false;    // inside of a dataset of another kind
    bool is_channel_ = false;  // the values of this dataset are the last channel's
    std::int64_t taken_ = 0;   // of them
    std::vector<std::string> header_;
    std::vector<double> values_;
    std::vector<UffFunction> channels_;
    std::vector<double> c_;
    std::vector<double> d_;
};

}  // namespace

bool is_uff(std::string_view head) {
    const std::size_t end = head.find_first_of("\r\n");
    if (end == head.npos || trimmed(head.substr(0, end)) != separator) {
        return false;
    }
    head.remove_prefix(std::min(head.find_first_not_of("\r\n", end), head.size()));
    const std::string_view second = trimmed(head.substr(0, head.find_first_of("\r\n")));
    return is_dataset_number(second) || is_binary_dataset(second);
}

Result<Recording> open_uff(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job) {
    TextLines lines(file);
    UffFile content(*file, options);
    std::size_t taken = 0;  // bytes
    for (;;) {
        const auto line = lines.next();
        if (!line) {
            return line.error();
        }
        if (!*line) {
            return content.finish();
        }
        if (const Status status = content.take(**line, lines.number(), lines.ended()); !status) {
            return status.error();
        }
        taken += (*line)->size() + 1;
        if (lines.number() % lines_per_report == 0) {
            if (job.cancelled()) {
                return file->error(ErrorCode::interrupted);
            }
            job.report(
                std::min(1.0, static_cast<double>(taken) / static_cast<double>(file->size())));
        }
    }
}

}  // namespace vybeg
