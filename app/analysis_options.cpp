#include "app/analysis_options.h"

#include "app/option_values.h"
#include "core/analysis/setting_table.h"
#include "core/base/error.h"
#include "core/batch/limits.h"
#include "core/recording/samples/open_table.h"

#include <algorithm>
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

void add_log_choice(CLI::App& app, LogChoice& logs) {
    add_settings(app, log_settings(), logs);
}

void add_tolerance_option(CLI::App& app, IdentifySettings& settings) {
    add_setting(app, *row_named(identify_settings(), "tolerance"), settings);
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
