// Which messages stay when there are more than the bar shows.
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/message_bar.h"
#include "ui/window/status_line.h"

#include <QPushButton>
#include <QToolButton>
#include <QtTest>

namespace test_message_bar {

using namespace vybeg;
using namespace vybeg::ui;

class TestMessageBar : public QObject {
    Q_OBJECT

    GuiTestHome home_;  // the settings of no other program

    static Message told(MessageLevel severity, const char* text) {
        return {severity, [text] { return QString(text); }, {}, {}};
    }

private slots:
    void the_oldest_go_and_questions_stay() {
        MessageBar bar;
        int pressed = 0;
        Message question = told(MessageLevel::warning, "recover?");
        question.button = [] { return QString("Recover"); };
        question.press = [&pressed] { ++pressed; };
        question.until_answered = true;
        bar.add(question);
        for (const char* text : {"first", "second", "third", "fourth"}) {
            bar.add(told(MessageLevel::warning, text));
        }
        QCOMPARE(bar.texts(), (QStringList{"fourth", "third", "recover?"}));
        childOf<QPushButton>(bar).click();
        QCOMPARE(pressed, 1);
        QCOMPARE(bar.texts(), (QStringList{"fourth", "third"}));
    }

    void a_message_that_is_closed_is_dismissed_and_not_pressed() {
        MessageBar bar;
        int pressed = 0;
        int dismissed = 0;
        Message question = told(MessageLevel::warning, "recover?");
        question.button = [] { return QString("Recover"); };
        question.press = [&pressed] { ++pressed; };
        question.dismiss = [&dismissed] { ++dismissed; };
        bar.add(question);
        childOf<QToolButton>(bar).click();
        QCOMPARE(dismissed, 1);
        bar.add(question);
        childOf<QPushButton>(bar).click();
        QCOMPARE(pressed, 1);
        QCOMPARE(dismissed, 1);
    }

    // What needs no answer stands in the status bar.
    void news_are_no_messages() {
        const auto window = shownWindow();
        window->document().report(told(MessageLevel::info, "written"));
        QCOMPARE(childOf<MessageBar>(*window).texts(), QStringList());
        QCOMPARE(childOf<StatusLine>(*window).text(), QString("written"));
        window->document().report(told(MessageLevel::warning, "odd"));
        QCOMPARE(childOf<MessageBar>(*window).texts(), QStringList{"odd"});
    }

    void a_newer_message_of_the_same_words_takes_the_place_of_the_older() {
        MessageBar bar;
        bar.add(told(MessageLevel::warning, "a"));
        bar.add(told(MessageLevel::warning, "b"));
        bar.add(told(MessageLevel::warning, "a"));
        QCOMPARE(bar.texts(), (QStringList{"a", "b"}));
    }
};

VYBEG_TEST(TestMessageBar)

}  // namespace test_message_bar

#include "test_message_bar.moc"
