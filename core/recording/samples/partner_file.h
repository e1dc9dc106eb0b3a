#pragma once

#include <filesystem>
#include <optional>

namespace vybeg {

// The file beside a channel's file that holds the other channel by its name: the next number
// ("sig0001.ana", "sig0002.ana"; of a demodulator of LabOne) or the next letter in place of a
// single one ("run_C", "run_D"; "x", "y"; "sin" of "cos"). Nothing where there is no such file.
std::optional<std::filesystem::path> partner_of(const std::filesystem::path& path);

}  // namespace vybeg
