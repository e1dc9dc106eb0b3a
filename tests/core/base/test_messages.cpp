#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace test_messages {

using namespace vybeg;

namespace {

template <class Code>
std::vector<MessageRow> rows() {
    std::vector<MessageRow> all;
    for (int i = 0; *message_row(static_cast<Code>(i)).code != '\0'; ++i) {
        all.push_back(message_row(static_cast<Code>(i)));
    }
    return all;
}

std::vector<MessageRow> all_rows() {
    std::vector<MessageRow> all = rows<ErrorCode>();
    std::ranges::copy(rows<DiagnosticKind>(), std::back_inserter(all));
    return all;
}

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
    void every_code_has_a_row() {
        QCOMPARE(rows<ErrorCode>().size(), static_cast<std::size_t>(ErrorCode::interrupted) + 1);
        QCOMPARE(rows<DiagnosticKind>().size(),
                 static_cast<std::size_t>(DiagnosticKind::same_recordings) + 1);
    }

    void names_and_sentences_are_those_of_one_code() {
        std::set<std::string> names;
        std::set<std::string> texts;
        for (const MessageRow& row : all_rows()) {
            const std::string name = row.name();
            QVERIFY2(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos,
                     row.code);
            QVERIFY2(names.insert(name).second, row.code);
            QVERIFY2(texts.insert(row.sentence).second, row.sentence);
        }
    }

    // The first argument of an error is its place, which not every one has.
    void sentences_leave_out_no_argument() {
        const auto check = [](const std::vector<MessageRow>& all, std::size_t first) {
            for (const MessageRow& row : all) {
                const std::string printed = sentence_for(false, row.sentence);
                QVERIFY2(is_sentence(printed), row.sentence);
                std::set<std::size_t> used = places(printed);
                used.erase(first - 1);
                QVERIFY2(used == from_to(first, used.empty() ? 0 : *used.rbegin()), row.sentence);
            }
        };
        check(rows<ErrorCode>(), 2);
        check(rows<DiagnosticKind>(), 1);
    }

    void the_window_names_no_option_and_no_other_argument() {
        for (const MessageRow& row : all_rows()) {
            const std::string shown = sentence_for(true, row.sentence);
            QVERIFY2(is_sentence(shown), row.sentence);
            QVERIFY2(places(shown) == places(sentence_for(false, row.sentence)), row.sentence);
            QVERIFY2(shown.find("--") == std::string::npos, row.code);
            QVERIFY2(shown.find_first_of("{}") == std::string::npos, row.code);
        }
    }

    void exit_statuses_are_those_of_the_interface_data() {
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("status");
        const auto row = [](ErrorCode code, int status) {
            QTest::newRow(code_name(code).c_str()) << static_cast<int>(code) << status;
        };
        row(ErrorCode::setting_invalid, 2);
        row(ErrorCode::file_missing, 3);
        row(ErrorCode::file_changed, 3);
        row(ErrorCode::window_too_long, 4);
        row(ErrorCode::out_of_threads, 4);
        row(ErrorCode::program_fault, 4);
        row(ErrorCode::output_failed, 5);
        row(ErrorCode::output_incomplete, 5);
        row(ErrorCode::interrupted_partly, 130);
        row(ErrorCode::interrupted, 130);
    }

    // Groups of error_rows.h.
    void exit_statuses_are_those_of_the_interface() {
        QFETCH(int, code);
        QFETCH(int, status);
        QCOMPARE(exit_status(static_cast<ErrorCode>(code)), status);
    }

    void exit_statuses_rise_by_groups() {
        int before = 2;
        for (const MessageRow& row : rows<ErrorCode>()) {
            VYBEG_AT_LEAST(row.grade, before, row.code);
            before = row.grade;
        }
    }

    void a_sentence_of_two_readers_is_that_of_each() {
        const std::string both = "Choose {--filter|the band-pass}, or less{ (--from)}.";
        QCOMPARE(sentence_for(false, both), "Choose --filter, or less (--from).");
        QCOMPARE(sentence_for(true, both), "Choose the band-pass, or less.");
        QCOMPARE(sentence_for(true, "{ (--from)|.}"), ".");
        QCOMPARE(sentence_for(false, "one for both"), "one for both");
        QCOMPARE(sentence_for(true, "one { alone"), "one { alone");
    }

    void an_argument_reads_as_what_it_is() {
        QCOMPARE(english(MessageArg("D\n")), "D\\x0a");
        QCOMPARE(english(number_arg(0.25, 2, "Hz")), "0.25 Hz");
        QCOMPARE(english(unit_arg("Hz")), "Hz");
        QCOMPARE(english(count_arg(-3)), "-3");
        QCOMPARE(english(exact_arg(0.1)), "0.1");
        QCOMPARE(english(words("%1 (%2)", {words("more than %1", {count_arg(3)}), "%1"})),
                 "more than 3 (%1)");
        QVERIFY(stored_arg("-1.5e3").kind == MessageArg::Kind::number);
        QVERIFY(stored_arg("1.5 V").kind == MessageArg::Kind::text);
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
                 "run.csv, line 12, column 3: \"1,5\" is not a number. Correct it; a missing "
                 "sample, but no time, may be written as nan.");
    }

    void a_diagnostic_reads_as_a_sentence() {
        const Diagnostic diagnostic{.kind = DiagnosticKind::not_converged, .args = {"3", "1000"}};
        QCOMPARE(english(diagnostic), "3 of 1000 windows did not converge; they are flagged.");
    }
};

VYBEG_TEST(TestMessages)

}  // namespace test_messages

#include "test_messages.moc"
