#pragma once

#include "core/analysis/identify_settings.h"
#include "core/base/describe.h"
#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// Conditions of one recording; empty where the list has none.
struct Conditions {
    std::string gyro;
    std::string date;  // ISO 8601
    std::optional<double> bias_v;
    std::optional<double> temperature_c;
    bool exchanged = false;  // pick-off C on amplifier 2
    std::string operator_name;
    std::string comment;

    friend bool operator==(const Conditions&, const Conditions&) = default;
};

// By the names of a list's columns.
template <class Archive, Described<Conditions> Owner>
void describe(Archive&& archive, Owner& conditions) {
    archive("gyro", conditions.gyro);
    archive("date", conditions.date);
    archive("bias_v", conditions.bias_v);
    archive("temperature_c", conditions.temperature_c);
    archive("exchanged", conditions.exchanged);
    archive("operator", conditions.operator_name);
    archive("comment", conditions.comment);
}

// A recording of a set: its file and how it is read, the conditions it was made under, and its
// content, known once it was read.
struct RecordingRef {
    std::string file;  // as the list names it
    std::filesystem::path path;
    OpenOptions open{};
    Conditions conditions{};
    std::vector<std::pair<std::string, std::string>> others{};  // unknown columns and their fields
    std::string sha256{};
    std::string start{};  // date and time from the file, or empty
    double seconds = 0;
    double rate_hz = 0;
    double f0_hz = 0;
    int id = 0;  // by which a program's document knows it; 0: none

    std::string name() const { return path.filename().string(); }

    friend bool operator==(const RecordingRef&, const RecordingRef&) = default;
};

// Recordings of one resonator, in the order of the list.
struct MeasurementSet {
    std::string name;
    std::vector<RecordingRef> recordings;
    IdentifySettings settings;
};

struct MeasurementList {
    std::vector<std::string> other_columns;  // unknown ones
    std::vector<MeasurementSet> sets;        // by their first recordings
    std::vector<Diagnostic> warnings;        // columns without effect, formulas
};

// Reads a measurement list (help, files.html): a row for each recording, whose file is relative to
// the list. A column named as an option of `analyze` or `identify` is that option; empty fields
// leave the default. Window, model, tolerance, threads, gain ratio and what logs are
// (log_settings()) hold for the whole set: one row suffices. In numbers a comma is a decimal sign;
// in lists of numbers with semicolons, too. `open` and `settings`: of every recording whose row
// does not give them. Checks all that can be checked without the recordings. Errors: those of
// read_csv(); list_invalid.
Result<MeasurementList> read_measurement_list(const std::filesystem::path& path,
                                              const OpenOptions& open,
                                              const IdentifySettings& settings);

// Whether a file is a measurement list: its first row has the column `file`. Of files with other
// endings than .csv and .txt none is read.
bool is_measurement_list(const std::filesystem::path& path);

// Every regular file of a folder as a set of its own, by name; without hidden files and those of
// which `left_out` is true. Errors: file_read_failed.
Result<MeasurementList> list_of_folder(
    const std::filesystem::path& folder, const OpenOptions& open, const IdentifySettings& settings,
    const std::function<bool(const std::filesystem::path&)>& left_out);

// Takes recordings out of a set, with their signal settings.
void leave_out(MeasurementSet& set, const std::function<bool(const RecordingRef&)>& which);

// What the recordings of a set say of a condition that the fit takes for all; empty: nothing.
// Errors: conditions_differ, with its name.
Result<std::string> one_told(const MeasurementSet& set, const MessageArg& name,
                             const std::function<std::string(const RecordingRef&)>& text_of,
                             bool any_case = false);

// Whether the recordings of a set have the same conditions, as far as the fit assumes it: gyro,
// bias voltage, exchange of the amplifiers. Errors: conditions_differ.
Status check_conditions(const MeasurementSet& set);

// Conditions of a set as a whole in a measurement list, for tables, passports and databases.

// The first gyro that a recording of the set names, and the first date, ISO 8601; empty: none.
std::string gyro_of(const MeasurementSet& set);
std::string list_date_of(const MeasurementSet& set);

// The conditions of a recording as a list has them, column by column; empty: not stated.
std::vector<std::pair<std::string, std::string>> fields_of(const Conditions& conditions);

// bias_v, temperature_c, exchanged, operator, comment: columns of a list, and their fields. Fields
// of recordings that differ are joined by ";"; empty: not stated.
std::vector<std::pair<std::string, std::string>> conditions_of(const MeasurementSet& set);

// The fields of the k-th unknown column in the same way.
std::string other_of(const MeasurementSet& set, std::size_t k);

}  // namespace vybeg
