#include "app/analysis_options.h"

#include "app/option_values.h"
#include "core/analysis/setting_table.h"
#include "core/base/messages.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace vybeg::cli {
namespace {

int small_whole_value(const std::string& option, const std::string& text, int least,
                      const std::string& allowed) {
    const std::int64_t number = whole_value(option, text);
    if (number < least || number > std::numeric_limits<int>::max()) {
        reject(option, text, allowed);
    }
    return static_cast<int>(number);
}

int channel(const std::string& option, const std::string& text, double number,
            const std::string& allowed) {
    if (number < 1 || number > std::numeric_limits<int>::max() || number != std::floor(number)) {
        reject(option, text, allowed);
    }
    return static_cast<int>(number);
}

// The names between the commas, of which only the middle one of three may be empty.
std::vector<std::string> variable_names(const std::string& option, const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        names.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    if (names.size() > 3 || names.front().empty() || names.back().empty()) {
        reject(option, text, "it is one to three names with commas, as in C,D,fs or XY,,fs");
    }
    return names;
}

RawLayout raw_layout(const std::string& option, const std::string& text) {
    RawLayout layout;
    std::string type = text;
    if (const std::size_t colon = text.find(':'); colon != std::string::npos) {
        const std::string order = text.substr(colon + 1);
        layout.big_endian = order == "be";
        type = order == "be" || order == "le" ? text.substr(0, colon) : text;
    }
    if (type == "i16") {
        layout.type = RawType::i16;
    } else if (type == "i32") {
        layout.type = RawType::i32;
    } else if (type == "f32") {
        layout.type = RawType::f32;
    } else if (type == "f64") {
        layout.type = RawType::f64;
    } else {
        reject(option, text, "it is i16, i32, f32 or f64, with :be for big-endian");
    }
    return layout;
}

// The companions of --raw, which stands before them in the order of parsing.
RawLayout& raw_of(OpenOptions& options, const std::string& option) {
    if (!options.raw) {
        throw CLI::ValidationError(option + " needs --raw.");
    }
    return *options.raw;
}

// What is said of a text file, which excludes --raw.
TextChoice& text_of(OpenOptions& options, const std::string& option) {
    if (options.raw) {
        throw CLI::ValidationError(option + " is for text, and --raw reads no text.");
    }
    return options.text ? *options.text : options.text.emplace();
}

void add_text_options(CLI::App& app, OpenOptions& options) {
    add_value(app, "--delimiter", "NAME",
              "Between the columns of a text file: comma, semicolon, tab, space or bar (default: "
              "guessed, as is all that follows)",
              [&options](const auto& option, const auto& text) {
                  text_of(options, option).delimiter = delimiter_from_name(text);
                  if (!options.text->delimiter) {
                      reject(option, text, "it is comma, semicolon, tab, space or bar");
                  }
              });
    add_value(app, "--decimal", "SIGN", "Decimal sign of a text file: point or comma",
              [&options](const auto& option, const auto& text) {
                  if (text != "point" && text != "comma") {
                      reject(option, text, "it is point or comma");
                  }
                  text_of(options, option).decimal_comma = text == "comma";
              });
    add_value(app, "--skip-lines", "N", "Lines of a text file above its first row of numbers",
              [&options](const auto& option, const auto& text) {
                  text_of(options, option).lines_to_skip = whole_value(option, text);
              });
    add_value(app, "--time-column", "N|none",
              "Column of a text file that is the time, from 1; none: every column is a channel",
              [&options](const auto& option, const auto& text) {
                  text_of(options, option).time_column =
                      text == "none" ? 0
                                     : small_whole_value(option, text, 1,
                                                         "it is the number of a column, from 1, "
                                                         "or none");
              });
    add_value(app, "--time-unit", "UNIT", "Unit of the time column: s, ms, us or ns",
              [&options](const auto& option, const auto& text) {
                  text_of(options, option).time_unit_s = time_unit_from_name(text);
                  if (!options.text->time_unit_s) {
                      reject(option, text, "it is s, ms, us or ns");
                  }
              });
}

// The rows of a table of settings as options.
template <class S>
void add_settings(CLI::App& app, const std::vector<SettingRow<S>>& rows, S& settings) {
    for (const SettingRow<S>& row : rows) {
        const auto take = [&row, &settings](const std::string& text) {
            if (const Status read = row.read(text, settings); !read) {
                throw CLI::ValidationError(english(read.error()));
            }
        };
        if (row.placeholder.empty()) {
            app.add_flag_callback(
                row.option(), [take] { take("yes"); }, row.help);
        } else {
            add_value(app, row.option(), row.placeholder, row.help,
                      [take](const auto&, const auto& text) { take(text); });
        }
    }
    app.get_option("--periods")->excludes("--window");
}

}  // namespace

void add_open_options(CLI::App& app, OpenOptions& options) {
    add_number(app, "--rate", options.rate_hz, "HZ", "Sample rate where the file has none, Hz");
    add_value(app, "--channels", "I,J",
              "Which two channels or columns are C and D, from 1; a time column does not count "
              "(default 1,2)",
              [&options](const auto& option, const auto& text) {
                  const std::string allowed = "it must be two channel numbers from 1, as in 1,2";
                  const auto pair = list_value(option, text, 2, allowed);
                  options.channel_c = channel(option, text, pair[0], allowed);
                  options.channel_d = channel(option, text, pair[1], allowed);
              });
    add_value(
        app, "--variables", "C,D[,RATE]",
        "Names of the variables of a MAT, HDF5 or NPZ file that hold C and D, and the rate; D "
        "is left out where one holds both: XY or XY,,RATE",
        [&options](const auto& option, const auto& text) {
            options.variables = variable_names(option, text);
        });
    add_value(app, "--raw", "TYPE", "Headerless interleaved samples: i16, i32, f32, f64 [:be]",
              [&options](const auto& option, const auto& text) {
                  options.raw = raw_layout(option, text);
              });
    add_value(app, "--raw-channels", "N", "Channels of --raw (default 2)",
              [&options](const auto& option, const auto& text) {
                  raw_of(options, option).channels =
                      small_whole_value(option, text, 1, "it must be at least 1");
              });
    add_value(app, "--skip", "BYTES", "Bytes before the first sample of --raw (default 0)",
              [&options](const auto& option, const auto& text) {
                  const std::int64_t bytes = whole_value(option, text);
                  if (bytes < 0) {
                      reject(option, text, "it cannot be negative");
                  }
                  raw_of(options, option).skip_bytes = bytes;
              });
    add_text_options(app, options);
    add_value(app, "--scale", "X",
              "Recording units per count of --raw, or per unit of a text file (default 1)",
              [&options](const auto& option, const auto& text) {
                  const double scale = number_value(option, text);
                  (options.raw ? options.raw->scale : text_of(options, option).scale) = scale;
              });
    add_value(app, "--unit", "NAME", "Unit of the samples, e.g. V (default: the file's)",
              [&options](const auto&, const auto& text) { options.unit = text; });
}

void add_analysis_options(CLI::App& app, Settings& settings) {
    add_settings(app, analysis_settings(), settings);
}

void add_identify_options(CLI::App& app, IdentifySettings& settings) {
    add_settings(app, identify_settings(), settings);
}

void add_compare_options(CLI::App& app, CompareOptions& options) {
    add_value(app, "--f-limit", "PPM",
              "Frequencies count as changed beyond this, ppm: they follow the temperature (default "
              "30)",
              [&options](const auto& option, const auto& text) {
                  options.f_limit_ppm = number_value(option, text);
                  if (options.f_limit_ppm < 0) {
                      reject(option, text, "it cannot be negative");
                  }
              });
}

}  // namespace vybeg::cli
