#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/arrays/npy_reader.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

// MAT files of level 4 and 5, as MathWorks, "MAT-File Format", describes them.
namespace vybeg {

// Whether a file of `size` bytes that begins with `head` is one of level 4: a possible header, a
// name that is one, and an array that the file has room for, at least a part of it.
bool is_mat4(std::string_view head, std::int64_t size);

bool is_mat5(std::string_view head);

namespace mat5 {

inline constexpr std::int64_t tag_bytes = 8;

// Types of elements (table 1-1), those of some numbers among them.
enum ElementType : std::uint32_t {
    int8 = 1,
    uint16 = 4,
    int32 = 5,
    uint32 = 6,
    float64 = 9,
    matrix = 14,
    compressed = 15,
    utf8 = 16,
    utf16 = 17
};

// Classes of arrays (table 1-3); those of numbers begin with the doubles.
enum ArrayClass : std::uint32_t {
    cell_class = 1,
    struct_class = 2,
    char_class = 4,
    double_class = 6
};

}  // namespace mat5

// The arrays of real numbers in a MAT file of level 4 or 5 and, by "name.field", in its single
// structs, read on demand: plain ones in place, compressed ones inflated on the way. Which of them
// is what: open_variables(). Errors: format_damaged, also where a size does not fit the numbers
// that are there; holds_log where Moku's converter wrote it of a phasemeter or a lock-in; those of
// open_variables(); interrupted.
Result<Recording> open_mat(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job);

// The columns of the table in a file of Moku's converter, whose struct `moku` names them; none: it
// is another file. Errors: those of open_mat() about the file.
Result<std::vector<NamedColumn>> moku_columns(const std::shared_ptr<const FileBytes>& file,
                                              const JobControl& job);

}  // namespace vybeg
