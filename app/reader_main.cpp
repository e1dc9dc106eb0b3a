// vybeg-reader: reads one HDF5, MAT 7.3 or audio file for the program that started it, and may die
// of it (core/recording/variables/library_variables.h). Not meant to be started by hand.
#include "app/reader_service.h"
#include "core/recording/variables/reader_protocol.h"

#include <cstdio>
#include <sys/stat.h>

int main(int argc, char** argv) {
    struct stat file {};
    if (argc != 2 || ::fstat(vybeg::reader_file, &file) != 0) {
        std::fputs("vybeg-reader is started by vybeg and vybeg-cli.\n", stderr);
        return 2;
    }
    return vybeg::serve_file(argv[1]);
}
