// Which messages stay when there are more than the bar shows.
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/message_bar.h"
#include "ui/window/page_stack.h"
#include "ui/window/status_line.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QStatusBar>
#include <QToolButton>
#include <QtTest>

namespace test_message_bar {

using namespace vybeg;
using namespace vybeg::ui;

class TestMessageBar : public QObject {
    Q_OBJECT

    GuiTestHome home_;  // the settings of no other program

    static Message told(MessageLevel severity, const char* text) {
        return {severity, [text] { return QString(text); }};
    }

    // Newest first, without those that wait.
    static QStringList shown(const MessageBar& bar) {
        QStringList texts;
        for (const QString& text : bar.texts()) {
            const auto widgets = bar.findChildren<QFrame*>();
            const bool is_shown = std::ranges::any_of(widgets, [&text](const QFrame* row) {
                return row->accessibleName() == text && !row->isHidden();
            });
            texts << (is_shown ? QStringList(text) : QStringList());
        }
        return texts;
    }

    // Whole messages, or one line again.
    static void press(const MessageBar& bar) { childOf<QToolButton>(bar, "openMessages").click(); }

    // That of the newest message.
    static void closeNewest(const MessageBar& bar) {
        const QString text = bar.texts().first();
        for (auto* close : bar.findChildren<QToolButton*>()) {
            if (close->parentWidget()->accessibleName() == text) {
                close->click();
                return;
            }
        }
    }

private slots:
    void the_oldest_wait_and_questions_stay() {
        MessageBar bar;
        int pressed = 0;
        Message question = told(MessageLevel::warning, "recover?");
        question.buttons = {{[] { return QString("Recover"); }, [&pressed] { ++pressed; }}};
        question.until_answered = true;
        bar.add(question);
        for (const char* text : {"first", "second", "third", "fourth"}) {
            bar.add(told(MessageLevel::warning, text));
        }
        QCOMPARE(shown(bar), QStringList{"fourth"});
        press(bar);
        QCOMPARE(shown(bar), (QStringList{"fourth", "third", "recover?"}));
        childOf<QPushButton>(bar).click();
        QCOMPARE(pressed, 1);
        QCOMPARE(shown(bar), (QStringList{"fourth", "third", "second"}));
        press(bar);
        QCOMPARE(shown(bar), QStringList{"fourth"});
    }

    // Seven files fail: what is behind the three is counted, and comes as others are closed.
    void failures_wait_and_come_as_others_are_closed() {
        MessageBar bar;
        bar.resize(600, 60);
        bar.show();
        const auto& more = childOf<QWidget>(bar, "moreMessages");
        for (const char* text : {"1", "2", "3", "4", "5", "6", "7"}) {
            bar.add(told(MessageLevel::error, text));
        }
        QCOMPARE(shown(bar), QStringList{"7"});
        QVERIFY(childOf<QToolButton>(bar, "openMessages").text().startsWith("6 more"));
        press(bar);
        QCOMPARE(shown(bar), (QStringList{"7", "6", "5"}));
        QVERIFY(more.isVisible());
        QVERIFY(childOf<QLabel>(more).text().startsWith("4 more"));
        // Warnings of later files hide no error but by the newest of them.
        bar.add(told(MessageLevel::warning, "odd"));
        bar.add(told(MessageLevel::warning, "odder"));
        QCOMPARE(shown(bar), (QStringList{"odder", "7", "6"}));
        QStringList seen;
        while (!bar.texts().isEmpty()) {
            QVERIFY(bar.isVisible());
            seen << bar.texts().first();
            closeNewest(bar);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        }
        QCOMPARE(seen.size(), 9);
        QVERIFY(!bar.isVisible() && !more.isVisible());
    }

    void all_are_closed_at_once_but_questions() {
        MessageBar bar;
        bar.show();
        Message question = told(MessageLevel::warning, "recover?");
        question.until_answered = true;
        bar.add(question);
        for (const char* text : {"1", "2", "3", "4"}) {
            bar.add(told(MessageLevel::error, text));
        }
        press(bar);
        QCOMPARE(shown(bar), (QStringList{"4", "3", "recover?"}));
        childOf<QToolButton>(bar, "closeMessages").click();
        QCOMPARE(bar.texts(), QStringList{"recover?"});
    }

    void a_message_that_is_closed_is_not_pressed() {
        MessageBar bar;
        bar.show();
        std::vector<int> pressed(2);
        Message message = told(MessageLevel::warning, "gone");
        for (int& count : pressed) {
            message.buttons.emplace_back([] { return QString("Find"); }, [&count] { ++count; });
        }
        bar.add(message);
        closeNewest(bar);
        QCOMPARE(pressed, (std::vector{0, 0}));
        bar.add(message);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        const auto buttons = bar.findChildren<QPushButton*>();
        QCOMPARE(buttons.size(), 2);
        buttons.at(1)->click();
        QCOMPARE(pressed, (std::vector{0, 1}));
        QVERIFY(bar.texts().isEmpty());
    }

    // A question is not closed by mistake: its buttons are its answers.
    void a_question_has_no_button_that_closes_it() {
        MessageBar bar;
        bar.show();
        Message question = told(MessageLevel::warning, "recover?");
        question.until_answered = true;
        bar.add(question);
        QVERIFY(std::ranges::none_of(bar.findChildren<QToolButton*>(), &QToolButton::isVisible));
    }

    // It has the place of the status line, and its rest comes over the window at a click.
    void a_message_moves_nothing_and_hides_no_row() {
        const auto window = shownWindow();
        window->document().open({home_.recording("rows.wav")});
        QTRY_VERIFY_WITH_TIMEOUT(!window->document().busy() && window->statusBar()->isVisible() &&
                                     window->document().analyses().size() == 1,
                                 20000);
        const auto& bar = childOf<MessageBar>(*window);
        const auto& pages = childOf<PageStack>(*window);
        const QRect place = pages.geometry();
        const QRect line = window->statusBar()->geometry();
        const QByteArray sentence = QByteArray("A long sentence of many words. ").repeated(20);
        for (const char* text : {"odd", "odder", sentence.constData()}) {
            Message message = told(MessageLevel::warning, text);
            message.buttons = {{[] { return QString("Find"); }, [] {}}};
            window->document().report(message);
            QTRY_VERIFY(bar.isVisible());
            QTRY_COMPARE(bar.geometry(), line);
            QCOMPARE(pages.geometry(), place);
        }
        press(bar);
        QTRY_VERIFY(bar.height() > 3 * line.height());
        QCOMPARE(bar.geometry().bottom(), line.bottom());
        QCOMPARE(bar.height(), bar.heightForWidth(bar.width()));
        QCOMPARE(pages.geometry(), place);
        press(bar);
        QTRY_COMPARE(bar.geometry(), line);
    }

    // The button is there where it shows more.
    void a_message_that_fits_its_line_has_no_more() {
        const auto window = shownWindow();
        const auto& more = childOf<QToolButton>(*window, "openMessages");
        window->document().report(told(MessageLevel::warning, "odd"));
        QVERIFY(!more.isVisible());
        const QByteArray sentence = QByteArray("A long sentence of many words. ").repeated(20);
        window->document().report(told(MessageLevel::error, sentence.constData()));
        QVERIFY(more.isVisible());
        QCOMPARE(more.text(), QString("More"));
        closeNewest(childOf<MessageBar>(*window));
        QVERIFY(!more.isVisible());
    }

    // A page that owns the window has the line as long as there are messages.
    void messages_have_their_line_on_every_page() {
        const auto window = shownWindow();
        const auto& bar = childOf<MessageBar>(*window);
        for (const Page page : {Page::resonator, Page::drift, Page::history}) {
            window->document().report(told(MessageLevel::warning, "odd"));
            childOf<PageStack>(*window).showPage(page);
            QVERIFY(window->statusBar()->isVisible());
            QTRY_COMPARE(bar.geometry(), window->statusBar()->geometry());
            closeNewest(bar);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QVERIFY(!window->statusBar()->isVisible());
        }
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
