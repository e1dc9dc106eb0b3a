#pragma once

#include "tests/app/cli_run.h"

#include <QJsonArray>

#include <array>
#include <cmath>
#include <numbers>

namespace vybeg::test {

// Twice theta_A of the four starts: 0, 22.5, 45, 67.5 degrees.
inline const std::array<const char*, 4> starts{"0", "0.7853981633974483", "1.5707963267948966",
                                               "2.356194490192345"};

// The four files of a set, PREFIX0.wav and so on.
inline QStringList set_of(const QString& prefix) {
    QStringList files;
    for (std::size_t k = 0; k < starts.size(); ++k) {
        files += prefix + QString::number(k) + ".wav";
    }
    return files;
}

// Ten seconds from each start, with a frequency of its own; whether it went well.
inline bool simulate_set(const QString& folder, const QString& prefix, const QString& split,
                         int seed) {
    bool done = true;
    for (std::size_t k = 0; k < starts.size(); ++k) {
        const Outcome simulated =
            run_cli(words("simulate --seconds 10 --noise 0.001 --tau 400 --theta-w 0.2 "
                          "--damping-anisotropy 3e-4 --theta-tau -0.3 --omega 5e-5") +
                        QStringList{"--split", split, "--f0",
                                    QString::number(5300 + 0.01 * static_cast<double>(k), 'g', 17),
                                    "--two-theta-A", starts[k], "--seed",
                                    QString::number(seed + static_cast<int>(k)), "-o",
                                    set_of(prefix)[static_cast<qsizetype>(k)]},
                    folder);
        done = done && simulated.status == 0;
    }
    return done;
}

// A wave that hardly moves: 28 s at a millionth of a hertz.
inline bool simulate_still(const QString& folder) {
    return run_cli({"simulate", "--seconds", "28", "--noise", "0.001", "--tau", "400", "--split",
                    "1e-6", "--theta-w", "0.2", "--two-theta-A", starts[1], "-o", "still.wav"},
                   folder)
               .status == 0;
}

inline bool is_quantity(const QJsonObject& object) {
    if (object["value"].isNull()) {
        return object.keys() == QStringList{"reason", "value"} &&
               object["reason"].toString().endsWith('.');
    }
    // With the tolerances of the channels also u, of the resonator also its sensitivities.
    QStringList keys = object.keys();
    keys.removeOne("sensitivity");
    const bool has_u = keys.removeOne("u");
    return keys == QStringList{"sd", "value"} && object["value"].isDouble() &&
           object["sd"].isDouble() && (!has_u || object["u"].toDouble() >= object["sd"].toDouble());
}

// The error of a quantity in its own deviations.
inline double deviations(const QJsonValue& quantity, double truth, double period = 0) {
    const double error = quantity["value"].toDouble() - truth;
    const double off = period > 0 ? std::remainder(error, period) : error;
    return std::abs(off) / quantity["sd"].toDouble();
}

// What is wrong with the failure of a run that should end with one sentence, of which `part` is
// known; empty: nothing.
inline QString fault_of(const Outcome& outcome, int status, const QString& part) {
    const bool fine = outcome.status == status && outcome.err_lines().size() == 1 &&
                      outcome.err.startsWith("vybeg-cli: ") && outcome.err.endsWith(".\n") &&
                      outcome.err.contains(part.toUtf8());
    return fine ? QString() : QString("%1: %2").arg(outcome.status).arg(QString(outcome.err));
}

}  // namespace vybeg::test
