#pragma once

#include "core/batch/batch_request.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QAbstractTableModel>
#include <QCollator>
#include <QSortFilterProxyModel>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vybeg::ui {

// What a column of a batch's table holds, by which its texts, colours and order differ.
enum class BatchColumnKind : std::uint8_t {
    text,
    state,
    reason,
    verdict,
    changed,
    model,
    noise,
    number,
    quantity,  // a parameter with its uncertainty, or its deviation
};

// A column of the window, made of fields of a row of RESULTS.csv.
struct BatchColumn {
    BatchColumnKind kind = BatchColumnKind::text;
    std::string name;  // in RESULTS.csv
    std::size_t field = 0;
    std::size_t sd_field = 0;  // of a quantity
    std::size_t u_field = 0;   // the same
    const char* unit = "";     // of a quantity, as resonator_parameters.h has it
};

// Those of every table, then the list's unknown ones.
std::vector<BatchColumn> batchColumns(const std::vector<std::string>& other_columns);

// Rows of a BatchTable by one of its columns, those that have nothing there last in both
// directions; without a column, as in the list.
class BatchOrder : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit BatchOrder(QObject* parent = nullptr);

protected:
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    QCollator by_name_;
};

// The table of a batch: every set of its list from the beginning, with its result as soon as that
// is there.
class BatchTable : public QAbstractTableModel {
    Q_OBJECT

public:
    // A number (NaN: none) or a text, by which rows are sorted.
    static constexpr int sort_role = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void begin(std::shared_ptr<const MeasurementList> list);
    void add(const FinishedRow& row);
    void setUnits(const DisplayUnits& units);
    void setTheme(const Theme& theme);
    void retranslate();

    const MeasurementList* list() const { return list_.get(); }
    const std::vector<BatchColumn>& columns() const { return columns_; }
    // Rows that are there, and those of them without a result.
    int finished() const { return finished_; }
    int failed() const { return failed_; }
    // Whether no row has anything in this column.
    bool isEmpty(int column) const;
    // All there is to say of a set: the reason, the warnings.
    QStringList details(int row) const;
    bool hasResult(int row) const {
        return stateOf(rows_[static_cast<std::size_t>(row)]) == State::done;
    }
    // Rows in that order with their headers, for a spreadsheet: all digits, a deviation and an
    // uncertainty are columns of their own.
    QString tableText(const std::vector<int>& rows, const std::vector<int>& columns) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    enum class State : std::uint8_t { waiting, done, failed };

    State stateOf(const FinishedRow& row) const;
    double number(const FinishedRow& row, std::size_t field) const;
    QString field(const FinishedRow& row, std::size_t field) const;
    QString reasonText(const FinishedRow& row) const;
    QString cellText(const FinishedRow& row, const BatchColumn& column) const;
    QVariant sortKey(const FinishedRow& row, const BatchColumn& column) const;
    QColor color(const FinishedRow& row, const BatchColumn& column) const;

    std::shared_ptr<const MeasurementList> list_;
    std::vector<BatchColumn> columns_ = batchColumns({});
    std::vector<FinishedRow> rows_;  // those to come with the fields of the list
    // Of the batch before: a row that is taken over has its warnings and its reason as there.
    std::vector<FinishedRow> earlier_;
    int finished_ = 0;
    int failed_ = 0;
    DisplayUnits units_;
    Theme theme_;
};

}  // namespace vybeg::ui
