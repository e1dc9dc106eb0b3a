// The questions for a file, and what may not be written over.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/message_bar.h"
#include "ui/plots/track_view.h"
#include "ui/window/export_dialogs.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTest>

#include <array>
#include <cmath>
#include <malloc.h>

namespace test_file_dialogs {

using namespace vybeg;
using namespace vybeg::ui;

class TestFileDialogs : public QObject, private WindowTest {
    Q_OBJECT

    void openOne() {
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        document().open({home_.recording("demo.wav")});
        QVERIFY(idle(1));
        QVERIFY(QTest::qWaitFor([&] { return document().carrier().has_value(); }));
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void a_question_for_a_file_keeps_no_memory() {
        openOne();
        const auto ask = [this](Command command) {
            window_->action(command)->trigger();
            auto* dialog = window_->findChild<QFileDialog*>();
            QVERIFY(dialog && dialog->isVisible());
            // Its list of files is read in the background, unless Qt knows the folder from an
            // earlier question; nothing shows which of them, or that it is done.
            QTest::qWait(20);
            dialog->reject();
            QVERIFY(!dialog->isVisible());
            deliverPosted();
        };
        const std::array commands{Command::open, Command::import_file, Command::export_track,
                                  Command::compare_passport};
        std::size_t before = 0;
        constexpr int warm = 4;
        constexpr int rounds = 12;
        for (int round = 0; round < rounds; ++round) {
            for (const Command command : commands) {
                if (window_->action(command)->isEnabled()) {
                    ask(command);
                }
            }
            before = round == warm - 1 ? mallinfo2().uordblks : before;
        }
        const auto kept = static_cast<double>(mallinfo2().uordblks) - static_cast<double>(before);
        const double each = kept / (rounds - warm) / static_cast<double>(commands.size()) / 1e6;
        qInfo("%.3f MB kept by each opening", each);
        VYBEG_LESS(each, 0.05);
    }

    void a_file_dialog_asks_each_question_anew() {
        openOne();
        window_->action(Command::export_track)->trigger();
        auto& dialog = childOf<QFileDialog>(*window_);
        QCOMPARE(dialog.acceptMode(), QFileDialog::AcceptSave);
        QCOMPARE(dialog.defaultSuffix(), QStringLiteral("csv"));
        QCOMPARE(QFileInfo(dialog.selectedFiles().value(0)).fileName(),
                 QStringLiteral("demo_maximum-likelihood_60.csv"));
        QStringList endings;
        for (const QString& filter : dialog.nameFilters()) {
            emit dialog.filterSelected(filter);
            endings += dialog.defaultSuffix();
        }
        QCOMPARE(endings, (QStringList{"csv", "mat", "h5", "npz"}));
        dialog.reject();
        window_->action(Command::export_plots)->trigger();
        auto& plots = childOf<ExportDialog>(*window_);
        QTest::keyClick(&plots, Qt::Key_Return);
        QCOMPARE(dialog.defaultSuffix(), QStringLiteral("png"));
        QVERIFY(dialog.selectedFiles().value(0).endsWith(".png"));
        dialog.reject();
        plots.reject();
        window_->action(Command::open)->trigger();
        QCOMPARE(dialog.acceptMode(), QFileDialog::AcceptOpen);
        QCOMPARE(dialog.fileMode(), QFileDialog::ExistingFiles);
        QCOMPARE(childOf<QLineEdit>(dialog, "fileNameEdit").text(), QString());
        // What is chosen now is opened, and written nowhere.
        const qsizetype recordings = qsizetype(document().recordings().size());
        const QString chosen = home_.recording("chosen.wav");
        emit dialog.filesSelected({chosen});
        dialog.reject();
        QVERIFY(QTest::qWaitFor(
            [&] { return qsizetype(document().recordings().size()) == recordings + 1; }));
    }

    void a_figure_has_the_plots_size_and_caption_that_are_asked_for() {
        openOne();
        QVERIFY(window_->action(Command::export_plots)->isEnabled());
        QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
        auto& dialog = childOf<ExportDialog>(*window_);
        const auto boxes = dialog.findChildren<QCheckBox*>();
        QCOMPARE(boxes.size(), 6);  // five plots and the settings
        typeInto(fieldOf(dialog, "Width"), "120");
        typeInto(fieldOf(dialog, "Height"), "100");
        typeInto(fieldOf(dialog, "Resolution"), "254");
        auto& title = childOf<QLineEdit>(dialog, "title");
        QCOMPARE(title.text(), QStringLiteral("demo.wav"));
        title.setText("Free decay of gyro_17");
        const auto save = [&](ExportDialog& to, const QString& path) {
            QTest::mouseClick(to.findChild<QPushButton*>("save"), Qt::LeftButton);
            auto& question = childOf<QFileDialog>(*window_);
            emit question.fileSelected(path);
            question.reject();
        };
        save(dialog, home_.path("paper.png"));
        const QImage image(home_.path("paper.png"));
        VYBEG_CLOSE(image.width(), 1200, 12);
        VYBEG_CLOSE(image.height(), 1000, 12);
        VYBEG_CLOSE(image.dotsPerMeterX(), 10000, 1);
        QTRY_VERIFY(!window_->findChild<ExportDialog*>());

        // Its resolution is kept; two plots only, as text.
        window_->action(Command::export_plots)->trigger();
        auto& again = childOf<ExportDialog>(*window_);
        QCOMPARE(fieldOf(again, "Resolution").value(), std::optional(254.));
        const double five = *fieldOf(again, "Height").value();
        const auto plots = again.findChildren<QCheckBox*>();
        for (const int off : {0, 1, 4}) {
            QTest::mouseClick(plots[off], Qt::LeftButton, {}, QPoint(8, plots[off]->height() / 2));
        }
        VYBEG_LESS(*fieldOf(again, "Height").value(), five);
        save(again, home_.path("two.svg"));
        QFile file(home_.path("two.svg"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString svg = QString::fromUtf8(file.readAll());
        QVERIFY(svg.contains("demo.wav") && svg.contains("window 60"));
        QVERIFY(svg.contains(">2θ") && !svg.contains(">Δφ"));
        QTRY_VERIFY(!window_->findChild<ExportDialog*>());
    }

    void nothing_is_exported_without_a_plot_or_with_a_wrong_size() {
        openOne();
        QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
        auto& dialog = childOf<ExportDialog>(*window_);
        auto& save = *dialog.findChild<QPushButton*>("save");
        QVERIFY(save.isEnabled());
        typeInto(fieldOf(dialog, "Width"), "5");
        QVERIFY(!save.isEnabled());
        QVERIFY(!fieldOf(dialog, "Width").fault().isEmpty());
        typeInto(fieldOf(dialog, "Width"), "100");
        QVERIFY(save.isEnabled());
        // Five plots do not stand in 40 mm, one does.
        typeInto(fieldOf(dialog, "Height"), "40");
        QVERIFY(!save.isEnabled());
        QVERIFY(!fieldOf(dialog, "Height").fault().isEmpty());
        typeInto(fieldOf(dialog, "Height"), "120");
        QVERIFY(save.isEnabled());
        for (QCheckBox* box : dialog.findChildren<QCheckBox*>().mid(0, 5)) {
            box->setChecked(false);
        }
        QVERIFY(!save.isEnabled());
        dialog.reject();
    }

    void a_copied_figure_is_an_image_and_vectors() {
        openOne();
        QTest::keyClick(window_.get(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        const QMimeData* data = QApplication::clipboard()->mimeData();
        QVERIFY(data->hasImage());
        QVERIFY(data->data("image/svg+xml").contains("<svg"));
    }

    void the_ending_decides_what_a_track_is_exported_as() {
        openOne();
        const QMap<QString, QByteArray> signatures{
            {"track.npz", "PK\x03\x04"}, {"track.h5", "\x89HDF"}, {"track.mat", "MATLAB 5.0"}};
        for (auto each = signatures.cbegin(); each != signatures.cend(); ++each) {
            const QString path = home_.path(each.key());
            window_->files().exportTrackTo(path);
            QVERIFY(QTest::qWaitFor([&] { return QFile::exists(path); }));
            QFile track(path);
            QVERIFY(track.open(QIODevice::ReadOnly));
            QVERIFY2(track.readAll().startsWith(each.value()), qPrintable(each.key()));
        }
        window_->files().exportTrackTo(home_.path("track.npy"));
        QTRY_VERIFY(the<MessageBar>().texts().join('\n').contains("let its name end in .npz"));
    }

    void an_ending_that_cannot_be_written_is_refused() {
        openOne();
        const auto refused = [this](const QString& path) {
            return the<MessageBar>().texts().first().contains("the ending \".xlsx\"") &&
                   !QFile::exists(path);
        };
        const QString path = home_.path("written.xlsx");
        the<MessageBar>().clear();
        window_->files().savePassportTo(path);
        QVERIFY(refused(path));
        the<MessageBar>().clear();
        window_->files().exportTrackTo(path);
        QTRY_VERIFY(!the<MessageBar>().texts().isEmpty());
        QVERIFY(refused(path));
        the<MessageBar>().clear();
        window_->files().exportHistoryTo(path, {});
        QVERIFY(refused(path));
        the<MessageBar>().clear();
        window_->files().writeReport({}, "All", path);
        QVERIFY(refused(path));
    }

    void no_export_takes_the_place_of_an_open_recording() {
        openOne();
        const QString recording = window_->document().currentRecording()->path;
        const QString link = home_.path("link.svg");
        QVERIFY(QFile::link(recording, link));
        const auto bytes = [&] {
            QFile file(recording);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray before = bytes();
        QVERIFY(!before.isEmpty());
        const QString around =
            QFileInfo(recording).path() + "/./" + QFileInfo(recording).fileName();
        for (const QString& path : {recording, around, link}) {
            window_->files().exportTrackTo(path);
            QVERIFY(the<MessageBar>().texts().first().contains("is one of the open files"));
            QVERIFY(!exportPlotsTo(*window_, path));
            QVERIFY(the<MessageBar>().texts().first().contains("is one of the open files"));
            window_->files().savePassportTo(path);
            QVERIFY(!document().busy());
            deliverPosted();
            QVERIFY(bytes() == before);
        }
        QVERIFY(QFile::remove(link));
    }

    // Of a recording in two files, too.
    void no_export_takes_the_place_of_a_further_file() {
        std::array<QByteArray, 2> texts{"t,C\n", "t,D\n"};
        for (int row = 0; row < 6000; ++row) {
            for (std::size_t channel = 0; channel < texts.size(); ++channel) {
                const double value = std::cos(row - 0.5 * static_cast<double>(channel));
                texts[channel] += QByteArray::number(row / 33333.0, 'g', 12) + "," +
                                  QByteArray::number(value, 'g', 12) + "\n";
            }
        }
        const QString c = home_.file("part-c.csv", texts[0]);
        const QString d = home_.file("part-d.csv", texts[1]);
        OpenOptions options;
        options.channel_d_file = d.toStdString();
        document().open({c}, options);
        QTRY_VERIFY(document().currentRecording() && document().currentRecording()->recording);
        the<MessageBar>().clear();
        window_->files().exportTrackTo(d);
        QVERIFY(the<MessageBar>().texts().first().contains("is one of the open files"));
        QFile file(d);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), texts[1]);
    }

    void an_exported_figure_has_its_size_whatever_else_is_in_the_window() {
        openOne();
        const auto size = [this] {
            [&] { QVERIFY(exportPlotsTo(*window_, home_.path("size.png"))); }();
            window_->action(Command::copy_plot)->trigger();
            const QSize written = QImage(home_.path("size.png")).size();
            return std::pair(written, QApplication::clipboard()->image().size());
        };
        const auto before = size();
        QCOMPARE(before.first, before.second);
        window_->document().report({MessageLevel::warning, [] { return QString("odd"); }});
        QVERIFY(the<MessageBar>().isVisible());
        window_->resize(1000, 700);
        QVERIFY(QTest::qWaitFor([&] { return the<TrackView>().width() < 800; }));
        QVERIFY(size() == before);
    }
};

VYBEG_TEST(TestFileDialogs)

}  // namespace test_file_dialogs

#include "test_file_dialogs.moc"
