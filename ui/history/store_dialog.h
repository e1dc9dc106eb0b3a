#pragma once

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace vybeg::ui {

// Asks under which gyro and date a result goes into the database.
class StoreDialog : public QDialog {
    Q_OBJECT

public:
    // `gyros`: those of the database. The date is ISO 8601 or empty.
    StoreDialog(const QStringList& gyros, const QString& gyro, const QString& date,
                QWidget* parent = nullptr);

signals:
    void chosen(const QString& gyro, const QString& date);

private:
    void refresh();

    QComboBox* gyro_;
    QLineEdit* date_;
    QLabel* fault_;
    QDialogButtonBox* buttons_;
};

}  // namespace vybeg::ui
