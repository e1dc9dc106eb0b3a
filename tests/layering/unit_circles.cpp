#include "tests/layering/unit_circles.h"

#include <QMap>
#include <QSet>

#include <algorithm>

namespace vybeg::test {
namespace {

// Tarjan's strongly connected components: one walk in depth; a unit from which no earlier unit of
// the walk is reached closes its component.
class Components {
public:
    explicit Components(const QMap<QString, QSet<QString>>& edges) : edges_(edges) {
        for (auto unit = edges.keyBegin(); unit != edges.keyEnd(); ++unit) {
            if (!number_.contains(*unit)) {
                visit(*unit);
            }
        }
    }

    const QList<QStringList>& found() const { return found_; }

private:
    qsizetype visit(const QString& unit) {
        const qsizetype own = number_.size();
        number_[unit] = own;
        open_ += unit;
        qsizetype earliest = own;
        for (const QString& next : edges_.value(unit)) {
            if (!number_.contains(next)) {
                earliest = std::min(earliest, visit(next));
            } else if (open_.contains(next)) {
                earliest = std::min(earliest, number_[next]);
            }
        }
        if (earliest == own) {
            const qsizetype begin = open_.indexOf(unit);
            found_ += open_.mid(begin);
            open_.resize(begin);
        }
        return earliest;
    }

    const QMap<QString, QSet<QString>>& edges_;
    QMap<QString, qsizetype> number_;  // in the order of the walk
    QStringList open_;
    QList<QStringList> found_;
};

}  // namespace

QStringList unitCircles(const QList<SourceFile>& files) {
    QMap<QString, QSet<QString>> edges;
    for (const SourceFile& file : files) {
        edges[file.unit()];
    }
    for (const SourceFile& file : files) {
        for (const Include& include : file.includes) {
            const QString other = include.header.section('.', 0, -2);
            if (other != file.unit() && edges.contains(other)) {
                edges[file.unit()] += other;
            }
        }
    }
    const Components components(edges);
    QStringList circles;
    for (QStringList units : components.found()) {
        if (units.size() > 1) {
            units.sort();
            circles += units.join(" <-> ");
        }
    }
    circles.sort();
    return circles;
}

}  // namespace vybeg::test
