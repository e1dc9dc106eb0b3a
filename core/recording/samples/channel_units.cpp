#include "core/recording/samples/channel_units.h"

#include "core/recording/samples/scaled_source.h"
#include "core/recording/samples/unit_ratio.h"

#include <utility>

namespace vybeg {

double note_units(const Channel& c, const Channel& d, std::vector<Diagnostic>& diagnostics) {
    if (c.unit.empty() || d.unit.empty()) {
        if (c.unit.empty() != d.unit.empty()) {
            const Channel& with = c.unit.empty() ? d : c;
            const Channel& without = c.unit.empty() ? c : d;
            diagnostics.push_back(
                {DiagnosticKind::unit_of_one, {with.name, with.unit, without.name}, -1, 0});
        }
        return 1;
    }
    const auto ratio = unit_ratio(d.unit, c.unit);
    if (!ratio) {
        diagnostics.push_back(
            {DiagnosticKind::units_differ, {c.name, c.unit, d.name, d.unit}, -1, 0});
    } else if (*ratio != 1) {
        diagnostics.push_back({DiagnosticKind::unit_converted, {d.name, d.unit, c.unit}, -1, 0});
    }
    return ratio.value_or(1);
}

void match_units(Recording& recording) {
    const auto channel = [&](int number) -> const Channel& {
        return recording.channels[static_cast<std::size_t>(number - 1)];
    };
    const double factor = note_units(channel(recording.channel_c), channel(recording.channel_d),
                                     recording.diagnostics);
    if (factor != 1) {
        recording.source = scaled_source(std::move(recording.source), 1, factor);
    }
}

}  // namespace vybeg
