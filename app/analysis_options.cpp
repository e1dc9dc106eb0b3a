#include "app/analysis_options.h"

#include "app/option_values.h"
#include "core/analysis/setting_table.h"
#include "core/base/messages.h"
#include "core/base/read_value.h"
#include "core/batch/limits.h"
#include "core/recording/samples/open_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace vybeg::cli {
namespace {

template <class S>
void add_setting(CLI::App& app, const SettingRow<S>& row, S& settings) {
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

// The rows of a table of settings as options.
template <class S>
void add_settings(CLI::App& app, const std::vector<SettingRow<S>>& rows, S& settings) {
    for (const SettingRow<S>& row : rows) {
        add_setting(app, row, settings);
    }
}

}  // namespace

void add_open_options(CLI::App& app, OpenOptions& options) {
    add_settings(app, open_settings(), options);
}

void add_drift_settings(CLI::App& app, DriftSettings& settings) {
    add_settings(app, drift_settings(), settings);
}

void add_analysis_options(CLI::App& app, Settings& settings) {
    add_settings(app, analysis_settings(), settings);
    app.get_option("--periods")->excludes("--window");
}

void add_identify_options(CLI::App& app, IdentifySettings& settings) {
    add_settings(app, identify_settings(), settings);
    app.get_option("--periods")->excludes("--window");
}

void add_column_options(CLI::App& app, std::string& columns, double& rad_per_angle_unit,
                        const std::string& roles) {
    add_value(app, "--columns", "NAMES", roles,
              [&columns](const auto&, const auto& text) { columns = text; });
    add_value(app, "--angle-unit", "deg|rad", "Unit of theta where the file does not tell it",
              [&rad_per_angle_unit](const auto& option, const auto& text) {
                  if (text != "deg" && text != "rad") {
                      reject(option, text, "it is deg or rad");
                  }
                  rad_per_angle_unit = text == "rad" ? 1 : std::numbers::pi / 180;
              });
}

LockIn lock_in_value(const std::string& option, const std::string& text, double* rate_hz) {
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    const std::size_t count = rate_hz == nullptr ? 2 : 3;
    std::vector<std::optional<double>> numbers;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        numbers.push_back(number_with_unit(parts[k], k == 0 ? "" : "Hz"));
    }
    const bool known = parts.size() == count && std::ranges::all_of(numbers, [](const auto& x) {
                           return x && *x > 0 && *x < 1e9;
                       });
    if (!known || *numbers[0] != std::floor(*numbers[0]) || *numbers[0] > 8) {
        reject(option, text,
               rate_hz == nullptr
                   ? "it is an order from 1 to 8 and a bandwidth, e.g. 4,20Hz"
                   : "it is an order from 1 to 8, a bandwidth and a rate, e.g. 4,20Hz,200Hz");
    }
    if (rate_hz != nullptr) {
        *rate_hz = *numbers[2];
    }
    return {static_cast<int>(*numbers[0]), *numbers[1]};
}

void add_phasor_options(CLI::App& app, PhasorChoice& choice) {
    add_value(app, "--phasors", "fixed|common|pll",
              "The files are logs of a lock-in or a phasemeter, with the columns Xc,Yc,Xd,Yd: "
              "relative to one frequency, to an oscillator that moves (column F or P), or each "
              "channel to its own phase (Pc,Pd)",
              [&choice](const auto& option, const auto& text) {
                  for (const PhasorFrame frame :
                       {PhasorFrame::fixed, PhasorFrame::common, PhasorFrame::pll}) {
                      if (text == frame_name(frame)) {
                          choice.frame = frame;
                          return;
                      }
                  }
                  reject(option, text, "it is fixed, common or pll");
              });
    CLI::Option* const phasors = app.get_option("--phasors");
    add_value(app, "--f-ref", "HZ",
              "With --phasors: frequency of the reference (default: of the file)",
              [&choice](const auto& option, const auto& text) {
                  const auto f_hz = number_with_unit(text, "Hz");
                  if (!f_hz || !(*f_hz > 0 && *f_hz < 1e12)) {
                      reject(option, text, "it is a frequency above zero");
                  }
                  choice.f_ref_hz = *f_hz;
              })
        ->needs(phasors);
    add_value(app, "--y-sign", "+|-",
              "With --phasors: the signal is Re((X + iY) e^iwt) or Re((X - iY) e^iwt)",
              [&choice](const auto& option, const auto& text) {
                  if (text != "+" && text != "-") {
                      reject(option, text, "it is + or -");
                  }
                  choice.y_sign = text == "+" ? 1 : -1;
              })
        ->needs(phasors);
    add_value(app, "--amplitude", "peak|rms", "With --phasors: what sqrt(X^2 + Y^2) is",
              [&choice](const auto& option, const auto& text) {
                  if (text != "peak" && text != "rms") {
                      reject(option, text, "it is peak or rms");
                  }
                  choice.peak_per_unit = text == "peak" ? 1 : std::numbers::sqrt2;
              })
        ->needs(phasors);
    add_value(
        app, "--lock-in", "ORDER,BW",
        "With --phasors: RC stages of the lock-in's filter, 1 to 8, and its 3 dB bandwidth, Hz "
        "(default: none)",
        [&choice](const auto& option, const auto& text) {
            choice.filter = lock_in_value(option, text, nullptr);
        })
        ->needs(phasors);
}

void add_tolerance_option(CLI::App& app, IdentifySettings& settings) {
    const auto& rows = identify_settings();
    const auto row =
        std::ranges::find(rows, std::string("tolerance"), &SettingRow<IdentifySettings>::name);
    add_setting(app, *row, settings);
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
    add_value(app, "--limit", "NAME=X[,NAME=X]",
              "Smaller changes count as none, significant or not: in the parameter's unit, or "
              "relative as in tau=0.5%,f_mean=10ppm",
              [&options](const auto&, const auto& text) {
                  Result<std::vector<PracticalLimit>> limits = read_practical_limits(text);
                  if (!limits) {
                      throw CLI::ValidationError(english(limits.error()));
                  }
                  options.limits = std::move(*limits);
              });
}

}  // namespace vybeg::cli
