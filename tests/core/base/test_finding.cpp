#include "core/base/diagnostic.h"
#include "tests/test_registry.h"

#include <QTest>

#include <vector>

namespace test_finding {

using namespace vybeg;

namespace {

Diagnostic gap(std::int64_t first, std::int64_t count) {
    return {DiagnosticKind::time_gap,
            {count_arg(count), number_arg(1e-3 * static_cast<double>(first))},
            first,
            count};
}

const Diagnostic note{DiagnosticKind::text_lines_ignored, {count_arg(3)}};
const Diagnostic serious{DiagnosticKind::fit_not_converged, {}};

}  // namespace

class TestFinding : public QObject {
    Q_OBJECT

private slots:
    void the_worst_come_first_and_each_kind_once() {
        const std::vector<NamedWarnings> all{
            {"a.wav", {note, gap(100, 2), gap(200, 3)}}, {"b.wav", {gap(100, 2)}}, {"", {serious}}};
        const std::vector<Finding> findings = findings_of(all);
        QCOMPARE(findings.size(), std::size_t(3));
        QCOMPARE(findings[0].diagnostic, serious);
        QCOMPARE(findings[1].diagnostic, gap(100, 2));
        QCOMPARE(findings[2].diagnostic, note);
        QCOMPARE(findings[1].count, std::int64_t(3));
        QCOMPARE(findings[1].frames, std::int64_t(7));
        QCOMPARE(findings[1].about, (std::vector<std::string>{"a.wav", "b.wav"}));
        QCOMPARE(findings[1].more, std::vector{gap(200, 3)});  // that of b.wav is the same
        QCOMPARE(count_warnings(findings), std::size_t(2));
        QCOMPARE(warning_kinds(findings), std::string("fit-not-converged;time-gap"));
    }

    void of_one_severity_the_order_stays() {
        const std::vector<Diagnostic> given{gap(1, 1), {DiagnosticKind::mains, {}}};
        const std::vector<Finding> findings = findings_of(given);
        QCOMPARE(findings[0].diagnostic.kind, DiagnosticKind::time_gap);
        QCOMPARE(findings[1].diagnostic.kind, DiagnosticKind::mains);
    }

    void the_text_counts_the_other_places() {
        const std::vector<Finding> gaps =
            findings_of(std::vector{gap(100, 2), gap(200, 3), gap(300, 4)});
        QCOMPARE(english(gaps[0]), std::string("2 samples are missing at 0.1 s; windows over them "
                                               "are flagged. (And 2 more places; 9 samples in "
                                               "all.)"));
        const std::vector<Finding> two = findings_of(std::vector{gap(100, 2), gap(200, 3)});
        QVERIFY(english(two[0]).ends_with("(And 1 more place; 5 samples in all.)"));
        const std::vector<Finding> options = findings_of(
            std::vector<Diagnostic>{{DiagnosticKind::option_without_effect, {"--hop", "a"}},
                                    {DiagnosticKind::option_without_effect, {"--snap", "b"}}});
        QCOMPARE(english(options[0]),
                 std::string("--hop has no effect: a. (And 1 more of the kind.)"));
    }

    void many_recordings_are_counted() {
        std::vector<NamedWarnings> all;
        for (const char* name : {"a", "b", "c", "d", "e"}) {
            all.emplace_back(name, std::vector{serious});
        }
        const Finding finding = findings_of(all).front();
        QCOMPARE(about_text(finding), std::string("a, b, c, +2"));
        QVERIFY(finding.more.empty());
        QCOMPARE(english(finding), "a, b, c, +2: " + english(serious));
    }
};

VYBEG_TEST(TestFinding)

}  // namespace test_finding

#include "test_finding.moc"
