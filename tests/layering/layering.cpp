#include "tests/layering/layering.h"

#include "tests/layering/class_sizes.h"
#include "tests/layering/source_tree.h"
#include "tests/layering/unit_circles.h"

#include <QRegularExpression>
#include <QSet>

namespace vybeg::test {
namespace {

bool isQt(const QString& header) {
    static const QRegularExpression qt(
        "^(Q[A-Za-z0-9]+(/.*)?|q[a-z0-9_]+\\.h|ui_.*\\.h|.*\\.moc|moc_[a-z0-9_]+\\.cpp)$");
    return qt.match(header).hasMatch();
}

bool isOf(const QString& header, const QString& folder) {
    return header.startsWith(folder + '/');
}

bool ofCommandLine(const SourceFile& file) {
    return file.top() == "app" && !file.path.section('/', -1).startsWith("gui");
}

// libhdf5 stays out of the programs: they start without it and read no HDF5 file themselves.
bool mayUseHdf5(const SourceFile& file) {
    return file.folder() == "core/recording/mat_hdf5" || file.folder() == "core/hdf5";
}

// The folders of core/ and of ui/, by their top folder.
using FolderOrder = QMap<QString, QStringList>;

// An include within core/ or within ui/.
QString orderViolation(const SourceFile& file, const QString& header, const FolderOrder& order) {
    const QStringList& folders = order[file.top()];
    const auto other = folders.indexOf(header.section('/', 0, -2));
    return other < 0 || other > folders.indexOf(file.folder())
               ? QString("a later folder of %1/: %2").arg(file.top(), header)
               : QString();
}

QString violation(const SourceFile& file, const Include& include, const FolderOrder& order) {
    const QString top = file.top();
    const QString& header = include.header;
    if (top == "tests") {
        return {};
    }
    if ((top == "core" || ofCommandLine(file)) && isQt(header)) {
        return "Qt: " + header;
    }
    if (header == "hdf5.h" && !mayUseHdf5(file)) {
        return "libhdf5: " + header;
    }
    const bool from_root = isOf(header, "core") || isOf(header, "ui") || isOf(header, "app");
    if (include.quoted && !from_root && !isOf(header, "tests") && !isQt(header)) {
        return "not included from the root: " + header;
    }
    if (isOf(header, "tests") || (top == "core" && (isOf(header, "ui") || isOf(header, "app"))) ||
        (top == "ui" && isOf(header, "app"))) {
        return top + "/ includes " + header;
    }
    if (ofCommandLine(file) && (isOf(header, "ui") || header.startsWith("app/gui"))) {
        return "the command line includes " + header;
    }
    return order.contains(top) && isOf(header, top) ? orderViolation(file, header, order)
                                                    : QString();
}

QStringList ofFile(const SourceFile& file, const FolderOrder& order) {
    QStringList found;
    if (order.contains(file.top()) && !order[file.top()].contains(file.folder())) {
        found += QString("%1:1: its folder is not in %2/CMakeLists.txt").arg(file.path, file.top());
    } else {
        for (const Include& include : file.includes) {
            if (const QString what = violation(file, include, order); !what.isEmpty()) {
                found += QString("%1:%2: %3").arg(file.path).arg(include.line).arg(what);
            }
        }
    }
    if (file.lines.size() > longest_file) {
        found += QString("%1:%2: longer than %3 lines")
                     .arg(file.path)
                     .arg(file.lines.size())
                     .arg(longest_file);
    }
    return found;
}

QStringList ofFolders(const QList<SourceFile>& files) {
    QMap<QString, QSet<QString>> units;
    for (const SourceFile& file : files) {
        units[file.folder()] += file.unit();
    }
    QStringList found;
    for (auto folder = units.cbegin(); folder != units.cend(); ++folder) {
        if (folder->size() > most_units) {
            found += QString("%1: %2 units, more than %3")
                         .arg(folder.key())
                         .arg(folder->size())
                         .arg(most_units);
        }
    }
    return found;
}

QStringList ofClasses(const QList<SourceFile>& files, const ClassCeilings& ceilings) {
    const QMap<QString, int> sizes = classSizes(files);
    QStringList found;
    for (auto size = sizes.cbegin(); size != sizes.cend(); ++size) {
        const int most = ceilings.value(size.key(), largest_class);
        if (*size > most) {
            found += QString("%1 has %2 lines, more than %3").arg(size.key()).arg(*size).arg(most);
        }
    }
    for (auto ceiling = ceilings.cbegin(); ceiling != ceilings.cend(); ++ceiling) {
        if (sizes.value(ceiling.key()) <= largest_class) {
            found += ceiling.key() + " needs no ceiling";
        }
    }
    return found;
}

}  // namespace

QStringList layeringViolations(const QDir& root, const ClassCeilings& ceilings) {
    const FolderOrder order{{"core", foldersInOrder(root, "core")},
                            {"ui", foldersInOrder(root, "ui")}};
    const QList<SourceFile> files = readSources(root);
    QStringList found;
    for (const SourceFile& file : files) {
        found += ofFile(file, order);
    }
    for (const QString& circle : unitCircles(files)) {
        found += "circle of units: " + circle;
    }
    return found + ofFolders(files) + ofClasses(files, ceilings);
}

}  // namespace vybeg::test
