#include "ui/batch/batch_order.h"

#include "ui/batch/batch_table.h"

#include <cmath>

namespace vybeg::ui {

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

}  // namespace vybeg::ui
