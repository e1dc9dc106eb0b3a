#include "core/recording/variables/variable_choice.h"

#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t most_channels = 4096;
constexpr std::size_t most_names_listed = 20;

class VariableChooser {
public:
    VariableChooser(const FileBytes& file, const Catalogue& catalogue, const OpenOptions& options)
        : file_(file), catalogue_(catalogue), options_(options) {}

    Status choose() {
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
        return choose_rate_of(first, second_channel());
    }

    VariableChoice take() { return std::move(choice_); }

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
                    words(VYBEG_MESSAGE("Words", "%1 has %2 channels and stands alone"),
                          {variable(place).name, count_arg(variable(place).channels)}));
            }
        }
        if (variable(first).frames != variable(second).frames) {
            return wrong_names(
                words(VYBEG_MESSAGE("Words", "they have %1 and %2 samples"),
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
            add_all_channels(*array);
        } else {
            return none_found(lengths.size());
        }
        return {};
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
        return two_rates(file_, catalogue_, first_hz, second_hz);
    }

    // Of a single number that is named as a rate or a step.
    static std::optional<double> stated_rate(const FileVariable& of) {
        return of.value ? rate_by_name(last_name(of.name), *of.value, of.unit) : std::nullopt;
    }

    // The struct or group of a variable, with the separator.
    static std::string owner_of(const FileVariable& of) {
        return of.name.substr(0, of.name.size() - last_name(of.name).size());
    }

    // Seconds, unless the name or the unit tells otherwise. Whole numbers without a unit count
    // something, and nobody knows what.
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

}  // namespace

bool same_rate(double one_hz, double other_hz) {
    return std::abs(one_hz / other_hz - 1) < 1e-4;
}

Error two_rates(const FileBytes& file, const Catalogue& catalogue, double first_hz,
                double second_hz) {
    return file.unsupported(
        catalogue.format,
        VYBEG_MESSAGE("Words",
                      "two sample rates, %1 and %2 Hz (--variables C,D,RATE tells "
                      "which holds)"),
        {number_arg(first_hz), number_arg(second_hz)});
}

Result<VariableChoice> choose_variables(const FileBytes& file, const Catalogue& catalogue,
                                        const OpenOptions& options) {
    VariableChooser choosing(file, catalogue, options);
    TRY(choosing.choose());
    return choosing.take();
}

}  // namespace vybeg
