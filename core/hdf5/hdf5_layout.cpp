#include "core/hdf5/hdf5_layout.h"

#include "core/recording/mat_hdf5/hdf5_open.h"

#include <cstddef>
#include <cstdlib>

namespace vybeg {
namespace {

// Metadata come in one block before all arrays: those of a track take 8 kB of it.
constexpr hsize_t metadata_block = 1 << 14;
// Links in the root group itself, in the order in which they were made.
constexpr unsigned most_links = 64;

// The memory of a file that libhdf5 believes to be on a disk. When the file is closed the bytes go
// to the layout. Only metadata are ever written to it, so that it stays as small as they are.
struct Image {
    std::size_t size = 0;
    std::string* closed = nullptr;
};

void* image_malloc(std::size_t size, H5FD_file_image_op_t, void* image) {
    static_cast<Image*>(image)->size = size;
    return std::malloc(size);
}

void* image_memcpy(void*, const void*, std::size_t, H5FD_file_image_op_t, void*) {
    return nullptr;  // for files that begin with an image; this one begins empty
}

void* image_realloc(void* bytes, std::size_t size, H5FD_file_image_op_t, void* image) {
    static_cast<Image*>(image)->size = size;
    return std::realloc(bytes, size);
}

herr_t image_free(void* bytes, H5FD_file_image_op_t operation, void* udata) {
    const auto* image = static_cast<Image*>(udata);
    if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE) {
        image->closed->assign(static_cast<const char*>(bytes), image->size);
    }
    std::free(bytes);
    return 0;
}

void* same_image(void* image) {
    return image;
}

herr_t keep_image(void*) {
    return 0;
}

Hdf5Handle make_file(Image& image) {
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS));
    H5FD_file_image_callbacks_t callbacks{image_malloc, image_memcpy, image_realloc, image_free,
                                          same_image,   keep_image,   &image};
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE));
    const bool ready = H5Pset_fapl_core(access.get(), metadata_block, false) >= 0 &&
                       H5Pset_file_image_callbacks(access.get(), &callbacks) >= 0 &&
                       H5Pset_meta_block_size(access.get(), metadata_block) >= 0 &&
                       H5Pset_link_creation_order(
                           creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED) >= 0 &&
                       H5Pset_link_phase_change(creation.get(), most_links, most_links / 2) >= 0;
    return ready ? Hdf5Handle(H5Fcreate("track", H5F_ACC_TRUNC, creation.get(), access.get()))
                 : Hdf5Handle();
}

Hdf5Handle text_type(std::int64_t bytes) {
    Hdf5Handle text(H5Tcopy(H5T_C_S1));
    const bool made = H5Tset_size(text.get(), static_cast<std::size_t>(bytes)) >= 0 &&
                      H5Tset_strpad(text.get(), H5T_STR_NULLPAD) >= 0 &&
                      H5Tset_cset(text.get(), H5T_CSET_UTF8) >= 0;
    return made ? std::move(text) : Hdf5Handle();
}

Hdf5Handle type_of(const Hdf5Array& array) {
    return array.text_bytes == 0 ? Hdf5Handle(H5Tcopy(H5T_IEEE_F64LE))
                                 : text_type(array.text_bytes);
}

// An empty text is none.
bool set_attribute(hid_t object, const char* name, const std::string& text) {
    if (text.empty()) {
        return true;
    }
    const Hdf5Handle type = text_type(static_cast<std::int64_t>(text.size()));
    const Hdf5Handle space(H5Screate(H5S_SCALAR));
    const Hdf5Handle attribute(
        H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
    return attribute && H5Awrite(attribute.get(), type.get(), text.data()) >= 0;
}

// Gives the array its room in the file and writes nothing there.
bool place(hid_t file, const Hdf5Array& array, std::int64_t& at) {
    const auto rows = static_cast<hsize_t>(array.rows);
    const Hdf5Handle space(H5Screate_simple(1, &rows, nullptr));
    const Hdf5Handle type = type_of(array);
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE));
    const bool ready = space && type && H5Pset_layout(creation.get(), H5D_CONTIGUOUS) >= 0 &&
                       H5Pset_alloc_time(creation.get(), H5D_ALLOC_TIME_EARLY) >= 0 &&
                       H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER) >= 0 &&
                       H5Pset_obj_track_times(creation.get(), false) >= 0;
    if (!ready) {
        return false;
    }
    const Hdf5Handle dataset(H5Dcreate2(file, array.name.c_str(), type.get(), space.get(),
                                        H5P_DEFAULT, creation.get(), H5P_DEFAULT));
    const haddr_t offset = dataset ? H5Dget_offset(dataset.get()) : HADDR_UNDEF;
    at = static_cast<std::int64_t>(offset);
    return dataset && (rows == 0 || offset != HADDR_UNDEF) &&
           set_attribute(dataset.get(), "unit", array.unit);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) bool vybeg_hdf5_layout(
    const std::string& program, const std::vector<Hdf5Array>& arrays, Hdf5Layout& layout) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    Image image{0, &layout.bytes};
    Hdf5Handle file = make_file(image);
    if (!file || !set_attribute(file.get(), "program", program)) {
        return false;
    }
    std::int64_t before = 0;
    for (const Hdf5Array& array : arrays) {
        std::int64_t at = 0;
        if (!place(file.get(), array, at)) {
            return false;
        }
        // Written in one pass: each array has to lie after the one before.
        if (array.rows > 0 && at < before) {
            return false;
        }
        before = array.rows > 0 ? at + array.bytes : before;
        layout.places.push_back(at);
    }
    hsize_t size = 0;
    const bool sized = H5Fget_filesize(file.get(), &size) >= 0;
    layout.size = static_cast<std::int64_t>(size);
    file = Hdf5Handle();
    return sized && !layout.bytes.empty();
}

}  // namespace vybeg
