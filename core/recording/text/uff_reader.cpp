#include "core/recording/text/uff_reader.h"

#include "core/base/message_arg.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_lines.h"
#include "core/recording/text/uff_dataset.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// The lines of a Universal File one after the other, without their ends (LF, CRLF, CR). What is
// binary between them is skipped by its length. Holds one chunk of the file in memory.
class UffLines {
public:
    explicit UffLines(std::shared_ptr<const FileBytes> file) : file_(std::move(file)) {}

    // The next line, valid until the next call; nothing after the last one. Errors:
    // file_read_failed; format_limit where a line is longer than 1 MiB.
    Result<std::optional<std::string_view>> next();

    // Precondition: `bytes` is not negative.
    void skip(std::int64_t bytes);

    std::int64_t number() const { return number_; }  // of the line last returned, from 1
    bool ended() const { return ended_; }            // whether that line had a line end
    // Of what follows that line, bytes from the start of the file.
    std::int64_t position() const { return offset_ - static_cast<std::int64_t>(rest().size()); }

private:
    std::string_view rest() const { return std::string_view(buffer_).substr(begin_); }
    Result<bool> fill();

    std::shared_ptr<const FileBytes> file_;
    std::string buffer_;  // bytes before offset_; from begin_ on they are not yet returned
    std::size_t begin_ = 0;
    std::int64_t offset_ = 0;  // in the file
    std::int64_t number_ = 0;
    bool ended_ = true;
};

constexpr std::size_t uff_chunk_bytes = std::size_t{1} << 16;

Result<std::optional<std::string_view>> UffLines::next() {
    std::size_t looked = 0;  // without a line end so far
    for (;;) {
        const std::size_t end = rest().find_first_of("\r\n", looked);
        // A CR at the end of the chunk may be half of a CRLF.
        if (end != std::string_view::npos && (rest()[end] == '\n' || end + 1 < rest().size())) {
            const std::string_view line = rest().substr(0, end);
            begin_ += end + (rest().substr(end, 2) == "\r\n" ? 2 : 1);
            ++number_;
            ended_ = true;
            return std::optional(line);
        }
        looked = std::min(end, rest().size());
        if (looked > longest_line) {
            return line_too_long(*file_, "UFF", number_ + 1);
        }
        const auto more = TRY(fill());
        if (!more) {
            break;
        }
    }
    if (rest().empty()) {
        return std::optional<std::string_view>();
    }
    ended_ = rest().back() == '\r';
    const std::string_view line = rest().substr(0, rest().size() - (ended_ ? 1 : 0));
    begin_ = buffer_.size();
    ++number_;
    return std::optional(line);
}

void UffLines::skip(std::int64_t bytes) {
    const auto held = static_cast<std::int64_t>(rest().size());
    begin_ += static_cast<std::size_t>(std::min(bytes, held));
    offset_ += std::min(std::max<std::int64_t>(bytes - held, 0), file_->size() - offset_);
}

// False at the end of the file.
Result<bool> UffLines::fill() {
    buffer_.erase(0, begin_);
    begin_ = 0;
    const std::size_t held = buffer_.size();
    buffer_.resize(held + uff_chunk_bytes);
    const auto got = TRY(file_->read(offset_, std::span(buffer_).subspan(held)));
    buffer_.resize(held + static_cast<std::size_t>(got));
    offset_ += got;
    return got > 0;
}

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

// Numbers that were text, as the bytes of a column.
class HeldNumbers final : public ByteSource {
public:
    explicit HeldNumbers(std::vector<double> values) : values_(std::move(values)) {}

    std::int64_t size() const override {
        return static_cast<std::int64_t>(values_.size() * sizeof(double));
    }

    Status read(std::int64_t offset, std::span<char> out) const override {
        std::memcpy(out.data(), reinterpret_cast<const char*>(values_.data()) + offset, out.size());
        return {};
    }

private:
    std::vector<double> values_;
};

// The samples of a channel that is read: values of text so far, or a place in the file.
struct UffSamples {
    std::vector<double> values;
    std::optional<SampleColumn> binary;

    SampleColumn take() {
        if (binary) {
            return std::move(*binary);
        }
        const auto count = static_cast<std::int64_t>(values.size());
        constexpr bool big_endian = std::endian::native == std::endian::big;
        return {std::make_shared<HeldNumbers>(std::move(values)),
                NumberType::f64,
                {even_run(count, 0, sizeof(double), big_endian)}};
    }
};

// Takes a file's lines one after the other and keeps the samples of the two channels that are asked
// for.
class UffFile {
public:
    UffFile(std::shared_ptr<const FileBytes> file, const OpenOptions& options)
        : shared_(std::move(file)), file_(*shared_), options_(options) {}

    // Bytes that follow the line last taken and are no lines.
    std::int64_t bytes_to_skip() { return std::exchange(to_skip_, 0); }

    // `ended`: the line has a line end; without one its last number may be cut off.
    // `behind`: where in the file the next line begins.
    Status take(std::string_view line, std::int64_t number, bool ended, std::int64_t behind) {
        if (trimmed(line) == separator) {
            return take_separator();
        }
        switch (place_) {
            case Place::outside: return {};
            case Place::number: return take_number(trimmed(line));
            case Place::header: return take_header(line, behind);
            case Place::data: return ended ? take_data(line, number) : Status{};
        }
        return {};
    }

    Result<Recording> finish() {
        if (channels_.empty()) {
            return unsupported(VYBEG_MESSAGE("Words", "no time response (dataset 58)"));
        }
        const UffFunction& first = channels_.front();
        FoundSamples found;
        found.format = {FormatPart::name("UFF"),
                        FormatPart::words(any_binary_ ? VYBEG_MESSAGE("Format", "dataset 58b")
                                                      : VYBEG_MESSAGE("Format", "dataset 58")),
                        FormatPart::channels(static_cast<std::int64_t>(channels_.size()))};
        if (std::isfinite(1 / first.step_s) && first.step_s > 0) {
            found.own_rate = SampleRate{1 / first.step_s, RateOrigin::file, first.step_relative_sd};
        }
        found.channels = numbered_channels(static_cast<int>(channels_.size()));
        for (std::size_t i = 0; i < channels_.size(); ++i) {
            found.channels[i].unit = channels_[i].unit;
            if (!channels_[i].name.empty()) {
                found.channels[i].name = channels_[i].name;
            }
        }
        found.start = first.start;
        found.promised_frames = first.count;
        found.source = column_source(c_.take(), d_.take());
        found.frames = found.source->frames();
        return complete_recording(file_, std::move(found), options_);
    }

private:
    enum class Place { outside, number, header, data };

    Error damaged(const char* text, std::vector<MessageArg> args = {}) const {
        return file_.error(ErrorCode::format_damaged, {"UFF", words(text, std::move(args))});
    }

    Error unsupported(const char* text, std::vector<MessageArg> args = {}) const {
        return file_.error(ErrorCode::format_unsupported, {"UFF", words(text, std::move(args))});
    }

    Status take_separator() {
        if (place_ == Place::header) {
            return damaged(VYBEG_MESSAGE("Words", "a dataset 58 ends within its header"));
        }
        if (place_ == Place::data && is_channel_ && taken_ < channels_.back().count) {
            return damaged(
                VYBEG_MESSAGE("Words", "a dataset 58 has %1 values, and its header says %2"),
                {count_arg(taken_), count_arg(channels_.back().count)});
        }
        // Datasets of other kinds, too, end with a separator.
        const bool begins = place_ == Place::number || (place_ == Place::outside && !skipping_);
        place_ = begins ? Place::number : Place::outside;
        skipping_ = false;
        return {};
    }

    Status take_number(std::string_view line) {
        binary_.reset();
        if (is_binary_dataset(line)) {
            if (line.substr(0, line.find_first_of("bB")) != time_history) {
                return unsupported(
                    VYBEG_MESSAGE("Words", "binary data of another dataset than 58 (%1)"),
                    {std::string(line.substr(0, 6))});
            }
            binary_ = parse_uff_binary(line);
            if (!binary_ || binary_->header_lines != uff_header_lines) {
                return damaged(
                    VYBEG_MESSAGE("Words", "the first line of a dataset 58b cannot be understood"));
            }
        }
        place_ = line == time_history || binary_ ? Place::header : Place::outside;
        skipping_ = place_ == Place::outside;
        header_.clear();
        return {};
    }

    Status take_header(std::string_view line, std::int64_t behind) {
        header_.emplace_back(line);
        if (header_.size() < uff_header_lines) {
            return {};
        }
        auto function = parse_uff_header(header_);
        if (!function) {
            return damaged(
                VYBEG_MESSAGE("Words", "the header of a dataset 58 cannot be understood"));
        }
        place_ = Place::data;
        taken_ = 0;
        is_channel_ = function->is_time_response();
        to_skip_ = binary_ ? binary_->bytes : 0;
        if (!is_channel_) {
            return {};
        }
        if (function->is_complex) {
            return unsupported(VYBEG_MESSAGE("Words", "complex values"));
        }
        if (!function->is_even) {
            return unsupported(VYBEG_MESSAGE("Words", "unevenly spaced values"));
        }
        if (channels_.size() == most_channels) {
            return unsupported(VYBEG_MESSAGE("Words", "more than %1 channels"),
                               {count_arg(most_channels)});
        }
        is_channel_ = channels_.empty() || (channels_.front().count == function->count &&
                                            channels_.front().step_s == function->step_s);
        if (is_channel_) {
            channels_.push_back(std::move(*function));
            return binary_ ? take_binary(behind) : Status{};
        }
        return {};
    }

    // The numbers of the last channel, which begin at `at`.
    Status take_binary(std::int64_t at) {
        const UffFunction& function = channels_.back();
        constexpr int ieee = 2, single_precision = 2, double_precision = 4;
        constexpr int little_endian = 1, of_big_endian = 2;
        if (binary_->float_format != ieee) {
            return unsupported(binary_->float_format == 1
                                   ? VYBEG_MESSAGE("Words", "floats of DEC VMS")
                               : binary_->float_format == 3
                                   ? VYBEG_MESSAGE("Words", "floats of IBM 5/370")
                                   : VYBEG_MESSAGE("Words", "binary numbers of an unknown format"));
        }
        if (function.data_type != single_precision && function.data_type != double_precision) {
            return unsupported(VYBEG_MESSAGE("Words", "binary values of the type %1"),
                               {count_arg(function.data_type)});
        }
        if (binary_->byte_order != little_endian && binary_->byte_order != of_big_endian) {
            return damaged(
                VYBEG_MESSAGE("Words", "the byte order of a dataset 58b is neither 1 nor 2"));
        }
        const NumberType type =
            function.data_type == single_precision ? NumberType::f32 : NumberType::f64;
        const std::int64_t width = bytes_of(type);
        if (function.count > binary_->bytes / width || function.count * width != binary_->bytes) {
            return damaged(
                VYBEG_MESSAGE("Words",
                              "a dataset 58b has %1 bytes, and its header says %2 values of %3"),
                {count_arg(binary_->bytes), count_arg(function.count), count_arg(width)});
        }
        any_binary_ = true;
        taken_ = function.count;
        const std::int64_t present =
            std::min(function.count, std::max<std::int64_t>(file_.size() - at, 0) / width);
        const auto channel = static_cast<int>(channels_.size());
        for (auto& [wanted, samples] :
             {std::pair(options_.channel_c, &c_), std::pair(options_.channel_d, &d_)}) {
            if (channel == wanted) {
                samples->binary = SampleColumn{
                    bytes_,
                    type,
                    {even_run(present, at, width, binary_->byte_order == of_big_endian)}};
            }
        }
        return {};
    }

    Status take_data(std::string_view line, std::int64_t number) {
        if (!is_channel_ || (binary_ && trimmed(line).empty())) {
            return {};
        }
        const auto channel = static_cast<int>(channels_.size());
        values_.clear();
        if (!parse_uff_values(line, values_)) {
            return damaged(VYBEG_MESSAGE("Words", "line %1 is not a row of numbers"),
                           {count_arg(number)});
        }
        taken_ += static_cast<std::int64_t>(values_.size());
        if (taken_ > channels_.back().count) {
            return damaged(VYBEG_MESSAGE("Words", "line %1 has more values than the header says"),
                           {count_arg(number)});
        }
        if (channel == options_.channel_c) {
            c_.values.insert(c_.values.end(), values_.begin(), values_.end());
        }
        if (channel == options_.channel_d) {
            d_.values.insert(d_.values.end(), values_.begin(), values_.end());
        }
        return {};
    }

    std::shared_ptr<const FileBytes> shared_;
    const FileBytes& file_;
    const OpenOptions& options_;
    std::shared_ptr<const ByteSource> bytes_ = file_part(shared_, 0, file_.size());
    std::optional<UffBinary> binary_;  // of this dataset, where its values are no text
    bool any_binary_ = false;
    std::int64_t to_skip_ = 0;
    Place place_ = Place::outside;
    bool skipping_ = false;    // inside of a dataset of another kind
    bool is_channel_ = false;  // the values of this dataset are the last channel's
    std::int64_t taken_ = 0;   // of them
    std::vector<std::string> header_;
    std::vector<double> values_;
    std::vector<UffFunction> channels_;
    UffSamples c_;
    UffSamples d_;
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
    UffLines lines(file);
    UffFile content(file, options);
    for (;;) {
        const auto line = TRY(lines.next());
        if (!line) {
            return content.finish();
        }
        TRY(content.take(*line, lines.number(), lines.ended(), lines.position()));
        lines.skip(content.bytes_to_skip());
        if (lines.number() % lines_per_report == 0) {
            if (job.cancelled()) {
                return file->error(ErrorCode::interrupted);
            }
            job.report(std::min(
                1.0, static_cast<double>(lines.position()) / static_cast<double>(file->size())));
        }
    }
}

}  // namespace vybeg
