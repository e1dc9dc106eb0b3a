#pragma once

#include <QCollator>
#include <QSortFilterProxyModel>

namespace vybeg::ui {

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

}  // namespace vybeg::ui
