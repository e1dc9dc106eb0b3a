#include "ui/batch/batch_text.h"

#include "ui/words/error_text.h"

#include <QCoreApplication>

#include <array>

namespace vybeg::ui {

namespace {

struct Named {
    const char* option;
    const char* field;  // of context BatchForm
};

constexpr std::array fields{
    Named{"-o", QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "Results")},
    Named{"--passport", QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "Passports")},
    Named{"--database", QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "Database")},
    Named{"--json", QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "JSON files")}};

}  // namespace

QString batchErrorText(const Error& error) {
    Error named = error;
    for (const auto& [option, field] : fields) {
        if (named.code == ErrorCode::setting_invalid && named.args.front().text == option) {
            named.args.front() =
                QCoreApplication::translate("vybeg::ui::BatchForm", field).toStdString();
        }
    }
    return errorText(named);
}

}  // namespace vybeg::ui
