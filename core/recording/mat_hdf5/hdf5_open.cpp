#include "core/recording/mat_hdf5/hdf5_open.h"

#include "core/recording/bytes/file_bytes.h"
#include "core/recording/variables/reader_protocol.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <sys/stat.h>

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
    const std::span<char> bytes(static_cast<char*>(out), size);
    const std::int64_t got = read_at(lent(file)->descriptor, static_cast<std::int64_t>(at), bytes);
    std::fill(bytes.begin() + std::max<std::int64_t>(got, 0), bytes.end(), '\0');
    return got < 0 ? -1 : 0;
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

// Sets a driver that reads the open file `descriptor`, whatever name H5Fopen() is given: the
// library's own drivers open their file by its name, which vybeg-reader may not do. False where the
// library refuses.
bool read_descriptor(hid_t access, int descriptor) {
    static const H5FD_class_t driver = driver_class();
    static const hid_t id = H5FDregister(&driver);
    return id >= 0 && H5Pset_driver(access, id, &descriptor) >= 0;
}

constexpr std::size_t chunk_cache_bytes = std::size_t{16} << 20;  // a block of C, then of D
constexpr std::size_t chunk_slots = 10007;  // a prime, far more than chunks fit

// The property by which h5clear opens a file that is marked as being written. The mark is in
// the file alone; it is ignored here, and stays.
constexpr const char* pass_over_marks = "clear_status_flags";

// The driver has the file already. Absolute: of another the library asks for the current folder.
constexpr const char* any_name = "/recording";

extern "C" herr_t find_truncation(unsigned, const H5E_error2_t* error, void* found) {
    if (error->min_num == H5E_TRUNCATED) {
        *static_cast<bool*>(found) = true;
    }
    return 0;
}

Hdf5Handle access_to_file(int descriptor) {
    Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_cache(access.get(), 0, chunk_slots, chunk_cache_bytes, 1.0);
    H5Pset_file_locking(access.get(), false, true);  // also where another program writes
    // A part whose check sum is wrong may be in writing; each attempt waits twice as long as the
    // one before, from 1 ns: 1 ms together, where the library's own 100 never end.
    H5Pset_metadata_read_attempts(access.get(), 20);
    return read_descriptor(access.get(), descriptor) ? std::move(access) : Hdf5Handle();
}

// Whether the superblock, of version 3 or later, says that a program writes the file. With a driver
// of its own the library does not look.
bool is_marked_as_written(int descriptor, hid_t file) {
    constexpr std::size_t version_at = 8;
    constexpr std::size_t marks_at = 11;
    hsize_t before = 0;
    const Hdf5Handle creation(H5Fget_create_plist(file));
    std::array<char, 12> head{};
    return creation && H5Pget_userblock(creation.get(), &before) >= 0 &&
           read_at(descriptor, static_cast<std::int64_t>(before), head) == std::ssize(head) &&
           static_cast<unsigned char>(head[version_at]) >= 3 && (head[marks_at] & 1) != 0;
}

}  // namespace

OpenedHdf5 open_hdf5(int descriptor) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    H5PLset_loading_state(0);
    const Hdf5Handle access = access_to_file(descriptor);
    OpenedHdf5 opened;
    if (!access) {
        return opened;
    }
    opened.file = Hdf5Handle(H5Fopen(any_name, H5F_ACC_RDONLY, access.get()));
    if (opened.file && !is_marked_as_written(descriptor, opened.file.get())) {
        return opened;
    }
    if (!opened.file) {
        H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, find_truncation, &opened.truncated);
    }
    opened.not_closed = true;
    Hdf5Handle beside(H5Fopen(any_name, H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get()));
    opened.file = beside ? std::move(beside) : std::move(opened.file);
    if (!opened.file && H5Pexist(access.get(), pass_over_marks) > 0) {
        hbool_t yes = true;
        H5Pset(access.get(), pass_over_marks, &yes);
        opened.file = Hdf5Handle(H5Fopen(any_name, H5F_ACC_RDONLY, access.get()));
    }
    return opened;
}

std::size_t packed_piece_bytes(hid_t dataset) {
    const Hdf5Handle creation(H5Dget_create_plist(dataset));
    const Hdf5Handle type(H5Dget_type(dataset));
    if (!creation || !type || H5Pget_layout(creation.get()) != H5D_CHUNKED ||
        H5Pget_nfilters(creation.get()) <= 0) {
        return 0;
    }
    std::array<hsize_t, H5S_MAX_RANK> sides{};
    const int rank = H5Pget_chunk(creation.get(), static_cast<int>(sides.size()), sides.data());
    std::size_t bytes = H5Tget_size(type.get());
    for (int i = 0; i < rank; ++i) {
        // HDF5 itself has no pieces of 4 GiB and more.
        bytes *= static_cast<std::size_t>(
            std::min<hsize_t>(sides[static_cast<std::size_t>(i)], std::uint32_t{0} - 1));
    }
    return bytes;
}

Hdf5Handle access_to_dataset(std::size_t piece_bytes) {
    Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS));
    H5Pset_chunk_cache(access.get(), chunk_slots, std::max(piece_bytes, chunk_cache_bytes), 1.0);
    return access;
}

MessageArg unsupported_storage(hid_t dataset) {
    const Hdf5Handle creation(H5Dget_create_plist(dataset));
    if (!creation || H5Pget_layout(creation.get()) == H5D_VIRTUAL ||
        H5Pget_external_count(creation.get()) > 0) {
        return Phrase::tr("samples in other files");
    }
    if (const std::size_t bytes = packed_piece_bytes(dataset); bytes > most_packed_bytes) {
        return Phrase::tr("samples packed in pieces of %1 MiB (a limit of this program is %2 MiB)",
                          {count_arg(bytes >> 20), count_arg(most_packed_bytes >> 20)});
    }
    const int filters = H5Pget_nfilters(creation.get());
    for (int i = 0; i < filters; ++i) {
        unsigned flags = 0;
        std::size_t values = 0;
        std::array<char, 64> name{};
        const H5Z_filter_t number =
            H5Pget_filter2(creation.get(), static_cast<unsigned>(i), &flags, &values, nullptr,
                           name.size() - 1, name.data(), nullptr);
        if (number > 0 && H5Zfilter_avail(number) <= 0) {
            return name[0] == '\0'
                       ? Phrase::tr("samples packed by the filter number %1", {count_arg(number)})
                       : Phrase::tr("samples packed by the filter %1, number %2",
                                    {name.data(), count_arg(number)});
        }
    }
    return {};
}

}  // namespace vybeg
