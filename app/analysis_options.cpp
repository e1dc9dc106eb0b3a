#include "app/analysis_options.h"

#include "app/option_values.h"
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

void add_band(CLI::App& app, const std::string& name, std::optional<Band>& target,
              const std::string& help) {
    add_value(app, name, "LO,HI", help, [&target](const auto& option, const auto& text) {
        const auto edges = list_value(option, text, 2, "it must be two frequencies in Hz, LO,HI");
        target = Band{edges[0], edges[1]};
    });
}

// The window's length, of which `take` gets the samples.
void add_length_options(CLI::App& app, Settings& settings, const std::string& help,
                        std::function<void(std::int64_t)> take) {
    auto* const window = add_value(app, "--window", "N", help,
                                   [take = std::move(take)](const auto& option, const auto& text) {
                                       take(whole_value(option, text));
                                   });
    add_number(app, "--periods", settings.periods, "P",
               "Window length in periods of the carrier; may be fractional")
        ->excludes(window);
    app.add_flag("--snap", settings.snap,
                 "Move the window to whole half-periods, where the averages are orthogonal");
}

void add_hop_option(CLI::App& app, Settings& settings) {
    add_value(app, "--hop", "N", "Samples between window starts (default: the window)",
              [&settings](const auto& option, const auto& text) {
                  settings.hop = whole_value(option, text);
                  if (settings.hop < 1) {
                      reject(option, text, "it must be at least 1 sample");
                  }
              });
}

void add_start_options(CLI::App& app, Settings& settings) {
    add_value(app, "--initial", "aA,aB,2thetaA,alpha,f",
              "Start values of conjugate-gradient: recording units, rad, Hz; alpha at the centre "
              "of the first window",
              [&settings](const auto& option, const auto& text) {
                  const auto v = list_value(option, text, 5, "it must be five numbers with commas");
                  settings.initial = StartValues{{v[0], v[1], v[2], v[3]}, v[4]};
              });
    add_value(app, "--start", "first|previous",
              "conjugate-gradient starts each window from in-phase or from the window before "
              "(default first)",
              [&settings](const auto& option, const auto& text) {
                  if (text != "first" && text != "previous") {
                      reject(option, text, "it is first or previous");
                  }
                  settings.start = text == "first" ? StartRule::first : StartRule::previous;
              });
}

void add_calibration_options(CLI::App& app, Calibration& calibration) {
    add_number(app, "--kappa", calibration.kappa, "K",
               "Gain ratio of the channels: S_D = D / K (default 1)");
    add_value(app, "--offset", "C,D|auto",
              "Offsets of the channels, recording units; auto: the mean of each over whole periods "
              "(default 0,0)",
              [&calibration](const auto& option, const auto& text) {
                  calibration.offset_auto = text == "auto";
                  if (!calibration.offset_auto) {
                      const auto offsets =
                          list_value(option, text, 2, "it is two numbers C,D or auto");
                      calibration.offset_c = offsets[0];
                      calibration.offset_d = offsets[1];
                  }
              });
    add_number(app, "--delay", calibration.delay_d_s, "S",
               "By how much channel D comes late, s (default 0)");
    add_number(app, "--angle-zero", calibration.angle_zero_deg, "DEG",
               "Angle of the first electrode, degrees; subtracted from theta_A (default 0)");
}

void add_f0_option(CLI::App& app, Settings& settings) {
    add_number(app, "--f0", settings.f0_hz, "HZ", "The carrier, Hz; skips the search for it");
}

// What is done to the signals on their way to the windows.
void add_signal_options(CLI::App& app, Settings& settings) {
    add_number(app, "--from", settings.from_s, "S", "Start of the part to analyse, s");
    add_number(app, "--to", settings.to_s, "S", "End of the part to analyse, s");
    add_band(app, "--band", settings.band, "Look for the carrier between two frequencies, Hz");
    add_band(app, "--filter", settings.filter, "Zero-phase band-pass before everything, Hz");
    add_calibration_options(app, settings.calibration);
    app.add_flag("--repair-lost", settings.repair_lost,
                 "Make gaps where samples were lost, so that time runs on behind them");
    add_value(app, "--threads", "N", "Threads (default: as many as the machine has)",
              [&settings](const auto& option, const auto& text) {
                  settings.threads = small_whole_value(option, text, 1, "it must be at least 1");
              });
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
    add_value(app, "--algorithm", "NAME",
              "in-phase, phase-shift, moving-axes, demodulation, conjugate-gradient or "
              "maximum-likelihood (default)",
              [&settings](const auto& option, const auto& text) {
                  const std::optional<Algorithm> algorithm = algorithm_from_name(text);
                  if (!algorithm) {
                      reject(option, text,
                             "it is in-phase, phase-shift, moving-axes, demodulation, "
                             "conjugate-gradient or maximum-likelihood");
                  }
                  settings.algorithm = *algorithm;
              });
    add_length_options(app, settings, "Window length, samples (default 60)",
                       [&settings](std::int64_t samples) { settings.window = samples; });
    add_hop_option(app, settings);
    add_f0_option(app, settings);
    add_start_options(app, settings);
    add_signal_options(app, settings);
}

void add_identify_options(CLI::App& app, IdentifySettings& settings) {
    add_value(app, "--model", "NAME",
              "auto (default), structured (the pick-offs are a calibrated pair) or free (only the "
              "modes)",
              [&settings](const auto& option, const auto& text) {
                  using enum FitOptions::Model;
                  if (text != "auto" && text != "structured" && text != "free") {
                      reject(option, text, "it is auto, structured or free");
                  }
                  settings.model =
                      text == "auto" ? automatic : (text == "free" ? free : structured);
              });
    add_length_options(app, settings.signal,
                       "Window length, samples (default: 15 ms, 12 periods at least)",
                       [&settings](std::int64_t samples) { settings.window = samples; });
    add_f0_option(app, settings.signal);
    add_signal_options(app, settings.signal);
    add_value(
        app, "--tolerance", "NAME=X[,NAME=X]",
        "How well the channels are known, standard deviations: kappa (relative, default "
        "0.01), skew (deg), delay (s), crosstalk (relative), phase-drift (rad over a run), "
        "gain-drift (relative, over a run); default 0, but for kappa. Units may follow, as in "
        "skew=0.1deg,delay=10ns",
        [&settings](const auto&, const auto& text) {
            Result<Tolerance> tolerance = read_tolerance(text);
            if (!tolerance) {
                throw CLI::ValidationError(english(tolerance.error()));
            }
            settings.tolerance = *tolerance;
        });
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
