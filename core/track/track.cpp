#include "core/track/track.h"

#include <algorithm>
#include <limits>

namespace vybeg {
namespace {

template <class Value>
void append_all(std::vector<Value>& values, const std::vector<Value>& more) {
    values.insert(values.end(), more.begin(), more.end());
}

}  // namespace

Track::Track(std::size_t rows) : time_s_(rows), flags_(rows), leakage_f_hz_(rows) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const SlowVariable variable : all_slow_variables) {
        values_[index(variable)].assign(rows, nan);
        if (info(variable).has_sd) {
            sds_[index(variable)].assign(rows, nan);
        }
    }
}

void Track::put(std::size_t row, SlowVariable variable, double value, double sd) {
    values_[index(variable)][row] = value;
    if (info(variable).has_sd) {
        sds_[index(variable)][row] = sd;
    }
}

void Track::append(const Track& rows) {
    append_all(time_s_, rows.time_s_);
    append_all(flags_, rows.flags_);
    append_all(leakage_f_hz_, rows.leakage_f_hz_);
    for (std::size_t i = 0; i < slow_variable_count; ++i) {
        append_all(values_[i], rows.values_[i]);
        append_all(sds_[i], rows.sds_[i]);
    }
}

TrackSink appended_to(Track& track) {
    return [&track](const Track& rows) {
        track.append(rows);
        return Status{};
    };
}

void set_flags(std::span<Flags> part, std::size_t first, std::span<const FlaggedRows> flagged) {
    for (const FlaggedRows& rows : flagged) {
        const std::size_t end = std::min(rows.first + rows.count, first + part.size());
        for (std::size_t row = std::max(rows.first, first); row < end; ++row) {
            set(part[row - first], rows.flag);
        }
    }
}

}  // namespace vybeg
