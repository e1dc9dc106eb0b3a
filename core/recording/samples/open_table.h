#pragma once

#include "core/base/setting_rows.h"
#include "core/recording/samples/open_options.h"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace vybeg {

// The choices of a text file by their words, in the order of lists of them.
inline constexpr std::array delimiters{std::pair{"comma", ','}, std::pair{"semicolon", ';'},
                                       std::pair{"tab", '\t'}, std::pair{"space", ' '},
                                       std::pair{"bar", '|'}};
inline constexpr std::array decimal_signs{std::pair{"point", false}, std::pair{"comma", true}};
inline constexpr std::array time_units{std::pair{"s", 1.0}, std::pair{"ms", 1e-3},
                                       std::pair{"us", 1e-6}, std::pair{"ns", 1e-9}};

// How a recording is opened, a row for each option, in the order of the command line's help: an
// option that needs another one comes after it. The text of an option that is not given is empty.
// check_options() checks the values and their bounds together.
const std::vector<SettingRow<OpenOptions>>& open_settings();

// Text of `options` other than rate and channels, as on the command line; empty without such
// options.
std::string options_text(const OpenOptions& options);

// Checks the options without a file: a positive rate, two different channels. Errors:
// setting_invalid.
Status check_options(const OpenOptions& options);

// Its part about headerless samples.
Status check_layout(const RawLayout& layout);

// The file of this name, which may be a path of Windows, relative to `folder`.
std::filesystem::path file_from(const std::filesystem::path& folder, std::string name);

// Makes the names of further files absolute that are relative to `folder`.
void find_files_from(const std::filesystem::path& folder, OpenOptions& options);

// The further files: that of channel D, the pieces.
std::vector<std::filesystem::path> further_files(const OpenOptions& options);

}  // namespace vybeg
