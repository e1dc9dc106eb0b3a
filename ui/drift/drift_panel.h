#pragma once

#include "ui/document/document.h"
#include "ui/panels/file_list.h"

#include <functional>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace vybeg::ui {

class NumberField;

// The whole-angle logs.
class DriftLogs : public FileList {
    Q_OBJECT

public:
    explicit DriftLogs(Document& document, QWidget* parent = nullptr);

    void refresh();

protected:
    void take(const QStringList& files) override;
    void remove(const QStringList& files) override;
    QString hint() const override;

private:
    Document& document_;
};

// Whole-angle logs, how they are read, and the tolerances of their channels. Each change of a
// setting is a step of undo.
class DriftPanel : public QWidget {
    Q_OBJECT

public:
    explicit DriftPanel(Document& document, QWidget* parent = nullptr);

signals:
    void openWanted();

private:
    QLabel* addRow(QFormLayout* form, QWidget* field);
    NumberField* makeNumber(const char* name);
    void edit(const std::function<void(DriftSettings&)>& change);
    void editColumns();
    void showFault(const QString& sentence);
    void refresh();
    void retranslate();

    Document& document_;
    DriftLogs* logs_;
    QPushButton* open_;
    QPushButton* remove_;
    QLabel* columns_label_ = nullptr;
    QLineEdit* columns_;
    QString columns_shown_;
    QLabel* fault_;
    QLabel* angle_unit_label_ = nullptr;
    QComboBox* angle_unit_;
    QLabel* time_unit_label_ = nullptr;
    QComboBox* time_unit_;
    QLabel* rate_label_ = nullptr;
    NumberField* rate_;
    QLabel* kappa_label_ = nullptr;
    NumberField* kappa_;
    QLabel* skew_label_ = nullptr;
    NumberField* skew_;
};

}  // namespace vybeg::ui
