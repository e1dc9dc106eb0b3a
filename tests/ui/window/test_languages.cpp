// Every text of the window in the interface's language, and the translation complete.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/import/import_dialog.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"
#include "ui/window/page_stack.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QProcess>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>
#include <QTextDocumentFragment>
#include <QTreeWidget>
#include <QXmlStreamReader>

#include <set>

namespace test_languages {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

// What stands in Latin letters in every language: names, endings of files, keys, notation.
const std::set<QString> anyLanguage{
    "Vybeg", "English", "Qt",        "QCustomPlot", "GNU",   "General", "Public", "License",
    "WAV",   "FLAC",    "CSV",       "PNG",         "SVG",   "PDF",     "NPZ",    "MAT",
    "HDF",   "SHA",     "NaN",       "nan",         "rms",   "demo",    "wav",    "Home",
    "Ctrl",  "Shift",   "Alt",       "Del",         "Space", "png",     "csv",    "bits",
    "cos",   "sin",     "opt",       "Return",      "json",  "ppm",     "Delete", "Insert",
    "JSON",  "theta",   "amplitude", "quadrature"};

// All texts that a widget shows or tells a screen reader.
QStringList textsOf(const QWidget& widget) {
    QStringList texts{widget.toolTip(), widget.accessibleName()};
    if (widget.isWindow()) {
        texts << widget.windowTitle();
    }
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        texts << label->text();
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        texts << button->text();
    } else if (const auto* edit = qobject_cast<const QLineEdit*>(&widget)) {
        texts << edit->text() << edit->placeholderText() << widget.property("unit").toString();
    } else if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) {
        texts << box->title();
    } else if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        texts << menu->title();
    } else if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
        for (int i = 0; i < combo->count(); ++i) {
            texts << combo->itemText(i) << combo->itemData(i, Qt::ToolTipRole).toString();
        }
    } else if (const auto* tabs = qobject_cast<const QTabWidget*>(&widget)) {
        for (int i = 0; i < tabs->count(); ++i) {
            texts << tabs->tabText(i);
        }
    } else if (const auto* tree = qobject_cast<const QTreeWidget*>(&widget)) {
        for (int column = 0; column < tree->columnCount(); ++column) {
            texts << tree->headerItem()->text(column) << tree->headerItem()->toolTip(column);
            for (int row = 0; row < tree->topLevelItemCount(); ++row) {
                texts << tree->topLevelItem(row)->text(column);
            }
        }
    } else if (const auto* table = qobject_cast<const QTableWidget*>(&widget)) {
        for (int row = 0; row < table->rowCount(); ++row) {
            for (int column = 0; column < table->columnCount(); ++column) {
                if (const QTableWidgetItem* item = table->item(row, column)) {
                    texts << item->text() << item->toolTip();
                }
            }
        }
    }
    for (const QAction* action : widget.actions()) {
        texts << action->text() << action->toolTip();
    }
    return texts;
}

QStringList foreignTexts(const QRegularExpression& foreign) {
    QStringList found;
    for (const QWidget* widget : QApplication::allWidgets()) {
        // Qt's own, never seen: two tabs need no scrolling.
        if (widget->objectName().startsWith("Scroll") && !widget->isVisible()) {
            continue;
        }
        for (QString text : textsOf(*widget)) {
            if (Qt::mightBeRichText(text)) {
                text = QTextDocumentFragment::fromHtml(text).toPlainText();
            }
            text.remove(QLatin1Char('&'));
            text.remove(QChar(0x200b));
            // Paths, hashes and names of options.
            text.remove(QRegularExpression("/\\S+|[0-9a-f]{64}|--[a-z-]+"));
            for (auto match = foreign.globalMatch(text); match.hasNext();) {
                const QString word = match.next().captured();
                if (!anyLanguage.contains(word) && word != QStringLiteral("Русский")) {
                    found << QStringLiteral("%1 in \"%2\" of %3")
                                 .arg(word, text, widget->metaObject()->className());
                }
            }
        }
    }
    found.removeDuplicates();
    return found;
}

// The texts of a translation that have plural forms, with their contexts.
QStringList pluralsOf(const QString& translation) {
    QFile file(QStringLiteral(VYBEG_SOURCE_DIR "/translations/") + translation);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QXmlStreamReader xml(&file);
    QStringList found;
    QString context;
    bool plural = false;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.isStartElement() && xml.name() == QLatin1String("message")) {
            plural = xml.attributes().hasAttribute("numerus");
        } else if (xml.isStartElement() && xml.name() == QLatin1String("source") && plural) {
            found << context + ": " + xml.readElementText();
        }
    }
    found.sort();
    return found;
}

}  // namespace

class TestLanguages : public QObject {
    Q_OBJECT

    GuiTestHome home_;

private slots:
    void no_word_of_the_other_language_is_left_after_switching() {
        TestWindow window;
        window.setLanguage("en");
        window.show();
        window.document().open({home_.recording("demo.wav"), home_.file("demo.csv", "")});
        QVERIFY(QTest::qWaitFor(
            [&] { return !window.document().busy() && window.document().analyses().size() == 1; },
            20000));
        window.action(Command::identify)->trigger();
        QVERIFY(QTest::qWaitFor(
            [&] {
                const RecordingSet* set = window.document().sets().current();
                return set && window.document().sets().outcome(*set);
            },
            20000));
        window.files().savePassportTo(home_.path("demo.json"));
        QVERIFY(QTest::qWaitFor([&] { return QFile::exists(home_.path("demo.json")); }));
        window.document().passport().open(home_.path("demo.json"));
        QVERIFY(QTest::qWaitFor([&] { return window.document().passport().content() != nullptr; }));
        // Both with every choice on the screen: text here, raw samples in the other.
        const QString table = home_.file("demo-2.csv", "t;C;D\n0,1;1;2\n0,2;3;4\n0,3;5;6\n");
        BackgroundJobs job;
        const OpenOptions as_text{.text = TextChoice{}};
        const OpenOptions as_raw{.raw = RawLayout{}};
        // A dialog has the language of its opening: it keeps the menu out of reach.
        QPointer<ImportDialog> text_import;
        const auto open_imports = [&] {
            delete text_import;
            text_import = new ImportDialog(job, table, as_text, &window);
            text_import->show();
            emit window.document().importWanted(home_.path("demo.wav"), as_raw);
            const QList<ImportDialog*> imports = window.findChildren<ImportDialog*>();
            QCOMPARE(imports.size(), 2);
            for (const ImportDialog* dialog : imports) {
                QTRY_VERIFY(!childOf<QLabel>(*dialog, "what").text().isEmpty());
            }
        };
        window.action(Command::about)->trigger();
        window.action(Command::help)->trigger();
        // So does "About": close it before switching.
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (widget->windowTitle() == QLatin1String("About Vybeg")) {
                widget->close();
            }
        }

        window.setLanguage("ru");
        open_imports();
        window.action(Command::about)->trigger();
        QTRY_COMPARE(foreignTexts(QRegularExpression("[A-Za-z]{3,}")).join('\n'), QString());
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (widget->windowTitle() == QStringLiteral("О программе Vybeg")) {
                widget->close();
            }
        }

        window.setLanguage("en");
        open_imports();
        QTRY_COMPARE(foreignTexts(QRegularExpression("[А-Яа-яЁё]+")), QStringList());
    }

    // "5e+05" is how programs write a number: a power of ten is "·10⁵".
    void no_number_has_an_exponent_of_programs() {
        TestWindow window;
        window.setLanguage("en");
        window.show();
        Document& document = window.document();
        FreeDecay decay;
        decay.rate_hz = 50000;
        decay.seconds = 4;
        const QStringList files{home_.recording("long.wav", decay),
                                home_.recording("short.wav", decay)};
        document.open(files);
        const auto idle = [&] { return QTest::qWaitFor([&] { return !document.busy(); }, 60000); };
        QVERIFY(QTest::qWaitFor([&] { return document.analyses().size() == 2; }, 20000) && idle());
        window.action(Command::identify)->trigger();
        QVERIFY(idle());
        Settings settings = document.settings();
        settings.window = 155555;
        settings.hop = 1'000'000;
        settings.calibration.kappa = 1.00000012;
        settings.calibration.delay_d_s = 1e-11;
        document.setSettings(settings);
        Tolerance tolerance;
        tolerance[crosstalk_error] = tolerance[gain_drift_error] = 1e-5;
        tolerance[kappa_error] = 3e-7;
        document.setTolerance(tolerance);
        QVERIFY(idle());
        for (const char* language : {"en", "ru"}) {
            window.setLanguage(language);
            for (int page = 0; page <= static_cast<int>(Page::history); ++page) {
                childOf<PageStack>(window).showPage(static_cast<Page>(page));
                QTRY_COMPARE(foreignTexts(QRegularExpression("[0-9][eE][+-]?[0-9]+")),
                             QStringList());
            }
        }
    }

    void a_letter_opens_one_entry_of_a_menu_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("first");
        QTest::newRow("English") << "en"
                                 << "&File";
        QTest::newRow("Russian") << "ru"
                                 << "&Файл";
    }
    void a_letter_opens_one_entry_of_a_menu() {
        QFETCH(QString, language);
        QFETCH(QString, first);
        TestWindow window;
        window.setLanguage(language);
        QVERIFY(QTest::qWaitFor(
            [&] { return childOf<QMenuBar>(window).actions().first()->text() == first; }));
        QList<const QWidget*> menus{&childOf<QMenuBar>(window)};
        for (const QMenu* menu : childOf<QMenuBar>(window).findChildren<QMenu*>()) {
            menus << menu;
        }
        VYBEG_MORE(menus.size(), 10);
        static const QRegularExpression mnemonic("(?<!&)&([^&])");
        static const QRegularExpression typed("[A-Za-zА-Яа-яЁё0-9]");
        QStringList wrong;
        for (const QWidget* menu : menus) {
            QMap<QString, QString> taken;
            for (const QAction* entry : menu->actions()) {
                const auto found = mnemonic.match(entry->text());
                const QString letter = found.captured(1).toLower();
                if (found.hasMatch() &&
                    (taken.contains(letter) || !typed.match(letter).hasMatch())) {
                    wrong << QStringLiteral("%1: %2 %3").arg(letter, taken[letter], entry->text());
                }
                taken[letter] = entry->text();
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void what_has_plural_forms_has_them_in_both_languages() {
        VYBEG_MORE(pluralsOf("vybeg_ru.ts").size(), 5);
        QCOMPARE(pluralsOf("vybeg_en.ts"), pluralsOf("vybeg_ru.ts"));
    }

    void the_translation_has_every_text_of_the_source_and_keeps_its_places() {
        // lupdate on a copy finds what the sources have and the translation has not.
        const QString copy = home_.path("vybeg_ru.ts");
        QVERIFY(QFile::copy(VYBEG_SOURCE_DIR "/translations/vybeg_ru.ts", copy));
        QProcess lupdate;
        lupdate.setWorkingDirectory(VYBEG_SOURCE_DIR);
        lupdate.start(VYBEG_LUPDATE, {"-silent", "-I", ".", "-locations", "none", "-no-obsolete",
                                      "-tr-function-alias", "QT_TRANSLATE_NOOP+=VYBEG_MESSAGE",
                                      "-tr-function-alias", "Q_DECLARE_TR_FUNCTIONS+=VYBEG_CONTEXT",
                                      "ui", "app", "core", "-ts", copy});
        QVERIFY(lupdate.waitForFinished(60000));
        QCOMPARE(lupdate.exitCode(), 0);

        QFile file(copy);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&file);
        static const QRegularExpression place("%[1-9n]");
        QString source;
        QStringList wrong;
        int messages = 0;
        while (!xml.atEnd()) {
            xml.readNext();
            if (!xml.isStartElement()) {
                continue;
            }
            if (xml.name() == QLatin1String("source")) {
                source = xml.readElementText();
                ++messages;
            } else if (xml.name() == QLatin1String("translation")) {
                if (xml.attributes().hasAttribute("type")) {
                    wrong << source + " (unfinished)";
                }
                const QString translated =
                    xml.readElementText(QXmlStreamReader::IncludeChildElements);
                for (auto match = place.globalMatch(source); match.hasNext();) {
                    const QString number = match.next().captured();
                    if (!translated.contains(number)) {
                        wrong << source + " (without " + number + ")";
                    }
                }
            }
        }
        QVERIFY(!xml.hasError());
        VYBEG_MORE(messages, 300);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }
};

VYBEG_TEST(TestLanguages)

}  // namespace test_languages

#include "test_languages.moc"
