#include "core/base/messages.h"

#include <QTest>

#include <cctype>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace vybeg;

namespace {

struct Documented {
    std::size_t args;  // as the comments in error.h count them
    int status;        // as INTERFACE and the groups in error.h have it
};

// One line for each code: a new code is added here, or the first test fails.
const std::map<ErrorCode, Documented> documented{
    {ErrorCode::setting_invalid, {3, 2}},
    {ErrorCode::file_missing, {0, 3}},
    {ErrorCode::file_permission, {0, 3}},
    {ErrorCode::file_is_directory, {0, 3}},
    {ErrorCode::file_empty, {0, 3}},
    {ErrorCode::file_read_failed, {1, 3}},
    {ErrorCode::format_unknown, {0, 3}},
    {ErrorCode::format_damaged, {2, 3}},
    {ErrorCode::format_unsupported, {2, 3}},
    {ErrorCode::text_not_a_number, {3, 3}},
    {ErrorCode::text_no_data, {0, 3}},
    {ErrorCode::text_time_backwards, {3, 3}},
    {ErrorCode::text_no_table, {3, 3}},
    {ErrorCode::text_lines_missing, {2, 3}},
    {ErrorCode::column_out_of_range, {2, 3}},
    {ErrorCode::too_few_channels, {2, 3}},
    {ErrorCode::channel_out_of_range, {2, 3}},
    {ErrorCode::too_few_frames, {2, 3}},
    {ErrorCode::rate_unknown, {0, 3}},
    {ErrorCode::passport_damaged, {1, 3}},
    {ErrorCode::passport_schema, {2, 3}},
    {ErrorCode::variable_missing, {2, 3}},
    {ErrorCode::file_changed, {0, 3}},
    {ErrorCode::window_too_long, {2, 4}},
    {ErrorCode::window_too_short, {2, 4}},
    {ErrorCode::range_empty, {3, 4}},
    {ErrorCode::carrier_above_half_rate, {2, 4}},
    {ErrorCode::carrier_not_found, {0, 4}},
    {ErrorCode::carrier_not_near, {2, 4}},
    {ErrorCode::band_invalid, {3, 4}},
    {ErrorCode::filter_too_long, {2, 4}},
    {ErrorCode::no_valid_samples, {0, 4}},
    {ErrorCode::every_window_clipped, {1, 4}},
    {ErrorCode::simulation_impossible, {1, 4}},
    {ErrorCode::fit_window_too_short, {2, 4}},
    {ErrorCode::fit_window_turns, {4, 4}},
    {ErrorCode::fit_beat_too_fast, {3, 4}},
    {ErrorCode::fit_too_few_windows, {2, 4}},
    {ErrorCode::fit_failed, {1, 4}},
    {ErrorCode::same_recording, {1, 4}},
    {ErrorCode::band_too_narrow, {3, 4}},
    {ErrorCode::channel_without_samples, {1, 4}},
    {ErrorCode::out_of_memory, {0, 4}},
    {ErrorCode::out_of_threads, {0, 4}},
    {ErrorCode::output_failed, {1, 5}},
    {ErrorCode::output_format_unknown, {1, 5}},
    {ErrorCode::output_is_recording, {0, 5}},
    {ErrorCode::output_incomplete, {1, 5}},
    {ErrorCode::interrupted_partly, {0, 130}},
    {ErrorCode::interrupted, {0, 130}},
};

// Arguments of each kind, as diagnostic.h counts them.
const std::map<DiagnosticKind, std::size_t> documented_kinds{
    {DiagnosticKind::time_uneven, 2},
    {DiagnosticKind::time_gap, 2},
    {DiagnosticKind::missing_samples, 1},
    {DiagnosticKind::file_ends_early, 2},
    {DiagnosticKind::file_not_closed, 1},
    {DiagnosticKind::channels_unequal, 4},
    {DiagnosticKind::filter_transients, 1},
    {DiagnosticKind::context_missing, 1},
    {DiagnosticKind::not_converged, 2},
    {DiagnosticKind::over_range, 2},
    {DiagnosticKind::unit_converted, 3},
    {DiagnosticKind::units_differ, 4},
    {DiagnosticKind::time_unit_unknown, 1},
    {DiagnosticKind::rates_disagree, 2},
    {DiagnosticKind::leakage, 2},
    {DiagnosticKind::wave_moves, 2},
    {DiagnosticKind::text_lines_ignored, 1},
    {DiagnosticKind::clipped, 3},
    {DiagnosticKind::samples_lost, 2},
    {DiagnosticKind::samples_doubled, 2},
    {DiagnosticKind::phase_step, 4},
    {DiagnosticKind::more_samples_lost, 1},
    {DiagnosticKind::below_one_bit, 2},
    {DiagnosticKind::offset, 3},
    {DiagnosticKind::mains, 2},
    {DiagnosticKind::start_transient, 1},
    {DiagnosticKind::gaps_inserted, 2},
    {DiagnosticKind::lost_counted, 2},
    {DiagnosticKind::phase_unknown, 1},
    {DiagnosticKind::carrier_elsewhere, 2},
    {DiagnosticKind::strike_left_out, 1},
    {DiagnosticKind::frequency_drifts, 3},
    {DiagnosticKind::frequency_follows_amplitude, 2},
    {DiagnosticKind::q_disagrees, 3},
    {DiagnosticKind::decay_of_one_direction, 0},
    {DiagnosticKind::structured_refused, 1},
    {DiagnosticKind::residual_above_noise, 1},
    {DiagnosticKind::residual_below_noise, 1},
    {DiagnosticKind::residual_coloured, 1},
    {DiagnosticKind::noise_too_narrow, 1},
    {DiagnosticKind::misfit_damping, 1},
    {DiagnosticKind::misfit_settling, 2},
    {DiagnosticKind::misfit_neighbour, 2},
    {DiagnosticKind::misfit_channel, 2},
    {DiagnosticKind::misfit_pickoff, 2},
    {DiagnosticKind::fitted_phase_step, 3},
    {DiagnosticKind::fit_not_converged, 0},
    {DiagnosticKind::option_without_effect, 2},
};

// The n of every %n in a template.
std::set<std::size_t> places(const std::string& text) {
    std::set<std::size_t> found;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] == '%' && std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0) {
            found.insert(static_cast<std::size_t>(text[i + 1] - '0'));
        }
    }
    return found;
}

std::set<std::size_t> from_to(std::size_t first, std::size_t last) {
    std::set<std::size_t> numbers;
    for (std::size_t n = first; n <= last; ++n) {
        numbers.insert(n);
    }
    return numbers;
}

bool is_sentence(const std::string& text) {
    const bool begins = std::isupper(static_cast<unsigned char>(text[0])) != 0 || text[0] == '%';
    return text.size() > 10 && begins && text.back() == '.';
}

}  // namespace

class TestMessages : public QObject {
    Q_OBJECT

private slots:
    void every_error_code_is_documented_here() {
        for (int i = 0; i <= static_cast<int>(ErrorCode::interrupted); ++i) {
            QVERIFY2(documented.contains(static_cast<ErrorCode>(i)),
                     qPrintable(QString::number(i)));
        }
        QCOMPARE(documented.size(), static_cast<std::size_t>(ErrorCode::interrupted) + 1);
    }

    void every_error_has_a_sentence_that_uses_all_of_its_arguments_and_no_other() {
        for (const auto& [code, facts] : documented) {
            const std::string text = message_template(code);
            QVERIFY2(is_sentence(text), text.c_str());
            std::set<std::size_t> used = places(text);
            used.erase(1);  // where: not every error has a place
            QVERIFY2(used == from_to(2, facts.args + 1), text.c_str());
        }
    }

    void no_two_errors_have_the_same_sentence() {
        std::set<std::string> texts;
        for (const auto& [code, facts] : documented) {
            texts.insert(message_template(code));
        }
        QCOMPARE(texts.size(), documented.size());
    }

    void exit_statuses_are_those_of_the_interface() {
        for (const auto& [code, facts] : documented) {
            QVERIFY2(exit_status(code) == facts.status, message_template(code));
        }
    }

    void every_diagnostic_has_a_name_and_a_sentence_with_its_arguments() {
        std::set<std::string> names;
        for (int i = 0; i < static_cast<int>(documented_kinds.size()); ++i) {
            const auto kind = static_cast<DiagnosticKind>(i);
            QVERIFY2(documented_kinds.contains(kind), qPrintable(QString::number(i)));
            const std::string text = message_template(kind);
            QVERIFY2(is_sentence(text), text.c_str());
            QVERIFY2(places(text) == from_to(1, documented_kinds.at(kind)), text.c_str());

            const std::string name = kind_name(kind);
            QVERIFY2(!name.empty(), text.c_str());
            QVERIFY2(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos,
                     name.c_str());
            names.insert(name);
        }
        QCOMPARE(names.size(), documented_kinds.size());
        // The kind after the last one documented here does not exist.
        QCOMPARE(message_template(static_cast<DiagnosticKind>(documented_kinds.size())), "");
    }

    void a_template_is_filled_once_and_in_any_order() {
        QCOMPARE(fill_template("%2 after %1, %1", {"a", "b"}), "b after a, a");
        // What an argument says is not filled again: it may be a file's name.
        QCOMPARE(fill_template("%1 and %2", {"%2", "50%1"}), "%2 and 50%1");
    }

    void a_number_without_an_argument_stays_as_it_is() {
        QCOMPARE(fill_template("%1 %2 %9", {"a"}), "a %2 %9");
        QCOMPARE(fill_template("100% %0 %% %x %", {"a"}), "100% %0 %% %x %");
        QCOMPARE(fill_template("", {"a"}), "");
    }

    void an_error_reads_as_where_why_and_what_to_do() {
        const Error error{
            .code = ErrorCode::text_not_a_number, .where = "run.csv", .args = {"12", "3", "1,5"}};
        QCOMPARE(english(error),
                 "run.csv, line 12, column 3: \"1,5\" is not a number. Correct it, or write nan "
                 "for a missing sample.");
    }

    void a_diagnostic_reads_as_a_sentence() {
        const Diagnostic diagnostic{.kind = DiagnosticKind::not_converged, .args = {"3", "1000"}};
        QCOMPARE(english(diagnostic), "3 of 1000 windows did not converge; they are flagged.");
    }
};

QTEST_GUILESS_MAIN(TestMessages)
#include "test_messages.moc"
