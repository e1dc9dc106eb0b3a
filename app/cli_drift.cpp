#include "app/cli_commands.h"
#include "app/cli_support.h"
#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/drift/drift_settings.h"
#include "core/output/drift_json.h"
#include "core/output/output_file.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>
#include <vector>

namespace vybeg::cli {
namespace {

std::string logs_text(const WholeAngleDrift& drift) {
    std::string text;
    for (std::size_t k = 0; k < drift.logs.size(); ++k) {
        const LogDrift& log = drift.logs[k];
        text += "log " + plain_text(log.name) + ", " + short_text(log.seconds) + " s, " +
                short_text(log.turn * 180 / std::numbers::pi, 4) + " degrees, " +
                integer_text(static_cast<std::int64_t>(log.rows)) + " rows" +
                (drift.left_out == k ? ", left out\n" : "\n");
        for (Eigen::Index term = 0; term < log_terms; ++term) {
            text += line(log_term_names[static_cast<std::size_t>(term)],
                         text_of(degrees_per_hour(log.coefficient(term)), "deg/h"));
        }
    }
    return text;
}

std::string drift_text(const WholeAngleDrift& drift) {
    std::string text = logs_text(drift) + "drift, d theta_A/dt\n";
    for (std::size_t k = 0; k < drift.harmonics.size(); ++k) {
        text += line(log_term_names[k], text_of(degrees_per_hour(drift.harmonics[k]), "deg/h"));
    }
    for (const LogAgreement& each : drift.agreement) {
        if (each.freedom > 0) {
            text +=
                line("harmonic " + integer_text(each.harmonic),
                     std::string(each.agrees ? "the logs agree" : "the logs differ") + ", chi^2 " +
                         short_text(each.chi2, 3) + " of " + short_text(each.freedom, 3));
        }
    }
    return text + "resonator, from the drift and the efforts\n" +
           lines_of(drift.resonator, held_parameters);
}

Status check_drift_paths(const DriftRequest& request) {
    std::vector<InputPath> inputs;
    for (const std::string& input : request.inputs) {
        inputs.push_back({input, "it is one of the logs"});
    }
    // Bins on standard output take the place of the summary.
    TRY(check_outputs({{"--json", request.json ? "-" : "", "the result goes there already"},
                       {"-o", request.output, ""}},
                      inputs));
    return request.output.empty() || request.output == "-"
               ? Status()
               : check_ending(request.output, {".csv", ".json"});
}

}  // namespace

Status run_drift(const DriftRequest& request, Log& log, std::stop_token stop) {
    TRY(check_drift_paths(request));
    // Before the work is done: a missing folder shows at once.
    auto output = TRY(open_named(request.output, silent_job(stop)));
    const std::vector<std::filesystem::path> logs(request.inputs.begin(), request.inputs.end());
    const auto found = TRY(drift_of_logs(logs, request.settings, job_of(stop, log)));
    log.warnings(found.drift.warnings);
    const bool whole = file_ending(request.output) == ".json";
    const std::string json = request.json || whole ? drift_json(program, found) : "";
    if (request.output != "-") {
        TRY(write_text(request.json ? json : drift_text(found.drift), silent_job(stop)));
    }
    if (output) {
        TRY(output->write(whole ? json : drift_csv(program, found)));
        TRY(output->commit());
    }
    return {};
}

}  // namespace vybeg::cli
