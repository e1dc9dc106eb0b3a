// Names by what differs between them.
#include "tests/test_registry.h"
#include "ui/words/short_names.h"

#include <QtTest>

namespace test_short_names {

using namespace vybeg::ui;

class TestShortNames : public QObject {
    Q_OBJECT

private slots:
    void what_all_share_goes_and_what_differs_stays() {
        QCOMPARE(distinctNames({"demonstration, n = 6", "demonstration, n = 60"}),
                 (QStringList{"…6", "…60"}));
        QCOMPARE(distinctNames({"HRG-17_0, n = 60", "HRG-17_22.5, n = 60", "HRG-17_67.5, n = 60"}),
                 (QStringList{"…0…", "…22.5…", "…67.5…"}));
        QCOMPARE(distinctNames({"long_a.wav", "long_b.wav"}), (QStringList{"…a…", "…b…"}));
    }

    // Of a word or number that differs nothing is left out.
    void words_and_numbers_stay_whole() {
        QCOMPARE(distinctNames({"recording 1015", "recording 1025"}),
                 (QStringList{"…1015", "…1025"}));
        QCOMPARE(distinctNames({"temperature 21.5", "temperature 22.5"}),
                 (QStringList{"…21.5", "…22.5"}));
        QCOMPARE(distinctNames({"spring", "sprung"}), (QStringList{"spring", "sprung"}));
    }

    void recordings_have_no_endings_where_nothing_differs_with_them() {
        QCOMPARE(recordingNames({"HRG-17_0.wav", "HRG-17_22.5.wav"}), (QStringList{"…0", "…22.5"}));
        QCOMPARE(recordingNames({"one.wav"}), QStringList{"one"});
        QCOMPARE(recordingNames({"a.wav", "a.csv"}), (QStringList{"a.wav", "a.csv"}));
    }

    void a_set_is_called_by_what_its_names_begin_with() {
        QCOMPARE(commonName({"HRG-17_0.wav", "HRG-17_22.5.wav"}), QStringLiteral("HRG-17"));
        QCOMPARE(commonName({"run-0.wav", "run-67.wav"}), QStringLiteral("run"));
        for (const QStringList& names : {QStringList{"a1.wav", "a2.wav"}, QStringList{},
                                         QStringList{"spring.wav", "sprung.wav"}}) {
            QCOMPARE(commonName(names), QString());
        }
    }

    void names_that_share_little_stay() {
        for (const QStringList& names :
             {QStringList{"a.wav"}, QStringList{}, QStringList{"a1", "a2"},
              QStringList{"demo", "demo (2)"}, QStringList{"x", "x"}}) {
            QCOMPARE(distinctNames(names), names);
        }
    }
};

VYBEG_TEST(TestShortNames)

}  // namespace test_short_names

#include "test_short_names.moc"
