#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/measurement_list.h"
#include "core/base/diagnostic.h"
#include "core/resonator/results/resonator_fit.h"
#include "core/resonator/runs/run_track.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// Individual wave pattern of a gyro: resonator with covariance, motion of its waves, and sources.
struct Passport : ResonatorNumbers {
    // Schema of its file.
    static constexpr int schema = 2;

    std::string program;
    std::string gyro;  // empty: not stated, as in older files
    std::string date;  // ISO 8601; empty: not stated
    std::vector<std::pair<std::string, std::string>> conditions;  // columns of a list, those stated
    std::vector<RecordingRef> inputs;                             // name and content
    std::vector<std::pair<std::string, std::string>> settings;    // name and value, as options
    std::vector<RunTrack> tracks;                                 // one for each input
};

enum class Verdict { unchanged, changed, not_comparable };

// "unchanged", "changed", "not comparable".
const char* verdict_name(Verdict verdict);

// Reasons for which a parameter is not comparable.
enum class Incomparable {
    none,
    now_unknown,       // for the reason of `now`
    then_unknown,      // for the reason of `then`
    other_direction,   // the passport has no wave in this direction
    other_mode_order,  // the modes of both sides are ordered by different quantities
};

// One parameter of the passport and now.
struct Difference {
    std::string name;  // as in identify JSON: "split_hz", "modes[0].f_hz", "runs[0].direction.f_hz"
    const char* unit = "";
    Estimate then;
    Estimate now;
    double change = 0;    // now - then, axes by the shorter way; NaN: a side has no value
    double sd = 0;        // of the change: statistical
    double u = 0;         // with the channels' tolerances and, of a frequency, the runs' spread
    double relative = 0;  // change / then; NaN: an axis, or no reference
    double limit = 0;     // smaller changes count as none; unit of the change
    Verdict verdict{};
    Incomparable why{};    // where `change` is NaN
    bool follows = false;  // Q, beside a frequency and a decay time that are compared themselves

    bool known() const { return !std::isnan(change); }
    double deviations() const;  // |change| / u
};

// Comparison of a set with a passport.
struct PassportComparison {
    std::string file;
    std::string sha256;
    Passport passport;
    std::vector<Difference> differences;
};

// Smaller changes of a parameter do not matter to the engineer, significant or not.
struct PracticalLimit {
    std::string parameter;  // its name in resonator_parameters.h; holds for modes and runs, too
    double size = 0;        // in its unit, or relative to the passport's value
    bool relative = false;
};

struct CompareOptions {
    // Frequencies follow the temperature (some 20 ppm per 0.1 Hz at 5 kHz): smaller changes of them
    // do not count.
    double f_limit_ppm = 30;
    std::vector<PracticalLimit> limits{};  // of a frequency, in place of f_limit_ppm
};

// English sentence of the last two, translated like those of error.h; empty for the others.
const char* incomparable_sentence(Incomparable why);

// The whole English sentence of a difference that is not comparable.
std::string incomparable_text(const Difference& difference);

// Threshold, in deviations, for any of `count` independent normal numbers, with the false alarm
// rate of three deviations of one number (0.27 %).
double changed_from(std::size_t count);

// Those that can change by themselves: comparable, and no Q beside its frequency and decay time.
std::size_t count_compared(const std::vector<Difference>& differences);

// Compares every parameter of a resonator and of its modes with a value on at least one side.
// Changed: the difference exceeds changed_from(number of compared parameters) combined deviations,
// both sides independent, and also the limit of a frequency and those of `options`. Q follows from
// frequency and decay time: it has changed only where one of these has. Not comparable: one side
// has no value, with its reason; but a size that lies as far above the other side's bound, the
// greatest size of a difference within its noise, has changed. Modes are compared if both sides
// name them alike. If the mean frequency or the decay time of the resonator is not comparable,
// those of the runs' directions are compared, each with the run of the passport of the nearest
// 2theta_A, within 0.1 rad modulo pi; u then includes the effect of the undetermined split and
// anisotropy on the remaining angle.
std::vector<Difference> compare(const Passport& passport, const ResonatorFit& now,
                                const CompareOptions& options = {});

// The warning that a passport is another gyro's; nothing where either side names none.
std::optional<Diagnostic> other_gyro(const Passport& passport, const std::string& gyro);

// A set and the resonator identified from its recordings.
struct SetResult {
    std::string program;  // name and version of the one that identified it
    MeasurementSet set;   // its recordings with what they contain, as identification.runs
    Identification identification;
    std::optional<PassportComparison> comparison;
    double seconds = 0;  // duration, by the caller's clock
};

}  // namespace vybeg
