#pragma once

#include "core/resonator/resonator_fit.h"
#include "core/resonator/run_track.h"

#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// What a file of an identification was.
struct IdentifiedInput {
    std::string name;
    std::string sha256;
    std::string start;  // date and time as the recording gives it, or empty
    double seconds = 0;
    double rate_hz = 0;
    double f0_hz = 0;

    friend bool operator==(const IdentifiedInput&, const IdentifiedInput&) = default;
};

// The individual wave pattern of a gyro: its resonator with covariance, what its waves did, and
// where all this comes from.
struct Passport {
    static constexpr int schema = 1;  // of its file

    std::string program;
    std::vector<IdentifiedInput> inputs;
    std::vector<std::pair<std::string, std::string>> settings;  // name and value, as options
    ResonatorModel model{};
    ResonatorEstimate resonator;
    std::vector<ModeEstimate> modes;
    RawParameters raw;
    std::vector<RunTrack> tracks;  // one for each input
};

enum class Verdict { unchanged, changed, not_comparable };

// "unchanged", "changed", "not comparable".
const char* verdict_name(Verdict verdict);

// One parameter, then and now.
struct Difference {
    std::string name;  // as in identify JSON; "modes[0].f_hz" for a mode's
    const char* unit = "";
    Estimate then;
    Estimate now;
    double change = 0;  // now - then, axes by the shorter way; NaN: not comparable
    double sd = 0;      // of the change
    Verdict verdict{};

    double deviations() const;  // |change| / sd
};

// Every parameter of a resonator and of its modes that at least one of both sides knows: changed
// from three standard deviations of the difference on, both sides counted as independent; not
// comparable where one of them has no value, for its reason.
std::vector<Difference> compare(const Passport& passport, const ResonatorFit& now);

}  // namespace vybeg
