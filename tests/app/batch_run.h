#pragma once

#include "tests/app/cli_run.h"

#include <array>
#include <utility>

namespace vybeg::test {

// The rows of a table, without its header and line of names.
inline QList<QByteArray> rows_of(const QByteArray& table) {
    QList<QByteArray> rows;
    for (const QByteArray& line : table.split('\n')) {
        if (!line.isEmpty() && !line.startsWith("# ") && !line.startsWith("set,gyro,")) {
            rows << line;
        }
    }
    return rows;
}

inline QList<QByteArray> names_of(const QByteArray& table) {
    for (const QByteArray& line : table.split('\n')) {
        if (line.startsWith("set,gyro,")) {
            return line.split(',');
        }
    }
    return {};
}

// A field of a row whose earlier fields hold no comma in quotes but that of "files".
inline QByteArray field_of(const QByteArray& table, int row, const QByteArray& name) {
    const QList<QByteArray> fields = rows_of(table).at(row).split(',');
    const qsizetype at = names_of(table).indexOf(name);
    return at >= 0 && at < fields.size() ? fields[at] : QByteArray("(no such column)");
}

// Twelve sets of one to three recordings, of which "broken" cannot be read and "gone" is not there.
inline const QByteArray twelve_sets =
    "set,file,gyro,date,from,lot\n"
    "s1,a.wav,G1,2026-01-01,,L1\n"
    "s1,b.wav,,,,L1\n"
    "s2,b.wav,G2,,0.2,\n"
    "s3,a.wav,G1,,,\n"
    "s3,b.wav,,,0.1,\n"
    "s3,c.wav,,,,\n"
    "broken,broken.wav,G3,,,L2\n"
    "s5,c.wav,,,,\n"
    "s6,c.wav,,,0.3,\n"
    "gone,a.wav,G1,,,\n"
    "gone,gone.wav,,,,\n"
    "s8,b.wav,,,,\n"
    "s9,a.wav,,,0.5,\n"
    "s9,c.wav,,,0.5,\n"
    "twice,a.wav,,,,\n"
    "twice,a.wav,,,,\n"
    "s11,a.wav,,,0.2,\n"
    "s12,b.wav,,,0.3,\n"
    "s12,c.wav,,,,L3\n";

// Writes list.csv and its recordings.
inline bool make_twelve_sets(const QString& folder) {
    bool done = put(folder + "/list.csv", twelve_sets) &&
                put(folder + "/broken.wav", "RIFF\x10WAVEnothing");
    for (const auto& [name, start] :
         {std::pair{"a.wav", "0"}, std::pair{"b.wav", "0.7854"}, std::pair{"c.wav", "1.5708"}}) {
        done =
            done &&
            run_cli(
                words("simulate --seconds 2 --noise 0.001 --tau 400 --split 1e-3 --theta-w 0.2") +
                    QStringList{"--two-theta-A", start, "-o", name},
                folder)
                    .status == 0;
    }
    return done;
}

}  // namespace vybeg::test
