#pragma once

#include "core/resonator/results/resonator_fit.h"
#include "core/resonator/runs/run_track.h"

#include <cstddef>
#include <optional>
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
    // Of its file. 2 adds the uncertainties u, modes_by and runs.
    static constexpr int schema = 2;

    std::string program;
    std::vector<IdentifiedInput> inputs;
    std::vector<std::pair<std::string, std::string>> settings;  // name and value, as options
    ResonatorModel model{};
    ResonatorEstimate resonator;
    std::vector<ModeEstimate> modes;
    // What the modes are named by; none: not known, in an old file.
    std::optional<ModeOrder> mode_order = ModeOrder::frequency;
    std::vector<RunEstimate> runs;  // one for each input; none in an old file
    RawParameters raw;
    std::vector<RunTrack> tracks;  // one for each input
};

enum class Verdict { unchanged, changed, not_comparable };

// "unchanged", "changed", "not comparable".
const char* verdict_name(Verdict verdict);

// Why a parameter is not comparable.
enum class Incomparable {
    none,
    now_unknown,       // for the reason of `now`
    then_unknown,      // for the reason of `then`
    other_direction,   // no wave of the passport stands in this direction
    other_mode_order,  // the modes of both sides are named by different things
};

// One parameter, then and now.
struct Difference {
    std::string name;  // as in identify JSON: "split_hz", "modes[0].f_hz", "runs[0].direction.f_hz"
    const char* unit = "";
    Estimate then;
    Estimate now;
    double change = 0;    // now - then, axes by the shorter way; NaN: not comparable
    double sd = 0;        // of the change: statistical
    double u = 0;         // with the channels' tolerances and, of a frequency, the runs' spread
    double relative = 0;  // change / then; NaN: an axis, or nothing to relate to
    double limit = 0;     // smaller changes count as none; unit of the change
    Verdict verdict{};
    Incomparable why{};  // of not_comparable

    double deviations() const;  // |change| / u
};

struct CompareOptions {
    // Frequencies follow the temperature (some 20 ppm per 0.1 Hz at 5 kHz): smaller changes of them
    // are no change of the gyro.
    double f_limit_ppm = 30;
};

// English sentence of the last two, translated like those of messages.h; empty for the others.
const char* incomparable_sentence(Incomparable why);

// The whole English sentence of a difference that is not comparable.
std::string incomparable_text(const Difference& difference);

// The size, in deviations, from which on one of `count` independent normal numbers is called
// changed: by chance as rarely as one number alone goes beyond three (0.27 %).
double changed_from(std::size_t count);

// Every parameter of a resonator and of its modes that at least one of both sides knows: changed
// where it has moved by changed_from(number of parameters compared) combined deviations of the
// difference, both sides counted as independent, and a frequency also by the limit; not comparable
// where one of them has no value, for its reason.
// Modes are compared where both sides name them alike. Where the mean frequency or the decay time
// of the resonator cannot be compared, those of the runs' directions are, each with the run of the
// passport whose 2theta_A is nearest: within 0.1 rad modulo pi, with what the
// unseen split and anisotropy may make of the rest in u.
std::vector<Difference> compare(const Passport& passport, const ResonatorFit& now,
                                const CompareOptions& options = {});

}  // namespace vybeg
