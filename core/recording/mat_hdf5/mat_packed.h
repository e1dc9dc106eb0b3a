#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/byte_source.h"
#include "core/recording/bytes/number_type.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// Where the numbers of an array stand in the unpacked bytes of its variable, column after column.
struct PackedArray {
    std::shared_ptr<const ByteSource> bytes;
    NumberType type =
        NumberType::f64;  // as they are stored, which may be narrower than their class
    bool big_endian = false;
    std::int64_t offset = 0;
    std::int64_t count = 0;
};

// The compressed variables of a MAT file of level 5, unpacked on demand and on the way: libmatio
// begins at the variable's start for every read.
class PackedVariables {
public:
    // Errors: those of FileBytes.
    static Result<PackedVariables> open(const std::string& path);

    // The array of the name "C" or, a field of a single struct, "run.C". Its bytes are decoded for
    // the caller alone: who reads two channels by turns takes it twice. Errors: format_damaged,
    // also where there is no such array of numbers.
    Result<PackedArray> find(const std::string& name) const;

private:
    struct Variable {
        std::string name;
        std::int64_t offset = 0;  // of its deflated bytes
        std::int64_t packed_size = 0;
        std::int64_t size = 0;
    };

    std::shared_ptr<const ByteSource> unpacked(const Variable& variable) const;
    std::optional<Variable> variable_at(std::int64_t offset, std::int64_t size) const;

    std::shared_ptr<const FileBytes> file_;
    bool big_endian_ = false;
    std::vector<Variable> variables_;
};

}  // namespace vybeg
