// What the check of a recording says.
#include "core/base/diagnostic.h"
#include "tests/test_registry.h"
#include "ui/panels/findings_flag.h"

#include <QLabel>
#include <QTextBrowser>
#include <QtTest>

namespace test_check_list {

using namespace vybeg;
using namespace vybeg::ui;

class TestCheckList : public QObject {
    Q_OBJECT

private slots:
    void a_note_stands_in_the_list_and_is_no_finding() {
        CheckList list;
        Diagnostic note;
        note.kind = DiagnosticKind::text_lines_ignored;
        note.args = {"2"};
        list.setFindings({note}, 1000);
        QCOMPARE(list.findChild<QLabel*>()->text(),
                 QStringLiteral("Recording check: nothing found"));
        QVERIFY(list.findChild<QTextBrowser*>()->toPlainText().contains("2 header"));
        Diagnostic gap;
        gap.kind = DiagnosticKind::clipped;
        gap.args = {"1", "12", "0.5"};
        list.setFindings({note, gap}, 1000);
        QVERIFY(list.findChild<QLabel*>()->text().contains("1 finding"));
    }
};

VYBEG_TEST(TestCheckList)

}  // namespace test_check_list

#include "test_check_list.moc"
