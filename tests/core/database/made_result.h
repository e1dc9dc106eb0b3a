#pragma once

#include "core/database/results_database.h"
#include "core/resonator/results/resonator_parameters.h"

#include <limits>
#include <string>

namespace vybeg::test {

// Options of opening with something in each that text can have; a file of raw samples has others.
inline OpenOptions made_opening() {
    OpenOptions options{.rate_hz = 33333.5, .channel_c = 3, .channel_d = 2};
    options.text = TextChoice{};
    options.text->delimiter = ';';
    options.text->decimal_comma = true;
    options.text->lines_to_skip = 3;
    options.text->time_column = 1;
    options.text->time_unit_s = 1e-3;
    options.unit = "mV";
    options.channel_d_file = "/data/канал, D.csv";
    return options;
}

// A result with something in every field; `number` makes it another one.
inline StoredResult made_result(int number, const std::string& gyro = "G7") {
    StoredResult result;
    result.key = "key " + std::to_string(number);
    result.set = "set, \"" + std::to_string(number) + "\"; набор";
    result.gyro = gyro;
    result.date = {"2026-03-" + std::string(number % 28 < 9 ? "0" : "") +
                       std::to_string(number % 28 + 1) + "T14:05:30.5+03:00",
                   DateSource::list};
    result.program = "vybeg-cli 0.1.0";
    result.model = "structured";
    result.warnings = "residual-coloured;offset";
    for (int k = 0; k < 4; ++k) {
        RecordingRef recording;
        recording.file = "a/run-" + std::to_string(k) + ".wav";
        recording.path = "/data/" + recording.file;
        recording.sha256 = "sha " + std::to_string(k);
        recording.start = "2026-03-31";
        recording.seconds = 28.5;
        recording.rate_hz = 33333;
        recording.f0_hz = 5300.25;
        recording.open = made_opening();
        recording.conditions = {gyro, result.date.text, 60.5, 20.0 + k, true, "И. О.", "quiet"};
        recording.others = {{"lot", "L1"}, {"bench", ""}};
        result.recordings.push_back(recording);
    }
    result.recordings[3].conditions.temperature_c.reset();
    for (const ResonatorParameter& parameter : resonator_parameters) {
        result.parameters.push_back({parameter.name, {5300 + 1e-3 * number, 1e-6, {}, 2e-6}});
    }
    result.parameters[1].estimate = {
        std::numeric_limits<double>::quiet_NaN(),
        std::numeric_limits<double>::quiet_NaN(),
        {ReasonCode::one_direction, {number_arg(22.5, 3), number_arg(28, 3)}}};
    result.parameters.push_back({"modes[0].f_hz", {5300.0026, 1e-6, {}}});
    result.raw.names = {"f", "split"};
    result.raw.values = {5300.0026, 0.1 + 0.2};
    result.raw.covariance = {1e-12, -1e-13, -1e-13, std::numeric_limits<double>::quiet_NaN()};
    result.json = "{\n  \"program\": \"vybeg-cli\"\n}\n";
    return result;
}

}  // namespace vybeg::test
