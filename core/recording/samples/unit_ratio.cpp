#include "core/recording/samples/unit_ratio.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vybeg {
namespace {

struct Unit {
    std::string_view text;
    char quantity;  // the same for all texts of one unit
};
constexpr std::array<Unit, 31> units{
    {{"V", 'V'},      {"v", 'V'},     {"Volt", 'V'},  {"volt", 'V'}, {"Volts", 'V'},
     {"volts", 'V'},  {"VOLT", 'V'},  {"VOLTS", 'V'}, {"В", 'V'},    {"в", 'V'},
     {"вольт", 'V'},  {"Вольт", 'V'}, {"A", 'A'},     {"Amp", 'A'},  {"Ampere", 'A'},
     {"ampere", 'A'}, {"А", 'A'},     {"m", 'm'},     {"m/s", 's'},  {"m/s^2", 'a'},
     {"m/s2", 'a'},   {"m/s²", 'a'},  {"g", 'g'},     {"N", 'N'},    {"Pa", 'p'},
     {"Ohm", 'o'},    {"V/V", '1'},   {"rad", 'r'},   {"deg", 'd'},  {"°", 'd'},
     {"Hz", 'h'}}};

struct Prefix {
    std::string_view text;
    double factor;
};
constexpr std::array<Prefix, 20> prefixes{
    {{"n", 1e-9},   {"u", 1e-6},     {"µ", 1e-6},     {"μ", 1e-6},     {"m", 1e-3},
     {"k", 1e3},    {"K", 1e3},      {"M", 1e6},      {"н", 1e-9},     {"мк", 1e-6},
     {"м", 1e-3},   {"к", 1e3},      {"М", 1e6},      {"micro", 1e-6}, {"milli", 1e-3},
     {"kilo", 1e3}, {"Micro", 1e-6}, {"Milli", 1e-3}, {"милли", 1e-3}, {"микро", 1e-6}}};

struct Scaled {
    char quantity;
    double factor;
};

std::optional<char> quantity_of(std::string_view text) {
    for (const Unit& unit : units) {
        if (unit.text == text) {
            return unit.quantity;
        }
    }
    return std::nullopt;
}

// Removes the coupling of a unit such as "V DC".
std::string_view without_coupling(std::string_view text) {
    for (const std::string_view coupling : {" DC", " AC", " dc", " ac"}) {
        if (text.ends_with(coupling)) {
            return text.substr(0, text.size() - coupling.size());
        }
    }
    return text;
}

std::optional<Scaled> scaled(std::string_view text) {
    text = without_coupling(text);
    if (const auto quantity = quantity_of(text)) {
        return Scaled{*quantity, 1};
    }
    for (const Prefix& prefix : prefixes) {
        if (text.starts_with(prefix.text)) {
            if (const auto quantity = quantity_of(text.substr(prefix.text.size()))) {
                return Scaled{*quantity, prefix.factor};
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> unit_ratio(std::string_view from, std::string_view to) {
    if (from == to) {
        return 1.0;
    }
    const auto a = scaled(from);
    const auto b = scaled(to);
    if (!a || !b || a->quantity != b->quantity) {
        return std::nullopt;
    }
    return a->factor / b->factor;
}

bool is_known_unit(std::string_view text) {
    return scaled(text).has_value();
}

bool is_unit_by_itself(std::string_view text) {
    constexpr std::array<std::string_view, 2> words{"mm", "in"};
    const auto unit = scaled(text);
    return unit && (unit->quantity == 'V' ? text != "В" && text != "в" : text.size() > 2) &&
           std::ranges::find(words, text) == words.end();
}

}  // namespace vybeg
