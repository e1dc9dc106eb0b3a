#include "ui/batch/batch_columns.h"

#include "core/output/batch_csv.h"
#include "core/resonator/results/resonator_parameters.h"
#include "ui/resonator/parameter_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace vybeg::ui {

namespace {

struct Texts {
    const char* name;  // in RESULTS.csv
    BatchColumnKind kind;
    const char* title;
    const char* tip;
};

// In the order of the window: what is asked first stands first. Behind the column that has changed
// come the parameters.
constexpr std::array first_texts{
    Texts{"set", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Set"),
          QT_TRANSLATE_NOOP("BatchColumn", "Its name in the list")},
    Texts{"gyro", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Gyro"),
          QT_TRANSLATE_NOOP("BatchColumn", "The first that the rows of the set name")},
    Texts{"date", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Date"),
          QT_TRANSLATE_NOOP("BatchColumn", "The first that the rows of the set name")},
    Texts{"status", BatchColumnKind::state, QT_TRANSLATE_NOOP("BatchColumn", "State"),
          QT_TRANSLATE_NOOP("BatchColumn", "Whether the set is computed, and has a result")},
    Texts{"verdict", BatchColumnKind::verdict, QT_TRANSLATE_NOOP("BatchColumn", "Verdict"),
          QT_TRANSLATE_NOOP("BatchColumn", "Of the comparison with the gyro's passport")},
    Texts{"changed", BatchColumnKind::changed, QT_TRANSLATE_NOOP("BatchColumn", "Changed"),
          QT_TRANSLATE_NOOP("BatchColumn", "The parameters that differ from the passport")}};

constexpr std::array last_texts{
    Texts{"model", BatchColumnKind::model, QT_TRANSLATE_NOOP("BatchColumn", "Model"),
          QT_TRANSLATE_NOOP("BatchColumn",
                            "Structured: of known channels; free: where the data tell too little "
                            "about it")},
    Texts{"noise", BatchColumnKind::noise, QT_TRANSLATE_NOOP("BatchColumn", "Noise"),
          QT_TRANSLATE_NOOP("BatchColumn", "White, or coloured about the carrier")},
    Texts{"chi2_per_dof", BatchColumnKind::number, QT_TRANSLATE_NOOP("BatchColumn", "χ² per dof"),
          QT_TRANSLATE_NOOP("BatchColumn",
                            "What the model leaves, in units of the noise: 1 is all noise")},
    Texts{"files", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Recordings"),
          QT_TRANSLATE_NOOP("BatchColumn", "As the list names them")},
    Texts{"message", BatchColumnKind::reason, QT_TRANSLATE_NOOP("BatchColumn", "Reason"),
          QT_TRANSLATE_NOOP("BatchColumn", "Why the set has no result, or no verdict")},
    Texts{"warnings", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Warnings"),
          QT_TRANSLATE_NOOP("BatchColumn", "Their codes, the worst first")},
    Texts{"bias_v", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Bias, V"),
          QT_TRANSLATE_NOOP("BatchColumn", "A column of the list")},
    Texts{"temperature_c", BatchColumnKind::text,
          QT_TRANSLATE_NOOP("BatchColumn", "Temperature, °C"),
          QT_TRANSLATE_NOOP("BatchColumn", "A column of the list")},
    Texts{"exchanged", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Exchanged"),
          QT_TRANSLATE_NOOP("BatchColumn", "A column of the list")},
    Texts{"operator", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Operator"),
          QT_TRANSLATE_NOOP("BatchColumn", "A column of the list")},
    Texts{"comment", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Comment"),
          QT_TRANSLATE_NOOP("BatchColumn", "A column of the list")}};

const Texts* textsOf(const std::string& name) {
    for (const auto& texts : first_texts) {
        if (name == texts.name) {
            return &texts;
        }
    }
    for (const auto& texts : last_texts) {
        if (name == texts.name) {
            return &texts;
        }
    }
    return nullptr;
}

QString translated(const char* text) {
    return QCoreApplication::translate("BatchColumn", text);
}

}  // namespace

std::vector<BatchColumn> batchColumns(const std::vector<std::string>& other_columns) {
    const std::vector<std::string> names = batch_columns();
    const auto place = [&names](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    std::vector<BatchColumn> columns;
    columns.reserve(names.size());
    for (const Texts& texts : first_texts) {
        columns.push_back({texts.kind, texts.name, place(texts.name)});
    }
    for (const ResonatorParameter& parameter : resonator_parameters) {
        if (const std::size_t at = place(parameter.name); at < names.size()) {
            columns.push_back({BatchColumnKind::quantity, parameter.name, at,
                               place(std::string("sd_") + parameter.name),
                               place(std::string("u_") + parameter.name), parameter.unit});
        }
    }
    for (const Texts& texts : last_texts) {
        columns.push_back({texts.kind, texts.name, place(texts.name)});
    }
    for (std::size_t k = 0; k < other_columns.size(); ++k) {
        columns.push_back({BatchColumnKind::text, other_columns[k], names.size() + k});
    }
    return columns;
}

QString batchColumnTitle(const BatchColumn& column, const DisplayUnits& units) {
    if (column.kind == BatchColumnKind::quantity) {
        const Shown shown = shownAs(column.name, column.unit, units);
        // Without the symbol, whose index a header could not set low.
        const QString title = shown.title.section(QLatin1Char(' '), 0, -2);
        return shown.unit.isEmpty() ? title : title + QLatin1Char('\n') + shown.unit;
    }
    const Texts* texts = textsOf(column.name);
    return texts ? translated(texts->title) : QString::fromStdString(column.name);
}

QString batchColumnTip(const BatchColumn& column) {
    if (column.kind == BatchColumnKind::quantity) {
        const Shown shown = shownAs(column.name, column.unit, {});
        return shown.title.section(QLatin1Char(' '), -1) + QStringLiteral(": ") + shown.tip;
    }
    const Texts* texts = textsOf(column.name);
    return texts ? translated(texts->tip)
                 : translated(QT_TRANSLATE_NOOP("BatchColumn", "A column of the list"));
}

double batchColumnFactor(const BatchColumn& column, const DisplayUnits& units) {
    return column.kind == BatchColumnKind::quantity
               ? shownAs(column.name, column.unit, units).factor
               : 1;
}

}  // namespace vybeg::ui
