#pragma once

#include "core/analysis/passport.h"
#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace vybeg {

// Passport as JSON text: "vybeg": "passport" and "schema": its number first, then program, gyro,
// date, conditions, inputs, settings, model, resonator, modes, modes_by, runs, parameters with
// covariance, tracks. Quantities as in identify JSON, with the reason's code and arguments beside
// its sentence, so that they read back. Numbers round-trip.
std::string passport_json(const Passport& passport);

// Reads such a text. Errors, with `where` as given: passport_damaged with the fault and its place
// in the file, also of schema 1; passport_schema for a schema newer than this program.
Result<Passport> read_passport(std::string_view text, const std::string& where);

// Reads a passport file. Errors also: those of own_file_text().
Result<Passport> read_passport_file(const std::filesystem::path& path);

// A result as a session saves it: its passport without the tracks of the waves, the warnings, and
// what became of each recording.
std::string saved_result_json(const SetResult& result);

// The reverse, without settings, motion of the waves, drift function and channel balance. Errors:
// those of read_passport().
Result<SetResult> read_saved_result(std::string_view text);

}  // namespace vybeg
