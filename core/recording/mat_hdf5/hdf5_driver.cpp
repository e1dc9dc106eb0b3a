#include "core/recording/mat_hdf5/hdf5_driver.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace vybeg {
namespace {

// H5FD_t comes first: the library sees no more.
struct LentFile {
    H5FD_t common;
    int descriptor;
    haddr_t end;  // of the addresses in use
    haddr_t size;
};

LentFile* lent(H5FD_t* file) {
    return reinterpret_cast<LentFile*>(file);
}

const LentFile* lent(const H5FD_t* file) {
    return reinterpret_cast<const LentFile*>(file);
}

extern "C" H5FD_t* open_lent(const char*, unsigned flags, hid_t access, haddr_t) {
    const auto* const descriptor = static_cast<const int*>(H5Pget_driver_info(access));
    struct stat status {};
    if (!descriptor || (flags & H5F_ACC_RDWR) != 0 || ::fstat(*descriptor, &status) != 0) {
        return nullptr;
    }
    auto file = std::make_unique<LentFile>();
    file->descriptor = *descriptor;
    file->size = static_cast<haddr_t>(status.st_size);
    return &file.release()->common;
}

extern "C" herr_t close_lent(H5FD_t* file) {
    delete lent(file);
    return 0;
}

// What the driver sec2 has, but for a handle that goes with the file's name.
extern "C" herr_t query_lent(const H5FD_t*, unsigned long* flags) {
    *flags = H5FD_FEAT_ACCUMULATE_METADATA_READ | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

extern "C" haddr_t end_of_addresses(const H5FD_t* file, H5FD_mem_t) {
    return lent(file)->end;
}

extern "C" herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t, haddr_t end) {
    lent(file)->end = end;
    return 0;
}

extern "C" haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) {
    return lent(file)->size;
}

// Zeros after the end of the file, as sec2 reads it.
extern "C" herr_t read_lent(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size,
                            void* out) {
    auto* bytes = static_cast<char*>(out);
    while (size > 0) {
        const ssize_t got = ::pread(lent(file)->descriptor, bytes, size, static_cast<off_t>(at));
        if (got < 0 && errno != EINTR) {
            return -1;
        }
        if (got == 0) {
            std::memset(bytes, 0, size);
            return 0;
        }
        const auto count = static_cast<std::size_t>(std::max<ssize_t>(got, 0));
        bytes += count;
        at += count;
        size -= count;
    }
    return 0;
}

extern "C" herr_t write_nothing(H5FD_t*, H5FD_mem_t, hid_t, haddr_t, std::size_t, const void*) {
    return -1;
}

H5FD_class_t driver_class() {
    H5FD_class_t driver{};
    driver.name = "vybeg";
    driver.maxaddr = (haddr_t{1} << 63) - 1;
    driver.fc_degree = H5F_CLOSE_WEAK;
    driver.fapl_size = sizeof(int);  // copied with the property list
    driver.open = open_lent;
    driver.close = close_lent;
    driver.query = query_lent;
    driver.get_eoa = end_of_addresses;
    driver.set_eoa = set_end_of_addresses;
    driver.get_eof = end_of_file;
    driver.read = read_lent;
    driver.write = write_nothing;
    const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(map), std::end(map), std::begin(driver.fl_map));
    return driver;
}

}  // namespace

bool read_descriptor(hid_t access, int descriptor) {
    static const H5FD_class_t driver = driver_class();
    static const hid_t id = H5FDregister(&driver);
    return id >= 0 && H5Pset_driver(access, id, &descriptor) >= 0;
}

}  // namespace vybeg
