#pragma once

#include "core/base/diagnostic.h"

#include <QLabel>

#include <vector>

namespace vybeg::ui {

// Findings, a paragraph each; a link shows those beyond the worst ones. Hidden without any.
class WarningList : public QLabel {
    Q_OBJECT

public:
    explicit WarningList(QWidget* parent);

    void setFindings(std::vector<Finding> findings);
    void refresh();  // in the present language

private:
    std::vector<Finding> findings_;
    bool open_ = false;
};

}  // namespace vybeg::ui
