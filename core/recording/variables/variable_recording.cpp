#include "core/recording/variables/variable_recording.h"

#include "core/recording/samples/reader_rules.h"
#include "core/recording/samples/vocabulary.h"
#include "core/recording/times/time_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

// Which of a file's variables are the recording.
struct VariableChoice {
    std::vector<ChannelPlace> channels;  // all that options.channel_c and channel_d choose from
    std::int64_t frames = 0;
    std::vector<Channel> names;  // of each channel
    std::optional<SampleRate> rate;
    std::optional<std::int64_t> time;       // the variable that holds the times
    double time_unit_s = 1;                 // in which those count
    std::optional<std::int64_t> time_of_d;  // where D's struct or group has times of its own
};

// Whether two rates are one, as files round them.
bool same_rate(double one_hz, double other_hz) {
    return std::abs(one_hz / other_hz - 1) < 1e-4;
}

// The error of a file that states two rates: format_unsupported.
Error two_rates(const FileBytes& file, const std::string& format, double first_hz,
                double second_hz) {
    return file.unsupported(
        format,
        VYBEG_MESSAGE("Words",
                      "two sample rates, %1 and %2 Hz (--variables C,D,RATE tells "
                      "which holds)"),
        {number_arg(first_hz), number_arg(second_hz)});
}

constexpr std::int64_t most_channels = 4096;
constexpr std::size_t most_names_listed = 20;

class VariableChooser {
public:
    VariableChooser(const FileBytes& file, const Catalogue& catalogue, const OpenOptions& options)
        : file_(file), catalogue_(catalogue), options_(options) {}

    Result<VariableChoice> choose() {
        TRY(name(0).empty() ? choose_longest() : choose_named(name(0), name(1)));
        const FileVariable& first = variable(choice_.channels[0].variable);
        choice_.frames = first.frames;
        for (const ChannelPlace& place : choice_.channels) {
            const FileVariable& of = variable(place.variable);
            // "/C" of the root group is the column C.
            const bool in_root = of.name.rfind('/') == 0;
            choice_.names.push_back({of.channels > 1 ? std::to_string(place.channel + 1)
                                     : in_root       ? of.name.substr(1)
                                                     : of.name,
                                     of.unit});
        }
        TRY(choose_rate_of(first, second_channel()));
        return std::move(choice_);
    }

private:
    std::string name(std::size_t place) const {
        return place < options_.variables.size() ? options_.variables[place] : "";
    }

    const FileVariable& variable(std::int64_t place) const {
        return catalogue_.variables[static_cast<std::size_t>(place)];
    }

    // Of channel D; that of C where there is none, which is reported later.
    const FileVariable& second_channel() const {
        const auto place = static_cast<std::size_t>(options_.channel_d) - 1;
        return variable(choice_.channels[place < choice_.channels.size() ? place : 0].variable);
    }

    std::int64_t count() const { return static_cast<std::int64_t>(catalogue_.variables.size()); }

    // By its name, or by the end of its path where that is the end of one alone.
    Result<std::int64_t> find(const std::string& wanted) const {
        std::string names;
        std::vector<std::int64_t> ending;
        for (std::int64_t i = 0; i < count(); ++i) {
            const FileVariable& candidate = variable(i);
            if (candidate.name == wanted || candidate.name == "/" + wanted) {
                return supported(i);
            }
            if (candidate.name.ends_with("/" + wanted) || candidate.name.ends_with("." + wanted)) {
                ending.push_back(i);
            }
            if (static_cast<std::size_t>(i) < most_names_listed) {
                names += (i == 0 ? "" : ", ") + candidate.name;
            } else if (static_cast<std::size_t>(i) == most_names_listed) {
                names += ", ...";
            }
        }
        if (ending.size() == 1) {
            return supported(ending.front());
        }
        return file_.error(ErrorCode::variable_missing,
                           {wanted, names.empty() ? "no arrays of numbers" : names});
    }

    Result<std::int64_t> supported(std::int64_t place) const {
        if (!variable(place).unsupported.text.empty()) {
            return unsupported(variable(place));
        }
        return place;
    }

    Status choose_named(const std::string& c, const std::string& d) {
        const auto first = TRY(find(c));
        if (d.empty()) {
            add_all_channels(first);
            return choice_.channels.empty() ? none_found(0) : Status();
        }
        const auto second = TRY(find(d));
        for (const std::int64_t place : {first, second}) {
            if (variable(place).channels != 1) {
                return wrong_names(
                    Phrase::tr("%1 has %2 channels and stands alone",
                               {variable(place).name, count_arg(variable(place).channels)}));
            }
        }
        if (variable(first).frames != variable(second).frames) {
            return wrong_names(Phrase::tr(
                "they have %1 and %2 samples",
                {count_arg(variable(first).frames), count_arg(variable(second).frames)}));
        }
        choice_.channels = {{first, 0}, {second, 0}};
        return {};
    }

    Error wrong_names(const MessageArg& reason) const {
        return {ErrorCode::setting_invalid,
                file_.path().string(),
                {"--variables", name(0) + "," + name(1), reason}};
    }

    void add_all_channels(std::int64_t place) {
        const std::int64_t channels = variable(place).channels;
        for (std::int64_t i = 0; i < channels && channels <= most_channels; ++i) {
            choice_.channels.push_back({place, i});
        }
    }

    bool is_candidate(const FileVariable& of) const {
        return of.unsupported.text.empty() && of.frames > 1 && of.channels >= 1 &&
               of.channels <= most_channels && !is_time_name(last_name(of.name)) &&
               last_name(of.name) != "index";  // pandas numbers its rows
    }

    // Vectors of this length among the candidates.
    std::vector<std::int64_t> vectors_of(std::int64_t frames) const {
        std::vector<std::int64_t> found;
        for (std::int64_t i = 0; i < count(); ++i) {
            if (is_candidate(variable(i)) && variable(i).channels == 1 &&
                variable(i).frames == frames) {
                found.push_back(i);
            }
        }
        return found;
    }

    Status choose_longest() {
        std::optional<std::int64_t> array;
        std::vector<std::int64_t> lengths;
        for (std::int64_t i = 0; i < count(); ++i) {
            if (!is_candidate(variable(i))) {
                continue;
            }
            if (variable(i).channels == 1) {
                lengths.push_back(variable(i).frames);
            } else if (!array || variable(i).frames > variable(*array).frames) {
                array = i;
            }
        }
        std::sort(lengths.rbegin(), lengths.rend());
        const auto pair = std::adjacent_find(lengths.begin(), lengths.end());
        if (wants_one_channel(options_) && pair == lengths.end() && !array && !lengths.empty()) {
            choice_.channels.push_back({vectors_of(lengths.front()).front(), 0});
        } else if (pair != lengths.end() && (!array || *pair >= variable(*array).frames)) {
            for (const std::int64_t place : vectors_of(*pair)) {
                choice_.channels.push_back({place, 0});
            }
            put_named_first();
        } else if (array) {
            TRY(check_no_other_of_its_size(variable(*array)));
            add_all_channels(*array);
        } else {
            return none_found(lengths.size());
        }
        return {};
    }

    Status check_no_other_of_its_size(const FileVariable& array) const {
        const auto other =
            std::find_if(&array + 1, &catalogue_.variables.back() + 1, [&](auto& of) {
                return is_candidate(of) && of.frames == array.frames &&
                       of.channels == array.channels;
            });
        return other > &catalogue_.variables.back()
                   ? Status()
                   : file_.error(ErrorCode::variables_ambiguous, {array.name + ", " + other->name});
    }

    // C before D where the names tell them apart, whatever their order in the file.
    void put_named_first() {
        std::array<std::optional<ChannelPlace>, 2> named;
        for (const ChannelPlace& place : choice_.channels) {
            const Meaning meaning = meaning_of(last_name(variable(place.variable).name));
            if (meaning == Meaning::channel_c || meaning == Meaning::channel_d) {
                auto& of = named[meaning == Meaning::channel_c ? 0 : 1];
                if (of) {
                    return;  // ambiguous names
                }
                of = place;
            }
        }
        if (named[0] && named[1]) {
            std::erase_if(choice_.channels, [&named](const ChannelPlace& place) {
                return place.variable == named[0]->variable || place.variable == named[1]->variable;
            });
            choice_.channels.insert(choice_.channels.begin(), {*named[0], *named[1]});
        }
    }

    Error none_found(std::size_t vectors) const {
        for (const FileVariable& candidate : catalogue_.variables) {
            if (!candidate.unsupported.text.empty()) {
                return unsupported(candidate);
            }
        }
        return too_few_channels(file_, static_cast<int>(std::min<std::size_t>(vectors, 1)));
    }

    Error unsupported(const FileVariable& of) const {
        return file_.unsupported(catalogue_.format, VYBEG_MESSAGE("Words", "%1 (%2)"),
                                 {of.unsupported, of.name});
    }

    Status choose_rate_of(const FileVariable& c, const FileVariable& d) {
        if (!name(2).empty()) {
            return choose_named_rate();
        }
        if (c.rate_hz && d.rate_hz && !same_rate(*c.rate_hz, *d.rate_hz)) {
            return rates_differ(*c.rate_hz, *d.rate_hz);
        }
        if (c.rate_hz) {
            choice_.rate = SampleRate{*c.rate_hz, RateOrigin::file};
        }
        const std::string own = owner_of(c);
        for (const bool near : {true, false}) {
            const bool open = !choice_.rate;
            for (std::int64_t i = 0; i < count() && open; ++i) {
                const FileVariable& of = variable(i);
                const auto rate =
                    !near || of.name.starts_with(own) ? stated_rate(of) : std::nullopt;
                if (rate && choice_.rate && !same_rate(*rate, choice_.rate->hz)) {
                    return rates_differ(choice_.rate->hz, *rate);
                }
                if (rate) {
                    choice_.rate = SampleRate{*rate, RateOrigin::file};
                }
            }
            for (std::int64_t i = 0; i < count() && !choice_.time; ++i) {
                if ((!near || variable(i).name.starts_with(own)) && is_time(variable(i))) {
                    choice_.time = i;
                }
            }
        }
        if (choice_.time) {
            choice_.time_unit_s = unit_of_times(variable(*choice_.time)).value_or(1);
        }
        return check_rate_of(d, own);
    }

    // Whether what stands beside D in a struct or group of its own contradicts what C has.
    Status check_rate_of(const FileVariable& d, const std::string& own_of_c) {
        const std::string own = owner_of(d);
        for (std::int64_t i = 0; i < count() && own != own_of_c; ++i) {
            const FileVariable& of = variable(i);
            if (!of.name.starts_with(own) || (own.empty() && of.name.starts_with(own_of_c))) {
                continue;
            }
            const auto rate = stated_rate(of);
            if (rate && choice_.rate && !same_rate(*rate, choice_.rate->hz)) {
                return rates_differ(choice_.rate->hz, *rate);
            }
            if (is_time(of) && choice_.time && *choice_.time != i) {
                choice_.time_of_d = i;
            }
        }
        return {};
    }

    Error rates_differ(double first_hz, double second_hz) const {
        return two_rates(file_, catalogue_.format, first_hz, second_hz);
    }

    // Of a single number that is named as a rate or a step.
    static std::optional<double> stated_rate(const FileVariable& of) {
        return of.value ? rate_by_name(last_name(of.name), *of.value, of.unit) : std::nullopt;
    }

    // The struct or group of a variable, with the separator.
    static std::string owner_of(const FileVariable& of) {
        return of.name.substr(0, of.name.size() - last_name(of.name).size());
    }

    // Seconds, unless the name or the unit is another. Whole numbers without a unit count ticks of
    // an unknown length.
    static std::optional<double> unit_of_times(const FileVariable& of) {
        const std::string unit = time_unit({std::string(last_name(of.name)), of.unit});
        if (unit.empty()) {
            return of.type.ends_with("float") ? std::optional(1.0) : std::nullopt;
        }
        return seconds_per(unit);
    }

    bool is_time(const FileVariable& of) const {
        return is_time_name(last_name(of.name)) && of.unsupported.text.empty() &&
               of.channels == 1 && of.frames == choice_.frames && unit_of_times(of);
    }

    Status choose_named_rate() {
        const auto place = TRY(find(name(2)));
        const FileVariable& of = variable(place);
        if (of.value) {
            choice_.rate = SampleRate{stated_rate(of).value_or(*of.value), RateOrigin::file};
        } else if (of.frames == choice_.frames && of.channels == 1) {
            choice_.time = place;
            choice_.time_unit_s = unit_of_times(of).value_or(1);
        }
        if (!choice_.time && !(choice_.rate && choice_.rate->hz > 0 &&
                               choice_.rate->hz <= std::numeric_limits<double>::max())) {
            return Error{ErrorCode::setting_invalid,
                         file_.path().string(),
                         {"--variables", name(2), "it holds no sample rate and no times"}};
        }
        return {};
    }

    const FileBytes& file_;
    const Catalogue& catalogue_;
    const OpenOptions& options_;
    VariableChoice choice_;
};

// A file of which only samples and rate are not found yet.
class VariableOpening {
public:
    VariableOpening(const FileBytes& file, const VariableReader& reader,
                    const VariableChoice& choice, const OpenOptions& options)
        : file_(file),
          format_(reader.catalogue().format),
          reader_(reader),
          choice_(choice),
          options_(options),
          c_(choice.channels[static_cast<std::size_t>(options.channel_c - 1)]),
          d_(choice.channels[static_cast<std::size_t>(options.channel_d - 1)]) {}

    // Errors: those of VariableReader; format_unsupported, rate_unknown, interrupted.
    Status take_samples(const JobControl& job, FoundSamples& found) const {
        found.own_rate = choice_.rate;
        if (choice_.time && choice_.time_of_d) {
            TRY(check_times_of_d());
        }
        if (choice_.time && found.own_rate) {
            TRY(check_times(found.own_rate->hz));
        } else if (choice_.time) {
            const auto steps = TRY(scan_times(job));
            if (steps.is_time && !steps.is_even()) {
                return take_uneven(steps.resolution, found);
            }
            if (steps.is_time) {
                found.own_rate = SampleRate{steps.even->rate_hz, RateOrigin::time_column,
                                            steps.even->rate_relative_sd};
            }
        }
        // Before the work of unpacking.
        TRY(choose_rate(file_, found.own_rate, options_));
        auto source = TRY(reader_.source(c_, d_, choice_.frames));
        found.source = std::move(source);
        return {};
    }

    // Reads all times once, block by block, holding none.
    Result<TimeSteps> scan_times(const JobControl& job) const {
        const auto read = [this](std::int64_t first, std::span<double> times) {
            return reader_.read({*choice_.time, 0}, first, times);
        };
        std::vector<double> block(
            static_cast<std::size_t>(std::min(choice_.frames, frames_per_request)));
        TRY(read(0, block));
        // Before the last time is looked at, for which much may have to be unpacked:
        // most of what is none does not even begin like one.
        return std::ranges::is_sorted(block) ? judge_column(std::move(block), choice_.frames,
                                                            choice_.time_unit_s, true, read, job)
                                             : TimeSteps{};
    }

private:
    // Fills `out` with the times from the frame `first` on, in seconds.
    Status read_times(std::int64_t variable, std::int64_t first, std::span<double> out) const {
        const Status status = reader_.read({variable, 0}, first, out);
        for (double& time : out) {
            time *= choice_.time_unit_s;
        }
        return status;
    }

    // The first and the last of the times, s.
    Result<std::array<double, 2>> ends_of(std::int64_t variable) const {
        std::array<double, 2> found{};
        TRY(read_times(variable, 0, std::span(found).first(1)));
        TRY(read_times(variable, choice_.frames - 1, std::span(found).last(1)));
        return found;
    }

    double mean_step(const std::array<double, 2>& ends) const {
        return (ends[1] - ends[0]) / static_cast<double>(choice_.frames - 1);
    }

    // All three columns at once, which only uneven times need: they are known after all of them.
    Status take_uneven(const TimeResolution& resolution, FoundSamples& found) const {
        const auto frames = static_cast<std::size_t>(choice_.frames);
        TimedSamples samples{std::vector<double>(frames), std::vector<double>(frames),
                             std::vector<double>(frames), resolution};
        for (std::size_t at = 0; at < frames; at += frames_per_request) {
            const std::size_t count = std::min<std::size_t>(frames_per_request, frames - at);
            const auto block = [&](std::vector<double>& column) {
                return std::span(column).subspan(at, count);
            };
            const auto first = static_cast<std::int64_t>(at);
            TRY(read_times(*choice_.time, first, block(samples.time_s)));
            TRY(reader_.read(c_, first, block(samples.c)));
            TRY(reader_.read(d_, first, block(samples.d)));
        }
        auto grid = TRY(to_uniform_grid(samples, file_.path().string()));
        found.own_rate = SampleRate{grid.rate_hz, RateOrigin::time_column, grid.rate_relative_sd};
        found.diagnostics = std::move(grid.diagnostics);
        found.source = memory_source(std::move(grid.c), std::move(grid.d));
        return {};
    }

    // Whether the first and the last of the times have the rate that the file states. Times in
    // steps of a second or more count something.
    Status check_times(double rate_hz) const {
        const auto ends = TRY(ends_of(*choice_.time));
        const double step_s = mean_step(ends);
        const bool is_time = step_s > 0 && step_s < longest_step_s;
        return is_time && !same_rate(1 / step_s, rate_hz)
                   ? two_rates(file_, format_, rate_hz, 1 / step_s)
                   : Status();
    }

    // Whether D's own times, of which C has others, begin and end as C's do.
    Status check_times_of_d() const {
        constexpr double allowed = 1e-3;  // of a step
        const auto c = TRY(ends_of(*choice_.time));
        const auto d = TRY(ends_of(*choice_.time_of_d));
        const double allowed_s = allowed * mean_step(c);
        if (std::abs(c[0] - d[0]) <= allowed_s && std::abs(c[1] - d[1]) <= allowed_s) {
            return {};
        }
        return file_.unsupported(
            format_,
            VYBEG_MESSAGE("Words", "C and D at different times (%1 to %2 s and %3 to %4 s)"),
            {number_arg(c[0], 9), number_arg(c[1], 9), number_arg(d[0], 9), number_arg(d[1], 9)});
    }

    const FileBytes& file_;
    const std::string& format_;
    const VariableReader& reader_;
    const VariableChoice& choice_;
    const OpenOptions& options_;
    ChannelPlace c_;
    ChannelPlace d_;
};

}  // namespace

Result<Recording> open_variables(const FileBytes& file, const VariableReader& reader,
                                 const OpenOptions& options, const JobControl& job) {
    const Catalogue& catalogue = reader.catalogue();
    auto choice = TRY(VariableChooser(file, catalogue, options).choose());
    const auto channels = static_cast<int>(choice.channels.size());
    TRY(check_channels(file, channels, options));
    TRY(check_frames(file, choice.frames));
    // The columns behind times keep their numbers, by which others may have been chosen.
    OpenOptions used = options;
    if (options.channel_c == 1 && options.channel_d == 2 && !choice.time && channels > 2 &&
        choice.channels[2].variable == choice.channels[0].variable) {
        choice.time = choice.channels[0].variable;
        const VariableOpening opening(file, reader, choice, options);
        const auto steps = TRY(opening.scan_times(job));
        choice.time = steps.is_even() ? choice.time : std::nullopt;
        used.channel_c += choice.time ? 1 : 0;
        used.channel_d += choice.time ? 1 : 0;
    }
    FoundSamples found;
    found.channels = choice.names;
    found.present_frames = choice.frames;
    found.never_closed = catalogue.not_closed;
    const ChannelPlace& c = choice.channels[static_cast<std::size_t>(used.channel_c - 1)];
    found.format = {
        FormatPart::name(catalogue.format),
        FormatPart::words(catalogue.variables[static_cast<std::size_t>(c.variable)].type),
        FormatPart::channels(channels)};
    const VariableOpening opening(file, reader, choice, used);
    TRY(opening.take_samples(job, found));
    return complete_recording(file, std::move(found), used);
}

}  // namespace vybeg
