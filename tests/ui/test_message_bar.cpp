// Which messages stay when there are more than the bar shows.
#include "tests/ui/gui_test.h"
#include "ui/panels/message_bar.h"

#include <QPushButton>
#include <QtTest>

using namespace vybeg;
using namespace vybeg::ui;

class TestMessageBar : public QObject {
    Q_OBJECT

    static Message told(Severity severity, const char* text) {
        return {severity, [text] { return QString(text); }, {}, {}};
    }

private slots:
    void news_go_before_warnings_and_questions_stay() {
        MessageBar bar;
        int pressed = 0;
        Message question = told(Severity::warning, "recover?");
        question.button = [] { return QString("Recover"); };
        question.press = [&pressed] { ++pressed; };
        question.until_answered = true;
        bar.add(question);
        bar.add(told(Severity::warning, "first"));
        bar.add(told(Severity::info, "written"));
        bar.add(told(Severity::warning, "second"));
        QCOMPARE(bar.texts(), (QStringList{"second", "first", "recover?"}));
        bar.add(told(Severity::error, "third"));
        bar.add(told(Severity::info, "newest"));
        QCOMPARE(bar.texts(), (QStringList{"newest", "third", "recover?"}));
        childOf<QPushButton>(bar).click();
        QCOMPARE(pressed, 1);
        QCOMPARE(bar.texts(), (QStringList{"newest", "third"}));
    }

    void a_newer_message_of_the_same_words_takes_the_place_of_the_older() {
        MessageBar bar;
        bar.add(told(Severity::warning, "a"));
        bar.add(told(Severity::warning, "b"));
        bar.add(told(Severity::warning, "a"));
        QCOMPARE(bar.texts(), (QStringList{"a", "b"}));
    }
};

QTEST_MAIN(TestMessageBar)
#include "test_message_bar.moc"
