#pragma once

#include "ui/words/display_units.h"

#include <QString>

#include <cstdint>
#include <string>
#include <vector>

namespace vybeg::ui {

// What a column of a batch's table holds, by which its texts, colours and order differ.
enum class BatchColumnKind : std::uint8_t {
    text,
    state,
    reason,
    verdict,
    changed,
    model,
    noise,
    number,
    quantity,  // a parameter with its uncertainty, or its deviation
};

// A column of the window, made of fields of a row of RESULTS.csv.
struct BatchColumn {
    BatchColumnKind kind = BatchColumnKind::text;
    std::string name;  // in RESULTS.csv
    std::size_t field = 0;
    std::size_t sd_field = 0;  // of a quantity
    std::size_t u_field = 0;   // the same
    const char* unit = "";     // of a quantity, as resonator_parameters.h has it
};

// Those of every table, then the list's unknown ones.
std::vector<BatchColumn> batchColumns(const std::vector<std::string>& other_columns);

// "Frequency split", and its unit in a second line.
QString batchColumnTitle(const BatchColumn& column, const DisplayUnits& units);
QString batchColumnTip(const BatchColumn& column);
// From stored values to displayed ones.
double batchColumnFactor(const BatchColumn& column, const DisplayUnits& units);

}  // namespace vybeg::ui
