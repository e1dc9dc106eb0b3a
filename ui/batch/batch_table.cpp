#include "ui/batch/batch_table.h"

#include "core/base/number_text.h"
#include "core/output/batch_csv.h"
#include "core/resonator/results/resonator_parameters.h"
#include "ui/resonator/parameter_text.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace vybeg::ui {

namespace {

struct Texts {
    const char* name = "";  // in RESULTS.csv
    BatchColumnKind kind = BatchColumnKind::text;
    const char* title = "";
    const char* tip = QT_TRANSLATE_NOOP("BatchColumn", "A column of the list");
};

// In the order of the window, the most important first. The parameters follow the column of
// changes.
constexpr std::array column_texts{
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
          QT_TRANSLATE_NOOP("BatchColumn", "The parameters that differ from the passport")},
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
    Texts{"bias_v", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Bias, V")},
    Texts{"temperature_c", BatchColumnKind::text,
          QT_TRANSLATE_NOOP("BatchColumn", "Temperature, °C")},
    Texts{"exchanged", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Exchanged")},
    Texts{"operator", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Operator")},
    Texts{"comment", BatchColumnKind::text, QT_TRANSLATE_NOOP("BatchColumn", "Comment")}};

// Null for a parameter and for an unknown column of the list.
const Texts* textsOf(const std::string& name) {
    const auto* found = std::ranges::find(column_texts, name, &Texts::name);
    return found == column_texts.end() ? nullptr : found;
}

QString translated(const char* text) {
    return QCoreApplication::translate("BatchColumn", text);
}

// "Frequency split", and its unit in a second line.
QString titleOf(const BatchColumn& column, const DisplayUnits& units) {
    if (column.kind == BatchColumnKind::quantity) {
        const Shown shown = shownAs(column.name, column.unit, units);
        // Without the symbol, whose index a header could not set low.
        const QString title = shown.title.section(QLatin1Char(' '), 0, -2);
        return shown.unit.isEmpty() ? title : title + QLatin1Char('\n') + shown.unit;
    }
    const Texts* texts = textsOf(column.name);
    return texts ? translated(texts->title) : QString::fromStdString(column.name);
}

QString tipOf(const BatchColumn& column) {
    if (column.kind == BatchColumnKind::quantity) {
        const Shown shown = shownAs(column.name, column.unit, {});
        return shown.title.section(QLatin1Char(' '), -1) + QStringLiteral(": ") + shown.tip;
    }
    const Texts* texts = textsOf(column.name);
    return translated(texts ? texts->tip : Texts{}.tip);
}

// From stored values to displayed ones.
double factorOf(const BatchColumn& column, const DisplayUnits& units) {
    return column.kind == BatchColumnKind::quantity
               ? shownAs(column.name, column.unit, units).factor
               : 1;
}

}  // namespace

std::vector<BatchColumn> batchColumns(const std::vector<std::string>& other_columns) {
    const std::vector<std::string> names = batch_columns();
    const auto place = [&names](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    std::vector<BatchColumn> columns;
    columns.reserve(names.size());
    for (const Texts& texts : column_texts) {
        columns.push_back({texts.kind, texts.name, place(texts.name)});
        if (texts.kind != BatchColumnKind::changed) {
            continue;
        }
        for (const ResonatorParameter& parameter : resonator_parameters) {
            if (const std::size_t at = place(parameter.name); at < names.size()) {
                columns.push_back({BatchColumnKind::quantity, parameter.name, at,
                                   place(std::string("sd_") + parameter.name),
                                   place(std::string("u_") + parameter.name), parameter.unit});
            }
        }
    }
    for (std::size_t k = 0; k < other_columns.size(); ++k) {
        columns.push_back({BatchColumnKind::text, other_columns[k], names.size() + k});
    }
    return columns;
}

namespace {

bool isMissing(const QVariant& key) {
    return key.typeId() == QMetaType::Double ? std::isnan(key.toDouble())
                                             : key.toString().isEmpty();
}

}  // namespace

BatchOrder::BatchOrder(QObject* parent) : QSortFilterProxyModel(parent) {
    by_name_.setNumericMode(true);  // HRG-9 before HRG-10
    setDynamicSortFilter(true);
}

bool BatchOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const QVariant a = left.data(BatchTable::sort_role);
    const QVariant b = right.data(BatchTable::sort_role);
    if (isMissing(a) || isMissing(b)) {
        const bool ascending = sortOrder() == Qt::AscendingOrder;
        return isMissing(a) != isMissing(b) && isMissing(b) == ascending;
    }
    return a.typeId() == QMetaType::Double ? a.toDouble() < b.toDouble()
                                           : by_name_.compare(a.toString(), b.toString()) < 0;
}

namespace {

constexpr int digits_of_numbers = 4;

// Numbers are aligned at the right, below the end of their titles.
int alignmentOf(const BatchColumn& column) {
    const bool numeric =
        column.kind == BatchColumnKind::quantity || column.kind == BatchColumnKind::number;
    return static_cast<int>((numeric ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

}  // namespace

void BatchTable::begin(std::shared_ptr<const MeasurementList> list) {
    beginResetModel();
    list_ = std::move(list);
    columns_ = batchColumns(list_->other_columns);
    if (finished_ > 0) {
        earlier_ = std::move(rows_);
    }
    rows_.clear();
    finished_ = 0;
    failed_ = 0;
    for (const MeasurementSet& set : list_->sets) {
        rows_.emplace_back().fields = batch_row(set);
    }
    endResetModel();
}

void BatchTable::add(const FinishedRow& finished) {
    FinishedRow& row = rows_[finished.set];
    row = finished;
    const auto known = finished.kept ? std::ranges::find(earlier_, row.fields, &FinishedRow::fields)
                                     : earlier_.end();
    if (known != earlier_.end()) {
        row.warnings = known->warnings;
        row.error = known->error;
    }
    ++finished_;
    failed_ += stateOf(row) == State::failed ? 1 : 0;
    const int place = static_cast<int>(finished.set);
    emit dataChanged(index(place, 0), index(place, columnCount() - 1));
}

void BatchTable::setUnits(const DisplayUnits& units) {
    if (units != units_) {
        units_ = units;
        retranslate();
    }
}

void BatchTable::setTheme(const Theme& theme) {
    theme_ = theme;
    retranslate();
}

void BatchTable::retranslate() {
    if (!rows_.empty()) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

bool BatchTable::isEmpty(int column) const {
    const std::size_t at = columns_[static_cast<std::size_t>(column)].field;
    return std::ranges::all_of(rows_, [at](const FinishedRow& row) {
        return at >= row.fields.size() || row.fields[at].empty();
    });
}

int BatchTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int BatchTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

// By its status, which a row that is still to come lacks.
BatchTable::State BatchTable::stateOf(const FinishedRow& row) const {
    const auto state = std::ranges::find(columns_, BatchColumnKind::state, &BatchColumn::kind);
    const QString status = field(row, state->field);
    return status.isEmpty()                ? State::waiting
           : status == QLatin1String("ok") ? State::done
                                           : State::failed;
}

QString BatchTable::field(const FinishedRow& row, std::size_t field) const {
    return field < row.fields.size() ? QString::fromStdString(row.fields[field]) : QString();
}

double BatchTable::number(const FinishedRow& row, std::size_t field) const {
    const auto value =
        field < row.fields.size() ? parse_number(row.fields[field]) : std::optional<double>();
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

// Of a row of an earlier batch there is only the English sentence of its file.
QString BatchTable::reasonText(const FinishedRow& row) const {
    const auto reason = std::ranges::find(columns_, BatchColumnKind::reason, &BatchColumn::kind);
    if (row.error) {
        return errorText(*row.error);
    }
    // Of a set with a serious warning: in the language of the window.
    const std::vector<Finding> findings = findings_of(row.warnings);
    const QString text = field(row, reason->field);
    return text.isEmpty() || findings.empty() ? text : findingText(findings.front());
}

QString BatchTable::cellText(const FinishedRow& row, const BatchColumn& column) const {
    const QString text = field(row, column.field);
    switch (column.kind) {
        case BatchColumnKind::text: return text;
        case BatchColumnKind::reason: return reasonText(row);
        case BatchColumnKind::state:
            return stateOf(row) == State::waiting ? tr("waiting")
                   : stateOf(row) == State::done  ? tr("done")
                                                  : tr("no result");
        case BatchColumnKind::verdict:
            return text == QLatin1String("changed")     ? verdictText(Verdict::changed)
                   : text == QLatin1String("unchanged") ? verdictText(Verdict::unchanged)
                   : text.isEmpty()                     ? QString()
                                                        : verdictText(Verdict::not_comparable);
        case BatchColumnKind::changed: {
            QStringList symbols;
            for (const QString& name : text.split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
                const QString symbol = differenceSymbol(name.toStdString());
                if (!symbols.contains(symbol)) {
                    symbols << symbol;
                }
            }
            return symbols.join(QStringLiteral(", "));
        }
        case BatchColumnKind::model:
            return text == QLatin1String("structured") ? tr("structured")
                   : text.isEmpty()                    ? QString()
                                                       : tr("free");
        case BatchColumnKind::noise:
            return text == QLatin1String("white") ? tr("white")
                   : text.isEmpty()               ? QString()
                                                  : tr("coloured");
        case BatchColumnKind::number: {
            const double value = number(row, column.field);
            return std::isnan(value) ? QString() : shortNumberText(value, digits_of_numbers);
        }
        case BatchColumnKind::quantity: {
            const double factor = factorOf(column, units_);
            const double value = factor * number(row, column.field);
            const double sd = number(row, column.sd_field);
            const double u = number(row, column.u_field);
            return std::isnan(value) ? QString()
                                     : valueText(value, std::abs(factor) * (u >= sd ? u : sd));
        }
    }
    return {};
}

QVariant BatchTable::sortKey(const FinishedRow& row, const BatchColumn& column) const {
    switch (column.kind) {
        case BatchColumnKind::quantity:
        case BatchColumnKind::number: return factorOf(column, units_) * number(row, column.field);
        case BatchColumnKind::state:
            return stateOf(row) == State::failed ? 0.
                   : stateOf(row) == State::done ? 1.
                                                 : std::numeric_limits<double>::quiet_NaN();
        default: return cellText(row, column);
    }
}

// Words say the same as the colours.
QColor BatchTable::color(const FinishedRow& row, const BatchColumn& column) const {
    if (stateOf(row) == State::waiting) {
        return theme_.mutedText;
    }
    if (stateOf(row) == State::failed) {
        return theme_.broken;
    }
    if (column.kind == BatchColumnKind::verdict) {
        const std::string& verdict = row.fields[column.field];
        return verdict == "changed"     ? theme_.broken
               : verdict == "unchanged" ? theme_.kept
                                        : theme_.mutedText;
    }
    return column.kind == BatchColumnKind::changed ? theme_.broken : QColor();
}

QStringList BatchTable::details(int row) const {
    const FinishedRow& of = rows_[static_cast<std::size_t>(row)];
    QStringList lines;
    if (stateOf(of) == State::failed) {
        lines << reasonText(of);
    }
    return lines << findingTexts(findings_of(of.warnings));
}

QVariant BatchTable::data(const QModelIndex& index, int role) const {
    const FinishedRow& row = rows_[static_cast<std::size_t>(index.row())];
    const BatchColumn& column = columns_[static_cast<std::size_t>(index.column())];
    switch (role) {
        case Qt::DisplayRole: return cellText(row, column);
        case sort_role: return sortKey(row, column);
        case Qt::ToolTipRole: {
            const QStringList lines = worstOf(details(index.row()));
            return plainTip(lines.isEmpty() ? cellText(row, column)
                                            : lines.join(QLatin1Char('\n')));
        }
        case Qt::ForegroundRole: {
            const QColor own = color(row, column);
            return own.isValid() ? QVariant(own) : QVariant();
        }
        case Qt::TextAlignmentRole: return alignmentOf(column);
        default: return {};
    }
}

QVariant BatchTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    const BatchColumn& column = columns_[static_cast<std::size_t>(section)];
    switch (role) {
        case Qt::DisplayRole: return titleOf(column, units_);
        case Qt::ToolTipRole: return tipOf(column);
        case Qt::TextAlignmentRole: return alignmentOf(column);
        default: return {};
    }
}

QString BatchTable::tableText(const std::vector<int>& rows, const std::vector<int>& columns) const {
    QStringList lines;
    QStringList head;
    for (const int k : columns) {
        const BatchColumn& column = columns_[static_cast<std::size_t>(k)];
        QString title = titleOf(column, units_);
        head << title.replace(QLatin1Char('\n'), QStringLiteral(", "));
        if (column.kind == BatchColumnKind::quantity) {
            head << tr("sd") << QStringLiteral("u");
        }
    }
    lines << head.join(QLatin1Char('\t'));
    for (const int place : rows) {
        const FinishedRow& row = rows_[static_cast<std::size_t>(place)];
        QStringList cells;
        for (const int k : columns) {
            const BatchColumn& column = columns_[static_cast<std::size_t>(k)];
            const double factor = factorOf(column, units_);
            if (column.kind == BatchColumnKind::quantity) {
                cells << exactText(factor * number(row, column.field))
                      << exactText(std::abs(factor) * number(row, column.sd_field))
                      << exactText(std::abs(factor) * number(row, column.u_field));
            } else if (column.kind == BatchColumnKind::number) {
                cells << exactText(number(row, column.field));
            } else {
                cells << cellText(row, column);
            }
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

}  // namespace vybeg::ui

#include "moc_batch_table.cpp"
