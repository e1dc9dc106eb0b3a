#include "core/base/result.h"
#include "tests/test_registry.h"

#include <QTest>

#include <memory>
#include <string>

namespace test_result {

using vybeg::Error;
using vybeg::ErrorCode;
using vybeg::Result;
using vybeg::Status;

namespace {

const Error failure{
    .code = ErrorCode::file_read_failed, .where = "run-45.wav", .args = {"input/output error"}};

Result<std::string> text(bool good) {
    if (!good) {
        return failure;
    }
    return std::string("value");
}

}  // namespace

class TestResult : public QObject {
    Q_OBJECT

private slots:
    void a_result_holds_the_value_it_was_given() {
        const Result<std::string> result = text(true);
        QVERIFY(bool(result));
        QCOMPARE(*result, "value");
        QCOMPARE(result->size(), 5U);
    }

    void a_result_holds_the_whole_error_it_was_given() {
        const Result<std::string> result = text(false);
        QVERIFY(!result);
        QCOMPARE(result.error(), failure);
    }

    void a_value_can_be_changed_and_moved_out() {
        Result<std::unique_ptr<int>> result = std::make_unique<int>(3);
        **result = 4;
        const std::unique_ptr<int> taken = std::move(*result);
        QCOMPARE(*taken, 4);
    }

    void an_error_of_one_result_can_be_handed_on_as_another() {
        const auto hand_on = []() -> Result<int> {
            const auto result = text(false);
            return result ? Result<int>(1) : Result<int>(result.error());
        };
        QVERIFY(!hand_on());
        QCOMPARE(hand_on().error(), failure);
    }

    void a_status_is_success_until_it_is_given_an_error() {
        const Status good;
        QVERIFY(bool(good));
        const Status bad = failure;
        QVERIFY(!bad);
        QCOMPARE(bad.error(), failure);
    }

    void errors_are_equal_only_in_code_place_and_arguments() {
        QVERIFY(failure == Error(failure));
        for (const auto change : {+[](Error& e) { e.code = ErrorCode::file_empty; },
                                  +[](Error& e) { e.where = "other.wav"; },
                                  +[](Error& e) { e.args = {"disk full"}; }}) {
            Error other = failure;
            change(other);
            QVERIFY(!(failure == other));
        }
    }
};

VYBEG_TEST(TestResult)

}  // namespace test_result

#include "test_result.moc"
