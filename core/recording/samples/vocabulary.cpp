#include "core/recording/samples/vocabulary.h"

#include "core/base/plain_text.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vybeg {
namespace {

// Names of one meaning, with blanks between them, as normal_name() has them.
struct Words {
    Meaning meaning;
    std::string_view names;
    NamedIn where = NamedIn::any_file;
};
constexpr std::array meanings{
    Words{Meaning::time,
          "t time times timestamp datetime date/time elapsed elapsedtime relativetime sec secs "
          "second seconds xaxis xvalue zeit т время сек секунды"},
    Words{Meaning::counter,
          "# n i k no nr № index sample samples samplenumber sequence frame point row count номер"},
    Words{Meaning::remark, "comment comments event events marker notes flag kommentar комментарий"},
    Words{Meaning::channel_c, "c sc chc channelc"},
    Words{Meaning::channel_d, "d sd chd channeld"},
    Words{Meaning::rate,
          "fs sr rate samplerate samplingrate samplefreq samplingfreq samplefrequency "
          "samplingfrequency fsample samplespersecond frequencyofsampling scanrate "
          "acquisitionrate messrate abtastrate abtastfrequenz частотадискретизации частотасбора "
          "частотаопроса частотаоцифровки частотавыборки"},
    Words{Meaning::rate, "updaterate sampling inputrate", NamedIn::text},
    Words{Meaning::step,
          "dt increment wfincrement sampleinterval samplinginterval sampleperiod samplingperiod "
          "tinc tinterval xinc xincr xincrement hinc hresolution timestep timeincrement deltat "
          "abtastintervall шагповремени шагдискретизации периоддискретизации "
          "интервалдискретизации"},
    Words{Meaning::step, "delta deltax timeinterval", NamedIn::text},
    Words{Meaning::step, "ts sampletime", NamedIn::variables},  // in a text, of other things
    Words{Meaning::start, "start"},
    Words{Meaning::names,
          "name channel channelname channelnames tracename signalname kanalname source label "
          "labels"},
    Words{Meaning::units,
          "unit units unitstring vunit verticalunit verticalunits yunit yunits yunitlabel einheit "
          "dataformat"},
    Words{Meaning::axis_unit,
          "hunit horizontalunit horizontalunits xunit xunits timeunit timemarkersscale"},
    Words{Meaning::unit, "a ma counts lsb"},
};

// What normal_name() leaves out.
constexpr std::array<std::string_view, 12> between_words{
    " ", "\t", "_", "-", ".", ":", "=", "\"", "'", "\u00A0", "\u202F", "\u2212"};

constexpr std::array<std::string_view, 3> time_beginnings{"time", "zeit", "время"};

// Spellings of one unit, with blanks between them.
struct Unit {
    std::string_view quantity;   // "time", "rate" or what samples may measure
    std::string_view spellings;  // of times and rates: small letters, which mean capitals, too
    double factor = 1;           // to the other units of the quantity
    bool prefixed = true;
};
constexpr std::array units{
    Unit{"time", "s sec secs second seconds sek sekunde sekunden с сек секунд секунда секунды"},
    Unit{"time", "min mins minute minutes minuten мин минут минуты", 60, false},
    Unit{"time", "h hr hrs hour hours stunden ч час часы", 3600, false},
    Unit{"time", "day days tage дни сут", 86400, false},
    Unit{"rate", "hz гц s/s sa/s sps 1/s samples/s samples/sec", 1, false},
    Unit{"rate", "khz кгц ks/s ksa/s ksps", 1e3, false},
    Unit{"rate", "mhz мгц ms/s msa/s", 1e6, false},
    Unit{"rate", "ghz gs/s gsa/s", 1e9, false},
    Unit{"voltage", "V v Volt volt VOLT Volts volts VOLTS В в вольт Вольт"},
    Unit{"current", "A Amp Ampere ampere А"},
    Unit{"length", "m"},
    Unit{"speed", "m/s"},
    Unit{"acceleration", "m/s^2 m/s2 m/s²"},
    Unit{"gravity", "g"},
    Unit{"force", "N"},
    Unit{"pressure", "Pa"},
    Unit{"resistance", "Ohm"},
    Unit{"ratio", "V/V"},
    Unit{"radians", "rad"},
    Unit{"degrees", "deg °"},
    Unit{"frequency", "Hz"},
};

using Prefix = std::pair<std::string_view, double>;
constexpr std::array prefixes{
    Prefix{"p", 1e-12},    Prefix{"n", 1e-9},      Prefix{"nano", 1e-9},   Prefix{"н", 1e-9},
    Prefix{"u", 1e-6},     Prefix{"\u00B5", 1e-6}, Prefix{"\u03BC", 1e-6}, Prefix{"micro", 1e-6},
    Prefix{"Micro", 1e-6}, Prefix{"мк", 1e-6},     Prefix{"микро", 1e-6},  Prefix{"m", 1e-3},
    Prefix{"milli", 1e-3}, Prefix{"Milli", 1e-3},  Prefix{"м", 1e-3},      Prefix{"милли", 1e-3},
    Prefix{"k", 1e3},      Prefix{"K", 1e3},       Prefix{"kilo", 1e3},    Prefix{"к", 1e3},
    Prefix{"M", 1e6},      Prefix{"М", 1e6}};

// Whether a word is one of a list with blanks between them.
bool is_listed(std::string_view word, std::string_view list) {
    const auto words = parts_between(list, ' ');
    return std::ranges::find(words, word) != words.end();
}

struct Scaled {
    std::string_view quantity;
    double factor;
};

// A unit of the wanted quantities, with or without a prefix.
template <class Wanted>
std::optional<Scaled> find_unit(std::string_view text, Wanted is_wanted) {
    const auto find = [&](std::string_view word, bool prefixed) {
        return std::ranges::find_if(units, [&](const Unit& unit) {
            return is_wanted(unit.quantity) && (unit.prefixed || !prefixed) &&
                   is_listed(word, unit.spellings);
        });
    };
    if (const auto whole = find(text, false); whole != units.end()) {
        return Scaled{whole->quantity, whole->factor};
    }
    for (const auto& [prefix, factor] : prefixes) {
        if (text.starts_with(prefix)) {
            const auto unit = find(text.substr(prefix.size()), true);
            if (unit != units.end()) {
                return Scaled{unit->quantity, factor * unit->factor};
            }
        }
    }
    return std::nullopt;
}

std::optional<double> factor_of(std::string_view unit, std::string_view quantity) {
    std::string small = lower_text(unit);
    while (small.ends_with('.')) {
        small.pop_back();
    }
    const auto found = find_unit(small, [&](std::string_view of) { return of == quantity; });
    return found ? std::optional(found->factor) : std::nullopt;
}

// The unit of samples, but for a coupling, as in "V DC".
std::optional<Scaled> unit_of_samples(std::string_view text) {
    for (const std::string_view coupling : {" DC", " AC", " dc", " ac"}) {
        if (text.ends_with(coupling)) {
            text.remove_suffix(coupling.size());
            break;
        }
    }
    return find_unit(text, [](std::string_view of) { return of != "time" && of != "rate"; });
}

// Of a word without brackets, which may be a name as well: "A" and "В" number channels.
bool is_unit_by_itself(std::string_view text) {
    constexpr std::array<std::string_view, 2> names{"mm", "in"};
    const auto unit = unit_of_samples(text);
    return unit && (unit->quantity == "voltage" ? text != "В" && text != "в" : text.size() > 2) &&
           std::ranges::find(names, text) == names.end();
}

// Names of SPICE programs are no names with a unit: V(c) is the voltage of node c.
std::optional<Channel> node_quantity(std::string_view name, std::string_view inside) {
    if (name != "V" && name != "I") {
        return std::nullopt;
    }
    const char* const unit = name == "V" ? "V" : "A";
    if (unit_ratio(inside, unit)) {
        return std::nullopt;
    }
    return Channel{std::string(name) + "(" + std::string(inside) + ")", unit};
}

// Start of the last word of a name: after a blank, '_' or '-', or as in "TimeMs".
std::size_t last_word(std::string_view name) {
    const auto cut = name.find_last_of(" _-");
    if (cut != std::string_view::npos) {
        return cut + 1;
    }
    const std::string small = lower_text(name);
    for (const std::string_view beginning : time_beginnings) {
        // "times" is a plural.
        if (small.starts_with(beginning) && small.size() > beginning.size() + 1) {
            return beginning.size();
        }
    }
    return 0;
}

}  // namespace

std::string_view without_brackets(std::string_view text) {
    const bool bracketed = text.size() >= 2 && ((text.front() == '[' && text.back() == ']') ||
                                                (text.front() == '(' && text.back() == ')'));
    return bracketed ? trimmed(text.substr(1, text.size() - 2)) : text;
}

std::string normal_name(std::string_view name) {
    const std::string small = lower_text(without_brackets(trimmed(name)));
    std::string normal;
    for (std::string_view rest = small; !rest.empty();) {
        const auto between = std::ranges::find_if(
            between_words, [rest](std::string_view each) { return rest.starts_with(each); });
        const bool is_between = between != between_words.end();
        normal += is_between ? "" : rest.substr(0, 1);
        rest.remove_prefix(is_between ? between->size() : 1);
    }
    return normal;
}

Meaning meaning_of(std::string_view name, NamedIn where) {
    const std::string normal = normal_name(name);
    if (normal.empty()) {
        return Meaning::counter;
    }
    const auto found = std::ranges::find_if(meanings, [&](const Words& row) {
        return (row.where == NamedIn::any_file || row.where == where) &&
               is_listed(normal, row.names);
    });
    return found == meanings.end() ? Meaning::other : found->meaning;
}

Channel name_and_unit(std::string_view field) {
    const std::string text = to_utf8(trimmed(field));
    const std::string_view whole = text;
    const auto result = [](std::string_view name, std::string_view unit) {
        return Channel{std::string(trimmed(name)), std::string(trimmed(unit))};
    };
    for (const auto& [open, close] :
         {std::pair{'[', ']'}, std::pair{'(', ')'}, std::pair{'{', '}'}}) {
        const auto at = whole.rfind(open);
        const auto end = whole.rfind(close);
        if (at == std::string_view::npos || at == 0 || end == std::string_view::npos || end < at) {
            continue;
        }
        std::string_view inside = whole.substr(at + 1, end - at - 1);
        inside.remove_prefix(inside.starts_with("in ") ? 3 : 0);
        if (end + 1 < whole.size()) {
            // "Time [ms] abs", "C (V) DC"
            if (is_any_unit(inside)) {
                return result(
                    std::string(trimmed(whole.substr(0, at))) + std::string(whole.substr(end + 1)),
                    inside);
            }
            continue;
        }
        if (are_digits(inside)) {
            return {text, ""};
        }
        if (const auto node = node_quantity(whole.substr(0, at), inside)) {
            return *node;
        }
        return result(whole.substr(0, at), inside);
    }
    const auto comma = whole.rfind(", ");
    if (comma != std::string_view::npos && comma > 0) {
        return result(whole.substr(0, comma), whole.substr(comma + 2));
    }
    if (whole.starts_with("in ") && is_any_unit(whole.substr(3))) {
        return result("", whole.substr(3));
    }
    for (const std::string_view separator : {" in ", " In ", "/"}) {
        const auto at = whole.rfind(separator);
        if (at != std::string_view::npos && at > 0 &&
            is_any_unit(whole.substr(at + separator.size()))) {
            return result(whole.substr(0, at), whole.substr(at + separator.size()));
        }
    }
    // "CH1 mVolt", "C_V", and "mV" alone
    const auto cut = whole.find_last_of(" _");
    const std::string_view last = cut == std::string_view::npos ? whole : whole.substr(cut + 1);
    return {text, is_unit_by_itself(last) ? std::string(last) : ""};
}

std::string_view last_name(std::string_view path) {
    const std::size_t separator = path.find_last_of("./");
    return separator == std::string_view::npos ? path : path.substr(separator + 1);
}

bool is_time_name(std::string_view name) {
    if (name == "T" || name == "Т") {
        return false;  // probably a temperature
    }
    if (meaning_of(name) == Meaning::time) {
        return true;
    }
    const std::size_t word = last_word(name);
    return word > 0 && seconds_per(name.substr(word)) &&
           meaning_of(name.substr(0, word)) == Meaning::time;
}

bool begins_as_time_name(std::string_view name) {
    const std::string small = lower_text(name);
    return std::ranges::any_of(time_beginnings, [&](std::string_view beginning) {
        return small.starts_with(beginning) && small.size() > beginning.size() &&
               std::string_view(" -(_").find(small[beginning.size()]) != std::string_view::npos;
    });
}

std::string time_unit(const Channel& column) {
    if (seconds_per(column.unit)) {
        return column.unit;
    }
    // The unit is the end of the name, or all of it: "t_ms", "sec".
    const std::string_view name = column.name;
    const std::string_view ending = name.substr(last_word(name));
    return seconds_per(ending) ? std::string(ending) : "";
}

std::optional<double> seconds_per(std::string_view unit) {
    return factor_of(unit, "time");
}

std::optional<double> hertz_per(std::string_view unit) {
    return factor_of(unit, "rate");
}

std::optional<double> rate_by_name(std::string_view name, double value, std::string_view unit) {
    const Meaning meaning = meaning_of(name, NamedIn::variables);
    if (meaning != Meaning::other) {
        return rate_in_hz(meaning, value, unit);
    }
    const Channel parts = name_and_unit(name);  // of "Sampling Rate (kHz)"
    return rate_in_hz(meaning_of(parts.name, NamedIn::variables), value,
                      unit.empty() ? parts.unit : unit);
}

std::optional<double> rate_in_hz(Meaning meaning, double value, std::string_view unit) {
    if (meaning != Meaning::rate && meaning != Meaning::step) {
        return {};
    }
    const bool is_rate = meaning == Meaning::rate;
    const auto factor = unit.empty() ? std::optional(1.0)
                        : is_rate    ? hertz_per(unit)
                                     : seconds_per(unit);
    if (!factor) {
        return {};
    }
    const double rate = is_rate ? value * *factor : 1 / (value * *factor);
    return std::isfinite(rate) && rate > 0 ? std::optional(rate) : std::nullopt;
}

std::optional<double> unit_ratio(std::string_view from, std::string_view to) {
    if (from == to) {
        return 1.0;
    }
    const auto a = unit_of_samples(from);
    const auto b = unit_of_samples(to);
    if (!a || !b || a->quantity != b->quantity) {
        return std::nullopt;
    }
    return a->factor / b->factor;
}

bool is_known_unit(std::string_view text) {
    return unit_of_samples(text).has_value();
}

bool is_any_unit(std::string_view text) {
    return is_known_unit(text) || seconds_per(text);
}

bool is_unit_below_name(std::string_view text) {
    const auto small = unit_of_samples(lower_text(text));
    return is_any_unit(text) || meaning_of(text) == Meaning::unit ||
           (small && (small->quantity == "voltage" || small->quantity == "gravity"));
}

}  // namespace vybeg
