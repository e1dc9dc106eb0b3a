// The import dialog driven as a person drives it: choices, preview, opening, what is remembered.
#include "core/recording/bytes/number_type.h"
#include "core/recording/open/open_recording.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/import/import_dialog.h"
#include "ui/import/import_fields.h"
#include "ui/panels/message_bar.h"
#include "ui/values/json_fields.h"
#include "ui/widgets/number_field.h"
#include "ui/window/main_window.h"
#include "ui/words/language.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>
#include <qcustomplot.h>

#include <cmath>
#include <ctime>

namespace test_import_dialog {

using namespace vybeg;
using namespace vybeg::ui;

class TestImportDialog : public QObject {
    Q_OBJECT

    GuiTestHome home_;
    Language language_;
    BackgroundJobs job_;
    QPointer<ImportDialog> dialog_;

    template <class Widget>
    Widget& the(const char* name = "") {
        return childOf<Widget>(*dialog_, QLatin1String(name));
    }

    QPushButton& openButton() { return *the<QDialogButtonBox>().button(QDialogButtonBox::Open); }
    QString told() { return the<QLabel>("what").text(); }
    QString cell(int row, int column) {
        const QTableWidgetItem* item = the<QTableWidget>().item(row, column);
        return item ? item->text() : QString();
    }
    int samples() { return the<QCustomPlot>().graph(0)->dataCount(); }

    void show(const QString& path, const OpenOptions& options = {}) {
        delete dialog_;
        dialog_ = new ImportDialog(job_, path, options);
        dialog_->show();
    }

    void choose(const char* list, const QString& text) {
        auto& box = the<QComboBox>(list);
        const int index = box.findText(text);
        VYBEG_AT_LEAST(index, 0, qPrintable(text));
        box.setCurrentIndex(index);
    }

    void type(const char* field, const QString& text) {
        auto& edit = the<QLineEdit>(field);
        edit.setFocus();
        edit.selectAll();
        QTest::keyClicks(&edit, text);
    }

    // A decay of 1000 Hz at 8000 Hz between semicolons, with decimal commas and no time.
    QString table(const QString& name) const {
        QByteArray text = "pick-off C;pick-off D\n";
        for (int k = 0; k < 4000; ++k) {
            const double phase = 0.25 * 3.14159265358979 * k;
            QByteArray row = QByteArray::number(std::cos(phase - 0.4), 'f', 6) + ";" +
                             QByteArray::number(0.3 * std::cos(phase - 0.5), 'f', 6) + "\n";
            text += row.replace('.', ',');
        }
        return home_.file(name, text);
    }

    QString raw(const QString& name) const {
        FreeDecay settings = demo_decay();
        settings.seconds = 1;
        const auto decay = simulate(settings, {});
        std::string bytes(64, 'h');
        for (std::size_t i = 0; decay && i < decay->c.size(); ++i) {
            bytes += store(static_cast<std::int16_t>(9000 * decay->c[i]), true);
            bytes += store(static_cast<std::int16_t>(9000 * decay->d[i]), true);
        }
        return home_.file(name, QByteArray::fromStdString(bytes));
    }

private slots:
    void init() {
        QSettings().clear();
        language_.use("en");
    }
    void cleanup() { delete dialog_; }

    void the_guess_stands_in_the_fields_and_the_rate_is_asked_for() {
        show(table("guess.csv"));
        QTRY_VERIFY(samples() > 0);
        QCOMPARE(the<QComboBox>("delimiter").currentText(), QString("automatic: semicolon"));
        QCOMPARE(the<QComboBox>("decimal").currentText(), QString("automatic: comma"));
        QVERIFY(dialog_->focusWidget() == &the<QLineEdit>("rate"));
        QCOMPARE(the<QComboBox>("time_column").currentText(), QString("automatic: none"));
        QCOMPARE(the<NumberField>("skip_lines").placeholderText(), QString("automatic: 1"));
        QCOMPARE(the<QComboBox>("channel_d").currentText(), QString("2: pick-off D"));
        QVERIFY(the<QComboBox>("raw_type").isHidden());
        QVERIFY(the<QLineEdit>("variables").isHidden());
        QVERIFY2(told().contains("sample rate"), qPrintable(told()));
        QVERIFY(!openButton().isEnabled());
        // With the keyboard alone; point and comma mean the same.
        for (const char* rate : {"8000,5", "8000.5"}) {
            type("rate", rate);
            QTRY_VERIFY(openButton().isEnabled());
            QCOMPARE(dialog_->options().rate_hz, std::optional(8000.5));
        }
        QCOMPARE(told(), QString("text, 2 columns, semicolon, decimal comma"));
        // The legend covers no sample, and numbers have a true minus.
        QCustomPlot& plot = the<QCustomPlot>();
        VYBEG_AT_MOST(plot.legend->outerRect().bottom(), plot.axisRect()->top());
        QVector<double> ticks;
        QVector<QString> numbers;
        plot.yAxis->ticker()->generate({-1.5, 1.5}, QLocale(), 'g', 6, ticks, nullptr, &numbers);
        const QString all = QStringList(numbers).join(' ');
        QVERIFY2(all.contains(QChar(0x2212)) && !all.contains('-'), qPrintable(all));
    }

    void the_file_of_the_other_channel_is_found_by_its_name_and_makes_a_pair() {
        const QTemporaryDir folder;
        const auto write = [&folder](const QString& name, double shift) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("t,U\n");
            for (int i = 0; i < 200; ++i) {
                file.write(QByteArray::number(1e-4 * i, 'f', 6) + ',' +
                           QByteArray::number(std::cos(0.9 * i + shift), 'f', 6) + '\n');
            }
        };
        write("run_C.csv", 0);
        show(folder.filePath("run_C.csv"));
        QTRY_VERIFY(told().contains("Import"));
        QVERIFY(!openButton().isEnabled());
        write("run_D.csv", 1.1);
        show(folder.filePath("run_C.csv"));
        QTRY_VERIFY(openButton().isEnabled());
        QCOMPARE(dialog_->options().channel_d_file, folder.filePath("run_D.csv").toStdString());
        QCOMPARE(cell(0, 1), QString("0.453596"));
        // Another file may have none beside it.
        dialog_->accept();
        write("alone_C.csv", 0);
        show(folder.filePath("alone_C.csv"));
        QTRY_VERIFY(told().contains("Import"));
        QVERIFY(dialog_->options().channel_d_file.empty());
    }

    void pieces_are_named_and_chosen_and_exclude_a_file_of_channel_d() {
        const QString path = table("piece_1.csv");
        show(path);
        type("join", "piece_2.csv, piece_3.csv");
        const auto beside = [&path](const char* name) {
            return QFileInfo(path).dir().filePath(name).toStdString();
        };
        QCOMPARE(dialog_->options().join,
                 (std::vector{beside("piece_2.csv"), beside("piece_3.csv")}));
        QVERIFY(!the<QLineEdit>("channel_d_file").isEnabled());
        // By the sign in the field.
        connect(dialog_, &ImportDialog::filesWanted, this, [](const auto& take) {
            take({QStringLiteral("/data/a.csv"), QStringLiteral("/data/b.csv")});
        });
        the<QLineEdit>("join").actions().front()->trigger();
        QCOMPARE(dialog_->options().join, (std::vector<std::string>{"/data/a.csv", "/data/b.csv"}));
        the<QLineEdit>("join").selectAll();
        QTest::keyClick(&the<QLineEdit>("join"), Qt::Key_Delete);
        type("channel_d_file", "other.csv");
        QVERIFY(!the<QLineEdit>("join").isEnabled());
        QCOMPARE(dialog_->options().channel_d_file, beside("other.csv"));
        the<QLineEdit>("channel_d_file").actions().front()->trigger();
        QCOMPARE(dialog_->options().channel_d_file, std::string("/data/a.csv"));
        // What was given stays as it is: a folder may have a comma in its name.
        const OpenOptions given{.join = {"/data, old/2.csv"}};
        show(path, given);
        QCOMPARE(dialog_->options().join, given.join);
    }

    void named_pieces_are_one_recording() {
        const QString first = home_.recording("first.wav");
        home_.recording("second.wav");
        show(first);
        QTRY_VERIFY(openButton().isEnabled());
        type("join", "second.wav");
        QTRY_VERIFY(openButton().isEnabled());
        const auto alone = open_recording(first.toStdU16String(), {}, JobControl());
        const auto both = open_recording(first.toStdU16String(), dialog_->options(), JobControl());
        QVERIFY(alone && both);
        QCOMPARE(both->source->frames(), 2 * alone->source->frames());
    }

    void another_delimiter_is_another_preview() {
        const OpenOptions rate{.rate_hz = 8000};
        show(table("delimiter.csv"), rate);
        QTRY_VERIFY(openButton().isEnabled());
        QCOMPARE(cell(0, 0), QString("pick-off C;pick-off D"));
        QCOMPARE(cell(1, 0), QString("0,921061"));
        QCOMPARE(cell(1, 1), QString("0,263275"));
        QCOMPARE(the<QTableWidget>().columnCount(), 2);
        QCOMPARE(the<QTableWidget>().horizontalHeaderItem(1)->text(), QString("D = pick-off D"));

        choose("delimiter", "tab");
        QTRY_VERIFY(told().contains("--delimiter tab"));
        QVERIFY(!openButton().isEnabled());
        QCOMPARE(cell(1, 0), QString("0,921061;0,263275"));
        QVERIFY(the<QCustomPlot>().isHidden());

        choose("delimiter", "semicolon");
        QTRY_VERIFY(openButton().isEnabled());
        QCOMPARE(samples(), static_cast<int>(preview_frames));
        QVERIFY(!the<QCustomPlot>().isHidden());
        QVERIFY(dialog_->options().text);
        QCOMPARE(dialog_->options().text->delimiter, std::optional(';'));

        the<QComboBox>("delimiter").setCurrentIndex(0);
        QTRY_VERIFY(openButton().isEnabled());
        QVERIFY(!dialog_->options().text);
    }

    void lines_columns_scale_and_unit_reach_the_preview() {
        show(home_.file("columns.txt",
                        "9 9 9\n1.5 0 4\n2.5 0.001 5\n3.5 0.002 6\n1 0.003 4\n"
                        "2 0.004 5\n3 0.005 1\n"));
        QTRY_VERIFY(samples() > 0);
        type("skip_lines", "1");
        choose("time_column", "2");
        QTRY_VERIFY(openButton().isEnabled());
        QCOMPARE(the<QTableWidget>().horizontalHeaderItem(1)->text(), QString("t = 2"));
        QCOMPARE(the<QComboBox>("channel_d").count(), 2);
        type("scale", "0,5");
        type("unit", "mV");
        QTRY_COMPARE(the<QComboBox>("channel_c").currentText(), QString("1 [mV]"));
        QCOMPARE(the<QCustomPlot>().graph(0)->data()->at(0)->value, 0.75);
        QCOMPARE(the<QCustomPlot>().yAxis->label(), QString("mV"));
        QCOMPARE(dialog_->options().unit, std::string("mV"));
        QCOMPARE(dialog_->options().text->time_column, std::optional(2));
        QCOMPARE(dialog_->options().text->lines_to_skip, std::optional<std::int64_t>(1));
        // C and D change places.
        the<QComboBox>("channel_c").setCurrentIndex(1);
        QTRY_VERIFY(!openButton().isEnabled());
        the<QComboBox>("channel_d").setCurrentIndex(0);
        QTRY_VERIFY(openButton().isEnabled());
        QCOMPARE(the<QCustomPlot>().graph(0)->data()->at(0)->value, 2.0);
    }

    void a_file_of_no_format_is_proposed_as_raw_samples() {
        show(raw("board.bin"));
        QTRY_VERIFY(samples() > 0);
        QCOMPARE(the<QComboBox>("read_as").currentText(), QString("raw samples"));
        QCOMPARE(the<QComboBox>("raw_type").currentText(), QString("16 bit integer"));
        QVERIFY(the<QComboBox>("delimiter").isHidden());
        choose("raw_order", "big endian");
        type("raw_skip", "64");
        type("rate", "33333");
        QTRY_VERIFY(openButton().isEnabled());
        the<QSpinBox>("raw_channels").setValue(3);
        QTRY_COMPARE(the<QTableWidget>().columnCount(), 3);
        choose("raw_type", "64 bit float");
        QTRY_VERIFY(told().contains("64 bit float"));
    }

    void a_text_read_as_raw_gets_the_layout_of_the_last_one() {
        const OpenOptions options{.rate_hz = 1000,
                                  .raw = RawLayout{.type = RawType::f64, .skip_bytes = 80}};
        rememberImport(importKind("/a/b.wav", {}, true), options);
        show(home_.recording("wave.wav"));
        QTRY_VERIFY(openButton().isEnabled());
        QVERIFY(the<QComboBox>("raw_type").isHidden());
        choose("read_as", "raw samples");
        QTRY_COMPARE(the<QComboBox>("raw_type").currentText(), QString("64 bit float"));
        QVERIFY(!the<QComboBox>("raw_type").isHidden());
    }

    void what_was_chosen_is_remembered_for_files_of_the_kind() {
        OpenOptions rate{.rate_hz = 8000};
        show(table("first.csv"), rate);
        QTRY_VERIFY(openButton().isEnabled());
        choose("delimiter", "semicolon");
        type("scale", "2");
        type("unit", "V");
        QTRY_VERIFY(openButton().isEnabled());
        const OpenOptions chosen = dialog_->options();
        QSignalSpy spy(dialog_, &ImportDialog::chosen);
        QTest::mouseClick(&openButton(), Qt::LeftButton);
        QCOMPARE(spy.count(), 1);

        show(table("second.csv"));
        QTRY_VERIFY(openButton().isEnabled());
        QCOMPARE(dialog_->options(), chosen);
        // Other columns are another kind; so is another ending.
        show(home_.file("third.csv", "1;2\n3;4\n5;6\n7;8\n9;1\n"));
        QTRY_VERIFY(samples() > 0);
        QCOMPARE(dialog_->options(), OpenOptions{});
        // What is said comes before what is remembered.
        rate.rate_hz = 9000;
        show(table("fourth.csv"), rate);
        QTRY_VERIFY(openButton().isEnabled());
        QCOMPARE(dialog_->options(), rate);
    }

    void a_sound_file_is_scaled_as_well() {
        show(home_.recording("scaled.wav"));
        QTRY_VERIFY(samples() > 0);
        const double first = the<QCustomPlot>().graph(0)->data()->constBegin()->value;
        QVERIFY(the<QLineEdit>("scale").isVisible());
        type("scale", "2.5");
        QCOMPARE(dialog_->options().scale, 2.5);
        QTRY_COMPARE(the<QCustomPlot>().graph(0)->data()->constBegin()->value, 2.5 * first);
    }

    void raw_layouts_are_remembered_by_the_ending() {
        const OpenOptions options{
            .rate_hz = 1000,
            .channel_d = 3,
            .raw = RawLayout{.type = RawType::f32, .channels = 3, .skip_bytes = 8},
            .scale = 4};
        rememberImport(importKind("/a/b.BIN", {}, true), options);
        show(raw("other.bin"));
        QTRY_VERIFY(openButton().isEnabled());
        QCOMPARE(dialog_->options(), options);
    }

    void only_the_last_kinds_are_kept() {
        for (int i = 0; i < 60; ++i) {
            const OpenOptions options{.rate_hz = 100 + i};
            rememberImport(QString::number(i), options);
        }
        rememberImport("59", {});
        QVERIFY(!rememberedImport("9"));
        QVERIFY(rememberedImport("10"));
        QVERIFY(!rememberedImport("59")->rate_hz);
    }

    void options_come_back_from_their_json() {
        const OpenOptions options{.rate_hz = 33333.25,
                                  .channel_c = 4,
                                  .variables = {"XY", "", "fs"},
                                  .text = TextChoice{'\t', true, 7, 0, 1e-6},
                                  .unit = "мкВ",
                                  .scale = -0.125,
                                  .channel_d_file = "/данные/d.ana",
                                  .join = {"/data/2.wav", "/data/3.wav"}};
        QCOMPARE(optionsFromJson(optionsToJson(options)), options);
        const OpenOptions raw{.raw = RawLayout{RawType::i32, true, 5, std::int64_t{1} << 40},
                              .scale = 1e-9};
        QCOMPARE(optionsFromJson(optionsToJson(raw)), raw);
        // Earlier versions kept the scale with the layout or the choice.
        for (const char* part : {"raw", "text"}) {
            QCOMPARE(optionsFromJson({{part, QJsonObject{{"scale", 0.25}}}}).scale, 0.25);
        }
        QCOMPARE(optionsFromJson({}), OpenOptions{});
    }

    void the_window_opens_what_was_chosen() {
        TestWindow window;
        window.setLanguage("en");
        window.show();
        window.document().open({table("norate.csv")});
        auto* bar = window.findChild<MessageBar*>();
        QTRY_VERIFY(!bar->texts().isEmpty());
        // The message offers the import.
        QPushButton* offer = nullptr;
        for (QPushButton* each : bar->findChildren<QPushButton*>()) {
            offer = each->text() == QString("Import…") ? each : offer;
        }
        QVERIFY(offer);
        offer->click();
        QTRY_VERIFY(window.findChild<ImportDialog*>());
        dialog_ = window.findChild<ImportDialog*>();
        type("rate", "8000");
        choose("decimal", "comma");
        QTRY_VERIFY(openButton().isEnabled());
        QTest::keyClick(dialog_, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(window.document().analyses().size(), std::size_t(1), 20000);
        const RecordingEntry* entry = window.document().currentRecording();
        QVERIFY(entry && entry->recording);
        QCOMPARE(entry->recording->rate_hz, 8000.0);
        QCOMPARE(entry->recording->read_with, std::string("--decimal comma"));
        QTRY_VERIFY(entry->f0_hz);
        VYBEG_CLOSE(*entry->f0_hz, 1000, 0.01);
        QTRY_VERIFY(!dialog_);
    }

    void the_menu_has_an_import() {
        TestWindow window;
        window.setLanguage("en");
        QCOMPARE(window.action(Command::import_file)->text(), QString("&Import…"));
        QVERIFY(window.action(Command::import_file)->isEnabled());
        QCOMPARE(window.action(Command::import_file)->shortcut(),
                 QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O));
    }

    void every_field_has_a_name_and_a_tip() {
        show(table("names.csv"));
        const auto* fields = dialog_->findChild<ImportFields*>();
        int named = 0;
        for (const QWidget* widget : fields->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
            if (widget->focusPolicy() != Qt::NoFocus) {
                QVERIFY(!widget->accessibleName().isEmpty());
                QVERIFY(!widget->toolTip().isEmpty());
                ++named;
            }
        }
        QCOMPARE(named, 18);
    }

    // Every key starts a preview; the window must not make any itself. 100 ms is what a person
    // feels. Processor time of this thread: what others do to the machine does not count.
    void typing_never_waits_for_a_preview() {
        QByteArray text = "t,C,D\n";
        for (int k = 0; k < 1000000; ++k) {
            text += QByteArray::number(k) + "e-5,1,2\n";
        }
        show(home_.file("large.csv", text));
        QTRY_VERIFY(samples() > 0);
        const auto busy_ms = [] {
            timespec time{};
            clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
            return 1e3 * static_cast<double>(time.tv_sec) +
                   1e-6 * static_cast<double>(time.tv_nsec);
        };
        double longest = 0;
        for (const char key : {'9', '0', '0', '0', '0', '0'}) {
            const double before = busy_ms();
            QTest::keyClick(&the<QLineEdit>("skip_lines"), key);
            longest = std::max(longest, busy_ms() - before);
        }
        VYBEG_LESS(longest, 100);
        QTRY_VERIFY(openButton().isEnabled());
        QVERIFY(cell(0, 0).startsWith("899993e-5"));
    }
};

VYBEG_TEST(TestImportDialog, threads)

}  // namespace test_import_dialog

#include "test_import_dialog.moc"
