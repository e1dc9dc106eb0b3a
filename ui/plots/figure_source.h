#pragma once

#include "ui/plots/plot_file.h"

#include <QStringList>

#include <functional>
#include <utility>
#include <vector>

namespace vybeg::ui {

// What a page offers for export: plots, of which some or all make one figure.
struct FigureSource {
    QStringList plots;  // their names; empty: nothing to export
    // The figure of these plots, by their places in `plots`, ascending.
    std::function<Figure(const std::vector<int>&)> figure;
    QString title;     // as proposed
    QString settings;  // of the analyses shown
};

// Those of all at these places.
template <class Value>
std::vector<Value> atPlaces(const std::vector<Value>& all, const std::vector<int>& places) {
    std::vector<Value> some;
    some.reserve(places.size());
    for (const int place : places) {
        some.push_back(all[static_cast<std::size_t>(place)]);
    }
    return some;
}

// Figures with their names, from which some are chosen; one below the other.
FigureSource sourceOf(const std::vector<std::pair<QString, Figure>>& figures, const QString& name,
                      const QString& title);

// Figures one below the other, of the width of the widest.
Figure stacked(const std::vector<Figure>& figures, const QString& name);

}  // namespace vybeg::ui
