#pragma once

#include "core/residuals/find_residuals.h"
#include "ui/widgets/quantity_table.h"

#include <QCoreApplication>
#include <QString>

#include <vector>

namespace vybeg::ui {

// Texts of the page Residuals in the language of the window.
struct ResidualWords {
    Q_DECLARE_TR_FUNCTIONS(Residuals)
};

// Sentences about the samples of a residual: how many, and which are left out.
QString coverageText(const Residuals& found);

// Rows of numbers with the columns C and D. What white normal noise does not explain, by more than
// four standard deviations, is in the colour `alarm`.
std::vector<QuantityRow> residualRows(const Residuals& found, const QString& unit,
                                      const QColor& alarm);

// E.g. "50.02 Hz: mains, 50 Hz".
QString lineName(const ResidualLine& line);
// Frequency, amplitudes, origin, and what can be done about it.
QString lineSentence(const ResidualLine& line, const Residuals& found, const QString& unit);
// E.g. "2800 … 7800 Hz".
QString bandText(const Band& band);

}  // namespace vybeg::ui
