#include "core/recording/text/uff_reader.h"

#include "core/base/message_arg.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"
#include "core/recording/text/text_lines.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// What the eleven records at the head of a dataset 58 (function at a nodal degree of freedom) say
// of its values.
struct UffFunction {
    std::string name;   // from the first identification line, else node and direction; may be empty
    std::string start;  // third identification line: date and time
    std::string unit;   // of the values
    int data_type = 0;  // 2 and 4: real, of single and of double precision; 5 and 6: complex
    bool is_time_response = false;  // others are spectra and the like
    bool is_even = false;
    std::int64_t count = 0;
    double step_s = 0;  // seconds from value to value
    // Standard deviation of step_s relative to it, by its six digits.
    double step_relative_sd = 0;
};

constexpr int uff_header_lines = 11;

// What the identifier of a dataset 58b says of the bytes that follow its header.
struct UffBinary {
    int byte_order = 0;    // 1 little endian, 2 big endian
    int float_format = 0;  // 1 DEC VMS, 2 IEEE 754, 3 IBM 5/370
    std::int64_t bytes = 0;
};

// The characters of a line of fixed columns, without blanks; empty after its end.
std::string_view field(std::string_view line, std::size_t begin, std::size_t width) {
    return begin < line.size() ? trimmed(line.substr(begin, width)) : std::string_view{};
}

// Writers put "NONE" for an empty field.
std::string told(std::string_view text) {
    text = trimmed(text);
    return text == "NONE" ? std::string{} : to_utf8(text);
}

// E.g. "12+X": the direction is 1, 2, 3 for the axes, 4, 5, 6 for rotations, negative the other
// way.
std::string node_and_direction(std::string_view line) {
    const auto direction = whole_number<int>(field(line, 51, 4));
    const std::string_view node = field(line, 41, 10);
    if (!direction || *direction == 0 || std::abs(*direction) > 6 || node.empty()) {
        return {};
    }
    constexpr std::array<const char*, 6> axes{"X", "Y", "Z", "RX", "RY", "RZ"};
    return std::string(node) + (*direction > 0 ? "+" : "-") +
           axes[static_cast<std::size_t>(std::abs(*direction) - 1)];
}

// The values of a data line, written side by side or with blanks between them; appended to
// `values`, missing ones as NaN. Fortran's D is read as E. False where there is anything else in
// the line.
bool parse_uff_values(std::string_view line, std::vector<double>& values) {
    std::string usual;
    if (line.find_first_of("Dd") != line.npos) {
        usual = usual_number(line, false);
        line = usual;
    }
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        line.remove_prefix(line.front() == '+' ? 1 : 0);
        double value = 0;
        const auto parsed = fast_float::from_chars(line.data(), line.data() + line.size(), value);
        if (parsed.ec == std::errc::invalid_argument) {
            return false;
        }
        values.push_back(std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN());
        line.remove_prefix(static_cast<std::size_t>(parsed.ptr - line.data()));
    }
    return true;
}

// Precondition: as many lines as uff_header_lines. Nothing where a number in them is none.
std::optional<UffFunction> parse_uff_header(const std::vector<std::string>& lines) {
    const std::string& kind = lines[5];
    const std::string& form = lines[6];
    const std::string& abscissa = lines[7];
    const std::string& ordinate = lines[8];
    const auto function = whole_number<int>(field(kind, 0, 5));
    const auto data_type = whole_number<int>(field(form, 0, 10));
    const auto count = whole_number<std::int64_t>(field(form, 10, 10));
    const auto spacing = whole_number<int>(field(form, 20, 10));
    const auto axis = whole_number<int>(field(abscissa, 0, 10));
    std::vector<double> step;
    if (!function || !data_type || *data_type < 1 || *data_type > 6 || !count || *count < 0 ||
        !spacing || !axis || !parse_uff_values(field(form, 43, 13), step) || step.size() != 1) {
        return std::nullopt;
    }
    constexpr int general = 0, time_response = 1;    // of functions
    constexpr int unknown_axis = 0, time_axis = 17;  // of what they are given over
    UffFunction found;
    found.is_time_response = (*function == time_response || *function == general) &&
                             (*axis == time_axis || *axis == unknown_axis);
    found.name = told(lines[0]);
    if (found.name.empty()) {
        found.name = node_and_direction(kind);
    }
    found.start = told(lines[2]);
    found.unit = told(field(ordinate, 47, 20));
    found.data_type = *data_type;
    found.is_even = *spacing == 1;
    found.count = *count;
    found.step_s = step[0] * seconds_per(told(field(abscissa, 47, 20))).value_or(1);
    // Written as Fortran does, with the exponent of E or D: every digit counts, zeros too.
    const NumberDigits digits = digits_of(usual_number(field(form, 43, 13), false));
    found.step_relative_sd =
        step[0] > 0 ? std::pow(10.0, -digits.decimals) / std::sqrt(12.0) / step[0] : 0;
    return found;
}

// "58b" and the numbers after it. Nothing where they are none, or not of a header of 58.
std::optional<UffBinary> parse_uff_binary(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_of("bB") + 1, line.size()));
    std::array<std::int64_t, 4> numbers{};
    for (std::int64_t& value : numbers) {
        line = trimmed(line);
        const std::string_view word = line.substr(0, line.find(' '));
        const auto parsed = whole_number<std::int64_t>(word);
        if (!parsed || *parsed < 0) {
            return std::nullopt;
        }
        value = *parsed;
        line.remove_prefix(word.size());
    }
    if (numbers[2] != uff_header_lines) {
        return std::nullopt;
    }
    return UffBinary{static_cast<int>(std::min<std::int64_t>(numbers[0], 9)),
                     static_cast<int>(std::min<std::int64_t>(numbers[1], 9)), numbers[3]};
}

constexpr std::string_view separator = "-1";  // before and after each dataset
constexpr std::string_view time_history = "58";
constexpr std::int64_t lines_per_report = 1 << 14;
constexpr std::size_t most_channels = 4096;

bool is_dataset_number(std::string_view text) {
    return are_digits(text) && text.size() <= 6;
}

// "58b" and the numbers after it.
bool is_binary_dataset(std::string_view line) {
    const std::size_t end = std::min(line.find_first_of("bB"), line.size());
    return end < line.size() && is_dataset_number(line.substr(0, end));
}

// The samples of a channel that is read: values of text so far, or a place in the file.
struct UffSamples {
    std::vector<double> values;
    std::optional<SampleColumn> binary;
};

// Binary numbers beside text are read at once, as it is.
Result<std::shared_ptr<const SampleSource>> uff_source(UffSamples c, UffSamples d) {
    if (c.binary && d.binary) {
        return column_source(std::move(*c.binary), std::move(*d.binary));
    }
    for (UffSamples* each : {&c, &d}) {
        if (each->binary) {
            each->values.resize(static_cast<std::size_t>(each->binary->frames()));
            TRY(read_column(*each->binary, 0, each->values));
        }
    }
    const std::size_t frames = std::min(c.values.size(), d.values.size());
    c.values.resize(frames);
    d.values.resize(frames);
    return memory_source(std::move(c.values), std::move(d.values));
}

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
            return file_.unsupported("UFF",
                                     VYBEG_MESSAGE("Words", "no time response (dataset 58)"));
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
        auto source = TRY(uff_source(std::move(c_), std::move(d_)));
        found.source = std::move(source);
        found.present_frames = found.source->frames();
        return complete_recording(file_, std::move(found), options_);
    }

private:
    enum class Place { outside, number, header, data };

    Status take_separator() {
        if (place_ == Place::header) {
            return file_.damaged("UFF",
                                 VYBEG_MESSAGE("Words", "a dataset 58 ends within its header"));
        }
        if (place_ == Place::data && is_channel_ && taken_ < channels_.back().count) {
            return file_.damaged(
                "UFF", VYBEG_MESSAGE("Words", "a dataset 58 has %1 values, and its header says %2"),
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
                return file_.unsupported(
                    "UFF", VYBEG_MESSAGE("Words", "binary data of another dataset than 58 (%1)"),
                    {std::string(line.substr(0, 6))});
            }
            binary_ = parse_uff_binary(line);
            if (!binary_) {
                return file_.damaged(
                    "UFF",
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
        if (std::ssize(header_) < uff_header_lines) {
            return {};
        }
        auto function = parse_uff_header(header_);
        if (!function) {
            return file_.damaged(
                "UFF", VYBEG_MESSAGE("Words", "the header of a dataset 58 cannot be understood"));
        }
        place_ = Place::data;
        taken_ = 0;
        is_channel_ = function->is_time_response;
        to_skip_ = binary_ ? binary_->bytes : 0;
        if (!is_channel_) {
            return {};
        }
        if (function->data_type >= 5) {
            return file_.unsupported("UFF", VYBEG_MESSAGE("Words", "complex values"));
        }
        if (!function->is_even) {
            return file_.unsupported("UFF", VYBEG_MESSAGE("Words", "unevenly spaced values"));
        }
        if (channels_.size() == most_channels) {
            return file_.unsupported("UFF", VYBEG_MESSAGE("Words", "more than %1 channels"),
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
            return file_.unsupported(
                "UFF", binary_->float_format == 1 ? VYBEG_MESSAGE("Words", "floats of DEC VMS")
                       : binary_->float_format == 3
                           ? VYBEG_MESSAGE("Words", "floats of IBM 5/370")
                           : VYBEG_MESSAGE("Words", "binary numbers of an unknown format"));
        }
        if (function.data_type != single_precision && function.data_type != double_precision) {
            return file_.unsupported("UFF", VYBEG_MESSAGE("Words", "binary values of the type %1"),
                                     {count_arg(function.data_type)});
        }
        if (binary_->byte_order != little_endian && binary_->byte_order != of_big_endian) {
            return file_.damaged(
                "UFF",
                VYBEG_MESSAGE("Words", "the byte order of a dataset 58b is neither 1 nor 2"));
        }
        const NumberType type =
            function.data_type == single_precision ? NumberType::f32 : NumberType::f64;
        const std::int64_t width = bytes_of(type);
        if (function.count > binary_->bytes / width || function.count * width != binary_->bytes) {
            return file_.damaged(
                "UFF",
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
                    {contiguous_range(present, at, width, binary_->byte_order == of_big_endian)}};
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
            return file_.damaged("UFF", VYBEG_MESSAGE("Words", "line %1 is not a row of numbers"),
                                 {count_arg(number)});
        }
        taken_ += static_cast<std::int64_t>(values_.size());
        if (taken_ > channels_.back().count) {
            return file_.damaged(
                "UFF", VYBEG_MESSAGE("Words", "line %1 has more values than the header says"),
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
    TextLines lines(file, "UFF");
    UffFile content(file, options);
    for (;;) {
        const auto line = TRY(lines.next());
        if (!line) {
            return content.finish();
        }
        TRY(content.take(*line, lines.number(), lines.ended(), lines.position()));
        lines.skip(content.bytes_to_skip());
        if (lines.number() % lines_per_report == 0) {
            TRY(job.go_on());
            job.report(std::min(
                1.0, static_cast<double>(lines.position()) / static_cast<double>(file->size())));
        }
    }
}

}  // namespace vybeg
