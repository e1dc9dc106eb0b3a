// Included before every file of core/ by the build. Qt's own headers begin with these names, so
// that any Qt include in core/ stops the compiler, whatever directories it searches.
#pragma GCC poison QObject QString QtCore QtGui QtWidgets QCoreApplication QByteArray \
    QT_BEGIN_NAMESPACE
