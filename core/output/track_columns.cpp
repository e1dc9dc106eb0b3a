#include "core/output/track_columns.h"

#include <algorithm>
#include <array>

namespace vybeg {
namespace {

// Behind t_s.
constexpr std::array value_columns{
    SlowVariable::a_A, SlowVariable::a_B,          SlowVariable::two_theta_A, SlowVariable::alpha,
    SlowVariable::f,   SlowVariable::delta_phi_CD, SlowVariable::rms};
constexpr std::array sd_columns{SlowVariable::a_A, SlowVariable::a_B, SlowVariable::two_theta_A,
                                SlowVariable::alpha, SlowVariable::f};
static_assert(1 + value_columns.size() + sd_columns.size() == track_number_columns);

constexpr std::size_t first_sd = 1 + value_columns.size();
constexpr std::size_t rows_at_once = std::size_t{1} << 16;

template <class AnyTrack>
auto column_of(AnyTrack& track, std::size_t column) {
    if (column == 0) {
        return track.time_s();
    }
    return column < first_sd ? track.values(value_columns[column - 1])
                             : track.sds(sd_columns[column - first_sd]);
}

template <class Values, class Sink>
Status pass(Values values, const Sink& sink) {
    for (std::size_t at = 0; at < values.size(); at += rows_at_once) {
        TRY(sink(values.subspan(at, std::min(rows_at_once, values.size() - at))));
    }
    return {};
}

}  // namespace

std::string track_column_name(std::size_t column) {
    if (column == 0) {
        return "t_s";
    }
    return column < first_sd ? info(value_columns[column - 1]).column
                             : std::string("sd_") + info(sd_columns[column - first_sd]).column;
}

std::string track_column_unit(std::size_t column) {
    return column == 0         ? "s"
           : column < first_sd ? info(value_columns[column - 1]).unit
                               : info(sd_columns[column - first_sd]).unit;
}

std::span<const double> track_column(const Track& track, std::size_t column) {
    return column_of(track, column);
}

std::span<double> track_column(Track& track, std::size_t column) {
    return column_of(track, column);
}

Status MemoryColumns::numbers(std::size_t column, const NumberSink& sink) const {
    return pass(track_column(track_, column), sink);
}

Status MemoryColumns::flags(const FlagSink& sink) const {
    return pass(track_.flags(), sink);
}

}  // namespace vybeg
